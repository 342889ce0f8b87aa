//! Replaying a program: every root is followed until it breaks something.

use std::f64::consts::TAU;

use momentous_expr::Symbol;

use super::super::number::bounded::Bounded;
use super::super::number::precise::Precise;
use super::super::number::real::{Real, Sign};
use super::super::planning::pending::Tested;
use super::super::{Exact, Outcome, Relation};
use super::bracketing::next_root;
use super::counting::first_integer;
use super::program::{Program, Stage, Work};
use super::tape::{Register, run};
use super::workspace::{Cause, Death, Precision, Workspace, Workspaces};

/// At most this many branches are followed.
const MOST_BRANCHES: usize = 4096;

/// A wanted value whose bound is a larger share of it than this is computed again exactly: so no certificate is more than a
/// thousand times what rounding the answer once costs.
const TIGHT: f64 = 200.0 * f64::EPSILON;

impl Program {
    /// Replays in floating point. A condition whose two sides agree within their error counts as satisfied, and the
    /// outcome is not decided; [`Program::solve`] decides it.
    pub fn run<'a>(&'a self, inputs: &[Bounded], workspace: &'a mut Workspace<Bounded>) -> Outcome<'a, Bounded> {
        self.run_fast(inputs, workspace, false)
    }

    fn run_fast<'a>(
        &'a self,
        inputs: &[Bounded],
        workspace: &'a mut Workspace<Bounded>,
        last: bool,
    ) -> Outcome<'a, Bounded> {
        workspace.prepare(&self.fast, &self.inputs, inputs.iter());
        Replay { program: self, workspace, last }.follow();
        Outcome { program: self, workspace, exact: false }
    }

    /// Replays exactly as long as operations are rational, and with 77 digits from there on. What is then still within its
    /// error of zero is taken to be zero: a strict inequality is broken by it, the others are satisfied.
    pub fn run_exact<'a>(&'a self, inputs: &[Exact], workspace: &'a mut Workspace<Precise>) -> Outcome<'a, Precise> {
        let inputs: Vec<Precise> = inputs.iter().map(Precise::from_exact).collect();
        workspace.prepare(&self.precise, &self.inputs, inputs.iter());
        Replay { program: self, workspace, last: true }.follow();
        Outcome { program: self, workspace, exact: true }
    }

    /// Solves one variant: in floating point, and again exactly where that leaves something open: a condition that is not
    /// decided, several solutions, or a wanted value whose bound is not tight. Values are rounded to floating point with
    /// bounds that cover the rounding.
    pub fn solve<'a>(&'a self, inputs: &[Exact], workspaces: &'a mut Workspaces) -> Outcome<'a, Bounded> {
        let bounded: Vec<Bounded> = inputs.iter().map(Bounded::from_exact).collect();
        self.solve_from(&bounded, &|| inputs.to_vec(), workspaces)
    }

    /// The same from floating-point inputs with bounds; `exact` gives the inputs themselves, and is asked only where the
    /// replay in floating point leaves something open.
    pub fn solve_from<'a>(
        &'a self,
        inputs: &[Bounded],
        exact: &dyn Fn() -> Vec<Exact>,
        workspaces: &'a mut Workspaces,
    ) -> Outcome<'a, Bounded> {
        let Workspaces { precision, fast, precise, replayed } = workspaces;
        *replayed = *precision == Precision::Exact || self.run(inputs, fast).is_open();
        if *replayed {
            self.run_exact(&exact(), precise);
            round(&self.symbols, precise, fast);
        }
        Outcome { program: self, workspace: fast, exact: *replayed }
    }

    /// Solves a limiting case, in which conditions may hold with nothing to spare, in floating point alone: what is within its
    /// error of zero is taken to be zero.
    pub fn solve_limit<'a>(&'a self, inputs: &[Bounded], workspaces: &'a mut Workspaces) -> Outcome<'a, Bounded> {
        workspaces.replayed = false;
        self.run_fast(inputs, &mut workspaces.fast, true)
    }
}

impl<R: Real> Outcome<'_, R> {
    /// Whether more digits are needed.
    fn is_open(&self) -> bool {
        let loose = |value: &R| {
            let value = value.to_bounded();
            value.error > TIGHT * value.value.abs()
        };
        let is_loose = |symbol: &Symbol| self.value(*symbol).is_none_or(loose);
        !self.is_decided() || self.survivors() > 1 || self.survivors() == 1 && self.program.wanted.iter().any(is_loose)
    }
}

