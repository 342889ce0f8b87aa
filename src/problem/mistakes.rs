//! The usual mistakes in one form of a problem, each as the program that makes it. They are planned once, when the first
//! wrong answer asks for them; right answers never do.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::OnceLock;

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::laws::wrong::Misconception;
use crate::laws::wrong::reading::MISREADINGS;
use crate::laws::wrong::reading::SLIPS;
use crate::laws::wrong::reading::SlipOf;
use crate::quantity::Unit;
use crate::solve::Bounded;
use crate::solve::Plan;
use crate::solve::Program;
use crate::solve::Real;
use crate::solve::System;
use crate::solve::Verify;
use crate::solve::Workspace;

use super::part::NumberPart;
use super::part::PartKind;
use super::part::Tolerance;
use super::planned::Form;
use super::planned::Problem;
use super::regimes::Leaf;
use super::restricted::Restricted;
use super::rounding::half_unit;
use super::variant::Worked;

/// The mistakes of a form, one list for each way in which its scene can go; empty until they are asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Mistakes(Arc<OnceLock<Vec<Vec<Mistake>>>>);

/// One way of making one usual mistake.
#[derive(Clone, Debug)]
pub struct Mistake {
    /// The mistake.
    pub of: &'static Misconception,
    /// The law that is got wrong, as it is used: a position in [`crate::model::Model::instances`]; none where nothing is
    /// wrong with the laws.
    pub instance: Option<usize>,
    made: Made,
}

#[derive(Clone, Debug)]
enum Made {
    /// The system has a wrong equation.
    Solved(Vec<Solver>),
    /// Some givens are taken too large or too small by a factor.
    Misread(Arc<Solver>, Vec<(Symbol, f64)>),
    /// The right value is written down wrongly.
    Written(SlipOf, fn(f64) -> f64),
}

/// A program for some of the quantities that are asked, with what chooses among its roots.
#[derive(Clone, Debug)]
pub(super) struct Solver {
    wanted: Vec<Symbol>,
    inputs: Vec<Symbol>,
    plan: Plan,
    /// With the conditions of a true solution, where there is something to choose.
    strict: Option<Program>,
    /// Without them: a wrong value need not be a possible one.
    loose: Program,
}

/// A formula and a program give the same within this share.
const SAME: f64 = 1e-9;

thread_local! {
    /// A wrong answer runs some dozens of programs; with one memory for all of them they allocate nothing.
    static MEMORY: RefCell<Workspace<Bounded>> = RefCell::default();
}

impl Mistakes {
    pub(super) fn of_leaf(&self, problem: &Problem, form: &Form, leaf: usize) -> &[Mistake] {
        let all = self.0.get_or_init(|| form.solver.leaves().iter().map(|leaf| planned(problem, form, leaf)).collect());
        all.get(leaf).map_or(&[], Vec::as_slice)
    }
}

fn planned(problem: &Problem, form: &Form, leaf: &Leaf) -> Vec<Mistake> {
    let used: BTreeSet<usize> = leaf.answer_steps().iter().flat_map(|step| step.equations.iter().copied()).collect();
    let wanted: Vec<Symbol> = form.wanted().collect();
    let mut mistakes: Vec<Mistake> = Vec::new();
    for mistaken in problem.model().mistaken(&leaf.system, &used, &form.told, problem.units()) {
        let solvers = Solver::each(&mistaken.system, &form.told, &wanted);
        if !solvers.is_empty() {
            let made = Made::Solved(solvers);
            mistakes.push(Mistake { of: mistaken.of, instance: Some(mistaken.instance), made });
        }
    }
    let right = Restricted::new(&leaf.system, used);
    if let Some(right) = Solver::new(&right.system, &form.told, &wanted).map(Arc::new) {
        mistakes.extend(misread(problem, form, &right));
    }
    mistakes.extend(SLIPS.iter().map(|slip| Mistake {
        of: slip.of,
        instance: None,
        made: Made::Written(slip.to, slip.written),
    }));
    mistakes
}

