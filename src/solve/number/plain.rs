//! Plain doubles as numbers of a tape: for what is only looked for, and needs no bound on its error.

use momentous_expr::Function;

use super::super::Exact;
use super::bounded::Bounded;
use super::real::{Real, Sign};

/// Without a bound: a sign is that of the computed value, and nothing is ever unsure.
impl Real for f64 {
    const SPACING: f64 = f64::EPSILON;

    fn from_exact(exact: &Exact) -> Self {
        Bounded::from_exact(exact).value
    }

    #[allow(clippy::cast_precision_loss, reason = "the nearest double is meant")]
    fn integer(value: i64) -> Self {
        value as Self
    }

    fn point(value: f64) -> Self {
        value
    }

    fn not_real() -> Self {
        Self::NAN
    }

    fn add(&self, other: &Self) -> Self {
        self + other
    }

    fn sub(&self, other: &Self) -> Self {
        self - other
    }

    fn mul(&self, other: &Self) -> Self {
        self * other
    }

    fn div(&self, other: &Self) -> Self {
        if *other == 0.0 { Self::NAN } else { self / other }
    }

    fn neg(&self) -> Self {
        -self
    }

    fn sqrt(&self) -> Self {
        Self::sqrt(*self)
    }

    fn apply(&self, function: Function) -> Self {
        function.evaluate(*self, 1.0)
    }

    fn atan2(&self, x: &Self) -> Self {
        if *self == 0.0 && *x == 0.0 { Self::NAN } else { libm::atan2(self + 0.0, *x) }
    }

    fn hull(&self, other: &Self) -> Self {
        0.5 * self + 0.5 * other
    }

    fn centre(&self) -> Self {
        *self
    }

    fn sign(&self) -> Sign {
        if *self > 0.0 {
            Sign::Positive
        } else if *self < 0.0 {
            Sign::Negative
        } else if self.is_nan() {
            Sign::NotReal
        } else {
            Sign::Zero
        }
    }

    fn to_bounded(&self) -> Bounded {
        Bounded { value: *self, error: Self::INFINITY }
    }

    fn is_unbounded(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_value_is_not_real() {
        let nothing =
            [1.0.div(&0.0), Real::sqrt(&-1.0), 0.0.atan2(&-0.0), 2.0.apply(Function::Acos), (-1.0).raise(&0.5)];
        assert!(nothing.iter().all(|number| !number.is_real()), "{nothing:?}");
        assert_eq!([2.0, -0.5, 0.0].map(|number: f64| number.sign()), [Sign::Positive, Sign::Negative, Sign::Zero]);
    }

    #[test]
    fn it_is_the_middle_of_what_is_bounded() {
        let (one, other) = (1.25, -0.75);
        let bounded = [one, other].map(Bounded::exactly);
        let pairs = [
            (one.add(&other), bounded[0].add(&bounded[1])),
            (one.sub(&other), bounded[0].sub(&bounded[1])),
            (one.mul(&other), bounded[0].mul(&bounded[1])),
            (one.div(&other), bounded[0].div(&bounded[1])),
            (Real::sqrt(&one), bounded[0].sqrt()),
            (one.apply(Function::Cos), bounded[0].apply(Function::Cos)),
            (Real::atan2(&one, &other), bounded[0].atan2(&bounded[1])),
            (one.powi(-3), bounded[0].powi(-3)),
            (one.root(3), bounded[0].root(3)),
        ];
        assert!(pairs.iter().all(|(plain, bounded)| plain.to_bits() == bounded.value.to_bits()), "{pairs:?}");
    }
}
