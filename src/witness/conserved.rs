//! Whether a quantity is conserved in a stage, as a simulation of it finds.

use momentous_problem::Conservable;
use momentous_problem::Conserved;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_simulate::scene::Component;
use momentous_simulate::scene::RecordedMotion;

use super::case::Case;
use super::simulation::UNCHANGED;
use super::simulation::Witness;
use super::turning;

/// A sum over bodies, and the sum of the sizes.
type Total = (f64, f64);

/// Whether a quantity is the same before a stage and after it; where the stage lasts, also at every moment that is watched in
/// between, so that what acts from outside has given and done nothing up to then.
pub(super) fn is_conserved(case: &Case<'_>, witness: &Witness<'_>, ask: &Conserved) -> Option<bool> {
    let scene = case.scene;
    let stage = witness.stage_of(ask.stage.as_deref()).filter(|stage| witness.has_run(*stage))?;
    let lasts = scene.stages.get(stage).is_some_and(|stage| !takes_no_time(stage));
    if lasts && ask.conserved == Conservable::AngularMomentum {
        let motions = witness.watched(stage);
        let stays = motions.and_then(|motions| turning::stays(witness, ask, about(scene, ask)?, stage, &motions));
        // Equal ends alone prove nothing.
        return stays.or_else(|| ends(scene, witness, ask, stage).filter(|same| !same));
    }
    let ends = ends(scene, witness, ask, stage)?;
    if !ends || !lasts {
        return Some(ends);
    }
    Some(witness.watched(stage).is_none_or(|motions| stays(scene, ask, &motions)))
}

/// The point about which angular momentum is meant.
fn about<'a>(scene: &'a Scene, ask: &'a Conserved) -> Option<&'a str> {
    ask.about.as_deref().or_else(|| scene.points.keys().next().map(String::as_str))
}

fn takes_no_time(stage: &Stage) -> bool {
    matches!(
        stage,
        Stage::Impact(_) | Stage::Blow(_) | Stage::Taut(_) | Stage::Strike(_) | Stage::Separate(_) | Stage::Interact(_)
    )
}

/// Whether the sum is the same before the stage and after it.
fn ends(scene: &Scene, witness: &Witness<'_>, ask: &Conserved, stage: usize) -> Option<bool> {
    let total = |base: &str, letter: &str| -> Option<[Total; 2]> {
        let mut ends = [(0.0, 0.0); 2];
        for (end, instant) in ends.iter_mut().zip([stage + 1, stage + 2]) {
            for body in &ask.of {
                let part = witness.carried(base, body, instant, letter)?;
                *end = (end.0 + part, end.1 + part.abs());
            }
        }
        Some(ends)
    };
    match ask.conserved {
        Conservable::Momentum => {
            // What is nothing along one axis is known to the error of the others.
            let all = every_letter(scene).into_iter().filter_map(|letter| total("p", letter));
            let size = all.flatten().map(|total| total.1).fold(0.0, f64::max);
            let is_same = |[before, after]: [Total; 2]| (after.0 - before.0).abs() <= UNCHANGED * size;
            let asked = letters(scene, ask).into_iter().map(|letter| total("p", letter).map(is_same));
            let is_same = asked.collect::<Option<Vec<bool>>>()?.into_iter().all(|agrees| agrees);
            // On which side of the support an arm carries a body is not said: with all on one side, equal sums prove nothing.
            let has_sides = matches!(scene.stages.get(stage), Some(Stage::Strike(_)));
            (!(is_same && has_sides)).then_some(is_same)
        }
        Conservable::Energy => total("T", "").map(same),
        Conservable::AngularMomentum => {
            let point = about(scene, ask)?;
            let bodies: Vec<&str> = ask.of.iter().map(String::as_str).collect();
            let moments = [stage + 1, stage + 2].map(|instant| turning::moments(witness, &bodies, point, instant));
            if let [Some(before), Some(after)] = moments {
                let size = before.1.max(after.1);
                let is_same = |(before, after): (&f64, &f64)| (after - before).abs() <= UNCHANGED * size;
                return Some(before.0.iter().zip(&after.0).all(is_same));
            }
            let is_asked = |body: &String| {
                ask.of.iter().any(|asked| asked == body || scene.members(asked).contains(&body.as_str()))
            };
            if !scene.bodies.keys().all(is_asked) {
                return None;
            }
            let ends = [stage + 1, stage + 2].map(|instant| witness.seen(&format!("H_{point}{instant}")));
            match ends {
                // Where all of it cancels, what is left is known to its error only.
                [Some(before), Some(after)] => {
                    let size = before.value.abs().max(after.value.abs());
                    Some((after.value - before.value).abs() <= UNCHANGED * size + before.error + after.error)
                }
                _ => None,
            }
        }
    }
}

