//! The pages of courses: who may see which is said in one table, and each page is one function of a `Visit`.

mod account;
mod around;
mod at_close;
mod clock;
mod companion;
mod fields;
mod gate;
mod grades;
mod hidden;
pub mod invite;
mod items;
mod joining;
mod ledger;
mod library;
mod limits;
mod origin;
mod outcome;
mod password;
mod processes;
mod reply;
pub mod retention;
mod routes;
mod serve;
mod session;
mod staff;
mod state;
mod student;
mod table;
mod visit;
mod visitor;
mod withheld;

pub use clock::Clock;
pub use gate::Who;
pub use serve::serve;
pub use state::Courses;
pub use table::{Address, addresses};
