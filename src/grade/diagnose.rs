//! Which usual mistake leads to a wrong answer: the answer is compared with what each mistake makes of the question.

use serde::Serialize;

use momentous_quantity::half_unit;
use momentous_quantity::round_to_figures;
use momentous_quantity::unit_of_place;

use super::expected::{ExpectedNumber, ExpectedVector};
use super::judge::BESIDE_A_WHOLE_NUMBER;
use super::read::{Answer, NumberAnswer, Written};
use super::verdict::Verdict;

/// Sources of a wrong answer, most likely first.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Diagnosis {
    /// The mistakes that lead to this answer, by their stable codes. They cannot be told apart with these numbers, and so
    /// are one diagnosis; the hints speak of the first.
    pub codes: Vec<&'static str>,
    /// The step to look at, as a noun phrase; none where the mistake is outside the laws.
    pub step: Option<String>,
    /// The hints to the student, a question first, each plainer than the one before. None holds the right value.
    pub hints: Vec<String>,
}

/// Beyond rounding at the end, an answer may come from values that were rounded on the way: this share of it.
const ROUNDED_ON_THE_WAY: f64 = 0.0035;

/// Whether a verdict leaves open where the answer comes from.
#[must_use]
pub fn is_open(verdict: Verdict) -> bool {
    matches!(
        verdict,
        Verdict::Wrong
            | Verdict::ChoiceWrong
            | Verdict::RoundingSlip
            | Verdict::Sense
            | Verdict::SenseReversed
            | Verdict::UnitPrefix
            | Verdict::OrderOfMagnitude
            | Verdict::AngleReversed
            | Verdict::AngleOtherSense
            | Verdict::AngleSupplement
            | Verdict::AngleComplement
            | Verdict::AngleOtherAxis
            | Verdict::ComponentsExchanged
            | Verdict::ComponentSign
            | Verdict::DirectionWrong
            | Verdict::FormulaFactor
            | Verdict::FormulaDimension
    )
}

/// The number of an answer in the unit of the question; as it stands where it has no unit, `None` where its unit measures
/// something else.
#[must_use]
pub fn number(expected: &ExpectedNumber, answer: &Answer) -> Option<f64> {
    let Answer::Number(answer) = answer else { return None };
    let directed = answer.directed().to_f64();
    let value = match unit(answer) {
        None => directed,
        Some(unit) if *unit == expected.unit => directed,
        Some(unit) if unit.dimension() == expected.unit.dimension() => {
            directed * unit.turning_as(&expected.unit).to_f64()
        }
        Some(_) => return None,
    };
    value.is_finite().then_some(value)
}

fn unit(answer: &NumberAnswer) -> Option<&momentous_quantity::Unit> {
    answer.unit.as_ref().filter(|unit| !unit.is_none())
}

/// The components of a vector in the unit of the question, in the same way.
#[must_use]
pub fn components(expected: &ExpectedVector, answer: &Answer) -> Option<Vec<f64>> {
    let (Answer::Vector(answer), Some(first)) = (answer, expected.components.first()) else { return None };
    let factor = match answer.unit.as_ref().filter(|unit| !unit.is_none()) {
        Some(unit) if unit.dimension() != first.unit.dimension() => return None,
        Some(unit) if *unit != first.unit => unit.in_terms_of(&first.unit).to_f64(),
        _ => 1.0,
    };
    let components: Vec<f64> = answer.components.iter().map(|component| component.to_f64() * factor).collect();
    (components.len() == expected.components.len() && components.iter().all(|component| component.is_finite()))
        .then_some(components)
}

/// The answer that a mistake leads to, as marking compares it with what was written.
struct Suspect {
    place: usize,
    size: f64,
    /// How far the answer is from it.
    away: f64,
}

/// Whether an answer is so near to a value that rounding may lead from the one to the other.
#[must_use]
pub fn is_near(expected: &ExpectedNumber, answer: f64, value: f64) -> bool {
    distance(expected, value, answer) <= reach(expected.figures) * value.abs()
}

/// How far two values are apart; of directions the shorter way round.
fn distance(expected: &ExpectedNumber, one: f64, other: f64) -> f64 {
    if expected.cyclic {
        return libm::fabs(libm::remainder(one - other, std::f64::consts::TAU / expected.size));
    }
    (one - other).abs()
}

/// Whether an answer is a value as it is rounded at the end.
#[must_use]
pub fn is_rounded(expected: &ExpectedNumber, answer: f64, value: f64) -> bool {
    let limit = if expected.whole { 0.0 } else { rounding(value, expected.figures) };
    distance(expected, value, answer) <= limit
}

/// The figures with which a number is written beyond those that are asked.
#[must_use]
pub fn further_figures(expected: &ExpectedNumber, answer: &Answer) -> usize {
    match answer {
        Answer::Number(NumberAnswer { written: Written::Figures { least, .. }, .. }) => {
            least.saturating_sub(expected.figures)
        }
        _ => 0,
    }
}

