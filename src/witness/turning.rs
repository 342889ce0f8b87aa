//! Whether an angular momentum stays the same at every moment of a stage that is watched, so that no moment acts from outside.

use momentous_problem::Conserved;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_simulate::scene::Asked;
use momentous_simulate::scene::RecordedMotion;
use momentous_simulate::scene::measure;
use momentous_simulate::scene::value_of;

use super::simulation::UNCHANGED;
use super::simulation::Witness;

/// Whether it stays; none where positions are not seen as the question counts them.
pub(super) fn stays(
    witness: &Witness<'_>,
    ask: &Conserved,
    about: &str,
    stage: usize,
    motions: &[RecordedMotion],
) -> Option<bool> {
    let scene = witness.scene();
    let (centre, upright) = match scene.stages.get(stage)? {
        Stage::Rotate(rotate) => (Some(&rotate.about), false),
        Stage::Central(central) => (Some(&central.about), false),
        // What is round about an upright axis has no moment about it alone.
        Stage::Bowl(bowl) => (Some(&bowl.about), true),
        Stage::Conical(conical) => (Some(&conical.about), true),
        Stage::Flight(_) => (None, false),
        Stage::Impact(_)
        | Stage::Push(_)
        | Stage::Slide(_)
        | Stage::Spring(_)
        | Stage::Swing(_)
        | Stage::Taut(_)
        | Stage::Connected(_)
        | Stage::Tow(_)
        | Stage::Blow(_)
        | Stage::Moment(_)
        | Stage::Strike(_)
        | Stage::Interact(_)
        | Stage::Fall(_)
        | Stage::Bounces(_)
        | Stage::Stream(_)
        | Stage::Thrust(_)
        | Stage::Drift(_)
        | Stage::Separate(_)
        | Stage::SlideOff(_)
        | Stage::Walk(_)
        | Stage::Motion(_) => return None,
    };
    // A motion round a point is watched from there.
    let from = match centre {
        Some(centre) => (centre == about).then_some([0.0; 3])?,
        None => place(scene, witness, about)?,
    };
    let mut stays = true;
    for motion in motions.iter().filter(|motion| motion.components.len() > 1) {
        let totals: Vec<[f64; 4]> = motion
            .record
            .moments
            .iter()
            .map(|moment| {
                let asked_bodies =
                    motion.record.bodies.iter().enumerate().filter(|(_, body)| ask.of.contains(&body.name));
                asked_bodies.fold([0.0; 4], |sum, (body, _)| {
                    let part = |vectors: &[Vec<f64>], axis: usize| {
                        vectors.get(body).and_then(|vector| vector.get(axis)).copied().unwrap_or(0.0)
                    };
                    let mass = moment.masses.get(body).copied().unwrap_or(f64::NAN);
                    let arm: [f64; 3] = std::array::from_fn(|axis| part(&moment.positions, axis) - from[axis]);
                    let velocity: [f64; 3] = std::array::from_fn(|axis| part(&moment.velocities, axis));
                    let turning =
                        |one: usize, other: usize| mass * (arm[one] * velocity[other] - arm[other] * velocity[one]);
                    let size = mass * libm::sqrt(square(arm) * square(velocity));
                    let part =
                        if upright { [0.0, 0.0, turning(0, 1)] } else { [turning(1, 2), turning(2, 0), turning(0, 1)] };
                    [sum[0] + part[0], sum[1] + part[1], sum[2] + part[2], sum[3] + size]
                })
            })
            .collect();
        let size = totals.iter().map(|total| total[3]).fold(0.0, f64::max);
        let first = totals.first()?;
        stays &= totals.iter().all(|total| (0..3).all(|axis| (total[axis] - first[axis]).abs() <= UNCHANGED * size));
    }
    Some(stays)
}

/// The angular momentum of bodies about a fixed point, each component where there are several, and the sizes that went into it.
pub(super) fn moments(
    witness: &Witness<'_>,
    bodies: &[&str],
    subject: &str,
    instant: usize,
) -> Option<(Vec<f64>, f64)> {
    let scene = witness.scene();
    let axes = scene.axes.rectangular();
    let components: Vec<Option<&str>> =
        if axes.len() == 3 { axes.iter().map(|(axis, _)| Some(axis.letter())).collect() } else { vec![None] };
    let sum_of = |component| {
        measure(scene, bodies, Asked { base: "H", subject, instant, component }, &|name| witness.known(name))
    };
    let all: Vec<(f64, f64)> = components.into_iter().map(sum_of).collect::<Option<_>>()?;
    let size = all.iter().map(|part| part.1).fold(0.0, f64::max);
    Some((all.into_iter().map(|part| part.0).collect(), size))
}

fn square(vector: [f64; 3]) -> f64 {
    vector.iter().map(|part| part * part).sum()
}

/// The place of a fixed point.
fn place(scene: &Scene, witness: &Witness<'_>, point: &str) -> Option<[f64; 3]> {
    let mut place = [0.0; 3];
    let at = &scene.points.get(point)?.at;
    for ((axis, _), coordinate) in scene.axes.rectangular().iter().zip(&mut place) {
        if let Some(term) = at.get(*axis) {
            *coordinate = value_of(scene, &term.0, &|name| witness.value(name))?;
        }
    }
    Some(place)
}
