//! The graph by which a sheet tells a force: the coordinates of its points stand at the axes.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::ForcePlot;
use momentous_figure::PlotAxis;
use momentous_figure::Wording;
use momentous_model::ActingForce;
use momentous_model::PrintedGraph;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;
use momentous_quantity::coherent_unit;

use super::plot;
use super::quantities::Quantities;
use super::quantities::Scope;
use super::words::sentences;

/// The force of a stage that changes with time: its graph that the sheet prints, or one with round numbers.
pub(super) fn force_plot(quantities: &Quantities<'_>, stage: usize) -> Option<Drawing> {
    let Some(graph) = quantities.model().graph.as_ref().filter(|graph| graph.stage == stage) else {
        return plot::force_plot(quantities, stage);
    };
    let force = plot::pulls(quantities, stage).find(|force| force.called == graph.called)?;
    drawing(quantities, force, graph)
}

/// The graph; in a solution up to the end of the stage, with its area.
fn drawing(quantities: &Quantities<'_>, force: &ActingForce, graph: &PrintedGraph) -> Option<Drawing> {
    let unit = |side: usize| {
        let mut symbols = graph.points.iter().flat_map(|point| point[side].symbols());
        symbols.find_map(|symbol| quantities.unit_told(symbol))
    };
    let dimensions = [Dimension::TIME, Dimension::FORCE];
    let units = [0, 1]
        .map(|side| unit(side).unwrap_or_else(|| coherent_unit(dimensions[side], quantities.worked.problem.units())));
    let quantities = &sketched(quantities, graph);
    let value = |side: usize, expr: &Expr| in_unit(quantities.evaluate(expr)?, &units[side]);
    let mut corners: Vec<([f64; 2], [Math; 2])> = Vec::new();
    for [time, strength] in &graph.points {
        let at = [value(0, time)?, value(1, strength)?];
        corners.push((at, [written(quantities, time, at[0]), written(quantities, strength, at[1])]));
    }
    let solved = quantities.scope() == Scope::Solved;
    let end = value(0, &force.during[1]).filter(|_| solved).unwrap_or(f64::INFINITY);
    corners.retain(|([time, _], _)| *time <= end);
    let mut points: Vec<[f64; 2]> = corners.iter().map(|(at, _)| *at).collect();
    let clock = quantities.model().symbols.find("t")?;
    let last =
        |symbol: Symbol| if symbol == clock { quantities.evaluate(&force.during[1]) } else { quantities.value(symbol) };
    let at_end = force.strength.evaluate(&|symbol| last(symbol).unwrap_or(f64::NAN));
    if points.last().is_some_and(|[time, _]| *time < end) && at_end.is_finite() {
        points.push([end, in_unit(at_end, &units[1])?]);
    }
    let marks = plot::marks(quantities, force).into_iter();
    let is_new = |mark: &plot::Mark| {
        let time = in_unit(mark.time, &units[0]);
        solved && corners.iter().all(|([at, _], _)| Some(*at) != time)
    };
    let marks: Vec<plot::Mark> = marks.filter(is_new).collect();
    let shaded = solved && force.during[0].is_zero();
    let axis = |side: usize, symbol: &str| PlotAxis {
        symbol: name_math(symbol),
        unit: units[side].unicode(),
        told: corners.iter().map(|(at, text)| (at[side], text[side].clone())).collect(),
    };
    let words = |(_, [time, force]): &([f64; 2], [Math; 2])| {
        let [second, newton] = [&units[0], &units[1]].map(Unit::unicode);
        format!("({} {second}, {} {newton})", time.plain(), force.plain())
    };
    let wording = plot::wording(force, &marks, shaded);
    let through =
        format!("straight lines through the points {}", corners.iter().map(words).collect::<Vec<_>>().join(", "));
    let plot = ForcePlot {
        wording: Wording { description: format!("{} {}", wording.description, sentences([through])), ..wording },
        time: axis(0, "t"),
        force: axis(1, "F"),
        points,
        area: shaded.then(|| quantities.impulse_of_force(force).label),
        marks: marks.into_iter().filter_map(|mark| Some((in_unit(mark.time, &units[0])?, mark.label))).collect(),
    };
    Some(plot.drawing())
}

/// With a force that is asked for as large as the largest that is told: its height on the sheet says nothing.
fn sketched<'a>(quantities: &Quantities<'a>, graph: &PrintedGraph) -> Quantities<'a> {
    let forces = || graph.points.iter().map(|[_, force]| force);
    let told = forces().filter_map(|force| quantities.evaluate(force)).map(f64::abs).fold(0.0, f64::max);
    let height = if told > 0.0 { told } else { 1.0 };
    let asked = forces().flat_map(Expr::symbols).filter(|symbol| quantities.value(*symbol).is_none());
    asked.fold(quantities.clone(), |assumed, symbol| assumed.assuming(symbol, height))
}

/// A coordinate in digits where the sheet tells its value, else in letters.
fn written(quantities: &Quantities<'_>, coordinate: &Expr, value: f64) -> Math {
    let is_told = |symbol: &Symbol| {
        quantities.is_literal(*symbol)
            || !quantities.is_any(*symbol) && quantities.worked.variant.given(*symbol).is_some()
    };
    if coordinate.symbols().iter().all(is_told) {
        Math::Number(value.to_string())
    } else {
        quantities.symbolic(coordinate)
    }
}

/// A value in a unit, without the digits that only come of computing in binary.
fn in_unit(value: f64, unit: &Unit) -> Option<f64> {
    format!("{:.9e}", value / unit.factor().to_f64()).parse().ok()
}

impl Quantities<'_> {
    /// The unit in which a sheet tells a quantity.
    fn unit_told(&self, symbol: Symbol) -> Option<Unit> {
        let given = self.worked.variant.given(symbol).map(|(_, unit)| unit);
        given.or_else(|| self.worked.problem.unit_given(symbol))
    }
}
