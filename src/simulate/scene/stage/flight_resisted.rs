//! A flight against a resistance, integrated in time.

use momentous_scene::stage::{Flight, Resistance};

use crate::scene::course::Until;
use crate::scene::integrate::Integrator;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{Vector, add, less, part, size, unit};

use super::flight::{SOON, placed};

/// A function that changes its sign where a flight ends.
type Signed<'a> = Box<dyn Fn(&[f64; 6]) -> f64 + 'a>;

impl StageRun<'_> {
    /// A body whose places may be unknown, until its flight ends.
    pub(super) fn fly_resisted(
        &mut self,
        body: &Particle<'_>,
        resistance: &Resistance,
        stage: &Flight,
    ) -> Result<(), NothingToSimulate> {
        let Resistance::Linear(term) = resistance else { return Err(NothingToSimulate::NoMethod) };
        let (linear, axes) = (self.values.term(term)?, self.values.axes());
        let starts = body.or_nought();
        let forces = axes.iter().map(|axis| Force::resistance(0, unit(*axis), [linear, 0.0])).collect();
        let mut system = System::<6> { forces, ..System::new(self.values.frame(), vec![starts]) };
        self.note_terminal(&system, resistance)?;
        let weight = libm::sqrt(size(body.falls));
        let quick = 1.0 / (size(body.velocity) + weight).max(f64::MIN_POSITIVE);
        let integrator = self.integrator(quick.min(self.values.mass(body.name)? / linear) / 8.0);
        // What is not known of where it starts is not known of where it is, either.
        let now = |state: &[f64; 6]| Particle { place: add(body.place, displaced(state, &starts)), ..*body };
        let signed: Signed<'_> = match stage.until.as_ref().map(|term| term.0.trim()) {
            None => Box::new(|_| 1.0),
            Some("top") => {
                let up = axes.iter().rfind(|axis| part(body.falls, **axis) != 0.0);
                let up = *up.ok_or(NothingToSimulate::NothingChanges)?;
                Box::new(move |state| part(velocity(state, 0), up))
            }
            Some(text) => {
                let (apart, axes) = (self.equation(&[*body], text)?, axes.clone());
                Box::new(move |state| {
                    let places = placed(&axes, &[now(state)], 0.0).into_iter().map(|(_, _, place)| place);
                    apart(&places.collect::<Vec<_>>())
                })
            }
        };
        // A film shows the passage that the laws found, of several of one place.
        let shown = self.motions.as_ref().and_then(|_| self.values.duration().ok());
        let end = if let Some(time) = shown {
            self.go(&system, integrator, &Until::Time(time))?
        } else if stage.until.is_none() {
            let during = stage.during.as_ref();
            let time = during.map_or_else(|| self.values.duration(), |term| self.values.term(term))?;
            self.go(&system, integrator, &Until::Time(time))?
        } else {
            if signed(&system.state()) == 0.0 {
                // A moment later it is on the side from which it comes back.
                self.go_on_for_a_moment(&mut system, integrator)?;
            }
            let mut side = signed(&system.state()).signum();
            for _ in 0..self.crossing {
                let passed = self.go(&system, integrator, &Until::Event(&|state| signed(state) * side))?;
                system.go_on_from(&passed);
                self.go_on_for_a_moment(&mut system, integrator)?;
                side = -side;
            }
            self.go(&system, integrator, &Until::Event(&|state| signed(state) * side))?
        };
        let moved = displaced(&end.state, &starts);
        self.note_velocity(body.name, velocity(&end.state, 0), size(body.velocity));
        for axis in axes {
            let from = part(body.place, axis);
            if !from.is_nan() {
                let name = self.values.place_name(body.name, self.values.index + 2, axis);
                self.note(&name, from + part(moved, axis), from.abs().max(size(moved)));
            }
        }
        self.note_duration(stage.during.as_ref(), end.time);
        Ok(())
    }

    /// Lets a body go on until it has left the place where it is.
    fn go_on_for_a_moment(
        &mut self,
        system: &mut System<'_, 6>,
        integrator: Integrator,
    ) -> Result<(), NothingToSimulate> {
        let soon = self.go(system, integrator, &Until::Time(system.start + SOON))?;
        system.go_on_from(&soon);
        Ok(())
    }
}

/// How far it is from where it started.
fn displaced(state: &[f64; 6], starts: &Particle<'_>) -> Vector {
    less(place(state, 0), starts.place)
}
