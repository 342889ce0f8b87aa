//! A plan as a program: compiled once, replayed for every variant.

use momentous_expr::Expr;
use momentous_expr::Symbol;

use super::super::number::bounded::Bounded;
use super::super::number::precise::Precise;
use super::super::planning::pending::{Pending, Test, Verify};
use super::super::{Audit, Closed, Relation, Root, Step, System};
use super::tape::{Instruction, Register, Stretch};
use super::workspace::Constants;
use super::writer::Writer;

/// A plan, its checks and its conditions, flattened onto a tape.
#[derive(Clone, Debug)]
pub struct Program {
    pub(crate) tape: Vec<Instruction>,
    pub(super) stages: Vec<Stage>,
    pub(crate) inputs: Vec<Register>,
    pub(crate) symbols: Vec<(Symbol, Register)>,
    pub(crate) wanted: Vec<Symbol>,
    pub(super) fast: Constants<Bounded>,
    pub(crate) precise: Constants<Precise>,
    pub(super) unchecked: Vec<usize>,
    /// Whether there is no choice of roots and no search: everything on the tape is computed once.
    pub(super) is_computed: bool,
}

/// Why a plan cannot be compiled: it uses a symbol that neither the inputs nor the steps before give.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the plan uses a symbol before it is found")]
pub struct UnknownSymbol {
    /// The step; as many as there are steps where it is a check.
    pub step: usize,
}

/// One step of the plan on the tape. The first stage has no step: it judges the givens.
#[derive(Clone, Debug)]
pub(super) struct Stage {
    /// The position of the step in the plan.
    pub(crate) step: Option<usize>,
    /// The instructions that all roots share.
    pub(super) prelude: Stretch,
    /// The roots.
    pub(crate) roots: Vec<Branch>,
    /// The registers of the step's unknowns, and whether the unknown is positive.
    pub(crate) unknowns: Vec<(Register, bool)>,
    /// The instructions that the tests need.
    pub(super) tests_code: Stretch,
    /// The conditions, as far as they can be told once the step is done.
    pub(crate) tests: Vec<Test>,
}

/// One root of a step on the tape.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    /// The pieces of work, in order.
    pub(super) work: Vec<Work>,
}

/// A piece of work.
#[derive(Clone, Debug)]
pub(super) enum Work {
    /// Run a stretch.
    Run(Stretch),
    /// Find the first integer for which the difference compares with zero as it should.
    Count { variable: Register, from: i64, code: Stretch, difference: Register, relation: Relation },
    /// Find where the residual is zero; behind the root before, which the variable still holds, where it is not the first.
    Bracket { variable: Register, code: Stretch, residual: Register, is_first: bool, repeats: bool },
}

impl Program {
    /// Compiles an audit (or an answer plan made into one). `inputs` are the known symbols in the order in which their
    /// values will be given; `wanted` those whose bounds must be tight.
    ///
    /// # Errors
    ///
    /// [`UnknownSymbol`], where the plan does not belong to these inputs.
    pub fn compile(
        system: &System,
        audit: &Audit,
        inputs: &[Symbol],
        wanted: &[Symbol],
        verify: Verify,
    ) -> Result<Self, UnknownSymbol> {
        let mut writer = Writer::default();
        let inputs: Vec<Register> = inputs.iter().map(|symbol| writer.input(*symbol)).collect();
        let mut tests = Pending::new(system, audit, verify);
        let mut stages = vec![Stage {
            step: None,
            prelude: 0..0,
            roots: vec![Branch { work: Vec::new() }],
            unknowns: Vec::new(),
            tests_code: 0..0,
            tests: Vec::new(),
        }];
        if let Some(stage) = stages.first_mut() {
            (stage.tests_code, stage.tests) = writer.stretch(|writer| tests.ready(writer));
        }
        for (place, step) in audit.plan.steps.iter().enumerate() {
            let unknown_symbol = UnknownSymbol { step: place };
            let mut stage = write_step(&mut writer, system, place, step).ok_or(unknown_symbol)?;
            (stage.tests_code, stage.tests) = writer.stretch(|writer| tests.ready(writer));
            stages.push(stage);
        }
        let runs = |work: &Work| matches!(work, Work::Run(_));
        let one_way = |stage: &Stage| matches!(stage.roots.as_slice(), [only] if only.work.iter().all(runs));
        Ok(Self {
            is_computed: stages.iter().all(one_way),
            stages,
            inputs,
            symbols: writer.symbols.iter().collect(),
            wanted: wanted.to_vec(),
            fast: Constants::new(&writer),
            precise: Constants::new(&writer),
            unchecked: tests.conditions(),
            tape: writer.tape,
        })
    }

