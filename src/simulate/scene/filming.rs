//! How a motion that is integrated is watched: its bodies at common instants, and what acts on them meanwhile.

use crate::record::{GAUSS, Moment, Pivot, Record, Recorded};

use super::component::Component;
use super::integrate::{Integrator, Slope};
use super::nothing::NothingToSimulate;
use super::recorded_motion::{Look, RecordedMotion, Seen};
use super::stage_run::StageRun;

/// The evenly spaced instants of a motion.
const INSTANTS: u32 = 120;

/// A motion to be watched: how its state goes on from a start to an end, and what is seen of it.
pub(super) struct Motion<'a, const N: usize> {
    pub names: &'a [&'a str],
    pub components: Vec<Component>,
    pub start: (f64, [f64; N]),
    pub end: f64,
    pub slope: Slope<'a, N>,
    pub look: &'a dyn Fn(f64, &[f64; N]) -> Look,
}

impl StageRun<'_> {
    /// Watches a motion, where anybody does. One that goes on where the last one ended continues it; any other takes its place.
    pub(super) fn film<const N: usize>(&mut self, motion: &Motion<'_, N>) -> Result<(), NothingToSimulate> {
        let tolerance = self.tolerance;
        let Some(motions) = self.motions.as_mut().filter(|_| motion.end > motion.start.0) else { return Ok(()) };
        let ended = |recorded: &RecordedMotion| {
            recorded.record.moments.last().is_some_and(|last| last.time.total_cmp(&motion.start.0).is_eq())
        };
        let same = |recorded: &mut RecordedMotion| {
            recorded.record.bodies.iter().map(|body| body.name.as_str()).eq(motion.names.iter().copied())
        };
        let before = motions.pop_if(same);
        let mut recorded = before.filter(ended).unwrap_or_else(|| RecordedMotion {
            components: motion.components.clone(),
            record: Record {
                bodies: Vec::new(),
                walls: Vec::new(),
                pivot: None,
                moments: Vec::new(),
                impacts: Vec::new(),
            },
            notes: Vec::new(),
        });
        let longest = (motion.end - motion.start.0) / f64::from(INSTANTS);
        motion.watch(Integrator { tolerance, longest }, &mut recorded.record)?;
        motions.push(recorded);
        Ok(())
    }

    /// Notes what the bodies of the last motion that was watched move about.
    pub(super) fn about(&mut self, at: Vec<f64>, cord: bool) {
        if let Some(motion) = self.motions.as_mut().and_then(|motions| motions.last_mut()) {
            motion.record.pivot = Some(Pivot { at, cord });
        }
    }

    /// Notes what a reader of the last motion that was watched must know.
    pub(super) fn remark(&mut self, note: &'static str) {
        if let Some(motion) = self.motions.as_mut().and_then(|motions| motions.last_mut())
            && !motion.notes.contains(&note)
        {
            motion.notes.push(note);
        }
    }
}

impl<const N: usize> Motion<'_, N> {
    fn watch(&self, integrator: Integrator, record: &mut Record) -> Result<(), NothingToSimulate> {
        let (start, mut state) = self.start;
        let first = (self.look)(start, &state);
        let (mut outside, mut work) = match record.moments.last() {
            Some(last) => (last.outside.clone(), last.work),
            None => (vec![0.0; self.components.len()], 0.0),
        };
        if record.bodies.is_empty() {
            let named = self.names.iter().zip(&first.bodies);
            record.bodies =
                named.map(|(name, body)| Recorded { name: (*name).to_owned(), mass: body.mass, radius: 0.0 }).collect();
        }
        let mut time = start;
        record.moments.push(moment(time, first, &outside, work));
        for step in 1..=INSTANTS {
            let next = start + (self.end - start) * f64::from(step) / f64::from(INSTANTS);
            let (middle, half) = (f64::midpoint(time, next), (next - time) / 2.0);
            for (place, weight) in GAUSS {
                let node = middle + place * half;
                (state, time) = (integrator.until(time, state, node, self.slope)?, node);
                let look = (self.look)(time, &state);
                for (sum, force) in outside.iter_mut().zip(&look.outside) {
                    *sum += force * weight * half;
                }
                work += look.power * weight * half;
            }
            (state, time) = (integrator.until(time, state, next, self.slope)?, next);
            record.moments.push(moment(time, (self.look)(time, &state), &outside, work));
        }
        Ok(())
    }
}

fn moment(time: f64, look: Look, outside: &[f64], work: f64) -> Moment {
    let total: f64 = look.bodies.iter().map(|body| body.mass).sum();
    let added = |value: &dyn Fn(&Seen, usize) -> f64| -> Vec<f64> {
        (0..outside.len()).map(|part| look.bodies.iter().map(|body| body.mass * value(body, part)).sum()).collect()
    };
    let squares = |body: &Seen| body.velocity.iter().map(|part| part * part).sum::<f64>();
    Moment {
        time,
        centre: added(&|body, part| body.place[part] / total),
        momentum: added(&|body, part| body.velocity[part]),
        outside: outside.to_vec(),
        kinetic: look.bodies.iter().map(|body| body.mass * squares(body) / 2.0).sum(),
        potential: look.potential,
        lost: look.lost,
        work,
        masses: look.bodies.iter().map(|body| body.mass).collect(),
        positions: look.bodies.iter().map(|body| body.place.clone()).collect(),
        velocities: look.bodies.into_iter().map(|body| body.velocity).collect(),
    }
}
