//! A difference of two terms, written in as few independent quantities as the equations of a scene allow.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Builder;
use momentous_model::Instant;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_solve::Closed;
use momentous_solve::Equation;
use momentous_solve::Plan;
use momentous_solve::Planner;
use momentous_solve::Reason;
use momentous_solve::Statement;
use momentous_solve::System;

use super::super::super::language::given::Given;
use super::super::super::reading::load::Loaded;
use super::data::is_exact;

/// At most so many terms are tried that an equation makes of a difference.
const MOST_TRIED: usize = 3;

/// At most so many quantities are taken as independent before the attempt is given up.
const MOST_FREE: usize = 12;

/// A difference as a term in independent quantities: by the equations of a stage alone, in what its bodies bring along; or by all
/// equations, in what is given. `None` where the equations do not lead there in one way.
pub(super) fn difference(loaded: &Loaded, builder: &Builder<'_>, stage: Option<usize>, whole: &Expr) -> Option<Expr> {
    let fixed = fixed(loaded, builder);
    let put = |term: &Expr| term.substitute(&|symbol| fixed.get(&symbol).cloned());
    let system = local(builder, stage, &put);
    let positive = |symbol: Symbol| builder.is_positive(symbol);
    let whole = put(whole).simplify_where(&positive);
    if whole.is_zero() || is_equation(&system, &whole, &positive) {
        return Some(Expr::zero());
    }
    let mut all: BTreeSet<Symbol> = system.equations.iter().flat_map(Equation::symbols).collect();
    all.extend(whole.symbols());
    let known: BTreeSet<Symbol> = match stage {
        Some(stage) => all.iter().copied().filter(|symbol| is_brought(loaded, builder, *symbol, stage, &all)).collect(),
        None => all.iter().copied().filter(|symbol| is_given(loaded, builder, *symbol)).collect(),
    };
    let reductions = reductions(&system, &whole, &known, &positive);
    reductions.iter().find_map(|whole| planned(&system, known.clone(), whole, &positive))
}

/// The difference itself, and what an equation of the stage makes of it: a loss that is told stands in place of the energies.
fn reductions(system: &System, whole: &Expr, known: &BTreeSet<Symbol>, positive: &dyn Fn(Symbol) -> bool) -> Vec<Expr> {
    let unknown = |term: &Expr| term.symbols().into_iter().filter(|symbol| !known.contains(symbol)).count();
    // An equation for each unit of mass is multiplied by the mass.
    let halves = whole.symbols().into_iter().filter(|symbol| positive(*symbol));
    let factors: Vec<Expr> = halves.map(|symbol| Expr::from(symbol) / Expr::integer(2)).chain([Expr::one()]).collect();
    let mut shorter: Vec<(usize, Expr)> = Vec::new();
    for (left, right) in sides(system).filter(|(left, right)| unknown(left) + unknown(right) > 0) {
        for factor in &factors {
            let gap = factor.clone() * (left.clone() - right.clone());
            let both = [whole.clone() - gap.clone(), whole.clone() + gap];
            let reduced = both.into_iter().map(|term| term.simplify_where(positive));
            shorter.extend(reduced.map(|term| (unknown(&term), term)));
        }
    }
    shorter.sort_by_key(|(count, term)| (*count, term.size()));
    let open = unknown(whole);
    let with = |wanted: &dyn Fn(usize) -> bool| {
        let some = shorter.iter().filter(|(count, _)| wanted(*count)).map(|(_, term)| term.clone());
        some.take(MOST_TRIED).collect::<Vec<_>>()
    };
    [with(&|count| count < open), vec![whole.clone()], with(&|count| count == open)].concat()
}

/// Solves for what is not known, and puts it in; what does not follow is taken as independent.
fn planned(
    system: &System,
    mut known: BTreeSet<Symbol>,
    whole: &Expr,
    positive: &dyn Fn(Symbol) -> bool,
) -> Option<Expr> {
    let mut planner = Planner::default();
    for _ in 0..MOST_FREE {
        let wanted: Vec<Symbol> = whole.symbols().into_iter().filter(|symbol| !known.contains(symbol)).collect();
        match planner.plan(system, &known, &wanted) {
            Ok(plan) => return Some(composed(&plan, whole)?.simplify_where(positive)),
            Err(stuck) => match stuck.reason {
                Reason::Underdetermined { wanted, .. } => known.insert(*wanted.last()?),
                Reason::NoTactic { .. } | Reason::Contradiction { .. } => return None,
            },
        };
    }
    None
}

/// A term with the steps of a plan put in, from the last to the first.
fn composed(plan: &Plan, whole: &Expr) -> Option<Expr> {
    let mut term = whole.clone();
    for step in plan.steps.iter().rev() {
        if !step.unknowns.iter().any(|unknown| term.contains(*unknown)) {
            continue;
        }
        let [root] = &step.roots[..] else { return None };
        for (unknown, closed) in root.values.iter().rev() {
            let Closed::Formula(formula) = closed else { return None };
            term = term.substitute(&|symbol| (symbol == *unknown).then(|| formula.clone()));
        }
    }
    Some(term)
}

