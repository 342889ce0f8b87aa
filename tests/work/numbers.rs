//! Lines with numbers in the place of letters: as they are given, or worked out to four figures.

use std::collections::BTreeSet;

use momentous::exercise::Exercise;
use momentous::expr::Symbol;
use momentous::grade::{DecimalMark, half_of_last_place};
use momentous::problem::Given;
use momentous::quantity::{Dimension, UnitSystem, coherent_unit};
use momentous::work::{Judge, Verdict};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

use super::algebra::{Sides, equations, is_typed, rearranged};
use super::consequences::{FEW, LONGEST, MANY, Size};
use super::solutions::each;

/// Figures of what was worked out.
const FIGURES: i32 = 4;
/// A slip changes a number by a larger share than this, which is more than ten times its rounding.
const LEAST_SLIP: f64 = 0.02;
const MOST_SLIP: f64 = 0.3;
/// A value that is written as a result may be off by this share, as by two significant figures.
const RESULT: f64 = 0.006;

/// A number of a line: what it stands for, its value as it is written in SI units, and how far it may be rounded.
struct Number {
    symbol: Symbol,
    text: String,
    value: f64,
    half: f64,
    is_given: bool,
}

/// A line with its numbers.
struct Line {
    text: String,
    sides: Sides,
    numbers: Vec<Number>,
}

impl Number {
    /// A value with four figures in SI units.
    #[allow(clippy::cast_possible_truncation, reason = "the power of ten of a value of a scene")]
    fn computed(symbol: Symbol, value: f64, dimension: Dimension) -> Self {
        let decimals = FIGURES - 1 - value.abs().log10().floor() as i32;
        let last = 10_f64.powi(-decimals);
        let text = format!("{:.*}", usize::try_from(decimals).unwrap_or(0), (value / last).round() * last);
        let value: f64 = text.parse().unwrap();
        // Numbers without decimals may be rounded to fewer figures than they show.
        let half = if decimals > 0 { last / 2.0 } else { value.abs() / 200.0 };
        let coherent = coherent_unit(dimension, UnitSystem::Si).to_string();
        // Nobody writes `1.9 1/s`.
        let unit = coherent.strip_prefix('1').map_or(coherent.clone(), |per| format!("rad{per}"));
        Self { symbol, text: format!("({text} {unit})"), value, half, is_given: false }
    }
}

/// An equation with numbers for some of its letters.
fn with_numbers(rng: &mut ChaCha8Rng, exercise: &Exercise, sides: &Sides, is_spoilt: bool) -> Option<Line> {
    let worked = exercise.worked();
    let model = worked.problem.model();
    let sides = sides.clone();
    let mut numbers: Vec<Number> = Vec::new();
    let symbols: BTreeSet<Symbol> = sides.0.symbols().into_iter().chain(sides.1.symbols()).collect();
    for symbol in symbols {
        let entry = model.symbols.entry(symbol);
        let value = worked.variant.value(symbol)?.value;
        let is_told = worked.form.told.contains(&symbol);
        let is_plain =
            entry.dimension != Dimension::NONE && is_typed(&entry.name) && value.abs() > 1e-6 && value.abs() < 1e9;
        if !is_plain || !rng.random_bool(if is_told { 0.6 } else { 0.5 }) {
            continue;
        }
        let given = worked.variant.given(symbol).filter(|_| is_told);
        numbers.push(given.map_or_else(
            || Number::computed(symbol, value, entry.dimension),
            |(decimal, unit)| {
                // What is given may have been rounded as well.
                let half = half_of_last_place(&decimal.to_rational())
                    .map(|half| half.to_f64().value() * unit.factor().to_f64());
                let half = half.unwrap_or(value.abs() / 200.0);
                Number { symbol, text: format!("({decimal} {unit})"), value, half, is_given: true }
            },
        ));
    }
    if is_spoilt {
        let computed: Vec<usize> = (0..numbers.len()).filter(|place| !numbers[*place].is_given).collect();
        if computed.is_empty() {
            return None;
        }
        let number = &mut numbers[computed[rng.random_range(0..computed.len())]];
        let share = rng.random_range(LEAST_SLIP..MOST_SLIP) * if rng.random_bool(0.5) { -1.0 } else { 1.0 };
        *number =
            Number::computed(number.symbol, number.value * (1.0 + share), model.symbols.entry(number.symbol).dimension);
    }
    if numbers.is_empty() {
        return None;
    }
    let name = |symbol: Symbol| {
        let name = &model.symbols.entry(symbol).name;
        let is_literal = model.literals.iter().any(|(literal, _)| *literal == symbol);
        let known = numbers.iter().find(|number| number.symbol == symbol).map(|number| number.text.clone());
        known.unwrap_or_else(|| if is_literal { format!("({name})") } else { name.clone() })
    };
    let text = format!("{} = {}", sides.0.text_with(&name), sides.1.text_with(&name));
    (text.len() <= LONGEST).then_some(Line { text, sides, numbers })
}

