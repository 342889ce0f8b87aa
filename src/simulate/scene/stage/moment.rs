//! A moment about a point: a couple pushes two particles, which stand for all that turns, along tracks on both sides of it.

use momentous_scene::stage::{During, Moment};
use momentous_scene::{Axis, Strength};

use crate::scene::component::Frame;
use crate::scene::course::Until;
use crate::scene::in_time::InTime;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{ZERO, part, times, unit};

/// Half the distance of the tracks, in m.
const ARM: f64 = 0.5;

/// The mass of each particle, in kg, where no moment of inertia is told.
const MASS: f64 = 1.0;

impl StageRun<'_> {
    pub(super) fn moment(&mut self, stage: &Moment) -> Result<(), NothingToSimulate> {
        let [start, end] = self.during(Some(&stage.during))?;
        let turnings: Vec<(String, InTime, Vec<f64>)> = match &stage.value {
            Strength::Components(components) => {
                let each = [Axis::X, Axis::Y, Axis::Z].into_iter().map(|axis| {
                    let moment = match components.get(axis) {
                        Some(term) => InTime::always(self.values.law(term)?),
                        None => InTime::steady(0.0),
                    };
                    Ok((format!(".{}", axis.letter()), moment, Vec::new()))
                });
                each.collect::<Result<_, _>>()?
            }
            value => {
                let (moment, changes) = self.values.strength(value)?;
                vec![(String::new(), moment, changes)]
            }
        };
        let rotors: Vec<String> = self.values.scene.rotors().map(str::to_owned).collect();
        let mut inertia = 0.0;
        for rotor in &rotors {
            inertia += self.values.inertia(Some(rotor))?;
        }
        let mass = if inertia > 0.0 { inertia / (2.0 * ARM * ARM) } else { MASS };
        for (letter, moment, changes) in turnings {
            // Each particle feels one force of the couple.
            let pair = Force::in_time(vec![(0, times(1.0 / (2.0 * ARM), unit(Axis::X)))], moment);
            let mut system = System::<6>::new(Frame::line("s"), vec![Particle::free("", mass, ZERO)]);
            (system.forces, system.changes, system.start) = (vec![pair], changes, start);
            let integrator = self.integrator((end - start) / 4.0);
            let pushed = self.try_out(&system, integrator, &Until::Time(end))?;
            let faster = part(velocity(&pushed.state, 0), Axis::X) / ARM;
            let gained = 2.0 * ARM * ARM * mass * faster;
            self.note_angular_impulse(&letter, gained, 0.0);
            let first = self.values.index + 1;
            if inertia > 0.0 {
                let about = |missing| {
                    Ok(self.values.named(&format!("H_{}{first}", stage.about)).map_err(|_| missing)? / inertia)
                };
                let turning = self.values.named(&format!("omega_{first}")).or_else(about)?;
                let ends = [turning, turning + faster];
                for (instant, rate) in (first..).zip(ends) {
                    self.note(&format!("omega_{instant}"), rate, turning);
                    self.note(&format!("H_{}{instant}", stage.about), inertia * rate, inertia * turning);
                    self.note(&format!("T_{instant}"), inertia * rate * rate / 2.0, 0.0);
                }
                let [start, end] = ends.map(|rate| [(inertia / (ARM * ARM), times(ARM * rate, unit(Axis::X)))]);
                self.note_energy(&start, &end);
                continue;
            }
            let [before, after] =
                [1, 2].map(|offset| format!("H_{}{}{letter}", stage.about, self.values.index + offset));
            if let Ok(before) = self.values.named(&before) {
                self.note(&after, before + gained, before);
            }
        }
        let term = match &stage.during {
            During::For(term) => Some(term),
            During::Between(_) => None,
        };
        self.note_duration(term, end - start);
        Ok(())
    }
}
