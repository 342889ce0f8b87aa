//! `any`: the proof that a quantity without a value does not matter for the answers.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::fmt::Write;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::equal;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Model;
use momentous_quantity::Rational;
use momentous_solve::Closed;
use momentous_solve::Condition;
use momentous_solve::Equation;
use momentous_solve::Relation;
use momentous_solve::Statement;
use momentous_solve::may_grow;

use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::questions::part::AskedUnit;
use super::super::reading::load::Loaded;
use super::planned::Form;
use super::regimes::Leaf;
use super::regimes::Regimes;

/// The symbols that may be anything, and those that a form's text names without telling their values.
pub(crate) fn free(loaded: &Loaded, model: &Model, form: &Form) -> BTreeSet<Symbol> {
    let any = form.known.iter().filter(|known| matches!(known.origin, Origin::Any)).map(|known| known.symbol);
    any.chain(symbols_only(loaded, form, &|name| model.symbol_of(name))).collect()
}

/// The quantities whose symbols a form's text prints without ever telling their values.
fn symbols_only(loaded: &Loaded, form: &Form, named: &dyn Fn(&str) -> Option<Symbol>) -> BTreeSet<Symbol> {
    let mut told = BTreeSet::new();
    let mut only = BTreeSet::new();
    for placeholder in loaded.draft.text.placeholders().chain(form.question.text.placeholders()) {
        let Some(symbol) = named(&placeholder.name) else { continue };
        if placeholder.filter.tells() {
            told.insert(symbol)
        } else {
            only.insert(symbol)
        };
    }
    only.difference(&told).copied().filter(|symbol| form.told.contains(symbol)).collect()
}

/// A fault for each answer of a form that is not proven to be the same whatever its `any` givens are.
pub(crate) fn check(model: &Model, form: &Form) -> Vec<Fault> {
    let known = &form.known;
    let free: Vec<&Known> = known.iter().filter(|known| form.free.contains(&known.symbol)).collect();
    let mut faults = Vec::new();
    if free.is_empty() {
        return faults;
    }
    let zeros = zeros(model, known);
    for leaf in form.solver.leaves() {
        let proof = Proof { form, leaf, zeros: &zeros, sources: Sources::of(leaf) };
        let mut written = fixed(known);
        for part in &form.parts {
            for number in part.kind.numbers() {
                let unit = match number.unit {
                    AskedUnit::InTermsOf(unit, _) => Some(unit),
                    AskedUnit::Unit(_) => None,
                };
                for known in proof.left_open(&free, (number.symbol, unit), &mut written) {
                    let message = format!("it cannot be proven that `{}` does not depend on `{}`", part.id, known.name);
                    let mut help =
                        "give its value, or ask for the answer in terms of it: `unit: v_A1`, or `as: formula`"
                            .to_owned();
                    if !is_positive(leaf, &zeros, &form.known, known.symbol) {
                        let _ = write!(help, "; if it is positive, add `require: [{} > 0]`", known.name);
                    }
                    let fault = Fault::new(Code::UnderDetermined, message).help(help);
                    faults.push(fault.at_path(Path::root().key("given").key(known.name.as_str())));
                }
            }
        }
    }
    faults
}

/// Whether a quantity is proven to be the same whatever a given is, as one way of the scene is planned.
pub(crate) fn is_independent(leaf: &Leaf, symbol: Symbol, given: Symbol) -> bool {
    let sources = Sources::of(leaf);
    let mut written = BTreeMap::new();
    sources.never_use(leaf, &[symbol], given)
        || written_in_givens(leaf, symbol, &mut written)
            .is_some_and(|term| Slopes::new(leaf, &sources, &written, given).are_zero(&term))
}

/// The symbols that may be anything and on which the value of a quantity may depend, as a form solves it.
pub(crate) fn behind<'f>(model: &Model, form: &'f Form, symbol: Symbol) -> Option<&'f Known> {
    let free: Vec<&Known> = form.known.iter().filter(|known| matches!(known.origin, Origin::Any)).collect();
    if free.is_empty() {
        return None;
    }
    let zeros = zeros(model, &form.known);
    let forward = form.forward.iter().filter(|_| form.reveal.iter().any(|reveal| reveal.symbol == symbol));
    forward.chain([&form.solver]).flat_map(Regimes::leaves).find_map(|leaf| {
        let proof = Proof { form, leaf, zeros: &zeros, sources: Sources::of(leaf) };
        proof.left_open(&free, (symbol, None), &mut fixed(&form.known)).first().copied()
    })
}

