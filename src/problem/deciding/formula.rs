//! Questions that are answered by a formula: the steps of the plan put together, in the symbols of what is given.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::equal_where;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;
use momentous_solve::Closed;
use momentous_solve::Move;
use momentous_solve::Plan;
use momentous_solve::Step;
use momentous_solve::quadratic_formula;

use super::super::compiling::planned::Form;
use super::super::compiling::regimes::Leaf;
use super::super::language::given::Given;
use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::questions::part::FormulaPart;
use super::super::questions::part::PartKind;
use super::super::sampling::variant::Worked;

/// The letters of a form's formulas.
#[derive(Clone, Debug, Default)]
pub struct Alphabet {
    /// The letters that a formula may contain, each with the least and the greatest value that it has in the problem, in SI
    /// units.
    pub letters: Vec<(Symbol, f64, f64)>,
    /// The values of other symbols: zeros, numbers that the sheet tells without a name, and givens in terms of others.
    pub values: BTreeMap<Symbol, Expr>,
}

/// Formulas in what is given, step by step of a plan.
struct Composer<'a> {
    steps: &'a [Step],
    positive: &'a BTreeSet<Symbol>,
    written: BTreeMap<Symbol, Expr>,
}

impl<'a> Composer<'a> {
    fn new(leaf: &'a Leaf, start: BTreeMap<Symbol, Expr>) -> Self {
        Self { steps: leaf.answer_steps(), positive: &leaf.system.positive, written: start }
    }

    /// A quantity in what is given; `None` where some step on the way has no formula, or one that is given piece by piece.
    fn composed(&mut self, symbol: Symbol, choice: &dyn Fn(usize) -> usize) -> Option<Expr> {
        if let Some(known) = self.written.get(&symbol) {
            return Some(known.clone());
        }
        let found_step = self.steps.iter().enumerate().find(|(_, step)| step.unknowns.contains(&symbol));
        let Some((position, step)) = found_step else { return Some(symbol.into()) };
        let root = step.roots.get(choice(position)).or(step.roots.first())?;
        let (_, closed) = root.values.iter().find(|(root_of, _)| *root_of == symbol)?;
        let Closed::Formula(formula) = closed else { return None };
        let formula = &taught_root(step, symbol, choice(position)).unwrap_or_else(|| formula.clone());
        let mut parts = BTreeMap::new();
        for symbol in formula.symbols() {
            parts.insert(symbol, self.composed(symbol, choice)?);
        }
        let whole = formula.substitute(&|symbol| parts.get(&symbol).cloned());
        let positive = |symbol: Symbol| self.positive.contains(&symbol);
        let whole = under_one_root(whole.simplify_where(&positive), &positive);
        if has_pieces(&whole) {
            return None;
        }
        self.written.insert(symbol, whole.clone());
        Some(whole)
    }
}

/// A root of the quadratic formula as it is taught. The plan computes it piece by piece, lest terms cancel; both are equal.
fn taught_root(step: &Step, symbol: Symbol, choice: usize) -> Option<Expr> {
    step.moves.iter().find_map(|solving_move| match solving_move {
        Move::Quadratic { unknown, a, b, c, .. } if *unknown == symbol && !c.is_zero() => {
            let [plus, minus] = quadratic_formula([a, b, c]);
            Some(if choice == 0 { plus } else { minus })
        }
        _ => None,
    })
}

/// `sqrt(a/b)` for `sqrt(a b)/b`, where every factor is positive and that is shorter.
fn under_one_root(formula: Expr, positive: &dyn Fn(Symbol) -> bool) -> Expr {
    let Expr::Product(factors) = &formula else { return formula };
    let is_root = |factor: &&Expr| matches!(factor, Expr::Power(pair) if pair.1 == Expr::ratio(1, 2));
    let mut outside = factors.iter().filter(|factor| !is_root(factor));
    if factors.iter().filter(is_root).count() != 1 || !outside.all(|factor| is_positive(factor, positive)) {
        return formula;
    }
    let joined = formula.clone().powi(2).simplify_where(positive).sqrt();
    if joined.size() < formula.size() { joined } else { formula }
}

fn is_positive(term: &Expr, positive: &dyn Fn(Symbol) -> bool) -> bool {
    match term {
        Expr::Number(number) => *number > Rational::ZERO,
        Expr::Pi => true,
        Expr::Symbol(symbol) => positive(*symbol),
        Expr::Sum(parts) | Expr::Product(parts) => parts.iter().all(|part| is_positive(part, positive)),
        Expr::Power(pair) => is_positive(&pair.0, positive),
        Expr::Apply(..) | Expr::Piecewise(_) => false,
    }
}

fn has_pieces(formula: &Expr) -> bool {
    matches!(formula, Expr::Piecewise(_)) || formula.children().any(has_pieces)
}

