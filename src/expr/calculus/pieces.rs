//! Integrals between bounds, and of functions that are given piece by piece.

use std::sync::Arc;

use super::super::{Expr, Function, Piecewise, Symbol};
use super::integral::integrate;

impl Expr {
    /// The integral over `symbol` from `low` to `high`; `None` where no antiderivative is found.
    ///
    /// Pieces give a function of the upper bound, piece by piece, or a plain sum where all bounds are numbers.
    /// A lower bound of zero is taken to lie in the first piece: pieces are counted from the start.
    ///
    /// ```
    /// use momentous_expr::{Expr, SymbolEntry, SymbolTable};
    /// use momentous_quantity::Dimension;
    /// let mut table = SymbolTable::default();
    /// let mut add = |name: &str| {
    ///     table.intern(SymbolEntry { name: name.into(), dimension: Dimension::TIME, meaning: String::new() })
    /// };
    /// let (t, end) = (add("t"), add("t_2"));
    /// let impulse = Expr::from(t).definite(t, &Expr::zero(), &end.into());
    /// assert_eq!(impulse.unwrap().text(&table), "t_2^2/2");
    /// ```
    #[must_use]
    pub fn definite(&self, symbol: Symbol, low: &Self, high: &Self) -> Option<Self> {
        let antiderivative = self.integrate(symbol)?;
        let terms = match &antiderivative {
            Self::Sum(terms) => terms.to_vec(),
            single => vec![single.clone()],
        };
        Some(Self::sum(terms.iter().map(|term| between(term, symbol, low, high))))
    }

    /// The same function with the value of each piece changed; any other term changed whole.
    pub(super) fn map_pieces(&self, change: impl Fn(&Self) -> Self) -> Self {
        let Self::Piecewise(piecewise) = self else { return change(self) };
        let pieces = piecewise.pieces.iter().map(|(until, value)| (until.clone(), change(value))).collect();
        Self::Piecewise(Arc::new(Piecewise { variable: piecewise.variable.clone(), pieces }))
    }
}

/// One term of an antiderivative at the upper bound less the same at the lower.
fn between(term: &Expr, symbol: Symbol, low: &Expr, high: &Expr) -> Expr {
    if let Some((coefficient, inner)) = logarithm(term).filter(|(coefficient, _)| !coefficient.contains(symbol)) {
        // one logarithm of a ratio, which is positive wherever the integral exists
        let ratio = at(&inner, symbol, high) / at(&inner, symbol, low);
        return coefficient * Expr::apply(Function::Ln, ratio);
    }
    let (upper, lower) = (at(term, symbol, high), at(term, symbol, low));
    if lower.is_zero() {
        return upper;
    }
    match (&upper, &lower) {
        (Expr::Piecewise(_), Expr::Piecewise(_)) => upper - lower,
        (Expr::Piecewise(_), _) => upper.map_pieces(|value| value.clone() - lower.clone()),
        _ => upper - lower,
    }
}

fn logarithm(term: &Expr) -> Option<(Expr, Expr)> {
    let factors = match term {
        Expr::Product(factors) => factors.to_vec(),
        single => vec![single.clone()],
    };
    let is_logarithm = |factor: &Expr| matches!(factor, Expr::Apply(Function::Ln, _));
    let (logarithms, others): (Vec<_>, Vec<_>) = factors.into_iter().partition(is_logarithm);
    match logarithms.as_slice() {
        [Expr::Apply(_, arguments)] => Some((Expr::product(others), arguments.first()?.clone())),
        _ => None,
    }
}

/// The term with the symbol replaced, known values of functions put in, and a piece chosen where that is certain.
fn at(term: &Expr, symbol: Symbol, value: &Expr) -> Expr {
    folded(&term.substitute(&|inner| (inner == symbol).then(|| value.clone())))
}

fn folded(term: &Expr) -> Expr {
    let term = term.map_children(folded);
    match &term {
        Expr::Apply(function, arguments) => match (function, arguments.as_ref()) {
            (Function::Sin | Function::Tan | Function::Asin | Function::Abs, [zero]) if zero.is_zero() => Expr::zero(),
            (Function::Cos | Function::Exp, [zero]) if zero.is_zero() => Expr::one(),
            (Function::Ln, [one]) if one.is_one() => Expr::zero(),
            _ => term,
        },
        Expr::Piecewise(piecewise) => chosen(piecewise).cloned().unwrap_or(term),
        _ => term,
    }
}

/// The piece that holds, where that can be told: all are numbers, or the variable is zero and bounds come after it.
fn chosen(piecewise: &Piecewise) -> Option<&Expr> {
    if piecewise.variable.is_zero()
        && piecewise.pieces.iter().all(|(until, _)| until.as_ref().is_none_or(|until| until.as_number().is_none()))
    {
        return piecewise.pieces.first().map(|(_, value)| value);
    }
    let variable = piecewise.variable.as_number()?;
    for (until, value) in &piecewise.pieces {
        match until {
            None => return Some(value),
            Some(until) if variable <= until.as_number()? => return Some(value),
            Some(_) => {}
        }
    }
    None
}

