//! Random formulas: written in another way they stay right, and changed they become wrong.

use momentous::grade::{DecimalMark, read};
use proptest::prelude::*;

use super::judged::{readable, verdict};

const NAMES: &str = "a b c:1:3 t:1:2";

/// A formula, and the same function in other words.
fn pairs() -> impl Strategy<Value = (String, String)> {
    let name = proptest::sample::select(vec!["a", "b", "c", "t"]);
    let number = (1_u32..9).prop_map(|number| number.to_string());
    let leaf = prop_oneof![3 => name.prop_map(str::to_owned), 1 => number].prop_map(|leaf| (leaf.clone(), leaf));
    leaf.prop_recursive(4, 12, 2, |inner| {
        let two = (inner.clone(), inner.clone(), 0..8_usize);
        let one = (inner, 0..6_usize);
        prop_oneof![
            two.prop_map(|(left, right, way)| joined(&left, &right, way)),
            one.prop_map(|(own, way)| turned(&own, way))
        ]
    })
}

type Pair = (String, String);

fn joined((a, other_a): &Pair, (b, other_b): &Pair, way: usize) -> Pair {
    match way {
        0 => (format!("({a}) + ({b})"), format!("({other_b}) + ({other_a})")),
        1 => (format!("({a})*({b})"), format!("({other_b})({other_a})")),
        2 => (format!("({a})/({b})"), format!("\\frac{{{other_a}}}{{{other_b}}}")),
        3 => (format!("(({a}) + ({b}))^2"), format!("({other_a})² + 2({other_a})({other_b}) + ({other_b})²")),
        4 => (format!("({a}) - ({b})"), format!("-(({other_b}) - ({other_a}))")),
        5 => (format!("sqrt(({a})^2)*({b})"), format!("|{other_a}|\\cdot({other_b})")),
        6 => (format!("1/({a}) + 1/({b})"), format!("(({other_a})+({other_b}))/(({other_a})*({other_b}))")),
        _ => (format!("2 ({a}) ({b})"), format!("({other_a}) ({other_b})/0.5")),
    }
}

fn turned((own, other): &Pair, way: usize) -> Pair {
    match way {
        0 => (own.clone(), format!("({other})^2/({other})")),
        1 => (format!("({own})^3"), format!("({other})*({other})**2")),
        2 => (own.clone(), format!("½({other}) + ({other})/2")),
        3 => (format!("sin(({own})*t)"), format!("cos(90° - t({other}))")),
        4 => (format!("exp(-t)*({own})"), format!("({other})/e^t")),
        _ => (own.clone(), format!("({other}) + t - t")),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn what_is_written_in_another_way_is_right((own, other) in pairs()) {
        let expected = readable(NAMES, &own);
        prop_assume!(expected.is_ok());
        let expected = expected.unwrap();
        prop_assume!(read(&other, &expected.kind, DecimalMark::Point).is_ok());
        let found = verdict(&expected, &other);
        // A division by nothing, or a formula that is zero without a proof.
        prop_assume!(found != "unreadable");
        prop_assert!(found.starts_with("right"), "{} for {}: {}", other, own, found);
    }

    #[test]
    fn what_is_changed_is_not_right((own, other) in pairs(), change in 0..6_usize) {
        let changed = match change {
            0 => format!("({other}) + a/1000000"),
            1 => format!("({other})*(1 + t/1000000000)"),
            2 => format!("({other}) + sin(1024 pi t)/1000"),
            3 => format!("({other}) + exp(-50)"),
            4 => format!("-({other}) - t"),
            _ => format!("({other}) + (a-1.25)(b-1.5)(c-1.75)(t-1.5)/1000"),
        };
        let expected = readable(NAMES, &own);
        prop_assume!(expected.is_ok());
        let expected = expected.unwrap();
        // A multiple of nothing is nothing.
        prop_assume!(change != 1 || !verdict(&expected, "0").starts_with("right"));
        prop_assert!(!verdict(&expected, &changed).starts_with("right"), "{} for {}", changed, own);
    }
}
