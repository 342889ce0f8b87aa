//! Readings of an answer, before anybody judges it.

use serde::Deserialize;
use serde::Serialize;

use momentous_grade::DecimalMark;
use momentous_render::Fragment;

use super::super::Exercise;
use super::Engine;
use super::refused::{Refused, RefusedKind};
use super::variant::VariantRequest;

/// Asks how an answer is read.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct ReadRequest {
    /// The variant.
    #[serde(flatten)]
    pub variant: VariantRequest,
    /// The part.
    pub part: String,
    /// The typed text.
    pub text: String,
    /// The sign between whole and decimal digits.
    #[serde(default)]
    pub decimal: DecimalMark,
}

/// How an answer is read. It says nothing of the right answer.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct ReadResponse {
    /// The reading, in words.
    pub understood: Option<String>,
    /// Why nothing was.
    pub unreadable: Option<String>,
    /// A formula that was understood, as mathematics.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub math: Option<Fragment>,
}

impl Engine<'_> {
    /// How an answer to a part is read.
    ///
    /// # Errors
    /// As for a sheet, and where the part is not asked.
    pub fn read(&self, request: &ReadRequest) -> Result<ReadResponse, Refused> {
        ReadResponse::of(&self.draw(&request.variant)?, &request.part, &request.text, request.decimal)
    }
}

impl ReadResponse {
    /// How an answer to a part of a variant that was drawn is read.
    ///
    /// # Errors
    /// Where the part is not asked.
    pub fn of(exercise: &Exercise, part: &str, text: &str, decimal: DecimalMark) -> Result<Self, Refused> {
        let part = exercise
            .part(part)
            .ok_or_else(|| Refused::new(RefusedKind::Unknown, format!("`{part}` is not asked for here")))?;
        Ok(match exercise.echo(part, text, decimal) {
            None => Self::default(),
            Some(Ok(understood)) => Self {
                understood: Some(understood),
                unreadable: None,
                math: exercise.typeset(part, text, decimal).as_ref().map(Fragment::math),
            },
            Some(Err(why)) => Self { understood: None, unreadable: Some(why), math: None },
        })
    }
}
