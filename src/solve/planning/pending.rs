//! Conditions that are tested as soon as they can be.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;

use super::super::replay::tape::Register;
use super::super::replay::writer::Writer;
use super::super::structure::incidence::ascending;
use super::super::{Audit, Relation, Statement, System};

/// Which equations are tested at the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verify {
    /// Those that no step uses, and those whose solution may add a root.
    Redundant,
    /// All whose symbols are found.
    All,
}

/// The tested term: a difference of sides.
#[derive(Clone, Debug)]
pub(crate) struct Test {
    pub(crate) what: Tested,
    pub(crate) difference: Register,
}

/// The owner of a test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tested {
    /// A condition of the system, by position.
    Condition(usize, Relation),
    /// An equation of the system, by position.
    Equation(usize),
}

/// The conditions and equations that are still to be tested, each as soon as its symbols are found.
pub(crate) struct Pending<'a> {
    waiting: Vec<Waiting<'a>>,
}

/// The test, and the symbols that were not found when it was last looked at.
struct Waiting<'a> {
    what: Tested,
    left: &'a Expr,
    right: &'a Expr,
    open: Vec<Symbol>,
}

impl<'a> Pending<'a> {
    pub(crate) fn new(system: &'a System, audit: &Audit, verify: Verify) -> Self {
        let conditions = system.conditions.iter().enumerate().map(|(place, condition)| {
            (Tested::Condition(place, condition.relation), &condition.left, &condition.right)
        });
        let redundant: BTreeSet<usize> = audit.checks.iter().copied().collect();
        let doubtful = |place: &usize| {
            let mut steps = audit.plan.steps.iter().filter(|step| step.equations.contains(place));
            steps.any(|step| match &system.equations[*place].statement {
                Statement::Equal { left, right } => {
                    may_add_roots(left, &step.unknowns) || may_add_roots(right, &step.unknowns)
                }
                Statement::FirstInteger { .. } => false,
            })
        };
        let tested = |place: &usize| verify == Verify::All || redundant.contains(place) || doubtful(place);
        let equations =
            system.equations.iter().enumerate().filter(|(place, _)| tested(place)).filter_map(|(place, equation)| {
                match &equation.statement {
                    Statement::Equal { left, right } => Some((Tested::Equation(place), left, right)),
                    Statement::FirstInteger { .. } => None,
                }
            });
        let waiting = conditions.chain(equations).map(|(what, left, right)| Waiting {
            what,
            left,
            right,
            open: ascending([left, right]),
        });
        Self { waiting: waiting.collect() }
    }

    /// Writes the tests whose symbols are found.
    pub(crate) fn ready(&mut self, writer: &mut Writer) -> Vec<Test> {
        let mut tests = Vec::new();
        self.waiting.retain_mut(|Waiting { what, left, right, open }| {
            while open.pop_if(|symbol| writer.symbols.holds(*symbol)).is_some() {}
            if !open.is_empty() {
                return true;
            }
            let difference = writer.difference(left, right);
            tests.extend(difference.map(|difference| Test { what: *what, difference }));
            difference.is_none()
        });
        tests
    }

    /// The conditions that are left.
    pub(crate) fn conditions(&self) -> Vec<usize> {
        let place = |tested: &Tested| if let Tested::Condition(place, _) = tested { Some(*place) } else { None };
        self.waiting.iter().filter_map(|waiting| place(&waiting.what)).collect()
    }
}

/// Whether undoing what is done to the unknowns may give values that do not satisfy the equation: a root, an absolute
/// value or a principal angle is never of the other sign.
fn may_add_roots(expr: &Expr, unknowns: &[Symbol]) -> bool {
    let involved = unknowns.iter().any(|unknown| expr.contains(*unknown));
    let adds = match expr {
        Expr::Power(pair) => pair.1.as_number().is_none_or(|exponent| !exponent.denominator().is_one()),
        Expr::Apply(Function::Abs | Function::Asin | Function::Acos | Function::Atan2, _) | Expr::Piecewise(_) => true,
        _ => false,
    };
    involved && (adds || expr.children().any(|part| may_add_roots(part, unknowns)))
}
