//! What a short contact may put into its balance although it is usually left out.

use schemars::JsonSchema;
use serde::Deserialize;

/// An impulse that a short contact usually leaves out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Included {
    /// That of weight.
    Weight,
}
