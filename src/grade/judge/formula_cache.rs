//! A cache of formulas that were judged before: many students of a class type the same one, and the worst takes milliseconds.

use std::cell::RefCell;
use std::sync::Arc;

use super::super::expected::ExpectedFormula;
use super::super::read::FormulaAnswer;
use super::judgement::Judgement;

/// The number that is remembered before all are forgotten.
const MOST: usize = 64;

/// A formula that was judged, against what.
struct Known {
    expected: ExpectedFormula,
    answer: FormulaAnswer,
    judgement: Judgement,
}

thread_local! {
    static CACHE: RefCell<Vec<Known>> = RefCell::default();
}

/// The judgement on a formula, from memory where it was found before on this thread.
pub(super) fn judged(
    expected: &ExpectedFormula,
    answer: &FormulaAnswer,
    judge: impl FnOnce() -> Judgement,
) -> Judgement {
    // The samples are those of one way of one form; where there are none, nothing says which form it is.
    if expected.samples.is_empty() {
        return judge();
    }
    let is_same = |known: &&Known| {
        Arc::ptr_eq(&known.expected.samples, &expected.samples)
            && known.answer == *answer
            && known.expected == *expected
            && known.expected.values == expected.values
    };
    let cached = CACHE.with_borrow(|known| known.iter().find(is_same).map(|known| known.judgement.clone()));
    cached.unwrap_or_else(|| {
        let judgement = judge();
        CACHE.with_borrow_mut(|known| {
            if known.len() >= MOST {
                known.clear();
            }
            known.push(Known { expected: expected.clone(), answer: answer.clone(), judgement: judgement.clone() });
        });
        judgement
    })
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::super::super::messages::Message;
    use super::super::super::verdict::Verdict;
    use super::*;
    use momentous_expr::{Expr, SymbolEntry, SymbolTable};
    use momentous_quantity::Dimension;

    #[test]
    fn equal_formulas_of_a_form_are_judged_once() {
        let mut symbols = SymbolTable::default();
        let name = |name: &str| SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() };
        let [x, asked] = ["x", "Q"].map(|text| symbols.intern(name(text)));
        let blank = ExpectedFormula::new(Expr::from(x), Arc::new(symbols), asked, vec![(x, 1.0, 2.0)]);
        let form = |samples: Vec<Vec<Option<f64>>>| ExpectedFormula { samples: samples.into(), ..blank.clone() };
        let answer = |number: i64| {
            let formula = Expr::from(x) * Expr::integer(number);
            FormulaAnswer { text: format!("{number}*x"), formula, shifted: Vec::new() }
        };
        let count = Cell::new(0);
        let judge = |expected: &ExpectedFormula, number: i64| {
            judged(expected, &answer(number), || {
                count.set(count.get() + 1);
                Judgement::of(Verdict::Wrong, Message::Wrong)
            });
            count.get()
        };
        let (one, other, none) = (form(vec![vec![Some(1.5)]]), form(vec![vec![Some(1.5)]]), form(Vec::new()));
        assert_eq!([judge(&one, 2), judge(&one, 2), judge(&one, 3), judge(&one, 3)], [1, 1, 2, 2]);
        assert_eq!([judge(&other, 2), judge(&other, 2)], [3, 3], "another form");
        assert_eq!([judge(&none, 2), judge(&none, 2)], [4, 5], "without samples");
        for number in 0..200 {
            judge(&one, number);
        }
        assert!(CACHE.with_borrow(Vec::len) <= MOST);
    }
}
