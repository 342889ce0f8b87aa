//! Judging the answers of many draws: bounded errors, nothing constant, zero by accident or given away.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::SymbolTable;
use momentous_problem::AskedUnit;
use momentous_problem::Meant;
use momentous_problem::NumberPart;
use momentous_problem::Part;
use momentous_problem::PartKind;

use super::promise::Outcome;
use super::report::AnswerSpread;
use super::sample::Answered;
use super::sample::Samples;

/// An error bound is small up to this share of the largest answer to the part.
const SMALL_ERROR: f64 = 1e-9;

/// A zero is an accident up to this share of the draws; beyond it the part asks for a zero too often.
const MOST_ZEROS: f64 = 0.1;

/// Beyond this share of draws in which the answer is among the givens, the part asks for nothing.
const MOST_GIVEN: f64 = 0.5;

/// The answers to one part that is a number, over all draws.
pub(super) struct Column<'a> {
    id: String,
    /// The part of which it is a number; that of a vector has several.
    part: &'a str,
    whole: bool,
    answers: Vec<&'a Answered>,
}

/// The parts that are numbers, with their answers.
pub(super) fn columns<'a>(parts: &'a [Part], samples: &'a Samples) -> Vec<Column<'a>> {
    let numbers = parts.iter().flat_map(|part| part.numbers().map(|number| (part.id.as_str(), number)));
    let column = |(index, (part, (id, number))): (usize, (&'a str, (String, &'a NumberPart)))| Column {
        id,
        part,
        whole: number.whole,
        answers: samples.drawn.iter().filter_map(|sample| sample.answers.get(index)).collect(),
    };
    numbers.enumerate().map(column).collect()
}

impl Column<'_> {
    /// The largest answer; one that is zero within its bound counts as zero.
    fn largest(&self) -> f64 {
        let sizes = self.answers.iter().map(|answer| (answer.value.value.abs(), answer.value.error));
        sizes.filter(|(size, error)| size > error).map(|(size, _)| size).fold(0.0, f64::max)
    }

    fn share(&self, holds: impl Fn(&Answered) -> bool) -> f64 {
        share(self.answers.iter().filter(|answer| holds(answer)).count(), self.answers.len())
    }

    fn distinct(&self) -> usize {
        self.answers.iter().map(|answer| answer.printed.as_str()).collect::<BTreeSet<_>>().len()
    }
}

/// Every bound is finite and small next to the answers.
pub(super) fn certified(columns: &[Column<'_>]) -> Outcome {
    let loose = |column: &Column<'_>| {
        // Beside an answer that is always zero nothing is large: there the unit in which it is printed is the measure.
        let largest = column.largest();
        let allowed = SMALL_ERROR * if largest > 0.0 { largest } else { 1.0 };
        let share = column.share(|answer| answer.value.error.is_nan() || answer.value.error > allowed);
        (share > 0.0 && !column.whole).then(|| format!("`{}` has no small bound in {}", column.id, percent(share)))
    };
    broken(&columns_in_words(columns, loose))
}

/// Nothing is the same for every seed, where seeds differ at all and it is not meant.
pub(super) fn varies(columns: &[Column<'_>], variants: usize, meant: &[Meant]) -> Outcome {
    if variants < 2 {
        return Outcome::NotChecked("every seed has the same givens");
    }
    if meant.contains(&Meant::OneAnswer) {
        return Outcome::Kept;
    }
    let constant = |column: &Column<'_>| {
        let printed = column.answers.first()?.printed.as_str();
        (column.distinct() == 1).then(|| format!("`{}` is always {printed}", column.id))
    };
    let said = columns_in_words(columns, constant);
    if said.is_empty() {
        return Outcome::Kept;
    }
    Outcome::Broken(format!("{}; if that is meant, write `allow: [one-answer]`", said.join("; ")))
}

