//! What is measured on bodies at an instant: speeds, directions, energies, the mass centre, moments.

use crate::scene::{Axis, Scene, Stage};

use super::bench::{kinetic, part};
use super::direction::unit;
use super::nothing::NothingToSimulate;
use super::state::add;
use super::values::Values;

/// A name of the scene, taken apart: `v_G2.x` has the base `v`, the subject `G`, the instant 2 and the component `x`.
#[derive(Clone, Copy, Debug)]
pub struct Asked<'a> {
    /// The kind of quantity.
    pub base: &'a str,
    /// Whose; empty for the system.
    pub subject: &'a str,
    /// When, counted from 1.
    pub instant: usize,
    /// Which component.
    pub component: Option<&'a str>,
}

/// How long free motion is watched where nothing happens in the scene, in s.
const WATCHED: f64 = 1.0;

/// Strips of the area that a radius sweeps meanwhile.
const STRIPS: u32 = 64;

/// Measures a quantity of the bodies at an instant: their velocities and places are what `value` gives. The second number is
/// the size of what it is a difference of.
#[must_use]
pub fn measure(
    scene: &Scene,
    alive: &[&str],
    asked: Asked<'_>,
    value: &dyn Fn(&str) -> Option<f64>,
) -> Option<(f64, f64)> {
    let values = in_plane(scene, asked, value)?;
    let axis = along(&values, asked);
    match (asked.base, asked.subject) {
        ("speed", body) => velocity(&values, body).ok().map(|own| (libm::hypot(own[0], own[1]), 0.0)),
        ("angle", body) if values.axes().len() == 2 => {
            let own = velocity(&values, body).ok()?;
            Some((libm::atan2(own[1], own[0]), 1.0))
        }
        ("p", "") => sum(&values, alive, axis?),
        ("p", body) => sum(&values, &[body], axis?),
        ("T", "") => energy(&values, alive),
        ("T", body) => energy(&values, &[body]),
        ("v", "G") => {
            let (momentum, scale) = sum(&values, alive, axis?)?;
            let whole: f64 = masses(&values, alive)?.into_iter().sum();
            Some((momentum / whole, scale / whole))
        }
        ("v", body) => Some((part(velocity(&values, body).ok()?, axis?), 0.0)),
        ("r", "G") => mean_place(&values, alive, axis?, 0.0),
        ("H", point) if is_origin(&values, point) => moment(&values, alive),
        _ => None,
    }
}

/// Measures what is asked of a scene in which nothing happens: its bodies are watched for a while in free motion.
#[must_use]
pub fn watch(
    scene: &Scene,
    alive: &[&str],
    asked: Asked<'_>,
    value: &dyn Fn(&str) -> Option<f64>,
) -> Option<(f64, f64)> {
    let values = in_plane(scene, asked, value)?;
    let axis = along(&values, asked);
    match (asked.base, asked.subject) {
        ("r", "G") => mean_place(&values, alive, axis?, 0.0),
        ("v", "G") => {
            let (before, one) = mean_place(&values, alive, axis?, WATCHED)?;
            let (after, other) = mean_place(&values, alive, axis?, 2.0 * WATCHED)?;
            Some(((after - before) / WATCHED, (one + other) / WATCHED))
        }
        // Twice the mass for each area that the radius sweeps in a unit of time.
        ("H", point) if is_origin(&values, point) => {
            let mut all = (0.0, 0.0);
            for body in alive {
                let rate = 2.0 * values.mass(body).ok()? * swept(&values, body).ok()? / WATCHED;
                all = (all.0 + rate, all.1 + rate.abs());
            }
            Some(all)
        }
        _ => None,
    }
}

/// The values at the instant that is asked for; none in a scene with more than two axes, since a plane is looked at.
fn in_plane<'a>(scene: &'a Scene, asked: Asked<'_>, value: &'a dyn Fn(&str) -> Option<f64>) -> Option<Values<'a>> {
    let values = Values { scene, value, index: asked.instant.checked_sub(1)? };
    (values.axes().len() <= 2).then_some(values)
}

/// Whether a point is the origin of places in a plane, about which moments are taken here.
fn is_origin(values: &Values<'_>, point: &str) -> bool {
    let placed = |own: &crate::scene::Point| own.at.axes().next().is_some();
    values.axes().len() != 1 && values.scene.points.get(point).is_some_and(|own| !placed(own))
}

