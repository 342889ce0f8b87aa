//! Strings that go taut: stiff cords that stretch until their ends move as one.

use momentous_scene::Term;
use momentous_scene::stage::JerkedString;
use momentous_scene::stage::Taut;

use crate::scene::course::Until;
use crate::scene::integrate::Integrator;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Lines, Particle, velocity};
use crate::scene::pushed::Pushed;
use crate::scene::stage_run::{Procedure, StageRun};
use crate::scene::system::System;
use crate::scene::touch::Touch;
use crate::scene::vector::{Vector, add, dot, size, times, unit};

/// Bodies that may be jerked at once.
const MOST_BODIES: usize = 8;

/// Strings that may be jerked at once.
const MOST_STRINGS: usize = 12;

/// Places and velocities of the bodies, and the impulse of each string.
const ROOM: usize = 6 * MOST_BODIES + MOST_STRINGS;

/// The share of the speeds below which nothing is stretched any more.
const STILL: f64 = 1e-13;

/// The longest step beside the time in which a cord gives way: well below that at which the fastest of several would be unstable.
const LONGEST: f64 = 0.4;

impl StageRun<'_> {
    pub(super) fn taut(&mut self, stage: &Taut) -> Result<(), NothingToSimulate> {
        let Some(between) = &stage.between else { return self.jerked_together(stage) };
        let [behind, ahead] = between.each_ref().map(String::as_str);
        let along = self.along_string(stage.along.as_ref())?;
        // The cord pulls the body ahead back, as a body in its way would push it.
        let parties = [self.values.particle(ahead)?, self.values.particle(behind)?];
        let parted = Touch { parties, normal: along, restitution: 0.0 }.watched(self)?;
        self.note_velocities(&parted.bodies);
        self.note_pushed(&parted.bodies, stage.duration.as_ref());
        Ok(())
    }

    /// Several cords, each of which gives way against a pull in proportion to how fast it is stretched, until none is.
    fn jerked_together(&mut self, stage: &Taut) -> Result<(), NothingToSimulate> {
        let names = stage.jerked();
        if names.len() > MOST_BODIES || stage.strings.len() > MOST_STRINGS {
            return Err(NothingToSimulate::NoMethod);
        }
        let bodies: Vec<Particle<'_>> =
            names.iter().map(|body| self.values.particle(body)).collect::<Result<_, _>>()?;
        let lines: Vec<Lines> =
            stage.strings.iter().map(|string| self.stretching(string, &names)).collect::<Result<_, _>>()?;
        let fastest = bodies.iter().map(|body| size(body.velocity)).fold(0.0, f64::max);
        let mut system = System::<ROOM>::new(self.values.frame(), bodies.clone());
        // Each string by itself would take about a second.
        let reduced = |line: &Lines| {
            1.0 / line.iter().map(|(index, _)| bodies[*index].mass.map_or(0.0, |mass| 1.0 / mass)).sum::<f64>()
        };
        let cord = |line: &Lines| Force::damper(line.clone(), reduced(line) * self.shorter);
        system.forces = lines.iter().map(cord).collect();
        let stretches = |state: &[f64; ROOM], line: &Lines| {
            line.iter().map(|(index, along)| dot(*along, velocity(state, *index))).sum::<f64>()
        };
        let left = |state: &[f64; ROOM]| {
            let most = lines.iter().map(|line| stretches(state, line).abs()).fold(0.0, f64::max);
            most - STILL * fastest
        };
        if left(&system.state()) <= 0.0 {
            return Err(NothingToSimulate::NothingChanges);
        }
        self.by(Procedure::Contact);
        let integrator = Integrator { tolerance: self.tolerance, longest: LONGEST / self.shorter };
        // The cords give way ever more slowly, so that the instant of the last stretch is known to few figures: a whole number of
        // seconds after it is the same however finely it is found.
        let last = self.try_out(&system, integrator, &Until::Event(&left))?.time;
        let end = self.go(&system, integrator, &Until::Time((last * self.shorter).ceil() / self.shorter))?;
        self.remark("The duration of the jerk is not given: it is drawn as seconds. Each position is measured from where the jerk begins.");
        let impulses: Vec<f64> = (0..lines.len()).map(|line| end.state[6 * names.len() + line]).collect();
        for (string, impulse) in stage.strings.iter().zip(&impulses) {
            self.note_here(&format!("J_{}", string.ends().concat()), -impulse, 0.0);
        }
        let on = |particle: usize| {
            let pulls = lines.iter().zip(&impulses).flat_map(|(line, impulse)| {
                line.iter().filter(|(body, _)| *body == particle).map(|(_, along)| times(*impulse, *along))
            });
            pulls.fold([0.0; 3], add)
        };
        let pushed: Vec<Pushed<'_>> = (bodies.iter().enumerate())
            .map(|(index, body)| Pushed {
                after: velocity(&end.state, index),
                impulse: on(index),
                ..Pushed::new(*body)
            })
            .collect();
        self.note_velocities(&pushed);
        self.note_pushed(&pushed, stage.duration.as_ref());
        Ok(())
    }

    /// How much faster a string is stretched for each metre per second of its ends.
    fn stretching(&self, string: &JerkedString, names: &[&str]) -> Result<Lines, NothingToSimulate> {
        let along = self.along_string(string.along.as_ref())?;
        let place = |body: &str| names.iter().position(|other| *other == body).ok_or(NothingToSimulate::Unread);
        let [behind, ahead] = string.ends();
        Ok(vec![(place(ahead)?, along), (place(behind)?, times(-1.0, along))])
    }

    /// The direction of a string, from its first body to its second.
    fn along_string(&self, along: Option<&Term>) -> Result<Vector, NothingToSimulate> {
        match (along, &self.values.axes()[..]) {
            (Some(term), _) => self.values.direction(&term.0),
            (None, [only]) => Ok(unit(*only)),
            _ => Err(NothingToSimulate::Unread),
        }
    }
}
