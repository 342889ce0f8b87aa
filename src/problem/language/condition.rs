//! Conditions as authors write them: two terms of one dimension, and how they compare.

use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::Reason;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;
use momentous_quantity::dimension_name;
use momentous_solve::Condition;
use momentous_solve::Relation;

use super::comparison::split_relation;

/// Reads `v_A1 > v_B1`; a fault is noted where it cannot be read.
pub(crate) fn condition(builder: &mut Builder<'_>, text: &str, reason: Reason, path: &Path) -> Option<Condition> {
    let is_asked = matches!(reason, Reason::Asked);
    let (left, relation, right) = match split_relation(text) {
        Some(sides) if is_asked || sides.1 != Relation::Equals => sides,
        written => {
            let fault = Fault::new(Code::Syntax, format!("`{text}` is not a condition"));
            let help = match written {
                Some((left, _, right)) => {
                    format!("compare with `<`, `>`, `<=` or `>=`; that two terms are equal is given: `{left}: {right}`")
                }
                None => "compare two terms: `v_A1 > v_B1`".to_owned(),
            };
            builder.fault(fault.help(help).at_path(path.clone()));
            return None;
        }
    };
    let [left, right] = [left, right].map(|side| builder.term(side, path));
    let comparable = are_comparable(builder, text, [&left, &right], path);
    comparable.then(|| builder.compare(left, relation, right, reason))
}

/// Whether two terms can be compared: each has a dimension, and both the same one; a fault is noted where they cannot.
pub(crate) fn are_comparable(builder: &mut Builder<'_>, text: &str, sides: [&Expr; 2], path: &Path) -> bool {
    let symbols = builder.symbols();
    let [left, right] = sides.map(|side| side.dimension(symbols));
    let message = match (left, right) {
        (Err(clash), _) | (_, Err(clash)) => {
            let unit = |dimension| coherent_unit(dimension, UnitSystem::Si).to_string();
            format!("`{text}` cannot be evaluated: {}", clash.sentence(symbols, &unit))
        }
        (Ok(one), Ok(other)) => {
            if one == other || sides.iter().any(|side| side.is_zero()) {
                return true;
            }
            format!("`{text}` compares {} with {}", dimension_name(one), dimension_name(other))
        }
    };
    builder.fault(Fault::new(Code::Dimension, message).help("check the units on both sides").at_path(path.clone()));
    false
}