/// The letters of the axes; none of the only axis.
fn every_letter(scene: &Scene) -> Vec<&'static str> {
    let axes = scene.axes.rectangular();
    axes.iter().map(|(axis, _)| if axes.len() > 1 { axis.letter() } else { "" }).collect()
}

/// The letters of those along which momentum is asked.
fn letters(scene: &Scene, ask: &Conserved) -> Vec<&'static str> {
    let asked = |letter: &&str| letter.is_empty() || ask.along.is_none_or(|axis| axis.letter() == *letter);
    every_letter(scene).into_iter().filter(asked).collect()
}

fn same([before, after]: [Total; 2]) -> bool {
    (after.0 - before.0).abs() <= UNCHANGED * before.1.max(after.1)
}

/// Whether the sum is the same at every moment that is watched; of bodies that are not seen to move nothing changes. Bodies that move
/// by themselves are added up where they are watched at the same times, and judged by the ends alone elsewhere.
fn stays(scene: &Scene, ask: &Conserved, motions: &[RecordedMotion]) -> bool {
    let is_asked = |motion: &&RecordedMotion| motion.record.bodies.iter().any(|body| ask.of.contains(&body.name));
    let watched: Vec<&RecordedMotion> = motions.iter().filter(is_asked).collect();
    let times = |motion: &RecordedMotion| motion.record.moments.iter().map(|moment| moment.time).collect::<Vec<_>>();
    let Some((first, others)) = watched.split_first() else { return true };
    let is_beside = |other: &&RecordedMotion| times(other) == times(first) && other.components == first.components;
    if !others.iter().all(is_beside) {
        return true;
    }
    let totals: Vec<Vec<Total>> = (0..first.record.moments.len())
        .map(|moment| {
            let mut sums = vec![(0.0, 0.0); first.components.len().max(1)];
            for motion in &watched {
                add(&mut sums, scene, ask, motion, moment);
            }
            sums
        })
        .collect();
    let size = totals.iter().flatten().map(|sum| sum.1).fold(0.0, f64::max);
    let Some(start) = totals.first() else { return true };
    let is_same =
        |sums: &Vec<Total>| sums.iter().zip(start).all(|(total, start)| (total.0 - start.0).abs() <= UNCHANGED * size);
    totals.iter().all(is_same)
}

/// Adds what the bodies that are asked for have in a motion at a moment.
fn add(sums: &mut [Total], scene: &Scene, ask: &Conserved, motion: &RecordedMotion, moment: usize) {
    // Beside the only axis of a scene, a motion may have a height of its own, along which nobody asks.
    let is_asked = |component: &Component| match scene.axes.rectangular().len() {
        0 | 1 => motion.components.len() < 2 || !component.vertical,
        _ => ask.along.is_none_or(|axis| axis.letter() == component.letter),
    };
    let Some(moment) = motion.record.moments.get(moment) else { return };
    for (place, _) in motion.record.bodies.iter().enumerate().filter(|(_, body)| ask.of.contains(&body.name)) {
        let (Some(mass), Some(velocity)) = (moment.masses.get(place), moment.velocities.get(place)) else { continue };
        match ask.conserved {
            Conservable::Momentum => {
                for ((sum, part), component) in sums.iter_mut().zip(velocity).zip(&motion.components) {
                    if is_asked(component) {
                        *sum = (sum.0 + mass * part, sum.1 + (mass * part).abs());
                    }
                }
            }
            Conservable::Energy => {
                let energy = mass * velocity.iter().map(|part| part * part).sum::<f64>() / 2.0;
                sums[0] = (sums[0].0 + energy, sums[0].1 + energy);
            }
            Conservable::AngularMomentum => {}
        }
    }
}
