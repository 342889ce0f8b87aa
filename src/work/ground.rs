//! The ground on which lines are judged: one way in which the scene of a form goes, with values of its quantities in several variants. It
//! is worked out once for a form and serves every line.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::RwLock;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Instance;
use momentous_model::QuantityKind;
use momentous_problem::FormCache;
use momentous_problem::Given;
use momentous_problem::Sampler;
use momentous_problem::Worked;
use momentous_quantity::Dimension;
use momentous_solve::Bounded;
use momentous_solve::Statement;
use momentous_solve::System;

use super::naming::is_naming;
use super::way::{Values, Way};

/// The variants at which a line is tried, beside the student's own.
const VARIANTS: usize = 6;
/// The seeds that are tried to find them.
const SEEDS: u64 = 80;
/// The sets of values that are tried for quantities that may be anything.
const TRIES: u64 = 60;

/// An equation of the scene.
#[derive(Clone, Debug)]
pub(crate) struct StatedEquation {
    /// Its position in the system.
    pub(crate) place: usize,
    /// Left side minus right side.
    pub(crate) residual: Expr,
    /// The law, as it is used: a position in the model's instances.
    pub(crate) tag: usize,
    /// Whether the answers are found by it.
    pub(crate) is_used: bool,
    /// Whether it only gives a name to something, so that it is no step.
    pub(crate) is_naming: bool,
}

/// One way in which the scene of a form goes.
#[derive(Debug)]
pub(crate) struct Ground {
    /// Its equations.
    pub(crate) system: System,
    /// The symbols that the sheet tells.
    pub(crate) told: BTreeSet<Symbol>,
    /// The symbols that have a value before any line is read.
    base: BTreeSet<Symbol>,
    /// The values of the base in other variants.
    variants: Vec<Values>,
    /// The equations that compare two sides.
    pub(crate) equations: Vec<StatedEquation>,
    /// The ways to quantities that no answer needs, as far as a line has asked for them.
    ways: RwLock<BTreeMap<Symbol, Option<Arc<Way>>>>,
    /// The systems with a mistake in them.
    pub(crate) wrong: FormCache,
}

/// The grounds of a form, one for each way in which its scene goes.
#[derive(Debug, Default)]
struct Grounds(RwLock<BTreeMap<usize, Arc<Ground>>>);

/// A variant on its ground: where the values of quantities are looked up.
#[derive(Clone, Copy)]
pub(crate) struct Place<'a> {
    ground: &'a Ground,
    base: &'a Values,
}

impl Ground {
    /// The ground of a variant.
    pub(crate) fn of(worked: Worked<'_>) -> Arc<Self> {
        let grounds = worked.form.work.get(Grounds::default);
        let leaf = worked.variant.leaf();
        if let Some(known) = grounds.0.read().ok().and_then(|known| known.get(&leaf).cloned()) {
            return known;
        }
        let ground = Arc::new(Self::new(worked));
        if let Ok(mut known) = grounds.0.write() {
            known.insert(leaf, Arc::clone(&ground));
        }
        ground
    }

    fn new(worked: Worked<'_>) -> Self {
        let leaf = worked.leaf();
        let used: BTreeSet<usize> =
            leaf.answer_steps().iter().flat_map(|step| step.equations.iter().copied()).collect();
        let told = worked.form.told.clone();
        let solved = leaf.audit.plan.steps.iter().flat_map(|step| step.unknowns.iter().copied());
        // What may be anything has no value that is solved from.
        let is_valued = worked.form.free.is_empty() && !told.iter().any(|symbol| is_any(worked, *symbol));
        let mut base: BTreeSet<Symbol> =
            if is_valued { told.iter().copied().chain(solved).collect() } else { told.clone() };
        // A mass that nothing tells may be any: it drops out of whatever is true.
        let model = worked.problem.model();
        let masses = model
            .symbols
            .iter()
            .map(|(symbol, _)| symbol)
            .filter(|symbol| model.name(*symbol).kind == QuantityKind::Mass);
        let is_open = |symbol: &Symbol| !base.contains(symbol) && Way::new(&leaf.system, &base, &[*symbol]).is_none();
        let open: Vec<Symbol> = masses.filter(is_open).collect();
        base.extend(open);
        let instances = &worked.problem.model().instances;
        let equations = leaf.system.equations.iter().enumerate().filter_map(|(place, equation)| {
            let Statement::Equal { left, right } = &equation.statement else { return None };
            let law = instances.get(equation.tag).map(|instance: &Instance| instance.law);
            Some(StatedEquation {
                place,
                residual: Expr::sum([left.clone(), -right.clone()]),
                tag: equation.tag,
                is_used: used.contains(&place),
                is_naming: law.is_some_and(is_naming),
            })
        });
        let mut ground = Self {
            system: leaf.system.clone(),
            told,
            base,
            variants: Vec::new(),
            equations: equations.collect(),
            ways: RwLock::default(),
            wrong: FormCache::default(),
        };
        ground.variants = ground.drawn(worked);
        ground
    }

