//! Mistakes about relations that the problem states.

use momentous_expr::Expr;
use momentous_quantity::Dimension;

use super::Misconception;
use super::Taught;
use super::Wrong;
use super::WrongForm;
use super::rewrite::factors;
use super::rewrite::terms;

/// `A = B + d` for `B = A + d`, `A = 2 B` for `B = 2 A`.
pub const TURNED_ROUND: Misconception = Misconception {
    id: "relation-turned-round",
    does: "turns a stated relation round: the larger of two quantities becomes the smaller one",
    ask: "Which of the two quantities that the problem compares is the larger one?",
    hint: "Put simple numbers into your relation, and read the sentence of the problem with them.",
};

/// Wrong forms of a relation that the problem states.
pub const STATED: &[WrongForm] = &[WrongForm { of: &TURNED_ROUND, write: turned_round }];

/// A single quantity that is another one and something, or a multiple of another one.
fn turned_round(law: &Taught<'_>) -> Vec<Wrong> {
    let Expr::Symbol(compared) = law.sides.0 else { return Vec::new() };
    let dimension = law.symbols.entry(compared).dimension;
    let alike =
        |term: &Expr| matches!(term, Expr::Symbol(symbol) if law.is(*symbol, dimension) && !law.known.contains(symbol));
    let (kept, rest): (Vec<Expr>, Vec<Expr>) = terms(&law.sides.1).into_iter().partition(alike);
    if let ([kept], false) = (&kept[..], rest.is_empty()) {
        return vec![Wrong::from((law.left(), kept.clone() - Expr::sum(rest)))];
    }
    let is_other = |factor: &Expr| matches!(factor, Expr::Symbol(symbol) if law.is(*symbol, dimension));
    let (other, times): (Vec<Expr>, Vec<Expr>) = factors(&law.sides.1).into_iter().partition(is_other);
    let is_plain = times.iter().flat_map(Expr::symbols).all(|symbol| law.is(symbol, Dimension::NONE));
    match &other[..] {
        [other] if is_plain && !times.is_empty() => {
            vec![Wrong::from((law.left() * Expr::product(times), other.clone()))]
        }
        _ => Vec::new(),
    }
}
