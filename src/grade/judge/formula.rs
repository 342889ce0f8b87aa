//! A formula: equal to the right one as a function over the problem's range, never as a text.

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::expr::equal_where;
use crate::quantity::Rational;
use crate::quantity::UnitSystem;
use crate::quantity::coherent_unit;
use crate::quantity::dimension_name;
use crate::solve::Bounded;
use crate::solve::Exact;
use crate::solve::Precise;
use crate::solve::Real;
use crate::solve::Sign;
use crate::solve::evaluate;

use super::super::expected::ExpectedFormula;
use super::super::messages::Message;
use super::super::verdict::Verdict;
use super::Judgement;

/// At so many points of the range two formulas must agree.
const POINTS: u64 = 20;
/// So many points are tried to find that many at which the right formula has a value.
const MOST_POINTS: u64 = 60;
/// Points lie on a grid of so many steps of each range.
const STEPS: u64 = 1 << 12;
/// A given that is the same in every variant is moved by this share of it, to tell functions apart.
const SPREAD: (i64, i64) = (1, 2);
/// Two formulas whose canonical forms may have more terms than this are compared at points only.
const MOST_TERMS: f64 = 300.0;
/// How far a ratio may change from point to point, to be called constant.
const CONSTANT: f64 = 1e-9;
/// Agreement to 256 bits, less what rounding in between can cost.
const AGREEMENT: f64 = 1e-60;

/// Judges a formula.
pub(super) fn judge(expected: &ExpectedFormula, answer: &Expr) -> Judgement {
    let answer = &expected.in_letters(answer);
    match answer.dimension(&expected.symbols) {
        Err(clash) => {
            let unit = |dimension| coherent_unit(dimension, UnitSystem::Si).to_string();
            let sentence = clash.sentence(&expected.symbols, &unit);
            return Judgement::of(Verdict::FormulaDimension, Message::FormulaClash(sentence));
        }
        Ok(dimension) if dimension != expected.dimension && !answer.is_zero() => {
            let [given, asked] = [dimension, expected.dimension].map(|own| dimension_name(own).to_owned());
            return Judgement::of(Verdict::FormulaDimension, Message::FormulaDimension { given, asked });
        }
        Ok(_) => {}
    }
    let points = points(expected);
    match compare(expected, answer, &points) {
        Compared::Equal if proven(expected, answer) => Judgement::of(Verdict::Right, Message::Right),
        Compared::Equal if agrees(expected, answer, &points) => Judgement::of(Verdict::RightAgrees, Message::Agrees),
        Compared::Factor(ratio) if (ratio + 1.0).abs() < CONSTANT => {
            Judgement::of(Verdict::SenseReversed, Message::SenseReversed)
        }
        Compared::Factor(_) => Judgement::of(Verdict::FormulaFactor, Message::Slip(Verdict::FormulaFactor)),
        Compared::Equal | Compared::Different => Judgement::of(Verdict::Wrong, Message::Wrong),
    }
}

/// What doubles say of two formulas.
enum Compared {
    /// They may be equal.
    Equal,
    /// One is a constant times the other.
    Factor(f64),
    /// They differ.
    Different,
}

/// A value for every symbol of the formula.
type Point = Vec<(Symbol, Rational)>;

/// Points of the range at which the right formula has a value. They depend on nothing but the formula's range.
fn points(expected: &ExpectedFormula) -> Vec<Point> {
    let has_value = |point: &Point| {
        let right: Bounded = value(&expected.formula, point);
        right.is_real() && !right.is_unbounded()
    };
    let drawn = (0..MOST_POINTS).map(|number| point(expected, number));
    drawn.filter(has_value).take(usize::try_from(POINTS).unwrap_or(0)).collect()
}

fn point(expected: &ExpectedFormula, number: u64) -> Point {
    let place = |(position, (symbol, low, high)): (usize, &(Symbol, f64, f64))| {
        let [low, high] = [*low, *high].map(|end| Rational::try_from(end).unwrap_or_default());
        let spread = &low * Rational::from(SPREAD.0) / Rational::from(SPREAD.1);
        let (low, high) = if low == high { (&low - &spread, &low + &spread) } else { (low, high) };
        let step = mixed(number * 1009 + position as u64) % (STEPS - 1) + 1;
        let share = Rational::from(step) / Rational::from(STEPS);
        (*symbol, &low + (high - &low) * share)
    };
    expected.domain.iter().enumerate().map(place).collect()
}

