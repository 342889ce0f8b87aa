//! The least model that a scene needs, and the cheapest method that meets a request.

mod choice;
mod class;
mod costs;
mod kept;
#[cfg(feature = "clock")] // it reads the clock
mod measure;
mod work;

pub use choice::{Choice, DEFAULT_ACCURACY, NoChoice, Request, options, time};
pub use class::{Class, Classified, classify};
pub use costs::{Cost, costs};
pub use kept::{Kept, MARGIN, NotKept, keep};
#[cfg(feature = "clock")]
pub use measure::measure_costs;
