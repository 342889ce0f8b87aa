//! Values that are worked out of a form when they are first wanted, and then kept beside it.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::OnceLock;
use std::sync::RwLock;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_solve::Sensitivity;

/// The formulas of a form, as far as somebody has asked: by the way the scene goes, the roots that are taken, and the
/// quantity.
#[derive(Clone, Debug, Default)]
pub(crate) struct Formulas(pub(crate) Arc<RwLock<BTreeMap<FormulaKey, Option<Expr>>>>);

type FormulaKey = (usize, Vec<usize>, Symbol);

/// The values of some givens in variants of a form, in the order of the givens; none for what may be anything.
pub type Sample = Vec<Option<f64>>;

/// The samples of a form, as far as somebody has asked: by the way the scene goes, the roots that are taken, and the givens.
#[derive(Clone, Debug, Default)]
pub(crate) struct Samples(pub(crate) Arc<RwLock<BTreeMap<SampleKey, Arc<[Sample]>>>>);

type SampleKey = (usize, Vec<usize>, Vec<Symbol>);

/// How the answers of a form move with the values on the way, for each way in which its scene can go; empty until it is asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sensitivities(pub(crate) Arc<OnceLock<Vec<Sensitivity>>>);
