//! Formulas against right ones, from a table: what agrees, what differs, and what cannot be told.

use std::path::Path;
use std::sync::Arc;

use momentous::expr::{Expr, Symbol, SymbolEntry, SymbolTable};
use momentous::grade::{Answer, DecimalMark, Expected, ExpectedFormula, ExpectedKind, judge, read};
use momentous::quantity::{Dimension, Unit};

/// What is expected where these names are given (`v:m/s:1:20`), and this formula is right.
pub(super) fn expected(names: &str, right: &str) -> Expected {
    readable(names, right).unwrap_or_else(|answer| panic!("{right}: {answer}"))
}

/// The same, or how the formula is read that is none with these names.
pub(super) fn readable(names: &str, right: &str) -> Result<Expected, String> {
    let mut symbols = SymbolTable::default();
    let mut add = |name: &str, dimension| {
        symbols.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() })
    };
    let letter = |name: &str| {
        let parts: Vec<&str> = name.split(':').collect();
        let end = |place: usize, usual: f64| parts.get(place).map_or(usual, |end| end.parse().unwrap());
        let unit = Unit::parse(parts.get(1).unwrap_or(&"")).unwrap();
        (add(parts[0], unit.dimension()), end(2, 1.0), end(3, 2.0))
    };
    let domain: Vec<(Symbol, f64, f64)> = names.split(' ').map(letter).collect();
    let asked = add("Q_asked", Dimension::NONE);
    let blank = ExpectedFormula::new(Expr::one(), Arc::new(symbols), asked, domain);
    let formula = match read(right, &ExpectedKind::Formula(blank.clone()), DecimalMark::Point) {
        Ok(Answer::Formula(answer)) => answer.formula,
        other => return Err(format!("{other:?}")),
    };
    let dimension = formula.dimension(&blank.symbols).unwrap();
    let kind = ExpectedKind::Formula(ExpectedFormula { formula, dimension, ..blank });
    Ok(Expected { id: "Q".to_owned(), points: 1, kind })
}

/// The verdict on an answer.
pub(super) fn verdict(expected: &Expected, answer: &str) -> &'static str {
    match read(answer, &expected.kind, DecimalMark::Point) {
        Ok(answer) => judge(expected, &answer).verdict.code(),
        Err(fault) => fault.kind.code(),
    }
}

#[test]
fn formulas_are_judged_as_the_table_says() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/answers/formulas_judged.csv");
    let mut rows = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).unwrap();
    let mut wrong = Vec::new();
    for row in rows.records().map(Result::unwrap) {
        let found = verdict(&expected(&row[0], &row[1]), &row[2]);
        if found != &row[3] {
            wrong.push(format!("{} for {}: {found}, not {}", &row[2], &row[1], &row[3]));
        }
    }
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}
