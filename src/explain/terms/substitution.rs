//! Numbers in place of symbols, and what is zero left out.

use momentous_expr::Arrangement;
use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;
use momentous_solve::Bounded;

use super::algebra::positive_first;
use super::display::Display;
use super::term::Term;

impl Display<'_> {
    /// A term with numbers and units in place of its symbols, what is zero and has a unit being left out; none where that leaves
    /// nothing to compute.
    pub(crate) fn substituted(self, term: &Term) -> Option<Math> {
        let value = |symbol: Symbol| self.worked.variant.value(symbol).map_or(f64::NAN, Bounded::or_zero);
        let put = |arranged: &Arrangement| arranged.with_numbers(&|symbol| self.put_in(symbol), &value);
        if !self.has_zeros(term) && !self.has_right_angle(&term.expr) {
            return Some(put(&term.arranged));
        }
        let rest = self.without_zeros(&term.expr);
        let size = match &rest {
            Expr::Power(pair) if pair.1 == Expr::ratio(1, 2) => match &pair.0 {
                Expr::Power(square) => square.0.clone(),
                _ => rest.clone(),
            },
            _ => rest.clone(),
        };
        let computes = !rest.is_zero() && !matches!((-size.clone(), size), (Expr::Symbol(_), _) | (_, Expr::Symbol(_)));
        computes.then(|| put(&positive_first(&rest).arranged()))
    }

    /// A term without what is zero and has a unit, and with the sines and cosines of right angles worked out.
    pub(crate) fn without_zeros(self, term: &Expr) -> Expr {
        self.without_right_angles(without(term, &|symbol| self.is_nothing(symbol)))
    }

    /// The same, but for what is not known yet.
    pub(crate) fn without_known_zeros(self, term: &Expr, unknowns: &[Symbol]) -> Expr {
        let is_out = |symbol| !unknowns.contains(&symbol) && self.is_nothing(symbol);
        if !term.symbols().into_iter().any(is_out) {
            return self.without_right_angles(term.clone());
        }
        self.without_right_angles(positive_first(&without(term, &is_out)))
    }

    /// A term with -1, 0 or 1 in place of the sine or cosine of a given angle of whole quarter turns, and 1 for the exponential of zero.
    fn without_right_angles(self, term: Expr) -> Expr {
        if !self.has_right_angle(&term) {
            return term;
        }
        positive_first(&self.worked_out(&term).simplify())
    }

    fn worked_out(self, term: &Expr) -> Expr {
        self.of_right_angle(term).map_or_else(|| term.map_children(|part| self.worked_out(part)), Expr::integer)
    }

    fn has_right_angle(self, term: &Expr) -> bool {
        self.of_right_angle(term).is_some() || term.children().any(|part| self.has_right_angle(part))
    }

    /// The value of a sine, a cosine or an exponential that is a whole number whatever is drawn.
    fn of_right_angle(self, term: &Expr) -> Option<i64> {
        let Expr::Apply(function, _) = term else { return None };
        let argument = term.children().next()?;
        let Expr::Symbol(symbol) = argument else {
            return (*function == Function::Exp && argument.is_zero()).then_some(1);
        };
        let angle = self.value_of(argument);
        let value = match function {
            Function::Sin => libm::sin(angle),
            Function::Cos => libm::cos(angle),
            _ => return None,
        };
        let is_whole = (value - value.round()).abs() < 1e-12 && self.is_told(*symbol);
        is_whole.then_some(i64::from(value > 0.5) - i64::from(value < -0.5))
    }

    /// Whether a quantity is given, or a number that the author wrote.
    fn is_told(self, symbol: Symbol) -> bool {
        let is_given = self.worked.variant.all_given().iter().any(|(given, ..)| *given == symbol);
        is_given || self.manner(symbol).constant.is_some()
    }

    /// A term with numbers in place of what is known.
    pub(crate) fn with_known_numbers(self, term: &Expr, unknowns: &[Symbol]) -> Math {
        let leaf = |symbol| if unknowns.contains(&symbol) { self.named(symbol) } else { self.put_in(symbol) };
        let value = |symbol: Symbol| self.worked.variant.value(symbol).map_or(f64::NAN, Bounded::or_zero);
        term.arranged().with_numbers(&leaf, &value)
    }

    /// Whether a quantity that is zero is left out of a term with numbers.
    pub(crate) fn has_zeros(self, term: &Term) -> bool {
        term.mentions.iter().any(|symbol| self.is_nothing(*symbol))
    }

    /// Whether a quantity with a unit is exactly zero.
    pub(crate) fn is_nothing(self, symbol: Symbol) -> bool {
        let has_unit = self.worked.problem.model().symbols.entry(symbol).dimension != Dimension::NONE;
        has_unit && self.worked.variant.value(symbol).is_some_and(Bounded::is_zero)
    }
}

/// A term with zero in place of some symbols. Its terms and factors keep their order.
pub(crate) fn without(term: &Expr, is_zero: &dyn Fn(Symbol) -> bool) -> Expr {
    let rest = term.substitute(&|symbol| is_zero(symbol).then(Expr::zero));
    // What then stands above and below a fraction cancels.
    let simple = rest.simplify();
    let is_shorter =
        simple.symbols().len() < rest.symbols().len() || !has_sum(&rest) && occurrences(&simple) < occurrences(&rest);
    if is_shorter { simple } else { rest }
}

fn has_sum(term: &Expr) -> bool {
    matches!(term, Expr::Sum(_)) || term.children().any(has_sum)
}

/// How many symbols are written in a term.
fn occurrences(term: &Expr) -> usize {
    usize::from(matches!(term, Expr::Symbol(_))) + term.children().map(occurrences).sum::<usize>()
}
