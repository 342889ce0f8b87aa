//! A term that the solutions of many variants show, and the unit in which its value is printed.

use std::sync::Arc;

use momentous_expr::Arrangement;
use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_quantity::Unit;

/// A term, set in symbols once and ready for the numbers of each variant.
#[derive(Debug)]
pub(crate) struct Term {
    pub expr: Expr,
    /// In symbols.
    pub symbols: Math,
    /// Its unit, from its dimension.
    pub unit: Measured,
    /// Whether its value is a number, or a multiple of letters that are left open.
    pub is_multiple: bool,
    /// The quantities in it.
    pub mentions: Vec<Symbol>,
    /// Whether it holds the angle of a point.
    pub has_angle: bool,
    /// The arrangement, but for what stands for its symbols.
    pub arranged: Arrangement,
}

/// A unit in which many values are printed; where letters are left open, a unit with powers of these.
#[derive(Debug)]
pub(crate) struct Measured {
    pub unit: Unit,
    /// The powers of letters, as a product.
    pub letters: Option<Expr>,
    /// The suffix of the number; none for a pure number.
    suffix: Option<Math>,
    /// The product of letters, set in symbols.
    product: Option<Math>,
}

impl Measured {
    pub(crate) fn new(unit: Unit) -> Self {
        Self { suffix: suffix(&unit), unit, letters: None, product: None }
    }

    pub(super) fn with_letters(self, letters: Expr, product: Math) -> Self {
        Self { letters: Some(letters), product: Some(product), ..self }
    }

    /// A number followed by the unit.
    pub(crate) fn put(&self, number: Math) -> Math {
        let is = |number: &Math, text: &str| matches!(number, Math::Number(digits) if digits == text);
        let times = |number: Math, product: &Math| {
            Math::Row(vec![number, Math::Operator(Operator::Juxtapose), product.clone()])
        };
        match (&self.suffix, &self.product) {
            (None, None) => number,
            (_, Some(_)) if is(&number, "0") => number,
            (Some(suffix), None) => Math::Row(vec![number, suffix.clone()]),
            (None, Some(product)) if is(&number, "1") => product.clone(),
            (None, Some(product)) if is(&number, "-1") => {
                Math::Row(vec![Math::Operator(Operator::Minus), product.clone()])
            }
            (None, Some(product)) => times(number, product),
            (Some(suffix), Some(product)) => {
                times(Math::Bracketed(Arc::new(Math::Row(vec![number, suffix.clone()]))), product)
            }
        }
    }
}

/// The suffix of a number with that unit; none for a pure number.
pub(super) fn suffix(unit: &Unit) -> Option<Math> {
    let gap = if unit.is_attached() { "" } else { "\u{a0}" };
    (!unit.is_none()).then(|| Math::Text([gap, &unit.unicode()].concat()))
}