/// `SplitMix64`: the same points on every platform.
fn mixed(seed: u64) -> u64 {
    let mut state = seed.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    state = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    state = (state ^ (state >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    state ^ (state >> 31)
}

fn value<R: Real>(formula: &Expr, point: &Point) -> R {
    let of = |symbol: Symbol| {
        let found = point.iter().find(|(own, _)| *own == symbol);
        found.map_or_else(R::not_real, |(_, value)| R::from_exact(&Exact::from(value.clone())))
    };
    evaluate(formula, &of)
}

fn compare(expected: &ExpectedFormula, answer: &Expr, points: &[Point]) -> Compared {
    let mut ratio: Option<f64> = None;
    let (mut equal, mut constant) = (true, true);
    for point in points {
        let (right, given): (Bounded, Bounded) = (value(&expected.formula, point), value(answer, point));
        if !given.is_real() {
            return Compared::Different;
        }
        let difference = given.sub(&right);
        equal &= !matches!(difference.sign(), Sign::Negative | Sign::Positive | Sign::NotReal);
        if right.value.abs() > right.error {
            let own = given.value / right.value;
            let first = *ratio.get_or_insert(own);
            constant &= (own - first).abs() <= CONSTANT * first.abs();
        } else {
            constant = false;
        }
        if !equal && !constant {
            return Compared::Different;
        }
    }
    match ratio {
        _ if points.is_empty() => Compared::Different,
        _ if equal => Compared::Equal,
        Some(ratio) if constant && ratio != 0.0 => Compared::Factor(ratio),
        _ => Compared::Different,
    }
}

/// Whether algebra proves the formulas equal; it is not tried where its forms could grow large.
fn proven(expected: &ExpectedFormula, answer: &Expr) -> bool {
    let fixed = |symbol: Symbol| {
        let zero = expected.domain.iter().any(|(own, low, high)| *own == symbol && *low == 0.0 && *high == 0.0);
        zero.then(Expr::zero)
    };
    let (right, given) = (expected.formula.substitute(&fixed), answer.substitute(&fixed));
    let (own, other) = (terms(&right), terms(&given));
    if own.0 * other.1 + own.1 * other.0 > MOST_TERMS {
        return false;
    }
    let positive = |symbol: Symbol| expected.domain.iter().any(|(own, low, _)| *own == symbol && *low > 0.0);
    equal_where(&right, &given, &positive)
}

/// About how many terms the canonical form of a formula can have above and below its bar.
fn terms(formula: &Expr) -> (f64, f64) {
    match formula {
        Expr::Sum(parts) => parts
            .iter()
            .map(terms)
            .fold((0.0, 1.0), |(above, below), (own, under)| (above * under + own * below, below * under)),
        Expr::Product(parts) => {
            parts.iter().map(terms).fold((1.0, 1.0), |(above, below), (own, under)| (above * own, below * under))
        }
        Expr::Power(pair) => {
            let (above, below) = terms(&pair.0);
            let exponent = pair.1.as_number().map_or(1.0, |number| number.to_f64().value());
            let size = exponent.abs().max(1.0);
            let (above, below) = (libm::pow(above, size), libm::pow(below, size));
            if exponent < 0.0 { (below, above) } else { (above, below) }
        }
        Expr::Apply(_, arguments) => {
            let inside: f64 = arguments
                .iter()
                .map(|argument| {
                    let (above, below) = terms(argument);
                    above * below
                })
                .sum();
            (inside.max(1.0), 1.0)
        }
        Expr::Piecewise(_) => (f64::INFINITY, 1.0),
        Expr::Number(_) | Expr::Pi | Expr::Symbol(_) => (1.0, 1.0),
    }
}

/// Whether the formulas agree at every point to 256 bits.
fn agrees(expected: &ExpectedFormula, answer: &Expr, points: &[Point]) -> bool {
    points.len() >= usize::try_from(POINTS).unwrap_or(0)
        && points.iter().all(|point| {
            let (right, given): (Precise, Precise) = (value(&expected.formula, point), value(answer, point));
            let difference = given.sub(&right);
            let small = difference.rough().abs() <= AGREEMENT * right.rough().abs().max(f64::MIN_POSITIVE);
            difference.is_real() && !difference.is_unbounded() && (small || difference.sign() == Sign::Zero)
        })
}