/// A zero is rare, unless it is always there, which is a constant.
pub(super) fn not_zero(columns: &[Column<'_>]) -> Outcome {
    let zeros = |column: &Column<'_>| {
        let share = column.share(|answer| answer.value.is_zero());
        (share > 0.0 && share < 1.0 && !column.whole)
            .then(|| (share, format!("`{}` is zero in {}", column.id, percent(share))))
    };
    let zeros: Vec<(f64, String)> = columns.iter().filter_map(zeros).collect();
    let often = zeros.iter().any(|(share, _)| *share > MOST_ZEROS);
    let said: Vec<String> = zeros.into_iter().map(|(_, said)| said).collect();
    if often { broken(&said) } else { Outcome::Kept }
}

/// Answers do not stand on the sheet already; a vector does only with all of its components.
pub(super) fn not_given(columns: &[Column<'_>]) -> Outcome {
    let parts: Vec<&[Column<'_>]> = columns.chunk_by(|column, next| column.part == next.part).collect();
    let given = |part: &&[Column<'_>]| {
        let first = part.first()?;
        let is_given =
            |draw: &usize| part.iter().all(|column| column.answers.get(*draw).is_some_and(|answer| answer.is_given));
        let share = share((0..first.answers.len()).filter(is_given).count(), first.answers.len());
        (share > MOST_GIVEN).then(|| format!("`{}` equals a given in {}", first.part, percent(share)))
    };
    broken(&parts.iter().filter_map(given).collect::<Vec<_>>())
}

/// How the answers lie, part by part.
pub(super) fn spreads(parts: &[Part], symbols: &SymbolTable, samples: &Samples) -> Vec<AnswerSpread> {
    let mut columns = columns(parts, samples).into_iter();
    let mut choices = 0..;
    let mut choice = |part: &Part| {
        let position = choices.next()?;
        let mut right: BTreeMap<String, usize> = BTreeMap::new();
        for phrase in samples.drawn.iter().filter_map(|sample| sample.chosen.get(position)) {
            *right.entry(phrase.clone()).or_default() += 1;
        }
        Some(AnswerSpread::Choice { id: part.id.clone(), right })
    };
    let mut number = |(id, number): (String, &NumberPart)| {
        let column = columns.next()?;
        let mut values: Vec<f64> = column.answers.iter().map(|answer| answer.value.value).collect();
        values.sort_by(f64::total_cmp);
        let at = |numerator: usize| values.get(values.len().saturating_sub(1) * numerator / 4).copied();
        let error = column.answers.iter().map(|answer| answer.value.error).fold(0.0, f64::max);
        let unit = match &number.unit {
            AskedUnit::Unit(unit) => unit.to_string(),
            AskedUnit::InTermsOf(symbol, _) => symbols.entry(*symbol).name.clone(),
        };
        Some(AnswerSpread::Number {
            id,
            unit,
            least: at(0)?,
            lower_quartile: at(1)?,
            median: at(2)?,
            upper_quartile: at(3)?,
            most: at(4)?,
            distinct: column.distinct(),
            error_bound: error.is_finite().then_some(error),
        })
    };
    let spread = |part: &Part| match &part.kind {
        PartKind::Choice(_) | PartKind::Formula(_) => choice(part).into_iter().collect(),
        PartKind::Number(_) | PartKind::Vector(_) | PartKind::Range(_) => {
            part.numbers().filter_map(&mut number).collect::<Vec<_>>()
        }
    };
    parts.iter().flat_map(spread).collect()
}

/// The sentences about columns.
fn columns_in_words(columns: &[Column<'_>], words: impl Fn(&Column<'_>) -> Option<String>) -> Vec<String> {
    columns.iter().filter_map(words).collect()
}

#[allow(clippy::cast_precision_loss)] // counts of draws are far below 2^53
fn share(count: usize, draws: usize) -> f64 {
    count as f64 / draws.max(1) as f64
}

/// A share of the draws in words.
pub(super) fn percent(share: f64) -> String {
    format!("{:.1} % of the draws", 100.0 * share)
}

pub(super) fn broken(said: &[String]) -> Outcome {
    if said.is_empty() { Outcome::Kept } else { Outcome::Broken(said.join("; ")) }
}

pub(super) fn noted(said: &[String]) -> Outcome {
    if said.is_empty() { Outcome::Kept } else { Outcome::Noted(said.join("; ")) }
}