/// The givens that are expressions of what may be anything: a sheet prints the expression in place of a value.
pub(crate) fn by_formula(loaded: &Loaded, model: &Model, form: &Form) -> BTreeSet<Symbol> {
    let symbols = loaded.given.iter().filter_map(|(name, _)| model.symbol_of(name));
    // A value with its unit stands in no formula, nor does what the sheet does not tell.
    let is_letter =
        |symbol| form.told.contains(&symbol) && model.literals.iter().all(|(literal, _)| *literal != symbol);
    let in_letters = |symbol: &Symbol| model.stated(*symbol).is_some_and(|stated| stated.all_symbols(&is_letter));
    symbols.filter(in_letters).filter(|symbol| behind(model, form, *symbol).is_some()).collect()
}

/// The proof that a quantity is the same whatever is open, in one way that the scene may go.
struct Proof<'a> {
    form: &'a Form,
    leaf: &'a Leaf,
    zeros: &'a BTreeSet<Symbol>,
    sources: Sources,
}

impl Proof<'_> {
    /// Those of some open quantities on which another one, or its ratio to a unit, is not proven not to depend.
    fn left_open<'k>(
        &self,
        free: &[&'k Known],
        (symbol, unit): (Symbol, Option<Symbol>),
        written: &mut BTreeMap<Symbol, Expr>,
    ) -> Vec<&'k Known> {
        let Self { form, leaf, zeros, sources } = self;
        let needed: Vec<Symbol> = [symbol].into_iter().chain(unit).collect();
        let alike = [(symbol, unit)];
        let grows = |symbol: Symbol| {
            is_positive(leaf, zeros, &form.known, symbol) && may_grow(&leaf.system, &form.told, zeros, symbol, &alike)
        };
        let mut open: Vec<&Known> = free.to_vec();
        open.retain(|known| !sources.never_use(leaf, &needed, known.symbol) && !grows(known.symbol));
        if open.is_empty() {
            return open;
        }
        let mut term = written_in_givens(leaf, symbol, written);
        if let Some(unit) = unit {
            let unit = written_in_givens(leaf, unit, written);
            term = term.zip(unit).map(|(term, unit)| (term / unit).simplify());
        }
        let are_zero = |term: &Expr, given: Symbol| Slopes::new(leaf, sources, written, given).are_zero(term);
        open.retain(|known| !term.as_ref().is_some_and(|term| are_zero(term, known.symbol)));
        open
    }
}

/// The symbols that are zero in every variant.
fn zeros(model: &Model, known: &[Known]) -> BTreeSet<Symbol> {
    let given = known.iter().filter(|known| matches!(&known.origin, Origin::Fixed(value) if value.is_zero()));
    let written = model.literals.iter().filter(|(_, quantity)| quantity.value.is_zero());
    given.map(|known| known.symbol).chain(written.map(|(symbol, _)| *symbol)).collect()
}

/// Whether a quantity is positive by its meaning, because the problem requires it, or because a positive quantity is a positive
/// multiple of it: `m` where a mass is `2*m`.
fn is_positive(leaf: &Leaf, zeros: &BTreeSet<Symbol>, known: &[Known], symbol: Symbol) -> bool {
    let is_zero = |side: &Expr| side.is_zero() || matches!(side, Expr::Symbol(symbol) if zeros.contains(symbol));
    let requires = |condition: &Condition| {
        condition.relation == Relation::Greater && condition.left == Expr::from(symbol) && is_zero(&condition.right)
    };
    let drawn = |symbol: Symbol| {
        known.iter().any(|known| known.symbol == symbol && known.origin.is_drawn() && known.origin.limits()[0] > 0.0)
    };
    let is_factor = |factor: &Expr| match factor {
        Expr::Number(number) => *number > Rational::ZERO,
        Expr::Symbol(letter) => *letter == symbol || leaf.system.positive.contains(letter) || drawn(*letter),
        _ => false,
    };
    let is_multiple = |term: &Expr| match term {
        Expr::Product(factors) => {
            factors.iter().filter(|factor| **factor == Expr::from(symbol)).count() == 1 && factors.iter().all(is_factor)
        }
        term => *term == Expr::from(symbol),
    };
    let follows = |equation: &Equation| match &equation.statement {
        Statement::Equal { left: Expr::Symbol(symbol), right } => {
            leaf.system.positive.contains(symbol) && is_multiple(right)
        }
        _ => false,
    };
    leaf.system.positive.contains(&symbol)
        || leaf.system.conditions.iter().any(requires)
        || leaf.system.equations.iter().any(follows)
}

/// The values that never change, as exact numbers.
fn fixed(known: &[Known]) -> BTreeMap<Symbol, Expr> {
    let value = |known: &Known| match (&known.origin, known.unit.factor()) {
        (Origin::Fixed(value), factor) if factor.pi == 0 => Some((known.symbol, Expr::measured(value, &known.unit))),
        _ => None,
    };
    known.iter().filter_map(value).collect()
}

