//! What a course says once for all problems of a folder, in `course.yaml`.

use schemars::JsonSchema;
use serde::Deserialize;

use super::course::CourseSymbols;

/// The settings of a course. They change how problems are printed and read, and never their numbers.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Course {
    /// The letters that the course uses for some quantities: `{ momentum: L, impulse: I }`. A problem's own letters come first.
    #[serde(default)]
    pub symbols: CourseSymbols,
}
