//! What is worked out of a form when it is first wanted, and then kept beside it.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::OnceLock;
use std::sync::RwLock;

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::solve::Sensitivity;

/// The formulas of a form, as far as somebody has asked: by the way the scene goes, the roots that are taken, and the
/// quantity.
#[derive(Clone, Debug, Default)]
pub(in crate::problem) struct Formulas(pub(in crate::problem) Arc<RwLock<BTreeMap<FormulaKey, Option<Expr>>>>);

type FormulaKey = (usize, Vec<usize>, Symbol);

/// The values of some givens in variants of a form, in the order of the givens; none for what may be anything.
pub type Sample = Vec<Option<f64>>;

/// The samples of a form, as far as somebody has asked: by the way the scene goes, the roots that are taken, and the givens.
#[derive(Clone, Debug, Default)]
pub(in crate::problem) struct Samples(pub(in crate::problem) Arc<RwLock<BTreeMap<SampleKey, Arc<[Sample]>>>>);

type SampleKey = (usize, Vec<usize>, Vec<Symbol>);

/// How the answers of a form move with the values on the way, for each way in which its scene can go; empty until it is asked for.
#[derive(Clone, Debug, Default)]
pub(in crate::problem) struct Sensitivities(pub(in crate::problem) Arc<OnceLock<Vec<Sensitivity>>>);
