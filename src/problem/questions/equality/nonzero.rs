//! Whether a term differs from zero for every admissible value of what it contains.

use std::collections::BTreeMap;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Builder;
use momentous_quantity::Decimal;
use momentous_quantity::Rational;
use momentous_quantity::Unit;
use momentous_solve::Bounded;
use momentous_solve::Condition;
use momentous_solve::Real;
use momentous_solve::Relation;
use momentous_solve::Sign;
use momentous_solve::evaluate;

use super::super::super::language::domain::Domain;
use super::super::super::language::given::Given;
use super::super::super::reading::load::Loaded;
use super::data::half_of_last_place;
use super::difference::fixed;

/// The ranges of quantities before any value is drawn.
pub(super) struct Ranges<'b, 's> {
    builder: &'b Builder<'s>,
    /// From where to where, with twice the precision of the data on either side.
    values: BTreeMap<Symbol, Bounded>,
    conditions: Vec<Condition>,
}

impl<'b, 's> Ranges<'b, 's> {
    pub(super) fn new(loaded: &Loaded, builder: &'b Builder<'s>) -> Self {
        let figures = loaded.draft.significant_figures();
        let mut values = BTreeMap::new();
        for (symbol, entry) in builder.symbols().iter() {
            let bounds = match loaded.given.get(&entry.name) {
                Some(Given::Drawn { domain, unit }) => between(&ends(domain), unit, &entry.name, figures),
                Some(Given::Literal(literal)) => between(&literal.components, &literal.unit, &entry.name, figures),
                _ => continue,
            };
            values.extend(bounds.map(|bounds| (symbol, bounds)));
        }
        for (symbol, quantity) in builder.literals() {
            let bounds = between(std::slice::from_ref(&quantity.value), &quantity.unit, "", figures);
            values.extend(bounds.map(|bounds| (*symbol, bounds)));
        }
        for (symbol, bounds) in limits(&builder.system().conditions) {
            values.entry(symbol).or_insert(bounds);
        }
        let fixed = fixed(loaded, builder);
        let put = |term: &Expr| term.substitute(&|symbol| fixed.get(&symbol).cloned());
        let conditions = builder.system().conditions.iter();
        let conditions = conditions
            .map(|condition| Condition {
                left: put(&condition.left),
                right: put(&condition.right),
                ..condition.clone()
            })
            .collect();
        Self { builder, values, conditions }
    }

    /// The factors of a term of which it is not known that they differ from zero; as functions of a clock they need to do so at some
    /// time only.
    pub(super) fn undecided(&self, term: &Expr, clock: Option<Symbol>) -> Vec<Expr> {
        let differs = |factor: &Expr| match clock.filter(|clock| factor.contains(*clock)) {
            Some(clock) => factor.collect(clock).is_some_and(|(parts, _)| parts.iter().any(|part| self.differs(part))),
            None => self.differs(factor),
        };
        factors(term).into_iter().filter(|factor| !differs(factor)).collect()
    }

    /// Whether a term differs from zero, as far as that is seen.
    fn differs(&self, term: &Expr) -> bool {
        match term {
            Expr::Product(factors) => factors.iter().all(|factor| self.differs(factor)),
            Expr::Power(pair) => self.differs(&pair.0),
            Expr::Number(number) => *number != Rational::ZERO,
            _ => self.is_positive(term) || self.is_apart(term) || self.is_compared(term),
        }
    }

    fn is_positive(&self, term: &Expr) -> bool {
        match term {
            Expr::Number(number) => *number > Rational::ZERO,
            Expr::Pi => true,
            Expr::Symbol(symbol) => self.builder.is_positive(*symbol),
            Expr::Sum(parts) | Expr::Product(parts) => parts.iter().all(|part| self.is_positive(part)),
            Expr::Power(pair) => self.is_positive(&pair.0),
            Expr::Apply(..) | Expr::Piecewise(_) => false,
        }
    }

    /// Whether the ranges of what a term contains keep it away from zero.
    fn is_apart(&self, term: &Expr) -> bool {
        let has_values = term.all_symbols(&|symbol| self.values.contains_key(&symbol));
        let value = |symbol: Symbol| self.values.get(&symbol).copied().unwrap_or_else(Bounded::not_real);
        has_values && matches!(evaluate(term, &value).sign(), Sign::Positive | Sign::Negative)
    }

    /// Whether a condition of every solution says so: a body that catches up with another is faster.
    fn is_compared(&self, term: &Expr) -> bool {
        let strict = |condition: &&Condition| {
            matches!(condition.relation, Relation::Less | Relation::Greater | Relation::Differs)
        };
        let says = |condition: &Condition| {
            let gap = condition.left.clone() - condition.right.clone();
            let ratio = (term.clone() / gap).simplify_where(&|symbol| self.builder.is_positive(symbol));
            !ratio.is_zero()
                && factors(&ratio).iter().all(|factor| match factor {
                    Expr::Number(number) => *number != Rational::ZERO,
                    other => self.is_positive(other),
                })
        };
        self.conditions.iter().filter(strict).any(says)
    }
}

/// The factors of a term above and below its bar, each once.
fn factors(term: &Expr) -> Vec<Expr> {
    match term {
        Expr::Product(parts) => parts.iter().flat_map(factors).collect(),
        Expr::Power(pair) if pair.1.as_number().is_some() => factors(&pair.0),
        other => vec![other.clone()],
    }
}

fn ends(domain: &Domain) -> Vec<Decimal> {
    match domain {
        Domain::Grid(grid) => vec![grid.low(), grid.high()],
        Domain::Choice(values) => values.clone(),
    }
}

fn between(values: &[Decimal], unit: &Unit, name: &str, figures: usize) -> Option<Bounded> {
    let factor = unit.factor().to_f64();
    let reach = |value: &Decimal| 2.0 * half_of_last_place(value, unit, name, figures);
    let low = values.iter().map(|decimal| decimal.to_f64() * factor - reach(decimal)).fold(f64::INFINITY, f64::min);
    let high =
        values.iter().map(|decimal| decimal.to_f64() * factor + reach(decimal)).fold(f64::NEG_INFINITY, f64::max);
    bounded(low, high)
}

fn bounded(low: f64, high: f64) -> Option<Bounded> {
    let value = f64::midpoint(low, high);
    let error = (high - value).max(value - low) * (1.0 + f64::EPSILON);
    value.is_finite().then_some(Bounded { value, error })
}

/// The quantities that conditions bound by two numbers: a coefficient of restitution lies between 0 and 1.
fn limits(conditions: &[Condition]) -> Vec<(Symbol, Bounded)> {
    let mut ranges: BTreeMap<Symbol, [Option<f64>; 2]> = BTreeMap::new();
    for condition in conditions {
        let (Expr::Symbol(symbol), Some(bound)) = (&condition.left, condition.right.as_number()) else { continue };
        let bound = bound.to_f64().value();
        let bounds = ranges.entry(*symbol).or_default();
        match condition.relation {
            Relation::AtLeast | Relation::Greater => bounds[0] = Some(bound),
            Relation::AtMost | Relation::Less => bounds[1] = Some(bound),
            Relation::Differs | Relation::Equals => {}
        }
    }
    let both = |(symbol, [low, high]): (Symbol, [Option<f64>; 2])| Some((symbol, bounded(low?, high?)?));
    ranges.into_iter().filter_map(both).collect()
}