/// Every unit that some given has and that is often overlooked: of all its givens, and of each alone.
fn misread(problem: &Problem, form: &Form, right: &Arc<Solver>) -> Vec<Mistake> {
    let mut mistakes = Vec::new();
    for row in MISREADINGS {
        let (Ok(given), Ok(taken)) = (Unit::parse(row.given), Unit::parse(row.taken)) else { continue };
        let factor = (taken.factor() * given.factor().power(-1)).to_f64();
        let told =
            form.told.iter().filter(|symbol| problem.unit_told(form, **symbol).is_some_and(|unit| unit == given));
        let read: Vec<(Symbol, f64)> = told.map(|symbol| (*symbol, factor)).collect();
        let mistake = |read: Vec<(Symbol, f64)>| Mistake {
            of: row.of,
            instance: None,
            made: Made::Misread(Arc::clone(right), read),
        };
        if read.len() > 1 {
            mistakes.extend(read.iter().map(|own| mistake(vec![*own])));
        }
        if !read.is_empty() {
            mistakes.push(mistake(read));
        }
    }
    mistakes
}

impl Solver {
    /// A program for everything that is wanted; where the mistake leaves some of it open, one for each that it does not.
    fn each(system: &System, told: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Vec<Self> {
        match Self::new(system, told, wanted) {
            Some(whole) => vec![whole],
            None => wanted.iter().filter_map(|symbol| Self::new(system, told, &[*symbol])).collect(),
        }
    }

    pub(super) fn new(system: &System, told: &BTreeSet<Symbol>, wanted: &[Symbol]) -> Option<Self> {
        let plan = crate::solve::plan(system, told, wanted).ok()?;
        let several = plan.steps.iter().any(|step| step.roots.len() > 1);
        let audit = crate::solve::Audit { answer_steps: plan.steps.len(), plan, checks: Vec::new() };
        let inputs: Vec<Symbol> = told.iter().copied().collect();
        let compile = |system: &System| Program::compile(system, &audit, &inputs, wanted, Verify::Redundant).ok();
        let strict = if several { compile(system) } else { None };
        let bare = System { conditions: Vec::new(), ..system.clone() };
        let loose = compile(&bare)?;
        Some(Self { wanted: wanted.to_vec(), strict, loose, inputs, plan: audit.plan })
    }

    /// What the program takes, in order.
    pub(super) fn inputs(&self) -> &[Symbol] {
        &self.inputs
    }

    /// The values of a quantity in every solution: those that can be, or where none can, all.
    pub(super) fn values(&self, symbol: Symbol, input: &dyn Fn(Symbol) -> Option<Bounded>) -> Vec<f64> {
        if !self.wanted.contains(&symbol) {
            return Vec::new();
        }
        let inputs: Option<Vec<Bounded>> = self.inputs.iter().map(|own| input(*own)).collect();
        let Some(inputs) = inputs else { return Vec::new() };
        MEMORY.with_borrow_mut(|memory| {
            let mut run = |program: &Program| {
                let outcome = program.run(&inputs, memory);
                let first = outcome.value(symbol).into_iter();
                let all = first.chain(outcome.other_values(symbol)).filter(|value| value.is_real());
                all.map(|value| value.value).filter(|value| value.is_finite()).collect::<Vec<f64>>()
            };
            let possible = self.strict.as_ref().map(&mut run).unwrap_or_default();
            if possible.is_empty() { run(&self.loose) } else { possible }
        })
    }
}

impl Problem {
    /// The unit in which a form tells a quantity.
    fn unit_told(&self, form: &Form, symbol: Symbol) -> Option<Unit> {
        let revealed = form.reveal.iter().find(|reveal| reveal.symbol == symbol).map(|reveal| reveal.unit.clone());
        revealed.or_else(|| self.unit_given(symbol))
    }
}

impl<'a> Worked<'a> {
    /// The usual mistakes that can be made with this variant's form. They are planned when this is first called.
    #[must_use]
    pub fn mistakes(&self) -> &'a [Mistake] {
        self.form.mistakes.of_leaf(self.problem, self.form, self.variant.leaf())
    }

