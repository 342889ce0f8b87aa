//! An arm about a fixed point with the particles on it, seen along its axis; and the balance of their moments of momentum.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use momentous_expr::Math;

use super::angular_diagram::{AngularImpulse, headings, turn_panel};
use super::body::{Attach, Body};
use super::input::Wording;
use super::panels::{Row, assemble};
use super::place::{Anchor, Canvas};
use super::scale::Scale;
use super::situation::{Moment, MovingBody, Scales, draw_centre, draw_vector};
use super::{Drawing, Point, Role, Shape};

const LONGEST_ARROW: f64 = 40.0;
/// The longest arm where the shortest has room at its true length, and where it has not.
const LONGEST_ARM: f64 = 74.0;
const FARTHEST_ARM: f64 = 120.0;
/// The length at which the shortest arm is drawn between the centre and the body.
const SHORTEST_LINE: f64 = 12.0;
/// Clear space about the outermost arc.
const ARC_ROOM: f64 = 7.0;
/// From the arm to a body beside it.
const BESIDE: f64 = 3.0;
/// The distance that an arm goes on beyond what strikes it.
const OVERHANG: f64 = 26.0;
/// Angles closer than this, in radians, are one direction.
const SAME_ANGLE: f64 = 1e-9;
/// The arcs of turns and moments, from the inside to the outside, and how far they turn.
const ARC_RADIUS: f64 = 15.0;
const ARC_STEP: f64 = 8.0;
const ARC_TURN: f64 = 1.1 * PI;

/// An arm with particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// The name of the fixed point.
    pub centre: Math,
    /// The particles.
    pub particles: Vec<OnArm>,
    /// The radius of a disc that carries the particles, in the unit of their distances.
    pub disc: Option<f64>,
    /// The moments on the arm, and its turns, drawn as arcs about the centre.
    pub turns: Vec<(Moment, Role)>,
}

/// A particle on an arm, or beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct OnArm {
    /// The particle with its vectors.
    pub body: MovingBody,
    /// Its distance from the centre, in any one unit, and what is written there.
    pub distance: f64,
    /// The label of that distance.
    pub label: Option<Math>,
    /// Its direction as seen from the centre, in radians.
    pub angle: f64,
    /// 0 on the arm; 1 or -1 where it touches the arm from the counter-clockwise or the clockwise side.
    pub beside: f64,
}

impl OnArm {
    /// Whether it lies on the arm itself, where that points in this direction.
    fn is_on_arm_at(&self, angle: f64) -> bool {
        self.beside == 0.0 && (self.angle - angle).abs() < SAME_ANGLE
    }
}

/// Before, the angular impulse, after.
#[derive(Clone, Debug, PartialEq)]
pub struct ArmDiagram {
    /// Title, description, caption.
    pub wording: Wording,
    /// The arm before, with the momenta of its particles.
    pub before: Arm,
    /// The angular impulse about the centre.
    pub impulse: AngularImpulse,
    /// The arm after.
    pub after: Arm,
}

impl ArmDiagram {
    /// The diagram: one scale for all distances, another for all momenta.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let both = [&self.before, &self.after];
        let scales = Arm::scales(&both);
        let panel = |arm: &Arm| {
            let mut canvas = Canvas::default();
            arm.draw_with(&mut canvas, &scales);
            canvas.settled()
        };
        let row = Row {
            panels: vec![
                panel(&self.before),
                turn_panel(&self.before.centre, &self.impulse, Role::Impulse),
                panel(&self.after),
            ],
        };
        self.wording.drawing(assemble(&headings(), vec![row], &[]))
    }
}

