//! A vector as an author writes it: a term for each axis.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{Axis, Term};

/// The components of a vector along the axes; those left out are zero.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Components {
    /// Along x.
    #[serde(default)]
    pub x: Option<Term>,
    /// Along y.
    #[serde(default)]
    pub y: Option<Term>,
    /// Along z.
    #[serde(default)]
    pub z: Option<Term>,
}

impl Components {
    /// The component along an axis, where it is written.
    #[must_use]
    pub fn get(&self, axis: Axis) -> Option<&Term> {
        match axis {
            Axis::X => self.x.as_ref(),
            Axis::Y => self.y.as_ref(),
            Axis::Z => self.z.as_ref(),
        }
    }

    /// The axes along which a component is written.
    pub fn axes(&self) -> impl Iterator<Item = Axis> {
        [Axis::X, Axis::Y, Axis::Z].into_iter().filter(|axis| self.get(*axis).is_some())
    }
}
