//! A part of a stage that was simulated, and what is said of it.

use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_simulate::Record;
use momentous_simulate::least::Choice;
use momentous_simulate::least::time;
use momentous_simulate::scene::Component;

/// The ending of a run that nothing cut short.
pub const AT_ITS_TIME: &str = "at its time";

/// The most digits that a double has.
const MOST_DIGITS: f64 = 15.0;

/// The names of the kinds of stages whose key in a file says too little.
const KINDS: &[(&str, &str)] = &[
    ("taut", "cord comes taut"),
    ("connected", "on one string"),
    ("rotate", "rotation"),
    ("moment", "turning moment"),
    ("conical", "on a cone"),
    ("bowl", "in a bowl"),
    ("interact", "mutual push"),
    ("central", "central force"),
    ("slide_off", "slide down"),
    ("separate", "parting"),
];

/// A part of a stage, simulated.
#[derive(Clone, Debug)]
pub struct Film {
    /// The stage, counted from 1.
    pub stage: usize,
    /// The names of the components.
    pub axes: Vec<Component>,
    /// The method that ran it, and why.
    pub choice: Choice,
    /// Its error, relative to the greatest size of what is off; none of a run that was given up before its time.
    pub error: Option<f64>,
    /// The cost of the run by the table of costs, in s; `None` where that has no row for it.
    pub seconds: Option<f64>,
    /// Its ending, in words.
    pub ending: String,
    /// The record of the run.
    pub record: Record,
    /// The notes that a reader of the motion needs.
    pub notes: Vec<&'static str>,
    /// The bodies whose mass is not known; it counts as 1 kg, and no velocity depends on it.
    pub unweighed: Vec<String>,
}

impl Film {
    /// The kind of its stage, in a word or two.
    #[must_use]
    pub fn kind(&self, scene: &Scene) -> &'static str {
        let stage = self.stage.checked_sub(1).and_then(|place| scene.stages.get(place));
        let key = stage.map_or("motion", Stage::key);
        KINDS.iter().find(|(known, _)| *known == key).map_or(key, |(_, words)| *words)
    }

    /// The digits that can be trusted; none of a run that was given up before its time.
    #[must_use]
    pub fn trusted_digits(&self) -> Option<u32> {
        let error = self.error?;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 15")]
        Some(libm::floor(-libm::log10(error)).clamp(0.0, MOST_DIGITS) as u32)
    }

    /// Which method ran it, why, how far it is right and what that costs, in a sentence.
    #[must_use]
    pub fn why(&self) -> String {
        let error = self.error.zip(self.trusted_digits()).map(|(error, digits)| {
            let trusted = match digits {
                0 => "no digit can be trusted".to_owned(),
                1 => "1 digit can be trusted".to_owned(),
                _ => format!("{digits} digits can be trusted"),
            };
            format!("error about {error:.0e} here: {trusted}")
        });
        let seconds = self.seconds.map(|seconds| format!("{} by the table of costs", time(seconds)));
        let both: Vec<String> = error.into_iter().chain(seconds).collect();
        if both.is_empty() { self.choice.to_string() } else { format!("{} ({})", self.choice, both.join("; ")) }
    }

    /// The notes that a reader needs: of the motion, and of momenta and energies.
    #[must_use]
    pub fn cautions(&self) -> Vec<String> {
        let bodies = self.unweighed.join(" and ");
        let unweighed = format!("The mass of {bodies} is not given: impulses and energies are for 1 kg.");
        let notes = self.notes.iter().map(|note| (*note).to_owned());
        notes.chain((!bodies.is_empty()).then_some(unweighed)).collect()
    }
}

/// Why a scene is not simulated as is asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}\nhelp: {help}")]
pub struct NotFilmed {
    /// The obstacle.
    pub what: String,
    /// The way out.
    pub help: &'static str,
}

/// Nothing in the table of costs serves.
pub(super) fn out_of_reach(stage: usize, error: &dyn std::fmt::Display) -> NotFilmed {
    refused(stage, &error.to_string(), "ask for less accuracy, allow more time, or omit --method")
}

pub(super) fn refused(stage: usize, what: &str, help: &'static str) -> NotFilmed {
    NotFilmed { what: format!("stage {stage}: {what}"), help }
}
