//! A quantity of a body against time, as graphs to choose from.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;
use momentous_quantity::Dimension;
use momentous_quantity::Printed;
use momentous_quantity::Unit;
use momentous_quantity::with_minus_signs;
use momentous_scene::Axis;

use super::curve::Curve;
use super::graph_mistakes;
use super::graph_mistakes::Point;
use super::graph_mistakes::Run;

/// Graphs of a state against time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plotted {
    /// The velocity.
    Velocity,
    /// The momentum.
    Momentum,
    /// The net force.
    Force,
}

/// A quantity of a body against time.
#[derive(Clone, Debug)]
pub struct Graph {
    /// Which one.
    pub plotted: Plotted,
    /// The short name of the body.
    pub body: String,
    /// The axis along which it is counted, where there are several.
    pub along: Option<Axis>,
    /// Which sense is positive, as a sentence.
    pub positive: String,
    /// The stretches of time between its ends.
    pub(crate) stretches: Vec<Stretch>,
    /// Whether nothing acts for a while before what happens, and after it.
    pub(crate) idle: [bool; 2],
}

/// A stage of a graph. The state that changes is the velocity or the momentum; of a force, the momentum that is gained.
#[derive(Clone, Debug)]
pub(crate) struct Stretch {
    pub stage: usize,
    /// The phrase for the stage: `the fall`.
    pub phrase: String,
    /// The state at both ends.
    pub ends: [Expr; 2],
    /// How it changes; none where that takes no time.
    pub course: Option<Course>,
}

/// How a state changes.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    /// The time that runs, where the rate contains it.
    pub clock: Option<Symbol>,
    /// From when to when.
    pub during: [Expr; 2],
    /// How fast.
    pub rate: Expr,
    /// By how much since the start, where the rate is not always the same.
    pub gained: Option<Expr>,
    /// When the rate has a jump or a corner.
    pub breaks: Vec<Expr>,
}

/// The values of quantities in SI units.
pub(crate) type Value<'a> = &'a dyn Fn(Symbol) -> f64;

/// Straight pieces of a curve.
const PIECES: u32 = 48;

/// How long nothing happens before or after what happens, as a share of the time that this takes.
const IDLE: f64 = 0.3;

/// The share of the largest value by which a curve may miss its end, and below which a value is zero.
const NOTHING: f64 = 1e-9;

/// Figures of the values in a reason.
const FIGURES: usize = 3;

impl Plotted {
    /// The quantity in words.
    #[must_use]
    pub fn noun(self) -> &'static str {
        match self {
            Self::Velocity => "the velocity",
            Self::Momentum => "the momentum",
            Self::Force => "the net force",
        }
    }

    /// The letter with which its name begins.
    #[must_use]
    pub fn letter(self) -> &'static str {
        match self {
            Self::Velocity => "v",
            Self::Momentum => "p",
            Self::Force => "F",
        }
    }

    pub(crate) fn dimension(self) -> Dimension {
        match self {
            Self::Velocity => Dimension::VELOCITY,
            Self::Momentum => Dimension::MOMENTUM,
            Self::Force => Dimension::FORCE,
        }
    }
}

impl Graph {
    /// Everything on which it depends.
    pub(crate) fn symbols(&self) -> BTreeSet<Symbol> {
        let courses = || self.stretches.iter().filter_map(|stretch| stretch.course.as_ref());
        let ends = self.stretches.iter().flat_map(|stretch| &stretch.ends);
        let terms =
            ends.chain(courses().flat_map(|course| course.during.iter().chain(&course.breaks).chain([&course.rate])));
        let mut symbols: BTreeSet<Symbol> = terms.flat_map(Expr::symbols).collect();
        for clock in courses().filter_map(|course| course.clock) {
            symbols.remove(&clock);
        }
        symbols
    }

    /// The right graph, then those of the mistakes; none where it does not end where it must.
    pub(crate) fn drawn(&self, value: Value<'_>) -> Vec<(Option<&'static Misconception>, Curve)> {
        let Some(runs) = self.runs(value) else { return Vec::new() };
        graph_mistakes::curves(&runs, self.plotted == Plotted::Force)
    }

