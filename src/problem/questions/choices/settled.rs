//! The common ground of questions that the scene settles: the stage that is meant, the names of bodies, and an answer by yes or
//! no.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::wrong::Misconception;
use momentous_model::Builder;

use super::super::part::PartKind;
use super::choice::ChoicePart;
use super::decision::Decision;

/// Whether something holds, and why, as a sentence without a full stop.
pub(crate) type Verdict = (bool, String);

/// A question that the scene settles, with the mistake that leads to the other answer.
pub(crate) fn yes_or_no((holds, because): Verdict, behind: Option<&'static Misconception>) -> PartKind {
    PartKind::Choice(ChoicePart::Settled(Decision { behind, ..Decision::yes_or_no(holds, because) }))
}

pub(crate) fn join(names: &[String]) -> String {
    match names {
        [] => "the system".into(),
        [only] => only.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// The stage that a question means: the one named, or the only one.
pub(crate) fn stage(name: Option<&str>, builder: &mut Builder<'_>, path: &Path) -> Option<usize> {
    let index = match name {
        Some(name) => builder.stage_of(name),
        None => (builder.scene().stages.len() == 1).then_some(0),
    };
    if index.is_none() {
        let message = match name {
            _ if builder.scene().stages.is_empty() => "nothing happens in this scene: it has no stage".to_owned(),
            None => "the question does not name the stage".to_owned(),
            Some(name) => format!("there is no stage `{name}`"),
        };
        let help = if builder.scene().stages.is_empty() {
            "describe what happens under `stages`, such as `- impact: { between: [A, B], restitution: e }`"
        } else {
            "give the stage a `name` and write it here: `stage: hit`"
        };
        builder.fault(Fault::new(Code::UnknownName, message).help(help).at_path(path.key("stage")));
    }
    index
}
