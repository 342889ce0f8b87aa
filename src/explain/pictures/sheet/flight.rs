//! A body that begins with a free flight, and what the flight leads to.

use std::f64::consts::FRAC_PI_2;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_figure::Depth;
use momentous_figure::Drawing;
use momentous_figure::Launch;
use momentous_figure::Layout;
use momentous_figure::Resisted;
use momentous_figure::Situation;
use momentous_figure::Target;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_scene::Term;
use momentous_scene::stage;
use momentous_scene::stage::Resistance;

use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::quantities::Scope;
use super::super::words::launch_wording;

/// A coordinate this close to another one is the same.
const SAME: f64 = 1e-9;

/// How much a resistance bends a sketched path of which nobody may know more.
const BENT: f64 = 0.8;
/// The least and the most by which a sketch is bent.
const BENT_WITHIN: [f64; 2] = [0.3, 2.5];

/// The start of a flight; none where a sketch of its path has nothing to show, as where nobody knows to where it leads.
pub(in super::super) fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    index: usize,
    flight: &stage::Flight,
) -> Option<Drawing> {
    let mut flying = flight.flying();
    let (Some(body), None) = (flying.next(), flying.next()) else { return None };
    let upright = (compass.angle([0.0, 1.0]) - FRAC_PI_2).abs() < SAME;
    if !upright || quantities.axes != [Axis::X, Axis::Y] {
        return None;
    }
    let slope = quantities.slope(index);
    let compass = &slope.as_ref().map_or_else(|| compass.clone(), |(rise, _)| compass.tilted(*rise));
    let target = match slope {
        Some((rise, label)) => Target::Slope(if compass.place([1.0, 0.0])[0] < 0.0 { -rise } else { rise }, label),
        None => target(quantities, body, index, flight)?,
    };
    let velocity = quantities.velocity(body, index + 1).filter(|velocity| *velocity != [0.0, 0.0]);
    let direction = velocity.map(|velocity| compass.angle(velocity));
    let moving = quantities.body(body, quantities.motion(compass, body, index + 1));
    let resisted = resisted(quantities, compass, index, flight);
    let is_true = resisted.is_some_and(|resisted| resisted.end.is_some());
    let wording = launch_wording(quantities, body, (&moving, index + 1), (&target, is_true));
    let launch = Launch { body: moving, direction, target, resisted };
    Some(Situation { wording, layout: Layout::Launch(launch), axes: compass.marks() }.drawing())
}

/// The resistance, from the derivation in a solution; on a sheet as much as it does in the time in which weight alone would bring
/// the body back.
fn resisted(quantities: &Quantities<'_>, compass: &Compass, index: usize, flight: &stage::Flight) -> Option<Resisted> {
    let (Resistance::Linear(term), Some(body)) = (flight.resistance.as_ref()?, flight.flying().next()) else {
        return None;
    };
    let rate = || Some(quantities.evaluate(&quantities.term(term)?)? / quantities.mass(body, index + 1)?);
    let by_axes = |along: &dyn Fn(&str) -> Option<f64>| Some([along("x")?, along("y")?]);
    let place = |instant: usize| by_axes(&|letter| quantities.named(&format!("r_{body}{instant}.{letter}")));
    let lasts = || quantities.named(&quantities.staged("dt", index));
    if quantities.scope() == Scope::Solved
        && let (Some(rate), Some(time)) = (rate(), lasts())
        && let (Some(start), Some(end)) = (place(index + 1), place(index + 2))
    {
        let end = Some(compass.place([end[0] - start[0], end[1] - start[1]]));
        return Some(Resisted { fading: rate * time, end });
    }
    let back = || Some(2.0 * quantities.velocity(body, index + 1)?[1].abs() / quantities.named("g")?);
    let fading = rate().zip(back()).map_or(BENT, |(rate, back)| (rate * back).clamp(BENT_WITHIN[0], BENT_WITHIN[1]));
    Some(Resisted { fading, end: None })
}

fn target(quantities: &Quantities<'_>, body: &str, index: usize, flight: &stage::Flight) -> Option<Target> {
    let (until, start) = (flight.until.as_ref()?, format!("r_{body}{}", index + 1));
    if until.0.trim() == "top" {
        return Some(Target::Top);
    }
    if let Some(way) = way(quantities, [body, &start], until, Axis::Y) {
        return depth(quantities, &way).map(Target::Ground);
    }
    let way = way(quantities, [body, &start], until, Axis::X)?;
    let strikes =
        matches!(quantities.scene().stages.get(index + 1), Some(Stage::Impact(impact)) if impact.against.is_some());
    let distance = quantities.evaluate(&way).map(|_| quantities.unsigned(&way));
    let falls = |stage: &Stage| {
        let Stage::Flight(flight) = stage else { return None };
        self::way(quantities, [body, &start], flight.until.as_ref()?, Axis::Y)
    };
    let ground = quantities.scene().stages.iter().find_map(falls);
    strikes.then(|| Target::Wall(distance, ground.and_then(|way| depth(quantities, &way))))
}

/// The way along an axis from the `start` of a body to where a flight ends that ends at a place on it.
fn way(quantities: &Quantities<'_>, [body, start]: [&str; 2], until: &Term, axis: Axis) -> Option<Expr> {
    let (left, right) = until.0.split_once('=')?;
    let letter = axis.letter();
    let is_own = left.trim() == letter || left.trim() == format!("{letter}_{body}");
    let start = quantities.model().symbol_of(&format!("{start}.{letter}")).filter(|_| is_own)?;
    let end = quantities.term(&Term(right.trim().to_owned()))?;
    let zero = |term: &Expr| quantities.evaluate(term).is_some_and(|value| value.abs() < SAME);
    let start = Some(Expr::from(start)).filter(|start| !zero(start));
    let end = if zero(&end) { Expr::zero() } else { end };
    Some(start.map_or_else(|| end.clone(), |start| (end.clone() - start).simplify()))
}

/// The depth of the ground, by the way to it; none where it lies above the start.
fn depth(quantities: &Quantities<'_>, way: &Expr) -> Option<Depth> {
    match quantities.evaluate(way) {
        None => Some(Depth::Below(None)),
        Some(way) if way.abs() < SAME => Some(Depth::Nothing),
        Some(value) => (value < 0.0).then(|| Depth::Below(Some(height(quantities, way)))),
    }
}

fn height(quantities: &Quantities<'_>, way: &Expr) -> Math {
    quantities.symbolic(&(-way.clone()).simplify())
}