impl Arm {
    /// On a problem sheet.
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        self.draw_with(canvas, &Self::scales(&[self]));
    }

    fn scales(arms: &[&Self]) -> (Scale, Scales) {
        let all = || arms.iter().flat_map(|arm| &arm.particles);
        // An arm that reaches to both sides is as wide as both.
        let spans = arms.iter().flat_map(|arm| {
            let ends = || arm.particles.iter().map(|particle| Point::polar(particle.distance.abs(), particle.angle));
            ends().flat_map(move |one| ends().chain([Point::ORIGIN]).map(move |other| one - other))
        });
        let spans: Vec<Point> = spans.filter(|span| span.x.is_finite() && span.y.is_finite()).collect();
        // What is nearer than something else has to be seen to be so.
        let usual = Scale::fitting(spans.iter().copied(), LONGEST_ARM);
        let is_crowded = |arm: &&Self| arm.particles.iter().any(|particle| arm.is_drawn_farther(particle, usual));
        let differ = all().any(|nearer| all().any(|other| nearer.distance.abs() < other.distance.abs()));
        let longest = if differ && arms.iter().any(is_crowded) { FARTHEST_ARM } else { LONGEST_ARM };
        (Scale::fitting(spans, longest), Scales::of(all().map(|particle| &particle.body), LONGEST_ARROW))
    }

    fn draw_with(&self, canvas: &mut Canvas, (distances, scales): &(Scale, Scales)) {
        let placed: Vec<(Point, Body)> =
            self.particles.iter().map(|particle| self.place(particle, *distances)).collect();
        for (particle, (foot, body)) in self.particles.iter().zip(&placed) {
            body.draw(canvas);
            let unit = Point::polar(1.0, particle.angle);
            if particle.beside == 0.0 {
                canvas.line([Point::ORIGIN, *foot - unit * body.reach(-unit)], Role::Length, false);
                continue;
            }
            // The arm goes on beyond what it carries in that direction.
            let carried = self.particles.iter().zip(&placed).filter(|(other, _)| other.is_on_arm_at(particle.angle));
            let from = carried.map(|(_, (at, body))| at.length() + body.reach(unit)).fold(0.0, f64::max);
            // An arm that carries nothing there ends beyond what strikes it.
            let end = if from > 0.0 || self.disc.is_some() { *foot } else { *foot + unit * OVERHANG };
            if foot.length() > from {
                canvas.line([unit * from, end], Role::Length, false);
            }
        }
        self.draw_disc(canvas, &placed, *distances);
        let away = self.particles.first().map_or(0.0, |particle| particle.angle + FRAC_PI_2 / 2.0);
        // Where there is no arm, its name stands where the arcs are open.
        let clear_of = if self.particles.is_empty() { away + PI } else { away };
        draw_centre(canvas, Point::ORIGIN, &self.centre, clear_of);
        for (number, (turn, role)) in (0_u8..).zip(&self.turns) {
            let sweep = ARC_TURN.copysign(turn.value);
            let radius = ARC_RADIUS + ARC_STEP * f64::from(number);
            let from = away + PI - sweep / 2.0;
            let (centre, role) = (Point::ORIGIN, *role);
            canvas.draw(Shape::Arc { centre, radius, from, to: from + sweep, arrow: true, role });
        }
        // What lies beside the arm has the label of its distance on its own side; both come before those of the vectors, which
        // find a place elsewhere.
        let (beside, on_arm): (Vec<_>, Vec<_>) =
            self.particles.iter().zip(&placed).partition(|(particle, _)| particle.beside != 0.0);
        for (particle, (foot, _)) in beside.into_iter().chain(on_arm) {
            let Some(label) = &particle.label else { continue };
            let side = particle.angle + FRAC_PI_2.copysign(particle.beside);
            let anchor = if particle.beside == 0.0 {
                Anchor::Along { from: Point::ORIGIN, to: *foot }
            } else {
                Anchor::Around { at: *foot * 0.5, radius: 0.0, prefer: side }
            };
            canvas.label(label, Role::Length, anchor);
        }
        for (particle, (foot, body)) in self.particles.iter().zip(&placed) {
            let mut body = body.clone();
            let normal = Point::polar(1.0, particle.angle + FRAC_PI_2);
            // What comes to the arm is drawn on its way there; what is carried is drawn away from what touches it.
            let blocked =
                if particle.beside == 0.0 { -self.touching((particle, *foot), &placed) } else { particle.beside };
            for moving in &particle.body.vectors {
                let arrives = scales.arrow(moving).is_some_and(|arrow| arrow.dot(normal) * blocked < 0.0);
                let attach = if arrives { Attach::Arriving } else { Attach::Leaving };
                draw_vector(canvas, &mut body, moving, scales, attach);
            }
        }
        for (number, (turn, role)) in (0_u8..).zip(&self.turns) {
            let radius = ARC_RADIUS + ARC_STEP * f64::from(number);
            canvas.label(&turn.label, *role, Anchor::Around { at: Point::ORIGIN, radius, prefer: away + PI });
        }
    }

    /// The rim of the disc, with gaps where particles lie on it.
    fn draw_disc(&self, canvas: &mut Canvas, placed: &[(Point, Body)], distances: Scale) {
        let Some(radius) = self.disc.filter(|radius| radius.is_finite()) else { return };
        let far = placed.iter().map(|(foot, _)| foot.length()).fold(self.clear(), f64::max);
        // Alone, it has no scale.
        let tip = distances.arrow(Point::new(radius, 0.0)).filter(|_| !placed.is_empty());
        let radius = tip.map_or(0.0, |tip| tip.x).max(far);
        let on_rim = placed.iter().filter_map(|(foot, body)| {
            let half = body.reach(Point::polar(1.0, foot.turned().angle()));
            ((foot.length() - radius).abs() < half).then(|| (foot.angle().rem_euclid(TAU), half / radius))
        });
        let mut gaps: Vec<(f64, f64)> = on_rim.collect();
        gaps.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        let (centre, role, arrow) = (Point::ORIGIN, Role::Surface, false);
        let Some((first, last)) = gaps.first().copied().zip(gaps.last().copied()) else {
            return canvas.draw(Shape::Circle { centre, radius, role });
        };
        let ends = gaps.windows(2).filter_map(|pair| if let [one, other] = pair { Some((*one, *other)) } else { None });
        for ((from, behind), (to, before)) in ends.chain([(last, (first.0 + TAU, first.1))]) {
            canvas.draw(Shape::Arc { centre, radius, from: from + behind, to: to - before, arrow, role });
        }
    }

    /// On which side something touches the arm at a particle that it carries there; 0 where nothing does.
    fn touching(&self, (particle, at): (&OnArm, Point), placed: &[(Point, Body)]) -> f64 {
        let right = Point::new(1.0, 0.0);
        let strikes = |(other, (foot, body)): &(&OnArm, &(Point, Body))| {
            let room = particle.body.outline().reach(right) + body.reach(right);
            other.beside != 0.0 && (other.angle - particle.angle).abs() < SAME_ANGLE && (*foot - at).length() < room
        };
        self.particles.iter().zip(placed).find(strikes).map_or(0.0, |(other, _)| other.beside)
    }

    /// How near to the centre something may be drawn.
    fn clear(&self) -> f64 {
        let arcs = f64::from(u8::try_from(self.turns.len()).unwrap_or(u8::MAX));
        if arcs > 0.0 { ARC_RADIUS + ARC_STEP * (arcs - 1.0) + ARC_ROOM } else { SHORTEST_LINE }
    }

    /// Whether a particle is drawn farther out than its distance says.
    fn is_drawn_farther(&self, particle: &OnArm, distances: Scale) -> bool {
        let unit = Point::polar(1.0, if particle.angle.is_finite() { particle.angle } else { 0.0 });
        drawn(particle, distances) < particle.body.outline().reach(unit) + self.clear()
    }

    /// The place of a particle on the arm, and its outline there.
    fn place(&self, particle: &OnArm, distances: Scale) -> (Point, Body) {
        let (body, angle) = (particle.body.outline(), if particle.angle.is_finite() { particle.angle } else { 0.0 });
        let unit = Point::polar(1.0, angle);
        let reach = body.reach(unit);
        let foot = unit * drawn(particle, distances).max(reach + self.clear());
        if particle.beside == 0.0 {
            return (foot, body.moved(foot));
        }
        // What touches the arm where it carries something touches that.
        let near = self.particles.iter().filter(|other| other.is_on_arm_at(particle.angle));
        let carried = near.map(|other| (drawn(other, distances), other.body.outline().reach(unit)));
        let blocked = carried.filter(|(at, other)| (at - drawn(particle, distances)).abs() < other + reach);
        let height = reach + BESIDE + blocked.map(|(_, other)| other).fold(0.0, f64::max);
        let at = foot + unit.turned() * (height * particle.beside.signum());
        (foot, body.moved(at))
    }
}

/// The length of the arm of a particle to scale.
fn drawn(particle: &OnArm, distances: Scale) -> f64 {
    distances.arrow(Point::new(particle.distance.abs(), 0.0)).map_or(0.0, |arrow| arrow.x)
}
