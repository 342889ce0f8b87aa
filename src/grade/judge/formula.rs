//! A formula: equal to the right one as a function over the problem's range, never as a text.

use momentous_expr::Expr;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;
use momentous_quantity::dimension_name;
use momentous_solve::Bounded;
use momentous_solve::Precise;
use momentous_solve::Real;
use momentous_solve::Sign;

use super::super::expected::ExpectedFormula;
use super::super::messages::Message;
use super::super::points::{Point, Points, has_no_value, is_certain, value};
use super::super::read::FormulaAnswer;
use super::super::verdict::Verdict;
use super::judgement::Judgement;
use super::proof::{Proof, prove};

/// At so many points of the range two formulas must agree.
const POINTS: usize = 20;
/// At so many of them, to many digits.
const PRECISE_POINTS: usize = 2;
/// The points tried to find them, where the right formula has a value in a part of the range only.
const MOST_POINTS: usize = 4000;
/// At so many points values are computed with many digits, at most.
const MOST_PRECISE: usize = 6;
/// How far a ratio may be from -1 to be called so.
const REVERSED: f64 = 1e-9;
/// Formulas agree to so many digits, where no proof is found: 77 are computed, and what rounding in between costs is left off.
/// What is smaller beside the right value is seen by algebra, or not at all.
const AGREEMENT: f64 = 1e-60;
/// A number in a formula may be rounded by as much as any number.
const TOLERANCE: f64 = 0.01;
/// How much further half a unit may lead than along a straight line.
const STRAIGHT: f64 = 1.01;

/// Judges a formula.
pub(super) fn judge(expected: &ExpectedFormula, answer: &FormulaAnswer) -> Judgement {
    let given = &expected.in_letters(&answer.formula);
    if has_no_value(expected, given) {
        return Judgement::of(Verdict::Unreadable, Message::NoValue);
    }
    match given.dimension(&expected.symbols) {
        Err(clash) => {
            let unit = |dimension| coherent_unit(dimension, UnitSystem::Si).to_string();
            let sentence = clash.sentence(&expected.symbols, &unit);
            return Judgement::of(Verdict::FormulaDimension, Message::FormulaClash(sentence));
        }
        Ok(dimension) if dimension != expected.dimension && !given.is_zero() => {
            let [given, asked] = [dimension, expected.dimension].map(|dimension| dimension_name(dimension).to_owned());
            return Judgement::of(Verdict::FormulaDimension, Message::FormulaDimension { given, asked });
        }
        Ok(_) => {}
    }
    let mut points = Vec::with_capacity(POINTS);
    let compared = match compare(expected, given, &mut points) {
        Compared::Agree => decide(expected, given, &points),
        other => other,
    };
    match compared {
        Compared::Proven => match expected.left_out(&answer.formula) {
            Some(coherent) => {
                let name = expected.symbols.entry(coherent).name.clone();
                Judgement::of(Verdict::Right, Message::Right).noted(Message::BareMultiple(name))
            }
            None => Judgement::of(Verdict::Right, Message::Right),
        },
        Compared::Agree => Judgement::of(Verdict::RightAgrees, Message::Agrees),
        Compared::Factor(ratio) if (ratio - 1.0).abs() <= TOLERANCE && !answer.shifted.is_empty() => rounded(),
        Compared::Different if is_rounded(expected, answer) => rounded(),
        Compared::Factor(ratio) if (ratio + 1.0).abs() < REVERSED => match (expected.signed, expected.directed) {
            (false, _) => Judgement::of(Verdict::RightWithNote, Message::NegativeMagnitude),
            (true, false) => Judgement::of(Verdict::SenseReversed, Message::SignReversed),
            (true, true) => Judgement::of(Verdict::SenseReversed, Message::SenseReversed),
        },
        Compared::Factor(_) => Judgement::of(Verdict::FormulaFactor, Message::Slip(Verdict::FormulaFactor)),
        Compared::Different if is_value(expected, given) => Judgement::of(Verdict::Wrong, Message::ValueForFormula),
        Compared::Different => Judgement::of(Verdict::Wrong, Message::Wrong),
        Compared::Open => Judgement::of(Verdict::Unreadable, Message::CannotBeJudged),
    }
}

/// Whether a number stands in the place of the formula whose value it is.
fn is_value(expected: &ExpectedFormula, given: &Expr) -> bool {
    let stated = given.evaluate(&|_| f64::NAN);
    given.symbols().is_empty() && expected.value.is_some_and(|value| (stated - value).abs() <= TOLERANCE * value.abs())
}

/// The comparison of two formulas.
#[derive(Clone, Copy, Debug)]
enum Compared {
    /// Algebra proves them equal.
    Proven,
    /// They agree wherever they were compared.
    Agree,
    /// One is a constant times the other.
    Factor(f64),
    /// They differ.
    Different,
    /// Neither that they are equal nor that they differ.
    Open,
}

/// Two values at a point.
enum AtPoint {
    /// They are the same as far as is known.
    Same,
    /// They differ, with the ratio of the student's to the right one.
    Apart(Bounded),
    /// The student's formula has no finite value that is certain.
    NoValue,
}

