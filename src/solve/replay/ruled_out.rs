//! Solutions that the caller rules out for reasons of its own, which no condition of a system states.

use super::super::number::real::Real;
use super::program::Program;
use super::tape::Register;
use super::workspace::{Cause, Death, Workspace};

/// A solution: its registers, and the root of each stage on the way to it.
struct Solution<R> {
    registers: Vec<R>,
    path: Vec<usize>,
}

impl<R: Real> Workspace<R> {
    /// Counts those solutions for which there is a reason among the branches that died, the first one found first. Where there is one
    /// for every solution, or for none, all stay.
    pub(super) fn rule_out(&mut self, program: &Program, reasons: &[Option<usize>]) {
        if self.survivors != reasons.len() || reasons.iter().all(Option::is_some) {
            return;
        }
        let first = Solution { registers: std::mem::take(&mut self.chosen), path: std::mem::take(&mut self.choices) };
        let others = self.others.drain(..).zip(self.other_choices.drain(..));
        let solutions = std::iter::once(first).chain(others.map(|(registers, path)| Solution { registers, path }));
        let (mut kept, mut out) = (Vec::new(), Vec::new());
        for (solution, reason) in solutions.zip(reasons) {
            match reason {
                Some(reason) => out.push((solution, *reason)),
                None => kept.push(solution),
            }
        }
        self.survivors = kept.len();
        let mut kept = kept.into_iter();
        if let Some(chosen) = kept.next() {
            for (solution, reason) in out {
                self.bury(program, &solution, &chosen.path, reason);
            }
            (self.chosen, self.choices) = (chosen.registers, chosen.path);
        }
        (self.others, self.other_choices) = kept.map(|solution| (solution.registers, solution.path)).unzip();
    }

    /// Notes a solution as a branch that died where its way parts from the one that is taken.
    fn bury(&mut self, program: &Program, solution: &Solution<R>, taken: &[usize], reason: usize) {
        let parts = solution.path.iter().zip(taken).position(|(here, there)| here != there);
        let Some((parting, stage)) = parts.and_then(|place| Some((place, program.stages.get(place)?))) else { return };
        let (values, path) = (self.death_values.len(), self.death_paths.len());
        let at = |register: &Register| solution.registers.get(*register as usize).cloned();
        self.death_values.extend(stage.unknowns.iter().filter_map(|(register, _)| at(register)));
        self.death_paths.extend(solution.path.iter().take(parting + 1));
        self.deaths.push(Death {
            step: stage.step,
            root: solution.path.get(parting).copied().unwrap_or(0),
            cause: Cause::RuledOut(reason),
            values: (values, self.death_values.len()),
            path: (path, self.death_paths.len()),
        });
    }
}
