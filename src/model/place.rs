//! Places of bodies: what moves them, and what happens too quickly to.

use momentous_expr::Expr;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_scene::stage::Impact;
use momentous_scene::stage::Separate;

use super::Builder;
use super::Name;
use super::QuantityKind;
use super::name::Meaning;
use super::stage::Description;

impl Builder<'_> {
    /// A component of the place of a body at an instant, under the name of the instant since which it is there.
    pub(super) fn place(&mut self, body: &str, instant: usize, axis: Axis) -> Expr {
        self.has_not_fallen(body, instant);
        let (body, instant) = self.place_since(body, instant);
        let (owner, when) = (self.called(&body), self.when(instant));
        let name = Name::of(QuantityKind::Position, &body).at(instant).along(self.letter(axis));
        let meaning = Meaning { noun: "the position", of: format!("of {owner} {when}") };
        self.component(name, meaning).into()
    }

    /// Whose place, and since when, a body has at an instant. Impacts and sudden separations take no time, a part starts where
    /// the whole was, and in the flight of others a body's own clock stands still.
    pub(super) fn place_since(&self, body: &str, instant: usize) -> (String, usize) {
        if self.axes.is_empty() {
            return (body.to_owned(), self.distance_since(body, instant));
        }
        let Some(index) = instant.checked_sub(2) else { return (body.to_owned(), instant) };
        let stage = self.scene.stages.get(index);
        if let Some(Stage::Impact(Impact { becomes: Some(union), between: Some([first, _]), .. })) = stage
            && union == body
        {
            return self.place_since(first, instant - 1);
        }
        if let Some(Stage::Separate(Separate { from: Some(whole), into, force: None, .. })) = stage
            && into.iter().any(|part| part == body)
        {
            return self.place_since(whole, instant - 1);
        }
        let stays = stage.is_some_and(|stage| Description::of(self.scene, stage).leaves(body));
        if stays { self.place_since(body, instant - 1) } else { (body.to_owned(), instant) }
    }

    /// Since when a body has been at its distance from a centre: a blow takes no time.
    pub(super) fn distance_since(&self, body: &str, instant: usize) -> usize {
        let since = self.timeline.naming_instant(body, instant);
        let before = since.checked_sub(2).and_then(|index| self.scene.stages.get(index));
        let struck = before.is_some_and(|stage| matches!(stage, Stage::Blow(blow) if blow.body == body));
        if struck { self.distance_since(body, since - 1) } else { since }
    }
}
