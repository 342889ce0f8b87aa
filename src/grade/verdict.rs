//! Verdicts of marking: one stable code for each kind of finding.

use std::fmt;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The verdict on the answer to one part. The codes are stable: tools match on them.
///
/// ```
/// use momentous_grade::Verdict;
/// assert_eq!(Verdict::UnitMissing.code(), "unit_missing");
/// assert!(Verdict::RightRounded.is_right());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
#[allow(missing_docs, reason = "the table below says of each what it means")]
pub enum Verdict {
    Right,
    RightRounded,
    RightWithNote,
    RightAgrees,
    FiguresFew,
    FiguresMany,
    FiguresWrong,
    UnitNotAsked,
    UnitMissing,
    UnitWrong,
    UnitWrongDimension,
    UnitPrefix,
    OrderOfMagnitude,
    RoundingSlip,
    SomeValues,
    Sense,
    SenseReversed,
    AngleReversed,
    AngleOtherSense,
    AngleSupplement,
    AngleComplement,
    AngleOtherAxis,
    ComponentsExchanged,
    ComponentSign,
    DirectionWrong,
    BodiesSwapped,
    IntervalEnds,
    IntervalHalf,
    FormulaFactor,
    FormulaDimension,
    Wrong,
    FollowThrough,
    FollowThroughUnphysical,
    ChoiceWrong,
    Unreadable,
    Unanswered,
    NotIssued,
}

/// Which part of the points a verdict is worth where the rubric says nothing.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Worth {
    /// All of them: the answer is right.
    All,
    /// This fraction, which a rubric may change.
    Part(u8, u8),
    /// No points, whatever the rubric says.
    Nothing,
}

use Worth::{All, Nothing, Part};

/// Every verdict: its code, what it means, and what it is worth. The order is that of the type.
const TABLE: &[(Verdict, &str, &str, Worth)] = &[
    (Verdict::Right, "right", "right", All),
    (
        Verdict::RightRounded,
        "right_rounded",
        "right: outside the tolerance, but by no more than rounding intermediate values can cause",
        All,
    ),
    (
        Verdict::RightWithNote,
        "right_with_note",
        "right, with a remark: a pound was read as a mass, a speed has a sign",
        All,
    ),
    (
        Verdict::RightAgrees,
        "right_agrees",
        "a formula that agrees numerically with the expected one, but was not proven equal",
        All,
    ),
    (Verdict::FiguresFew, "figures_few", "the right value, written with fewer figures than are required", Part(3, 4)),
    (
        Verdict::FiguresMany,
        "figures_many",
        "the right value, written with more figures than the data support, where that is required",
        Part(3, 4),
    ),
    (
        Verdict::FiguresWrong,
        "figures_wrong",
        "within the tolerance, but the last required figure is not right",
        Part(3, 4),
    ),
    (Verdict::UnitNotAsked, "unit_not_asked", "right, but in another unit than the question requires", Part(1, 2)),
    (Verdict::UnitMissing, "unit_missing", "the right number without its unit", Part(1, 2)),
    (Verdict::UnitWrong, "unit_wrong", "the right number with another unit of the same dimension", Part(1, 2)),
    (
        Verdict::UnitWrongDimension,
        "unit_wrong_dimension",
        "the right number with a unit that measures something else",
        Part(1, 2),
    ),
    (Verdict::UnitPrefix, "unit_prefix", "off by the factor of a prefix: grams for kilograms", Part(1, 2)),
    (Verdict::OrderOfMagnitude, "order_of_magnitude", "off by a power of ten that is not a usual prefix", Part(0, 1)),
    (Verdict::RoundingSlip, "rounding_slip", "right to one figure fewer than asked: rounded too early", Part(1, 2)),
    (
        Verdict::SomeValues,
        "some_values",
        "some of several values, or too many: each right one counts, and each wrong one cancels a right one",
        Nothing,
    ),
    (Verdict::Sense, "sense", "the right magnitude without the sign or the word that gives the direction", Part(1, 2)),
    (Verdict::SenseReversed, "sense_reversed", "the right magnitude in the opposite direction", Part(0, 1)),
    (Verdict::AngleReversed, "angle_reversed", "the opposite direction: half a turn off", Part(0, 1)),
    (
        Verdict::AngleOtherSense,
        "angle_other_sense",
        "the size of the angle is right, but it was measured in the opposite sense",
        Part(0, 1),
    ),
    (
        Verdict::AngleSupplement,
        "angle_supplement",
        "the supplement: measured from the other end of the axis",
        Part(0, 1),
    ),
    (
        Verdict::AngleComplement,
        "angle_complement",
        "the complement: measured towards the reference from the other axis",
        Part(0, 1),
    ),
    (Verdict::AngleOtherAxis, "angle_other_axis", "a quarter turn off: measured from the other axis", Part(0, 1)),
    (
        Verdict::ComponentsExchanged,
        "components_exchanged",
        "the right components of a vector in the wrong places",
        Part(0, 1),
    ),
    (Verdict::ComponentSign, "component_sign", "a vector with a component of the wrong sign", Part(0, 1)),
    (Verdict::DirectionWrong, "direction_wrong", "a vector of the right magnitude in a wrong direction", Part(0, 1)),
    (Verdict::BodiesSwapped, "bodies_swapped", "the right value of another body's quantity", Part(0, 1)),
    (
        Verdict::IntervalEnds,
        "interval_ends",
        "the right end points, but one is included that must not be, or the other way round",
        Part(1, 2),
    ),
    (
        Verdict::IntervalHalf,
        "interval_half",
        "an interval with one right end point, or one on the other side of the right boundary",
        Part(0, 1),
    ),
    (Verdict::FormulaFactor, "formula_factor", "a formula that is right except for a constant factor", Part(0, 1)),
    (
        Verdict::FormulaDimension,
        "formula_dimension",
        "a formula that adds or compares quantities of different dimensions, or has another dimension than the quantity asked for",
        Part(0, 1),
    ),
    (Verdict::Wrong, "wrong", "not right", Nothing),
    (
        Verdict::FollowThrough,
        "follow_through",
        "wrong, but it follows from an earlier answer of the student's own",
        Part(1, 1),
    ),
    (
        Verdict::FollowThroughUnphysical,
        "follow_through_unphysical",
        "the same, but the earlier answer makes something impossible happen",
        Part(1, 2),
    ),
    (Verdict::ChoiceWrong, "choice_wrong", "the wrong option", Nothing),
    (
        Verdict::Unreadable,
        "unreadable",
        "the answer cannot be read, or a formula cannot be judged; it is not marked and costs no attempt",
        Nothing,
    ),
    (Verdict::Unanswered, "unanswered", "there is no answer", Nothing),
    (Verdict::NotIssued, "not_issued", "the student was not given this sheet; nothing on it is marked", Nothing),
];

