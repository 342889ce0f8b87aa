//! A law as it is used in one scene.

use std::collections::BTreeSet;
use std::fmt;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::Law;

/// One use of a law: which, in which stage, and why it may be used there.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The law.
    pub law: &'static Law,
    /// Why it applies here.
    pub because: Because,
    /// The stage in which it is used, counted from 0; none for a relation at one instant.
    pub stage: Option<usize>,
    /// The integral that the equation's right side is the value of, where the law defines one.
    pub integral: Option<Integral>,
    /// The line from which its equation follows, to be shown with it.
    pub shown: Option<Shown>,
    /// The uses of laws, as positions in [`Model::instances`](super::Model::instances), that name what stands in the value of the integral
    /// for the ends of the range.
    pub ends: Vec<usize>,
}

/// Why an equation may be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Because {
    /// By the definition of a quantity, or because the author says so without a reason.
    Definition,
    /// A clause from which the law follows.
    Fact(String),
    /// A clause, and what follows from it for the equation.
    Conclusion(String, String),
}

impl Because {
    /// A reason of the author's own, who may have drawn a conclusion.
    pub(super) fn written(text: &str) -> Self {
        match text.split_once(", so ") {
            _ if text.is_empty() => Self::Definition,
            Some((fact, follows)) => Self::Conclusion(fact.to_owned(), follows.to_owned()),
            None => Self::Fact(text.to_owned()),
        }
    }
}

impl From<&str> for Because {
    fn from(fact: &str) -> Self {
        Self::Fact(fact.to_owned())
    }
}

impl From<String> for Because {
    fn from(fact: String) -> Self {
        Self::Fact(fact)
    }
}

/// Written as a clause.
impl fmt::Display for Because {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Definition => f.write_str("by definition"),
            Self::Fact(fact) => f.write_str(fact),
            Self::Conclusion(fact, follows) => write!(f, "{fact}, so {follows}"),
        }
    }
}

/// The step from which the equation of a law follows.
#[derive(Clone, Debug)]
pub enum Shown {
    /// Something equals an integral.
    Integral {
        /// The quantity that equals it.
        of: Expr,
        /// The integral.
        integral: Integral,
    },
    /// The right side is the sum of a series.
    Series(Series),
    /// The right side is the area of these shapes together.
    Areas(Vec<Expr>),
    /// A balance, from which the left side follows.
    Balance([Expr; 2]),
}

/// A factor times a sum whose terms go on in the same way.
#[derive(Clone, Debug)]
pub struct Series {
    /// The common factor of all terms.
    pub factor: Expr,
    /// The first terms.
    pub terms: Vec<Expr>,
    /// The last term; none where they go on for ever.
    pub last: Option<Expr>,
}

/// A definite integral, to be shown before its value.
#[derive(Clone, Debug)]
pub struct Integral {
    /// The integrand.
    pub integrand: Expr,
    /// Over what.
    pub variable: Symbol,
    /// From where.
    pub low: Expr,
    /// To where.
    pub high: Expr,
}

/// In which sense something is left out of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Omitted {
    /// It is small, or idealised away: air resistance, the mass of a string.
    Neglected,
    /// It acts, but across the motion, within the system or on the support: its equation is not needed.
    NotNeeded,
}

/// Something that is left out of the model on purpose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// Whether it is neglected, or has no part in what is asked.
    pub kind: Omitted,
    /// The omitted quantity: `weight`.
    pub what: String,
    /// Why that is right: `it is not impulsive: during the short contact its impulse is negligible`.
    pub why: String,
    /// The stages in which it is left out, counted from 0.
    pub stages: BTreeSet<usize>,
}

/// An impulse in a stage, for diagrams and for questions about which momentum is conserved.
#[derive(Clone, Debug)]
pub struct Impulse {
    /// The stage, counted from 0.
    pub stage: usize,
    /// The short name of the body on which it acts.
    pub on: String,
    /// The giver of the impulse.
    pub by: Agent,
    /// Its name: `the contact with cart B`, `the thrust`, `weight`.
    pub called: String,
    /// Its components along the scene's axes, in their order; none where it is only one magnitude along `line`.
    pub components: Vec<Expr>,
    /// Whether it belongs to a short impact, in which ordinary forces have no time to act.
    pub impulsive: bool,
}

/// The giver of an impulse.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Agent {
    /// Another body of the scene.
    Body(String),
    /// A surface of the scene.
    Surface(String),
    /// The guide of a body, at right angles to the way in which it lets it move.
    Guide,
    /// Something outside the scene: a hand, an engine, the earth.
    Outside,
}
