//! Particles with their centre of mass G and their velocities.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use momentous_expr::Math;

use super::extent::Extent;
use super::input::{AxisMark, LabelledVector, Wording};
use super::panels::draw_axes;
use super::place::{Anchor, Canvas};
use super::scale::Scale;
use super::situation::draw_centre;
use super::{Drawing, Point, Role, Shape};

/// The room in which the particles' places are spread out.
const ROOM: Point = Point::new(210.0, 130.0);
const LONGEST: f64 = 52.0;
/// The longest arrow where particles are close together.
const SHORTEST_LONGEST: f64 = 24.0;
const PARTICLE: f64 = 5.5;
const MARK: f64 = 4.5;
/// Particles that would be drawn nearer to each other than this and by so much smaller with the origin are drawn without it.
const NEAREST: f64 = 36.0;
const SMALLER: f64 = 0.7;
/// The sentence about an origin that is not drawn.
const FAR_ORIGIN: &str = "The origin of the axes lies outside the figure.";
/// How far from the velocity a force is drawn that points the same way.
const BESIDE: f64 = 5.0;

/// Input of a figure of a centre of mass.
#[derive(Clone, Debug, PartialEq)]
pub struct MassCentre {
    /// Title, description, caption.
    pub wording: Wording,
    /// The particles.
    pub particles: Vec<PlacedParticle>,
    /// The centre of mass, where it is to be shown: its name, place and velocity.
    pub centre: Option<PlacedParticle>,
    /// The kind of the arrows.
    pub arrows: Travel,
    /// The name of the point from which the places are told, where it is to be shown.
    pub origin: Option<Math>,
    /// The axes to name.
    pub axes: Vec<AxisMark>,
}

/// The kinds of the arrows of particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Travel {
    /// Velocities, to a scale of their own.
    Velocity,
    /// Displacements, to the scale of the places.
    Displacement,
}

/// A particle, or a centre of mass, at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedParticle {
    /// Its name.
    pub name: Math,
    /// Its place, in any one unit for the whole figure.
    pub position: [f64; 2],
    /// Its velocity or displacement, where that is to be shown.
    pub velocity: Option<LabelledVector>,
    /// The forces on it that are to be shown.
    pub forces: Vec<LabelledVector>,
}

impl PlacedParticle {
    fn place(&self) -> Point {
        let [x, y] = self.position;
        if x.is_finite() && y.is_finite() { Point::new(x, y) } else { Point::ORIGIN }
    }

    fn vector(&self) -> Option<Point> {
        self.velocity.as_ref()?.vector()
    }
}

impl MassCentre {
    /// The figure: places to scale, velocities to another scale.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let all = || self.particles.iter().chain(&self.centre);
        let ends = || {
            let moved = all().filter_map(|particle| Some(particle.place() + particle.vector()?));
            moved.filter(|_| self.arrows == Travel::Displacement)
        };
        let spread = Extent::around(all().map(PlacedParticle::place).chain(ends()));
        let factor_alone = enlargement(spread);
        let with_origin = spread.joined(Extent::default());
        let least = nearest(&self.particles);
        let is_far = least * enlargement(with_origin) < NEAREST.min(SMALLER * least * factor_alone);
        let has_origin = self.origin.is_some() && !is_far;
        let (spread, factor) =
            if has_origin { (with_origin, enlargement(with_origin)) } else { (spread, factor_alone) };
        let placed = |particle: &PlacedParticle| (particle.place() - spread.low) * factor;
        let longest = match self.arrows {
            Travel::Velocity => longest_arrow(&all().map(placed).collect::<Vec<_>>()),
            Travel::Displacement => {
                all().filter_map(PlacedParticle::vector).map(Point::length).fold(0.0, f64::max) * factor
            }
        };
        let role = match self.arrows {
            Travel::Velocity => Role::Velocity,
            Travel::Displacement => Role::Length,
        };
        let vectors = all().filter_map(PlacedParticle::vector);
        let scale = match self.arrows {
            Travel::Velocity => Scale::sketching(vectors, longest),
            Travel::Displacement => Scale::fitting(vectors, longest),
        };
        let forces = Scale::sketching(
            all().flat_map(|placed_particle| &placed_particle.forces).filter_map(LabelledVector::vector),
            longest,
        );
        let mut canvas = Canvas::default();
        if let Some(origin) = &self.origin {
            let at = (Point::ORIGIN - spread.low) * factor;
            if !has_origin {
                canvas.tell(FAR_ORIGIN);
            } else if all().all(|particle| (placed(particle) - at).length() > PARTICLE) {
                draw_centre(&mut canvas, at, origin, FRAC_PI_4);
            }
        }
        if self.arrows == Travel::Displacement {
            canvas.tell_scale(scale);
        }
        if let Some(centre) = &self.centre {
            draw_mark(&mut canvas, placed(centre));
        }
        for particle in &self.particles {
            draw_forces(&mut canvas, particle, placed(particle), forces);
            draw_particle(&mut canvas, particle, placed(particle), (scale, role));
        }
        if let Some(centre) = &self.centre {
            draw_arrow(&mut canvas, centre, placed(centre), MARK, (scale, role));
        }
        let mut canvas = canvas.settled();
        draw_axes(&mut canvas, &self.axes);
        self.wording.drawing(canvas)
    }
}

