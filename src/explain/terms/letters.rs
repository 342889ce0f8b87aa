//! Growth of quantities computed from those that the sheet leaves open: multiples of their letters, or numbers where these drop
//! out.

use std::collections::BTreeMap;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_problem::Part;
use momentous_problem::Worked;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;
use momentous_solve::Closed;
use momentous_solve::Step;

/// The powers of open letters of which a quantity is a multiple; none for a number.
pub(super) type Powers = BTreeMap<Symbol, Rational>;

/// How a term depends on the open letters.
#[derive(Clone, Debug, PartialEq)]
enum Growth {
    /// It is zero, and so a multiple of anything.
    Zero,
    By(Powers),
}

/// How the quantities of one way depend on the open letters.
#[derive(Debug, Default)]
pub(super) struct Letters {
    /// The growth of each quantity, `None` where it is no multiple of powers of letters. A quantity that is not here is a number.
    known: BTreeMap<Symbol, Option<Growth>>,
}

impl Letters {
    pub(crate) fn of(worked: Worked<'_>) -> Self {
        let zeros = worked.zeros().map(|zero| (zero, Expr::zero())).collect();
        Self::along(worked, &worked.leaf().audit.plan.steps, &|unknown| worked.in_givens(unknown, &zeros))
    }

    /// The same along other steps; `whole` writes an unknown in what is given.
    pub(super) fn along(worked: Worked<'_>, steps: &[Step], whole: &dyn Fn(Symbol) -> Option<Expr>) -> Self {
        let mut letters = Self::default();
        if worked.form.free.is_empty() {
            return letters;
        }
        let literals = worked.problem.model().literals.iter().filter(|(_, quantity)| quantity.value.is_zero());
        let zeros = worked.zeros().chain(literals.map(|(symbol, _)| *symbol));
        letters.known.extend(zeros.map(|zero| (zero, Some(Growth::Zero))));
        let as_it_stands = |letter: &Symbol| (*letter, Some(Growth::By(Powers::from([(*letter, Rational::ONE)]))));
        letters.known.extend(worked.form.free.iter().map(as_it_stands));
        for step in steps {
            for (unknown, closed) in step.roots.iter().flat_map(|root| &root.values) {
                let growth = letters.solved(worked, (*unknown, closed), whole);
                let other_root = letters.known.get(unknown).cloned();
                letters.known.insert(*unknown, common(other_root.into_iter().chain([growth])));
            }
        }
        letters
    }

    fn solved(
        &self,
        worked: Worked<'_>,
        (unknown, closed): (Symbol, &Closed),
        whole: &dyn Fn(Symbol) -> Option<Expr>,
    ) -> Option<Growth> {
        let number = Some(Growth::By(Powers::new()));
        if !closed.symbols().iter().any(|symbol| self.is_open(*symbol) || self.is_zero(*symbol)) {
            return number;
        }
        let at_once = || match closed {
            Closed::Formula(formula) => self.growth(worked, formula),
            _ => None,
        };
        let by_algebra = || {
            let whole = whole(unknown).filter(|whole| !whole.contains(unknown))?;
            self.growth(worked, &whole)
        };
        // A pure number that is asked as one has a value whatever the letters are, and so has one that no formula gives.
        let asks = |part: &Part| part.kind.numbers().iter().any(|number| number.symbol == unknown);
        let is_number = worked.form.parts.iter().any(asks) || !matches!(closed, Closed::Formula(_));
        let is_pure = is_number && worked.problem.model().symbols.entry(unknown).dimension == Dimension::NONE;
        at_once().or_else(by_algebra).or(number.filter(|_| is_pure))
    }

    /// Whether a quantity hangs on an open letter.
    pub(crate) fn is_open(&self, symbol: Symbol) -> bool {
        match self.known.get(&symbol) {
            Some(Some(Growth::By(powers))) => !powers.is_empty(),
            Some(None) => true,
            _ => false,
        }
    }

    /// Whether it is no multiple of powers of letters.
    pub(crate) fn is_free(&self, symbol: Symbol) -> bool {
        matches!(self.known.get(&symbol), Some(None))
    }

    fn is_zero(&self, symbol: Symbol) -> bool {
        matches!(self.known.get(&symbol), Some(Some(Growth::Zero)))
    }

    /// The powers of letters of which a term is a multiple; `None` where it is none.
    pub(crate) fn powers(&self, worked: Worked<'_>, term: &Expr) -> Option<Powers> {
        if self.known.is_empty() {
            return Some(Powers::new());
        }
        match self.growth(worked, term)? {
            Growth::Zero => Some(Powers::new()),
            Growth::By(powers) => Some(powers),
        }
    }

    fn growth(&self, worked: Worked<'_>, term: &Expr) -> Option<Growth> {
        let number = || Some(Growth::By(Powers::new()));
        let inner = |part: &Expr| self.growth(worked, part);
        // Of a letter that may be negative neither the absolute value nor a root is a multiple.
        let of_positive = |growth: Growth| match &growth {
            Growth::By(powers) if !powers.keys().all(|letter| worked.is_positive(*letter)) => None,
            _ => Some(growth),
        };
        match term {
            Expr::Number(value) if value.is_zero() => Some(Growth::Zero),
            Expr::Number(_) | Expr::Pi => number(),
            Expr::Symbol(symbol) => self.known.get(symbol).cloned().unwrap_or_else(number),
            Expr::Sum(terms) => common(terms.iter().map(inner)),
            Expr::Product(factors) => {
                let factors: Option<Vec<Growth>> = factors.iter().map(inner).collect();
                factors?.into_iter().try_fold(Growth::By(Powers::new()), |product, factor| match (product, factor) {
                    (Growth::By(product), Growth::By(factor)) => Some(Growth::By(times(product, &factor))),
                    _ => Some(Growth::Zero),
                })
            }
            Expr::Power(pair) => match (inner(&pair.0)?, pair.1.as_number()) {
                (Growth::Zero, _) => Some(Growth::Zero),
                (Growth::By(powers), _) if powers.is_empty() && inner(&pair.1)? == Growth::By(Powers::new()) => {
                    number()
                }
                (base, Some(exponent)) => {
                    let base = if exponent.is_int() { base } else { of_positive(base)? };
                    let Growth::By(powers) = base else { return Some(base) };
                    Some(Growth::By(powers.into_iter().map(|(letter, power)| (letter, power * exponent)).collect()))
                }
                _ => None,
            },
            Expr::Apply(Function::Abs, arguments) => common(arguments.iter().map(inner)).and_then(of_positive),
            Expr::Apply(Function::Atan2, arguments) => {
                common(arguments.iter().map(inner)).and_then(of_positive).and_then(|_| number())
            }
            Expr::Apply(_, arguments) => {
                let is_number = |growth: Growth| growth == Growth::Zero || growth == Growth::By(Powers::new());
                arguments.iter().all(|argument| inner(argument).is_some_and(is_number)).then(number).flatten()
            }
            Expr::Piecewise(piecewise) => common(piecewise.pieces.iter().map(|(_, value)| inner(value))),
        }
    }
}

/// How terms grow that all grow alike.
fn common(mut terms: impl Iterator<Item = Option<Growth>>) -> Option<Growth> {
    terms.try_fold(Growth::Zero, |common, term| match (common, term?) {
        (Growth::Zero, growth) | (growth, Growth::Zero) => Some(growth),
        (common, growth) => (common == growth).then_some(common),
    })
}

fn times(mut product: Powers, factor: &Powers) -> Powers {
    for (letter, power) in factor {
        *product.entry(*letter).or_default() += power;
    }
    product.retain(|_, power| !power.is_zero());
    product
}
