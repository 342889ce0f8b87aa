//! Numerics in the form that does not cancel: roots, times, orbits, sums of bounces, grazing contacts.

mod bounces;
mod clock;
mod fading;
mod grazing;
mod orbit;
mod polynomial;
mod quadratic;

pub use bounces::BounceTrain;
pub use clock::Clock;
pub use fading::{repeated_cosine, repeated_decay};
pub use grazing::grazing_cosine;
pub use orbit::Orbit;
pub use polynomial::first_fall;
pub(super) use polynomial::shifted;
pub use quadratic::{Meeting, first_contact};
