//! Long numbers with a radius of error.

use dashu::base::Abs;
use dashu::float::round::mode::{HalfEven, Up};
use dashu::float::{Context, FBig};
use dashu::integer::IBig;

use momentous_quantity::Rational;

/// The numbers of a ball's middle.
pub(super) type Float = FBig<HalfEven, 2>;
/// The numbers of a ball's radius; every operation rounds up.
pub(super) type Radius = FBig<Up, 2>;

/// The bits of a middle: about 77 digits.
pub(super) const BITS: usize = 256;
/// The bits of a radius.
pub(super) const RADIUS_BITS: usize = 32;
/// A middle and a radius.
#[derive(Clone, Debug)]
pub struct Ball {
    pub(crate) middle: Float,
    pub(super) radius: Radius,
}

fn context() -> Context<HalfEven> {
    Context::new(BITS)
}

pub(super) fn radius_of(value: &Float) -> Radius {
    value.clone().abs().with_rounding::<Up>().with_precision(RADIUS_BITS).value()
}

pub(crate) fn small(value: i32) -> Radius {
    Radius::from(value).with_precision(RADIUS_BITS).value()
}

pub(super) fn float(value: i32) -> Float {
    Float::from(value).with_precision(BITS).value()
}

impl Ball {
    /// A computed middle: its rounding, of a few units in its last place, joins the radius.
    pub(crate) fn rounded(middle: Float, radius: Radius) -> Self {
        // A zero that a function returns, ln 1, carries no precision, and the next function refuses it.
        let middle = middle.with_precision(BITS).value();
        if middle.repr().significand().is_zero() {
            return Self { middle, radius };
        }
        let unit = radius_of(&middle.ulp()) * small(4);
        Self { middle, radius: radius + unit }
    }

    pub(super) fn from_rational(value: &Rational) -> Self {
        let part = |integer: &IBig| context().convert_int::<2>(integer.clone()).value();
        let (above, below) = (part(value.numerator()), part(&IBig::from(value.denominator().clone())));
        Self::rounded(above / below, small(0))
    }

    pub(crate) fn pi() -> Self {
        Self::rounded(context().pi::<2>(None).value(), small(0))
    }

    /// Converts that multiple of pi.
    pub(super) fn from_angle(multiple: &Rational) -> Self {
        Self::from_rational(multiple).times(Self::pi())
    }

    pub(super) fn times(self, other: Self) -> Self {
        let spread = self.size() * other.radius.clone() + other.size() * self.radius.clone();
        Self::rounded(self.middle * other.middle, spread + self.radius * other.radius)
    }

    pub(crate) fn size(&self) -> Radius {
        radius_of(&self.middle)
    }

    /// The least size that the true value may have, rounded down; zero or less where zero is among its values.
    pub(crate) fn least(&self) -> Float {
        let size = self.middle.clone().abs() - self.radius.clone().with_rounding::<HalfEven>();
        let share = Float::ONE - (float(2)).powi((-40).into());
        size * share
    }

    pub(super) fn reaches_zero(&self) -> bool {
        self.least() <= Float::ZERO
    }

    pub(crate) fn is_negative(&self) -> bool {
        self.middle < Float::ZERO
    }
}

/// The radius as a divisor: rounded down.
pub(crate) fn divisor(value: Float) -> Radius {
    let shrunk = value * (Float::ONE - float(2).powi((-20).into()));
    shrunk.with_rounding::<Up>().with_precision(RADIUS_BITS).value()
}
