//! Plane geometry of drawings: points as vectors, arrow heads, arcs as points, numbers as text.

use std::ops::{Add, Mul, Neg, Sub};

use super::Point;

/// Length of a full arrow head.
const HEAD_LENGTH: f64 = 7.5;
/// Half the width of a full arrow head.
const HEAD_HALF_WIDTH: f64 = 2.7;
/// The head takes at most this part of a short arrow.
const HEAD_SHARE: f64 = 0.65;

impl Point {
    /// The origin.
    pub const ORIGIN: Self = Self { x: 0.0, y: 0.0 };

    /// The point (x, y).
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The vector of that length at an angle in radians, counter-clockwise from the right.
    #[must_use]
    pub fn polar(length: f64, angle: f64) -> Self {
        Self::new(length * libm::cos(angle), length * libm::sin(angle))
    }

    /// Its distance from the origin.
    #[must_use]
    pub fn length(self) -> f64 {
        libm::hypot(self.x, self.y)
    }

    /// Its angle in radians, between -pi and pi.
    #[must_use]
    pub fn angle(self) -> f64 {
        libm::atan2(self.y, self.x)
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The same vector turned by 90 degrees, counter-clockwise.
    #[must_use]
    pub fn turned(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// The same vector turned by an angle in radians, counter-clockwise.
    #[must_use]
    pub fn rotated(self, angle: f64) -> Self {
        self.turned_by(cosine_and_sine(angle))
    }

    /// The same vector turned by an angle, told by its cosine and sine.
    fn turned_by(self, [cosine, sine]: [f64; 2]) -> Self {
        Self::new(self.x * cosine - self.y * sine, self.x * sine + self.y * cosine)
    }

    /// The point that divides the way to `end`: 0 here, 1 there.
    #[must_use]
    pub fn towards(self, end: Self, part: f64) -> Self {
        self + (end - self) * part
    }
}

impl Add for Point {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Point {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}

impl Neg for Point {
    type Output = Self;
    fn neg(self) -> Self {
        self * -1.0
    }
}

/// Most things on drawings stand level.
fn cosine_and_sine(angle: f64) -> [f64; 2] {
    if angle == 0.0 { [1.0, 0.0] } else { [libm::cos(angle), libm::sin(angle)] }
}

/// The filled head of an arrow, tip first, and the point where its shaft ends.
///
/// The head shrinks with short arrows, so that a shaft always remains to be seen.
pub(super) fn arrow_head(from: Point, to: Point) -> ([Point; 3], Point) {
    let along = to - from;
    let length = along.length();
    if length <= 0.0 {
        return ([to; 3], to);
    }
    let unit = along * (1.0 / length);
    let head = HEAD_LENGTH.min(HEAD_SHARE * length);
    let side = unit.turned() * (HEAD_HALF_WIDTH * head / HEAD_LENGTH);
    let base = to - unit * head;
    ([to, base + side, base - side], base)
}

/// An arc as a line through points, close enough together for the eye.
pub(super) fn arc_points(centre: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    const PARTS: u32 = 32;
    let angle = |part: u32| from + (to - from) * f64::from(part) / f64::from(PARTS);
    (0..=PARTS).map(|part| centre + Point::polar(radius, angle(part))).collect()
}

/// The corners of a turned rectangle, counter-clockwise from its lower left.
pub(super) fn corners(centre: Point, size: Point, angle: f64) -> [Point; 4] {
    let half = size * 0.5;
    let turn = cosine_and_sine(angle);
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(right, up)| centre + Point::new(right * half.x, up * half.y).turned_by(turn))
}

/// A coordinate as text: two decimals at most, no trailing zeros, never `-0`; anything that is not finite is `0`.
pub(super) fn coordinate(value: f64) -> String {
    let mut text = String::new();
    put_coordinate(&mut text, value);
    text
}

/// The same at the end of a text. A picture has thousands of coordinates, and the digits of whole numbers are written much
/// faster than doubles.
pub(super) fn put_coordinate(out: &mut String, value: f64) {
    let hundredths = hundredths(value);
    if hundredths < 0 {
        out.push('-');
    }
    let (whole, rest) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    put_digits(out, whole);
    if rest > 0 {
        out.push('.');
        out.push(digit(rest / 10));
    }
    if rest % 10 > 0 {
        out.push(digit(rest));
    }
}

/// The digits of a whole number, of which most have no more than three.
fn put_digits(out: &mut String, number: u64) {
    if number >= 1000 {
        put_digits(out, number / 1000);
    }
    for power in [100, 10] {
        if number >= power {
            out.push(digit(number / power));
        }
    }
    out.push(digit(number));
}

fn digit(number: u64) -> char {
    char::from(b'0' + (number % 10) as u8)
}

/// The part of a coordinate that is printed.
pub(super) fn hundredths(value: f64) -> i64 {
    let hundredths = (value * 100.0).round();
    #[allow(clippy::cast_possible_truncation, reason = "no picture is that large")]
    if hundredths.is_finite() { hundredths as i64 } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_short_and_never_negative_zero() {
        let cases = [(1.0, "1"), (-0.001, "0"), (2.345_6, "2.35"), (f64::NAN, "0"), (100.0, "100"), (-3.5, "-3.5")];
        for (value, text) in cases {
            assert_eq!(coordinate(value), text);
        }
    }

    #[test]
    fn the_head_of_a_short_arrow_leaves_a_shaft() {
        let (_, base) = arrow_head(Point::ORIGIN, Point::new(5.0, 0.0));
        assert!(base.x > 1.0);
    }
}
