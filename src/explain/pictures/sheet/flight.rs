//! A body that begins with a free flight, and what the flight leads to.

use std::f64::consts::FRAC_PI_2;

use crate::expr::Expr;
use crate::expr::Math;
use crate::figure::Depth;
use crate::figure::Drawing;
use crate::figure::Launch;
use crate::figure::Layout;
use crate::figure::Situation;
use crate::figure::Target;
use crate::scene::Axis;
use crate::scene::Stage;
use crate::scene::Term;
use crate::scene::stage;

use super::super::compass::Compass;
use super::super::quantities::Quantities;
use super::super::words::launch_wording;

/// A coordinate this close to another one is the same.
const SAME: f64 = 1e-9;

/// The start of the first flight; none where a sketch of its path has nothing to show, as where nobody knows to where it leads.
pub(in super::super) fn drawing(
    quantities: &Quantities<'_>,
    compass: &Compass,
    flight: &stage::Flight,
) -> Option<Drawing> {
    let mut flying = flight.flying();
    let (Some(body), None) = (flying.next(), flying.next()) else { return None };
    let upright = (compass.angle([0.0, 1.0]) - FRAC_PI_2).abs() < SAME;
    if !upright || quantities.axes != [Axis::X, Axis::Y] {
        return None;
    }
    let slope = quantities.slope(0);
    let compass = &slope.as_ref().map_or_else(|| compass.clone(), |(rise, _)| compass.tilted(*rise));
    let target = match slope {
        Some((rise, label)) => Target::Slope(if compass.place([1.0, 0.0])[0] < 0.0 { -rise } else { rise }, label),
        None => target(quantities, body, flight)?,
    };
    let velocity = quantities.velocity(body, 1).filter(|velocity| *velocity != [0.0, 0.0]);
    let direction = velocity.map(|velocity| compass.angle(velocity));
    let moving = quantities.body(body, quantities.motion(compass, body, 1));
    let wording = launch_wording(quantities, body, &moving, &target);
    let launch = Launch { body: moving, direction, target };
    Some(Situation { wording, layout: Layout::Launch(launch), axes: compass.marks() }.drawing())
}

fn target(quantities: &Quantities<'_>, body: &str, flight: &stage::Flight) -> Option<Target> {
    let until = flight.until.as_ref()?;
    if until.0.trim() == "top" {
        return Some(Target::Top);
    }
    if let Some(way) = way(quantities, body, until, Axis::Y) {
        return depth(quantities, &way).map(Target::Ground);
    }
    let way = way(quantities, body, until, Axis::X)?;
    let strikes = matches!(quantities.scene().stages.get(1), Some(Stage::Impact(impact)) if impact.against.is_some());
    let distance = quantities.evaluate(&way).map(|_| quantities.unsigned(&way));
    let falls = |stage: &Stage| {
        let Stage::Flight(own) = stage else { return None };
        self::way(quantities, body, own.until.as_ref()?, Axis::Y)
    };
    let ground = quantities.scene().stages.iter().find_map(falls);
    strikes.then(|| Target::Wall(distance, ground.and_then(|way| depth(quantities, &way))))
}

/// The way along an axis from the start of a body to where a flight ends that ends at a place on it.
fn way(quantities: &Quantities<'_>, body: &str, until: &Term, axis: Axis) -> Option<Expr> {
    let (left, right) = until.0.split_once('=')?;
    let letter = axis.letter();
    let is_own = left.trim() == letter || left.trim() == format!("{letter}_{body}");
    let start = quantities.model().symbol_of(&format!("r_{body}1.{letter}")).filter(|_| is_own)?;
    let end = quantities.term(&Term(right.trim().to_owned()))?;
    let zero = |term: &Expr| quantities.evaluate(term).is_some_and(|value| value.abs() < SAME);
    let start = Some(Expr::from(start)).filter(|start| !zero(start));
    let end = if zero(&end) { Expr::zero() } else { end };
    Some(start.map_or_else(|| end.clone(), |start| (end.clone() - start).simplify()))
}

/// Where the ground is, by the way to it; none where it lies above the start.
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
