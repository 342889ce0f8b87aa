//! Bounces on a floor: what is read off the worlds, and heights and the path, which are integrated.

use momentous_scene::stage::Bounces;

use crate::scene::integrate::Integrator;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::stage_run::{Procedure, StageRun};
use crate::scene::vector::size;

/// The share of the first height below which a bounce adds nothing.
const NOTHING: f64 = 1e-14;

/// The last bounce whose height has a name with its number.
const NUMBERED: u32 = 40;

/// The acceleration of free fall, on which no ratio of heights depends, where nothing else needs it.
const ANY_GRAVITY: f64 = 9.81;

/// Bounces after which a path is given up.
const MOST_BOUNCES: u32 = 2_000;

impl StageRun<'_> {
    pub(super) fn bounces(&mut self, stage: &Bounces) -> Result<(), NothingToSimulate> {
        if let Err(missing) = self.values.drop_before(stage) {
            return self.heights_after_a_known_one(stage).ok_or(missing)?;
        }
        let staged = self.values.bounces(stage)?;
        self.take(&staged)?;
        self.by(Procedure::Integrated);
        match self.values.drop_before(stage)? {
            Some(height) => self.path(stage, height),
            None => self.between_bounces(stage),
        }
    }

    /// Heights and the whole path after a drop.
    fn path(&mut self, stage: &Bounces, height: f64) -> Result<(), NothingToSimulate> {
        let count = self.values.bounces_counted(stage);
        let (gravity, e) = (self.values.named("g")?, self.values.term(&stage.restitution)?);
        let mut path = height;
        let mut rise = height;
        for bounce in 1..=MOST_BOUNCES {
            let (arrives, top) = self.bounce(rise, gravity, e)?;
            rise = top;
            let is_counted = count.is_some_and(|count| (count - f64::from(bounce)).abs() < 0.5);
            self.note_bounce(stage, (bounce, is_counted), [arrives, e * arrives]);
            if bounce <= NUMBERED {
                self.note(&format!("h_{bounce}"), rise, 0.0);
            }
            if is_counted {
                self.note("path_n", path, 0.0);
            }
            path += 2.0 * rise;
            if is_counted {
                self.note("h_n", rise, 0.0);
            }
            if rise <= NOTHING * height {
                self.note("path_total", path, 0.0);
                return Ok(());
            }
        }
        Ok(())
    }

    /// Heights after a bounce whose height is known, where nobody says from where the body was dropped.
    fn heights_after_a_known_one(&mut self, stage: &Bounces) -> Option<Result<(), NothingToSimulate>> {
        let known = |bounce: &u32| self.values.named(&format!("h_{bounce}")).ok();
        let first = (1..=NUMBERED).find(|bounce| known(bounce).is_some())?;
        let mut rise = known(&first)?;
        let (gravity, e) = (self.values.named("g").unwrap_or(ANY_GRAVITY), self.values.term(&stage.restitution).ok()?);
        self.by(Procedure::Integrated);
        for bounce in first + 1..=NUMBERED {
            match self.bounce(rise, gravity, e) {
                Ok((_, next)) => rise = next,
                Err(reason) => return Some(Err(reason)),
            }
            self.note(&format!("h_{bounce}"), rise, 0.0);
        }
        Some(Ok(()))
    }

    /// What one bounce changes, by the speeds towards the floor before it and away from the floor after it.
    fn note_bounce(&mut self, stage: &Bounces, (number, is_counted): (u32, bool), [before, after]: [f64; 2]) {
        let Ok(mass) = self.values.mass(&stage.body) else { return };
        let (impulse, loss) = (mass * (before + after), mass * (before * before - after * after) / 2.0);
        let numbered = (number <= NUMBERED).then(|| number.to_string());
        for which in numbered.into_iter().chain(is_counted.then(|| "n".to_owned())) {
            self.note(&format!("J_{which}"), impulse, 0.0);
            self.note(&format!("T_lost_{which}"), loss, mass * before * before);
        }
        if number == 1 {
            self.note_here("T_lost", mass * before * before / 2.0, 0.0);
        }
    }

    /// From one height to the floor, and up to the next; the speed on the floor, and that height.
    fn bounce(&self, from: f64, gravity: f64, e: f64) -> Result<(f64, f64), NothingToSimulate> {
        let integrator = Integrator { tolerance: self.tolerance, longest: 8.0 * libm::sqrt(from / gravity) };
        let slope = |_: f64, state: &[f64; 2]| [state[1], -gravity];
        let (time, down) = integrator.event(0.0, [from, 0.0], &slope, &|_, state| state[0])?;
        let (_, top) = integrator.event(time, [0.0, -e * down[1]], &slope, &|_, state| state[1])?;
        Ok((-down[1], top[0]))
    }

    /// What each of the first bounces changes. As it flies, the body comes back with the speed with which it left.
    fn first_bounces(&mut self, stage: &Bounces) {
        let Some(e) = self.values.term(&stage.restitution).ok().filter(|e| *e > 0.0) else { return };
        let count = self.values.bounces_counted(stage);
        let mut before = None;
        for number in 1..=NUMBERED {
            let Ok(bounce) = self.values.bounce(stage, f64::from(number)) else { return };
            let arrives = before.unwrap_or(bounce.leaves / e);
            let is_counted = count.is_some_and(|count| (count - f64::from(number)).abs() < 0.5);
            self.note_bounce(stage, (number, is_counted), [arrives, bounce.leaves]);
            before = Some(bounce.leaves);
        }
    }

    /// The flight that follows the n-th bounce: how high it goes, how long it lasts, and how far.
    fn between_bounces(&mut self, stage: &Bounces) -> Result<(), NothingToSimulate> {
        self.first_bounces(stage);
        let Some(count) = self.values.bounces_counted(stage) else { return Ok(()) };
        let (before, after) = (self.values.bounce(stage, count)?, self.values.bounce(stage, count + 1.0)?);
        let flight = after.time - before.time;
        self.note("dt_n", flight, after.time);
        if let [from, to] = [&before, &after].map(|bounce| bounce.along)
            && let (Some(from), Some(to)) = (from, to)
        {
            self.note("range_n", to - from, size([from, to, 0.0]));
        }
        let slope = |_: f64, state: &[f64; 2]| [state[1], -before.press];
        let integrator = Integrator { tolerance: self.tolerance, longest: flight };
        let (_, top) = integrator.event(0.0, [0.0, before.leaves], &slope, &|_, state| state[1])?;
        self.note("h_n", top[0], 0.0);
        Ok(())
    }
}
