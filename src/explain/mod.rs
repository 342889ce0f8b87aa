//! From a derivation to an outline: wording, rounding for display, the steps.

mod algebra;
mod answers;
mod axes;
mod checks;
mod computed;
mod counting;
mod derivation;
mod diagrams;
mod display;
mod divisors;
mod energy;
mod instructor;
mod interval;
mod ledger;
mod limits;
mod lines;
mod numbers;
mod outline;
mod pictures;
mod quadratic;
mod script;
mod sentence;
mod solution;
mod steps;
mod term;
mod way;
mod wording;

pub use answers::{printed_answers, printed_formula, printed_vector};
pub use computed::lines_out;
pub use interval::printed_range;
pub use lines::Line;
pub use lines::lines;
pub use outline::{Audience, Block, Inline, Outline, Section, SharedBlock};
pub use pictures::situation;
pub use solution::brief;
pub use solution::solution;