/// The suspects that lead to the answer: those within its rounding, or the nearest within that of the values on the way.
/// Suspects that give the right answer here are none. Of an answer that is written with further figures, those which agree in these.
#[must_use]
pub fn matching(expected: &ExpectedNumber, answer: f64, further: usize, suspects: &[f64]) -> Vec<usize> {
    let distance = |one: f64, other: f64| distance(expected, one, other);
    let rounding = |value: f64| if expected.whole { 0.0 } else { rounding(value, expected.figures) };
    let near = suspects
        .iter()
        .enumerate()
        .filter(|(_, value)| is_near(expected, answer, **value) && !is_right(expected, **value))
        .map(|(place, value)| Suspect { place, size: value.abs(), away: distance(*value, answer) });
    let near: Vec<Suspect> = near.collect();
    let finer =
        |suspect: &Suspect| if expected.whole { 0.0 } else { self::rounding(suspect.size, expected.figures + further) };
    let alike: Vec<usize> =
        near.iter().filter(|suspect| suspect.away <= finer(suspect)).map(|suspect| suspect.place).collect();
    if !alike.is_empty() {
        return alike;
    }
    let limit = |suspect: &Suspect| rounding(suspect.size);
    // Whoever writes further figures has kept them on the way.
    let on_the_way = if further > 0 { ROUNDED_ON_THE_WAY / 10.0 } else { ROUNDED_ON_THE_WAY };
    chosen(&near, &limit, rounding(answer), Some(on_the_way).filter(|_| !expected.whole))
}

/// The answers that lead to a suspect when they are rounded at the end; nothing where the suspect gives the right answer.
#[must_use]
pub fn window(expected: &ExpectedNumber, suspect: f64) -> Option<[f64; 2]> {
    if is_right(expected, suspect) {
        return None;
    }
    let reach = if expected.whole { BESIDE_A_WHOLE_NUMBER } else { rounding(suspect.abs(), expected.figures) };
    Some([suspect - reach, suspect + reach])
}

/// Whether a suspect is the right answer, as it is rounded.
fn is_right(expected: &ExpectedNumber, suspect: f64) -> bool {
    let rounding = if expected.whole { 0.0 } else { rounding(expected.value, expected.figures) };
    distance(expected, suspect, expected.value) <= rounding.min(expected.allowance)
}

/// [`matching`] for vectors: sizes and distances are those of vectors.
#[must_use]
pub fn matching_vectors(expected: &ExpectedVector, answer: &[f64], suspects: &[Vec<f64>]) -> Vec<usize> {
    let figures = expected.components.first().map_or(3, |first| first.figures);
    let size = |vector: &[f64]| libm::sqrt(vector.iter().map(|part| part * part).sum());
    let distance =
        |one: &[f64], other: &[f64]| size(&one.iter().zip(other).map(|(one, other)| one - other).collect::<Vec<f64>>());
    let right: Vec<f64> = expected.components.iter().map(|expected| expected.value).collect();
    // Each component is rounded for itself, so that the vector is off by no more than all of them.
    let limits: Vec<f64> =
        suspects.iter().map(|vector| vector.iter().map(|value| rounding(*value, figures)).sum()).collect();
    let near = suspects
        .iter()
        .enumerate()
        .map(|(place, vector)| Suspect { place, size: size(vector), away: distance(vector, answer) })
        .filter(|suspect| distance(&suspects[suspect.place], &right) > limits[suspect.place]);
    let own_rounding = answer.iter().map(|value| rounding(*value, figures)).sum();
    chosen(&near.collect::<Vec<_>>(), &|suspect| limits[suspect.place], own_rounding, Some(ROUNDED_ON_THE_WAY))
}

/// Those within their limit; else, where values on the way may have been rounded, the nearest with what is beside it.
fn chosen(near: &[Suspect], limit: &dyn Fn(&Suspect) -> f64, own_rounding: f64, on_the_way: Option<f64>) -> Vec<usize> {
    let exact: Vec<usize> =
        near.iter().filter(|suspect| suspect.away <= limit(suspect)).map(|suspect| suspect.place).collect();
    let Some(on_the_way) = on_the_way.filter(|_| exact.is_empty()) else { return exact };
    let loose = || near.iter().filter(|suspect| suspect.away <= on_the_way * suspect.size);
    let nearest = loose().map(|suspect| suspect.away).fold(f64::INFINITY, f64::min);
    loose().filter(|suspect| suspect.away <= nearest + own_rounding).map(|suspect| suspect.place).collect()
}

/// The share of a value beyond which no rounding leads.
fn reach(figures: usize) -> f64 {
    unit_of_place(1 - i32::try_from(figures).unwrap_or(1)).max(2.0 * ROUNDED_ON_THE_WAY)
}

/// How far rounding moves a value.
fn rounding(value: f64, figures: usize) -> f64 {
    half_unit(value, figures) * 1.001 + 1e-9 * value.abs()
}

/// Whether an answer is the right one cut to two figures, and written with no more: rounding, not a wrong method.
#[must_use]
pub fn is_coarse(expected: &ExpectedNumber, written: &Answer, answer: f64) -> bool {
    let is_whole = |written_number: &NumberAnswer| match written_number.written {
        Written::Figures { least, .. } => least >= expected.figures,
        Written::Computed => true,
    };
    if matches!(written, Answer::Number(written_number) if is_whole(written_number)) {
        return false;
    }
    if expected.figures <= 2 || expected.whole || (answer - expected.value).abs() > 0.1 * expected.value.abs() {
        return false;
    }
    let rounded = round_to_figures(expected.value, 2).map(|value| value.to_f64());
    rounded.is_some_and(|value| (value - answer).abs() <= 1e-9 * value.abs())
}