/// The axis of a component, or the only one.
fn along(values: &Values<'_>, asked: Asked<'_>) -> Option<Axis> {
    match (asked.component, &values.axes()[..]) {
        (Some(letter), axes) => axes.iter().copied().find(|axis| axis.letter() == letter),
        (None, [only]) => Some(*only),
        (None, _) => None,
    }
}

/// The velocity of a body, or of what it is part of.
fn velocity(values: &Values<'_>, body: &str) -> Result<[f64; 2], NothingToSimulate> {
    values.moving(body).or_else(|missing| {
        let owner = |whole: &&String| values.scene.members(whole).contains(&body) && whole.as_str() != body;
        let wholes = values.scene.stages.iter().filter_map(|stage| match stage {
            Stage::Impact(impact) => impact.becomes.as_ref(),
            Stage::Separate(separate) => separate.from.as_ref(),
            _ => None,
        });
        wholes.filter(owner).find_map(|whole| values.moving(whole).ok()).ok_or(missing)
    })
}

fn masses(values: &Values<'_>, bodies: &[&str]) -> Option<Vec<f64>> {
    bodies.iter().map(|body| values.mass(body).ok()).collect()
}

fn sum(values: &Values<'_>, bodies: &[&str], axis: Axis) -> Option<(f64, f64)> {
    let mut all = (0.0, 0.0);
    for (body, mass) in bodies.iter().zip(masses(values, bodies)?) {
        let own = mass * part(velocity(values, body).ok()?, axis);
        all = (all.0 + own, all.1 + own.abs());
    }
    Some(all)
}

fn energy(values: &Values<'_>, bodies: &[&str]) -> Option<(f64, f64)> {
    let mut all = 0.0;
    for (body, mass) in bodies.iter().zip(masses(values, bodies)?) {
        all += kinetic(mass, velocity(values, body).ok()?);
    }
    Some((all, 0.0))
}

/// The mean of the places of all bodies, each counted by its mass, when they have gone on for a time. Where only velocities
/// are spoken of, they may all start at the same place.
fn mean_place(values: &Values<'_>, bodies: &[&str], axis: Axis, time: f64) -> Option<(f64, f64)> {
    let (mut all, mut scale, mut whole) = (0.0, 0.0, 0.0);
    for (body, mass) in bodies.iter().zip(masses(values, bodies)?) {
        let start = values.place_before(body, axis).ok().or((time > 0.0).then_some(0.0))?;
        let way = if time > 0.0 { time * values.velocity_before(body, axis).ok()? } else { 0.0 };
        (all, scale, whole) = (all + mass * (start + way), scale + mass * (start.abs() + way.abs()), whole + mass);
    }
    Some((all / whole, scale / whole))
}

fn moment(values: &Values<'_>, bodies: &[&str]) -> Option<(f64, f64)> {
    let mut all = (0.0, 0.0);
    for (body, mass) in bodies.iter().zip(masses(values, bodies)?) {
        let [x, y] = place(values, body).ok()?;
        let [u, v] = velocity(values, body).ok()?;
        all = (all.0 + mass * (x * v - y * u), all.1 + mass * ((x * v).abs() + (y * u).abs()));
    }
    Some(all)
}

fn place(values: &Values<'_>, body: &str) -> Result<[f64; 2], NothingToSimulate> {
    let mut all = [0.0; 2];
    for axis in values.axes() {
        let own = values.place_before(body, axis)?;
        all = add(all, unit(axis).map(|part| part * own));
    }
    Ok(all)
}

/// The area that the radius of a body sweeps while it is watched: triangles between places that follow each other.
fn swept(values: &Values<'_>, body: &str) -> Result<f64, NothingToSimulate> {
    let ([x, y], [u, v]) = (place(values, body)?, values.moving(body)?);
    let at = |step: u32| {
        let time = WATCHED * f64::from(step) / f64::from(STRIPS);
        [x + u * time, y + v * time]
    };
    let triangle = |step: u32| {
        let ([a, b], [c, d]) = (at(step), at(step + 1));
        (a * d - b * c) / 2.0
    };
    Ok((0..STRIPS).map(triangle).sum())
}
