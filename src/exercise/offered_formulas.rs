//! Formulas to choose from: the right one, and what usual mistakes lead to.

use momentous_expr::Expr;
use momentous_expr::Leaf;
use momentous_expr::LeafKind;
use momentous_grade as grade;
use momentous_grade::ExpectedKind;
use momentous_problem::FormulaPart;
use momentous_problem::Part;

use super::Exercise;
use super::diagnosis::hints_on;
use super::item::FormulaItem;

impl Exercise {
    /// The formulas to which usual mistakes lead, each once, with its feedback; none of them is right.
    pub(super) fn mistaken_formulas(&self, part: &Part, formula: &FormulaPart) -> Vec<(FormulaItem, String)> {
        let worked = self.worked();
        let symbols = &self.problem.notation().table(&self.problem.model().symbols);
        let ExpectedKind::Formula(right) = self.expected(part).kind else { return Vec::new() };
        let leaf = |symbol| Leaf { math: self.problem.math_of(symbol), kind: LeafKind::Name };
        let mut offered = vec![right.formula.clone()];
        let mut all: Vec<(FormulaItem, String)> = Vec::new();
        for mistake in worked.mistakes() {
            for wrong in worked.mistaken_formulas(mistake, formula.symbol) {
                if offered.iter().any(|listed| *listed == wrong || is_same(&right, listed, &wrong)) {
                    continue;
                }
                let said = hints_on(worked, &[mistake]).into_iter().next().unwrap_or_default();
                all.push((FormulaItem { text: wrong.text(symbols), math: Some(wrong.layout(&leaf)) }, said));
                offered.push(wrong);
            }
        }
        all
    }
}

/// Whether two formulas are marked alike where this one is right: as functions over the problem's range they are one.
fn is_same(right: &grade::ExpectedFormula, one: &Expr, other: &Expr) -> bool {
    let dimension = one.dimension(&right.symbols).unwrap_or(right.dimension);
    let expected = grade::ExpectedFormula { formula: one.clone(), dimension, ..right.clone() };
    let expected = grade::Expected { id: String::new(), points: 0, kind: ExpectedKind::Formula(expected) };
    let answer = grade::FormulaAnswer { text: String::new(), formula: other.clone(), shifted: Vec::new() };
    grade::judge(&expected, &grade::Answer::Formula(answer)).verdict.is_right()
}
