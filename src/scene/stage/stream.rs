//! A steady stream on a body: a jet on a vane or a plate, sand on a belt, hail, a chain.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A steady stream meets a body that is at rest or moves at constant velocity, and exerts a force on it. How much arrives is given by `flow`, or by
/// `density` and `area`, or by `per_length`. Without `turned`, `restitution` or `stays` it spreads over the smooth surface of the body.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stream {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body that the stream meets.
    pub body: String,
    /// What the stream is called in a sentence: `the jet`, `the sand`.
    pub by: String,
    /// The speed of the stream: a name, a value or an expression. Or `drop`.
    #[serde(default)]
    pub speed: Option<Term>,
    /// The height through which the stream falls from rest before it meets the body, instead of its speed.
    #[serde(default)]
    pub drop: Option<Term>,
    /// The direction of the stream: `to the right`, `downwards`. Default: along the first axis.
    #[serde(default)]
    pub direction: Option<Term>,
    /// The speed of the body along the stream, where it moves.
    #[serde(default)]
    pub moves: Option<Term>,
    /// The mass that reaches the body per unit time.
    #[serde(default)]
    pub flow: Option<Term>,
    /// The density of the stream, with `area`.
    #[serde(default)]
    pub density: Option<Term>,
    /// The cross-section of the stream, with `density`.
    #[serde(default)]
    pub area: Option<Term>,
    /// The mass per unit length, of a chain or a rope.
    #[serde(default)]
    pub per_length: Option<Term>,
    /// Whether many bodies follow each other (a wheel of vanes), so that all of the stream is used even where they move.
    #[serde(default)]
    pub series: bool,
    /// The angle through which a smooth vane turns the stream, counter-clockwise positive: 180° sends it back.
    #[serde(default)]
    pub turned: Option<Term>,
    /// The direction at right angles to the smooth surface over which the stream spreads, or from which it rebounds: `upwards`,
    /// `30 deg above +x`. Default: that of the stream, which meets the surface squarely.
    #[serde(default)]
    pub normal: Option<Term>,
    /// The coefficient of restitution, where the stream rebounds from the body: hail, bullets.
    #[serde(default)]
    pub restitution: Option<Term>,
    /// Whether what arrives stays on the body: sand on a belt, water in a bucket, a chain on a scale.
    #[serde(default)]
    pub stays: bool,
    /// For how long the stream has been caught, in a vertical plane: its weight rests on the body.
    #[serde(default)]
    pub during: Option<Term>,
    /// The mass caught so far, instead of a time.
    #[serde(default)]
    pub caught: Option<Term>,
}
