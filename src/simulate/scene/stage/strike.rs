//! A body that strikes an arm: a contact that lasts, between the body and the place of the arm that it meets.

use momentous_scene::stage::Strike;

use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::Particle;
use crate::scene::stage_run::StageRun;
use crate::scene::touch::Touch;
use crate::scene::vector::{dot, times, unit};

impl StageRun<'_> {
    pub(super) fn strike(&mut self, stage: &Strike) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let (body, first, along) = (stage.body.as_str(), self.values.index + 1, unit(axis));
        let distance = self.values.term(&stage.at)?;
        let mut carried = Vec::new();
        for (name, term) in &stage.carries {
            carried.push((name.as_str(), self.values.mass(name)?, self.values.term(term)?));
        }
        let turning = self.values.named(&format!("omega_{first}")).or_else(|missing| {
            let (name, _, arm) = *carried.first().ok_or(missing)?;
            Ok(self.values.velocity_before(name, axis)? / arm)
        })?;
        // By the lever, a particle at another distance from the pivot resists a push at the place that is struck with the
        // square of the ratio of the distances.
        let inertia = self.values.inertia(stage.rotor.as_ref())?;
        let resists = inertia / (distance * distance)
            + carried.iter().map(|(_, mass, arm)| mass * (arm / distance) * (arm / distance)).sum::<f64>();
        let mass = self.values.mass(body)?;
        let speed = self.values.velocity_before(body, axis)?;
        let meets = speed - turning * distance;
        let struck = Particle::free("arm", resists, times(turning * distance, along));
        let parties = [Particle::free(body, mass, times(speed, along)), struck];
        let restitution = match (&stage.restitution, stage.plastic) {
            (Some(term), _) => self.values.term(term)?,
            (None, true) => 0.0,
            // The impulse up to the greatest deformation is the reduced mass times the velocity at which they meet.
            (None, false) => {
                let told = self.values.named(&format!("I_M{}", self.values.suffix()));
                let impulse = told.map_err(|_| NothingToSimulate::NoRestitution)? / distance;
                let restitution = impulse * (1.0 / mass + 1.0 / resists) / meets - 1.0;
                Some(restitution)
                    .filter(|coefficient| (0.0..=1.0).contains(coefficient))
                    .ok_or(NothingToSimulate::NoRestitution)?
            }
        };
        let sense = meets.signum();
        let touch = Touch { parties, normal: times(sense, along), restitution };
        let parted = touch.watched(self)?;
        self.lever(distance.abs());
        self.remark(
            "The arm is shown as the point that is struck, with its effective mass there; its momentum is the angular momentum divided by the distance.",
        );
        let [after, struck] = parted.bodies.map(|body| dot(body.after, along));
        let (mut ends, fast) = ([Vec::new(), Vec::new()], speed.abs() + (turning * distance).abs());
        for (side, (speed_here, turning)) in [(speed, turning), (after, struck / distance)].into_iter().enumerate() {
            let mut moment = mass * distance * speed_here;
            let mut size = moment.abs();
            ends[side].push((mass, times(speed_here, along)));
            // What turns has the energy of its effective mass at the place that is struck.
            ends[side].push((inertia / (distance * distance), times(turning * distance, along)));
            moment += inertia * turning;
            size += (inertia * turning).abs();
            for (name, mass, arm) in &carried {
                let velocity = times(arm * turning, along);
                let name =
                    if side == 0 { self.values.start_name(name, axis) } else { self.values.velocity_after(name, axis) };
                self.note(&name, arm * turning, fast);
                ends[side].push((*mass, velocity));
                moment += mass * arm * arm * turning;
                size += (mass * arm * arm * turning).abs();
            }
            self.note(&format!("H_{}{}", stage.about, first + side), moment, size);
            self.note(&format!("omega_{}", first + side), turning, fast / distance);
        }
        self.note_angular_impulse("", resists * distance * (struck - turning * distance), resists * distance * fast);
        self.note_velocity(body, times(after, along), fast);
        self.note_energy(&ends[0], &ends[1]);
        Ok(())
    }
}
