//! The exchange of a stage with all bodies together, by what they have at its ends.

use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_scene::Stage;

use super::simulation::Measurement;
use super::simulation::Witness;

impl Witness<'_> {
    /// The kinetic energy gained or lost in a stage that was simulated; the work of all forces is what is gained.
    pub(super) fn exchanged(&self, name: &str) -> Option<Measurement> {
        let name = Name::parse(name).filter(|name| name.subject.is_empty() && name.instant.is_none())?;
        let sign = match name.kind {
            QuantityKind::EnergyGained | QuantityKind::Work => 1.0,
            QuantityKind::EnergyLost => -1.0,
            _ => return None,
        };
        let stage = self.stage_of(name.stage.as_deref()).filter(|stage| self.has_run(*stage))?;
        // What a stream loses is in the stream.
        if matches!(self.scene().stages.get(stage), Some(Stage::Stream(_))) {
            return None;
        }
        let [start, end] = [stage + 1, stage + 2].map(|instant| format!("T_{instant}"));
        let after = self.seen(&end)?;
        let before = self.seen(&start).or_else(|| self.started_with(&start))?;
        Some(Measurement { value: sign * (after.value - before.value), error: before.error + after.error })
    }
}
