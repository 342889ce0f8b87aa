//! Strings that go taut.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::Term;

/// A slack, light, inextensible string between two bodies goes taut with a jerk, or several strings at once.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Taut {
    /// A name for the stage, used in brackets: `J_A[jerk]`.
    #[serde(default)]
    pub name: Option<String>,
    /// The two bodies, the second ahead of the first along the string.
    #[serde(default)]
    pub between: Option<[String; 2]>,
    /// The smooth, light pulley over which the string runs, as it is called in a sentence. Velocities of both bodies are then
    /// counted along the string, from the first body to the second.
    #[serde(default)]
    pub over: Option<String>,
    /// In two dimensions, the direction of the string, from the first body to the second: `30 deg above +x`.
    #[serde(default)]
    pub along: Option<Term>,
    /// Several strings that are jerked at the same time, in place of `between` and `along`: those that go taut, and those that are
    /// taut already and pass the jerk on.
    #[serde(default)]
    pub strings: Vec<JerkedString>,
    /// How long the jerk lasts, if the average tension is wanted.
    #[serde(default)]
    pub duration: Option<Term>,
}

/// One of several strings that are jerked at the same time.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JerkedString {
    /// The two bodies, the second ahead of the first along the string.
    pub between: [String; 2],
    /// In two dimensions, the direction of the string, from the first body to the second: `30 deg above +x`.
    #[serde(default)]
    pub along: Option<Term>,
}

impl JerkedString {
    /// The two bodies at its ends, the second ahead of the first.
    #[must_use]
    pub fn ends(&self) -> [&str; 2] {
        self.between.each_ref().map(String::as_str)
    }
}

impl Taut {
    /// The bodies at the ends of each of its strings, the second ahead of the first.
    #[must_use]
    pub fn ends(&self) -> Vec<[&str; 2]> {
        self.pulls().into_iter().map(|(ends, _)| ends).collect()
    }

    /// The same, with the direction of each string from the first to the second, where it is told.
    #[must_use]
    pub fn pulls(&self) -> Vec<([&str; 2], Option<&Term>)> {
        let single = self.between.iter().map(|both| (both.each_ref().map(String::as_str), self.along.as_ref()));
        single.chain(self.strings.iter().map(|string| (string.ends(), string.along.as_ref()))).collect()
    }

    /// The bodies that are jerked, each once.
    #[must_use]
    pub fn jerked(&self) -> Vec<&str> {
        let mut bodies: Vec<&str> = Vec::new();
        for body in self.ends().into_iter().flatten() {
            if !bodies.contains(&body) {
                bodies.push(body);
            }
        }
        bodies
    }
}
