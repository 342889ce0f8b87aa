//! The least model that a scene needs, and the cheapest method that meets a request.

mod choice;
mod class;
mod costs;

pub use choice::{Choice, DEFAULT_ACCURACY, NoChoice, Request, choose};
pub use class::{Class, Classified, classify};
pub use costs::{Cost, costs, measure_costs};
