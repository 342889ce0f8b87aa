//! How a scene ends: solved and witnessed, refused, or at fault.

use std::panic::{AssertUnwindSafe, catch_unwind};

use momentous::bank::{Outcome, Promise, Seeds, audit};
use momentous::fault::Source;
use momentous::render::Renderer;

use super::draw::Drawn;

/// How a scene ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// Every answer is solved, and a simulation agrees.
    Witnessed,
    /// Solved, but no simulation says anything of an answer: why.
    Unwitnessed(String),
    /// Refused, with the reason.
    Refused(String),
    /// A promise is broken, which no scene may do: which, and how.
    Fault(String),
}

impl End {
    /// The end in a word.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Witnessed => "witnessed",
            Self::Unwitnessed(_) => "unwitnessed",
            Self::Refused(_) => "refused",
            Self::Fault(_) => "fault",
        }
    }

    /// Why it is so; empty where all is well.
    pub fn reason(&self) -> &str {
        match self {
            Self::Witnessed => "",
            Self::Unwitnessed(why) | Self::Refused(why) | Self::Fault(why) => why,
        }
    }
}

/// Promises that ask the author for other numbers, and say so: no fault of the program.
const OF_THE_NUMBERS: &[Promise] = &[Promise::Reproduces, Promise::Sharp];

/// Asks of a scene the first question that it knows: the file, and how it ends.
pub fn asked(drawn: &Drawn, renderer: &Renderer) -> (String, End) {
    let mut last = (drawn.file(0), End::Refused("nothing is asked".to_owned()));
    for question in 0..drawn.questions.len() {
        let file = drawn.file(question);
        let end = end(&file, renderer);
        let is_unknown = matches!(&end, End::Refused(why) if why.contains("is not known in this scene"));
        last = (file, end);
        if !is_unknown {
            break;
        }
    }
    last
}

/// Looks at a scene as `momentous check` does. A panic is a fault of the scene that caused it, and ends no other.
pub fn end(file: &str, renderer: &Renderer) -> End {
    let looked = catch_unwind(AssertUnwindSafe(|| looked_at(file, renderer)));
    looked.unwrap_or_else(|_| End::Fault("a panic".to_owned()))
}

fn looked_at(file: &str, renderer: &Renderer) -> End {
    let audit = audit(&Source::new("scene.yaml", file), Seeds { drawn: 1, simulated: 1 }, renderer);
    if let Some(faults) = audit.faults {
        return End::Refused(faults);
    }
    let Some(form) = audit.forms.first() else { return End::Fault("no form".to_owned()) };
    if let Some(Outcome::Broken(reason)) = form.outcome(Promise::Draws) {
        return End::Refused(reason.clone());
    }
    let broken = form.promises.iter().filter(|own| matches!(own.outcome, Outcome::Broken(_)));
    let (numbers, broken): (Vec<_>, Vec<_>) = broken.partition(|own| OF_THE_NUMBERS.contains(&own.promise));
    if let ([first, ..], []) = (&numbers[..], &broken[..]) {
        return End::Refused(first.outcome.remark().unwrap_or_default().to_owned());
    }
    let broken: Vec<String> = broken
        .iter()
        .map(|own| format!("{}: {}", own.promise.name(), own.outcome.remark().unwrap_or_default()))
        .collect();
    if !broken.is_empty() {
        return End::Fault(broken.join("; "));
    }
    if form.simulation.is_whole() {
        return End::Witnessed;
    }
    let nothing = form.simulation.nothing.map_or_else(|| format!("{:?}", form.simulation.unseen), str::to_owned);
    End::Unwitnessed(nothing)
}
