//! Marking: what is read of an answer, how it is judged, and what the report says.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

mod answers;
mod asks;
mod attempts;
mod boundary_rules;
mod bounds;
mod diagnosis;
mod formulas;
mod honest_rounding;
mod items;
mod misreadings;
mod mistakes_met;
mod no_reason;
mod readings;
mod round_trip;
mod several_roots;
mod sheets;
mod tutored;
mod verdicts;
