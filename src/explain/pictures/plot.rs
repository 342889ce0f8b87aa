//! Force against time, for a push whose force changes.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::ForcePlot;
use momentous_figure::PlotAxis;
use momentous_figure::Wording;
use momentous_model::ActingForce;
use momentous_model::ForceKind;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;
use momentous_quantity::coherent_unit;
use momentous_scene::Stage;
use momentous_scene::stage::During;
use momentous_scene::stage::Push;

use super::quantities::Quantities;
use super::quantities::Scope;
use super::words::sentences;

/// Straight pieces of a curve.
const PIECES: u32 = 72;

/// The force of a stage that changes with time, where there is one and its values may be shown.
pub(super) fn force_plot(quantities: &Quantities<'_>, stage: usize) -> Option<Drawing> {
    let clock = quantities.model().symbols.find("t")?;
    let force = pulls(quantities, stage).find(|force| force.strength.contains(clock))?;
    plot(quantities, force, clock)
}

/// The pushes and pulls of a stage.
pub(super) fn pulls<'a>(quantities: &Quantities<'a>, stage: usize) -> impl Iterator<Item = &'a ActingForce> {
    let forces = quantities.model().forces.iter();
    forces.filter(move |force| force.stage == stage && force.kind == ForceKind::Pull)
}

fn plot(quantities: &Quantities<'_>, force: &ActingForce, clock: Symbol) -> Option<Drawing> {
    let end = quantities.evaluate(&force.during[1])?;
    // The graph of a force starts with its stage, even where the body starts to move later.
    let begin = quantities.start_of(force.stage);
    let start = quantities.evaluate(&begin)?;
    let marks = marks(quantities, force);
    let strength_at = |time: f64| {
        let value = |symbol| if symbol == clock { Some(time) } else { quantities.value(symbol) };
        force.strength.evaluate(&|symbol| value(symbol).unwrap_or(f64::NAN))
    };
    let mut times: Vec<f64> =
        (0..=PIECES).map(|piece| start + (end - start) * f64::from(piece) / f64::from(PIECES)).collect();
    times.extend(marks.iter().map(|mark| mark.time).filter(|time| (start..=end).contains(time)));
    times.sort_by(f64::total_cmp);
    let [time, strength] = [Dimension::TIME, Dimension::FORCE].map(|dimension| quantities.unit_like(dimension, force));
    let [second, newton] = [&time, &strength].map(|unit| unit.factor().to_f64());
    let points: Vec<[f64; 2]> = times.iter().map(|time| [time / second, strength_at(*time) / newton]).collect();
    if points.iter().any(|[_, force]| !force.is_finite()) {
        return None;
    }
    // What acts before the body moves is no part of the impulse that moves it.
    let shaded = quantities.scope() == Scope::Solved && begin == force.during[0];
    let plot = ForcePlot {
        wording: wording(force, &marks, shaded),
        time: PlotAxis { symbol: name_math("t"), unit: time.unicode(), told: Vec::new() },
        force: PlotAxis { symbol: name_math("F"), unit: strength.unicode(), told: Vec::new() },
        points,
        area: shaded.then(|| quantities.impulse_of_force(force).label),
        marks: marks.into_iter().map(|mark| (mark.time / second, mark.label)).collect(),
    };
    Some(plot.drawing())
}

/// A time with a name.
pub(super) struct Mark {
    pub time: f64,
    pub label: Math,
    /// The name in a figure's description.
    words: String,
}

/// Times with names: the ends of the force's pieces, when the body starts to move, the end.
pub(super) fn marks(quantities: &Quantities<'_>, force: &ActingForce) -> Vec<Mark> {
    let pieces = match &force.strength {
        Expr::Piecewise(piecewise) => piecewise.pieces.iter().filter_map(|(until, _)| until.clone()).collect(),
        _ => Vec::new(),
    };
    let mut marks: Vec<Mark> = Vec::new();
    for time in pieces.into_iter().chain(force.during.clone()) {
        let Expr::Symbol(symbol) = time else { continue };
        if quantities.is_literal(symbol) {
            continue;
        }
        let label = quantities.symbolic(&time);
        if let Some(value) = quantities.value(symbol)
            && !marks.iter().any(|mark| mark.label == label)
        {
            marks.push(Mark { time: value, label, words: quantities.time_in_words(&time) });
        }
    }
    marks
}

pub(super) fn wording(force: &ActingForce, marks: &[Mark], shaded: bool) -> Wording {
    let name = force.in_words();
    let area = if shaded { ", whose impulse is the shaded area" } else { "" };
    let times: Vec<&str> = marks.iter().map(|mark| mark.words.as_str()).collect();
    let marked = if times.is_empty() { String::new() } else { format!("marked times: {}", times.join(", ")) };
    Wording {
        title: format!("Graph of {name} against time"),
        description: sentences([format!("a curve of {name} F over the time t{area}"), marked]),
        caption: sentences([format!("{name} against time{area}")]),
    }
}

impl Quantities<'_> {
    /// Words for a time, for a text without mathematics.
    pub(super) fn what_time(&self, time: &Expr) -> String {
        match time {
            Expr::Symbol(symbol) if !self.is_literal(*symbol) => self.model().symbols.entry(*symbol).meaning.clone(),
            other => self.symbolic(other).plain(),
        }
    }

    /// A time that is marked, in such a text: what it is, where its name has a whole word as `t_start` has.
    pub(super) fn time_in_words(&self, time: &Expr) -> String {
        let plain = || self.symbolic(time).plain();
        let Expr::Symbol(symbol) = time else { return plain() };
        let entry = self.model().symbols.entry(*symbol);
        let is_word = entry.name.rsplit('_').next().is_some_and(|index| index.len() > 2);
        if is_word && !entry.meaning.is_empty() { entry.meaning.clone() } else { plain() }
    }

    /// The time at which a push starts.
    pub(super) fn start_of(&self, stage: usize) -> Expr {
        let Some(Stage::Push(Push { during: Some(During::Between([start, _])), .. })) = self.scene().stages.get(stage)
        else {
            return Expr::zero();
        };
        self.term(start).filter(|start| self.evaluate(start) != Some(0.0)).unwrap_or_else(Expr::zero)
    }

    /// The unit in which the problem gives the quantities of that dimension in a force and its times; else the system's own.
    fn unit_like(&self, dimension: Dimension, force: &ActingForce) -> Unit {
        let mut symbols = force.strength.symbols();
        symbols.extend(force.during.iter().flat_map(Expr::symbols));
        let alike = symbols.into_iter().filter(|symbol| self.model().symbols.entry(*symbol).dimension == dimension);
        let given =
            alike.filter(|symbol| !self.is_literal(*symbol)).find_map(|symbol| self.worked.problem.unit_given(symbol));
        given.unwrap_or_else(|| coherent_unit(dimension, self.worked.problem.units()))
    }
}
