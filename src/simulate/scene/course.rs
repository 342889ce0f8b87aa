//! How particles go on until a time or an event.

use super::filming::Motion;
use super::integrate::{End, Integrator};
use super::nothing::NothingToSimulate;
use super::stage_run::StageRun;
use super::system::System;

/// What ends a motion.
pub(super) enum Until<'a, const N: usize> {
    Time(f64),
    /// Something that is positive until then.
    Event(&'a dyn Fn(&[f64; N]) -> f64),
}

impl StageRun<'_> {
    /// Lets particles go until a motion of theirs ends, and watches them.
    pub(super) fn go<const N: usize>(
        &mut self,
        system: &System<'_, N>,
        integrator: Integrator,
        until: &Until<'_, N>,
    ) -> Result<End<N>, NothingToSimulate> {
        let names: Vec<&str> = system.particles.iter().filter(|own| own.mass.is_some()).map(|own| own.name).collect();
        let end = if let Until::Time(time) = until { *time } else { f64::INFINITY };
        let stop = |_: f64, state: &[f64; N]| if let Until::Event(stop) = until { stop(state) } else { 1.0 };
        let mut reached = End { time: system.start, state: system.state(), stopped: false };
        let changes = system.changes.iter().copied().filter(|change| *change > system.start && *change < end);
        for next in changes.chain([end]) {
            // Just before a change the old law holds.
            let slope = |at: f64, state: &[f64; N]| system.slope(if at >= next { next.next_down() } else { at }, state);
            let look = |at: f64, state: &[f64; N]| system.look(if at >= next { next.next_down() } else { at }, state);
            let start = (reached.time, reached.state);
            reached = integrator.run(start.0, start.1, next, &slope, &stop)?;
            let components = system.frame.components.clone();
            self.film(&Motion { names: &names, components, start, end: reached.time, slope: &slope, look: &look })?;
            if reached.stopped {
                break;
            }
        }
        Ok(reached)
    }

    /// The same without watching.
    pub(super) fn try_out<const N: usize>(
        &mut self,
        system: &System<'_, N>,
        integrator: Integrator,
        until: &Until<'_, N>,
    ) -> Result<End<N>, NothingToSimulate> {
        self.unwatched(|bench| bench.go(system, integrator, until))
    }

    /// Runs something while nobody watches.
    pub(super) fn unwatched<T>(&mut self, run: impl FnOnce(&mut Self) -> T) -> T {
        let motions = self.motions.take();
        let found = run(self);
        self.motions = motions;
        found
    }
}
