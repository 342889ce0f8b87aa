//! A string that goes taut: a stiff cord that stretches until its ends move as one.

use crate::scene::stage::Taut;

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::touch::Touch;
use crate::simulate::scene::vector::{Vector, across, dot, unit};

impl Bench<'_> {
    pub(super) fn taut(&mut self, stage: &Taut) -> Result<(), NothingToSimulate> {
        let [behind, ahead] = [stage.between[0].as_str(), stage.between[1].as_str()];
        let along = match (&stage.along, &self.values.axes()[..]) {
            (Some(term), _) => self.values.direction(&term.0)?,
            (None, [only]) => unit(*only),
            _ => return Err(NothingToSimulate::Unread),
        };
        // The cord pulls the body ahead back, as a body in its way would push it.
        let parties = [self.party(ahead)?, self.party(behind)?];
        let touch = Touch { parties, normal: along, restitution: 0.0 };
        let parted = touch.watched(self)?;
        let scale = dot(parties[0].velocity, parties[0].velocity) + dot(parties[1].velocity, parties[1].velocity);
        let each = [ahead, behind].into_iter().zip(parted.velocities).zip(parted.impulses).zip(parties);
        for (((body, velocity), impulse), party) in each {
            self.note_velocity(body, velocity, libm::sqrt(scale));
            self.note_impulse(body, impulse, stage.duration.as_ref());
            if let Some(along) = party.guide {
                let reaction = parted.reactions[usize::from(body == behind)];
                self.note_here(&format!("R_{body}"), dot(across(along), reaction), 0.0);
            }
        }
        let masses = parties.map(|party| party.mass.unwrap_or(0.0));
        let carriers = |velocities: [Vector; 2]| [(masses[0], velocities[0]), (masses[1], velocities[1])];
        self.note_energy(&carriers(parties.map(|party| party.velocity)), &carriers(parted.velocities));
        Ok(())
    }
}
