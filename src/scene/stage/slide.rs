//! A slide over a floor or along a slope.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

use super::Halt;
use super::UpOrDown;

/// A body slides over a level floor, or up or down a slope; only friction and weight act along its path.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Slide {
    /// A name for the stage, used in brackets: `dt[skid]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// What it slides on, where that is a body that gives way along the level axis: a wedge on ice. Needs a `height`.
    #[serde(default)]
    pub on: Option<String>,
    /// The coefficient of kinetic friction. Default: the floor is smooth.
    #[serde(default)]
    pub friction: Option<Term>,
    /// How far it slides.
    #[serde(default)]
    pub distance: Option<Term>,
    /// How long it slides. Default: `dt`.
    #[serde(default)]
    pub duration: Option<Term>,
    /// The slope against the level: `alpha above +x` where the floor rises towards +x, `alpha below +x` where it falls; the
    /// angle alone where the axis points up or down the slope. Default: the floor is level.
    #[serde(default)]
    pub incline: Option<Term>,
    /// The height between the two ends of the slide, where the floor is not level.
    #[serde(default)]
    pub height: Option<Term>,
    /// `up` or `down` if there is a height and no incline: the way on a smooth ramp of any shape. Default: down.
    #[serde(default)]
    pub way: Option<UpOrDown>,
    /// Which way it slides, along one axis: `to the left`; relative to what it slides `on`. Default: along the axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// `rest` if it slides until it is at rest, `together` until it and what it slides `on` have the same velocity.
    #[serde(default)]
    pub until: Option<Halt>,
}

impl Slide {
    /// Whether it goes along a smooth ramp of any shape, of which only the height is known.
    #[must_use]
    pub fn is_ramp(&self) -> bool {
        self.height.is_some() && self.incline.is_none()
    }
}
