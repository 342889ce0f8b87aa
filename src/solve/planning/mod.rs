//! From a system to a plan: which equations, in which order, closed by which tactic, and with which checks.

pub(super) mod audit;
pub(super) mod choice;
pub(super) mod pending;
pub(super) mod plan;
pub(super) mod planner;
pub(super) mod search;
pub(super) mod stuck;
pub(super) mod tactics;
pub(super) mod ties;