/// Puts what a replay with more digits found in place of what a floating-point replay found. Only the values of symbols are
/// ever asked for; the others stay as they were.
fn round<R: Real>(symbols: &[(Symbol, Register)], precise: &Workspace<R>, fast: &mut Workspace<Bounded>) {
    let rounded = |values: &[R], into: &mut Vec<Bounded>| {
        into.resize(values.len(), Bounded::not_real());
        for place in symbols.iter().map(|(_, register)| *register as usize) {
            if let (Some(value), Some(place)) = (values.get(place), into.get_mut(place)) {
                *place = value.to_bounded();
            }
        }
    };
    rounded(&precise.chosen, &mut fast.chosen);
    fast.others.resize_with(precise.others.len(), Vec::new);
    for (values, into) in precise.others.iter().zip(&mut fast.others) {
        rounded(values, into);
    }
    fast.death_values.clear();
    fast.death_values.extend(precise.death_values.iter().map(R::to_bounded));
    fast.choices.clone_from(&precise.choices);
    fast.other_choices.clone_from(&precise.other_choices);
    fast.deaths.clone_from(&precise.deaths);
    fast.death_paths.clone_from(&precise.death_paths);
    (fast.survivors, fast.decided) = (precise.survivors, precise.decided);
}

/// A replay under way.
struct Replay<'a, R> {
    program: &'a Program,
    workspace: &'a mut Workspace<R>,
    /// Whether no better arithmetic follows.
    last: bool,
}