    /// When each of its stages begins and ends, by the clock of the graph.
    #[must_use]
    pub fn spans(&self, value: Value<'_>) -> Vec<(usize, [f64; 2])> {
        let mut begin = self.begin(value);
        let mut spans = Vec::new();
        for stretch in &self.stretches {
            let end = begin + stretch.lasts(value);
            spans.push((stretch.stage, [begin, end]));
            begin = end;
        }
        spans
    }

    /// Whether its times are numbers of the problem.
    #[must_use]
    pub fn has_times(&self) -> bool {
        self.idle == [false, false]
    }

    /// When the first stage begins.
    fn begin(&self, value: Value<'_>) -> f64 {
        if self.idle[0] {
            return self.waits(value);
        }
        let first = self.stretches.first().and_then(|stretch| stretch.course.as_ref());
        first.map_or(0.0, |course| course.during[0].evaluate(value))
    }

    /// How long nothing happens at an end.
    fn waits(&self, value: Value<'_>) -> f64 {
        let whole: f64 = self.stretches.iter().map(|stretch| stretch.lasts(value)).sum();
        if whole > 0.0 { IDLE * whole } else { 1.0 }
    }

    /// The state and its rate all the way.
    fn runs(&self, value: Value<'_>) -> Option<Vec<Run>> {
        let mut runs = Vec::new();
        let mut largest: f64 = 0.0;
        let mut missed: f64 = 0.0;
        let (first, last) = (self.stretches.first()?, self.stretches.last()?);
        if self.idle[0] {
            runs.push(Run::idle(0, [0.0, self.begin(value)], first.ends[0].evaluate(value)));
        }
        for (place, ((_, [begin, end]), stretch)) in self.spans(value).into_iter().zip(&self.stretches).enumerate() {
            let ends = stretch.ends.each_ref().map(|end| end.evaluate(value));
            largest = ends.iter().fold(largest, |largest, end| largest.max(end.abs()));
            let Some(course) = &stretch.course else { continue };
            let piece = course.runs(value, place + 1, [begin, end], ends[0]);
            let points = || piece.iter().flat_map(|run| &run.points);
            largest = points().fold(largest, |largest, point| largest.max(point.state.abs()));
            if self.plotted != Plotted::Force {
                missed = missed.max((points().last()?.state - ends[1]).abs());
            }
            runs.extend(piece);
        }
        if self.idle[1] {
            let end = self.spans(value).last()?.1[1];
            let state = last.ends[1].evaluate(value);
            runs.push(Run::idle(self.stretches.len() + 1, [end, end + self.waits(value)], state));
        }
        // As large as the least that a curve shows of a value.
        (missed <= 1e-6 * largest).then_some(runs)
    }

    /// Why the right one is right, as a sentence without a full stop.
    pub(crate) fn because(&self, value: Value<'_>, unit: Option<&Unit>) -> String {
        let values = Values { value, unit, largest: self.largest(value) };
        if self.plotted == Plotted::Force {
            let clauses: Vec<String> = self.stretches.iter().filter_map(|stretch| stretch.force(&values)).collect();
            return format!("the graph shows the sum of all forces at each moment: it is {}", listed(&clauses));
        }
        let is_level =
            self.stretches.iter().all(|stretch| stretch.course.as_ref().is_none_or(|course| course.rate.is_zero()));
        let slope = match self.plotted {
            _ if is_level => "where no net force acts, the graph is level",
            Plotted::Velocity => "the slope of the graph is the net force divided by the mass",
            Plotted::Momentum | Plotted::Force => "the slope of the graph is the net force",
        };
        let from = self.stretches.first().and_then(|stretch| values.said(stretch.ends[0].evaluate(value)));
        let from = from.map_or_else(String::new, |from| format!("from {from} "));
        let clauses: Vec<String> = self.stretches.iter().filter_map(|stretch| stretch.change(&values)).collect();
        format!("{slope}: {from}{} {}", self.plotted.noun(), listed(&clauses))
    }

    fn largest(&self, value: Value<'_>) -> f64 {
        self.drawn(value).first().map_or(0.0, |(_, right)| right.largest())
    }
}

impl Stretch {
    fn lasts(&self, value: Value<'_>) -> f64 {
        let [from, to] =
            self.course.as_ref().map_or([0.0; 2], |course| course.during.each_ref().map(|clock| clock.evaluate(value)));
        to - from
    }

