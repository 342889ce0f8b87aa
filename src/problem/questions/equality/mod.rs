//! Whether two terms of a problem are equal: by the equations of a scene, or by the numbers of a variant.

mod data;
mod difference;
mod nonzero;

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::equal;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_model::Builder;

use super::super::language::given::Given;
use super::super::reading::load::Loaded;
use super::to_solve::to_solve;

pub(crate) use data::half_of_last_place;

use difference::difference;
use nonzero::Ranges;

/// Whether two terms are equal.
#[derive(Clone, Debug)]
pub enum Equality {
    /// In every variant.
    Always,
    /// In no variant.
    Never,
    /// Decided by the numbers of a variant.
    InNumbers(Sides),
}

/// Two terms that are compared variant by variant.
#[derive(Clone, Debug)]
pub struct Sides {
    /// The terms.
    pub terms: [Expr; 2],
    /// The quantities among them that have to be solved.
    pub quantities: Vec<Symbol>,
    /// The clock of a stage, and the moments at which terms in it are compared.
    pub clock: Option<(Symbol, Vec<Expr>)>,
}

/// The span for which equality is asked: its stage, and what runs from its start to its end.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    pub stage: usize,
    /// The clock of the stage, in which terms are equal only if they are at all times.
    pub clock: Option<Symbol>,
}

impl Equality {
    /// Decides what can be decided for every variant: first by the equations of the stage alone, whatever else is told, then by all
    /// equations and the values that are given.
    pub(crate) fn of(loaded: &Loaded, builder: &Builder<'_>, place: Place, [left, right]: [Expr; 2]) -> Self {
        let whole = left.clone() - right.clone();
        let positive = |symbol: Symbol| builder.is_positive(symbol);
        if left == right || equal(&left, &right) || whole.simplify_where(&positive).is_zero() {
            return Self::Always;
        }
        let ranges = Ranges::new(loaded, builder);
        let mut open = None;
        for stage in [Some(place.stage), None] {
            let Some(reduced) = difference(loaded, builder, stage, &whole) else { continue };
            if reduced.is_zero() {
                return Self::Always;
            }
            let mut undecided = ranges.undecided(&reduced, place.clock);
            let is_of_stage =
                stage.is_some() || reduced.symbols().iter().any(|symbol| is_drawn(loaded, builder, *symbol));
            match (undecided.pop(), undecided.is_empty()) {
                // Fixed numbers alone decide nothing for every value.
                (None, _) if is_of_stage => return Self::Never,
                // A single factor of what is given, such as 1 - e^2, needs nothing to be solved.
                (Some(only), true) if stage.is_some() && is_told(loaded, builder, &only) => open = open.or(Some(only)),
                _ => {}
            }
        }
        let sides = open.map_or([left, right], |open| [open, Expr::zero()]);
        let quantities = sides.iter().flat_map(Expr::symbols).filter(|symbol| Some(*symbol) != place.clock);
        let quantities = to_solve(loaded, builder, quantities.collect());
        let clock = place.clock.filter(|clock| sides.iter().any(|side| side.contains(*clock)));
        let clock = clock.map(|clock| (clock, moments(builder, place.stage)));
        Self::InNumbers(Sides { terms: sides, quantities, clock })
    }

    /// Whether terms are equal at the end of a stage, as far as that is seen without anything being solved for it.
    pub(super) fn at_the_end(loaded: &Loaded, builder: &Builder<'_>, stage: usize, [left, right]: [Expr; 2]) -> Self {
        let whole = left.clone() - right.clone();
        for place in [Some(stage), None] {
            let Some(reduced) = difference(loaded, builder, place, &whole) else { continue };
            if reduced.is_zero() {
                return Self::Always;
            }
            if place.is_none() && is_told(loaded, builder, &reduced) {
                return Self::InNumbers(Sides { terms: [reduced, Expr::zero()], quantities: Vec::new(), clock: None });
            }
        }
        Self::InNumbers(Sides { terms: [left, right], quantities: Vec::new(), clock: None })
    }

    /// Everything on which it depends.
    pub(crate) fn symbols(&self) -> BTreeSet<Symbol> {
        match self {
            Self::Always | Self::Never => BTreeSet::new(),
            Self::InNumbers(sides) => sides.terms.iter().flat_map(Expr::symbols).collect(),
        }
    }

    /// The quantities that have to be solved for it.
    pub(crate) fn quantities(&self) -> &[Symbol] {
        match self {
            Self::Always | Self::Never => &[],
            Self::InNumbers(sides) => &sides.quantities,
        }
    }

    /// A fault where numbers would have to decide, and something among them may be anything.
    pub(super) fn undecidable(&self, loaded: &Loaded, builder: &Builder<'_>, question: &str) -> Option<Fault> {
        let Self::InNumbers(sides) = self else { return None };
        let any = |symbol: &Symbol| {
            let name = &builder.symbols().entry(*symbol).name;
            matches!(loaded.given.get(name), Some(Given::Any(_))).then(|| format!("`{name}`"))
        };
        let whole = sides.terms[0].clone() - sides.terms[1].clone();
        let reduced = difference(loaded, builder, None, &whole).unwrap_or(whole);
        let undecided = Ranges::new(loaded, builder).undecided(&reduced, None);
        let names: BTreeSet<String> =
            undecided.iter().flat_map(Expr::symbols).filter_map(|symbol| any(&symbol)).collect();
        (!names.is_empty()).then(|| {
            let names = names.into_iter().collect::<Vec<_>>().join(", ");
            Fault::new(Code::UnderDetermined, format!("{question} depends on {names}, which can have any value"))
                .help("give it a value, or describe the stage further, such as by its coefficient of restitution")
        })
    }
}

/// Moments of a stage: what is the same at all of them is so at all times. Where it is not told how long it lasts, they are of every
/// size, in s.
fn moments(builder: &Builder<'_>, stage: usize) -> Vec<Expr> {
    const SHARES: [i64; 5] = [1, 3, 5, 8, 10];
    const SIZES: [u32; 4] = [100_000, 1000, 10, 1];
    let of_span = |[start, end]: [Expr; 2]| {
        let at = |share: i64| start.clone() + Expr::ratio(share, 11) * (end.clone() - start.clone());
        SHARES.into_iter().map(at).collect::<Vec<_>>()
    };
    let spanned = builder.span_of(stage).map(of_span).unwrap_or_default();
    spanned.into_iter().chain(SIZES.into_iter().map(|below| Expr::ratio(271, 70 * below))).collect()
}

fn is_drawn(loaded: &Loaded, builder: &Builder<'_>, symbol: Symbol) -> bool {
    matches!(loaded.given.get(&builder.symbols().entry(symbol).name), Some(Given::Drawn { .. } | Given::Any(_)))
}

/// Whether a term contains nothing but what has a value of its own.
fn is_told(loaded: &Loaded, builder: &Builder<'_>, term: &Expr) -> bool {
    let is_any =
        |symbol: &Symbol| matches!(loaded.given.get(&builder.symbols().entry(*symbol).name), Some(Given::Any(_)));
    let symbols = term.symbols();
    !symbols.iter().any(is_any) && to_solve(loaded, builder, symbols).is_empty()
}
