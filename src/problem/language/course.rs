//! The symbols that a course prefers: `symbols: { momentum: L, impulse: I }`.

use schemars::JsonSchema;
use serde::Deserialize;
use serde::Serialize;

use momentous_expr::Notation;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;

use super::text::is_name;

/// The letters that a course uses. Names in the file keep the usual ones.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Eq, Hash, JsonSchema, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CourseSymbols {
    /// For momentum. Default: `p`.
    #[serde(default)]
    pub momentum: Option<String>,
    /// For an impulse. Default: `J`.
    #[serde(default)]
    pub impulse: Option<String>,
    /// For angular momentum. Default: `H`.
    #[serde(default)]
    pub angular_momentum: Option<String>,
    /// For kinetic energy. Default: `T`.
    #[serde(default)]
    pub kinetic_energy: Option<String>,
}

/// Letters that stand for other quantities.
const TAKEN: [&str; 10] = ["v", "m", "r", "F", "N", "W", "R", "a", "t", "speed"];

impl CourseSymbols {
    /// The key of each quantity, its usual letter, and the one that the course writes.
    fn rows(&self) -> [(&'static str, &'static str, Option<&str>); 4] {
        [
            ("momentum", "p", self.momentum.as_deref()),
            ("impulse", "J", self.impulse.as_deref()),
            ("angular_momentum", "H", self.angular_momentum.as_deref()),
            ("kinetic_energy", "T", self.kinetic_energy.as_deref()),
        ]
    }

    /// These letters, and those of `other` for the rest.
    #[must_use]
    pub(crate) fn or(&self, other: &Self) -> Self {
        let either = |first: &Option<String>, other: &Option<String>| first.as_ref().or(other.as_ref()).cloned();
        Self {
            momentum: either(&self.momentum, &other.momentum),
            impulse: either(&self.impulse, &other.impulse),
            angular_momentum: either(&self.angular_momentum, &other.angular_momentum),
            kinetic_energy: either(&self.kinetic_energy, &other.kinetic_energy),
        }
    }

    /// The notation.
    ///
    /// # Errors
    /// A letter that is none, or that stands for something else.
    pub(crate) fn notation(&self) -> Result<Notation, Vec<Fault>> {
        let mut faults = Vec::new();
        for (key, usual, chosen_letter) in self.rows() {
            let Some(chosen_letter) = chosen_letter else { continue };
            let other = |(name, letter, chosen): &(&str, &str, Option<&str>)| {
                *name != key && chosen.unwrap_or(letter) == chosen_letter
            };
            let fault = if !is_name(chosen_letter) || chosen_letter.contains(['_', '.', '@', '[', '(']) {
                Fault::new(Code::Value, format!("`{chosen_letter}` is not a letter"))
                    .help(format!("write one, as `{key}: {usual}`"))
            } else if TAKEN.contains(&chosen_letter) || self.rows().iter().any(other) {
                Fault::new(Code::Duplicate, format!("`{chosen_letter}` stands for another quantity"))
                    .help("choose another letter")
            } else {
                continue;
            };
            faults.push(fault.at_path(Path::root().key("symbols").key(key)));
        }
        let letters = self.rows();
        let letters = letters
            .iter()
            .filter_map(|(_, usual, letter)| letter.filter(|letter| letter != usual).map(|letter| (*usual, letter)));
        if faults.is_empty() { Ok(Notation::new(letters)) } else { Err(faults) }
    }
}