/// Each piece raised by what the pieces before it have gathered, so that the whole has no jumps.
pub(super) fn integrate_pieces(piecewise: &Piecewise, symbol: Symbol, steps: &mut usize) -> Option<Expr> {
    let in_bounds =
        piecewise.pieces.iter().any(|(until, _)| until.as_ref().is_some_and(|until| until.contains(symbol)));
    if piecewise.variable != Expr::Symbol(symbol) || in_bounds {
        return None;
    }
    let mut gathered = Expr::zero();
    let mut start: Option<Expr> = None;
    let mut pieces = Vec::new();
    for (until, value) in &piecewise.pieces {
        let antiderivative = integrate(value, symbol, steps)?;
        let piece = match &start {
            None => antiderivative,
            Some(start) => gathered.clone() + antiderivative.clone() - at(&antiderivative, symbol, start),
        };
        if let Some(until) = until {
            gathered = at(&piece, symbol, until);
            start = Some(until.clone());
        }
        pieces.push((until.clone(), piece));
    }
    Some(Expr::Piecewise(Arc::new(Piecewise { variable: piecewise.variable.clone(), pieces })))
}

#[cfg(test)]
mod tests {
    use super::super::super::equal;
    use super::super::super::testing::AnyName;
    use super::*;

    #[test]
    fn forces_integrate_to_impulses() {
        for (force, expected) in [
            ("F", "F*t_2"),
            ("F_0 + k*t", "F_0*t_2 + k*t_2^2/2"),
            ("k*t*(t_a - t)", "k*t_a*t_2^2/2 - k*t_2^3/3"),
            ("F_0*sin(pi*t/t_a)", "F_0*t_a/pi*(1 - cos(pi*t_2/t_a))"),
            ("F_0*sin(pi*t/t_a)^2", "F_0*(t_2/2 - t_a*sin(2*pi*t_2/t_a)/(4*pi))"),
            ("F_0*exp(-t/t_a)", "F_0*t_a*(1 - exp(-t_2/t_a))"),
            ("F_0*(1 - exp(-t/t_a))", "F_0*t_2 - F_0*t_a*(1 - exp(-t_2/t_a))"),
            ("k*t*exp(-t/t_a)", "k*(t_a^2 - t_a*(t_2 + t_a)*exp(-t_2/t_a))"),
            ("t^2*cos(w*t)", "t_2^2*sin(w*t_2)/w + 2*t_2*cos(w*t_2)/w^2 - 2*sin(w*t_2)/w^3"),
            ("q/(m - r*t)", "-q/r*ln((m - r*t_2)/m)"),
            ("sqrt(a + b*t)", "2*((a + b*t_2)*sqrt(a + b*t_2) - a*sqrt(a))/(3*b)"),
            ("t/(a + b*t)^2", "(ln((a + b*t_2)/a) + a/(a + b*t_2) - 1)/b^2"),
            ("t*exp(-(t^2))", "(1 - exp(-(t_2^2)))/2"),
            ("sin(w*t)*cos(w*t)", "sin(w*t_2)^2/(2*w)"),
            ("(1 + t)^3", "((1 + t_2)^4 - 1)/4"),
        ] {
            let mut names = AnyName::default();
            let (force, expected) = (names.term(force), names.term(expected));
            let (t, end) = (names.named("t"), names.named("t_2"));
            let found = force.definite(t, &Expr::zero(), &end.into()).unwrap_or(Expr::integer(404));
            assert!(equal(&found, &expected), "{} is {}", force.text(&names.0), found.text(&names.0));
            let back = found.differentiate(end);
            let force_at_end = force.substitute(&|symbol| (symbol == t).then(|| end.into()));
            assert!(equal(&back, &force_at_end), "{}", back.text(&names.0));
        }
    }

    #[test]
    fn pieces_join_without_jumps() {
        let mut names = AnyName::default();
        let (ramp, constant) = (names.term("k*t"), names.term("k*t_a"));
        let (bound, end, t) = (names.term("t_a"), names.term("t_2"), names.named("t"));
        let pieces = vec![(Some(bound), ramp), (None, constant)];
        let force = Expr::Piecewise(Arc::new(Piecewise { variable: t.into(), pieces }));
        let twice = Expr::integer(2) * force.clone() - names.term("F");
        let impulse = twice.definite(t, &Expr::zero(), &end).unwrap_or(Expr::integer(404));
        let (k, t_a, f) = (3.0, 2.0, 0.5);
        let value = |t_2: f64| {
            impulse.evaluate(&|symbol| match names.0.entry(symbol).name.as_str() {
                "k" => k,
                "t_a" => t_a,
                "F" => f,
                "t_2" => t_2,
                _ => f64::NAN,
            })
        };
        for (end, expected) in [(1.0, 2.5), (2.0, 11.0), (5.0, 45.5)] {
            assert!((value(end) - expected).abs() < 1e-12, "{end}");
        }
        let numbers = [Some(Expr::one()), None].into_iter().zip([Expr::Symbol(t), Expr::one()]).collect();
        let saturating = Expr::Piecewise(Arc::new(Piecewise { variable: t.into(), pieces: numbers }));
        assert_eq!(saturating.definite(t, &Expr::zero(), &Expr::integer(3)), Some(Expr::ratio(5, 2)));
    }
}
