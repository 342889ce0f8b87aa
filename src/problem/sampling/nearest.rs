//! The nearest numbers that have a solution, where those of the author have none: an angle beyond which nothing is turned, a height that
//! is not reached.

use momentous_expr::Symbol;
use momentous_model::QuantityKind;
use momentous_quantity::Decimal;
use momentous_quantity::Unit;
use momentous_quantity::first_place;
use momentous_quantity::round_to_figures;
use momentous_quantity::unit_of_place;

use super::super::language::known::Origin;
use super::no_variant::NoVariant;
use super::sampler::Sampler;

/// A value is tried at these shares of itself, one after the other, up and down.
const STEP: f64 = 1.04;
const STEPS: i32 = 60;

/// Halvings until a boundary is known.
const HALVINGS: u32 = 40;

/// Figures with which a boundary is written.
const FIGURES: core::ops::RangeInclusive<usize> = 2..=6;

/// The most ways that are named.
const MOST: usize = 3;

/// A given that has to change.
struct Change {
    name: String,
    value: Decimal,
    unit: Unit,
    /// Whether every smaller value nearby would do, rather than every greater one.
    is_most: bool,
    /// How far it is from the author's value, as a logarithm.
    way: f64,
}

impl Sampler<'_> {
    /// The values of single givens from which on there is a solution, the nearest first: `angle_A2: 60 deg` or less.
    pub(crate) fn nearest_solutions(&mut self) -> Option<String> {
        let model = self.problem.model();
        let is_ours = |symbol: Symbol| model.name(symbol).kind != QuantityKind::Gravity;
        let fixed: Vec<(String, Symbol, Decimal, Unit)> = (self.form.known.iter())
            .filter(|known| is_ours(known.symbol))
            .filter_map(|known| match &known.origin {
                Origin::Fixed(value) if !value.is_zero() => {
                    Some((known.name.clone(), known.symbol, value.clone(), known.unit.clone()))
                }
                Origin::Fixed(_) | Origin::Drawn(_) | Origin::Any => None,
            })
            .collect();
        let mut changes: Vec<Change> = fixed
            .iter()
            .flat_map(|given| [1.0 / STEP, STEP].map(|step| self.boundary(given, step)))
            .flatten()
            .collect();
        changes.sort_by(|one, other| one.way.total_cmp(&other.way));
        let said: Vec<String> = changes.iter().take(MOST).map(Change::in_words).collect();
        (!said.is_empty()).then(|| said.join(", or "))
    }

    /// The value nearest to a given one, in one sense, from which on there is a solution.
    fn boundary(&mut self, (name, symbol, value, unit): &(String, Symbol, Decimal, Unit), step: f64) -> Option<Change> {
        let start = value.to_f64();
        // Of several solutions the author chooses one.
        let mut solves = |value: &Decimal| {
            let solved = self.with_values(0, &[(*symbol, value.clone(), unit.clone())]);
            matches!(solved, Ok(_) | Err(NoVariant::Solutions { count: 2.., .. }))
        };
        let mut solves_at = |value: f64| round_to_figures(value, 15).is_some_and(|value| solves(&value));
        let at = |steps: i32| start * libm::pow(step, f64::from(steps));
        let first = (1..=STEPS).find(|steps| solves_at(at(*steps)))?;
        let (mut without, mut with) = (at(first - 1), at(first));
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(without, with);
            *(if solves_at(middle) { &mut with } else { &mut without }) = middle;
        }
        let onward = (with - without).signum();
        let written = FIGURES.into_iter().find_map(|figures| {
            let last = unit_of_place(first_place(with) + 1 - i32::try_from(figures).ok()?);
            let near = [with, with + onward * last].map(|value| round_to_figures(value, figures));
            near.into_iter().flatten().find(|value| solves(value))
        })?;
        Some(Change {
            name: name.clone(),
            value: written,
            unit: unit.clone(),
            is_most: onward < 0.0,
            way: libm::log(with / start).abs(),
        })
    }
}

impl Change {
    fn in_words(&self) -> String {
        let value = format!("{} {}", self.value, self.unit);
        let side = if self.is_most { "or less" } else { "or more" };
        format!("`{}: {}` {side}", self.name, value.trim_end())
    }
}
