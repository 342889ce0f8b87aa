//! What we print, in whatever style, is read as what it was: every unit of the table, every writing of a number, either locale.

use momentous::grade::{Answer, DecimalMark, ExpectedKind, ExpectedNumber, Reading, read};
use momentous::quantity::{Decimal, Printed, Unit};
use proptest::prelude::*;

/// The unit in every style in which it is printed.
fn written_units(unit: &Unit) -> [String; 5] {
    [unit.to_string(), unit.unicode(), unit.latex(), unit.spoken(true), unit.spoken(false)]
}

/// The number in every style in which it is printed, with the mark of each locale.
fn written_numbers(printed: &Printed) -> Vec<(String, DecimalMark)> {
    let styles = [printed.plain(), printed.latex()];
    let with_comma = styles.clone().map(|text| (text.replace('.', ","), DecimalMark::Comma));
    styles.map(|text| (text, DecimalMark::Point)).into_iter().chain(with_comma).collect()
}

/// The first misreading of each kind.
fn shown(found: &[String]) -> String {
    let mut kinds: Vec<&str> = found.iter().map(|own| own.split_once(' ').map_or("", |(_, unit)| unit)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    kinds.truncate(60);
    kinds.join("\n")
}

/// Why what was printed is not read as itself; nothing where it is.
fn misread(printed: &Printed, unit: &Unit) -> Vec<String> {
    let asked = ExpectedKind::Number(ExpectedNumber::new(1.0, unit.clone()));
    let mut misread = Vec::new();
    for (number, mark) in written_numbers(printed) {
        for unit_text in written_units(unit) {
            let text = format!("{number} {unit_text}");
            let same = |text: &str| match read(text.trim(), &asked, mark) {
                Ok(Answer::Number(answer)) => {
                    let own = answer.unit.clone().unwrap_or_default();
                    let exact = *answer.number.value() == printed.to_decimal().to_rational();
                    let same = own.dimension() == unit.dimension() && own.factor() == unit.factor();
                    if exact && same { None } else { Some(format!("`{text}` as {answer:?}")) }
                }
                Ok(other) => Some(format!("`{text}` as {other:?}")),
                Err(fault) => Some(format!("`{text}`: {fault}")),
            };
            misread.extend(same(&text));
            // What is said to have been understood is printed, too.
            let told = Reading::of(&text, &asked, mark).map(|reading| reading.told).unwrap_or_default();
            misread.extend(same(&if mark == DecimalMark::Comma { told.replace('.', ",") } else { told }));
        }
    }
    misread
}

#[test]
fn every_unit_is_read_as_it_is_printed() {
    let numbers = [("3.10", 3), ("-0.4", 1), ("1234567", 4), ("0.0000421", 3), ("120", 3)];
    let printed: Vec<Printed> = numbers
        .iter()
        .map(|(text, figures)| Printed::exact(&Decimal::parse(text).expect("a number").to_rational(), *figures))
        .collect();
    let mut found = Vec::new();
    for unit in Unit::all() {
        for own in &printed {
            found.extend(misread(own, &unit));
        }
    }
    assert!(found.is_empty(), "{} are misread:\n{}", found.len(), shown(&found));
}

#[test]
fn products_and_powers_are_read_as_they_are_printed() {
    let printed = Printed::new(4.56, 3).expect("it is finite");
    let second = Unit::parse("s").expect("a unit");
    let mut found = Vec::new();
    // A name such as `miles per hour` cannot stand in a product: it would say something else.
    for unit in Unit::all().filter(|unit| !unit.spoken(true).contains(" per ")) {
        let made =
            [unit.times(&second), unit.per(&second), unit.per(&second).and_then(|own| own.per(&second)), unit.power(2)];
        for own in made.into_iter().flatten().filter(|own| !own.is_none()) {
            found.extend(misread(&printed, &own));
        }
    }
    assert!(found.is_empty(), "{} are misread:\n{}", found.len(), shown(&found));
}

proptest! {
    #[test]
    fn every_number_is_read_as_it_is_printed(value in prop::num::f64::NORMAL, figures in 1..12_usize) {
        prop_assume!(value.abs() > 1e-280 && value.abs() < 1e280);
        let printed = Printed::new(value, figures).expect("it is finite");
        let unit = Unit::parse("kg m/s").expect("a unit");
        let found = misread(&printed, &unit);
        prop_assert!(found.is_empty(), "{}", found.join("\n"));
    }
}
