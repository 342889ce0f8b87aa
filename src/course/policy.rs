//! When and how an assignment is worked on and marked.

use serde::{Deserialize, Serialize};

use momentous_grade::Attempts;
use momentous_grade::FeedbackTime;
use momentous_grade::Keep;

use super::moment::Moment;
use super::share::Share;

/// When and how an assignment is worked on and marked. It takes the place of what the problems' own rubrics say of attempts and hints.
/// Its instants are in order: opens, due, late until, closes.
#[derive(Clone, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub struct Policy {
    /// How many attempts at a part count; any number where none is named.
    pub attempts: Option<u32>,
    /// The share of the points that each attempt before costs.
    pub attempt_penalty: Share,
    /// The share that each of the author's hints costs.
    pub hint_penalty: Share,
    /// The share that each hint on a wrong answer costs.
    pub further_penalty: Share,
    /// When students see it.
    pub opens: Moment,
    /// When answers are due.
    pub due: Moment,
    /// Until when they are taken late, where they are.
    pub late_until: Option<Moment>,
    /// The share that each started day after `due` costs.
    pub late_penalty: Share,
    /// When nothing more is taken.
    pub closes: Moment,
    /// When students see what was right.
    pub verdicts: Release,
    /// When students see the worked solutions.
    pub solutions: SolutionRelease,
    /// The treatment of answers that were saved and not handed in.
    #[serde(default)]
    pub unsubmitted: Unsubmitted,
    /// Whether the site solves problems of these kinds for others than those who teach, while it is open.
    #[serde(default)]
    pub solvers: Solvers,
}

/// When verdicts are shown.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Release {
    /// Shown as soon as answers are marked.
    #[default]
    AtOnce,
    /// When the assignment has closed for the student.
    AtClose,
}

impl Release {
    /// Every time of release, the usual one first.
    pub const ALL: [Self; 2] = [Self::AtOnce, Self::AtClose];
    /// Their names in forms.
    pub(super) const NAMES: [&str; 2] = ["at_once", "at_close"];

    /// The name in forms.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }
}

/// When worked solutions are shown.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SolutionRelease {
    /// When the assignment has closed for the student.
    #[default]
    AtClose,
    /// Never.
    Never,
}

impl SolutionRelease {
    /// Every time of release, the usual one first.
    pub const ALL: [Self; 2] = [Self::AtClose, Self::Never];
    /// Their names in forms.
    pub(super) const NAMES: [&str; 2] = ["at_close", "never"];

    /// The name in forms.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }
}

/// The treatment of answers that were saved and not handed in, when no more are taken.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Unsubmitted {
    /// They do not count.
    #[default]
    Leave,
    /// They are handed in, as they were saved last.
    HandIn,
}

impl Unsubmitted {
    /// Both, the usual one first.
    pub const ALL: [Self; 2] = [Self::Leave, Self::HandIn];
    /// Their names in forms.
    pub(super) const NAMES: [&str; 2] = ["leave", "hand_in"];

    /// The name in forms.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }
}

/// Whether simulators and pages of own numbers solve problems of the kinds of an assignment while it is open.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Solvers {
    /// They do.
    #[default]
    Shown,
    /// They do for those who teach. It is a hurdle and no wall: whoever has the program can solve what is printed.
    Hidden,
}

impl Solvers {
    /// Both, the usual one first.
    pub const ALL: [Self; 2] = [Self::Shown, Self::Hidden];
    /// Their names in forms.
    pub(super) const NAMES: [&str; 2] = ["shown", "hidden"];

    /// The name in forms.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }
}

impl Policy {
    /// The cost of attempts and hints, in the terms of marking. The best sheet counts.
    #[must_use]
    pub fn rules(&self) -> Attempts {
        Attempts {
            most: self.attempts,
            penalty: self.attempt_penalty.fraction().clone(),
            hint: self.hint_penalty.fraction().clone(),
            further_hint: self.further_penalty.fraction().clone(),
            keep: Keep::Best,
            told: match self.verdicts {
                Release::AtOnce => FeedbackTime::AtOnce,
                Release::AtClose => FeedbackTime::Later,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_stored_policies() {
        let stored = |value: serde_json::Value| value.as_str().unwrap().to_owned();
        for release in Release::ALL {
            assert_eq!(stored(serde_json::to_value(release).unwrap()), release.name());
        }
        for release in SolutionRelease::ALL {
            assert_eq!(stored(serde_json::to_value(release).unwrap()), release.name());
        }
        for unsubmitted in Unsubmitted::ALL {
            assert_eq!(stored(serde_json::to_value(unsubmitted).unwrap()), unsubmitted.name());
        }
        for solvers in Solvers::ALL {
            assert_eq!(stored(serde_json::to_value(solvers).unwrap()), solvers.name());
        }
    }
}