/// Whether an equation states that the difference is zero.
fn is_equation(system: &System, whole: &Expr, positive: &dyn Fn(Symbol) -> bool) -> bool {
    let holds = |(left, right): (&Expr, &Expr)| {
        let gap = left.clone() - right.clone();
        [whole.clone() - gap.clone(), whole.clone() + gap].iter().any(|rest| rest.simplify_where(positive).is_zero())
    };
    let symbols = whole.symbols();
    let mut alike = sides(system).filter(|(left, right)| {
        left.symbols().union(&right.symbols()).copied().collect::<BTreeSet<Symbol>>() == symbols
    });
    alike.any(holds)
}

fn sides(system: &System) -> impl Iterator<Item = (&Expr, &Expr)> {
    system.equations.iter().filter_map(|equation| match &equation.statement {
        Statement::Equal { left, right } => Some((left, right)),
        Statement::FirstInteger { .. } => None,
    })
}

/// The equations of a stage and those that hold at an instant; all of them where no stage is named.
fn local(builder: &Builder<'_>, stage: Option<usize>, put: &dyn Fn(&Expr) -> Expr) -> System {
    let belongs = |equation: &&Equation| match (stage, builder.stage_of_law(equation.tag)) {
        (None, _) => true,
        (exactly, stage_of_law) => stage_of_law == exactly,
    };
    let equations = builder.system().equations.iter().filter(belongs).map(|equation| match &equation.statement {
        Statement::Equal { left, right } => {
            let statement = Statement::Equal { left: put(left), right: put(right) };
            Equation { statement, ..equation.clone() }
        }
        Statement::FirstInteger { .. } => equation.clone(),
    });
    let system = builder.system();
    System { equations: equations.collect(), positive: system.positive.clone(), ..System::default() }
}

/// Values that are exact and the same in every variant: zeros, and what an equation alone says of a single quantity.
pub(super) fn fixed(loaded: &Loaded, builder: &Builder<'_>) -> BTreeMap<Symbol, Expr> {
    let mut fixed = BTreeMap::new();
    for (symbol, entry) in builder.symbols().iter() {
        if let Some(Given::Literal(literal)) = loaded.given.get(&entry.name)
            && let [only] = &literal.components[..]
            && is_exact(only, &literal.unit)
        {
            fixed.insert(symbol, Expr::measured(only, &literal.unit));
        }
    }
    for (name, given) in loaded.given.iter() {
        let Given::Literal(literal) = given else { continue };
        for (value, axis) in literal.components.iter().zip(["x", "y", "z"]).filter(|_| literal.components.len() > 1) {
            let symbol = builder.symbols().find(&format!("{name}.{axis}")).filter(|_| value.is_zero());
            fixed.extend(symbol.map(|symbol| (symbol, Expr::zero())));
        }
    }
    for (symbol, quantity) in builder.literals() {
        if is_exact(&quantity.value, &quantity.unit) {
            fixed.insert(*symbol, Expr::measured(&quantity.value, &quantity.unit));
        }
    }
    for (left, right) in sides(builder.system()) {
        let symbols: Vec<Symbol> = left.symbols().union(&right.symbols()).copied().collect();
        if let [only] = symbols[..]
            && let Some((parts, _)) = (left.clone() - right.clone()).collect(only)
            && let [rest, slope] = &parts[..]
        {
            fixed.insert(only, (-rest.clone() / slope.clone()).simplify());
        }
    }
    fixed
}

/// Whether a quantity is one with which a stage begins, or a property of what takes part: all but what the stage makes.
fn is_brought(loaded: &Loaded, builder: &Builder<'_>, symbol: Symbol, stage: usize, all: &BTreeSet<Symbol>) -> bool {
    let name = builder.name(symbol);
    match (&name.kind, &name.instant) {
        (QuantityKind::Value(_), _) => true,
        (QuantityKind::AngleBetween(_) | QuantityKind::Magnitude(_), _) => is_given(loaded, builder, symbol),
        (kind, Some(Instant::Number(at))) => {
            // Along a line of impact the components n and t stand in place of x and y.
            let along = |letter: &str| Name { stage: None, ..name.clone() }.along(letter);
            let is_normal = |symbol: &Symbol| Name { stage: None, ..builder.name(*symbol).clone() } == along("n");
            let is_turned = matches!(name.component.as_deref(), Some("x" | "y")) && all.iter().any(is_normal);
            let is_state = match kind {
                QuantityKind::Velocity | QuantityKind::Position | QuantityKind::AngularVelocity => true,
                QuantityKind::AngularMomentum => !has_parts(builder, symbol),
                _ => false,
            };
            *at <= stage + 1 && is_state && !is_turned
        }
        _ => builder.is_positive(symbol) || is_given(loaded, builder, symbol),
    }
}

/// Whether an angular momentum is made of quantities that are known by themselves.
fn has_parts(builder: &Builder<'_>, symbol: Symbol) -> bool {
    let defines = |(left, right): (&Expr, &Expr)| *left == Expr::from(symbol) && right.symbols().len() > 1;
    sides(builder.system()).any(defines)
}

fn is_given(loaded: &Loaded, builder: &Builder<'_>, symbol: Symbol) -> bool {
    let name = &builder.symbols().entry(symbol).name;
    let has_value = |name: &str| loaded.given.get(name).is_some_and(|given| !given.is_derived());
    builder.is_literal(symbol)
        || name == "g"
        || has_value(name)
        || name.split_once('.').is_some_and(|(whole, _)| has_value(whole))
}
