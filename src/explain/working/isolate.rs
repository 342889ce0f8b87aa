//! An unknown isolated as on paper: what was done to it is undone, and nothing is multiplied out.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Rational;

/// Isolates an unknown in `left = right`: terms are moved, factors divided, powers turned into roots. Of a square the root with
/// that sign is taken. `None` where the unknown stands more than once, or within a function.
pub(super) fn isolated([left, right]: [&Expr; 2], unknown: Symbol, is_negative: bool) -> Option<Expr> {
    let (mut side, mut other) = match [left, right].map(|side| occurrences(side, Some(unknown))) {
        [1, 0] => (left.clone(), right.clone()),
        [0, 1] => (right.clone(), left.clone()),
        _ => return None,
    };
    loop {
        side = match &side {
            Expr::Symbol(_) => return Some(other),
            Expr::Sum(terms) => {
                let (inner, rest) = apart(terms, unknown)?;
                other = Expr::sum([other].into_iter().chain(rest.map(|term| -term.clone())));
                inner
            }
            Expr::Product(factors) => {
                let (inner, rest) = apart(factors, unknown)?;
                let (numbers, factors): (Vec<&Expr>, Vec<&Expr>) =
                    rest.partition(|factor| factor.as_number().is_some());
                let number = Expr::product(numbers.into_iter().map(|number| number.clone().powi(-1)));
                // Half of every term is no bracket with a half before it.
                other = match &other {
                    Expr::Sum(terms) => Expr::sum(terms.iter().map(|term| number.clone() * term.clone())),
                    _ => number * other,
                };
                other =
                    Expr::product([other].into_iter().chain(factors.into_iter().map(|factor| factor.clone().powi(-1))));
                inner
            }
            Expr::Power(pair) => {
                let (base, exponent) = &**pair;
                if *exponent == Expr::integer(2) {
                    let root = other.power(Expr::ratio(1, 2));
                    other = if is_negative { -root } else { root };
                } else if *exponent == Expr::ratio(1, 2) || *exponent == Expr::integer(-1) {
                    other = other.power(exponent.clone().powi(-1));
                } else {
                    return None;
                }
                base.clone()
            }
            _ => return None,
        };
    }
}

/// The part that holds the unknown, and the others.
fn apart(parts: &[Expr], unknown: Symbol) -> Option<(Expr, impl Iterator<Item = &Expr>)> {
    let place = parts.iter().position(|part| occurrences(part, Some(unknown)) > 0)?;
    let others = parts.iter().enumerate().filter(move |(index, _)| *index != place).map(|(_, part)| part);
    Some((parts.get(place)?.clone(), others))
}

/// The number of times that a quantity, or any, stands in a term.
pub(super) fn occurrences(term: &Expr, wanted: Option<Symbol>) -> usize {
    match term {
        Expr::Symbol(symbol) => usize::from(wanted.is_none_or(|wanted| wanted == *symbol)),
        _ => term.children().map(|part| occurrences(part, wanted)).sum(),
    }
}

/// The number of fractions that stand within each other in a term.
pub(super) fn nested_fractions(term: &Expr) -> usize {
    let divides = |part: &Expr| {
        let Expr::Power(pair) = part else { return false };
        pair.1.as_number().is_some_and(|exponent| *exponent < Rational::ZERO)
    };
    let inner = term.children().map(nested_fractions).max().unwrap_or(0);
    let is_fraction = divides(term) || matches!(term, Expr::Product(factors) if factors.iter().any(divides));
    match term {
        // The factors of a product share its one fraction.
        Expr::Product(factors) if is_fraction => {
            let within = |factor: &Expr| match factor {
                Expr::Power(pair) if divides(factor) => nested_fractions(&pair.0),
                _ => nested_fractions(factor),
            };
            1 + factors.iter().map(within).max().unwrap_or(0)
        }
        _ => inner + usize::from(is_fraction),
    }
}

/// Whether a term is the quotient of a sum.
pub(super) fn is_quotient_of_sum(term: &Expr) -> bool {
    let Expr::Product(factors) = term else { return false };
    nested_fractions(term) > 0 && factors.iter().any(|factor| matches!(factor, Expr::Sum(_)))
}

/// Whether the unknown is a term of one side by itself, so that moving the others isolates it.
pub(super) fn is_bare([left, right]: [&Expr; 2], unknown: Symbol) -> bool {
    let is_term = |side: &Expr| matches!(side, Expr::Sum(terms) if terms.contains(&unknown.into()));
    is_term(left) || is_term(right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use momentous_expr::SymbolEntry;
    use momentous_expr::SymbolTable;
    use momentous_quantity::Dimension;

    #[test]
    fn nothing_is_multiplied_out() {
        let mut table = SymbolTable::default();
        let [f, m, g, v, l] = ["F", "m", "g", "v", "L"].map(|name| {
            table.intern(SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() })
        });
        let [tension, mass, gravity, speed, length] = [f, m, g, v, l].map(Expr::from);
        // F - m g = m v^2/L
        let left = tension - mass.clone() * gravity.clone();
        let right = mass.clone() * speed.powi(2) / length.clone();
        let name = |symbol| table.entry(symbol).name.clone();
        let text = |term: Option<Expr>| term.unwrap().text_with(&name);
        assert_eq!(text(isolated([&left, &right], f, false)), "m*v^2/L + m*g");
        assert!(is_bare([&left, &right], f) && !is_bare([&left, &right], l));
        assert_eq!(isolated([&left, &right], m, false), None, "it stands twice");
        let root = isolated([&left, &right], v, true).unwrap();
        let values = |symbol| if symbol == f { 30.0 } else { 2.0 };
        // (30 - 4)*2/2 = 26
        assert!((root.evaluate(&values) + 26.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn fractions_within_fractions_are_counted() {
        let mut table = SymbolTable::default();
        let [a, b, c] = ["a", "b", "c"].map(|name| {
            let entry = SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() };
            Expr::from(table.intern(entry))
        });
        assert_eq!(nested_fractions(&(a.clone() * b.clone())), 0);
        let sum = a.clone() / b.clone() + c.clone();
        assert_eq!([&sum, &(sum.clone() / c.clone())].map(nested_fractions), [1, 2]);
        assert!(is_quotient_of_sum(&((a.clone() + b) / c.clone())) && !is_quotient_of_sum(&(a / c)));
    }
}
