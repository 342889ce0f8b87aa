//! The author's hints, one by one.

use serde::Deserialize;
use serde::Serialize;

use momentous_render::Fragment;

use super::super::Exercise;
use super::Engine;
use super::refused::{Refused, RefusedKind};
use super::variant::VariantRequest;

/// Asks for a hint.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct HintRequest {
    /// The variant.
    #[serde(flatten)]
    pub variant: VariantRequest,
    /// Which hint, counted from 1.
    pub number: usize,
}

/// A hint.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HintResponse {
    /// Its text.
    pub hint: Fragment,
    /// Whether there are more.
    pub more: bool,
}

impl Engine<'_> {
    /// One of the author's hints.
    ///
    /// # Errors
    /// As for a sheet, and where there is no such hint.
    pub fn hint(&self, request: &HintRequest) -> Result<HintResponse, Refused> {
        HintResponse::of(&self.draw(&request.variant)?, request.number)
    }
}

impl HintResponse {
    /// A hint of a variant that was drawn, counted from 1.
    ///
    /// # Errors
    /// Where there is no such hint, or its text is not fit to print.
    pub fn of(exercise: &Exercise, number: usize) -> Result<Self, Refused> {
        let hints = exercise.variant().hints(exercise.problem());
        let Some(text) = number.checked_sub(1).and_then(|place| hints.get(place)) else {
            let message = format!("there is no hint {number}");
            return Err(Refused::new(RefusedKind::Unknown, message).help(format!("there are {}", hints.len())));
        };
        let name = format!("{}: hint {number}", exercise.problem().id());
        let hint = Fragment::authored(&name, text, 3).map_err(|faults| Refused::fault(&faults))?;
        Ok(Self { hint, more: number < hints.len() })
    }
}