impl<R: Real> Replay<'_, R> {
    /// Follows every branch. Where there is nothing to choose and nothing to search, all is computed in one go once the givens
    /// are judged.
    fn follow(&mut self) {
        let program = self.program;
        let (true, Some((givens, steps))) = (program.is_computed, program.stages.split_first()) else {
            return self.stage(0);
        };
        let (judged, whole) = (givens.tests_code.end, program.tape.len());
        run(&program.tape, &(0..judged), &mut self.workspace.registers);
        if self.passes(givens) {
            run(&program.tape, &(judged..whole), &mut self.workspace.registers);
            if steps.iter().all(|step| self.passes(step)) {
                self.survive();
            }
        }
    }

    /// Whether the only root of a stage serves.
    fn passes(&mut self, stage: &Stage) -> bool {
        self.workspace.branches += 1;
        self.workspace.path.push(0);
        let cause = self.judge(stage);
        if let Some(cause) = cause {
            self.die(stage, 0, cause);
        }
        cause.is_none()
    }

    /// Follows every root of a stage. Recursion is as deep as the plan has steps.
    fn stage(&mut self, index: usize) {
        let program = self.program;
        let Some(stage) = program.stages.get(index) else {
            self.survive();
            return;
        };
        run(&program.tape, &stage.prelude, &mut self.workspace.registers);
        for (root, branch) in stage.roots.iter().enumerate() {
            if self.workspace.branches > MOST_BRANCHES {
                self.workspace.decided = false;
                return;
            }
            self.workspace.branches += 1;
            self.workspace.path.truncate(index);
            self.workspace.path.push(root);
            let is_there = branch.work.iter().all(|work| self.work(work));
            if !is_there && root > 0 {
                break;
            }
            run(&program.tape, &stage.tests_code, &mut self.workspace.registers);
            match self.judge(stage) {
                None => self.stage(index + 1),
                Some(cause) => self.die(stage, root, cause),
            }
        }
    }

    /// Does a piece of work; whether there is what it searches for. Where one root of several is not there, the next are not either.
    fn work(&mut self, work: &Work) -> bool {
        let program = self.program;
        let registers = &mut self.workspace.registers;
        match work {
            Work::Run(stretch) => {
                run(&program.tape, stretch, registers);
                true
            }
            Work::Count { variable, from, code, difference, relation } => {
                let mut decided = true;
                let integer = first_integer(*from, |candidate| {
                    registers[*variable as usize] = R::integer(candidate);
                    run(&program.tape, code, registers);
                    let verdict = verdict(*relation, &registers[*difference as usize], self.last);
                    decided &= verdict.is_some();
                    verdict.unwrap_or(false)
                });
                self.workspace.decided &= decided;
                self.workspace.registers[*variable as usize] = integer.map_or_else(R::not_real, R::integer);
                integer.is_some()
            }
            Work::Bracket { variable, code, residual, is_first, repeats } => {
                let least = if *is_first { 0.0 } else { registers[*variable as usize].rough() };
                let most = if *repeats { TAU } else { f64::INFINITY };
                let root = next_root([least, most], |candidate: &R| {
                    registers[*variable as usize] = candidate.clone();
                    run(&program.tape, code, registers);
                    registers[*residual as usize].clone()
                });
                let is_there = root.is_some();
                registers[*variable as usize] = root.unwrap_or_else(R::not_real);
                is_there
            }
        }
    }

    /// Why the branch dies at this stage, if it does; all that the stage says is computed.
    fn judge(&mut self, stage: &Stage) -> Option<Cause> {
        let mut is_broken = false;
        for (register, positive) in &stage.unknowns {
            match self.at(*register).sign() {
                Sign::NotReal => return Some(Cause::NotReal),
                Sign::Negative => is_broken |= *positive,
                Sign::Zero | Sign::Positive | Sign::Unsure => {}
            }
        }
        for test in &stage.tests {
            let difference = self.at(test.difference);
            match test.what {
                Tested::Condition(place, relation) => match verdict(relation, difference, self.last) {
                    Some(true) => {}
                    Some(false) => return Some(Cause::Condition(place)),
                    None => self.workspace.decided = false,
                },
                Tested::Equation(place) => {
                    if !matches!(difference.sign(), Sign::Zero | Sign::Unsure) {
                        return Some(Cause::Equation(place));
                    }
                }
            }
        }
        is_broken.then_some(Cause::NotPositive)
    }

    /// The value in a register: the compiler of the tape made it.
    fn at(&self, register: Register) -> &R {
        &self.workspace.registers[register as usize]
    }

    fn die(&mut self, stage: &Stage, root: usize, cause: Cause) {
        let workspace = &mut *self.workspace;
        let (values, path) = (workspace.death_values.len(), workspace.death_paths.len());
        for (register, _) in &stage.unknowns {
            workspace.death_values.push(workspace.registers[*register as usize].clone());
        }
        workspace.death_paths.extend_from_slice(&workspace.path);
        workspace.deaths.push(Death {
            step: stage.step,
            root,
            cause,
            values: (values, workspace.death_values.len()),
            path: (path, workspace.death_paths.len()),
        });
    }

    /// The branch is a solution: the first, or another if it differs from the first.
    fn survive(&mut self) {
        let workspace = &mut *self.workspace;
        if workspace.survivors == 0 {
            if self.program.is_straight() {
                std::mem::swap(&mut workspace.chosen, &mut workspace.registers);
            } else {
                workspace.chosen.clone_from(&workspace.registers);
            }
            workspace.choices.clone_from(&workspace.path);
            workspace.survivors = 1;
            return;
        }
        let registers = &workspace.registers;
        let unknowns = || self.program.stages.iter().flat_map(|stage| &stage.unknowns);
        let (mut is_known, mut unsure) = (false, false);
        for values in std::iter::once(&workspace.chosen).chain(&workspace.others) {
            let signs = unknowns().map(|(place, _)| values[*place as usize].sub(&registers[*place as usize]).sign());
            let (mut differs, mut open) = (false, false);
            for sign in signs {
                match sign {
                    Sign::Zero => {}
                    Sign::Unsure => open = true,
                    _ => differs = true,
                }
            }
            is_known |= !differs;
            unsure |= !differs && open;
        }
        if !is_known {
            let registers = workspace.registers.clone();
            workspace.others.push(registers);
            workspace.other_choices.push(workspace.path.clone());
            workspace.survivors += 1;
        }
        workspace.decided &= !unsure || self.last;
    }
}

/// Whether a difference compares with zero as the relation says; `None` where that is not decided.
fn verdict<R: Real>(relation: Relation, difference: &R, last: bool) -> Option<bool> {
    let sign = match difference.sign() {
        Sign::Unsure if last && !difference.is_unbounded() => Sign::Zero,
        sign => sign,
    };
    match (relation, sign) {
        (_, Sign::Unsure) => None,
        (_, Sign::NotReal) => Some(false),
        (Relation::Less, sign) => Some(sign == Sign::Negative),
        (Relation::AtMost, sign) => Some(sign != Sign::Positive),
        (Relation::Greater, sign) => Some(sign == Sign::Positive),
        (Relation::AtLeast, sign) => Some(sign != Sign::Negative),
        (Relation::Differs, sign) => Some(sign != Sign::Zero),
        (Relation::Equals, sign) => Some(sign == Sign::Zero),
    }
}
