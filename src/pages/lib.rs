//! The pages of problems: fields of an address or a form in, a call of the engine, a page out. No physics and no marking stands here,
//! nor in the scripts of the pages: a browser draws what the engine computed.
//!
//! Whoever shows them, a server or a file that needs none, asks [`View`] for a page:
//!
//! ```
//! use momentous_bank::Bank;
//! use momentous_exercise::calls::Limits;
//! use momentous_pages::{Beside, Library, Nothing, Pages, View};
//!
//! let pages = Pages::new(Library::of(Bank::built_in()), "", Limits::default(), None)?;
//! let view = View::new(&pages, Beside::default(), &Nothing);
//! let sheet = view.answer("/practice/impact/two-carts", Vec::new())?;
//! assert!(sheet.contains("Two carts"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod again;
mod assets;
mod figure;
mod library;
mod pages;
mod parameters;
mod place;
mod play;
mod practice;
mod refusal;
mod routes;
mod simulator;
mod solve;
mod start;
mod view;
mod watched;
mod withheld;
pub mod words;

pub use again::Again;
pub use assets::Assets;
pub use library::Library;
pub use pages::{Beside, Pages, SIMULATORS};
pub use parameters::Parameters;
pub use place::FormLink;
pub use refusal::{Refusal, heading, no_page};
pub use routes::{OfProblem, PROBLEM_PAGES, Shown};
pub use view::View;
pub use withheld::{Nothing, Open, Withheld};
