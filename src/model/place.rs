//! Where bodies are: what moves them, and what happens too quickly to.

use crate::expr::Expr;
use crate::scene::Axis;
use crate::scene::Stage;

use super::Builder;
use super::Meaning;
use super::Name;
use super::QuantityKind;

impl Builder<'_> {
    /// A component of the place of a body at an instant, under the name of the instant since which it is there.
    pub(super) fn place(&mut self, body: &str, instant: usize, axis: Axis) -> Expr {
        let (body, instant) = self.place_since(body, instant);
        let (owner, when) = (self.called(&body), self.when(instant));
        let name = Name::of(QuantityKind::Position, &body).at(instant).along(self.letter(axis));
        let meaning = Meaning { noun: "the position", of: format!("of {owner} {when}") };
        self.component(name, meaning).into()
    }

    /// Whose place, and since when, a body has at an instant. Impacts and separations take no time, a part starts where the
    /// whole was, and in the flight of others a body's own clock stands still.
    pub(super) fn place_since(&self, body: &str, instant: usize) -> (String, usize) {
        let Some(index) = instant.checked_sub(2).filter(|_| !self.axes.is_empty()) else {
            return (body.to_owned(), instant);
        };
        let stays = match self.scene.stages.get(index) {
            Some(Stage::Impact(impact)) => {
                if impact.becomes.as_deref() == Some(body)
                    && let Some([first, _]) = &impact.between
                {
                    return self.place_since(first, instant - 1);
                }
                true
            }
            Some(Stage::Separate(separate)) => {
                if separate.into.iter().any(|part| part == body)
                    && let Some(whole) = &separate.from
                {
                    return self.place_since(whole, instant - 1);
                }
                true
            }
            Some(Stage::Blow(_) | Stage::Stream(_) | Stage::Strike(_)) => true,
            Some(Stage::Flight(flight)) => !flight.flying().any(|own| own == body),
            Some(Stage::Fall(fall)) => fall.body != body,
            _ => false,
        };
        if stays { self.place_since(body, instant - 1) } else { (body.to_owned(), instant) }
    }
}
