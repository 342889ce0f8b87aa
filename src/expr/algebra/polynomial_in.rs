//! A term read as a polynomial in one symbol, with coefficients as they are written.

use super::super::{Expr, Symbol};

/// Powers above this are not multiplied out.
const MAX_POWER: i32 = 16;

/// The largest size that is multiplied out and integrated; a term that takes more to write fills pages.
pub(crate) const MAX_SIZE: usize = 10_000;

/// The coefficients of the powers 0, 1, 2, ... of `symbol`; `None` where the term is not such a polynomial as it is written.
pub(crate) fn polynomial_in(term: &Expr, symbol: Symbol) -> Option<Vec<Expr>> {
    if !term.contains(symbol) {
        return Some(vec![term.clone()]);
    }
    match term {
        Expr::Symbol(_) => Some(vec![Expr::zero(), Expr::one()]),
        Expr::Sum(terms) => {
            let parts: Vec<_> = terms.iter().map(|term| polynomial_in(term, symbol)).collect::<Option<_>>()?;
            let length = parts.iter().map(Vec::len).max().unwrap_or(0);
            let column = |power: usize| Expr::sum(parts.iter().filter_map(|part| part.get(power).cloned()));
            Some((0..length).map(column).collect())
        }
        Expr::Product(factors) => factors
            .iter()
            .try_fold(vec![Expr::one()], |product, factor| multiply(&product, &polynomial_in(factor, symbol)?)),
        Expr::Power(pair) => {
            let power = pair.1.as_number().filter(|power| power.is_int())?;
            let power =
                i32::try_from(power.numerator().clone()).ok().filter(|power| (1..=MAX_POWER).contains(power))?;
            let base = polynomial_in(&pair.0, symbol)?;
            (0..power).try_fold(vec![Expr::one()], |product, _| multiply(&product, &base))
        }
        _ => None,
    }
}

fn multiply(left: &[Expr], right: &[Expr]) -> Option<Vec<Expr>> {
    let length = (left.len() + right.len()).checked_sub(1).filter(|length| *length <= 64)?;
    let size = |terms: &[Expr]| terms.iter().map(Expr::size).sum::<usize>();
    if size(left) * right.len() + size(right) * left.len() > MAX_SIZE {
        return None;
    }
    let mut sums = vec![Vec::new(); length];
    for (low, first) in left.iter().enumerate() {
        for (high, second) in right.iter().enumerate() {
            sums.get_mut(low + high)?.push(first.clone() * second.clone());
        }
    }
    Some(sums.into_iter().map(Expr::sum).collect())
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::AnyName;
    use super::*;

    #[test]
    fn what_would_fill_pages_is_not_multiplied_out() {
        for (text, degree) in [
            ("(a + b*t)^2*(t + 1)", Some(3)),
            ("((((a + b*t)^9 + t)^9 + t)^9 + t)^9", None),
            ("((a + b*t)*(c + d*t)*(a + t))^5*((b + t)*(c - t) + (a - b*t)^3)^6*(a*t + b)^3", None),
        ] {
            let mut names = AnyName::default();
            let (term, t) = (names.term(text), names.named("t"));
            assert_eq!(polynomial_in(&term, t).map(|found| found.len() - 1), degree, "{text}");
        }
    }
}
