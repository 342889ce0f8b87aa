//! Everything that marking says to a student, as data, and its wording in English: another language is another wording.
//!
//! No message holds the right value, nor anything from which it follows.

use std::fmt;

use super::read::{MAX_LENGTH, Unreadable, UnreadableKind};

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
    /// A zero without a unit.
    ZeroWithoutUnit,
    /// Fewer figures than asked; how many are.
    TooFewFigures(usize),
    /// More figures than asked; how many are.
    TooManyFigures(usize),
    /// No direction; the words for it.
    Sense(Option<[String; 2]>),
    /// The opposite direction.
    SenseReversed,
    /// The number is right, unlike what stands beside it.
    NumberRight,
    /// No unit.
    UnitMissing,
    /// Another unit of the same dimension: the one that was written.
    UnitWrong(String),
    /// A unit of something else.
    UnitWrongDimension {
        /// What the written unit measures, with its article.
        given: String,
        /// What is asked, with its article.
        asked: String,
    },
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
    /// An answer that cannot be read.
    Unreadable(Unreadable),
}

impl Message {
    /// Whether it says no more than that the value is right.
    pub(super) fn is_verdict(&self) -> bool {
        matches!(self, Self::Right | Self::RightRounded)
    }
}

/// In English, in whole sentences.
impl fmt::Display for Message {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Right => write!(out, "Right."),
            Self::RightBecause(because) => write!(out, "Right: {because}."),
            Self::RightRounded => write!(out, "Right within the rounding of intermediate values."),
            Self::NegativeMagnitude => write!(out, "This quantity is a magnitude: it is written without a minus sign."),
            Self::PoundsAsMass => {
                write!(out, "Pounds and the like are read as a mass here (`lbm`); elsewhere they are forces.")
            }
            Self::ZeroWithoutUnit => write!(out, "A zero, too, is written with its unit."),
            Self::TooFewFigures(asked) => write!(out, "Write {asked} significant figures."),
            Self::TooManyFigures(asked) => write!(out, "The data support no more than {asked} significant figures."),
            Self::Sense(Some([plus, minus])) => {
                write!(out, "The magnitude is right. Say its direction too: by a sign, or \"{plus}\" or \"{minus}\".")
            }
            Self::Sense(None) => write!(out, "The magnitude is right. What is its sign?"),
            Self::SenseReversed => write!(out, "The magnitude is right. Look at the direction again."),
            Self::NumberRight => write!(out, "The number is right."),
            Self::UnitMissing => write!(out, "The unit is missing."),
            Self::UnitWrong(unit) => write!(out, "Its unit is not {unit}."),
            Self::UnitWrongDimension { given, asked } => {
                write!(out, "Look at the unit: this is {given}, the question asks for {asked}.")
            }
            Self::UnitPrefix => write!(
                out,
                "This is off by the factor of a prefix. Look at the units again: grams or kilograms, metres or kilometres?"
            ),
            Self::OrderOfMagnitude => write!(out, "The digits are right. Look at the decimal point again."),
            Self::NotWhole => write!(out, "The answer is a whole number."),
            Self::Wrong => write!(out, "Not right."),
            Self::ChoiceWrong => write!(out, "Not this one."),
            Self::Unanswered => write!(out, "No answer."),
            Self::Unreadable(fault) => write_unreadable(fault, out),
        }
    }
}

fn write_unreadable(fault: &Unreadable, out: &mut fmt::Formatter<'_>) -> fmt::Result {
    write!(out, "Character {}: ", fault.at + 1)?;
    match &fault.kind {
        UnreadableKind::TooLong => write!(out, "an answer has at most {MAX_LENGTH} characters."),
        UnreadableKind::NotANumber => write!(out, "a number must stand here, like `3.1`, `-0.4`, `1.2e3` or `3/4`."),
        UnreadableKind::NameBefore => write!(out, "write the value alone, without a name and `=` before it."),
        UnreadableKind::Underscore => write!(out, "an underscore does not belong into a number."),
        UnreadableKind::Marks => write!(out, "these points and commas make no number."),
        UnreadableKind::OtherMark(mark) => write!(out, "decimals begin with `{mark}` here."),
        UnreadableKind::AmbiguousMark([whole, decimal]) => {
            write!(out, "this can be read in two ways: write `{whole}` or `{decimal}`.")
        }
        UnreadableKind::SecondNumber => write!(out, "a second number stands here: write one value."),
        UnreadableKind::MixedOrGrouped => write!(
            out,
            "this can be a whole number and a fraction, or one grouped number: write it without the space, or as a decimal."
        ),
        UnreadableKind::LostExponent => {
            write!(out, "this can be a power of ten or a difference: write `10^-3`, or spaces around the minus sign.")
        }
        UnreadableKind::ProductAfterBar => {
            write!(out, "this can belong above or below the fraction bar: write brackets.")
        }
        UnreadableKind::TwoSigns => write!(out, "two signs stand side by side."),
        UnreadableKind::OpenBracket => write!(out, "this bracket is not closed."),
        UnreadableKind::TooDeep => write!(out, "this is nested too deeply."),
        UnreadableKind::TooLarge => write!(out, "this number is too large, too small or too long."),
        UnreadableKind::Undefined => write!(out, "this has no value."),
        UnreadableKind::AngleUnit => write!(out, "an angle needs its unit here: `sin(30 deg)` or `sin(0.5 rad)`."),
        UnreadableKind::NotOneValue => write!(out, "write one value, not a range or a condition."),
        UnreadableKind::Unit(fault) => write!(out, "{fault}; {}.", fault.help().trim_end_matches('?')),
        UnreadableKind::UnitOrDirection(letter) => {
            write!(out, "`{letter}` can be a unit or a direction: write the direction as a word.")
        }
        UnreadableKind::NoDirection(word) => write!(out, "\"{word}\" says a direction, but this quantity has none."),
        UnreadableKind::OtherDirection { word, senses: [plus, minus] } => {
            write!(out, "\"{word}\" is none of the directions here: \"{plus}\" or \"{minus}\".")
        }
        UnreadableKind::SignAndDirection => write!(out, "write a sign or a direction, not both."),
        UnreadableKind::NoOption(count) => {
            write!(out, "choose one of the {count} options, by its letter, its number or its text.")
        }
        UnreadableKind::SeveralOptions => write!(out, "this fits more than one option: write more of its text."),
    }
}
