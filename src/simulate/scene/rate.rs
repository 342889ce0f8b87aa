//! How fast a vector changes, from where it is at a few instants.

use super::vector::{Vector, ZERO, add, less, size, times};

/// By how many widths each of the instants lies apart from the first.
const INSTANTS: [f64; 5] = [0.0, 1.0, 2.0, 3.0, 4.0];

/// The slope at the first instant of the polynomial through all of them, in units of the width.
const WEIGHTS: [f64; 5] = [-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -1.0 / 4.0];

/// How fast a vector changes, and how far that may be off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rate {
    pub value: Vector,
    pub off: f64,
}

/// The rate of change just after an instant, or just before it where the width is negative. `at` says what the vector is so much
/// later; one half as wide says how far the rate may be off.
pub(super) fn rate<E>(width: f64, at: impl Fn(f64) -> Result<Vector, E>) -> Result<Rate, E> {
    let slope = |width: f64| -> Result<(Vector, f64), E> {
        INSTANTS.into_iter().zip(WEIGHTS).try_fold((ZERO, 0.0_f64), |(sum, largest), (instant, weight)| {
            let rate = at(instant * width)?;
            Ok((add(sum, times(weight / width, rate)), largest.max(size(rate))))
        })
    };
    let ((wide, largest), (value, _)) = (slope(width)?, slope(width / 2.0)?);
    let rounding = 16.0 * f64::EPSILON * largest / width.abs();
    Ok(Rate { value, off: size(less(wide, value)) + rounding })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use core::convert::Infallible;

    #[test]
    fn a_rate_is_as_near_as_it_says() {
        for width in [1e-2, -1e-2, 1e-3] {
            let curve = |time: f64| Ok::<_, Infallible>([libm::exp(time), libm::sin(time), 5.0]);
            let found = rate(width, curve).unwrap();
            let apart = size(less(found.value, [1.0, 1.0, 0.0]));
            assert!(apart <= found.off && found.off < 1e-7, "{found:?}: {apart:e} apart");
        }
    }
}
