//! How a scene ends: solved and witnessed, refused, or at fault.

use std::panic::{AssertUnwindSafe, catch_unwind};

use momentous::bank::{Outcome, Promise, Seeds, audit};
use momentous::fault::{Code, Fault, Source};
use momentous::problem::{compile, load};
use momentous::render::Renderer;

use super::draw::{NUMBERS, draw_again};
use super::lack::{Lack, lack};
use super::table::Table;

/// How a scene ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// Every answer is solved, and a simulation agrees.
    Witnessed,
    /// Solved, but no simulation says anything of an answer: why.
    Unwitnessed(String),
    /// Refused, with the reason.
    Refused(Refusal, String),
    /// A promise is broken, which no scene may do: which, and how.
    Fault(String),
}

/// Why a scene is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Refusal {
    /// Its numbers contradict each other or a condition of the motion.
    Contradiction,
    /// What is asked does not follow from what is given.
    Lack,
    /// What happens in it is refused by name.
    Named,
    /// What is asked is not known in the scene, or given already.
    NotKnown,
    /// It follows, and no method finds it.
    NoMethod,
    /// It is not well formed.
    Malformed,
}

impl Refusal {
    /// All, in the order of the table of counts.
    pub const ALL: [Self; 6] =
        [Self::Contradiction, Self::Lack, Self::Named, Self::NotKnown, Self::NoMethod, Self::Malformed];

    /// The refusal in a word or two.
    pub fn name(self) -> &'static str {
        match self {
            Self::Contradiction => "contradiction",
            Self::Lack => "lack",
            Self::Named => "named",
            Self::NotKnown => "not-known",
            Self::NoMethod => "no-method",
            Self::Malformed => "malformed",
        }
    }

    fn of(fault: &Fault) -> Self {
        match fault.code {
            Code::OverDetermined | Code::Unphysical | Code::Ambiguous | Code::Range => Self::Contradiction,
            Code::UnderDetermined => Self::Lack,
            Code::Stuck => Self::NoMethod,
            Code::UnknownName if fault.message.contains("is not known in this scene") => Self::NotKnown,
            Code::Duplicate if fault.message.contains("is given already") => Self::NotKnown,
            Code::Value | Code::MissingKey | Code::UnknownName | Code::Dimension => Self::Named,
            _ => Self::Malformed,
        }
    }
}

impl End {
    /// The end in a word.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Witnessed => "witnessed",
            Self::Unwitnessed(_) => "unwitnessed",
            Self::Refused(refusal, _) => refusal.name(),
            Self::Fault(_) => "fault",
        }
    }

    /// Why it is so; empty where all is well.
    pub fn reason(&self) -> &str {
        match self {
            Self::Witnessed => "",
            Self::Unwitnessed(why) | Self::Refused(_, why) | Self::Fault(why) => why,
        }
    }
}

/// Promises that ask the author for other numbers, and say so: no fault of the program.
const OF_THE_NUMBERS: &[Promise] = &[Promise::Reproduces, Promise::Sharp];

/// A scene with its end, and the refusals on the way there.
pub struct Ended {
    /// The file that was looked at last.
    pub file: String,
    /// How it ends.
    pub end: End,
    /// How it was refused with other numbers or questions, each with its file.
    pub on_the_way: Vec<(Refusal, String, String)>,
    /// How many lacks of data two worlds showed, that agree on what is given and differ in the answer.
    pub shown: usize,
}

/// Scene number `seed` of a kind. The next question is asked where one is not known or does not follow, and other numbers are drawn
/// where they contradict each other.
pub fn ended(table: &Table, kind: &str, seed: u64, renderer: &Renderer) -> Ended {
    let mut ended =
        Ended { file: String::new(), end: End::Fault("nothing is asked".to_owned()), on_the_way: Vec::new(), shown: 0 };
    let mut question = 0;
    let mut numbers = 0;
    loop {
        let scene = draw_again(table, kind, seed, numbers);
        ended.file = scene.file(question);
        ended.end = end(&ended.file, renderer);
        let End::Refused(refusal, why) = &ended.end else { break };
        let refusal = *refusal;
        if refusal == Refusal::Lack {
            match lack(table, &scene, question, why) {
                Lack::Shown => ended.shown += 1,
                Lack::Open => {}
                Lack::Nothing(why) => {
                    ended.end = End::Fault(why);
                    break;
                }
            }
        }
        let (next, others) = match refusal {
            Refusal::NotKnown | Refusal::Lack | Refusal::NoMethod => (question + 1, numbers),
            Refusal::Contradiction => (question, numbers + 1),
            Refusal::Named | Refusal::Malformed => break,
        };
        if next == scene.questions.len() || others == NUMBERS {
            break;
        }
        ended.on_the_way.push((refusal, why.clone(), ended.file.clone()));
        (question, numbers) = (next, others);
    }
    ended
}

/// Looks at a scene as `momentous check` does. A panic is a fault of the scene that caused it, and ends no other.
pub fn end(file: &str, renderer: &Renderer) -> End {
    let looked = catch_unwind(AssertUnwindSafe(|| looked_at(file, renderer)));
    looked.unwrap_or_else(|_| End::Fault("a panic".to_owned()))
}

fn looked_at(file: &str, renderer: &Renderer) -> End {
    let source = Source::new("scene.yaml", file);
    if let Err(faults) = load(source.clone()).and_then(|loaded| compile(loaded, None)) {
        // What else is wrong may follow from the gravest of them.
        let gravest = faults.list.iter().map(Refusal::of).max();
        return End::Refused(gravest.unwrap_or(Refusal::Malformed), faults.to_string());
    }
    let audit = audit(&source, Seeds { drawn: 1, simulated: 1 }, renderer);
    if let Some(faults) = audit.faults {
        return End::Refused(Refusal::Named, faults);
    }
    let Some(form) = audit.forms.first() else { return End::Fault("no form".to_owned()) };
    if let Some(Outcome::Broken(reason)) = form.outcome(Promise::Draws) {
        return End::Refused(Refusal::Contradiction, reason.clone());
    }
    let broken = form.promises.iter().filter(|finding| matches!(finding.outcome, Outcome::Broken(_)));
    let (numbers, broken): (Vec<_>, Vec<_>) = broken.partition(|finding| OF_THE_NUMBERS.contains(&finding.promise));
    if let ([first, ..], []) = (&numbers[..], &broken[..]) {
        return End::Refused(Refusal::Contradiction, first.outcome.remark().unwrap_or_default().to_owned());
    }
    let broken: Vec<String> = broken
        .iter()
        .map(|finding| format!("{}: {}", finding.promise.name(), finding.outcome.remark().unwrap_or_default()))
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
