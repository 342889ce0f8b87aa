//! Typeset mathematics: one layout tree, printed as plain text, LaTeX, Typst or `MathML` by the writers beside it.

use std::sync::Arc;

/// A piece of typeset mathematics. What it is made of may be shared: the name of a quantity stands in many places.
///
/// Terms ([`super::super::Expr`]) are laid out as this; so are quantities with their units, and the few marks that explanations need.
#[derive(Clone, Debug)]
pub enum Math {
    /// Parts side by side.
    Row(Vec<Math>),
    /// A number, as it is to be printed, with an ASCII hyphen for its sign: `-2.30`.
    Number(String),
    /// A variable, set in italics: `v`, `m`, `\u{3b8}`.
    Identifier(String),
    /// Words or a unit, set upright: `m/s`, `before`.
    Text(String),
    /// An operator or relation between its neighbours.
    Operator(Operator),
    /// A fraction.
    Fraction(Arc<Math>, Arc<Math>),
    /// A base with a subscript: `v_{A1}`.
    Sub(Arc<Math>, Arc<Math>),
    /// A base with a superscript: `v^2`.
    Sup(Arc<Math>, Arc<Math>),
    /// A base with a subscript and a superscript.
    SubSup(Arc<Math>, Arc<Math>, Arc<Math>),
    /// A square root.
    Root(Arc<Math>),
    /// Its content in round brackets.
    Bracketed(Arc<Math>),
    /// Its content in square brackets: `m_A [v_2 - v_1]`.
    Squared(Arc<Math>),
    /// Its content between bars: an absolute value.
    Bars(Arc<Math>),
    /// A function's name, upright: `sin`, `arctan`.
    Function(String),
    /// Rows of (condition text, value) behind a brace.
    Cases(Vec<(Math, Math)>),
    /// A definite integral: lower, upper, integrand, variable.
    Integral(Arc<Math>, Arc<Math>, Arc<Math>, Arc<Math>),
    /// A vector's name, set bold.
    Vector(String),
}

/// The operators and relations of the subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operator {
    /// `+`
    Plus,
    /// A true minus sign.
    Minus,
    /// A multiplication that must be seen: `3 \u{d7} 10^4`.
    Times,
    /// A multiplication that is only a thin space: `m v`.
    Juxtapose,
    /// `=`
    Equals,
    /// Approximately equal.
    Approximately,
    /// `<`
    Less,
    /// Less than or equal.
    AtMost,
    /// `>`
    Greater,
    /// Greater than or equal.
    AtLeast,
    /// Not equal.
    Differs,
    /// `,`
    Comma,
    /// An implication, `=>`.
    Implies,
    /// Plus or minus.
    PlusMinus,
}

impl Math {
    /// An identifier with an upright or italic subscript as the subject writes it: `v` and `A1`.
    #[must_use]
    pub fn subscripted(base: &str, subscript: &str) -> Self {
        if subscript.is_empty() {
            return Self::Identifier(base.to_owned());
        }
        Self::Sub(Arc::new(Self::Identifier(base.to_owned())), Arc::new(Self::Text(subscript.to_owned())))
    }

    /// The name of a vector: its letter set bold.
    #[must_use]
    pub fn bold(self) -> Self {
        match self {
            Self::Identifier(letter) => Self::Vector(letter),
            Self::Sub(base, below) => Self::Sub(Arc::new((*base).clone().bold()), below),
            other => other,
        }
    }

    /// `left relation right`.
    #[must_use]
    pub fn relation(left: Self, relation: Operator, right: Self) -> Self {
        Self::Row(vec![left, Self::Operator(relation), right])
    }

    /// `a < b < c`.
    #[must_use]
    pub fn chain(parts: impl IntoIterator<Item = Self>, relation: Operator) -> Self {
        let mut row = Vec::new();
        for part in parts {
            row.extend((!row.is_empty()).then_some(Self::Operator(relation)));
            row.push(part);
        }
        Self::Row(row)
    }
}

/// Shared parts are equal by their address, before their contents are compared.
impl PartialEq for Math {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (one, other) if std::ptr::eq(one, other) => true,
            (Self::Row(one), Self::Row(other)) => one == other,
            (Self::Number(one), Self::Number(other))
            | (Self::Identifier(one), Self::Identifier(other))
            | (Self::Text(one), Self::Text(other))
            | (Self::Function(one), Self::Function(other))
            | (Self::Vector(one), Self::Vector(other)) => one == other,
            (Self::Operator(one), Self::Operator(other)) => one == other,
            (Self::Fraction(a, b), Self::Fraction(c, d))
            | (Self::Sub(a, b), Self::Sub(c, d))
            | (Self::Sup(a, b), Self::Sup(c, d)) => (a, b) == (c, d),
            (Self::SubSup(a, b, c), Self::SubSup(d, e, f)) => (a, b, c) == (d, e, f),
            (Self::Root(one), Self::Root(other))
            | (Self::Bracketed(one), Self::Bracketed(other))
            | (Self::Squared(one), Self::Squared(other))
            | (Self::Bars(one), Self::Bars(other)) => one == other,
            (Self::Cases(one), Self::Cases(other)) => one == other,
            (Self::Integral(a, b, c, d), Self::Integral(e, f, g, h)) => (a, b, c, d) == (e, f, g, h),
            _ => false,
        }
    }
}

impl Eq for Math {}

impl Default for Math {
    fn default() -> Self {
        Self::Row(Vec::new())
    }
}

impl Math {
    /// Whether an operator is a sign in front, since nothing that it could join stands before it.
    #[must_use]
    pub fn is_prefix(before: Option<&Self>) -> bool {
        matches!(before, None | Some(Self::Operator(_)))
    }

    /// Whether a space belongs between neighbours: a number and its unit, a word and what follows.
    pub fn needs_space(before: Option<&Self>, after: &Self) -> bool {
        let Some(before) = before else { return false };
        let joins = |part: &Self| matches!(part, Self::Operator(_));
        match (before, after) {
            (before, _) if joins(before) => false,
            (_, Self::Text(text)) => text.starts_with(char::is_alphanumeric),
            (Self::Text(text), after) => !joins(after) && !text.ends_with(char::is_whitespace),
            _ => false,
        }
    }
}

/// A subscript as runs of letters, of digits, and of everything else.
pub fn subscript_parts(text: &str) -> impl Iterator<Item = &str> {
    let kind = |letter: char| (letter.is_alphabetic(), letter.is_numeric());
    let mut rest = text;
    std::iter::from_fn(move || {
        let first = kind(rest.chars().next()?);
        let end = rest.find(|letter| kind(letter) != first).unwrap_or(rest.len());
        let (part, behind) = rest.split_at(end);
        rest = behind;
        Some(part)
    })
}
