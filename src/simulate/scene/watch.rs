//! A scene in which nothing happens: its bodies are watched for a while in free motion.

use momentous_scene::Scene;

use super::measure::{Asked, along, centre, energy, mean, of_centre, place, sum, turning, velocity};
use super::stage_run::kinetic;
use super::values::Values;
use super::vector::{Vector, ZERO, add, cross, less, part, size, times};

/// The time for which they are watched, in s.
const WATCHED: f64 = 1.0;

/// The share of a distance that counts as what a velocity is a difference of: places are rounded so much finer than velocities may be off.
const ROUNDED: f64 = 1e-5;

/// Strips of the area that a radius sweeps meanwhile.
const STRIPS: u32 = 64;

/// Measures what is asked by where the bodies are at one time and at another. The second number is the size of what it is a
/// difference of.
#[must_use]
pub fn watch(
    scene: &Scene,
    alive: &[&str],
    asked: Asked<'_>,
    value: &dyn Fn(&str) -> Option<f64>,
) -> Option<(f64, f64)> {
    let values = Values { scene, value, index: asked.instant.checked_sub(1)? };
    let watched = Watched { values: &values, bodies: alive };
    let one = |vector: Vector| along(&values, asked).map(|axis| part(vector, axis));
    match (asked.base, asked.subject) {
        ("r" | "v", "G") => of_centre(&values, alive, asked, &|body| watched.gone(body, None)),
        ("v_rel", body) => {
            let far = ROUNDED * size(watched.at(body, 2.0 * WATCHED, Some("G"))?) / WATCHED;
            Some((one(watched.gone(body, Some("G"))?)?, size(watched.gone(body, None)?).max(far)))
        }
        ("T", "G") => {
            let whole: f64 = alive.iter().map(|body| values.mass(body).ok()).sum::<Option<f64>>()?;
            let (mean, scale) = mean(&values, alive, &|body| watched.gone(body, None))?;
            Some((kinetic(whole, mean), whole * scale * size(mean)))
        }
        ("T_rel", "") => {
            let (all, _) = energy(&values, alive, &|body| watched.gone(body, Some("G")))?;
            let (whole, _) = energy(&values, alive, &|body| watched.gone(body, None))?;
            Some((all, whole))
        }
        // Twice the mass for each area that the radius sweeps in a unit of time.
        ("H", point) => {
            let (all, scale) = sum(&values, alive, &|body| watched.swept(body, point))?;
            Some((turning(&values, asked, times(2.0 / WATCHED, all))?, 2.0 * scale / WATCHED))
        }
        _ => None,
    }
}

/// Bodies of which it is known how they move.
struct Watched<'a> {
    values: &'a Values<'a>,
    bodies: &'a [&'a str],
}

impl Watched<'_> {
    /// The place of a body when it has gone on for a time, seen from a point. Where only velocities are used, all may start at
    /// the same place.
    fn at(&self, body: &str, time: f64, from: Option<&str>) -> Option<Vector> {
        let velocity_of = |body: &str| {
            let start = place(self.values, body).unwrap_or(ZERO);
            Some(add(start, times(time, velocity(self.values, body).ok()?)))
        };
        let point_of_view = match from {
            Some(point) => centre(self.values, self.bodies, point, &velocity_of)?,
            None => ZERO,
        };
        Some(less(velocity_of(body)?, point_of_view))
    }

    /// The distance that it goes in a unit of time.
    fn gone(&self, body: &str, from: Option<&str>) -> Option<Vector> {
        Some(times(1.0 / WATCHED, less(self.at(body, 2.0 * WATCHED, from)?, self.at(body, WATCHED, from)?)))
    }

    /// The area that its radius sweeps: triangles between places that follow each other.
    fn swept(&self, body: &str, point: &str) -> Option<Vector> {
        place(self.values, body).ok()?;
        let at = |step: u32| self.at(body, WATCHED * f64::from(step) / f64::from(STRIPS), Some(point));
        (0..STRIPS).try_fold(ZERO, |all, step| Some(add(all, times(0.5, cross(at(step)?, at(step + 1)?)))))
    }
}
