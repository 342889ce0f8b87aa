//! Answers as multiples of another quantity, `0.44` where they are asked in `T_1`: a bare number is that multiple.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_problem::AskedUnit;
use momentous_quantity::Dimension;

use super::judge::Judge;
use super::written::Written;

impl Judge<'_> {
    /// A line whose sides without a dimension are multiples of that in terms of which its quantity is asked; `None` where there are none.
    pub(crate) fn in_terms_asked(&self, line: &Written) -> Option<Written> {
        let mut multiplied = line.clone();
        let mut is_changed = false;
        for chain in multiplied.stated.iter_mut().flatten() {
            let sides = || chain.iter().flat_map(|statement| [&statement.left, &statement.right]);
            let letter = sides().find_map(|side| line.letter_alone(side));
            let Some(unit) = letter.and_then(|letter| self.asked_in(letter)) else { continue };
            for side in chain.iter_mut().flat_map(|statement| [&mut statement.left, &mut statement.right]) {
                if !side.is_zero() && is_pure(line, side) {
                    *side = side.clone() * Expr::from(unit);
                    is_changed = true;
                }
            }
        }
        is_changed.then_some(multiplied)
    }

    /// The quantity of which a multiple is asked.
    fn asked_in(&self, symbol: Symbol) -> Option<Symbol> {
        let numbers = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
        numbers.into_iter().find(|number| number.symbol == symbol).and_then(|number| match &number.unit {
            AskedUnit::InTermsOf(unit, rest) if rest.is_none() => Some(*unit),
            _ => None,
        })
    }
}

/// Whether nothing in a side has a dimension.
fn is_pure(line: &Written, side: &Expr) -> bool {
    side.symbols().into_iter().all(|symbol| match line.number(symbol) {
        Some(number) => number.unit.is_none(),
        None => line.symbols.entry(symbol).dimension == Dimension::NONE,
    })
}
