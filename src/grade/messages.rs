//! Everything that marking says to a student, as data; [`super::catalogue`] has the words.
//!
//! No message holds the right value, nor anything from which it follows.

use super::read::Unreadable;
use super::verdict::Verdict;

/// Something that a student is told.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Message {
    /// Right.
    Right,
    /// Right, and why: said to those only who found it.
    RightBecause(String),
    /// Right within honest rounding.
    RightRounded,
    /// A magnitude was given a minus sign.
    NegativeMagnitude,
    /// A pound was read as a mass.
    PoundsAsMass,
    /// Fewer figures than asked; how many are.
    TooFewFigures(usize),
    /// Fewer figures than asked, of an answer that is asked back; how many are.
    FiguresWanted(usize),
    /// More figures than asked; how many are.
    TooManyFigures(usize),
    /// The answer has as many figures as asked, and the last is not right.
    LastFigure,
    /// A formula that agrees with the right one, without a proof.
    Agrees,
    /// A formula that is right within the rounding of a number in it.
    RoundedNumber,
    /// A formula that has no real value for any values that the problem can have.
    NoValue,
    /// A formula of which it can be found neither that it is right nor that it is wrong.
    CannotBeJudged,
    /// A number where its formula is asked.
    ValueForFormula,
    /// Another unit than the question fixes; that one.
    UnitNotAsked(String),
    /// Rounded too early.
    RoundingSlip,
    /// Some of several values are right, not all, or there are too many.
    SomeValues,
    /// A slip with an angle, a vector or an interval, without anything to fill in.
    Slip(Verdict),
    /// The answer holds on the other side of the right boundary.
    OtherSide,
    /// Components exchanged; whether they are normal and tangential ones.
    ComponentsExchanged {
        /// Whether the axes are those of a contact.
        of_contact: bool,
    },
    /// The value of another body's quantity.
    BodiesSwapped,
    /// A formula that measures something else.
    FormulaDimension {
        /// The measure of the answer, with its article.
        given: String,
        /// The measure that is asked, with its article.
        asked: String,
    },
    /// A formula whose parts cannot stand together; the sentence that says which.
    FormulaClash(String),
    /// Earlier attempts or hints have cost this per cent of the points.
    Reduced(u32),
    /// Being late has cost this per cent of the points.
    Late(u32),
    /// No attempt was left.
    NoAttemptLeft,
    /// A text that cannot be read leaves an earlier answer in its place.
    EarlierStands,
    /// An answer was right before, and stays so.
    RightBefore,
    /// No direction; the words for it.
    Sense(Option<[String; 2]>),
    /// The opposite direction.
    SenseReversed,
    /// The opposite sign of what has no direction.
    SignReversed,
    /// The number is right, unlike what stands beside it.
    NumberRight,
    /// No unit.
    UnitMissing,
    /// Another unit of the same dimension: the one that was written.
    UnitWrong(String),
    /// A unit of something else.
    UnitWrongDimension {
        /// The measure of the written unit, with its article.
        given: String,
        /// The measure that is asked, with its article.
        asked: String,
    },
    /// A unit where a multiple of a quantity is asked.
    NoMultiple {
        /// The quantity.
        of: String,
        /// The unit of the number times the quantity, where there is one.
        unit: Option<String>,
    },
    /// Right as what multiplies this quantity, in terms of which a formula is asked.
    BareMultiple(String),
    /// Off by the factor of a prefix.
    UnitPrefix,
    /// Off by a power of ten.
    OrderOfMagnitude,
    /// A whole number is asked.
    NotWhole,
    /// Wrong, and nothing more is known.
    Wrong,
    /// Another option.
    ChoiceWrong,
    /// No answer.
    Unanswered,
    /// A sheet that the student was not given.
    NotIssued,
    /// An answer that cannot be read.
    Unreadable(Unreadable),
}

impl Message {
    /// The right magnitude with the other sign: the words for its directions, where it has any.
    #[must_use]
    pub fn reversed(senses: Option<&[String; 2]>) -> Self {
        if senses.is_some() { Self::SenseReversed } else { Self::SignReversed }
    }

    /// Whether it says no more than that the value is right.
    pub(super) fn is_verdict(&self) -> bool {
        matches!(self, Self::Right | Self::RightRounded)
    }
}
