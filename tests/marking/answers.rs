//! Reading answers, against tables of what people type and what it means.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use momentous::grade::{Called, DecimalMark, ExpectedKind, ExpectedNumber, Multiple, read};
use momentous::quantity::{Dimension, Printed, Unit, UnitSystem, coherent_unit};
use proptest::prelude::*;

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/answers").join(name)
}

/// A number in a unit, or `of` a quantity, with the units of the multiple and of the product where there are such.
fn number(unit: &str, senses: &str) -> ExpectedKind {
    let multiple_of = unit.strip_prefix("of ").map(|own| {
        let (name, units) = own.split_once(": ").map_or((own, None), |(name, units)| (name, Some(units)));
        let units = units.and_then(|units| units.split_once(" and "));
        let units = units.map(|(own, product)| [own, product].map(|unit| Unit::parse(unit).unwrap()));
        Multiple { name: name.to_owned(), units }
    });
    let unit = if multiple_of.is_some() { "" } else { unit };
    let called = multiple_of.map(|own| {
        Arc::new(Called { name: String::new(), axis: None, in_space: None, motion: None, multiple_of: Some(own) })
    });
    let senses = senses.split_once(" | ").map(|(plus, minus)| [plus.to_owned(), minus.to_owned()]);
    let unit = Unit::parse(unit).unwrap_or_else(|fault| panic!("{unit}: {fault}"));
    ExpectedKind::Number(ExpectedNumber { senses, called, ..ExpectedNumber::new(1.0, unit) })
}

fn mark(name: &str) -> DecimalMark {
    match name {
        "" => DecimalMark::Either,
        "point" => DecimalMark::Point,
        "comma" => DecimalMark::Comma,
        other => panic!("no decimal mark: {other}"),
    }
}

/// `= ` and what was understood, or `! `, the character and the code of the fault.
fn outcome(text: &str, asked: &ExpectedKind, mark: DecimalMark) -> String {
    match read(text, asked, mark) {
        Ok(answer) => format!("= {}", answer.echo()),
        Err(fault) => format!("! {} {}", fault.at, fault.kind.code()),
    }
}

/// The rows of a table whose texts may write characters as `\u{2212}`.
fn rows(name: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(fixture(name)).unwrap();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let row = |row: csv::StringRecord| row.iter().map(unescaped).collect();
    reader.records().map(|record| row(record.unwrap())).collect()
}

fn unescaped(text: &str) -> String {
    let mut parts = text.split("\\u{");
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (code, rest) = part.split_once('}').unwrap();
        plain.push(char::from_u32(u32::from_str_radix(code, 16).unwrap()).unwrap());
        plain.push_str(rest);
    }
    plain
}

#[test]
fn numbers_are_read_as_the_table_says() {
    let rows = rows("numbers.csv");
    let mut wrong = Vec::new();
    for row in &rows {
        let [text, unit, senses, mark_name, expected] = row.as_slice() else { panic!("{row:?}: five columns") };
        let found = outcome(text, &number(unit, senses), mark(mark_name));
        if found != *expected {
            wrong.push(format!("{text:?} ({unit}, {senses}, {mark_name}): {found}, not {expected}"));
        }
    }
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
    assert!(rows.len() >= 250, "only {} rows", rows.len());
}

#[test]
fn choices_are_read_as_the_table_says() {
    for row in rows("choices.csv") {
        let [text, options, expected] = row.as_slice() else { panic!("{row:?}: three columns") };
        let options = options.split(" | ").map(str::to_owned).collect();
        let asked = ExpectedKind::Choice { question: String::new(), options, right: 0, because: String::new() };
        assert_eq!(outcome(text, &asked, DecimalMark::Point), *expected, "{text}");
    }
}

#[test]
fn hostile_answers_are_answered_at_once() {
    let hostile = [
        "(",
        "9^",
        "-",
        "sqrt(",
        "1 000 ",
        "1/",
        "9",
        ",",
        ".",
        "{",
        "\\mathrm{",
        "left ",
        "N ",
        "←",
        "e",
        "2π",
        "1e400*",
        "=",
        "√",
        "\u{200b}",
    ];
    for piece in hostile {
        for text in [piece.repeat(10_000 / piece.len()), piece.chars().cycle().take(200).collect::<String>()] {
            let start = Instant::now();
            let _ = read(&text, &number("m/s", "to the right | to the left"), DecimalMark::Either);
            let _ = read(
                &text,
                &ExpectedKind::Choice {
                    question: String::new(),
                    options: vec!["a".into()],
                    right: 0,
                    because: String::new(),
                },
                DecimalMark::Point,
            );
            // A build without optimisation, on a busy machine; the bound of a release build is a millisecond.
            assert!(
                start.elapsed() < Duration::from_millis(100),
                "{:?}: {:?}",
                &text[..20.min(piece.len())],
                start.elapsed()
            );
        }
    }
}

const DIMENSIONS: [Dimension; 10] = [
    Dimension::NONE,
    Dimension::MASS,
    Dimension::LENGTH,
    Dimension::TIME,
    Dimension::VELOCITY,
    Dimension::ACCELERATION,
    Dimension::FORCE,
    Dimension::MOMENTUM,
    Dimension::ENERGY,
    Dimension::ANGULAR_MOMENTUM,
];

proptest! {
    #[test]
    fn what_we_print_is_read_as_itself(
        value in prop::num::f64::NORMAL.prop_filter("of a size that is printed", |value| (1e-250..1e250).contains(&value.abs())),
        near in -1e7..1e7_f64,
        figures in 1..12_usize,
        dimension in 0..DIMENSIONS.len(),
        us in any::<bool>(),
        comma in any::<bool>(),
    ) {
        let system = if us { UnitSystem::Us } else { UnitSystem::Si };
        let unit = coherent_unit(DIMENSIONS[dimension], system);
        let asked = number(&unit.to_string(), "");
        for value in [value, near] {
            let printed = Printed::new(value, figures).unwrap();
            let attached = if unit.is_none() { "" } else { " " };
            for (number, unit_text) in [
                (printed.plain(), unit.to_string()),
                (printed.plain().replace('-', "\u{2212}"), unit.unicode()),
                (printed.latex(), unit.latex()),
            ] {
                let number = if comma { number.replace('.', ",") } else { number };
                let mark = if comma { DecimalMark::Comma } else { DecimalMark::Point };
                let text = format!("{number}{attached}{unit_text}");
                let answer = read(&text, &asked, mark);
                let Ok(momentous::grade::Answer::Number(answer)) = answer else {
                    return Err(TestCaseError::fail(format!("{text}: {answer:?}")));
                };
                prop_assert_eq!(answer.number.value().into_owned(), printed.to_decimal().to_rational(), "{}", text);
                prop_assert_eq!(answer.unit.unwrap_or_default(), unit.clone(), "{}", text);
            }
        }
    }

    #[test]
    fn no_text_makes_reading_panic(text in "[0-9a-z .,+*/^(){}°√π×−<>_'-]{0,40}|\\PC{0,40}") {
        for mark in [DecimalMark::Either, DecimalMark::Point, DecimalMark::Comma] {
            if let Err(fault) = read(&text, &number("m/s", "up | down"), mark) {
                prop_assert!(fault.at <= text.chars().count());
            }
        }
    }
}
