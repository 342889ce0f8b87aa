//! Promises of `momentous check` about a form before a student sees it.

use serde::Serialize;
use serde::Serializer;
use serde::ser::SerializeMap;

use momentous_fault::Path;

/// One promise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Promise {
    /// Names, dimensions and ranges are right, and what is asked follows from the givens.
    Compiles,
    /// Texts, hints, solution and key can be written in every format.
    Prints,
    /// The sheet tells every value that the answers need.
    Told,
    /// Every seed draws within a bounded number of tries.
    Draws,
    /// The quantity asked has exactly one solution that nothing forbids.
    Determined,
    /// Each answer's error is bounded, and the bound is small.
    Certified,
    /// No answer is the same for every seed.
    Varies,
    /// Seeds give different sheets, with different answers.
    Variety,
    /// The influences that short contacts leave out are small beside theirs.
    Neglected,
    /// Answers are not zero by accident.
    NotZero,
    /// Answers are not among the givens.
    NotGiven,
    /// The numbers on the sheet lead to the answers of the key.
    FromTheSheet,
    /// The lines of a worked solution can be computed again.
    Reproduces,
    /// No condition is there for nothing.
    Requires,
    /// The answers that the key prints reach full marks.
    KeyMarks,
    /// Honest rounding moves no answer so far that right and wrong look alike.
    Sharp,
    /// A simulation that shares no code with the laws agrees.
    Simulation,
    /// The common mistakes can be distinguished from the right answer.
    WrongForms,
    /// Honest rounding reaches full marks.
    Rounding,
    /// Marking says of the author's own answers what their author expects.
    Expected,
}

/// Each promise with its stable name and what it says, in the order of reports.
const SAID: &[(Promise, &str, &str)] = &[
    (
        Promise::Compiles,
        "compiles",
        "names, dimensions, ranges and texts are right, and what is asked follows from the givens",
    ),
    (Promise::Prints, "prints", "texts, hints, solution and key can be written in every format"),
    (Promise::Told, "told", "the sheet prints every value that the answers need"),
    (Promise::Draws, "draws", "every seed gives a variant within a bounded number of attempts"),
    (
        Promise::Determined,
        "determined",
        "what is asked has exactly one solution, whichever way the scene goes, no drawn values contradict each other, and nothing in it is unphysical",
    ),
    (Promise::Certified, "certified", "the error of every answer is bounded, and small"),
    (Promise::Varies, "varies", "each answer differs from seed to seed"),
    (Promise::Variety, "variety", "seeds give different sheets, and different answers"),
    (
        Promise::Neglected,
        "neglected",
        "the impulses neglected in short contacts are small compared with those of the contacts",
    ),
    (Promise::NotZero, "not-zero", "answers are not zero by accident"),
    (Promise::NotGiven, "not-given", "answers do not equal a given in most draws"),
    (
        Promise::FromTheSheet,
        "from-the-sheet",
        "the problem solved with only its printed numbers gives every printed answer",
    ),
    (
        Promise::Reproduces,
        "reproduces",
        "each line of the worked solution can be computed again from the numbers printed on it",
    ),
    (Promise::Requires, "requires", "every `require` rejects some draws"),
    (Promise::KeyMarks, "key-marks", "the answers of the key get full marks"),
    (
        Promise::Sharp,
        "sharp",
        "rounding intermediate results shifts no answer by more than three tolerances: drawn numbers with which it does are drawn again",
    ),
    (Promise::Simulation, "simulation", "an independent simulation agrees"),
    (Promise::WrongForms, "wrong-forms", "the common mistakes can be distinguished from the right answer"),
    (Promise::Rounding, "rounding", "parts rounded as a student rounds get full marks"),
    (Promise::Expected, "expected", "the author's own answers get the verdicts that the file expects"),
];

impl Promise {
    /// Every promise, in the order of reports.
    pub fn all() -> impl Iterator<Item = Self> {
        SAID.iter().map(|(promise, ..)| *promise)
    }

    /// Its stable name, for tools.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.said().0
    }

    /// The sentence of the promise.
    #[must_use]
    pub fn sentence(self) -> &'static str {
        self.said().1
    }

    fn said(self) -> (&'static str, &'static str) {
        let said = SAID.iter().find(|(promise, ..)| *promise == self);
        said.map_or(("", ""), |(_, name, sentence)| (*name, *sentence))
    }
}

/// The finding of an audit on a promise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It holds.
    Kept,
    /// It holds, and the author should know something.
    Noted(String),
    /// It holds, and what the author should know stands in the file, with the reason why it may stay.
    Acknowledged {
        /// The remark.
        remark: String,
        /// Why it may stay.
        reason: String,
    },
    /// It does not hold.
    Broken(String),
    /// Nothing was looked at, and why.
    NotChecked(&'static str),
}

impl Outcome {
    /// The same, where the author acknowledges what is noted of a promise.
    pub(super) fn acknowledged(self, promise: Promise, reasons: &[(Path, String, String)]) -> Self {
        match (self, reasons.iter().find(|(_, name, _)| name == promise.name())) {
            (Self::Noted(remark), Some((.., reason))) => Self::Acknowledged { remark, reason: reason.clone() },
            (outcome, _) => outcome,
        }
    }

    /// Its stable name, for tools.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Kept => "kept",
            Self::Noted(_) => "noted",
            Self::Acknowledged { .. } => "acknowledged",
            Self::Broken(_) => "broken",
            Self::NotChecked(_) => "not checked",
        }
    }

    /// The sentence beyond the name.
    #[must_use]
    pub fn remark(&self) -> Option<&str> {
        match self {
            Self::Kept => None,
            Self::Noted(remark) | Self::Broken(remark) | Self::Acknowledged { remark, .. } => Some(remark),
            Self::NotChecked(remark) => Some(remark),
        }
    }
}

/// A promise with what was found of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The promise.
    pub promise: Promise,
    /// The outcome.
    pub outcome: Outcome,
}

impl Serialize for Finding {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("promise", self.promise.name())?;
        map.serialize_entry("outcome", self.outcome.name())?;
        map.serialize_entry("remark", &self.outcome.remark())?;
        if let Outcome::Acknowledged { reason, .. } = &self.outcome {
            map.serialize_entry("reason", reason)?;
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_promise_has_a_name_of_its_own_and_says_something() {
        let names: std::collections::BTreeSet<&str> = Promise::all().map(Promise::name).collect();
        assert_eq!((names.len(), names.contains("")), (SAID.len(), false));
        assert!(Promise::Expected as usize == SAID.len() - 1 && Promise::all().is_sorted());
        assert!(Promise::all().all(|promise| !promise.sentence().is_empty()));
        assert!(momentous_problem::NOTED.iter().all(|name| names.contains(name)));
    }
}
