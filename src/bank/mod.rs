//! Finding and listing problems, and the audit behind `momentous check`.

mod answers;
mod audit;
mod collection;
mod course;
mod diagnosis;
mod entry;
mod printed;
mod promise;
mod repeat;
mod report;
mod sample;
mod simulation;
mod wrong_forms;

pub use audit::{Seeds, audit};
pub use collection::{Bank, FOLDER, files_under};
pub use course::{COURSE_FILE, load_in_course};
pub use diagnosis::{Diagnosed, Tally, diagnosed};
pub use entry::Card;
pub use promise::{Finding, Outcome, Promise};
pub use report::{AnswerSpread, Audit, FormAudit};
pub use simulation::{Simulated, followed, staged};
