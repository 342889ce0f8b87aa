//! Measures of bodies at an instant: speeds, directions, energies, the centre of mass, moments.

use momentous_scene::{Axis, Scene};

use super::nothing::NothingToSimulate;
use super::stage_run::kinetic;
use super::values::Values;
use super::vector::{Vector, ZERO, add, cross, less, part, size, times, unit};

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

/// Measures a quantity of the bodies at an instant: their velocities and places are what `value` gives. The second number is
/// the size of what it is a difference of.
#[must_use]
pub fn measure(
    scene: &Scene,
    alive: &[&str],
    asked: Asked<'_>,
    value: &dyn Fn(&str) -> Option<f64>,
) -> Option<(f64, f64)> {
    let values = Values { scene, value, index: asked.instant.checked_sub(1)? };
    let one = |vector: Vector| along(&values, asked).map(|axis| part(vector, axis));
    let moving = |body: &str| velocity(&values, body).ok();
    match (asked.base, asked.subject) {
        ("speed", body) => Some((size(moving(body)?), 0.0)),
        ("angle", body) if values.axes().len() == 2 => {
            let vector = moving(body)?;
            Some((libm::atan2(vector[1], vector[0]), 1.0))
        }
        ("p", "") => {
            let (all, scale) = sum(&values, alive, &moving)?;
            Some((one(all)?, scale))
        }
        ("p", body) => {
            let (total, scale) = sum(&values, &[body], &moving)?;
            Some((one(total)?, scale))
        }
        ("T", "") => energy_by_speed(&values, alive),
        ("T", body) if body != "G" => energy_by_speed(&values, &[body]),
        ("V", body) => {
            let (centre, mass) = (place(&values, body).ok()?, values.mass(body).ok()?);
            let lifted = values.axes().into_iter().map(|axis| Some(-values.gravity(axis).ok()? * part(centre, axis)));
            Some((mass * lifted.sum::<Option<f64>>()?, 0.0))
        }
        ("r" | "v", "G") => of_centre(&values, alive, asked, &moving),
        ("v", body) => Some((one(moving(body)?)?, 0.0)),
        ("H", point) => {
            let places = |body: &str| place(&values, body).ok();
            let centre = centre(&values, alive, point, &places)?;
            let moment = |body: &str| Some(cross(less(places(body)?, centre), moving(body)?));
            let (all, scale) = sum(&values, alive, &moment)?;
            // An arm along the velocity has no moment, but a product of that size goes into it.
            let sizes = alive
                .iter()
                .map(|body| Some(values.mass(body).ok()? * size(less(places(body)?, centre)) * size(moving(body)?)));
            let scale = sizes.sum::<Option<f64>>().map_or(scale, |sizes| scale.max(sizes));
            Some((turning(&values, asked, all)?, scale))
        }
        _ => None,
    }
}

/// The place of the centre of mass, or its velocity where the bodies move so.
pub(super) fn of_centre(
    values: &Values<'_>,
    bodies: &[&str],
    asked: Asked<'_>,
    moving: &dyn Fn(&str) -> Option<Vector>,
) -> Option<(f64, f64)> {
    let (mean, scale) = match asked.base {
        "r" => mean(values, bodies, &|body| place(values, body).ok())?,
        _ => mean(values, bodies, moving)?,
    };
    Some((part(mean, along(values, asked)?), scale))
}

/// Which moment a name refers to: the only one of a plane, or that of its component.
pub(super) fn turning(values: &Values<'_>, asked: Asked<'_>, moment: Vector) -> Option<f64> {
    match (values.axes().len(), asked.component) {
        (2, None) => Some(moment[2]),
        (3, Some(_)) => along(values, asked).map(|axis| part(moment, axis)),
        _ => None,
    }
}

/// The place of a point of the scene, or of the centre of mass of bodies.
pub(super) fn centre(
    values: &Values<'_>,
    bodies: &[&str],
    point: &str,
    places: &dyn Fn(&str) -> Option<Vector>,
) -> Option<Vector> {
    if point == "G" {
        return mean(values, bodies, places).map(|(mean, _)| mean);
    }
    let at = &values.scene.points.get(point)?.at;
    at.axes().try_fold(ZERO, |all, axis| Some(add(all, times(values.term(at.get(axis)?).ok()?, unit(axis)))))
}

/// The axis of a component, or the only one.
pub(super) fn along(values: &Values<'_>, asked: Asked<'_>) -> Option<Axis> {
    match (asked.component, &values.axes()[..]) {
        (Some(letter), axes) => axes.iter().copied().find(|axis| axis.letter() == letter),
        (None, [only]) => Some(*only),
        (None, _) => None,
    }
}

/// The velocity of a body, or of what it is part of.
pub(super) fn velocity(values: &Values<'_>, body: &str) -> Result<Vector, NothingToSimulate> {
    if values.axes().is_empty() {
        return Err(NothingToSimulate::Unread);
    }
    values.moving(body).or_else(|missing| {
        let owner = |whole: &&str| values.scene.members(whole).contains(&body) && *whole != body;
        let wholes = values.scene.stages.iter().filter_map(|stage| Some(stage.whole_and_parts()?.0));
        wholes.filter(owner).find_map(|whole| values.moving(whole).ok()).ok_or(missing)
    })
}

/// The place of a body.
pub(super) fn place(values: &Values<'_>, body: &str) -> Result<Vector, NothingToSimulate> {
    if values.axes().is_empty() {
        return Err(NothingToSimulate::Unread);
    }
    values
        .axes()
        .into_iter()
        .try_fold(ZERO, |all, axis| Ok(add(all, times(values.place_before(body, axis)?, unit(axis)))))
}

/// The sum over bodies of a vector counted by mass; and the sum of the sizes.
pub(super) fn sum(
    values: &Values<'_>,
    bodies: &[&str],
    vector: &dyn Fn(&str) -> Option<Vector>,
) -> Option<(Vector, f64)> {
    bodies.iter().try_fold((ZERO, 0.0), |(all, scale), body| {
        let momentum = times(values.mass(body).ok()?, vector(body)?);
        Some((add(all, momentum), scale + size(momentum)))
    })
}

/// The mean of what each body has, counted by its mass; and the mean of the sizes.
pub(super) fn mean(
    values: &Values<'_>,
    bodies: &[&str],
    vector: &dyn Fn(&str) -> Option<Vector>,
) -> Option<(Vector, f64)> {
    let (all, scale) = sum(values, bodies, vector)?;
    let whole: f64 = bodies.iter().map(|body| values.mass(body).ok()).sum::<Option<f64>>()?;
    Some((times(1.0 / whole, all), scale / whole))
}

/// The kinetic energy of bodies, by their velocities or by their speeds.
fn energy_by_speed(values: &Values<'_>, bodies: &[&str]) -> Option<(f64, f64)> {
    let each = bodies.iter().map(|body| {
        let speed = || values.named(&format!("speed_{body}{}", values.index + 1)).ok();
        let speed = velocity(values, body).ok().map(size).or_else(speed)?;
        Some(values.mass(body).ok()? * speed * speed / 2.0)
    });
    Some((each.sum::<Option<f64>>()?, 0.0))
}

/// The kinetic energy of bodies that move so.
pub(super) fn energy(
    values: &Values<'_>,
    bodies: &[&str],
    moving: &dyn Fn(&str) -> Option<Vector>,
) -> Option<(f64, f64)> {
    let each = bodies.iter().map(|body| Some(kinetic(values.mass(body).ok()?, moving(body)?)));
    Some((each.sum::<Option<f64>>()?, 0.0))
}