/// From which other quantities each one is computed, at whatever distance.
struct Sources(BTreeMap<Symbol, BTreeSet<Symbol>>);

impl Sources {
    fn of(leaf: &Leaf) -> Self {
        let mut dependence = Self(BTreeMap::new());
        for root in leaf.audit.plan.steps.iter().flat_map(|step| &step.roots) {
            for (unknown, closed) in &root.values {
                let symbols = closed.symbols();
                let further = symbols.iter().filter_map(|source| dependence.0.get(source)).flatten().copied();
                let all: BTreeSet<Symbol> = further.collect::<Vec<_>>().into_iter().chain(symbols).collect();
                dependence.0.entry(*unknown).or_default().extend(all);
            }
        }
        dependence
    }

    /// Whether none of these is computed from a given, and no choice among roots looks at it: a proof without algebra.
    fn never_use(&self, leaf: &Leaf, needed: &[Symbol], given: Symbol) -> bool {
        let uses = |symbol: &Symbol| *symbol == given || self.0.get(symbol).is_some_and(|from| from.contains(&given));
        let conditions =
            leaf.system.conditions.iter().flat_map(|condition| [condition.left.symbols(), condition.right.symbols()]);
        let looked_at: BTreeSet<Symbol> = conditions.flatten().chain(leaf.system.positive.iter().copied()).collect();
        let one_root = leaf.audit.plan.steps.iter().all(|step| step.roots.len() == 1);
        !needed.iter().any(uses) && (one_root || !looked_at.iter().filter(|symbol| **symbol != given).any(uses))
    }
}

/// The proof by algebra that slopes with respect to one given are zero: those of a term, and of every root among which a quantity in
/// it was chosen.
struct Slopes<'a> {
    leaf: &'a Leaf,
    sources: &'a Sources,
    written: &'a BTreeMap<Symbol, Expr>,
    given: Symbol,
    /// What is known of quantities that were chosen among roots: until it is proven, nothing.
    chosen: BTreeMap<Symbol, bool>,
}

impl<'a> Slopes<'a> {
    fn new(leaf: &'a Leaf, sources: &'a Sources, written: &'a BTreeMap<Symbol, Expr>, given: Symbol) -> Self {
        Self { leaf, sources, written, given, chosen: BTreeMap::new() }
    }

    /// Whether a term is the same whatever the given is. Recursion is at most as deep as the plan has steps.
    fn are_zero(&mut self, term: &Expr) -> bool {
        let is_flat = !term.contains(self.given) || equal(&term.differentiate(self.given), &Expr::zero());
        is_flat && term.symbols().into_iter().all(|symbol| symbol == self.given || self.is_same(symbol))
    }

    /// Whether a quantity that stands in a term is the same: it is given, or so is each root that it may be.
    fn is_same(&mut self, symbol: Symbol) -> bool {
        if !self.sources.0.get(&symbol).is_some_and(|from| from.contains(&self.given)) {
            return true;
        }
        if let Some(known) = self.chosen.get(&symbol) {
            return *known;
        }
        self.chosen.insert(symbol, false);
        let roots = self.leaf.audit.plan.steps.iter().flat_map(|step| &step.roots);
        let values = roots.flat_map(|root| &root.values).filter(|(unknown, _)| *unknown == symbol);
        let is_same = values.map(|(_, closed)| closed).all(|closed| match closed {
            Closed::Formula(formula) => {
                let term = formula.substitute(&|symbol| self.written.get(&symbol).cloned()).simplify();
                self.are_zero(&term)
            }
            Closed::FirstInteger { .. } | Closed::BracketedRoot { .. } => false,
        });
        self.chosen.insert(symbol, is_same);
        is_same
    }
}

/// A quantity as a term in what is given, through every step of the plan; `None` where a step has no single formula.
fn written_in_givens(leaf: &Leaf, symbol: Symbol, written: &mut BTreeMap<Symbol, Expr>) -> Option<Expr> {
    if !written.contains_key(&symbol) {
        for step in &leaf.audit.plan.steps {
            let [root] = &step.roots[..] else { continue };
            for (unknown, closed) in &root.values {
                if let Closed::Formula(formula) = closed {
                    let term = formula.substitute(&|symbol| written.get(&symbol).cloned()).simplify();
                    written.insert(*unknown, term);
                }
            }
        }
    }
    let solved = leaf.audit.plan.steps.iter().any(|step| step.unknowns.contains(&symbol));
    if solved { written.get(&symbol).cloned() } else { Some(symbol.into()) }
}
