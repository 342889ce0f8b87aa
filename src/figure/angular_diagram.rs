//! A particle about a fixed point O: moment of momentum before + angular impulse = moment of momentum after.

use std::f64::consts::PI;

use momentous_expr::Math;
use momentous_expr::Operator;

use super::body::{Attach, Body};
use super::drawing::unknown;
use super::input::{AxisMark, Form, LabelledVector, Wording};
use super::panels::{Row, assemble};
use super::place::{Anchor, Canvas};
use super::scale::Scale;
use super::situation::draw_centre;
use super::{Drawing, Point, Role, Shape};

const LONGEST_MOMENTUM: f64 = 54.0;
const LONGEST_RADIUS: f64 = 72.0;
/// The length at which the shortest radius is drawn between the centre and the body.
const SHORTEST_LINE: f64 = 10.0;
/// An arrow whose direction lies this near (cosine) to that of the centre points towards it.
const INWARDS: f64 = 0.9;
/// An arrow whose direction lies this far (cosine) from that of the centre points across the radius.
const ACROSS: f64 = 0.1;
/// How far a label stands from the line that it is beside.
const BESIDE: f64 = 3.0;
/// The arc that stands for an angular impulse, and how far it turns.
const ARC_RADIUS: f64 = 20.0;
const ARC_FROM: f64 = -PI / 3.0;
const ARC_TURN: f64 = 1.4 * PI;

/// Input of an angular impulse-momentum diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct AngularDiagram {
    /// Title, description, caption.
    pub wording: Wording,
    /// The name of the fixed point.
    pub centre: Math,
    /// One row of panels each.
    pub particles: Vec<AngularMomentum>,
    /// The axes to name.
    pub axes: Vec<AxisMark>,
}

/// The row of one particle.
#[derive(Clone, Debug, PartialEq)]
pub struct AngularMomentum {
    /// The particle's name.
    pub name: Math,
    /// Before.
    pub before: AngularState,
    /// The angular impulse about the fixed point.
    pub impulse: AngularImpulse,
    /// After.
    pub after: AngularState,
}

/// A particle at a place, with its momentum.
#[derive(Clone, Debug, PartialEq)]
pub struct AngularState {
    /// The vector from the fixed point to the particle, and the label of its length.
    pub radius: LabelledVector,
    /// Its momentum, or its components one by one.
    pub momenta: Vec<LabelledVector>,
}

/// An angular impulse, positive counter-clockwise.
#[derive(Clone, Debug, PartialEq)]
pub struct AngularImpulse {
    /// The label at its arc.
    pub label: Math,
    /// Its value; only the sign is drawn. `None` where it is not known.
    pub value: Option<f64>,
}

/// Moments of momentum of all bodies together, which need no places: arcs about the fixed point.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnDiagram {
    /// Title, description, caption.
    pub wording: Wording,
    /// The name of the fixed point.
    pub centre: Math,
    /// Before, what changes it, after.
    pub terms: [AngularImpulse; 3],
}

impl TurnDiagram {
    /// The diagram; of each term only the sense is drawn.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let roles = [Role::Momentum, Role::Impulse, Role::Momentum];
        let panels = self.terms.iter().zip(roles).map(|(term, role)| turn_panel(&self.centre, term, role)).collect();
        let row = Row { panels };
        self.wording.drawing(assemble(&headings(), vec![row], &[]))
    }
}

/// The headings over the three panels.
pub(super) fn headings() -> [Math; 3] {
    ["before", "angular impulse", "after"].map(|words| Math::Text(words.to_owned()))
}

