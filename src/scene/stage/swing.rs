//! A swing on a cord.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::Halt;

/// A body on a light cord swings freely between its lowest point and another point, or between two points; or it slides so on the
/// inside of a smooth circular track. Needs a vertical plane.
///
/// Without `from` it starts at its lowest point. Without `to` it ends at its lowest point if it has `from`, and otherwise
/// where it comes to rest.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Swing {
    /// A name for the stage, used in brackets: `h_C[up]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// What the cord is fixed to, where that is a body that gives way along the level axis: a cart on a track.
    #[serde(default)]
    pub on: Option<String>,
    /// The length of the cord, from the fixed end to the body. Default: none; only heights are then used.
    #[serde(default)]
    pub length: Option<Term>,
    /// The radius of a smooth circular track on whose inside the body slides, in place of a cord. Angles are then those between its
    /// radius and the vertical.
    #[serde(default)]
    pub radius: Option<Term>,
    /// The height between the two ends of the swing. Default: `h_` and the body's short name.
    #[serde(default)]
    pub height: Option<Term>,
    /// The angle between the cord and the vertical at the start.
    #[serde(default)]
    pub from: Option<Term>,
    /// The angle between the cord and the vertical at the end.
    #[serde(default)]
    pub to: Option<Term>,
    /// `down` if the body swings down to its lowest point and only the height says from where, and up by default. Between two angles
    /// it says which end lies higher, so that a `height` may be given.
    #[serde(default)]
    pub way: Option<UpOrDown>,
    /// Which way the body moves at its lowest point, along the horizontal axis: `to the left`; relative to what the cord is fixed
    /// `on`. Default: along the axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// `rest` if the body comes to rest at the angle `to`, `together` if it and what the cord is fixed `on` have the same velocity there.
    #[serde(default)]
    pub until: Option<Halt>,
}

/// Up or down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum UpOrDown {
    /// Up.
    #[default]
    Up,
    /// Down.
    Down,
}

/// An end of a swing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place<'a> {
    /// At the lowest point.
    Lowest,
    /// At the angle given by the author, or at one that the scene names.
    Angle(Option<&'a Term>),
}

impl Swing {
    /// The distance from the centre of the circle, whatever keeps the body on it.
    #[must_use]
    pub fn arm(&self) -> Option<&Term> {
        self.length.as_ref().or(self.radius.as_ref())
    }

    /// The guide that keeps the body on its circle.
    #[must_use]
    pub fn held_by(&self) -> &'static str {
        if self.radius.is_some() { "the track" } else { "the cord" }
    }

    /// The start and the end of the swing.
    #[must_use]
    pub fn places(&self) -> [Place<'_>; 2] {
        match (&self.from, &self.to, self.way) {
            (Some(from), Some(to), _) => [Place::Angle(Some(from)), Place::Angle(Some(to))],
            (Some(from), None, _) => [Place::Angle(Some(from)), Place::Lowest],
            (None, to, None | Some(UpOrDown::Up)) => [Place::Lowest, Place::Angle(to.as_ref())],
            (None, _, Some(UpOrDown::Down)) => [Place::Angle(None), Place::Lowest],
        }
    }

    /// Whether it swings from one angle to another.
    #[must_use]
    pub fn goes_between_angles(&self) -> bool {
        self.places().iter().all(|place| matches!(place, Place::Angle(_)))
    }

    /// Whether it goes up, as far as that is said: a swing between two angles may go either way.
    #[must_use]
    pub fn goes_up(&self) -> bool {
        let [from, _] = self.places();
        from == Place::Lowest || self.goes_between_angles() && self.way == Some(UpOrDown::Up)
    }

    /// Whether the body is at rest at the end.
    #[must_use]
    pub fn stops(&self) -> bool {
        let open = matches!(self.places(), [_, Place::Angle(None)]);
        open || self.until.is_some()
    }
}
