//! Exact arithmetic as long as it lasts, with rational numbers and rational multiples of pi; balls of 77 digits from then on.

use dashu::base::{Abs, Approximation, BitTest, Sign as Parity, SquareRoot};
use dashu::float::round::mode::HalfEven;

use momentous_expr::Function;
use momentous_quantity::Rational;

use super::super::Exact;
use super::ball::{BITS, Ball, Float, RADIUS_BITS, Radius, divisor, float, radius_of, small};
use super::bounded::Bounded;
use super::real::{Real, Sign};
use super::right_angles::{rational_cosine, rational_sine};

/// Rational numbers with more bits than this go on as balls.
const LONGEST: usize = 1 << 14;
/// Exponentials of larger arguments are not computed.
const LARGEST_EXPONENT: f64 = 1e6;
/// Sines of larger arguments are not computed.
const LARGEST_ANGLE: f64 = 1e18;

/// A rational number or multiple of pi; or a middle and a radius within which the true value lies.
#[derive(Clone, Debug)]
pub enum Precise {
    /// Exactly this.
    Rational(Rational),
    /// Exactly this multiple of pi, which is not zero: the sine of 180 degrees is zero, not a small number.
    Angle(Rational),
    /// Within the radius of the middle.
    Ball(Ball),
    /// A value of which nothing is known.
    Unbounded,
    /// There is no real value.
    NotReal,
}

impl Precise {
    fn ball(&self) -> Option<Ball> {
        match self {
            Self::Rational(value) => Some(Ball::from_rational(value)),
            Self::Angle(multiple) => Some(Ball::from_angle(multiple)),
            Self::Ball(ball) => Some(ball.clone()),
            Self::Unbounded | Self::NotReal => None,
        }
    }

    fn rational(value: Rational) -> Self {
        let bits = value.numerator().bit_len() + value.denominator().bit_len();
        if bits > LONGEST { Self::Ball(Ball::from_rational(&value)) } else { Self::Rational(value) }
    }

    fn angle(multiple: Rational) -> Self {
        match Self::rational(multiple) {
            Self::Rational(multiple) if !multiple.is_zero() => Self::Angle(multiple),
            Self::Ball(multiple) => Self::Ball(multiple.times(Ball::pi())),
            zero => zero,
        }
    }

    /// The result of an operation without two ordinary operands.
    fn lost(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::NotReal, _) | (_, Self::NotReal) => Self::NotReal,
            _ => Self::Unbounded,
        }
    }

    fn balls(&self, other: &Self, combine: impl FnOnce(Ball, Ball) -> Self) -> Self {
        match (self.ball(), other.ball()) {
            (Some(ball), Some(other)) => combine(ball, other),
            _ => self.lost(other),
        }
    }

    /// The value in decimal digits, without its error; `None` where there is none.
    #[must_use]
    pub fn decimal(&self, digits: usize) -> Option<String> {
        let ball = self.ball()?;
        Some(ball.middle.to_decimal().value().with_precision(digits.max(1)).value().to_string())
    }

    /// Sine or cosine: `exact` of a multiple of pi, where it has a value, and `function` of everything else.
    fn wave(&self, exact: fn(&Rational) -> Option<Rational>, function: impl FnOnce(&Float) -> Float) -> Self {
        if let Self::Angle(multiple) = self
            && let Some(value) = exact(multiple)
        {
            return Self::Rational(value);
        }
        let Some(ball) = self.ball() else { return self.clone() };
        if ball.middle.to_f64().value().abs() > LARGEST_ANGLE {
            return Self::Unbounded;
        }
        Self::Ball(Ball::rounded(function(&ball.middle), ball.radius))
    }

    fn exponential(&self) -> Self {
        let Some(ball) = self.ball() else { return self.clone() };
        if ball.middle.to_f64().value().abs() > LARGEST_EXPONENT || ball.radius > small(1) {
            return Self::Unbounded;
        }
        // exp(m) (exp(r) - 1), where exp(r) - 1 is at most 2 r up to r = 1.
        let value = ball.middle.exp();
        let radius = radius_of(&value) * ball.radius * small(2);
        Self::Ball(Ball::rounded(value, radius))
    }

    fn logarithm(&self) -> Self {
        let Some(ball) = self.ball() else { return self.clone() };
        if ball.reaches_zero() {
            return if self.sign() == Sign::Zero { Self::NotReal } else { Self::Unbounded };
        }
        if ball.is_negative() {
            return Self::NotReal;
        }
        let radius = ball.radius.clone() / divisor(ball.least());
        Self::Ball(Ball::rounded(ball.middle.ln(), radius))
    }

    /// Arc sine or arc cosine.
    fn arc(&self, function: impl FnOnce(&Float) -> Float) -> Self {
        let Some(mut ball) = self.ball() else { return self.clone() };
        let room = Float::ONE - ball.middle.clone().abs();
        let radius = ball.radius.clone().with_rounding::<HalfEven>();
        if room.clone() + radius.clone() < Float::ZERO {
            return Self::NotReal;
        }
        let inner = room.clone() - radius;
        if room < Float::ZERO {
            ball.middle = if ball.is_negative() { float(-1) } else { float(1) };
        }
        let radius = if ball.radius == Radius::ZERO {
            small(0)
        } else if inner > Float::ZERO {
            // The slope is at most 1 / sqrt(1 - |x|) over the ball.
            ball.radius / divisor(inner.with_precision(BITS).value().sqrt())
        } else {
            // |acos a - acos b| <= pi / sqrt 2 sqrt |a - b| anywhere; a moved middle doubles the distance.
            (ball.radius * small(2)).with_precision(RADIUS_BITS).value().sqrt() * small(3)
        };
        Self::Ball(Ball::rounded(function(&ball.middle), radius))
    }
}

