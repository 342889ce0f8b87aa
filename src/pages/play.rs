//! A scene played: the animation asks for its record by itself; what the page says beside it stands here.

use serde::Serialize;

use momentous_exercise::calls::{PlayResponse, Refused, RefusedKind, SheetResponse};

use super::parameters::Parameters;
use super::place::Place;
use super::view::View;

#[derive(Serialize)]
struct PlayPage {
    title: String,
    place: Place,
    sheet: SheetResponse,
    played: Option<PlayResponse>,
    /// Why nothing is played, as sentences.
    refused: Option<Vec<String>>,
}

/// The scene of a variant, as an animation with plots.
pub(super) fn play(view: &View<'_>, problem: String, fields: &Parameters) -> Result<String, Refused> {
    let variant = fields.variant(problem)?;
    let exercise = view.engine().draw(&variant)?;
    let sheet = SheetResponse::of(&exercise)?;
    let (played, refused) = match PlayResponse::of(&exercise, &view.pages.limits) {
        Ok(played) => (Some(played), None),
        // Why there is nothing to play is part of the page.
        Err(refused) if refused.kind == RefusedKind::NotSimulated => (None, Some(refused.sentences())),
        Err(refused) => return Err(refused),
    };
    view.page(
        "play",
        &PlayPage { title: sheet.title.clone(), place: Place::of(&exercise, &variant)?, sheet, played, refused },
    )
}
