//! From a derivation to an outline: wording, rounding for display, the steps.

mod asked;
mod cache;
mod checking;
mod computed;
mod detail;
mod lines;
mod outline;
mod pictures;
mod reach;
mod sections;
mod terms;
mod wording;
mod working;

pub use asked::{lines_out, offered_pictures, printed_answers, printed_formula, situation};
pub use detail::Detail;
pub use lines::Line;
pub use lines::lines;
pub use outline::{Audience, Block, Inline, Outline, Section};
pub use reach::last_instant;
pub use sections::solution::solution;
pub use terms::printed::{printed_range, printed_vector};
pub use wording::capitalised;
