//! Physics-free: a system of equations is planned, solved symbolically, and compiled to tapes that replay in floating point.
//!
//! [`plan`] chooses equations and closes them; [`audit`] adds what judging needs; [`Program::compile`] flattens both;
//! [`Program::solve`] replays them for one variant, with bounds on every error.
//!
//! ```
//! use std::collections::BTreeSet;
//! use momentous::expr::{Expr, SymbolEntry, SymbolTable};
//! use momentous::quantity::{Dimension, Rational};
//! use momentous::solve::{Equation, Exact, Program, Statement, System, Verify, Workspaces, audit, plan};
//!
//! let mut table = SymbolTable::default();
//! let [m, v, p] = ["m", "v", "p"].map(|name| {
//!     table.intern(SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: name.into() })
//! });
//! let momentum = Statement::Equal { left: Expr::from(p), right: Expr::from(m) * Expr::from(v) };
//! let system = System { equations: vec![Equation { statement: momentum, tag: 0, cost: 1 }], ..System::default() };
//!
//! let known = BTreeSet::from([m, p]);
//! let plan = plan(&system, &known, &[v]).unwrap();
//! let audit = audit(&system, &known, &plan);
//! let program = Program::compile(&system, &audit, &[m, p], &[v], Verify::All)?;
//!
//! let givens = [Exact::from(Rational::from(4)), Exact::from(Rational::from(10))];
//! let mut memory = Workspaces::default();
//! let outcome = program.solve(&givens, &mut memory);
//! assert_eq!(outcome.survivors(), 1);
//! assert_eq!(outcome.value(v).map(|speed| speed.value), Some(2.5));
//! # Ok::<(), momentous::solve::UnknownSymbol>(())
//! ```

mod audit;
mod backward;
mod ball;
mod basis;
mod batch;
mod bits;
mod blocks;
mod bounded;
mod bracketing;
mod choice;
mod counting;
mod evaluate;
mod exact;
mod freedom;
mod matching;
mod outcome;
mod pending;
mod plain;
mod plan;
mod planner;
mod precise;
mod program;
mod rank;
mod real;
mod replay;
mod residuals;
mod sample;
mod scaling;
mod search;
mod sensitivity;
mod structure;
mod stuck;
mod symbol_registers;
mod system;
mod tactics;
mod tape;
mod tree;
mod workspace;
mod writer;

pub use audit::{Audit, audit};
pub use ball::Ball;
pub use batch::{Batch, BatchValues, BatchWriter};
pub use bounded::Bounded;
pub use evaluate::evaluate;
pub use exact::Exact;
pub use outcome::Outcome;
pub use pending::Verify;
pub use plan::{Closed, Move, Plan, Root, Step, Tactic};
pub use planner::{Planner, plan};
pub use precise::Precise;
pub use program::{Program, UnknownSymbol};
pub use real::{Real, Sign};
pub use scaling::may_grow;
pub use sensitivity::Sensitivity;
pub use stuck::{Reason, Stuck};
pub use system::{Condition, Equation, Relation, Statement, System};
pub use tree::{Tree, TreeWorkspace};
pub use workspace::{Cause, Death, Precision, Workspace, Workspaces};
