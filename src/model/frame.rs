//! Directions of a scene, and the axes along and across a line of impact.

use momentous_expr::Expr;

/// A direction in the plane of the first two axes, or along the third.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Direction {
    /// Quarter turns from the first axis to the axis that the words start from; none or two where it lies along the third.
    pub quarters: u8,
    /// The angle from there, counter-clockwise; zero along an axis.
    pub turn: Expr,
    /// Whether it lies along the third axis of a scene, or against it.
    pub across: bool,
}

impl Direction {
    /// The direction along (or, with `reversed`, against) the axis of that position.
    pub(super) fn axis(position: usize, reversed: bool) -> Self {
        let quarters = u8::from(position == 1) + if reversed { 2 } else { 0 };
        Self { quarters, turn: Expr::zero(), across: position == 2 }
    }

    /// The direction at that angle from an axis, in the plane of the first two.
    pub(super) fn turned(quarters: u8, turn: Expr) -> Self {
        Self { quarters, turn, across: false }
    }

    /// Cosine and sine of the whole angle, written with the angle that the author named.
    #[must_use]
    pub fn cosine_and_sine(&self) -> [Expr; 2] {
        if self.across {
            return [Expr::zero(), Expr::zero()];
        }
        let (cos, sin) = if self.turn.is_zero() {
            (Expr::one(), Expr::zero())
        } else {
            (self.turn.clone().cos().simplify(), self.turn.clone().sin().simplify())
        };
        match self.quarters % 4 {
            0 => [cos, sin],
            1 => [-sin, cos],
            2 => [-cos, -sin],
            _ => [sin, -cos],
        }
    }

    /// Components along the axis from which the direction is counted, and at 90° to it counter-clockwise.
    #[must_use]
    pub fn from_axis(&self, x: &Expr, y: &Expr) -> [Expr; 2] {
        let (x, y) = (x.clone(), y.clone());
        match self.quarters % 4 {
            0 => [x, y],
            1 => [y, -x],
            2 => [-x, -y],
            _ => [-y, x],
        }
    }
}

/// The axes n and t of a contact.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The direction of n; t lies at 90° to it, counter-clockwise.
    pub normal: Direction,
}

/// An angle above (1) or below (-1) an axis, as authors write a direction: `alpha above +x`.
#[must_use]
pub fn above_or_below(text: &str) -> Option<(&str, i64, &str)> {
    let split = |(joint, sign)| text.split_once(joint).map(|(turn, base)| (turn, sign, base));
    [(" above ", 1), (" below ", -1)].into_iter().find_map(split)
}

/// Whether an axis is written with the sign of its negative direction: `-x`.
#[must_use]
pub fn is_reversed(axis: &str) -> bool {
    axis.trim().starts_with('-')
}
