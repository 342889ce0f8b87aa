//! The plan: which equations, in which order, each block closed by a tactic. It is the symbolic half of the derivation.

use std::collections::BTreeSet;

use momentous_expr::{Expr, Symbol};

/// Steps in the order in which they are solved. Each step uses only what is known or was solved before it.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// The steps.
    pub steps: Vec<Step>,
}

/// One irreducible block of equations and the unknowns that it determines.
#[derive(Clone, Debug)]
pub struct Step {
    /// Positions of the equations in the system, as many as there are unknowns.
    pub equations: Vec<usize>,
    /// The unknowns, in the order in which they are found.
    pub unknowns: Vec<Symbol>,
    /// The tactic that closed the block.
    pub tactic: Tactic,
    /// How a student would do it, in order.
    pub moves: Vec<Move>,
    /// Every root that algebra allows; the conditions of the system choose among them, variant by variant.
    pub roots: Vec<Root>,
}

/// The tactics, in the order in which they are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tactic {
    /// One equation, one unknown that can be brought to one side.
    Isolate,
    /// k linear equations in k unknowns.
    Linear,
    /// k - 1 unknowns written linearly in one, substituted, the one solved.
    Tear,
    /// One equation of second degree in one unknown.
    Quadratic,
    /// a sin(theta) + b cos(theta) = 0: theta by its tangent.
    Tangent,
    /// R cos(theta) and R sin(theta) known: R and theta found.
    Polar,
    /// The first integer that satisfies a condition.
    Count,
    /// One equation with no closed form, solved between bounds.
    BracketedRoot,
}

/// The values of a step's unknowns on one branch.
#[derive(Clone, Debug)]
pub struct Root {
    /// One closed value for each unknown of the step, in the step's order. A value may use unknowns that stand before it.
    pub values: Vec<(Symbol, Closed)>,
}

/// How a value is computed.
#[derive(Clone, Debug)]
pub enum Closed {
    /// From a formula in what is known at that point.
    Formula(Expr),
    /// By counting up from the first integer until the condition holds.
    FirstInteger {
        /// The number with which counting starts.
        from: i64,
        /// The left side of the condition, in `unknown`.
        left: Expr,
        /// How the sides compare.
        relation: super::super::Relation,
        /// The right side.
        right: Expr,
    },
    /// The root of `residual`, a term in the unknown and what is known, the n-th one from zero upwards (0 the first).
    BracketedRoot {
        /// Zero at the root.
        residual: Expr,
        /// Which root, counted from zero upwards.
        index: usize,
        /// Whether it repeats after a turn, so that there are no others beyond.
        repeats: bool,
    },
}

impl Closed {
    /// Every symbol that the value is computed from.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        match self {
            Self::Formula(term) | Self::BracketedRoot { residual: term, .. } => term.symbols(),
            Self::FirstInteger { left, right, .. } => left.symbols().union(&right.symbols()).copied().collect(),
        }
    }
}

/// Both roots of `a x^2 + b x + c = 0` as they are taught, the one with plus before the square root first.
#[must_use]
pub fn quadratic_formula([a, b, c]: [&Expr; 3]) -> [Expr; 2] {
    let root = (b.clone().powi(2) - Expr::integer(4) * a.clone() * c.clone()).sqrt();
    [root.clone(), -root].map(|root| (root - b.clone()) / (Expr::integer(2) * a.clone()))
}

/// One thing that a student does on paper. Equations are named by their position in the system.
#[derive(Clone, Debug)]
pub enum Move {
    /// Solve `equation` for `unknown`: it equals `value`.
    Isolate {
        /// The equation.
        equation: usize,
        /// The unknown brought to one side.
        unknown: Symbol,
        /// Its value.
        value: Expr,
    },
    /// Multiply equation `times` by `factor` and add it to `equation`, so that `drops` falls out and `left = right` remains.
    Combine {
        /// The equation that is added to.
        equation: usize,
        /// The equation that is multiplied.
        times: usize,
        /// By what.
        factor: Expr,
        /// The unknown that falls out.
        drops: Symbol,
        /// Left side of what remains. The sides differ by exactly what the two equations differ by together: no sign changes.
        left: Expr,
        /// Right side of what remains.
        right: Expr,
    },
    /// `zero` is zero for the values given, and so is the term of `equation` that holds `drops`; `left = right` remains.
    Vanish {
        /// The equation.
        equation: usize,
        /// A term that is zero.
        zero: Expr,
        /// The unknown that falls out.
        drops: Symbol,
        /// Left side of what remains.
        left: Expr,
        /// Right side of what remains.
        right: Expr,
    },
    /// Put the value of `unknown` into `equation`; `left = right` remains.
    Substitute {
        /// The equation.
        equation: usize,
        /// The unknown that is replaced.
        unknown: Symbol,
        /// By what.
        value: Expr,
        /// Left side of what remains.
        left: Expr,
        /// Right side of what remains.
        right: Expr,
    },
    /// Square both sides of `equation`, none of which is negative; `left = right` remains.
    Square {
        /// The equation.
        equation: usize,
        /// The square of its left side.
        left: Expr,
        /// The square of its right side.
        right: Expr,
    },
    /// Divide `equation`, `a sin(theta) + b cos(theta) = 0`, by the cosine; `left = right`, the tangent and its value, remains.
    Tangent {
        /// The equation.
        equation: usize,
        /// The tangent of the angle.
        left: Expr,
        /// Its value.
        right: Expr,
    },
    /// `a x^2 + b x + c = 0`: the left side of `equation` less the right side, times `factor`.
    Quadratic {
        /// The equation.
        equation: usize,
        /// By what it was multiplied, so that nothing stands below a bar.
        factor: Expr,
        /// The unknown.
        unknown: Symbol,
        /// Coefficient of its square.
        a: Expr,
        /// Coefficient of the unknown.
        b: Expr,
        /// The rest.
        c: Expr,
    },
    /// `a x^4 + b x^2 + c = 0`, a quadratic equation in the square: the left side of `equation` less the right side, times `factor`.
    Biquadratic {
        /// The equation.
        equation: usize,
        /// By what it was multiplied, so that nothing stands below a bar.
        factor: Expr,
        /// The unknown.
        unknown: Symbol,
        /// Coefficients of the fourth power and of the square, and the rest.
        coefficients: Box<[Expr; 3]>,
    },
    /// Two equations are `R cos(theta) = x` and `R sin(theta) = y`: square and add them, divide one by the other.
    Polar {
        /// The equations of x and of y; both follow from both where each has the two components.
        equations: [usize; 2],
        /// The magnitude.
        magnitude: Symbol,
        /// The angle.
        angle: Symbol,
        /// The magnitude's cosine component.
        x: Expr,
        /// The magnitude's sine component.
        y: Expr,
    },
    /// Find `unknown` by counting.
    Count {
        /// The integer.
        unknown: Symbol,
    },
    /// Find `unknown` by calculation between bounds, since no formula gives it.
    Numeric {
        /// The unknown.
        unknown: Symbol,
    },
}