/// Fixed values that are nothing: they leave a formula altogether.
fn zeros(known: &[Known]) -> impl Iterator<Item = (Symbol, Expr)> {
    let zero = |known: &&Known| matches!(&known.origin, Origin::Fixed(value) if value.is_zero());
    known.iter().filter(zero).map(|known| (known.symbol, Expr::zero()))
}

/// A fault for each formula that is asked and cannot be written in what the form tells.
pub(crate) fn check(
    literals: &[(Symbol, momentous_quantity::Quantity)],
    form: &Form,
    name: &dyn Fn(Symbol) -> String,
) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (index, part) in form.parts.iter().enumerate() {
        let PartKind::Formula(formula) = &part.kind else { continue };
        let path = form.question.path.key("ask").index(index);
        if form.question.roots.is_some() {
            let fault = Fault::new(Code::Value, "a formula cannot be asked for together with every root");
            faults.push(fault.help("pick one root with `where`, or ask for numbers").at_path(path));
            continue;
        }
        for leaf in form.solver.leaves() {
            let start = zeros(&form.known).chain(numbers(literals)).collect();
            let composed = Composer::new(leaf, start).composed(formula.symbol, &|_| 0);
            let strange = |symbol: &Symbol| literals.iter().any(|(literal, _)| literal == symbol);
            let fault = match composed {
                None => unwritten(leaf.answer_steps(), formula.symbol, &part.id, name),
                Some(formula) if formula.symbols().iter().any(strange) => {
                    let message = format!("the formula for `{}` contains a value that has no symbol", part.id);
                    Fault::new(Code::Value, message).help("give that value a name under `given`")
                }
                Some(_) => continue,
            };
            faults.push(fault.at_path(path.key("find")));
            break;
        }
    }
    faults
}

/// Why no formula is written for a quantity: the step on the way to it that has none.
fn unwritten(steps: &[Step], asked: Symbol, id: &str, name: &dyn Fn(Symbol) -> String) -> Fault {
    let mut needed = BTreeSet::from([asked]);
    let how = |closed: &Closed| match closed {
        Closed::Formula(_) => None,
        Closed::FirstInteger { .. } => Some("by counting"),
        Closed::BracketedRoot { .. } => Some("in numbers, as the root of an equation"),
    };
    let without = steps.iter().rev().find_map(|step| {
        let values = step.roots.iter().flat_map(|root| &root.values).filter(|(symbol, _)| needed.contains(symbol));
        let values: Vec<_> = values.collect();
        needed.extend(values.iter().flat_map(|(_, closed)| closed.symbols()));
        values.into_iter().find_map(|(symbol, closed)| Some((name(*symbol), how(closed)?)))
    });
    let (why, help) = match without {
        Some((name, how)) => (
            format!("`{name}` is found {how}"),
            format!("ask for a number, or give `{name}` and ask for another quantity"),
        ),
        None => ("it is put together from several pieces".to_owned(), "ask for a number".to_owned()),
    };
    Fault::new(Code::Stuck, format!("the program writes no formula for `{id}`: {why}")).help(help)
}

/// Values without a dimension that an author wrote into a term, and zeros.
fn numbers(literals: &[(Symbol, momentous_quantity::Quantity)]) -> impl Iterator<Item = (Symbol, Expr)> {
    let plain = literals
        .iter()
        .filter(|(_, quantity)| quantity.value.is_zero() || quantity.unit.dimension() == Dimension::NONE);
    plain.map(|(symbol, quantity)| (*symbol, Expr::measured(&quantity.value, &quantity.unit)))
}

