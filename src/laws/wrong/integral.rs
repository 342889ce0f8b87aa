//! Mistakes about what adds up over time: one value for all of it, a part of the area under a graph.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::rewrite::one;

/// One value of a changing force.
pub const VALUE_TIMES_TIME: Misconception = Misconception {
    id: "value-times-time",
    does: "multiplies one value of what changes with time by the whole time",
    ask: "Does it have this value all the time? What does the graph against time look like?",
    hint: "The integral is the area under the curve: a rectangle only if the curve is level.",
};
/// The mean of first and last.
pub const ENDS_AVERAGED: Misconception = Misconception {
    id: "ends-averaged",
    does: "takes the mean of the first and the last value as the average over time",
    ask: "Is the graph against time a straight line?",
    hint: "The mean of the two end values is the average over time only for a straight line.",
};
/// The mean of zero and the peak.
pub const HALF_PEAK: Misconception = Misconception {
    id: "half-of-the-peak",
    does: "takes half of the peak as the average force",
    ask: "Which shape does the graph of the force have? Is it a triangle that begins and ends at zero?",
    hint: "Half of the peak is the average over time only if the graph is a triangle on the time axis.",
};
/// A part of the area under a graph.
pub const PART: Misconception = Misconception {
    id: "part-of-the-area",
    does: "counts only a part of the area under the graph of the force",
    ask: "From which moment to which does the force act? Which parts of the area under its graph have you counted?",
    hint: "Divide the area into pieces from the first moment to the last, and add all of them.",
};

/// A value of what changes, times the whole time: that at the end, at the start, half-way, and where its pieces meet.
pub(super) fn value_times_time(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let [low, high] = graph.ends;
    let times = [high.clone(), low.clone(), graph.middle()].into_iter().chain(graph.corners());
    // Nobody takes a force for zero all the time.
    let values = times.map(|time| graph.at(&time).simplify()).filter(|value| !value.is_zero());
    values.map(|value| Wrong::from((law.left(), value * graph.duration()))).collect()
}

/// The mean of the values at both ends, times the time.
pub(super) fn ends_averaged(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let [low, high] = graph.ends;
    let mean = (Expr::ratio(1, 2) * (graph.at(low) + graph.at(high))).simplify();
    if mean.is_zero() {
        return Vec::new();
    }
    one((law.left(), mean * graph.duration()))
}

/// Half of a value where pieces meet, times the time; of a force that rises and falls in one piece, half of that half-way.
pub(super) fn half_peak(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let mut tops = graph.corners();
    if tops.is_empty() && graph.ends.iter().all(|end| graph.at(end).simplify().is_zero()) {
        tops.push(graph.middle());
    }
    let half = |time: &Expr| Expr::product([Expr::ratio(1, 2), graph.at(time), graph.duration()]);
    tops.iter().map(|time| Wrong::from((law.left(), half(time)))).collect()
}

/// Half of the area, as up to the middle of a graph that rises and falls alike; of a graph in pieces, each piece alone, as if its ends
/// were joined by a line.
pub(super) fn part_of_the_area(law: &Taught<'_>) -> Vec<Wrong> {
    let Some(graph) = Graph::of(law) else { return Vec::new() };
    let corners = graph.corners();
    if corners.is_empty() {
        return one((law.left(), Expr::ratio(1, 2) * law.right()));
    }
    let [low, high] = graph.ends;
    let ends: Vec<Expr> = std::iter::once(low.clone()).chain(corners).chain([high.clone()]).collect();
    let area = |from: &Expr, to: &Expr| {
        let mean = Expr::ratio(1, 2) * (graph.at(from) + graph.at(to));
        mean.simplify() * (to.clone() - from.clone())
    };
    let pieces = ends.windows(2).filter_map(|piece| match piece {
        [from, to] => Some(area(from, to)),
        _ => None,
    });
    pieces.map(|piece| Wrong::from((law.left(), piece))).collect()
}

/// What changes, against time or position.
struct Graph<'a> {
    value: &'a Expr,
    variable: Symbol,
    ends: [&'a Expr; 2],
}

impl<'a> Graph<'a> {
    fn of(law: &Taught<'a>) -> Option<Self> {
        law.integral.map(|(value, variable, ends)| Self { value, variable, ends })
    }

    fn at(&self, time: &Expr) -> Expr {
        self.value.substitute(&|symbol| (symbol == self.variable).then(|| time.clone()))
    }

    fn duration(&self) -> Expr {
        let [low, high] = self.ends;
        high.clone() - low.clone()
    }

    fn middle(&self) -> Expr {
        let [low, high] = self.ends;
        Expr::ratio(1, 2) * (low.clone() + high.clone())
    }

    /// The places at which one piece ends and another begins.
    fn corners(&self) -> Vec<Expr> {
        fn collect(term: &Expr, found: &mut Vec<Expr>) {
            if let Expr::Piecewise(own) = term {
                found.extend(own.pieces.iter().filter_map(|(until, _)| until.clone()));
            }
            term.children().for_each(|part| collect(part, found));
        }
        let mut found = Vec::new();
        collect(self.value, &mut found);
        found.retain(|time| !self.ends.contains(&time));
        found
    }
}

/// What grows by a given rate counts with its value at the end: `F_0 T + k T^2` for `F_0 T + k T^2/2`.
pub(super) fn growth_not_halved(law: &Taught<'_>) -> Vec<Wrong> {
    fn at_the_end(law: &Taught<'_>, term: &Expr) -> Expr {
        let rates = [Dimension::new(1, 1, -3), Dimension::new(1, 1, -4), Dimension::new(1, 2, -3)];
        match term {
            Expr::Product(parts) if rates.iter().any(|rate| parts.iter().any(|factor| is_of(law, factor, *rate))) => {
                Expr::product(parts.iter().filter(|part| !is_share(part)).cloned())
            }
            other => other.map_children(|part| at_the_end(law, part)),
        }
    }
    law.both(|side| at_the_end(law, side))
}

/// Whether a factor is a quantity of that dimension by itself.
fn is_of(law: &Taught<'_>, factor: &Expr, dimension: Dimension) -> bool {
    matches!(factor, Expr::Symbol(symbol) if law.is(*symbol, dimension))
}

/// Whether a factor is a number between zero and one: that of an integral.
fn is_share(factor: &Expr) -> bool {
    matches!(factor, Expr::Number(number) if (Rational::ZERO..Rational::ONE).contains(number))
}
