//! The memory of a replay: made once, used for every variant, so that a replay allocates nothing.

use super::super::number::real::Real;
use super::tape::Register;
use super::writer::Writer;

/// The numbers of a program, as one kind of real.
#[derive(Clone, Debug)]
pub(crate) struct Constants<R> {
    numbers: Vec<(Register, R)>,
    registers: usize,
}

impl<R: Real> Constants<R> {
    pub(crate) fn new(writer: &Writer) -> Self {
        let numbers = writer.constants.iter().map(|(value, register)| (*register, R::from_exact(value)));
        Self { numbers: numbers.collect(), registers: writer.registers as usize }
    }
}

/// Registers, and what a replay found. It may be used with one program after another.
#[derive(Clone, Debug)]
pub struct Workspace<R> {
    pub(crate) registers: Vec<R>,
    /// The registers of the first surviving branch.
    pub(crate) chosen: Vec<R>,
    /// The registers of the surviving branches that differ from it and from each other.
    pub(crate) others: Vec<Vec<R>>,
    /// The root of each stage on each of these.
    pub(crate) other_choices: Vec<Vec<usize>>,
    /// The root of each stage on the branch that is being followed.
    pub(crate) path: Vec<usize>,
    /// The root of each stage on the first surviving branch.
    pub(crate) choices: Vec<usize>,
    pub(super) deaths: Vec<Death>,
    /// The values of the unknowns of the steps at which branches died.
    pub(super) death_values: Vec<R>,
    /// The roots taken on the way to each death.
    pub(super) death_paths: Vec<usize>,
    pub(crate) survivors: usize,
    pub(crate) decided: bool,
    pub(crate) branches: usize,
}

impl<R> Default for Workspace<R> {
    fn default() -> Self {
        Self {
            registers: Vec::new(),
            chosen: Vec::new(),
            others: Vec::new(),
            other_choices: Vec::new(),
            path: Vec::new(),
            choices: Vec::new(),
            deaths: Vec::new(),
            death_values: Vec::new(),
            death_paths: Vec::new(),
            survivors: 0,
            decided: true,
            branches: 0,
        }
    }
}

impl<R: Real> Workspace<R> {
    /// Ready for a replay: constants and inputs in their registers. An input that is missing is not real.
    pub(crate) fn prepare<'i>(
        &mut self,
        constants: &Constants<R>,
        places: &[Register],
        inputs: impl Iterator<Item = &'i R>,
    ) where
        R: 'i,
    {
        if self.registers.len() != constants.registers {
            self.registers.clear();
            self.registers.resize(constants.registers, R::not_real());
        }
        for place in places {
            self.registers[*place as usize] = R::not_real();
        }
        for (place, value) in places.iter().zip(inputs) {
            self.registers[*place as usize] = value.clone();
        }
        for (register, value) in &constants.numbers {
            self.registers[*register as usize] = value.clone();
        }
        self.path.clear();
        self.choices.clear();
        self.deaths.clear();
        self.death_values.clear();
        self.death_paths.clear();
        (self.survivors, self.decided, self.branches) = (0, true, 0);
        self.others.clear();
        self.other_choices.clear();
    }
}

/// Why a branch is no solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// It breaks the condition at this position in the system.
    Condition(usize),
    /// It does not satisfy the equation at this position, though it was found from its square or the like, or though
    /// nothing used the equation.
    Equation(usize),
    /// Some unknown has no real value.
    NotReal,
    /// An unknown that is positive in every admissible solution comes out negative.
    NotPositive,
    /// The caller ruled it out, for that reason of its own.
    RuledOut(usize),
}

/// A branch that died, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Death {
    /// The step at which it died; none where the givens alone break a condition.
    pub step: Option<usize>,
    /// The root of that step.
    pub root: usize,
    /// Why.
    pub cause: Cause,
    pub(crate) values: (usize, usize),
    pub(crate) path: (usize, usize),
}

/// When a variant is replayed exactly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// Only where floating point leaves something open.
    #[default]
    OnDemand,
    /// Always: what is decided must be the same.
    Exact,
}

/// The memory of [`super::super::Program::solve`]: a replay in floating point, and an exact one where it is needed.
#[derive(Clone, Debug, Default)]
pub struct Workspaces {
    pub(crate) precision: Precision,
    pub(super) fast: Workspace<super::super::Bounded>,
    pub(crate) precise: Workspace<super::super::Precise>,
    pub(super) replayed: bool,
}

impl Workspaces {
    /// Memory for replays of that precision.
    #[must_use]
    pub fn new(precision: Precision) -> Self {
        Self { precision, ..Self::default() }
    }
}
