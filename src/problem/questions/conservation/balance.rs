//! A question of conservation whose names are known, and what decides it.

use super::super::super::language::ask::Conserved;
use super::super::choices::judgement::Test;

/// A question of conservation whose names are known.
pub(crate) struct Balance<'a> {
    pub ask: &'a Conserved,
    pub stage: usize,
    /// The axes along which momentum is meant, by their positions.
    pub axes: Vec<usize>,
    /// The point about which angular momentum is meant.
    pub about: &'a str,
    /// Whether the stage takes no time.
    pub is_sudden: bool,
}

/// The decision of a question of conservation: what has to hold, why it is conserved then, and the words for both instants.
pub(crate) struct Verdict {
    pub tests: Vec<Test>,
    pub because: String,
}
