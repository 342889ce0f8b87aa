//! Repeated integrals of cosines and of decaying exponentials, as good where the rate vanishes as anywhere else.

/// Below this square, or product, of rate and time the series is used: beyond it nothing cancels.
const SMALL: f64 = 1.0;

/// The terms of a series that ends below rounding.
const TERMS: u32 = 20;

/// The integral of `cos(rate t)` from 0 to a time, taken so many times over; `time^order / order!` where the rate is 0.
///
/// ```
/// use momentous_simulate::repeated_cosine;
/// assert!((repeated_cosine(1, 2.0, 3.0) - 6.0_f64.sin() / 3.0).abs() < 1e-16);
/// assert_eq!(repeated_cosine(2, 2.0, 0.0), 2.0);
/// ```
#[must_use]
pub fn repeated_cosine(order: usize, time: f64, rate: f64) -> f64 {
    let angle = rate * time;
    let square = angle * angle;
    if square < SMALL {
        return power(time, order) * series(order, 2, -square);
    }
    let first = if order.is_multiple_of(2) { libm::cos(angle) } else { libm::sin(angle) / angle };
    let orders = (order % 2..order).step_by(2);
    power(time, order) * orders.fold(first, |part, order| (1.0 / factorial(order) - part) / square)
}

/// The integral of `exp(-rate t)` from 0 to a time, taken so many times over; `time^order / order!` where the rate is 0.
///
/// ```
/// use momentous_simulate::repeated_decay;
/// assert!((repeated_decay(1, 2.0, 3.0) - (1.0 - (-6.0_f64).exp()) / 3.0).abs() < 1e-16);
/// assert_eq!(repeated_decay(2, 2.0, 0.0), 2.0);
/// ```
#[must_use]
pub fn repeated_decay(order: usize, time: f64, rate: f64) -> f64 {
    let share = rate * time;
    if share.abs() < SMALL {
        return power(time, order) * series(order, 1, -share);
    }
    power(time, order) * (0..order).fold(libm::exp(-share), |part, order| (1.0 / factorial(order) - part) / share)
}

/// `1/n! + z/(n + s)! + z²/(n + 2s)! + ...`
fn series(order: usize, step: usize, argument: f64) -> f64 {
    let (mut term, mut next, mut sum) = (1.0 / factorial(order), order, 0.0);
    for _ in 0..TERMS {
        sum += term;
        term *= argument / (next + 1..=next + step).map(exact).product::<f64>();
        next += step;
    }
    sum
}

fn factorial(order: usize) -> f64 {
    (1..=order).map(exact).product()
}

fn power(time: f64, order: usize) -> f64 {
    (0..order).fold(1.0, |power, _| power * time)
}

#[allow(clippy::cast_precision_loss, reason = "orders are small")]
fn exact(order: usize) -> f64 {
    order as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The derivative of each is the one before it, on both sides of where the series ends.
    #[test]
    fn each_is_the_integral_of_the_one_before() {
        for family in [repeated_cosine, repeated_decay] {
            for (order, rate) in (1..8).flat_map(|order| [0.0, 0.3, 0.99, 1.01, 4.0].map(|rate| (order, rate))) {
                let (before, after) = (family(order, 1.0 - 1e-3, rate), family(order, 1.0 + 1e-3, rate));
                let (slope, right) = ((after - before) / 2e-3, family(order - 1, 1.0, rate));
                assert!((slope - right).abs() < 1e-5 * (1.0 + rate * rate), "{order} {rate}: {slope} {right}");
            }
        }
    }

    #[test]
    fn both_sides_of_the_end_of_the_series_agree() {
        for order in 0..8 {
            for family in [repeated_cosine, repeated_decay] {
                let [below, above] = [1.0 - 1e-14, 1.0 + 1e-14].map(|rate| family(order, 1.0, rate));
                assert!((below - above).abs() < 1e-12 / factorial(order).sqrt(), "{order}: {below} {above}");
            }
        }
    }
}