impl AngularDiagram {
    /// The diagram: one scale for all radii, another for all momenta.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let states = || self.particles.iter().flat_map(|particle| [&particle.before, &particle.after]);
        let radii = Scale::fitting(states().filter_map(|state| state.radius.vector()), LONGEST_RADIUS);
        let momenta = states().flat_map(|state| &state.momenta).filter_map(LabelledVector::vector);
        let momenta = Scale::fitting(momenta, LONGEST_MOMENTUM);
        let rows = self.particles.iter().map(|particle| Row {
            panels: vec![
                self.state_panel(&particle.name, &particle.before, radii, momenta),
                turn_panel(&self.centre, &particle.impulse, Role::Impulse),
                self.state_panel(&particle.name, &particle.after, radii, momenta),
            ],
        });
        let mut canvas = assemble(&headings(), rows.collect(), &self.axes);
        canvas.tell_scale(momenta);
        self.wording.drawing(canvas)
    }

    fn state_panel(&self, name: &Math, state: &AngularState, radii: Scale, momenta: Scale) -> Canvas {
        let mut canvas = Canvas::default();
        let radius = state.radius.vector().and_then(|vector| radii.arrow(vector)).unwrap_or_default();
        let mut body = Body::new(name, Form::Disc, radius);
        // A radius shorter than the body would hide the centre under it; a body on the centre is drawn to its right.
        let outward = if radius == Point::ORIGIN { 0.0 } else { radius.angle() };
        let reach = body.reach(Point::polar(1.0, outward));
        let distance = radius.length().max(reach + SHORTEST_LINE);
        body = body.moved(Point::polar(distance, outward));
        body.draw(&mut canvas);
        draw_centre(&mut canvas, Point::ORIGIN, &self.centre, outward);
        let end = Point::polar(distance - reach, outward);
        canvas.line([Point::ORIGIN, end], Role::Length, false);
        let mut beside = Anchor::Along { from: Point::ORIGIN, to: end };
        for momentum in &state.momenta {
            match momentum.vector().map(|vector| momenta.arrow(vector)) {
                Some(Some(arrow)) => {
                    let along = arrow.dot(Point::polar(1.0, outward)) / arrow.length();
                    // Towards the centre, the radius is in the way.
                    let attach = if along < -INWARDS { Attach::Arriving } else { Attach::Leaving };
                    if along.abs() > ACROSS || state.momenta.len() == 1 {
                        body.draw_arrow(&mut canvas, arrow, attach, &momentum.label, Role::Momentum);
                        continue;
                    }
                    // The label of the part across the radius has the near side for itself, and that of the radius its other side.
                    let (from, to) = body.attach(arrow, attach);
                    canvas.arrow(from, to, Role::Momentum);
                    let at = |at: Point, prefer: f64| Anchor::Around { at, radius: BESIDE, prefer };
                    canvas.label(&momentum.label, Role::Momentum, at(from.towards(to, 0.5), outward + PI));
                    beside = at(Point::ORIGIN.towards(end, 0.5), (-arrow).angle());
                }
                Some(None) => body.draw_note(&mut canvas, &momentum.equals(number("0")), Role::Momentum),
                None => body.draw_note(&mut canvas, &momentum.equals(unknown()), Role::Momentum),
            }
        }
        canvas.label(&state.radius.label, Role::Length, beside);
        canvas.settled()
    }
}

/// The arc that stands for an angular impulse about a fixed point, or for an angular momentum.
pub(super) fn turn_panel(name: &Math, impulse: &AngularImpulse, role: Role) -> Canvas {
    let mut canvas = Canvas::default();
    draw_centre(&mut canvas, Point::ORIGIN, name, 0.0);
    let (text, direction) = match impulse.value {
        Some(value) if value > 0.0 => (impulse.label.clone(), Some(ARC_TURN)),
        Some(value) if value < 0.0 => (impulse.label.clone(), Some(-ARC_TURN)),
        Some(_) => (Math::relation(impulse.label.clone(), Operator::Equals, number("0")), None),
        None => (Math::relation(impulse.label.clone(), Operator::Equals, unknown()), None),
    };
    if let Some(turn) = direction {
        // Clockwise is the mirror image: the arc ends where the other one starts.
        let from = if turn > 0.0 { ARC_FROM } else { PI - ARC_FROM };
        let (centre, radius) = (Point::ORIGIN, ARC_RADIUS);
        canvas.draw(Shape::Arc { centre, radius, from, to: from + turn, arrow: true, role });
    }
    let radius = if direction.is_some() { ARC_RADIUS } else { 6.0 };
    canvas.label(&text, role, Anchor::Around { at: Point::ORIGIN, radius, prefer: PI / 2.0 });
    canvas.settled()
}

fn number(digits: &str) -> Math {
    Math::Number(digits.to_owned())
}
