//! Angles that have no unit: a plain number would be one of radians, which hardly anybody means.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_solve::Statement;

use super::Builder;
use super::Model;

/// The fault of an angle that is a plain number, with the way out.
#[must_use]
pub fn angle_without_unit(help: impl Into<String>) -> Fault {
    Fault::new(Code::Dimension, "an angle needs its unit").help(help)
}

impl Builder<'_> {
    /// Notes a fault where an angle is a plain number other than zero.
    pub fn needs_unit(&mut self, angle: &Expr, path: &Path) {
        if angle.as_number().is_some_and(|number| !number.is_zero()) {
            let number = angle.text(&self.symbols);
            let help = format!("write `{number} deg`, or `{number} rad` if radians are meant");
            self.faults.push(angle_without_unit(help).at_path(path.clone()));
        }
    }

    /// The same for every sine, cosine and tangent in a term.
    pub(super) fn need_units(&mut self, term: &Expr, path: &Path) {
        if let Some(angle) = argument(term) {
            self.needs_unit(angle, path);
        }
        for part in term.children() {
            self.need_units(part, path);
        }
    }
}

impl Model {
    /// The quantities that some equation takes as angles: they are added up under a sine, a cosine or a tangent.
    #[must_use]
    pub fn angles(&self) -> BTreeSet<Symbol> {
        let mut angles = BTreeSet::new();
        for equation in &self.system.equations {
            let (Statement::Equal { left, right } | Statement::FirstInteger { left, right, .. }) = &equation.statement;
            add_angles(left, &mut angles);
            add_angles(right, &mut angles);
        }
        angles
    }
}

fn add_angles(term: &Expr, angles: &mut BTreeSet<Symbol>) {
    if let Some(angle) = argument(term) {
        let is_added = |symbol: &Symbol| angle.differentiate(*symbol).as_number().is_some();
        angles.extend(angle.symbols().into_iter().filter(is_added));
    }
    for part in term.children() {
        add_angles(part, angles);
    }
}

/// The angle of a sine, a cosine or a tangent.
fn argument(term: &Expr) -> Option<&Expr> {
    match term {
        Expr::Apply(Function::Sin | Function::Cos | Function::Tan, arguments) => arguments.first(),
        _ => None,
    }
}
