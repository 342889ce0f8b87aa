//! The least model that a scene needs, and the cheapest method that meets a request.

mod choice;
mod class;
mod costs;
#[cfg(feature = "clock")] // it reads the clock
mod measure;

pub use choice::{Choice, DEFAULT_ACCURACY, NoChoice, Request, choose};
pub use class::{Class, Classified, classify};
pub use costs::{Cost, costs};
#[cfg(feature = "clock")]
pub use measure::measure_costs;
