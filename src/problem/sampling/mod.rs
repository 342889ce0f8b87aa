//! Drawing variants: random words, values, what they round to, and why a draw is refused.

pub(super) mod issued;
mod limit;
mod motion;
mod nearest;
pub(super) mod neglected;
pub(super) mod no_variant;
mod other_way;
mod passage;
mod refusal;
mod rival;
pub(super) mod rounding;
pub(super) mod sampler;
pub(super) mod samples;
pub(super) mod say;
pub(super) mod secret;
mod sense;
pub(super) mod sign;
pub(super) mod stream;
pub(super) mod variant;