impl Worked<'_> {
    /// The letters of this variant's formulas.
    #[must_use]
    pub fn alphabet(&self) -> Alphabet {
        let mut alphabet = Alphabet { letters: Vec::new(), values: zeros(&self.form.known).collect() };
        let literals = &self.problem.model().literals;
        alphabet.values.extend(numbers(literals));
        let needed = self.form.needed();
        for known in &self.form.known {
            let told = self.form.told.contains(&known.symbol) && !alphabet.values.contains_key(&known.symbol);
            let unspoken = known.name == "g" && self.problem.loaded().given.get("g").is_none();
            if !told || unspoken && !needed.contains(&known.symbol) {
                continue;
            }
            if let Some(value) = self.told_as_number(known) {
                alphabet.values.insert(known.symbol, value);
                continue;
            }
            let [low, high] = known.origin.limits().map(|end| end * known.unit.factor().to_f64());
            alphabet.letters.push((known.symbol, low, high));
        }
        for reveal in &self.form.reveal {
            let value = self.variant.value(reveal.symbol).map_or(1.0, |value| value.value);
            alphabet.letters.push((reveal.symbol, value, value));
        }
        for (name, given) in self.problem.loaded().given.iter() {
            let symbol = self.problem.model().symbols.find(name);
            if let (Given::Expression(_), Some(symbol)) = (given, symbol)
                && let Some(value) = self.in_givens(symbol, &alphabet.values)
            {
                alphabet.values.insert(symbol, value);
            }
        }
        alphabet
    }

    /// A pure number that the sheet tells without naming it: it stands in formulas as it is.
    pub(crate) fn told_as_number(&self, known: &Known) -> Option<Expr> {
        let pure = self.problem.model().symbols.entry(known.symbol).dimension == Dimension::NONE;
        let names = [&self.problem.loaded().draft.text, &self.form.question.text].into_iter().any(|text| {
            let is_its_name = |name: &str| self.problem.model().symbol_of(name) == Some(known.symbol);
            text.placeholders().any(|placeholder| placeholder.filter.names() && is_its_name(&placeholder.name))
        });
        let (value, unit) = self.variant.given(known.symbol).filter(|_| pure && !names)?;
        Some(Expr::measured(&value, &unit))
    }

    /// The answer to a part as a formula; a multiple of the quantity in terms of which it is asked.
    #[must_use]
    pub fn formula(&self, part: &FormulaPart) -> Option<Expr> {
        let values = self.alphabet().values;
        let whole = self.in_givens(part.symbol, &values)?;
        let Some(unit) = part.in_terms_of else { return Some(whole) };
        let factor = (whole / self.in_givens(unit, &values)?).simplify_where(&|symbol| self.is_positive(symbol));
        Some((factor * Expr::from(unit)).simplify_where(&|symbol| self.is_positive(symbol)))
    }

    /// The fixed values that are nothing.
    pub fn zeros(&self) -> impl Iterator<Item = Symbol> {
        zeros(&self.form.known).map(|(symbol, _)| symbol)
    }

    /// Whether a quantity is positive in every variant that goes this way.
    #[must_use]
    pub fn is_positive(&self, symbol: Symbol) -> bool {
        self.leaf().system.positive.contains(&symbol)
    }

    /// A quantity in the letters of what is given, `values` put in.
    #[must_use]
    pub fn in_givens(&self, symbol: Symbol, values: &BTreeMap<Symbol, Expr>) -> Option<Expr> {
        let general = self.general(symbol)?;
        if !general.symbols().iter().any(|symbol| values.contains_key(symbol)) {
            return Some(general);
        }
        let special = general.substitute(&|symbol| values.get(&symbol).cloned());
        Some(special.simplify_where(&|symbol| self.is_positive(symbol)))
    }

    /// A quantity in what is given by way of another plan, for each of its roots.
    pub(crate) fn every_formula(&self, plan: &Plan, symbol: Symbol) -> Vec<Expr> {
        let roots = plan.steps.iter().map(|step| step.roots.len()).max().unwrap_or(0);
        let values = self.alphabet().values;
        let composed = |root: usize| {
            let positive = &self.leaf().system.positive;
            Composer { steps: &plan.steps, positive, written: values.clone() }.composed(symbol, &|_| root)
        };
        (0..roots).filter_map(composed).collect()
    }

    /// Whether two terms are proven equal in every variant that goes this way: both written in what is given, step by step of the plan
    /// and of what only judging needs.
    #[must_use]
    pub fn are_equal(&self, left: &Expr, right: &Expr) -> bool {
        let (leaf, roots) = (self.leaf(), self.variant.roots());
        let start = zeros(&self.form.known).chain(numbers(&self.problem.model().literals)).collect();
        let steps = &leaf.audit.plan.steps;
        let mut composer = Composer { steps, positive: &leaf.system.positive, written: start };
        let choice = |position: usize| roots.get(position).copied().unwrap_or(0);
        let mut written = |term: &Expr| {
            let mut parts = BTreeMap::new();
            for symbol in term.symbols() {
                parts.insert(symbol, composer.composed(symbol, &choice)?);
            }
            Some(term.substitute(&|symbol| parts.get(&symbol).cloned()))
        };
        match (written(left), written(right)) {
            (Some(left), Some(right)) => equal_where(&left, &right, &|symbol| self.is_positive(symbol)),
            _ => false,
        }
    }

    /// A quantity in what every variant that goes this way is told; composed once.
    fn general(&self, symbol: Symbol) -> Option<Expr> {
        let roots = self.variant.roots();
        let key = (self.variant.leaf(), roots.to_vec(), symbol);
        let formulas = &self.form.formulas.0;
        if let Some(known) = formulas.read().ok().and_then(|known| known.get(&key).cloned()) {
            return known;
        }
        let start = zeros(&self.form.known).chain(numbers(&self.problem.model().literals)).collect();
        let choice = |position: usize| roots.get(position).copied().unwrap_or(0);
        let composed = Composer::new(self.leaf(), start).composed(symbol, &choice);
        if let Ok(mut known) = formulas.write() {
            known.insert(key, composed.clone());
        }
        composed
    }
}
