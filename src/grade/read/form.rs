//! How a term of a calculation is written.

use super::answer::Written;

/// How a term is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// A decimal, perhaps times a power of ten.
    Decimal { least: usize, most: usize },
    /// A power of ten, with which a decimal stays a decimal.
    PowerOfTen,
    /// An angle in terms of pi, which needs no unit in a sine.
    Radians,
    /// The angle that belongs to a sine, cosine or tangent.
    Arc,
    /// Anything else.
    Computed,
}

impl Form {
    pub(super) fn written(self) -> Written {
        match self {
            Self::Decimal { least, most } => Written::Figures { least, most },
            _ => Written::Computed,
        }
    }

    /// How a product of two terms is written.
    pub(super) fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Decimal { most, .. }, Self::PowerOfTen) => Self::Decimal { least: most, most },
            (Self::Radians | Self::Arc, Self::Radians | Self::Arc) => Self::Computed,
            (form @ (Self::Radians | Self::Arc), _) | (_, form @ (Self::Radians | Self::Arc)) => form,
            _ => Self::Computed,
        }
    }
}
