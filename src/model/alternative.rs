//! Ways in which a stage can go, and the systems that they make.

use crate::solve::Condition;
use crate::solve::Equation;
use crate::solve::System;

use super::Builder;
use super::Model;

/// One of several ways in which a stage can go, with what holds only there.
#[derive(Clone, Debug, Default)]
pub struct Alternative {
    /// What happens, as a clause: `the crate stays at rest`.
    pub what: String,
    /// Equations that hold only there.
    pub equations: Vec<Equation>,
    /// When it is the way that is taken.
    pub conditions: Vec<Condition>,
    /// The stage, counted from 0, all through which a body stands still, and the short name of the body.
    pub still: Option<(usize, String)>,
}

impl Model {
    /// The system of every combination of ways in which the stages can go, with what happens in each.
    #[must_use]
    pub fn systems(&self) -> Vec<(Vec<String>, System)> {
        let mut all = vec![(Vec::new(), self.system.clone())];
        for ways in &self.choices {
            let extend = |(words, system): &(Vec<String>, System)| {
                let one = |way: &Alternative| {
                    let mut system = system.clone();
                    system.equations.extend(way.equations.iter().cloned());
                    system.conditions.extend(way.conditions.iter().cloned());
                    (words.iter().cloned().chain([way.what.clone()]).collect(), system)
                };
                ways.iter().map(one).collect::<Vec<_>>()
            };
            all = all.iter().flat_map(extend).collect();
        }
        all
    }
}

impl Builder<'_> {
    /// The way in which a body stands still all through a stage: its choice, counted from 0, and what happens there.
    #[must_use]
    pub fn stands_still(&self, body: &str, stage: usize) -> Option<(usize, &str)> {
        let is_meant = |way: &&Alternative| way.still.as_ref().is_some_and(|own| own.0 == stage && own.1 == body);
        self.choices
            .iter()
            .enumerate()
            .find_map(|(choice, ways)| Some((choice, ways.iter().find(is_meant)?.what.as_str())))
    }
}
