//! What a form is meant to do although something speaks against it: the names under `allow`.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::did_you_mean;
use momentous_model::Builder;
use momentous_model::Warning;

use super::form::Question;

/// What `momentous check` would find in a form and its author means, by the names that authors write under `allow`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meant {
    /// An answer is among the givens.
    EqualsGiven,
    /// Every seed gives the same sheet.
    OneSheet,
    /// Every seed has the same answers, or the same answer to a part.
    OneAnswer,
}

impl Meant {
    /// Everything that can be meant, with its name.
    pub const NAMES: &[(&str, Self)] =
        &[("equals-given", Self::EqualsGiven), ("one-sheet", Self::OneSheet), ("one-answer", Self::OneAnswer)];
}

/// The promises of `momentous check` of which something may be noted that an author acknowledges.
pub const NOTED: [&str; 8] =
    ["told", "draws", "variety", "neglected", "requires", "sharp", "simulation", "wrong-forms"];

/// What an author allows a form.
#[derive(Clone, Debug, Default)]
pub(crate) struct Allowed {
    /// Of what is unphysical about solutions.
    pub warnings: Vec<Warning>,
    /// Of what `momentous check` looks for.
    pub meant: Vec<Meant>,
}

impl Allowed {
    /// What stands under `allow`; every warning where the form is meant to end in something impossible.
    pub(crate) fn read(question: &Question, builder: &mut Builder<'_>) -> Self {
        let mut allowed = Self::default();
        if question.expect.is_some() {
            allowed.warnings.extend(Warning::NAMES.iter().map(|(_, warning)| *warning));
        }
        for (path, name) in &question.allow {
            let warning = Warning::NAMES.iter().find(|(listed, _)| listed == name);
            let meant = Meant::NAMES.iter().find(|(listed, _)| listed == name);
            allowed.warnings.extend(warning.map(|(_, warning)| *warning));
            allowed.meant.extend(meant.map(|(_, meant)| *meant));
            if warning.is_none() && meant.is_none() {
                let known =
                    Warning::NAMES.iter().map(|(name, _)| *name).chain(Meant::NAMES.iter().map(|(name, _)| *name));
                let near = did_you_mean(name, known.clone()).map(|near| format!("did you mean `{near}`?"));
                let help =
                    near.unwrap_or_else(|| format!("the warnings are: {}", known.collect::<Vec<_>>().join(", ")));
                let fault = Fault::new(Code::UnknownName, format!("there is no warning `{name}`"));
                builder.fault(fault.help(help).at_path(path.clone()));
            }
        }
        for (path, name, reason) in &question.acknowledge {
            let fault = if !NOTED.contains(&name.as_str()) {
                let near = did_you_mean(name, NOTED).map(|near| format!("did you mean `{near}`?"));
                let help = near.unwrap_or_else(|| format!("notes may be acknowledged of {}", NOTED.join(", ")));
                Fault::new(Code::UnknownName, format!("nothing is noted of a promise `{name}`")).help(help)
            } else if reason.trim().is_empty() {
                let help = format!("write why it may stay: `acknowledge: {{ {name}: ... }}`");
                Fault::new(Code::Value, format!("the note on `{name}` is acknowledged without a reason")).help(help)
            } else {
                continue;
            };
            builder.fault(fault.at_path(path.clone()));
        }
        allowed
    }
}
