//! A term that the solutions of many variants show.

use crate::expr::Arrangement;
use crate::expr::Expr;
use crate::expr::Math;
use crate::expr::Symbol;
use crate::quantity::Unit;

/// A term, set in symbols once and ready for the numbers of each variant.
#[derive(Debug)]
pub(super) struct Term {
    pub expr: Expr,
    /// In symbols.
    pub symbols: Math,
    /// Its unit, from its dimension.
    pub unit: Unit,
    /// The quantities in it.
    pub mentions: Vec<Symbol>,
    /// Whether it holds the angle of a point.
    pub has_angle: bool,
    /// What it looks like but for what stands for its symbols.
    pub arranged: Arrangement,
}
