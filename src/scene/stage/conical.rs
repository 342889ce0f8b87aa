//! A conical pendulum.

use schemars::JsonSchema;
use serde::Deserialize;

use super::Arm;

/// A body on a cord moves steadily round a horizontal circle, before and after its cord is drawn in or let out.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Conical {
    /// A name for the stage.
    #[serde(default)]
    pub name: Option<String>,
    /// The body.
    pub body: String,
    /// The fixed point from which the cord hangs.
    pub about: String,
    /// The length of the cord: one term, or the lengths before and after: `[L_1, L_2]`.
    pub length: Arm,
}
