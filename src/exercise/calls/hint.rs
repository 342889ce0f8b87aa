//! The author's hints, one by one.

use serde::Deserialize;
use serde::Serialize;

use crate::render::Fragment;

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
    /// What it says.
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
        let exercise = request.variant.draw(self)?;
        let hints = exercise.student_sheet().hints;
        let number = request.number;
        let Some(text) = number.checked_sub(1).and_then(|place| hints.get(place)) else {
            let message = format!("there is no hint {number}");
            return Err(Refused::new(RefusedKind::Unknown, message).help(format!("there are {}", hints.len())));
        };
        let name = format!("{}: hint {number}", exercise.problem().id());
        let hint = Fragment::authored(&name, text, 3).map_err(|faults| Refused::fault(&faults))?;
        Ok(HintResponse { hint, more: number < hints.len() })
    }
}