/// Whether the sides of a line agree as far as the roundings of its numbers reach: worked out apart from the judge.
fn agrees(exercise: &Exercise, line: &Line) -> bool {
    let residual = |changed: Option<(Symbol, f64)>| {
        let value = |symbol: Symbol| {
            let number = line.numbers.iter().find(|value| value.symbol == symbol).map(|number| number.value);
            let own =
                number.unwrap_or_else(|| exercise.variant().value(symbol).map_or(f64::NAN, |number| number.value));
            own + changed.filter(|(other, _)| *other == symbol).map_or(0.0, |(_, by)| by)
        };
        [&line.sides.0, &line.sides.1].map(|side| side.evaluate(&value))
    };
    let [left, right] = residual(None);
    let reach: f64 = line
        .numbers
        .iter()
        .map(|number| {
            let [moved_left, moved_right] = residual(Some((number.symbol, number.half)));
            ((moved_left - moved_right) - (left - right)).abs()
        })
        .sum();
    (left - right).abs() <= 1.5 * reach.max(RESULT * left.abs()) + 1e-9 * (left.abs() + right.abs())
}

/// Lines with numbers: how many there were. Right ones are never called wrong, and of spoilt ones those that are taken agree.
fn numeric_lines(size: Size, is_spoilt: bool) -> usize {
    let mut rng = ChaCha8Rng::seed_from_u64(46);
    let (mut lines, mut faults, mut open) = (0, Vec::new(), 0);
    each(1..=size.seeds, &mut |name, exercise| {
        let worked = exercise.worked();
        // Of what the sheet gives by its letter only nobody writes a number.
        if worked.problem.loaded().given.iter().any(|(_, given)| matches!(given, Given::Any(_))) {
            return;
        }
        let all = equations(worked);
        let table = &worked.problem.model().symbols;
        let mut judge = Judge::new(worked, DecimalMark::Point);
        for _ in 0..size.lines {
            let Some(sides) = rearranged(&mut rng, table, &all) else { continue };
            let Some(line) = with_numbers(&mut rng, exercise, &sides, is_spoilt) else { continue };
            let agrees = agrees(exercise, &line);
            // Of a number that stands in several places each may have been rounded by itself.
            let is_repeated = |number: &Number| line.text.matches(&number.text).count() > 1;
            if is_spoilt == agrees || is_spoilt && line.numbers.iter().any(is_repeated) {
                continue;
            }
            let judged = judge.line(&line.text);
            lines += 1;
            if matches!(judged.verdict, Verdict::Undecided | Verdict::Unreadable) {
                open += 1;
                eprintln!("{name} {:?} {}: {}", judged.verdict, line.text, judged.message);
            }
            let is_fault = if is_spoilt { judged.verdict.is_true() } else { judged.verdict.is_wrong() };
            if is_fault {
                faults.push(format!("{name} {:?} {}: {}", judged.verdict, line.text, judged.message));
            }
        }
    });
    eprintln!("{lines} lines, {open} cannot be read or decided, {} faults", faults.len());
    assert!(faults.len() * 100_000 <= lines, "{} of {lines}\n{}", faults.len(), faults.join("\n"));
    assert!(open * 200 <= lines, "{open} of {lines} cannot be read or decided");
    lines
}

#[test]
fn lines_with_numbers_are_never_called_wrong() {
    assert!(numeric_lines(FEW, false) > 500);
}

#[test]
fn lines_with_a_wrong_number_are_refused() {
    assert!(numeric_lines(FEW, true) > 200);
}

#[test]
#[ignore = "takes an hour"]
fn a_million_lines_with_numbers_are_judged() {
    assert!(numeric_lines(MANY, false) > 300_000);
    assert!(numeric_lines(MANY, true) > 100_000);
}
