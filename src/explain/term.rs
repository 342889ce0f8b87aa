//! A term that the solutions of many variants show, and the unit in which its value is printed.

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
    pub unit: Measured,
    /// The quantities in it.
    pub mentions: Vec<Symbol>,
    /// Whether it holds the angle of a point.
    pub has_angle: bool,
    /// What it looks like but for what stands for its symbols.
    pub arranged: Arrangement,
}

/// A unit in which many values are printed.
#[derive(Debug)]
pub(super) struct Measured {
    pub unit: Unit,
    /// Its size in SI units.
    pub size: f64,
    /// What follows the number; nothing for a pure number.
    suffix: Option<Math>,
}

impl Measured {
    pub(super) fn new(unit: Unit) -> Self {
        Self { size: unit.factor().to_f64(), suffix: suffix(&unit).map(Math::shared), unit }
    }

    /// A number followed by the unit.
    pub(super) fn put(&self, number: Math) -> Math {
        match &self.suffix {
            Some(suffix) => Math::Row(vec![number, suffix.clone()]),
            None => number,
        }
    }
}

/// What follows a number with that unit; nothing for a pure number.
pub(super) fn suffix(unit: &Unit) -> Option<Math> {
    let gap = if unit.is_attached() { "" } else { "\u{a0}" };
    (!unit.is_none()).then(|| Math::Text([gap, &unit.unicode()].concat()))
}