    /// The conditions that cannot be judged, since some of their symbols are not found: positions in the system.
    #[must_use]
    pub fn unchecked(&self) -> &[usize] {
        &self.unchecked
    }

    /// Whether it only computes: no choice of roots, no search, and nothing to judge.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.is_computed && self.stages.iter().all(|stage| stage.tests.is_empty())
    }

    /// Whether no step has a choice of roots.
    pub(super) fn is_straight(&self) -> bool {
        self.stages.iter().all(|stage| stage.roots.len() == 1)
    }

    /// The register of a symbol that the program finds or is given.
    pub(crate) fn register(&self, symbol: Symbol) -> Option<Register> {
        let place = self.symbols.binary_search_by_key(&symbol, |(known, _)| *known).ok()?;
        self.symbols.get(place).map(|(_, register)| *register)
    }
}

/// Writes a step. What does not depend on the root chosen is computed once, before the roots.
fn write_step<'s>(writer: &mut Writer, system: &System, place: usize, step: &'s Step) -> Option<Stage> {
    let (mut prelude, hoisted) = writer.stretch(|writer| {
        let formula = |value: &'s Closed| if let Closed::Formula(expr) = value { Some(expr) } else { None };
        let known = |expr: &&Expr| expr.all_symbols(&|symbol| writer.symbols.holds(symbol));
        let values = step.roots.iter().flat_map(|root| &root.values);
        let ready: Vec<&Expr> = values.filter_map(|(_, value)| formula(value)).filter(known).collect();
        ready.into_iter().try_for_each(|expr| writer.expr(expr).map(drop))
    });
    hoisted?;
    let registers: Vec<(Symbol, Register)> = if let [root] = step.roots.as_slice() {
        // A single root needs no copies: its registers are the unknowns' own.
        let (code, work) = writer.stretch(|writer| write_root(writer, root, None));
        let branch = Branch { work: work? };
        prelude.end = prelude.end.max(code.start);
        let registers =
            step.unknowns.iter().filter_map(|symbol| Some((*symbol, writer.symbols.get(*symbol)?))).collect();
        return Some(stage(system, place, prelude, vec![branch], registers));
    } else {
        step.unknowns.iter().map(|symbol| (*symbol, writer.register())).collect()
    };
    let mut roots = Vec::new();
    for root in &step.roots {
        let mark = writer.mark();
        roots.push(Branch { work: write_root(writer, root, Some(&registers))? });
        writer.forget(mark);
    }
    writer.symbols.extend(registers.iter().copied());
    Some(stage(system, place, prelude, roots, registers))
}

fn stage(
    system: &System,
    step: usize,
    prelude: Stretch,
    roots: Vec<Branch>,
    registers: Vec<(Symbol, Register)>,
) -> Stage {
    let unknowns =
        registers.into_iter().map(|(symbol, register)| (register, system.positive.contains(&symbol))).collect();
    Stage { step: Some(step), prelude, roots, unknowns, tests_code: 0..0, tests: Vec::new() }
}

/// Writes the values of one root; into `registers` where other roots share them.
fn write_root(writer: &mut Writer, root: &Root, registers: Option<&[(Symbol, Register)]>) -> Option<Vec<Work>> {
    let mut work = Vec::new();
    for (symbol, value) in &root.values {
        let wanted = registers
            .and_then(|registers| registers.iter().find(|(known, _)| known == symbol))
            .map(|(_, register)| *register);
        match value {
            Closed::Formula(expr) => {
                let (code, register) = writer.stretch(|writer| {
                    let register = writer.expr(expr)?;
                    if let Some(wanted) = wanted {
                        writer.copy(register, wanted);
                    }
                    Some(wanted.unwrap_or(register))
                });
                writer.symbols.insert(*symbol, register?);
                work.push(Work::Run(code));
            }
            Closed::FirstInteger { from, left, relation, right } => {
                let variable = wanted.unwrap_or_else(|| writer.register());
                writer.symbols.insert(*symbol, variable);
                let mark = writer.mark();
                let (code, difference) = writer.stretch(|writer| writer.difference(left, right));
                writer.forget(mark);
                work.push(Work::Count { variable, from: *from, code, difference: difference?, relation: *relation });
            }
            Closed::BracketedRoot { residual, index, repeats } => {
                let variable = wanted.unwrap_or_else(|| writer.register());
                writer.symbols.insert(*symbol, variable);
                let mark = writer.mark();
                let (code, residual) = writer.stretch(|writer| writer.expr(residual));
                writer.forget(mark);
                let (is_first, repeats) = (*index == 0, *repeats);
                work.push(Work::Bracket { variable, code, residual: residual?, is_first, repeats });
            }
        }
    }
    Some(work)
}
