//! Physics-free: a system of equations is planned, solved symbolically, and compiled to tapes that replay in floating point.
//!
//! [`plan`] chooses equations and closes them; [`audit`] adds what judging needs; [`Program::compile`] flattens both;
//! [`Program::solve`] replays them for one variant, with bounds on every error.
//!
//! ```
//! use std::collections::BTreeSet;
//! use momentous_expr::{Expr, SymbolEntry, SymbolTable};
//! use momentous_quantity::{Dimension, Rational};
//! use momentous_solve::{Equation, Exact, Program, Statement, System, Verify, Workspaces, audit, plan};
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
//! # Ok::<(), momentous_solve::UnknownSymbol>(())
//! ```

mod evaluate;
mod number;
mod planning;
mod replay;
mod scaling;
mod structure;
mod system;

pub use evaluate::evaluate;
pub use number::ball::Ball;
pub use number::bounded::Bounded;
pub use number::exact::Exact;
pub use number::precise::Precise;
pub use number::real::{Real, Sign};
pub use planning::audit::{Audit, audit};
pub use planning::pending::Verify;
pub use planning::plan::{Closed, Move, Plan, Root, Step, Tactic, quadratic_formula};
pub use planning::planner::{Planner, has_enough, plan};
pub use planning::stuck::{Reason, Stuck};
pub use planning::ties::Ties;
pub use replay::batch::{Batch, BatchValues, BatchWriter};
pub use replay::outcome::Outcome;
pub use replay::program::{Program, UnknownSymbol};
pub use replay::sensitivity::Sensitivity;
pub use replay::tree::{Tree, TreeWorkspace};
pub use replay::workspace::{Cause, Death, Precision, Workspace, Workspaces};
pub use scaling::may_grow;
pub use structure::rank::is_singular;
pub use system::{Condition, Equation, Relation, Statement, System};
