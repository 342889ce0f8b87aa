//! Why an answer cannot be read.

use momentous_quantity::UnitFault;

/// An answer that cannot be read: what is wrong, and at which character. It is never marked, and costs no attempt.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The character of the answer, counted from 0.
    pub at: usize,
    /// The fault there.
    pub kind: UnreadableKind,
}

/// The faults of an answer's text.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum UnreadableKind {
    /// More characters than are read; how many are.
    TooLong(usize),
    /// No number where one must stand.
    NotANumber,
    /// An equation whose left side is no name.
    NameBefore,
    /// An underscore between digits.
    Underscore,
    /// Points or commas that no number has: `3..2`, `12,34,5`.
    Marks,
    /// A decimal comma where a point is the decimal mark, or the other way round; the mark that is to be used.
    OtherMark(char),
    /// A comma or point that may group thousands or begin the decimals; the two ways to write it without doubt.
    AmbiguousMark([String; 2]),
    /// A second number behind the first.
    SecondNumber,
    /// `2 100/200`: a mixed number or a grouped one.
    MixedOrGrouped,
    /// `1.2 x 10-3`: a lost exponent or a difference.
    LostExponent,
    /// `1190-1210`: a range or a difference.
    RangeOrDifference,
    /// A text that can be read in two ways; each as it is written without doubt.
    Ambiguous([String; 2]),
    /// A sign that does not belong behind a number, or is missing there.
    Behind(String),
    /// `1/2 sqrt(3)`: a product after a fraction bar, without a sign.
    ProductAfterBar,
    /// Two signs, one behind the other.
    TwoSigns,
    /// A bracket that is not closed.
    OpenBracket,
    /// Brackets or powers nested too deeply.
    TooDeep,
    /// A number, written or computed, too large or too small or with too many digits.
    TooLarge,
    /// A division by zero, the root of a negative number and the like.
    Undefined,
    /// The angle of a sine, cosine or tangent without its unit.
    AngleUnit,
    /// `±`, `<` and the like: not one value.
    NotOneValue,
    /// `9.81 +/- 0.01`: a value with its uncertainty, as it is usually written.
    Uncertainty(String),
    /// Something else than a number times the quantity of which a multiple is asked.
    Multiple(String),
    /// A unit that cannot be read.
    Unit(UnitFault),
    /// A unit that may also be the abbreviation of a direction: `5 N N`.
    UnitOrDirection(String),
    /// A direction word where the quantity has no direction.
    NoDirection(String),
    /// A direction word that is none of the two of the question.
    OtherDirection {
        /// The word.
        word: String,
        /// The two words of the question.
        senses: [String; 2],
    },
    /// A sign together with a direction word.
    SignAndDirection,
    /// A direction in the plane that cannot be understood.
    Direction,
    /// A vector with another number of components than this one.
    Components(usize),
    /// A vector whose components have different units, or a unit twice.
    MixedUnits,
    /// A component along an axis that the question does not have, or two along one.
    Axis,
    /// Neither an interval nor a condition.
    NotAnInterval,
    /// A condition on another quantity; the one of the question.
    OtherName(String),
    /// An interval whose lower end is above its upper end.
    EmptyInterval,
    /// A name that the sheet does not give; the nearest that it does.
    UnknownName {
        /// The name.
        name: String,
        /// The nearest given one.
        near: Option<String>,
    },
    /// Letters that can be read as different names or products of names.
    AmbiguousName {
        /// The typed name.
        name: String,
        /// The readings that it can have, with every sign of multiplication.
        readings: Vec<String>,
    },
    /// A formula that can be read in two ways; both, with every bracket.
    TwoReadings([String; 2]),
    /// The power -1 of a function that has no inverse of that name: `ln^-1 x`.
    InverseOrReciprocal,
    /// `log`, which has two meanings.
    Logarithm,
    /// A function without an argument.
    NoArgument,
    /// A number right behind a factor: `x 2`.
    NumberBehind,
    /// The quantity that is asked, in its own formula.
    AskedName(String),
    /// `e` alone where the sheet gives no coefficient of restitution.
    NotEuler,
    /// A formula with more parts than are read.
    TooManyParts,
    /// A text that does not belong into a formula.
    NotAFormula,
    /// No number, name or bracket where one must stand.
    NoTerm,
    /// No option has this name or number; the number of options.
    NoOption(usize),
    /// More than one of the options.
    SeveralOptions,
}

/// The reading of a text, or its fault and at which byte.
pub(super) type At<T> = Result<T, (usize, UnreadableKind)>;

impl UnreadableKind {
    /// Whether the text has more than one reading, so that no other way to read it may be tried.
    pub(super) fn is_doubt(&self) -> bool {
        matches!(
            self,
            Self::AmbiguousMark(_)
                | Self::MixedOrGrouped
                | Self::LostExponent
                | Self::RangeOrDifference
                | Self::Ambiguous(_)
                | Self::ProductAfterBar
                | Self::NotOneValue
                | Self::Uncertainty(_)
                | Self::Multiple(_)
                | Self::UnitOrDirection(_)
                | Self::SignAndDirection
                | Self::OtherDirection { .. }
        )
    }

    /// Its stable code, for tools.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::TooLong(_) => "too_long",
            Self::NotANumber => "not_a_number",
            Self::NameBefore => "name_before",
            Self::Underscore => "underscore",
            Self::Marks => "marks",
            Self::OtherMark(_) => "other_mark",
            Self::AmbiguousMark(_) => "ambiguous_mark",
            Self::SecondNumber => "second_number",
            Self::MixedOrGrouped => "mixed_or_grouped",
            Self::LostExponent => "lost_exponent",
            Self::RangeOrDifference => "range_or_difference",
            Self::Ambiguous(_) => "ambiguous",
            Self::Behind(_) => "behind",
            Self::ProductAfterBar => "product_after_bar",
            Self::TwoSigns => "two_signs",
            Self::OpenBracket => "open_bracket",
            Self::TooDeep => "too_deep",
            Self::TooLarge => "too_large",
            Self::Undefined => "undefined",
            Self::AngleUnit => "angle_unit",
            Self::NotOneValue => "not_one_value",
            Self::Uncertainty(_) => "uncertainty",
            Self::Multiple(_) => "multiple",
            Self::Unit(_) => "unit",
            Self::UnitOrDirection(_) => "unit_or_direction",
            Self::NoDirection(_) => "no_direction",
            Self::OtherDirection { .. } => "other_direction",
            Self::SignAndDirection => "sign_and_direction",
            Self::Direction => "direction",
            Self::Components(_) => "components",
            Self::MixedUnits => "mixed_units",
            Self::Axis => "axis",
            Self::NotAnInterval => "not_an_interval",
            Self::OtherName(_) => "other_name",
            Self::EmptyInterval => "empty_interval",
            Self::UnknownName { .. } => "unknown_name",
            Self::AmbiguousName { .. } => "ambiguous_name",
            Self::TwoReadings(_) => "two_readings",
            Self::InverseOrReciprocal => "inverse_or_reciprocal",
            Self::Logarithm => "logarithm",
            Self::NoArgument => "no_argument",
            Self::NumberBehind => "number_behind",
            Self::AskedName(_) => "asked_name",
            Self::NotEuler => "not_euler",
            Self::TooManyParts => "too_many_parts",
            Self::NotAFormula => "not_a_formula",
            Self::NoTerm => "no_term",
            Self::NoOption(_) => "no_option",
            Self::SeveralOptions => "several_options",
        }
    }
}

impl std::error::Error for Unreadable {}
