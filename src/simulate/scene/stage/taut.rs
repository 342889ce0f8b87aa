//! A string that goes taut: a stiff cord that stretches until its ends move as one.

use momentous_scene::stage::Taut;

use crate::scene::nothing::NothingToSimulate;
use crate::scene::stage_run::StageRun;
use crate::scene::touch::Touch;
use crate::scene::vector::unit;

impl StageRun<'_> {
    pub(super) fn taut(&mut self, stage: &Taut) -> Result<(), NothingToSimulate> {
        let [behind, ahead] = [stage.between[0].as_str(), stage.between[1].as_str()];
        let along = match (&stage.along, &self.values.axes()[..]) {
            (Some(term), _) => self.values.direction(&term.0)?,
            (None, [only]) => unit(*only),
            _ => return Err(NothingToSimulate::Unread),
        };
        // The cord pulls the body ahead back, as a body in its way would push it.
        let parties = [self.values.particle(ahead)?, self.values.particle(behind)?];
        let parted = Touch { parties, normal: along, restitution: 0.0 }.watched(self)?;
        self.note_velocities(&parted.bodies);
        self.note_pushed(&parted.bodies, stage.duration.as_ref());
        Ok(())
    }
}
