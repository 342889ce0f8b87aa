//! Parts that are answered by a formula: on the sheet, in the key, as JSON, and what marking expects.

use std::sync::Arc;

use serde_json::Value;
use serde_json::json;

use momentous_explain as explain;
use momentous_explain::Inline;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_grade as grade;
use momentous_problem::FormulaPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::Sign;
use momentous_problem::Text;
use momentous_problem::Worked;
use momentous_quantity::Dimension;

use super::Exercise;

impl Exercise {
    /// The question, with the symbols in which it is answered.
    pub(super) fn formula_on_sheet(&self, part: &Part, formula: &FormulaPart) -> Vec<Inline> {
        let name = |symbol: Symbol| Inline::Math(self.problem.math_of(symbol));
        let mut text = Inline::line(&format!("Find {}, ", part.label));
        text.push(name(formula.symbol));
        let letters = self.letters(formula);
        for (index, letter) in letters.iter().enumerate() {
            let joint = match index {
                0 => ", in terms of ",
                _ if index + 1 == letters.len() => " and ",
                _ => ", ",
            };
            text.extend([Inline::Text(joint.into()), name(*letter)]);
        }
        let is_first = self.worked().form.parts.iter().find(|part| matches!(part.kind, PartKind::Formula(_)));
        if is_first.is_some_and(|first| first.id == part.id) {
            let unnamed = letters.into_iter().filter(|letter| self.is_printed_without_its_letter(*letter));
            for (index, letter) in unnamed.enumerate() {
                let joint = if index == 0 { ", where " } else { ", and " };
                let meaning = &self.problem.model().symbols.entry(letter).meaning;
                text.extend([Inline::Text(joint.into()), name(letter), Inline::Text(format!(" is {meaning}"))]);
            }
        }
        text.push(Inline::Text(".".into()));
        text
    }

    /// Whether the text prints the value of a quantity, and never what the quantity is called.
    fn is_printed_without_its_letter(&self, symbol: Symbol) -> bool {
        let texts = [&self.problem.loaded().draft.text, &self.worked().form.question.text];
        let model = self.problem.model();
        let placeholders = texts.into_iter().flat_map(Text::placeholders);
        let mut placeholders =
            placeholders.filter(|placeholder| model.symbol_of(&placeholder.name) == Some(symbol)).peekable();
        placeholders.peek().is_some() && !placeholders.any(|placeholder| placeholder.filter.names())
    }

    /// The symbols in which an answer is written: that of which it is a multiple first, then all that are given.
    pub(super) fn letters(&self, formula: &FormulaPart) -> Vec<Symbol> {
        let given = self.worked().alphabet().letters.into_iter().map(|(symbol, ..)| symbol);
        formula.in_terms_of.into_iter().chain(given.filter(|symbol| Some(*symbol) != formula.in_terms_of)).collect()
    }

    /// A formula as a student may type it.
    pub(super) fn printed_formula(&self, part: &FormulaPart) -> String {
        let formula = self.worked().formula(part);
        let symbols = || self.problem.notation().table(&self.problem.model().symbols);
        formula.map_or_else(|| "not defined".into(), |formula| formula.text(&symbols()))
    }

    pub(super) fn formula_record(&self, part: &Part, formula: &FormulaPart) -> Value {
        let name = |symbol: Symbol| self.problem.model().symbols.entry(symbol).name.clone();
        let letters: Vec<String> =
            self.letters(formula).into_iter().map(|symbol| self.problem.name_of(symbol)).collect();
        let math = explain::printed_formula(self.worked(), formula);
        json!({
            "id": part.id,
            "kind": "formula",
            "find": name(formula.symbol),
            "value": self.printed_formula(formula),
            "latex": math.map(|math| math.latex()),
            "symbols": letters,
            "printed": self.printed_formula(formula),
            "points": part.points,
        })
    }
}

/// The right answer to a formula.
pub(super) fn expected_formula(worked: Worked<'_>, part: &FormulaPart) -> grade::ExpectedKind {
    let mut alphabet = worked.alphabet();
    if let Some(unit) = part.in_terms_of
        && !alphabet.letters.iter().any(|(listed, ..)| *listed == unit)
        && let Some(value) = worked.in_givens(unit, &alphabet.values)
    {
        alphabet.values.insert(unit, value);
    }
    let formula = worked.in_givens(part.symbol, &alphabet.values);
    let symbols = &worked.problem.model().symbols;
    let formula = formula.unwrap_or_else(|| Expr::from(part.symbol));
    let table = Arc::new(worked.problem.notation().table(symbols));
    let givens: Vec<Symbol> = alphabet.letters.iter().map(|(symbol, ..)| *symbol).collect();
    let value = worked.variant.value(part.symbol).map(|number| number.value);
    let sign = worked.problem.sign(part.symbol);
    grade::ExpectedKind::Formula(grade::ExpectedFormula {
        value: value.filter(|_| symbols.entry(part.symbol).dimension == Dimension::NONE),
        signed: sign != Sign::Nothing || value.is_none_or(|value| value < 0.0),
        directed: matches!(sign, Sign::Sense(_)),
        samples: worked.samples(&givens),
        values: alphabet.values.into_iter().collect(),
        multiple_of: part.in_terms_of.filter(|unit| symbols.entry(*unit).dimension != Dimension::NONE),
        ..grade::ExpectedFormula::new(formula, table, part.symbol, alphabet.letters)
    })
}
