//! What a partly right answer is worth.

use crate::quantity::Rational;

use super::verdict::Verdict;

/// The fraction of a part's points for each kind of partly right answer, each from 0 to 1.
///
/// The defaults are those of an instructor who asks for physics first: a number that is right shows that the
/// method is, so a slip of writing beside it costs half; a direction that is plainly the wrong one is wrong physics.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rubric {
    /// The right number without its unit. Default: 1/2.
    pub unit_missing: Rational,
    /// The right number with another unit of the same dimension. Default: 1/2.
    pub unit_wrong: Rational,
    /// The right number with a unit of something else. Default: 1/2.
    pub unit_wrong_dimension: Rational,
    /// Off by the factor of a prefix: grams for kilograms. Default: 1/2.
    pub unit_prefix: Rational,
    /// Off by another power of ten. Default: 0.
    pub order_of_magnitude: Rational,
    /// The magnitude of a signed quantity, its direction unsaid. Default: 1/2.
    pub sense: Rational,
    /// The right magnitude in the opposite direction. Default: 0.
    pub sense_reversed: Rational,
    /// A wrong answer that follows from an earlier one. Default: 1, since the step itself is right.
    pub follow_through: Rational,
    /// The same, where the earlier answer makes something impossible happen, which the student might have seen. Default: 1/2.
    pub follow_through_unphysical: Rational,
}

impl Default for Rubric {
    fn default() -> Self {
        let half = || Rational::ONE / Rational::from(2);
        Self {
            unit_missing: half(),
            unit_wrong: half(),
            unit_wrong_dimension: half(),
            unit_prefix: half(),
            order_of_magnitude: Rational::ZERO,
            sense: half(),
            sense_reversed: Rational::ZERO,
            follow_through: Rational::ONE,
            follow_through_unphysical: half(),
        }
    }
}

impl Rubric {
    /// The fraction of the points for a verdict, held between 0 and 1.
    ///
    /// ```
    /// use momentous::grade::{Rubric, Verdict};
    /// assert_eq!(Rubric::default().fraction(Verdict::UnitMissing).to_string(), "1/2");
    /// ```
    #[must_use]
    pub fn fraction(&self, verdict: Verdict) -> Rational {
        let fraction = match verdict {
            Verdict::Right | Verdict::RightRounded | Verdict::RightWithNote => &Rational::ONE,
            Verdict::Sense => &self.sense,
            Verdict::SenseReversed => &self.sense_reversed,
            Verdict::FollowThrough => &self.follow_through,
            Verdict::FollowThroughUnphysical => &self.follow_through_unphysical,
            Verdict::UnitMissing => &self.unit_missing,
            Verdict::UnitWrong => &self.unit_wrong,
            Verdict::UnitWrongDimension => &self.unit_wrong_dimension,
            Verdict::UnitPrefix => &self.unit_prefix,
            Verdict::OrderOfMagnitude => &self.order_of_magnitude,
            Verdict::Wrong | Verdict::ChoiceWrong | Verdict::Unreadable | Verdict::Unanswered => &Rational::ZERO,
        };
        fraction.clone().clamp(Rational::ZERO, Rational::ONE)
    }
}
