//! The whole suite.

use super::{Row, Trial, hard, points, run_trial, scenes};

/// The scenes on a line.
#[must_use]
pub fn on_a_line() -> Vec<Trial<1>> {
    scenes::on_a_line().into_iter().chain(hard::on_a_line()).collect()
}

/// The scenes in the plane.
#[must_use]
pub fn in_the_plane() -> Vec<Trial<2>> {
    scenes::in_the_plane().into_iter().chain(hard::in_the_plane()).collect()
}

/// Every scene by every method, and impacts at a point by every law of restitution.
#[must_use]
pub fn run_all() -> Vec<Row> {
    let mut rows: Vec<Row> = on_a_line().iter().flat_map(run_trial).collect();
    rows.extend(in_the_plane().iter().flat_map(run_trial));
    rows.extend(points::run_all());
    rows
}
