//! A wrong form of a law: the mistake behind it, what it is made from, and what stands in place of the law.

use std::collections::BTreeSet;

use crate::Sides;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolTable;

/// A common mistake, as a row of its chapter's table.
#[derive(Debug)]
pub struct Misconception {
    /// A stable name for tools, tables and an author's `feedback`: `restitution-inverted`.
    pub id: &'static str,
    /// The mistake as it follows a subject: `divides by the coefficient of restitution`.
    pub does: &'static str,
    /// The first question to the student. It holds no value.
    pub ask: &'static str,
    /// The plainer hint that follows. It holds no value either.
    pub hint: &'static str,
}

impl PartialEq for Misconception {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for Misconception {}

/// A wrong form of a law.
#[derive(Debug)]
pub struct WrongForm {
    /// The mistake behind it.
    pub of: &'static Misconception,
    /// The wrong equations that come of it, one for each way of making the mistake; none where it cannot be made.
    pub write: fn(&Taught<'_>) -> Vec<Wrong>,
}

/// A law as it stands in one scene: what a wrong form is made from.
#[derive(Clone, Copy, Debug)]
pub struct Taught<'a> {
    /// The two sides, as they are taught.
    pub sides: &'a Sides,
    /// The integral of which the right side is the value: integrand and variable, from where and to where.
    pub integral: Option<(&'a Expr, Symbol, [&'a Expr; 2])>,
    /// The other laws of the same stage by their ids; those of a single instant stand beside every stage.
    pub beside: &'a [(&'static str, Sides)],
    /// The quantities.
    pub symbols: &'a SymbolTable,
    /// The symbols known before anything is solved.
    pub known: &'a BTreeSet<Symbol>,
    /// One unit of acceleration: `g` to one who takes a weight for a mass.
    pub unit_acceleration: &'a Expr,
}

/// The equations in place of a law for a student who made a mistake.
#[derive(Clone, Debug)]
pub struct Wrong {
    /// The equations in its place.
    pub equations: Vec<Sides>,
    /// Laws of the same stage that the student leaves aside, by their ids.
    pub without: &'static [&'static str],
}

impl From<Sides> for Wrong {
    fn from(sides: Sides) -> Self {
        Self { equations: vec![sides], without: &[] }
    }
}
