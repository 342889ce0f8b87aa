//! A system of equations with the conditions under which it holds.

use std::collections::{BTreeMap, BTreeSet};

use momentous_expr::{Expr, Operator, Symbol};

/// Equations and conditions over one problem's symbols. What is known and what is wanted is said when it is planned.
#[derive(Clone, Debug, Default)]
pub struct System {
    /// An independent set, and combinations derived from it that a plan may prefer.
    pub equations: Vec<Equation>,
    /// The conditions that every true solution satisfies; a root that breaks one is not a solution.
    pub conditions: Vec<Condition>,
    /// Symbols whose value is positive in every admissible solution: masses, speeds, durations, distances.
    pub positive: BTreeSet<Symbol>,
    /// Symbols that stand for one pure number in every problem with these equations, such as a right angle in degrees.
    pub fixed: BTreeMap<Symbol, Expr>,
    /// Values known beforehand of known symbols: a plan holds for these values alone, and divides by nothing that is
    /// zero there.
    pub values: BTreeMap<Symbol, Expr>,
}

impl System {
    /// Other equations under the same conditions.
    #[must_use]
    pub fn with(&self, equations: Vec<Equation>) -> Self {
        Self { equations, ..Self { equations: Vec::new(), ..self.clone() } }
    }
}

/// One equation, as it is taught.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Its statement.
    pub statement: Statement,
    /// The caller's own number for it: which instance of which law.
    pub tag: usize,
    /// The cost of using it in a plan; 1 as a rule, more for what is taught only when nothing else serves.
    pub cost: u32,
}

/// The statement of an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Statement {
    /// Two sides are equal.
    Equal {
        /// The left side.
        left: Expr,
        /// The right side.
        right: Expr,
    },
    /// `unknown` is the first integer, from `from` upwards, for which `left relation right` holds.
    FirstInteger {
        /// The integer.
        unknown: Symbol,
        /// The number with which counting starts.
        from: i64,
        /// The left side; it contains `unknown`.
        left: Expr,
        /// How the sides compare.
        relation: Relation,
        /// The right side.
        right: Expr,
    },
}

/// How two sides compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Strictly less.
    Less,
    /// Less or equal.
    AtMost,
    /// Strictly greater.
    Greater,
    /// Greater or equal.
    AtLeast,
    /// Different.
    Differs,
    /// Equal; asked of values that are known, and required of no solution.
    Equals,
}

impl Relation {
    /// The opposite: the relation that holds where this one does not.
    #[must_use]
    pub fn opposite(self) -> Self {
        match self {
            Self::Less => Self::AtLeast,
            Self::AtMost => Self::Greater,
            Self::Greater => Self::AtMost,
            Self::AtLeast => Self::Less,
            Self::Differs => Self::Equals,
            Self::Equals => Self::Differs,
        }
    }

    /// Its sign in print.
    #[must_use]
    pub fn operator(self) -> Operator {
        match self {
            Self::Less => Operator::Less,
            Self::AtMost => Operator::AtMost,
            Self::Greater => Operator::Greater,
            Self::AtLeast => Operator::AtLeast,
            Self::Differs => Operator::Differs,
            Self::Equals => Operator::Equals,
        }
    }
}

/// An inequality that holds in every true solution.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The left side.
    pub left: Expr,
    /// How the sides compare.
    pub relation: Relation,
    /// The right side.
    pub right: Expr,
    /// The caller's own number for it: which reason to give where it is broken.
    pub tag: usize,
}
