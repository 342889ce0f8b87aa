//! Ways in which a stage can go, and the systems that they make.

use crate::solve::Condition;
use crate::solve::Equation;
use crate::solve::System;

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
