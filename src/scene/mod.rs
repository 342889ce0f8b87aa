//! What is in a scene: bodies, axes, surfaces, points and a timeline of stages. Data only; no law is known here.

mod axes;
mod body;
mod force;
pub mod stage;
mod term;

pub use axes::{Axes, Axis, Sense, Senses};
pub use body::{Body, Plane, Point, Surface};
pub use force::{Force, Friction, Piece, Pull, Strength};
pub use stage::Stage;
pub use term::Term;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

/// The bodies, the axes and the timeline of a problem.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// The axes, each with the direction in which it points: `{ x: to the right }`, `{ x: east, y: north }`; or `polar`.
    pub axes: Axes,
    /// Whether the drawing's plane is `horizontal` (weight does not act in it) or `vertical` (it does). Default: horizontal.
    #[serde(default)]
    pub plane: Plane,
    /// The bodies, each under a short name that ends in a letter: `A`, `ball`.
    pub bodies: BTreeMap<String, Body>,
    /// Fixed or moving smooth surfaces that bodies strike: `floor: { normal: up }`.
    #[serde(default)]
    pub surfaces: BTreeMap<String, Surface>,
    /// Fixed points about which moments are taken: `O: { name: the pivot }`.
    #[serde(default)]
    pub points: BTreeMap<String, Point>,
    /// What happens, in order. Instants 1, 2, 3, ... lie before, between and after the stages. None: a single instant.
    #[serde(default)]
    pub stages: Vec<Stage>,
    /// Names for the instants, in order, to be used after `@`: `[before, after]` lets `v_A@after` be written.
    #[serde(default)]
    pub instants: Vec<String>,
}
