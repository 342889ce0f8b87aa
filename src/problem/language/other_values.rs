//! Other values that a form has for what its file gives: "now it is held tightly".

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::Builder;
use momentous_quantity::dimension_name;

use super::super::reading::load::Loaded;
use super::super::reading::turning;
use super::super::reading::unsound;
use super::form::Question;
use super::given::Fraction;
use super::given::Given;
use super::known::Known;
use super::known::Origin;

/// The values known in a form, in the order of the file; faults are noted in the builder.
pub(crate) fn known_in(loaded: &Loaded, question: &Question, known: &[Known], builder: &mut Builder<'_>) -> Vec<Known> {
    let mut written = known.to_vec();
    for (name, given) in question.given.iter() {
        let fault = match (written.iter_mut().find(|known| known.name == name), value(given)) {
            (Some(known), Some((origin, unit))) if loaded.given.get(name).and_then(value).is_some() => {
                let fault = unlike(known, unit.dimension());
                let kind = &builder.name(known.symbol).kind;
                let fault = fault.or_else(|| turning::unclear(kind, name, &origin, &unit));
                let fault = fault.or_else(|| unsound::value(builder, name, known.symbol, &origin));
                (known.origin, known.unit) = (origin, unit);
                fault
            }
            _ => {
                let (message, help) = if loaded.given.get(name).is_none() {
                    let message = format!("a form cannot give `{name}`, which the file's `given` does not give");
                    (message, "give it in the file's `given`, or have it solved first and then told: `reveal: [...]`")
                } else {
                    let message = format!("a form cannot give `{name}` another value like this");
                    (message, "a form may change what the file's `given` gives by a value, a range or a choice")
                };
                Some(Fault::new(Code::Value, message).help(help))
            }
        };
        if let Some(fault) = fault {
            builder.fault(fault.at_path(question.path.key("given").name(name)));
        }
    }
    written
}

/// A value, or those from which one is drawn; none where it is given in another way.
fn value(given: &Given) -> Option<(Origin, momentous_quantity::Unit)> {
    match given {
        Given::Drawn { domain, unit } => Some((Origin::Drawn(domain.clone()), unit.clone())),
        Given::Literal(literal) => match &literal.components[..] {
            [only] => Some((Origin::Fixed(only.clone()), literal.unit.clone())),
            _ => None,
        },
        Given::Expression(text) => {
            let fraction = Fraction::read_any(text.trim())?;
            Some((Origin::Fixed(fraction.decimal()?), fraction.unit))
        }
        Given::Any(_) => None,
    }
}

/// Whether no form gives a quantity a value that is zero or negative.
pub(crate) fn is_positive_in_every_form(loaded: &Loaded, name: &str) -> bool {
    let mut question = loaded.questions.iter().filter_map(|question| value(question.given.get(name)?));
    question.all(|(origin, _)| origin.is_positive())
}

/// The fault of a value that is of another kind than the file's own.
fn unlike(Known { name, unit, .. }: &Known, dimension: momentous_quantity::Dimension) -> Option<Fault> {
    let [expected, found] = [unit.dimension(), dimension].map(dimension_name);
    let message = format!("`{name}` is {expected}, but its unit here is one of {found}");
    (dimension != unit.dimension()).then(|| Fault::new(Code::Dimension, message).help("change the unit"))
}
