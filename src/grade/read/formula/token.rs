//! What the text of a formula consists of.

use momentous_expr::Symbol;
use momentous_quantity::Rational;

use super::named::Named;

/// How deeply brackets, functions and powers may be nested.
pub(super) const MAX_DEPTH: usize = 24;

/// A token with its place.
#[derive(Clone, Debug)]
pub(super) struct Lexeme {
    pub(super) token: Token,
    /// The character of the answer at which it begins.
    pub(super) at: usize,
    /// Whether a space stands before it.
    pub(super) gap: bool,
}

/// A sign, a number, a name.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    /// A number; half a unit of its last place, where it is a decimal of three figures or more and may so be rounded.
    Number {
        value: Rational,
        half: Option<Rational>,
    },
    /// A number for which a symbol stands: its place among them, and whether it has a unit.
    Written {
        place: usize,
        measured: bool,
    },
    /// Letters side by side, in which names and functions are still to be found.
    Word(Vec<Letter>),
    /// A quantity that the sheet gives.
    Name(Symbol),
    /// The ratio of a circle's circumference to its diameter.
    Pi,
    /// The base of natural logarithms, below a power.
    Euler,
    /// A function, whose argument follows.
    Function(Named),
    /// A root of that degree, whose radicand follows.
    Root(u32),
    /// `\sqrt[3]{x}`: a root whose degree follows in brackets, and then its radicand.
    IndexedRoot,
    /// `\frac`: two groups follow.
    Fraction,
    Plus,
    Minus,
    /// `±`, and `+-`.
    PlusMinus,
    Times,
    Over,
    /// `\over`: a bar through the whole group in which it stands.
    WholeOver,
    Power,
    /// An opening bracket; what closes it.
    Open(char),
    Close(char),
    Bar,
    Comma,
    Equals,
    Degree,
    Radian,
}

/// A letter or digit of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Letter {
    pub(super) sign: char,
    pub(super) place: Place,
    /// The character of the answer.
    pub(super) at: usize,
}

/// How a letter is joined to the one before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// It stands beside it.
    Beside,
    /// It is its index: `_A`, `₁`.
    Below,
    /// A point stands between: a component, or a product.
    Point,
}

impl Token {
    /// Whether the argument of a function may begin with it.
    pub(super) fn begins_argument(&self) -> bool {
        self.begins_factor() || matches!(self, Self::Number { .. } | Self::Written { .. } | Self::Bar)
    }

    /// Whether it is a number that can be neither an index nor meant for a power: behind a name it is a factor, `m u 1.26`.
    pub(super) fn is_decimal(&self) -> bool {
        matches!(self, Self::Number { value, .. } if !value.is_int())
    }

    /// Whether it continues a product without a sign; a whole number never does, and a bar may close what it opened.
    pub(super) fn begins_factor(&self) -> bool {
        matches!(
            self,
            Self::Word(_)
                | Self::Name(_)
                | Self::Pi
                | Self::Euler
                | Self::Function(_)
                | Self::Root(_)
                | Self::IndexedRoot
                | Self::Fraction
                | Self::Open(_)
        )
    }
}