impl Verdict {
    /// Every verdict, in the order of their importance in the documentation.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.iter().map(|(verdict, ..)| *verdict)
    }

    /// Its stable code.
    #[must_use]
    pub fn code(self) -> &'static str {
        self.row().1
    }

    /// The verdict with that code.
    #[must_use]
    pub fn of(code: &str) -> Option<Self> {
        TABLE.iter().find(|row| row.1 == code).map(|row| row.0)
    }

    /// Its meaning, in a clause.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        self.row().2
    }

    /// Whether the answer is fully right.
    #[must_use]
    pub fn is_right(self) -> bool {
        self.row().3 == All
    }

    /// The fraction of the points that it is worth where a rubric says nothing: above and below the bar.
    #[must_use]
    pub fn usual_fraction(self) -> (u8, u8) {
        match self.row().3 {
            All => (1, 1),
            Part(above, below) => (above, below),
            Nothing => (0, 1),
        }
    }

    /// Whether a rubric may say what it is worth.
    #[must_use]
    pub fn is_negotiable(self) -> bool {
        matches!(self.row().3, Part(..))
    }

    fn row(self) -> &'static (Self, &'static str, &'static str, Worth) {
        &TABLE[self as usize]
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

impl<'de> Deserialize<'de> for Verdict {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let code = String::deserialize(deserializer)?;
        Self::of(&code).ok_or_else(|| D::Error::custom("there is no verdict with this code"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_stands_in_the_order_of_the_type_and_its_codes_differ() {
        let mut codes: Vec<&str> = Vec::new();
        for (position, (verdict, code, meaning, _)) in TABLE.iter().enumerate() {
            assert_eq!(*verdict as usize, position, "{code}");
            assert!(code.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'_'), "{code}");
            assert!(!meaning.is_empty() && !codes.contains(code), "{code}");
            assert_eq!(Verdict::of(code), Some(*verdict));
            codes.push(code);
        }
        assert_eq!(Verdict::NotIssued as usize + 1, TABLE.len());
    }
}
