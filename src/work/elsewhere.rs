//! The same line of another instant or another body.

use momentous_expr::Symbol;
use momentous_model::Name;
use momentous_problem::Worked;

use super::ground::Place;
use super::holds::{At, Holds};
use super::meaning::Meanings;
use super::written::{Statement, Written};

/// The place in which a line would be true.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Elsewhere {
    /// At another instant.
    Instant,
    /// For another body.
    Body,
}

/// Whether a line that does not hold becomes true where one quantity is taken at another instant, or of another body.
pub(crate) fn elsewhere(
    worked: Worked<'_>,
    place: Place<'_>,
    (line, meanings): (&Written, &[Meanings]),
    at: &At<'_>,
) -> Option<(Elsewhere, Symbol)> {
    let model = worked.problem.model();
    let mentioned = line.quantities();
    for symbol in &mentioned {
        let other_name = model.name(*symbol);
        for (other, _) in model.symbols.iter().filter(|(other, _)| other != symbol && !mentioned.contains(other)) {
            let name = model.name(other);
            let at_once = |name: &Name| Name { instant: None, ..name.clone() };
            let of_anybody = |name: &Name| Name { subject: String::new(), ..name.clone() };
            let moved = if at_once(other_name) == at_once(name) {
                Elsewhere::Instant
            } else if of_anybody(other_name) == of_anybody(name) {
                Elsewhere::Body
            } else {
                continue;
            };
            if place.value(other).is_none()
                || place.value(other).map(|number| number.value) == place.value(*symbol).map(|number| number.value)
            {
                continue;
            }
            let exchanged = exchanged(line, *symbol, other);
            if meanings.iter().any(|set| at.line(&exchanged, set) == Holds::Yes) {
                return Some((moved, other));
            }
        }
    }
    None
}

fn exchanged(line: &Written, symbol: Symbol, other: Symbol) -> Written {
    let put = |side: &momentous_expr::Expr| side.substitute(&|replaced| (replaced == symbol).then(|| other.into()));
    let statement = |statement: &Statement| Statement {
        left: put(&statement.left),
        right: put(&statement.right),
        compared: statement.compared,
    };
    let stated = line
        .stated
        .iter()
        .map(|ways| ways.iter().map(|chain| chain.iter().map(statement).collect()).collect())
        .collect();
    Written { stated, ..line.clone() }
}
