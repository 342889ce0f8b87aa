//! What marking found: one stable code for each kind of finding.

use std::fmt;

use serde::{Serialize, Serializer};

/// What was found about the answer to one part. The codes are stable: tools match on them.
///
/// ```
/// use momentous::grade::Verdict;
/// assert_eq!(Verdict::UnitMissing.code(), "unit_missing");
/// assert!(Verdict::RightRounded.is_right());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Verdict {
    /// Right.
    Right,
    /// Right: further away than the tolerance, but no further than honest rounding of intermediate values can lead.
    RightRounded,
    /// Right, and something is to be said: a pound was read as a mass, a speed has a sign.
    RightWithNote,
    /// The magnitude is right, and the sign that says the direction is missing.
    Sense,
    /// The magnitude is right, and the answer says the opposite direction.
    SenseReversed,
    /// The number is right, and its unit is missing.
    UnitMissing,
    /// The number is right, and its unit is another one of the same dimension.
    UnitWrong,
    /// The number is right, and its unit measures something else.
    UnitWrongDimension,
    /// Off by the factor of a prefix: grams for kilograms, kilometres for metres.
    UnitPrefix,
    /// Off by a power of ten that is no usual prefix.
    OrderOfMagnitude,
    /// Not right.
    Wrong,
    /// Wrong, but it follows from an earlier answer of the student's own.
    FollowThrough,
    /// The same, where the earlier answer makes something impossible happen.
    FollowThroughUnphysical,
    /// Another phrase was chosen.
    ChoiceWrong,
    /// The answer cannot be read; it is not marked.
    Unreadable,
    /// There is no answer.
    Unanswered,
}

impl Verdict {
    /// Every verdict.
    pub const ALL: [Self; 16] = [
        Self::Right,
        Self::RightRounded,
        Self::RightWithNote,
        Self::Sense,
        Self::SenseReversed,
        Self::UnitMissing,
        Self::UnitWrong,
        Self::UnitWrongDimension,
        Self::UnitPrefix,
        Self::OrderOfMagnitude,
        Self::Wrong,
        Self::FollowThrough,
        Self::FollowThroughUnphysical,
        Self::ChoiceWrong,
        Self::Unreadable,
        Self::Unanswered,
    ];

    /// Its stable code.
    #[must_use]
    pub fn code(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::RightRounded => "right_rounded",
            Self::RightWithNote => "right_with_note",
            Self::Sense => "sense",
            Self::SenseReversed => "sense_reversed",
            Self::UnitMissing => "unit_missing",
            Self::UnitWrong => "unit_wrong",
            Self::UnitWrongDimension => "unit_wrong_dimension",
            Self::UnitPrefix => "unit_prefix",
            Self::OrderOfMagnitude => "order_of_magnitude",
            Self::Wrong => "wrong",
            Self::FollowThrough => "follow_through",
            Self::FollowThroughUnphysical => "follow_through_unphysical",
            Self::ChoiceWrong => "choice_wrong",
            Self::Unreadable => "unreadable",
            Self::Unanswered => "unanswered",
        }
    }

    /// Whether the answer is fully right.
    #[must_use]
    pub fn is_right(self) -> bool {
        matches!(self, Self::Right | Self::RightRounded | Self::RightWithNote)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.code())
    }
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.code())
    }
}
