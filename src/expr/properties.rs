//! Properties that hold for every term: tried on random ones.

use proptest::prelude::*;

use super::testing::AnyName;
use super::{Expr, Function, Leaf, LeafKind, Math, Operator, Symbol, equal};

const NAMES: [&str; 4] = ["a", "b", "c", "t"];

/// A table with the names, and their symbols.
fn table() -> (AnyName, Vec<Symbol>) {
    let mut names = AnyName::default();
    let symbols = NAMES.iter().map(|name| names.named(name)).collect();
    (names, symbols)
}

/// Rational terms, and terms with functions that are real wherever the symbols are positive.
fn terms(functions: bool) -> impl Strategy<Value = Expr> {
    let (_, symbols) = table();
    let number = (-6_i64..=6, 1_u32..=5).prop_map(|(above, below)| Expr::ratio(above, below));
    let symbol = proptest::sample::select(symbols).prop_map(Expr::Symbol);
    let leaf = prop_oneof![1 => number, 3 => symbol];
    leaf.prop_recursive(4, 20, 3, move |inner| {
        let several = proptest::collection::vec(inner.clone(), 2..4);
        let function = prop_oneof![Just(Function::Sin), Just(Function::Cos), Just(Function::Abs)];
        let applied = (function, inner.clone()).prop_map(|(function, argument)| Expr::apply(function, argument));
        let positive = inner.clone().prop_map(|term| (term.powi(2) + Expr::one()).sqrt());
        prop_oneof![
            3 => several.clone().prop_map(Expr::sum),
            3 => several.prop_map(Expr::product),
            1 => (inner.clone(), 2_i64..4).prop_map(|(base, power)| base.powi(power)),
            1 => (inner.clone(), inner.clone()).prop_map(|(above, below)| above / (below.powi(2) + Expr::one())),
            u32::from(functions) => prop_oneof![applied, positive],
        ]
    })
}

fn points() -> impl Strategy<Value = Vec<f64>> {
    proptest::collection::vec((1_i32..40).prop_map(|tenths| f64::from(tenths) / 10.0), NAMES.len())
}

fn close(left: f64, right: f64) -> bool {
    !left.is_finite() || (left - right).abs() <= 1e-6 * (1.0 + left.abs())
}

fn begins_with_minus(math: &Math) -> bool {
    match math {
        Math::Operator(operator) => *operator == Operator::Minus,
        Math::Row(parts) => parts.first().is_some_and(begins_with_minus),
        Math::Bracketed(inner) | Math::Squared(inner) => begins_with_minus(inner),
        _ => false,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn simplifying_keeps_the_value(term in terms(true), point in points()) {
        let value = |symbol: Symbol| point[symbol.index()];
        let simple = term.simplify();
        prop_assert!(close(term.evaluate(&value), simple.evaluate(&value)), "{}", simple.text(&table().0.0));
        prop_assert!(equal(&term, &simple), "{}", simple.text(&table().0.0));
    }

    #[test]
    fn simplifying_twice_changes_nothing(term in terms(true)) {
        let simple = term.simplify();
        prop_assert_eq!(simple.simplify().text(&table().0.0), simple.text(&table().0.0));
    }

    #[test]
    fn equal_terms_have_equal_values(left in terms(true), right in terms(true), point in points()) {
        let value = |symbol: Symbol| point[symbol.index()];
        if equal(&left, &right) {
            prop_assert!(close(left.evaluate(&value), right.evaluate(&value)));
        }
        prop_assert!(!equal(&left, &(left.clone() + Expr::one())) || left.evaluate(&value).is_nan());
        prop_assert!(equal(&(left.clone() * right.clone()), &(right * left)));
    }

    #[test]
    fn a_minus_is_seen_without_the_layout(term in terms(true)) {
        let name = |symbol: Symbol| Leaf { math: Math::Identifier(NAMES[symbol.index()].into()), kind: LeafKind::Name };
        prop_assert_eq!(term.begins_with_minus(), begins_with_minus(&term.layout(&name)), "{}", term.text(&table().0.0));
    }

    #[test]
    fn text_reads_back(term in terms(true)) {
        let (mut names, _) = table();
        let text = term.text(&names.0);
        prop_assume!(text.len() < super::MAX_LENGTH);
        let again = names.read(&text);
        prop_assert!(again.is_ok(), "{text}: {again:?}");
        let again = again.unwrap_or(Expr::integer(404));
        prop_assert!(equal(&again, &term), "{text}");
        // the first reading may fold numbers; from then on nothing changes
        let settled = again.text(&names.0);
        prop_assert_eq!(names.term(&settled).text(&names.0), settled);
    }

    #[test]
    fn a_derivative_is_a_slope(term in terms(true), point in points()) {
        let t = table().1[3];
        let at = |shift: f64| term.evaluate(&|symbol| point[symbol.index()] + if symbol == t { shift } else { 0.0 });
        let step = 1e-4;
        let slope = (at(step) - at(-step)) / (2.0 * step);
        let exact = term.differentiate(t).evaluate(&|symbol| point[symbol.index()]);
        let scale = 1.0 + slope.abs() + at(0.0).abs();
        // skip where the term bends too sharply for a difference to show its slope
        let other = (at(2.0 * step) - at(-2.0 * step)) / (4.0 * step);
        prop_assume!(exact.is_finite() && (slope - other).abs() < 1e-5 * scale);
        prop_assert!((slope - exact).abs() < 1e-3 * scale, "{slope} {exact}");
    }

    #[test]
    fn an_antiderivative_differentiates_back(term in terms(false), shape in 0..5, point in points()) {
        let t = table().1[3];
        let linear = Expr::Symbol(table().1[0]) + Expr::integer(2) * Expr::Symbol(t);
        let force = match shape {
            0 => term,
            1 => term * linear.sin(),
            2 => term * linear.cos(),
            3 => term * Expr::apply(Function::Exp, linear),
            _ => term * linear.power(Expr::ratio(-3, 2)),
        };
        if let Some(integral) = force.integrate(t) {
            let value = |symbol: Symbol| point[symbol.index()];
            let back = integral.differentiate(t);
            prop_assert!(close(force.evaluate(&value), back.evaluate(&value)) , "{}", integral.text(&table().0.0));
        }
    }

    #[test]
    fn coefficients_make_up_the_term(term in terms(false), point in points()) {
        let (_, symbols) = table();
        let value = |symbol: Symbol| point[symbol.index()];
        if let Some((coefficients, rest)) = term.linear_coefficients(&symbols[..2]) {
            let parts = coefficients.into_iter().zip(&symbols).map(|(part, symbol)| part * Expr::Symbol(*symbol));
            let sum = Expr::sum(parts.chain([rest]));
            prop_assert!(close(term.evaluate(&value), sum.evaluate(&value)));
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "[a-c0-9+*/^()., -]{0,40}") {
        if let Err(fault) = AnyName::default().read(&text) {
            prop_assert!(fault.start <= fault.end && fault.end <= text.len());
            prop_assert!(text.is_char_boundary(fault.start) && text.is_char_boundary(fault.end));
        }
    }
}
