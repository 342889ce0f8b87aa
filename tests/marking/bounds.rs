//! Whatever is typed is answered at once: its length, its parts and its nesting are bounded before anything is worked out. How long the
//! worst cases take is measured by `cargo bench --bench marking`; here their work is counted.

use std::sync::Arc;

use momentous::expr::{Expr, SymbolEntry, SymbolTable};
use momentous::grade::{
    DecimalMark, ExpectedFormula, ExpectedInterval, ExpectedKind, ExpectedNumber, ExpectedVector, Frame, FrameAxis,
    read,
};
use momentous::quantity::{Dimension, Unit};

fn number() -> ExpectedNumber {
    let senses = Some(["to the right".to_owned(), "to the left".to_owned()]);
    ExpectedNumber { senses, ..ExpectedNumber::new(1.0, Unit::parse("m/s").expect("a unit")) }
}

fn formula() -> ExpectedKind {
    let mut symbols = SymbolTable::default();
    let entry = |name: &str| SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() };
    let [a, b, asked] = ["a", "b", "x"].map(|name| symbols.intern(entry(name)));
    let formula = Expr::from(a) + Expr::from(b);
    let domain = vec![(a, 1.0, 3.0), (b, 2.0, 5.0)];
    ExpectedKind::Formula(ExpectedFormula::new(formula, Arc::new(symbols), asked, domain))
}

/// Every kind of part, with the most characters that are read.
fn kinds() -> Vec<(ExpectedKind, usize)> {
    let axis = |letter| FrameAxis { letter, senses: ["plus".to_owned(), "minus".to_owned()] };
    let frame = Frame { axes: vec![axis('x'), axis('y')] };
    let options = ["conserved", "not conserved"].map(str::to_owned).to_vec();
    let interval = ExpectedInterval { name: "e".to_owned(), low: None, high: None, unit: Unit::none() };
    vec![
        (ExpectedKind::Number(number()), 200),
        (ExpectedKind::Vector(ExpectedVector { components: vec![number(), number()], frame }), 200),
        (ExpectedKind::Interval(Box::new(interval)), 200),
        (ExpectedKind::Choice { question: String::new(), options, right: 0, because: String::new() }, 200),
        (formula(), 1000),
    ]
}

#[test]
fn ten_thousand_characters_are_refused_at_the_limit() {
    for text in ["9", "(", "9^9", "-", "sqrt(2)*", "left ", "m kg/s ", "a+b*", "\\cdot{", "é", "±", "1,2;"] {
        let long: String = text.chars().cycle().take(10_000).collect();
        for (kind, most) in kinds() {
            let fault = read(&long, &kind, DecimalMark::Point).expect_err("it is too long");
            assert_eq!((fault.kind.code(), fault.at), ("too_long", most), "{text}");
        }
    }
}

fn code(text: &str, kind: &ExpectedKind) -> String {
    read(text, kind, DecimalMark::Point).map_or_else(|fault| fault.kind.code().to_owned(), |_| "read".to_owned())
}

#[test]
fn a_calculation_has_few_parts() {
    let kind = ExpectedKind::Number(number());
    let sum = |parts: usize| format!("1{} m/s", "+1".repeat(parts - 1));
    assert_eq!(code(&sum(60), &kind), "read");
    assert_eq!(code(&sum(61), &kind), "too_many_parts");
    assert_eq!(code(&format!("{}1{}", "(".repeat(17), ")".repeat(17)), &kind), "too_deep");
    // No number grows beyond a few thousand binary digits, whatever is done with it.
    for text in ["9^9^9", "9^9999", "(9^2000)^2", "9^2000*9^2000", "(1/3)^2000*(1/7)^2000"] {
        assert_eq!(code(text, &kind), "too_large", "{text}");
    }
}

#[test]
fn a_formula_has_at_most_two_hundred_parts_and_few_functions() {
    let kind = formula();
    let sum = |terms: usize| format!("a{}", "+b".repeat(terms - 1));
    assert_eq!(code(&sum(60), &kind), "read");
    assert_eq!(code(&sum(201), &kind), "too_many_parts");
    assert_eq!(code(&format!("a{}", "+arctan(b)".repeat(9)), &kind), "too_many_parts");
    assert_eq!(code(&format!("{}a{}", "(".repeat(25), ")".repeat(25)), &kind), "too_deep");
    assert_ne!(code("(a+b)^65", &kind), "read");
}