fn draw_particle(canvas: &mut Canvas, particle: &PlacedParticle, at: Point, arrow: (Scale, Role)) {
    canvas.draw(Shape::Circle { centre: at, radius: PARTICLE, role: Role::Body });
    draw_arrow(canvas, particle, at, PARTICLE, arrow);
}

/// The forces, beside the velocity where it points the same way.
fn draw_forces(canvas: &mut Canvas, particle: &PlacedParticle, at: Point, scale: Scale) {
    for force in &particle.forces {
        let Some(arrow) = force.vector().and_then(|vector| scale.arrow(vector)) else { continue };
        let ahead = arrow * (1.0 / arrow.length());
        let side = Point::new(-ahead.y, ahead.x);
        let along = |velocity: Point| velocity.dot(side).abs() < 0.2 * velocity.dot(ahead);
        let aside = if particle.vector().is_some_and(along) { side * BESIDE } else { Point::ORIGIN };
        let from = at + aside + ahead * PARTICLE;
        let to = from + arrow;
        canvas.arrow(from, to, Role::Force);
        canvas.label(&force.label, Role::Force, Anchor::Along { from, to });
    }
}

/// A small circle with a cross.
fn draw_mark(canvas: &mut Canvas, at: Point) {
    canvas.draw(Shape::Circle { centre: at, radius: MARK, role: Role::Axis });
    for arm in [Point::new(MARK, 0.0), Point::new(0.0, MARK)] {
        canvas.line([at - arm, at + arm], Role::Axis, false);
    }
}

/// The arrow from the rim of the mark, if it moves, and the name on the other side.
fn draw_arrow(canvas: &mut Canvas, particle: &PlacedParticle, at: Point, radius: f64, (scale, role): (Scale, Role)) {
    let arrow = particle.vector().and_then(|vector| scale.arrow(vector));
    if let (Some(arrow), Some(velocity)) = (arrow, &particle.velocity) {
        let from = at + arrow * (radius / arrow.length());
        let to = if role == Role::Length { at + arrow } else { from + arrow };
        canvas.arrow(from, to, role);
        canvas.label(&velocity.label, role, Anchor::Along { from, to });
    }
    let away = arrow.map_or(FRAC_PI_2, |arrow| (-arrow).angle());
    canvas.label(&particle.name, Role::Body, Anchor::Around { at, radius, prefer: away });
    if let (None, Some(velocity), Some(_)) = (arrow, &particle.velocity, particle.vector()) {
        let note = velocity.equals(Math::Number("0".to_owned()));
        canvas.label(&note, role, Anchor::Around { at, radius, prefer: 0.0 });
    }
}

/// How large the places are drawn that lie within this box.
fn enlargement(spread: Extent) -> f64 {
    let part = |room: f64, size: f64| if size > 0.0 { room / size } else { f64::INFINITY };
    let factor = part(ROOM.x, spread.size().x).min(part(ROOM.y, spread.size().y));
    if factor.is_finite() { factor } else { 1.0 }
}

/// The least distance between two particles.
fn nearest(particles: &[PlacedParticle]) -> f64 {
    let places: Vec<Point> = particles.iter().map(PlacedParticle::place).collect();
    least_distance(&places)
}

fn least_distance(places: &[Point]) -> f64 {
    let pairs = places
        .iter()
        .enumerate()
        .flat_map(|(index, one)| places.iter().take(index).map(move |other| (*one - *other).length()));
    pairs.fold(f64::INFINITY, f64::min)
}

/// An arrow length that keeps arrows from reaching the neighbours.
fn longest_arrow(places: &[Point]) -> f64 {
    (0.8 * least_distance(places) - 2.0 * PARTICLE).clamp(SHORTEST_LONGEST, LONGEST)
}
