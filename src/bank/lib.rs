//! Finding and listing problems, and the audit behind `momentous check`.

mod agreement;
mod answers;
mod audit;
mod collection;
mod course;
mod diagnosis;
mod each;
mod easier;
mod entry;
mod exhibit;
mod expected;
#[cfg(feature = "files")]
mod files;
mod homework;
mod printed;
mod promise;
mod query;
#[cfg(feature = "files")]
mod read_file;
mod relatives;
mod repeat;
mod report;
#[cfg(feature = "files")]
mod repository;
mod sample;
mod sections;
mod spelling;
mod wrong_forms;

pub use audit::{Seeds, audit, unusable};
pub use collection::Bank;
pub use course::{COURSE_FILE, FOLDER, load_in_course};
#[cfg(feature = "files")]
pub use course::{course_file, course_letters};
pub use diagnosis::{Diagnosed, Tally, diagnosed};
pub use entry::Card;
pub use exhibit::{AnswerKind, Exhibit};
#[cfg(feature = "files")]
pub use files::files_under;
pub use homework::{HOMEWORK_FOLDER, Homework, Slot};
pub use promise::{Finding, Outcome, Promise};
pub use query::Query;
pub use report::{AnswerSpread, Audit, Failing, FormAudit};
#[cfg(feature = "files")]
pub use repository::course_folder;
pub use sections::Section;
