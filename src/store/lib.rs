//! The records of courses, kept: in SQLite, in a folder, or in PostgreSQL. It knows keys and records and no rule of a course.
//!
//! Both databases hold the same tables and take the same statements: a record is kept as JSON, beside the columns by which it is
//! found and which must be unique.

mod address;
mod allowance;
mod assignments;
mod backup;
mod connection;
mod courses;
mod fault;
mod health;
mod inspect;
mod joining;
mod lock;
mod mail;
mod open;
mod people;
mod private;
mod problem_files;
mod readers;
mod records;
mod regrade;
mod retention;
mod schema;
mod sheets;
mod tickets;
mod trail;
mod writer;

pub use address::Address;
pub use allowance::Rate;
pub use assignments::AssignmentWithItems;
pub use fault::StoreFault;
pub use health::Ill;
pub use inspect::Inspection;
pub use mail::MailedLink;
pub use open::Store;
pub use people::Membership;
pub use regrade::Regrade;
pub use retention::Records;
pub use sheets::{HandIn, HandedIn};
/// The driver of the databases, for tests that look into them.
pub use sqlx;
pub use tickets::{Reach, Ticket, TicketKind};
pub use trail::Entry;