    /// The change of the state, in words.
    fn change(&self, values: &Values<'_>) -> Option<String> {
        let [before, after] = self.ends.each_ref().map(|clock| clock.evaluate(values.value));
        let phrase = &self.phrase;
        let is_same = (after - before).abs() <= NOTHING * values.largest;
        let to = values.said(after).map_or_else(
            || if after < before { "down".to_owned() } else { "up".to_owned() },
            |after| format!("to {after}"),
        );
        match &self.course {
            None if is_same => None,
            None => Some(format!("jumps {to} in {phrase}")),
            Some(course) if course.rate.is_zero() => Some(format!("stays the same in {phrase}")),
            Some(course) if course.gained.is_none() => Some(format!("changes evenly {to} in {phrase}")),
            Some(_) if is_same => Some(format!("changes with the force and comes back to its value in {phrase}")),
            Some(_) => Some(format!("changes {to} in {phrase}, fastest where the force is largest")),
        }
    }

    /// The force, in words.
    fn force(&self, values: &Values<'_>) -> Option<String> {
        let course = self.course.as_ref()?;
        let phrase = &self.phrase;
        let [from, to] = course.during.each_ref().map(|clock| clock.evaluate(values.value));
        let at = |share: f64| values.said(course.rate_at(values.value, from + share * (to - from)));
        let (Some(first), Some(middle), Some(last)) = (at(NOTHING), at(0.5), at(1.0 - NOTHING)) else {
            return Some(format!("as it is told for {phrase}"));
        };
        Some(if course.gained.is_none() {
            format!("{middle} all through {phrase}")
        } else {
            format!("{first} at the start of {phrase}, {middle} half-way through it and {last} at its end")
        })
    }
}

impl Course {
    fn rate_at(&self, value: Value<'_>, time: f64) -> f64 {
        at_time(value, &self.rate, self.clock, time)
    }

    /// The state and its rate from one break to the next, where the state crosses zero as well.
    fn runs(&self, value: Value<'_>, stretch: usize, [begin, end]: [f64; 2], before: f64) -> Vec<Run> {
        let [from, to] = self.during.each_ref().map(|clock| clock.evaluate(value));
        let mut ends: Vec<f64> = self.breaks.iter().map(|at_break| at_break.evaluate(value)).collect();
        ends.retain(|at_break| from < *at_break && *at_break < to);
        ends.push(to);
        ends.sort_by(f64::total_cmp);
        let mut start = from;
        let mut runs = Vec::new();
        for stop in ends {
            let points = (0..=PIECES).map(|piece| {
                let time = start + (stop - start) * f64::from(piece) / f64::from(PIECES);
                // At a jump of the force, what holds on this side of it.
                let inside = time.max(start + NOTHING * (stop - start)).min(stop - NOTHING * (stop - start));
                let rate = self.rate_at(value, inside);
                let gained = self.gained.as_ref().map(|gain| at_time(value, gain, self.clock, inside));
                Point {
                    time: begin + (end - begin) * (time - from) / (to - from),
                    state: before + gained.unwrap_or(rate * (time - from)),
                    rate,
                }
            });
            runs.extend(Run { stretch, points: points.collect() }.at_zeros());
            start = stop;
        }
        runs
    }
}

/// How values are said in a reason.
struct Values<'a> {
    value: Value<'a>,
    /// The unit of the quantity; none where no number of the problem means anything by itself.
    unit: Option<&'a Unit>,
    largest: f64,
}

impl Values<'_> {
    /// A value with its unit, where it has one.
    fn said(&self, value: f64) -> Option<String> {
        let unit = self.unit?;
        let number = if value.abs() <= 10.0 * NOTHING * self.largest {
            "0".to_owned()
        } else {
            with_minus_signs(&Printed::new(value / unit.factor().to_f64(), FIGURES)?.plain())
        };
        Some(format!("{number}\u{a0}{}", unit.unicode()))
    }
}

fn at_time(value: Value<'_>, term: &Expr, clock: Option<Symbol>, time: f64) -> f64 {
    term.evaluate(&|symbol| if Some(symbol) == clock { time } else { value(symbol) })
}

fn listed(clauses: &[String]) -> String {
    match clauses {
        [rest @ .., last] if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        several => several.concat(),
    }
}
