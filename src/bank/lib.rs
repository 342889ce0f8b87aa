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
mod expected;
#[cfg(feature = "files")]
mod files;
mod homework;
mod printed;
mod promise;
#[cfg(feature = "files")]
mod read_file;
mod repeat;
mod report;
#[cfg(feature = "files")]
mod repository;
mod sample;
mod wrong_forms;

pub use audit::{Seeds, audit, unusable};
pub use collection::Bank;
#[cfg(feature = "files")]
pub use course::course_letters;
pub use course::{COURSE_FILE, FOLDER, load_in_course};
pub use diagnosis::{Diagnosed, Tally, diagnosed};
pub use entry::Card;
#[cfg(feature = "files")]
pub use files::files_under;
pub use homework::{HOMEWORK_FOLDER, Homework, Slot};
pub use promise::{Finding, Outcome, Promise};
pub use report::{AnswerSpread, Audit, Failing, FormAudit};
#[cfg(feature = "files")]
pub use repository::course_folder;
