//! Graphs that a solution speaks of besides those of a force against time: a force against the place, with its work as the area, and
//! a velocity against the time or the place.

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_expr::name_math;
use momentous_figure::Drawing;
use momentous_figure::ForcePlot;
use momentous_figure::PlotAxis;
use momentous_figure::Wording;
use momentous_laws::energy;
use momentous_laws::motion;
use momentous_model::Instance;
use momentous_quantity::Dimension;
use momentous_quantity::coherent_unit;
use momentous_scene::Axis;
use momentous_scene::stage::Motion;
use momentous_solve::Statement;

use super::super::reach::laws_used;
use super::quantities::Quantities;
use super::words::sentences;

/// Straight pieces of a curve.
const PIECES: u16 = 72;

/// The plotted quantities, and the meaning of the area beneath the curve.
struct Curve {
    term: Expr,
    variable: Symbol,
    ends: [f64; 2],
    across: (&'static str, Dimension),
    up: (&'static str, Dimension),
    area: Option<Math>,
    /// The caption, as a clause.
    shows: String,
}

/// The works of forces that depend on the place, each as the area under the graph of its force.
pub(super) fn works(quantities: &Quantities<'_>, stage: usize) -> Vec<Drawing> {
    let used = laws_used(quantities.worked).filter(|law| law.stage == Some(stage) && law.law.id == energy::WORK.id);
    let curves = used.filter_map(|law| {
        let integral = law.integral.as_ref()?;
        let ends = [quantities.evaluate(&integral.low)?, quantities.evaluate(&integral.high)?];
        Some(Curve {
            term: integral.integrand.clone(),
            variable: integral.variable,
            ends,
            across: (letter(quantities), Dimension::LENGTH),
            up: ("F", Dimension::FORCE),
            area: defined(quantities, law),
            shows: "the force against the place; the shaded area is its work".to_owned(),
        })
    });
    curves.filter_map(|curve| curve.plot(quantities)).collect()
}

/// The velocity that a scene tells along its only axis, with the displacement as the area where it is found so.
pub(super) fn velocity(quantities: &Quantities<'_>, index: usize, stage: &Motion) -> Option<Drawing> {
    let [axis] = quantities.axes[..] else { return None };
    let term = quantities.term(stage.velocity.as_ref()?.along(axis, 1)?)?;
    let symbols = &quantities.model().symbols;
    let place = symbols.find(axis.letter()).filter(|place| term.contains(*place));
    let (variable, across) = match place {
        Some(place) => (place, (letter(quantities), Dimension::LENGTH)),
        None => (symbols.find("t")?, ("t", Dimension::TIME)),
    };
    let ends = match place {
        Some(_) => [1, 2].map(|side| quantities.named(&format!("r_{}{}", stage.body, index + side))),
        None => {
            let (start, end) = quantities.ends(stage.during.as_ref())?;
            [Some(start), end.or_else(|| quantities.named(&quantities.staged("dt", index)))]
        }
    };
    let [Some(start), Some(end)] = ends else { return None };
    let law = laws_used(quantities.worked)
        .find(|law| law.stage == Some(index) && law.law.id == motion::DISPLACEMENT.id && law.integral.is_some());
    let area = law.filter(|_| place.is_none()).and_then(|law| defined(quantities, law));
    let name = quantities.called(&stage.body);
    let over = if place.is_some() { "place" } else { "time" };
    let under = if area.is_some() { "; the shaded area is the displacement" } else { "" };
    let shows = format!("the velocity of {name} against the {over}{under}");
    let curve = Curve { term, variable, ends: [start, end], across, up: ("v", Dimension::VELOCITY), area, shows };
    curve.plot(quantities)
}

/// The letter of the only axis.
fn letter(quantities: &Quantities<'_>) -> &'static str {
    match quantities.axes[..] {
        [Axis::Y] => "y",
        [Axis::Z] => "z",
        _ => "x",
    }
}

/// The notation of the quantity that a law says is an integral.
fn defined(quantities: &Quantities<'_>, law: &Instance) -> Option<Math> {
    let model = quantities.model();
    let is_own = |tag: usize| model.instances.get(tag).is_some_and(|instance| std::ptr::eq(instance, law));
    model.system.equations.iter().filter(|equation| is_own(equation.tag)).find_map(|equation| {
        match &equation.statement {
            Statement::Equal { left, .. } => Some(quantities.symbolic(left)),
            Statement::FirstInteger { .. } => None,
        }
    })
}

impl Curve {
    fn plot(&self, quantities: &Quantities<'_>) -> Option<Drawing> {
        let [start, end] = self.ends;
        let units =
            [self.across.1, self.up.1].map(|dimension| coherent_unit(dimension, quantities.worked.problem.units()));
        let [across, up] = units.each_ref().map(|unit| unit.factor().to_f64());
        let at = |place: f64| {
            let value = |symbol| if symbol == self.variable { Some(place) } else { quantities.value(symbol) };
            self.term.evaluate(&|symbol| value(symbol).unwrap_or(f64::NAN))
        };
        let places = (0..=PIECES).map(|piece| start + (end - start) * f64::from(piece) / f64::from(PIECES));
        let mut points: Vec<[f64; 2]> = places.map(|place| [place / across, at(place) / up]).collect();
        if points.iter().flatten().any(|value| !value.is_finite()) || end - start == 0.0 {
            return None;
        }
        points.sort_by(|one, other| one[0].total_cmp(&other[0]));
        let axis = |symbol: &str, unit: String| PlotAxis { symbol: name_math(symbol), unit, told: Vec::new() };
        let wording = Wording {
            title: format!("Graph of {} against {}", self.up.0, self.across.0),
            description: sentences([format!("a curve of {} over {}", self.up.0, self.across.0), self.shows.clone()]),
            caption: sentences([self.shows.clone()]),
        };
        let plot = ForcePlot {
            wording,
            time: axis(self.across.0, units[0].unicode()),
            force: axis(self.up.0, units[1].unicode()),
            points,
            area: self.area.clone(),
            marks: Vec::new(),
        };
        Some(plot.drawing())
    }
}
