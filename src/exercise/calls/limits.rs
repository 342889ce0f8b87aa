//! How much a call may take.

use super::refused::{Refused, RefusedKind};

/// The bounds of calls. Each counts work or bytes and none reads a clock, so that the same call ends in the same way on every
/// machine. A face chooses them for its [`Engine`](super::Engine).
///
/// What is not listed has one bound that is the same for every face, because a reading or a number would depend on it: the
/// length and depth of an answer, and the tries of a draw.
///
/// ```
/// use momentous_exercise::calls::Limits;
/// let phone = Limits { scene_steps: 10_000, ..Limits::default() };
/// assert!(phone.scene_steps < Limits::default().scene_steps);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The bytes of a request.
    pub request_bytes: usize,
    /// The fields of an address or of a form.
    pub fields: usize,
    /// The values that are set, the quantities that are sought, and the answers, of each so many.
    pub values: usize,
    /// The bounces that a simulator follows.
    pub bounces: u32,
    /// The steps of a method in a simulator.
    pub simulator_steps: usize,
    /// The impacts of a method in a simulator.
    pub simulator_impacts: usize,
    /// The steps of each run of a problem's scene; of a method without steps, the events.
    pub scene_steps: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            request_bytes: 64 * 1024,
            fields: 400,
            values: 64,
            bounces: 20,
            simulator_steps: 20_000,
            simulator_impacts: 250,
            scene_steps: 1_000_000,
        }
    }
}

/// Refuses more than so many of something.
///
/// # Errors
/// Where `count` is above `most`.
pub fn within(count: usize, most: usize, what: &str) -> Result<(), Refused> {
    if count <= most {
        return Ok(());
    }
    Err(Refused::new(RefusedKind::TooLarge, format!("at most {most} {what}, and these are {count}")))
}
