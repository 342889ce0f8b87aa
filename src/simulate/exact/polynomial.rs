//! The first time at which a polynomial falls through zero. It misses none: the roots of the derivative cut the time into
//! pieces on which the polynomial is monotone, and each piece is bracketed.

/// The highest degree: the square of the distance of two bodies under forces that grow with the sixth power of time.
pub const HIGHEST_DEGREE: usize = 16;

/// The first `t` in `[0, horizon]` at which the polynomial with these coefficients (of 1, t, t², ...) goes from positive to
/// negative. One that is zero or negative at 0 and falling falls at 0; one that only touches zero does not fall.
///
/// ```
/// use momentous_simulate::first_fall;
/// // y = 10 t - 9.81 t^2 / 2 under a ceiling at 5 m: the gap 5 - y is open, and closes before it opens again.
/// let t = first_fall(&[5.0, -10.0, 9.81 / 2.0], 2.0).unwrap();
/// assert!((t - 0.878857810886).abs() < 1e-12);
/// assert_eq!(first_fall(&[5.2, -10.0, 9.81 / 2.0], 2.0), None);
/// ```
#[must_use]
pub fn first_fall(coefficients: &[f64], horizon: f64) -> Option<f64> {
    let coefficients = trimmed(coefficients);
    if coefficients.len() < 2 || coefficients.len() > HIGHEST_DEGREE + 1 {
        return None;
    }
    if coefficients[0] <= 0.0 && falls_at_start(coefficients) {
        return Some(0.0);
    }
    let horizon = horizon.min(farthest(coefficients));
    let turns = roots(&derivative(coefficients), horizon);
    let mut left = 0.0;
    for right in turns.into_iter().chain([horizon]) {
        let (from, to) = (value(coefficients, left), value(coefficients, right));
        if from > 0.0 && to < 0.0 || (from > 0.0 && to == 0.0 && falls_after(coefficients, right)) {
            return Some(bracketed(coefficients, left, right));
        }
        left = right;
    }
    None
}

/// The same polynomial in the time since `origin`.
pub(crate) fn shifted(coefficients: &[f64], origin: f64) -> Vec<f64> {
    let mut local = coefficients.to_vec();
    if origin != 0.0 {
        for done in 0..local.len() {
            for place in (done..local.len().saturating_sub(1)).rev() {
                local[place] += origin * local[place + 1];
            }
        }
    }
    while local.last() == Some(&0.0) {
        local.pop();
    }
    local
}

/// Whether the polynomial goes down from 0, by its first coefficient that is not zero.
fn falls_at_start(coefficients: &[f64]) -> bool {
    coefficients[1..].iter().find(|value| **value != 0.0).is_some_and(|value| *value < 0.0)
}

/// Whether the polynomial goes down at a root.
fn falls_after(coefficients: &[f64], root: f64) -> bool {
    value(&derivative(coefficients), root) < 0.0
}

fn trimmed(coefficients: &[f64]) -> &[f64] {
    let length = coefficients.iter().rposition(|value| *value != 0.0).map_or(0, |last| last + 1);
    &coefficients[..length]
}

fn value(coefficients: &[f64], at: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, value| sum * at + value)
}

#[allow(clippy::cast_precision_loss, reason = "degrees are small")]
fn derivative(coefficients: &[f64]) -> Vec<f64> {
    coefficients.iter().enumerate().skip(1).map(|(power, value)| value * power as f64).collect()
}

/// A time beyond which there is no root (Cauchy's bound).
fn farthest(coefficients: &[f64]) -> f64 {
    let Some((last, rest)) = coefficients.split_last() else { return 0.0 };
    1.0 + rest.iter().fold(0.0_f64, |most, value| most.max((value / last).abs()))
}

/// The roots in `[0, horizon]` at which the sign changes, in order.
fn roots(coefficients: &[f64], horizon: f64) -> Vec<f64> {
    let coefficients = trimmed(coefficients);
    if coefficients.len() < 2 {
        return Vec::new();
    }
    if let [constant, slope] = coefficients {
        let root = -constant / slope;
        return if root > 0.0 && root < horizon { vec![root] } else { Vec::new() };
    }
    let mut brackets = Vec::new();
    let mut left = 0.0;
    for right in roots(&derivative(coefficients), horizon).into_iter().chain([horizon]) {
        if (value(coefficients, left) > 0.0) != (value(coefficients, right) > 0.0) {
            brackets.push(bracketed(coefficients, left, right));
        }
        left = right;
    }
    brackets
}

/// The root between two places of different sign: Newton's step where it stays inside, halves elsewhere.
fn bracketed(coefficients: &[f64], mut left: f64, mut right: f64) -> f64 {
    let positive_left = value(coefficients, left) > 0.0;
    let slopes = derivative(coefficients);
    let mut middle = f64::midpoint(left, right);
    for _ in 0..200 {
        let height = value(coefficients, middle);
        if height == 0.0 {
            return middle;
        }
        if (height > 0.0) == positive_left {
            left = middle;
        } else {
            right = middle;
        }
        let newton = middle - height / value(&slopes, middle);
        let next = if newton > left && newton < right { newton } else { f64::midpoint(left, right) };
        if (next - middle).abs() <= f64::EPSILON * next.abs() {
            return next;
        }
        middle = next;
    }
    middle
}
