//! The names that a text may contain.

use momentous_expr::Symbol;
use momentous_expr::SymbolTable;

use super::super::super::expected::ExpectedFormula;

/// The names that a text may contain, and what each stands for.
pub(super) struct Vocabulary<'a> {
    /// All quantities, with their names and dimensions.
    pub(super) symbols: &'a SymbolTable,
    /// The quantities that may stand in the text.
    pub(super) names: Vec<Symbol>,
    /// The quantity that is asked, where it may not stand in the text.
    pub(super) asked: Option<Symbol>,
    /// The symbols that stand for numbers of the text, in their order.
    pub(super) numbers: Vec<Symbol>,
    /// The place of a factor that stands behind a fraction bar without a sign.
    pub(super) behind_bars: BehindBars,
}

/// The place of a factor that stands behind a fraction bar without a sign: `a/b c`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BehindBars {
    /// It is asked back.
    Doubtful,
    /// Above the bar.
    Above,
    /// Below it.
    Below,
}

/// How doubtful places of a term are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Manner {
    /// The meaning of letters behind a number.
    pub letters: Letters,
    /// The place of factors behind a fraction bar.
    pub behind_bars: BehindBars,
}

/// The meaning of a letter behind a number that may be a unit or a quantity: `2 m`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letters {
    /// The unit.
    Units,
    /// The quantity.
    Names,
    /// The quantity where another one follows, as in `2 m v`, and the unit elsewhere.
    Products,
}

impl<'a> Vocabulary<'a> {
    /// The names of an answer that is a formula.
    pub(super) fn of(asked: &'a ExpectedFormula) -> Self {
        let given = asked.domain.iter().map(|(symbol, ..)| *symbol);
        Self {
            symbols: &asked.symbols,
            names: given.chain(asked.values.iter().map(|(symbol, _)| *symbol)).collect(),
            asked: Some(asked.asked),
            numbers: Vec::new(),
            behind_bars: BehindBars::Doubtful,
        }
    }

    /// Whether a symbol stands for a number of the text.
    pub(super) fn is_written(&self, symbol: Symbol) -> bool {
        self.numbers.contains(&symbol)
    }
}
