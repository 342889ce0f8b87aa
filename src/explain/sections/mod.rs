//! The sections of a worked solution.

pub(super) mod answers;
pub(super) mod axes;
pub(super) mod diagrams;
pub(super) mod instructor;
pub(super) mod interval;
pub(super) mod solution;
mod stage_words;
