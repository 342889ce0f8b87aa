//! How particles go on until a time or an event.

use super::filming::Motion;
use super::integrate::{End, Integrator};
use super::nothing::NothingToSimulate;
use super::particles::velocity;
use super::stage_run::StageRun;
use super::system::System;
use super::vector::size;

/// The end of a motion.
pub(super) enum Until<'a, const N: usize> {
    Time(f64),
    /// Something that is positive until then.
    Event(&'a dyn Fn(&[f64; N]) -> f64),
}

/// A goal that a motion reaches, or at which it just turns back, so that it touches the goal and does not cross it.
pub(super) struct Goal<'a, S> {
    /// The rest of the way.
    pub left: &'a dyn Fn(&S) -> f64,
    /// How fast that gets less.
    pub closing: &'a dyn Fn(&S) -> f64,
    /// The whole way.
    pub whole: f64,
    /// About how long the motion takes.
    pub time: f64,
}

/// The share of its way within which a motion that turns back has reached its goal.
const BEYOND: f64 = 1e-9;

impl<S> Goal<'_, S> {
    /// Positive until the motion is well beyond the goal or turns back near it.
    pub(super) fn passed(&self, state: &S) -> f64 {
        self.turned(state).min((self.left)(state) + BEYOND * self.whole)
    }

    /// Whether a motion that has been tried out up to this state goes on beyond the goal, and does not turn back there.
    pub(super) fn is_crossed(&self, tried: &S) -> bool {
        (self.left)(tried) < -BEYOND / 2.0 * self.whole
    }

    /// The end of the motion, where it has been tried out up to this state: the goal itself where it goes on beyond, else where
    /// it turns.
    pub(super) fn end(&self, tried: &S) -> impl Fn(&S) -> f64 {
        let crosses = self.is_crossed(tried);
        move |state| if crosses { (self.left)(state) } else { self.turned(state) }
    }

    fn turned(&self, state: &S) -> f64 {
        let left = (self.left)(state);
        if left > self.whole / 2.0 { left } else { (self.closing)(state) * self.time }
    }
}

impl StageRun<'_> {
    /// Lets particles go until a motion of theirs ends, and watches them.
    pub(super) fn go<const N: usize>(
        &mut self,
        system: &System<'_, N>,
        integrator: Integrator,
        until: &Until<'_, N>,
    ) -> Result<End<N>, NothingToSimulate> {
        let names: Vec<&str> =
            system.particles.iter().filter(|particle| particle.mass.is_some()).map(|particle| particle.name).collect();
        let end = if let Until::Time(time) = until { *time } else { f64::INFINITY };
        let stop = |_: f64, state: &[f64; N]| if let Until::Event(stop) = until { stop(state) } else { 1.0 };
        let state = system.state();
        let mut reached = End { time: system.start, state, stopped: false, largest: state.map(f64::abs) };
        let changes = system.changes.iter().copied().filter(|change| *change > system.start && *change < end);
        for next in changes.chain([end]) {
            // Just before a change the old law holds.
            let slope = |at: f64, state: &[f64; N]| system.slope(if at >= next { next.next_down() } else { at }, state);
            let look = |at: f64, state: &[f64; N]| system.look(if at >= next { next.next_down() } else { at }, state);
            let start = (reached.time, reached.state);
            let course = self.course(|| system.course(start.0, &start.1));
            reached = match course.known() {
                Some(formula) => formula.run(start, next, integrator.longest, &stop)?,
                None => integrator.run(start.0, start.1, next, &slope, &stop)?,
            };
            let components = system.frame.components.clone();
            for index in 0..system.particles.len() {
                self.fastest = self.fastest.max(size(velocity(&reached.largest, index)));
            }
            let (end, slope, look) = (reached.time, &slope, &look);
            self.film(&Motion { names: &names, components, start, end, slope, course: &course, look })?;
            if reached.stopped {
                break;
            }
        }
        Ok(reached)
    }

    /// Lets particles go until they reach a goal, and watches them.
    pub(super) fn go_to<const N: usize>(
        &mut self,
        system: &System<'_, N>,
        integrator: Integrator,
        goal: &Goal<'_, [f64; N]>,
    ) -> Result<End<N>, NothingToSimulate> {
        let tried = self.try_out(system, integrator, &Until::Event(&|state| goal.passed(state)))?;
        let end = goal.end(&tried.state);
        self.go(system, integrator, &Until::Event(&end))
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
        let result = run(self);
        self.motions = motions;
        result
    }
}