    /// Values in other variants of the same way.
    fn drawn(&self, worked: Worked<'_>) -> Vec<Values> {
        let mut variants: Vec<Values> = Vec::new();
        let Ok(mut sampler) = Sampler::new(worked.problem, worked.variant.form()) else { return variants };
        for seed in 1..SEEDS {
            let Ok(variant) = sampler.variant(seed) else { continue };
            if variant.leaf() != worked.variant.leaf() {
                continue;
            }
            let Some(other) = Worked::new(worked.problem, &variant) else { continue };
            let values = self.values(other, seed);
            if !variants.contains(&values) {
                variants.push(values);
            }
            if variants.len() == VARIANTS {
                break;
            }
        }
        variants
    }

    /// The values of the base in a variant.
    pub(crate) fn values(&self, worked: Worked<'_>, seed: u64) -> Values {
        let known = self.base.iter().filter(|symbol| !is_any(worked, **symbol));
        let known = known.filter_map(|symbol| Some((*symbol, worked.variant.value(*symbol)?)));
        let known: Values = known.collect();
        let missing: Vec<Symbol> = self.base.iter().copied().filter(|symbol| !known.contains_key(symbol)).collect();
        if missing.is_empty() {
            return known;
        }
        let wanted: Vec<Symbol> = worked.form.wanted().collect();
        let mut last = known.clone();
        for attempt in 0..TRIES {
            let mut values = known.clone();
            for (place, symbol) in missing.iter().enumerate() {
                let dimension = worked.problem.model().symbols.entry(*symbol).dimension;
                values.insert(*symbol, anything(dimension, seed * TRIES + attempt, place));
            }
            let place = Place { ground: self, base: &values };
            let is_possible = wanted.iter().all(|symbol| place.value(*symbol).is_some());
            last = values;
            if is_possible {
                break;
            }
        }
        last
    }

    /// What the sheet gives by its letter only, and values in which each of these is one; none where there is none.
    pub(crate) fn letters_as_one(&self, worked: Worked<'_>) -> Option<(Vec<Symbol>, Values)> {
        let letters: Vec<Symbol> = self.told.iter().copied().filter(|symbol| is_any(worked, *symbol)).collect();
        let values = || self.base.iter().filter_map(|symbol| Some((*symbol, worked.variant.value(*symbol)?))).collect();
        (!letters.is_empty()).then(|| (letters, values()))
    }

    /// The other variants.
    pub(crate) fn places(&self) -> impl Iterator<Item = Place<'_>> {
        self.variants.iter().map(|base| Place { ground: self, base })
    }

    /// A place on the ground.
    pub(crate) fn place<'a>(&'a self, base: &'a Values) -> Place<'a> {
        Place { ground: self, base }
    }

    fn way(&self, symbol: Symbol) -> Option<Arc<Way>> {
        if let Some(known) = self.ways.read().ok().and_then(|known| known.get(&symbol).cloned()) {
            return known;
        }
        let way = Way::new(&self.system, &self.base, &[symbol]).map(Arc::new);
        if let Ok(mut known) = self.ways.write() {
            known.insert(symbol, way.clone());
        }
        way
    }

    /// The quantities in the equations that give the answers.
    pub(crate) fn used_symbols(&self) -> BTreeSet<Symbol> {
        self.equations.iter().filter(|stated| stated.is_used).flat_map(|stated| stated.residual.symbols()).collect()
    }

    /// The quantities that the used equations give.
    pub(crate) fn sought(&self) -> BTreeSet<Symbol> {
        self.used_symbols().difference(&self.told).copied().collect()
    }

    /// The positions of the used equations in the system.
    pub(crate) fn used(&self) -> BTreeSet<usize> {
        self.equations.iter().filter(|stated| stated.is_used).map(|stated| stated.place).collect()
    }
}

impl Place<'_> {
    /// The value of a quantity in SI units; none where it does not follow from what is given.
    pub(crate) fn value(&self, symbol: Symbol) -> Option<Bounded> {
        if let Some(value) = self.base.get(&symbol) {
            return Some(*value);
        }
        let solutions = self.ground.way(symbol)?.solve(&|symbol| self.base.get(&symbol).copied());
        solutions.first()?.get(&symbol).copied()
    }
}

/// Whether the sheet gives a quantity by its letter only: a number for it says nothing.
fn is_any(worked: Worked<'_>, symbol: Symbol) -> bool {
    let name = &worked.problem.model().symbols.entry(symbol).name;
    matches!(worked.problem.loaded().given.get(name), Some(Given::Any(_)))
}

/// A value for what may be anything: a pure number below one, anything else between one half and three.
fn anything(dimension: Dimension, seed: u64, place: usize) -> Bounded {
    let mut mixed = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ (place as u64 + 1).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    mixed = (mixed ^ (mixed >> 29)).wrapping_mul(0x94D0_49BB_1331_11EB);
    #[allow(clippy::cast_precision_loss, reason = "20 bits fit")]
    let share = ((mixed >> 40) & 0xF_FFFF) as f64 / f64::from(1 << 20);
    let value = if dimension == Dimension::NONE { 0.2 + 0.7 * share } else { 0.5 + 2.5 * share };
    Bounded::exactly(value)
}