    /// What a mistake makes of a quantity, as formulas in what is given; none where nothing but numbers is got wrong.
    #[must_use]
    pub fn mistaken_formulas(&self, mistake: &Mistake, symbol: Symbol) -> Vec<Expr> {
        let Made::Solved(solvers) = &mistake.made else { return Vec::new() };
        let told = |symbol: Symbol| self.variant.value(symbol);
        let right = self.every_formula(&self.leaf().audit.plan, symbol);
        let mut formulas: Vec<Expr> = Vec::new();
        for solver in solvers.iter().filter(|solver| solver.wanted.contains(&symbol)) {
            let values = solver.values(symbol, &told);
            for formula in self.every_formula(&solver.plan, symbol) {
                // Of several roots the one that is possible for these numbers.
                let value = formula.evaluate(&|own| told(own).map_or(f64::NAN, |value| value.value));
                let taken = values.iter().any(|own| (own - value).abs() <= SAME * value.abs());
                if taken && !formulas.contains(&formula) && !right.contains(&formula) {
                    formulas.push(formula);
                }
            }
        }
        formulas
    }

    /// What a mistake makes of the answer to a part, in the unit of the question; none where it cannot be made there.
    #[must_use]
    pub fn mistaken(&self, mistake: &Mistake, number: &NumberPart) -> Vec<f64> {
        let unit = self.unit_of(number);
        let told = |symbol: Symbol| self.variant.value(symbol);
        let values = match &mistake.made {
            Made::Solved(solvers) => solvers.iter().flat_map(|solver| solver.values(number.symbol, &told)).collect(),
            Made::Misread(right, read) => {
                let misread = |symbol: Symbol| {
                    let factor = read.iter().find(|(own, _)| *own == symbol).map_or(1.0, |(_, factor)| *factor);
                    told(symbol).map(|own| Bounded { value: own.value * factor, error: own.error * factor })
                };
                right.values(number.symbol, &misread)
            }
            Made::Written(to, written) => {
                let fits = match to {
                    SlipOf::Signed => self.is_signed(number),
                    SlipOf::Angle => number.plain_unit().factor().pi != 0,
                    SlipOf::Count => number.whole,
                };
                told(number.symbol).filter(|_| fits).map(|value| written(value.value)).into_iter().collect()
            }
        };
        values.into_iter().map(|value| value / unit).filter(|value| value.is_finite()).collect()
    }

    /// Whether a mistake changes some answer by more than its tolerance; true where it cannot be made.
    #[must_use]
    pub fn tells_apart(&self, mistake: &str) -> bool {
        let mut possible = false;
        let numbers = || {
            self.form.parts.iter().filter_map(|part| match &part.kind {
                PartKind::Number(number) => Some(number),
                PartKind::Vector(_) | PartKind::Formula(_) | PartKind::Range(_) | PartKind::Choice(_) => None,
            })
        };
        for mistake in self.mistakes().iter().filter(|own| own.of.id == mistake) {
            for number in numbers() {
                let right = self.answer(number).value;
                let allowed = match &number.tolerance {
                    Tolerance::Relative(share) => share.to_f64() * right.abs(),
                    Tolerance::Absolute(distance) => distance.to_f64(),
                    Tolerance::ToFigures => half_unit(right, number.figures),
                };
                let allowed = allowed.max(self.judged(number).allowance);
                for value in self.mistaken(mistake, number) {
                    possible = true;
                    if (value - right).abs() > allowed {
                        return true;
                    }
                }
            }
        }
        !possible
    }

    /// Whether the sign of a number says a direction, so that it can be got wrong.
    fn is_signed(&self, number: &NumberPart) -> bool {
        let entry = self.problem.model().symbols.entry(number.symbol);
        let senses = super::say::senses_of(&self.problem.loaded().draft.scene, &entry.name);
        senses.is_some() && ["v_", "p_", "J_", "F_avg_"].iter().any(|start| entry.name.starts_with(start))
    }
}
