//! Records of a motion that is watched.

use crate::record::Record;

use super::component::Component;
use super::formula::Followed;

/// A motion that was watched.
#[derive(Clone, Debug)]
pub struct RecordedMotion {
    /// The components of its positions and velocities.
    pub components: Vec<Component>,
    /// The record.
    pub record: Record,
    /// What it follows from.
    pub followed: Followed,
    /// The notes that a reader needs.
    pub notes: Vec<&'static str>,
}

/// A body as it is seen at an instant.
pub(super) struct SeenBody {
    pub mass: f64,
    pub place: Vec<f64>,
    pub velocity: Vec<f64>,
}

/// The view of a motion at an instant.
#[derive(Default)]
pub(super) struct Look {
    pub bodies: Vec<SeenBody>,
    /// The forces from outside, added up.
    pub outside: Vec<f64>,
    /// The energy that weight and springs can give back.
    pub potential: f64,
    /// The power of all other forces.
    pub power: f64,
    /// The energy that is lost for good.
    pub lost: f64,
}
