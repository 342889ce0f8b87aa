//! Reading vectors, directions, formulas, intervals and several values, against tables of what people type and what it means.

use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use momentous::expr::{Expr, Symbol, SymbolEntry, SymbolTable};
use momentous::grade::{
    DecimalMark, ExpectedEnd, ExpectedFormula, ExpectedInterval, ExpectedKind, ExpectedNumber, ExpectedVector, Frame,
    FrameAxis, Reference, read, read_several,
};
use momentous::quantity::{Dimension, Unit};

fn unit(text: &str) -> Unit {
    Unit::parse(text).unwrap()
}

fn frame(name: &str) -> Frame {
    let axis = |letter, plus: &str, minus: &str| FrameAxis { letter, senses: [plus.to_owned(), minus.to_owned()] };
    let axes = match name {
        "plane" => vec![axis('x', "to the right", "to the left"), axis('y', "upwards", "downwards")],
        "compass" => vec![axis('x', "east", "west"), axis('y', "north", "south")],
        "contact" => vec![axis('n', "along n", "against n"), axis('t', "along t", "against t")],
        "space" => {
            let flat = [axis('x', "east", "west"), axis('y', "north", "south")];
            flat.into_iter().chain([axis('z', "upwards", "downwards")]).collect()
        }
        other => panic!("no frame: {other}"),
    };
    Frame { axes }
}

/// A vector in a frame, in m/s if no other unit is said: `plane in N s`.
fn vector(name: &str) -> ExpectedKind {
    let (name, own) = name.split_once(" in ").unwrap_or((name, "m/s"));
    let frame = frame(name);
    let components = frame.axes.iter().map(|_| ExpectedNumber::new(1.0, unit(own))).collect();
    ExpectedKind::Vector(ExpectedVector { components, frame })
}

fn heading(counted: &str) -> ExpectedKind {
    let (quarters, clockwise) = match counted {
        "east" => (0, false),
        "north-clockwise" => (1, true),
        other => panic!("not counted so: {other}"),
    };
    let reference = Some(Reference { frame: frame("compass"), quarters, clockwise });
    ExpectedKind::Number(ExpectedNumber { reference, cyclic: true, ..ExpectedNumber::new(1.0, unit("°")) })
}

/// The names that formulas may contain, with their dimensions.
const NAMES: [(&str, Dimension); 9] = [
    ("m_A", Dimension::MASS),
    ("m_B", Dimension::MASS),
    ("v_A1", Dimension::VELOCITY),
    ("v_B1", Dimension::VELOCITY),
    ("e", Dimension::NONE),
    ("g", Dimension::ACCELERATION),
    ("h", Dimension::LENGTH),
    ("theta", Dimension::NONE),
    ("mu_k", Dimension::NONE),
];

fn formula() -> ExpectedKind {
    let mut symbols = SymbolTable::default();
    let mut add = |name: &str, dimension| {
        symbols.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() })
    };
    let domain: Vec<(Symbol, f64, f64)> = NAMES.map(|(name, dimension)| (add(name, dimension), 1.0, 2.0)).to_vec();
    let asked = add("v_B2", Dimension::VELOCITY);
    let formula = Expr::from(domain[2].0);
    ExpectedKind::Formula(ExpectedFormula::new(formula, Arc::new(symbols), asked, domain))
}

/// A formula in other names: `m_A:kg e`, each with a unit of its dimension.
fn formula_among(names: &str) -> ExpectedKind {
    let mut symbols = SymbolTable::default();
    let mut add = |name: &str, dimension| {
        symbols.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() })
    };
    let name = |name: &str| {
        let (name, own) = name.split_once(':').unwrap_or((name, ""));
        (add(name, unit(own).dimension()), 1.0, 2.0)
    };
    let domain: Vec<(Symbol, f64, f64)> = names.split(' ').map(name).collect();
    let asked = add("Q_asked", Dimension::NONE);
    let formula = Expr::from(domain[0].0);
    ExpectedKind::Formula(ExpectedFormula::new(formula, Arc::new(symbols), asked, domain))
}

/// An interval of e, or of a name with its unit: `v_A2:m/s`.
fn interval(of: &str) -> ExpectedKind {
    let (name, own) = of.split_once(':').unwrap_or(("e", ""));
    let end =
        |value, closed| Some(ExpectedEnd { number: ExpectedNumber::new(value, unit(own)), closed, is_limit: false });
    let (name, unit) = (name.to_owned(), unit(own));
    ExpectedKind::Interval(Box::new(ExpectedInterval { name, low: end(0.0, false), high: end(0.5, true), unit }))
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

/// Compares each row of a table with what is found of its other columns.
fn check(name: &str, least: usize, found: impl Fn(&[&str]) -> String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/answers").join(name);
    let text = fs::read_to_string(path).unwrap();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.unwrap()).collect();
    let mut wrong = Vec::new();
    for row in &rows {
        let cells: Vec<&str> = row.iter().collect();
        let (expected, given) = cells.split_last().unwrap();
        let found = found(given);
        if found != *expected {
            wrong.push(format!("{given:?}\t{found}\tnot {expected}"));
        }
    }
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
    assert!(rows.len() >= least, "{name} has only {} rows", rows.len());
}

#[test]
fn vectors_are_read_as_the_table_says() {
    check("vectors.csv", 110, |row| outcome(row[2], &vector(row[0]), mark(row[1])));
}

#[test]
fn directions_are_read_as_the_table_says() {
    check("headings.csv", 30, |row| outcome(row[2], &heading(row[0]), mark(row[1])));
}

#[test]
fn formulas_are_read_as_the_table_says() {
    let asked = formula();
    check("formulas.csv", 110, |row| outcome(row[0], &asked, DecimalMark::Either));
}

#[test]
fn formulas_in_other_names_are_read_as_the_table_says() {
    check("formulas_among.csv", 250, |row| outcome(row[1], &formula_among(row[0]), DecimalMark::Point));
}

#[test]
fn intervals_are_read_as_the_table_says() {
    check("intervals.csv", 50, |row| outcome(row[2], &interval(row[0]), mark(row[1])));
}

#[test]
fn several_values_are_read_as_the_table_says() {
    check("several.csv", 15, |row| read_several(row[0]).join(" | "));
}

#[test]
fn hostile_answers_of_every_kind_are_answered_at_once() {
    let kinds = [vector("plane"), heading("east"), formula(), interval("")];
    let pieces = [
        "(",
        "[",
        "<",
        "1,",
        "i",
        "-",
        "@",
        "at ",
        "N ",
        "° ",
        "m_A",
        "mA",
        "^",
        "sqrt(",
        "e",
        "|",
        "/",
        "≤",
        " and ",
        "sin ",
        "{",
        "\\",
        "(m_A+m_B)*",
    ];
    for piece in pieces {
        for length in [10_000, 999, 200] {
            let text: String = piece.chars().cycle().take(length).collect();
            for kind in &kinds {
                let timed = || {
                    let start = Instant::now();
                    let _ = read(&text, kind, DecimalMark::Either);
                    start.elapsed()
                };
                // A build without optimisation; the bound of a release build is a millisecond. A busy machine delays any one reading.
                let bound = Duration::from_millis(100);
                let is_quick = (0..5).any(|_| timed() < bound);
                assert!(is_quick, "{piece} {length}: five readings took more than {bound:?} each");
            }
        }
    }
}