impl Real for Precise {
    const SPACING: f64 = 1e-75;

    fn from_exact(exact: &Exact) -> Self {
        let rational = Self::rational(exact.rational.clone());
        match exact.pi_power {
            0 => rational,
            1 => Self::angle(exact.rational.clone()),
            power => rational.mul(&Self::Ball(Ball::pi()).powi(i32::from(power))),
        }
    }

    fn integer(value: i64) -> Self {
        Self::Rational(Rational::from(value))
    }

    fn point(value: f64) -> Self {
        Rational::try_from(value).map_or(Self::Unbounded, Self::Rational)
    }

    fn not_real() -> Self {
        Self::NotReal
    }

    fn add(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Rational(one), Self::Rational(other)) => Self::rational(one + other),
            (Self::Angle(one), Self::Angle(other)) => Self::angle(one + other),
            (Self::Rational(zero), other) | (other, Self::Rational(zero)) if zero.is_zero() => other.clone(),
            _ => self.balls(other, |ball, other| {
                Self::Ball(Ball::rounded(ball.middle + other.middle, ball.radius + other.radius))
            }),
        }
    }

    fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    fn mul(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Rational(one), Self::Rational(other)) => Self::rational(one * other),
            (Self::Rational(factor), Self::Angle(angle)) | (Self::Angle(angle), Self::Rational(factor)) => {
                Self::angle(factor * angle)
            }
            (zero @ Self::Rational(number), Self::Ball(_)) if number.is_zero() => zero.clone(),
            (Self::Ball(_), zero @ Self::Rational(other)) if other.is_zero() => zero.clone(),
            _ => self.balls(other, |ball, other| Self::Ball(ball.times(other))),
        }
    }

    fn div(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::NotReal, _) => Self::NotReal,
            (_, Self::Rational(other)) if other.is_zero() => Self::NotReal,
            (Self::Rational(one), Self::Rational(other)) | (Self::Angle(one), Self::Angle(other)) => {
                Self::rational(one / other)
            }
            (Self::Angle(angle), Self::Rational(other)) => Self::angle(angle / other),
            (zero @ Self::Rational(number), Self::Angle(_)) if number.is_zero() => zero.clone(),
            (zero @ Self::Rational(number), Self::Ball(ball)) if number.is_zero() && !ball.reaches_zero() => {
                zero.clone()
            }
            _ => self.balls(other, |ball, other| {
                if other.reaches_zero() {
                    return Self::Unbounded;
                }
                let least = divisor(other.least());
                let value = ball.middle / other.middle;
                // The quotient's own rounding joins the radius after; twice the spread covers it here.
                let spread = (ball.radius + radius_of(&value) * other.radius * small(2)) / least;
                Self::Ball(Ball::rounded(value, spread))
            }),
        }
    }

    fn neg(&self) -> Self {
        match self {
            Self::Rational(value) => Self::Rational(-value.clone()),
            Self::Angle(multiple) => Self::Angle(-multiple.clone()),
            Self::Ball(ball) => Self::Ball(Ball { middle: -ball.middle.clone(), radius: ball.radius.clone() }),
            other => other.clone(),
        }
    }

    fn sqrt(&self) -> Self {
        if let Self::Rational(value) = self {
            if *value < Rational::ZERO {
                return Self::NotReal;
            }
            let (above, below) = (value.numerator().clone().into_parts().1, value.denominator().clone());
            let (root, divisor) = (above.sqrt(), below.sqrt());
            if root.pow(2) == above && divisor.pow(2) == below {
                return Self::Rational(Rational::from(root) / Rational::from(divisor));
            }
        }
        let Some(ball) = self.ball() else { return self.clone() };
        if ball.reaches_zero() {
            let most = (ball.size() + ball.radius.clone()).with_precision(RADIUS_BITS).value();
            let value = if ball.is_negative() { float(0) } else { ball.middle.sqrt() };
            return Self::Ball(Ball::rounded(value, most.sqrt()));
        }
        if ball.is_negative() {
            return Self::NotReal;
        }
        let radius = ball.radius.clone() / divisor(ball.least().with_precision(BITS).value().sqrt());
        Self::Ball(Ball::rounded(ball.middle.sqrt(), radius))
    }

    fn apply(&self, function: Function) -> Self {
        let is_zero = self.sign() == Sign::Zero;
        match function {
            Function::Sin | Function::Tan | Function::Asin if is_zero => self.clone(),
            Function::Cos | Function::Exp if is_zero => Self::integer(1),
            Function::Sin => self.wave(rational_sine, Float::sin),
            Function::Cos => self.wave(rational_cosine, Float::cos),
            Function::Tan => self.apply(Function::Sin).div(&self.apply(Function::Cos)),
            Function::Asin => self.arc(Float::asin),
            Function::Acos => self.arc(Float::acos),
            Function::Exp => self.exponential(),
            Function::Ln => self.logarithm(),
            Function::Abs if self.rough() < 0.0 || self.sign() == Sign::Negative => self.neg(),
            Function::Abs => self.clone(),
            Function::Atan2 => self.atan2(&Self::integer(1)),
        }
    }

    fn atan2(&self, x: &Self) -> Self {
        match (self.sign(), x.sign()) {
            (Sign::Zero, Sign::Zero) => return Self::NotReal,
            (Sign::Zero, Sign::Positive) => return Self::integer(0),
            (Sign::Zero, Sign::Negative) => return Self::Angle(Rational::ONE),
            (Sign::Positive, Sign::Zero) => return Self::Angle(Rational::ONE / Rational::from(2)),
            (Sign::Negative, Sign::Zero) => return Self::Angle(-Rational::ONE / Rational::from(2)),
            _ => {}
        }
        let (unsure, x_sign) = (self.sign() == Sign::Unsure, x.sign());
        let cut = unsure && x_sign != Sign::Positive && x_sign != Sign::Negative;
        // Half a turn one way is half a turn the other way: on either side of the cut it is counted one way.
        let counted_on = unsure && x_sign == Sign::Negative;
        self.balls(x, |y, x| {
            let spread = y.radius.clone() + x.radius.clone();
            let square = y.middle.clone() * y.middle.clone() + x.middle.clone() * x.middle.clone();
            let distance = square.with_precision(BITS).value().sqrt();
            let free = distance - spread.clone().with_rounding::<HalfEven>();
            if cut || free <= Float::ZERO {
                return Self::Ball(Ball { middle: float(0), radius: small(4) });
            }
            let value = y.middle.with_precision(BITS).value().atan2(&x.middle.with_precision(BITS).value());
            let value = if counted_on && value < Float::ZERO { value + float(2) * Ball::pi().middle } else { value };
            Self::Ball(Ball::rounded(value, spread / divisor(free)))
        })
    }

    fn hull(&self, other: &Self) -> Self {
        self.balls(other, |ball, other| {
            let middle = (ball.middle.clone() + other.middle.clone()) / float(2);
            let apart = radius_of(&((ball.middle - other.middle) / float(2)));
            let radius = if ball.radius > other.radius { ball.radius } else { other.radius };
            Self::Ball(Ball::rounded(middle, apart + radius))
        })
    }

    fn centre(&self) -> Self {
        match self {
            Self::Ball(ball) => Self::Ball(Ball { middle: ball.middle.clone(), radius: small(0) }),
            other => other.clone(),
        }
    }

    fn sign(&self) -> Sign {
        let sign = |negative: bool| if negative { Sign::Negative } else { Sign::Positive };
        match self {
            Self::Rational(value) if value.is_zero() => Sign::Zero,
            Self::Rational(value) | Self::Angle(value) => sign(value.numerator().sign() == Parity::Negative),
            Self::Ball(ball) if ball.reaches_zero() => Sign::Unsure,
            Self::Ball(ball) => sign(ball.is_negative()),
            Self::Unbounded => Sign::Unsure,
            Self::NotReal => Sign::NotReal,
        }
    }

    fn to_bounded(&self) -> Bounded {
        match self {
            Self::Rational(value) => match value.to_f64() {
                Approximation::Exact(value) => Bounded::exactly(value),
                Approximation::Inexact(value, _) => Bounded::rounded(value, 0.0),
            },
            Self::Angle(multiple) => Self::Ball(Ball::from_angle(multiple)).to_bounded(),
            Self::Ball(ball) => Bounded::rounded(ball.middle.to_f64().value(), ball.radius.to_f64().value()),
            Self::Unbounded => Bounded { value: 0.0, error: f64::INFINITY },
            Self::NotReal => Bounded { value: f64::NAN, error: f64::NAN },
        }
    }

    fn is_unbounded(&self) -> bool {
        matches!(self, Self::Unbounded)
    }
}
