//! The fault of a name that a scene does not have.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::did_you_mean;

/// There is no body, surface or point of that name.
pub(super) fn unknown(kind: &str, name: &str, known: &[&str]) -> Fault {
    let fault = Fault::new(Code::UnknownName, format!("there is no {kind} `{name}` at this point of the scene"));
    match did_you_mean(name, known.iter().copied()) {
        Some(near) => fault.help(format!("did you mean `{near}`?")),
        None if known.is_empty() => fault.help(format!("declare it under the scene's {kind}s")),
        None => fault.help(format!("the scene has: {}", known.join(", "))),
    }
}
