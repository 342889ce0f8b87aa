//! A scene simulated, for whoever wants to watch it.

use serde::Deserialize;
use serde::Serialize;
use serde_json::Value;

use momentous_simulate::MethodKind;
use momentous_simulate::least::Request;
use momentous_witness::{Shot, shoot};

use super::super::Exercise;
use super::Engine;
use super::refused::{Refused, RefusedKind};
use super::variant::VariantRequest;

/// Asks for a simulation.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct SimulateRequest {
    /// The variant.
    #[serde(flatten)]
    pub variant: VariantRequest,
    /// The name of a method, as `momentous simulate --method` has it; the cheapest that serves where none is named.
    #[serde(default)]
    pub method: Option<String>,
    /// The greatest relative error.
    #[serde(default)]
    pub accuracy: Option<f64>,
    /// Shots of a variant: what was simulated axis by axis or body by body as one motion, for whoever draws it.
    #[serde(default)]
    pub together: bool,
}

impl Engine<'_> {
    /// All that can be simulated of a variant: the object that `momentous simulate --format json` writes.
    ///
    /// # Errors
    /// As for a solution, and where nothing can be simulated so.
    pub fn simulate(&self, request: &SimulateRequest) -> Result<Value, Refused> {
        let method = match &request.method {
            None => None,
            Some(name) => Some(MethodKind::named(name).map_err(|message| Refused::new(RefusedKind::Unknown, message))?),
        };
        if request.accuracy.is_some_and(|accuracy| !(accuracy > 0.0 && accuracy < 1.0)) {
            return Err(Refused::new(RefusedKind::Invalid, "an accuracy is a number between 0 and 1, such as 1e-6"));
        }
        let exercise = self.draw(&request.variant)?;
        let steps = Some(self.limits.scene_steps);
        let shot = shot(&exercise, &Request { accuracy: request.accuracy, budget: None, method, steps })?;
        let shot = if request.together { shot.together() } else { shot };
        Ok(shot.record(exercise.problem(), exercise.variant()))
    }
}

/// Shoots the simulation of a variant.
pub(super) fn shot(exercise: &Exercise, wanted: &Request) -> Result<Shot, Refused> {
    shoot(exercise.problem(), exercise.variant(), wanted).map_err(|reason| {
        // Its help is about the command line.
        let prefix = format!("{}: ", exercise.problem().id());
        let message = reason.what.strip_prefix(&prefix).unwrap_or(&reason.what);
        Refused::new(RefusedKind::NotSimulated, message)
    })
}