/// Compares two formulas in double precision, or with more digits where that does not suffice; the points at which they agree are kept.
fn compare(expected: &ExpectedFormula, given: &Expr, kept: &mut Vec<Point>) -> Compared {
    let (mut met, mut precise) = (0, 0);
    let (mut missing, mut apart): (bool, Option<Bounded>) = (false, None);
    for point in Points::new(expected, &[&expected.formula, given]).take(MOST_POINTS) {
        let Some((comparison, digits)) = meet(expected, given, &point) else { continue };
        precise += usize::from(digits == Digits::Many);
        met += if digits == Digits::Many { POINTS / PRECISE_POINTS } else { 1 };
        match comparison {
            AtPoint::Same => kept.push(point),
            AtPoint::NoValue => missing = true,
            AtPoint::Apart(ratio) => {
                let first = *apart.get_or_insert(ratio);
                // What may be zero is no factor.
                let is_factor = is_certain(&ratio) && matches!(ratio.sign(), Sign::Negative | Sign::Positive);
                if !is_factor || differ(&first, &ratio) {
                    return Compared::Different;
                }
            }
        }
        if apart.is_some() && (missing || !kept.is_empty()) {
            return Compared::Different;
        }
        if met >= POINTS || precise == MOST_PRECISE {
            break;
        }
    }
    match apart {
        Some(ratio) if met >= POINTS => Compared::Factor(ratio.value),
        Some(_) => Compared::Different,
        None if missing || met < POINTS => Compared::Open,
        None => Compared::Agree,
    }
}

/// How many digits were needed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Digits {
    /// Those of a double.
    Few,
    /// All of them.
    Many,
}

/// The two values at a point; `None` where the right formula has none.
fn meet(expected: &ExpectedFormula, given: &Expr, point: &Point) -> Option<(AtPoint, Digits)> {
    let right: Bounded = value(&expected.formula, point);
    if !right.is_real() {
        return None;
    }
    let answered: Bounded = value(given, point);
    if is_certain(&right) && is_certain(&answered) {
        return Some((parted(&right, &answered), Digits::Few));
    }
    if is_certain(&right) && !answered.is_real() {
        return Some((AtPoint::NoValue, Digits::Few));
    }
    let (right, answered): (Precise, Precise) = (value(&expected.formula, point), value(given, point));
    let comparison = match (is_finite(&right), is_finite(&answered)) {
        (false, _) => return None,
        (true, false) => AtPoint::NoValue,
        (true, true) => parted(&right, &answered),
    };
    Some((comparison, Digits::Many))
}

/// Whether there is a bound on a value: one with many digits may be finite where no double is.
fn is_finite(value: &Precise) -> bool {
    value.is_real() && !value.is_unbounded()
}

/// Whether two values are apart for certain.
fn differ<R: Real>(one: &R, other: &R) -> bool {
    matches!(one.sub(other).sign(), Sign::Negative | Sign::Positive)
}

fn parted<R: Real>(right: &R, answered: &R) -> AtPoint {
    if differ(answered, right) { AtPoint::Apart(answered.div(right).to_bounded()) } else { AtPoint::Same }
}

/// Decides about formulas that agree in double precision: a proof, or agreement to many digits.
fn decide(expected: &ExpectedFormula, given: &Expr, points: &[Point]) -> Compared {
    match prove(expected, given) {
        Proof::Equal => return Compared::Proven,
        Proof::Different => return Compared::Different,
        Proof::None => {}
    }
    let mut all = true;
    for point in points.iter().take(PRECISE_POINTS) {
        let (right, answered): (Precise, Precise) = (value(&expected.formula, point), value(given, point));
        if differ(&answered, &right) {
            return Compared::Different;
        }
        let difference = answered.sub(&right);
        let bound = difference.to_bounded();
        let known = is_finite(&difference) && right.sign() != Sign::Zero;
        all &= known && bound.value.abs() + bound.error <= AGREEMENT * right.rough().abs();
    }
    // Where the right value is zero, to be small is no agreement.
    if all { Compared::Agree } else { Compared::Open }
}

fn rounded() -> Judgement {
    Judgement::of(Verdict::Right, Message::Right).noted(Message::RoundedNumber)
}

/// Whether a formula is right within the rounding of its decimals: every decimal stands for all numbers that round to it.
fn is_rounded(expected: &ExpectedFormula, answer: &FormulaAnswer) -> bool {
    if answer.shifted.is_empty() {
        return false;
    }
    let given = expected.in_letters(&answer.formula);
    let shifted: Vec<Expr> = answer.shifted.iter().map(|formula| expected.in_letters(formula)).collect();
    let points = Points::new(expected, &[&expected.formula, &given]).take(MOST_POINTS);
    let mut found = points.filter_map(|point| {
        let right: Bounded = value(&expected.formula, &point);
        if !is_certain(&right) {
            return None;
        }
        let answered: Bounded = value(&given, &point);
        let moves = shifted.iter().map(|shifted| value::<Bounded>(shifted, &point).sub(&answered));
        let reach: f64 = moves.map(|moved| moved.value.abs() - moved.error).sum();
        // The reach is that of a straight line.
        let reach = (reach * STRAIGHT).min(TOLERANCE * right.value.abs());
        let apart = answered.sub(&right);
        Some(is_certain(&apart) && apart.value.abs() + apart.error <= reach)
    });
    (0..POINTS).all(|_| found.next() == Some(true))
}
