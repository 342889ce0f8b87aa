//! Formulas that were judged before: many students of a class type the same one.

use std::cell::RefCell;
use std::sync::Arc;

use super::super::expected::ExpectedFormula;
use super::super::read::FormulaAnswer;
use super::Judgement;

/// So many are remembered before all are forgotten.
const MOST: usize = 64;

/// A formula that was judged, against what.
struct Known {
    expected: ExpectedFormula,
    answer: FormulaAnswer,
    judgement: Judgement,
}

thread_local! {
    static KNOWN: RefCell<Vec<Known>> = RefCell::default();
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
    let found = KNOWN.with_borrow(|known| known.iter().find(is_same).map(|known| known.judgement.clone()));
    found.unwrap_or_else(|| {
        let judgement = judge();
        KNOWN.with_borrow_mut(|known| {
            if known.len() >= MOST {
                known.clear();
            }
            known.push(Known { expected: expected.clone(), answer: answer.clone(), judgement: judgement.clone() });
        });
        judgement
    })
}
