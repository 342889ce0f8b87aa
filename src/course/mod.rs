//! Courses: people, assignments, what was handed in, and the rules by which it counts. All of it is data and functions; nothing here
//! knows a clock, a database, a file or a page. What happens at a moment is told that [`Moment`].

mod assignment;
mod fields;
mod handed_in;
mod key;
mod local_time;
mod moment;
mod people;
mod policy;
mod policy_form;
mod problem_file;
mod share;
mod window;

pub use assignment::{Assignment, Correction, CorrectionChoice, Extension, Item};
pub use fields::FieldFault;
pub use handed_in::{Attempt, Draft, HintShown, Override, Sheet};
pub use key::Key;
pub use local_time::{NoMoment, zone};
pub use moment::Moment;
pub use people::{Course, Member, Person, Role};
pub use policy::{Policy, Release, SolutionRelease};
pub use policy_form::PolicyForm;
pub use problem_file::ProblemFile;
pub use share::{NoShare, Share};
pub use window::{ExtensionForm, Late, Phase, Window};
