//! Numbers that know their error, each with what it costs.

pub(super) mod ball;
pub(super) mod bounded;
pub(super) mod exact;
pub(super) mod plain;
pub(super) mod precise;
pub(super) mod real;
mod right_angles;
mod running_error;
