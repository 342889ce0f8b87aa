//! The verdicts on a line, and what is said of each.

use serde::Serialize;

/// Verdicts on a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// It follows from the scene, by some laws.
    Follows,
    /// It gives an answer.
    Answer,
    /// It is true as far as the figures of its numbers show.
    AsFigures,
    /// It says what a quantity is.
    Definition,
    /// It says what a letter of the student's own stands for.
    OwnLetter,
    /// It says again what is given.
    Restates,
    /// It is true of any values.
    Identity,
    /// It is true of the numbers of this sheet by chance.
    Coincidence,
    /// It says which direction counts as positive.
    Convention,
    /// It is no equation.
    Remark,
    /// It follows from a usual mistake.
    Mistake,
    /// It would be true of another instant.
    OtherInstant,
    /// It would be true of another body.
    OtherBody,
    /// Its sides measure different things.
    Dimensions,
    /// It does not follow from the scene.
    DoesNotFollow,
    /// It cannot be read.
    Unreadable,
    /// It cannot be decided.
    Undecided,
}

impl Verdict {
    /// Its stable name for tools.
    #[must_use]
    pub fn code(self) -> &'static str {
        match self {
            Self::Follows => "follows",
            Self::Answer => "answer",
            Self::AsFigures => "as-figures",
            Self::Definition => "definition",
            Self::OwnLetter => "own-letter",
            Self::Restates => "restates",
            Self::Identity => "identity",
            Self::Coincidence => "coincidence",
            Self::Convention => "convention",
            Self::Remark => "remark",
            Self::Mistake => "mistake",
            Self::OtherInstant => "other-instant",
            Self::OtherBody => "other-body",
            Self::Dimensions => "dimensions",
            Self::DoesNotFollow => "does-not-follow",
            Self::Unreadable => "unreadable",
            Self::Undecided => "undecided",
        }
    }

    /// Whether it is true and may establish laws.
    #[must_use]
    pub fn is_true(self) -> bool {
        matches!(
            self,
            Self::Follows
                | Self::Answer
                | Self::AsFigures
                | Self::Definition
                | Self::OwnLetter
                | Self::Restates
                | Self::Identity
        )
    }

    /// Whether it is wrong for certain.
    #[must_use]
    pub fn is_wrong(self) -> bool {
        matches!(self, Self::Mistake | Self::OtherInstant | Self::OtherBody | Self::Dimensions | Self::DoesNotFollow)
    }
}

/// The words for a list: `a, b and c`.
pub(crate) fn list(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
