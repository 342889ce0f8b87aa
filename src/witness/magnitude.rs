//! The magnitude of a vector of which a simulation finds the components.

use momentous_model::VectorName;
use momentous_model::component_name;

use super::simulation::Measurement;
use super::simulation::Witness;

impl Witness<'_> {
    /// The magnitude of a vector by what is found of its components.
    pub(super) fn magnitude(&self, name: &str) -> Option<Measurement> {
        let Some(VectorName::Magnitude(vector)) = VectorName::parse(name) else { return None };
        let parts: Vec<Measurement> = match &self.scene().axes.rectangular()[..] {
            [_] => vec![self.seen(vector)?],
            axes => {
                let parts = axes.iter().map(|(axis, _)| self.seen(&component_name(vector, axis.letter())));
                parts.collect::<Option<_>>()?
            }
        };
        let value = libm::sqrt(parts.iter().map(|part| part.value * part.value).sum());
        Some(Measurement { value, error: parts.iter().map(|part| part.error).sum() })
    }
}
