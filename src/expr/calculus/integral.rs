//! Antiderivatives of what forces are made of: polynomials, powers of linear terms, sines and exponentials, pieces of these.
//! What is not found is said so; nothing is guessed.

use momentous_quantity::Rational;

use super::super::algebra::polynomial_in::{MAX_SIZE, polynomial_in};
use super::super::{Expr, Function, Symbol};

/// Integrals that need more steps than this, by parts or multiplied out, are given up.
const MAX_STEPS: usize = 200;

impl Expr {
    /// An antiderivative with respect to `symbol`; `None` where the rules find none.
    ///
    /// ```
    /// use momentous_expr::{Expr, SymbolEntry, SymbolTable};
    /// use momentous_quantity::Dimension;
    /// let mut table = SymbolTable::default();
    /// let t = table.intern(SymbolEntry { name: "t".into(), dimension: Dimension::TIME, meaning: String::new() });
    /// assert_eq!(Expr::from(t).powi(2).integrate(t).unwrap().text(&table), "t^3/3");
    /// ```
    #[must_use]
    pub fn integrate(&self, symbol: Symbol) -> Option<Self> {
        integrate(self, symbol, &mut MAX_STEPS.clone())
    }
}

pub(crate) fn integrate(term: &Expr, symbol: Symbol, steps: &mut usize) -> Option<Expr> {
    *steps = steps.checked_sub(1)?;
    // By parts, each step may write a term out some times over.
    if term.size() > MAX_SIZE {
        return None;
    }
    if !term.contains(symbol) {
        return Some(term.clone() * Expr::Symbol(symbol));
    }
    if let Expr::Sum(terms) = term {
        let parts: Option<Vec<_>> = terms.iter().map(|term| integrate(term, symbol, steps)).collect();
        return parts.map(Expr::sum);
    }
    if let Expr::Piecewise(piecewise) = term {
        return super::pieces::integrate_pieces(piecewise, symbol, steps);
    }
    let all = match term {
        Expr::Product(factors) => factors.to_vec(),
        single => vec![single.clone()],
    };
    let all = all.into_iter().map(exponential_power);
    let (varying, fixed): (Vec<_>, Vec<_>) = all.partition(|factor| factor.contains(symbol));
    let antiderivative = integrate_factors(&varying, symbol, steps)?;
    Some(scaled(&antiderivative, &Expr::product(fixed)))
}

/// `exp(n u)` for `exp(u)^n`, whose antiderivative is known.
fn exponential_power(factor: Expr) -> Expr {
    match &factor {
        Expr::Power(pair) => match &pair.0 {
            Expr::Apply(Function::Exp, inner) => inner.first().map_or_else(
                || factor.clone(),
                |inner| Expr::apply(Function::Exp, (inner.clone() * pair.1.clone()).simplify()),
            ),
            _ => factor,
        },
        _ => factor,
    }
}

/// A factor in front of every term of a sum.
fn scaled(term: &Expr, factor: &Expr) -> Expr {
    match term {
        Expr::Sum(terms) => Expr::sum(terms.iter().map(|term| factor.clone() * term.clone())),
        Expr::Piecewise(_) => term.map_pieces(|value| scaled(value, factor)),
        other => factor.clone() * other.clone(),
    }
}

fn integrate_factors(factors: &[Expr], symbol: Symbol, steps: &mut usize) -> Option<Expr> {
    if let Some((pieces, others)) = take(factors, |factor| matches!(factor, Expr::Piecewise(_))) {
        let others = Expr::product(others);
        return integrate(&pieces.map_pieces(|value| value.clone() * others.clone()), symbol, steps);
    }
    if let Some(coefficients) = polynomial_in(&Expr::product(factors.to_vec()), symbol) {
        return Some(power_rule(&coefficients, &Expr::Symbol(symbol), &Rational::ZERO));
    }
    let (polynomial, others): (Vec<_>, Vec<_>) =
        factors.iter().cloned().partition(|factor| polynomial_in(factor, symbol).is_some());
    let polynomial = Expr::product(polynomial);
    let direct = match others.as_slice() {
        [single] => with_polynomial(&polynomial, single, symbol, steps),
        [Expr::Apply(Function::Sin, first), Expr::Apply(Function::Cos, second)]
        | [Expr::Apply(Function::Cos, first), Expr::Apply(Function::Sin, second)]
            if first == second =>
        {
            let double = Expr::integer(2) * first.first()?.clone();
            integrate(&Expr::product([Expr::ratio(1, 2), polynomial.clone(), double.sin()]), symbol, steps)
        }
        _ => None,
    };
    direct.or_else(|| by_inner_derivative(factors, symbol)).or_else(|| {
        let (sum, others) = take(factors, |factor| matches!(factor, Expr::Sum(_)))?;
        let Expr::Sum(terms) = sum else { return None };
        let others = Expr::product(others);
        integrate(&Expr::sum(terms.iter().map(|term| term.clone() * others.clone())), symbol, steps)
    })
}

/// The first factor that passes, and the others.
fn take(factors: &[Expr], test: impl Fn(&Expr) -> bool) -> Option<(Expr, Vec<Expr>)> {
    let place = factors.iter().position(test)?;
    let mut others = factors.to_vec();
    let factor = others.remove(place);
    Some((factor, others))
}

/// A polynomial times one power, sine, cosine or exponential of a linear term.
fn with_polynomial(polynomial: &Expr, factor: &Expr, symbol: Symbol, steps: &mut usize) -> Option<Expr> {
    let linear = |inner: &Expr| match polynomial_in(inner, symbol)?.as_slice() {
        [offset, slope] => Some((offset.clone(), slope.clone())),
        _ => None,
    };
    match factor {
        Expr::Power(pair) => {
            let shift = pair.1.as_number()?;
            if let (Expr::Apply(Function::Sin | Function::Cos, _), true) = (&pair.0, pair.1 == Expr::integer(2)) {
                return integrate(&(polynomial.clone() * halved_square(&pair.0)?), symbol, steps);
            }
            let (offset, slope) = linear(&pair.0)?;
            // in u = offset + slope x: x = (u - offset)/slope, dx = du/slope
            let inverse = (Expr::Symbol(symbol) - offset) / slope.clone();
            let substituted = polynomial.substitute(&|inner| (inner == symbol).then(|| inverse.clone()));
            let coefficients = polynomial_in(&substituted, symbol)?;
            Some(scaled(&power_rule(&coefficients, &pair.0, shift), &slope.powi(-1)))
        }
        Expr::Apply(function, arguments) => {
            let inner = arguments.first()?;
            let (_, slope) = linear(inner)?;
            by_parts(polynomial, *function, inner, &slope, symbol, steps)
        }
        _ => None,
    }
}

/// Each power c u^(k + shift) raised: c u^(k + shift + 1)/(k + shift + 1), or a logarithm.
fn power_rule(coefficients: &[Expr], base: &Expr, shift: &Rational) -> Expr {
    let raised = coefficients.iter().zip(1_i64..).map(|(coefficient, power)| {
        let power = Expr::Number(shift.clone() + Rational::from(power));
        let integral = if power.is_zero() {
            Expr::apply(Function::Ln, base.clone())
        } else {
            base.clone().power(power.clone()) / power
        };
        coefficient.clone() * integral
    });
    Expr::sum(raised)
}

/// `p f(u)` with u linear: `p F(u)/b` less the integral of `p' F(u)/b`.
fn by_parts(
    polynomial: &Expr,
    function: Function,
    inner: &Expr,
    slope: &Expr,
    symbol: Symbol,
    steps: &mut usize,
) -> Option<Expr> {
    let whole = Expr::product([polynomial.clone(), function.antiderivative(inner)?, slope.clone().powi(-1)]);
    let derivative = polynomial.differentiate(symbol);
    if derivative.is_zero() {
        return Some(whole);
    }
    if function == Function::Ln {
        return None;
    }
    let rest = Expr::product([derivative, function.antiderivative(inner)?, slope.clone().powi(-1)]);
    Some(whole - integrate(&rest, symbol, steps)?)
}

impl Function {
    /// An antiderivative with respect to the argument.
    fn antiderivative(self, argument: &Expr) -> Option<Expr> {
        let other = |function| Expr::apply(function, argument.clone());
        match self {
            Self::Sin => Some(-other(Self::Cos)),
            Self::Cos => Some(other(Self::Sin)),
            Self::Exp => Some(other(Self::Exp)),
            Self::Ln => Some(argument.clone() * (other(Self::Ln) - Expr::one())),
            Self::Tan => Some(-Expr::apply(Function::Ln, other(Self::Cos))),
            Self::Asin | Self::Acos | Self::Atan2 | Self::Abs => None,
        }
    }
}

/// `sin(u)^2 = (1 - cos 2u)/2`, `cos(u)^2 = (1 + cos 2u)/2`.
fn halved_square(base: &Expr) -> Option<Expr> {
    let Expr::Apply(function, arguments) = base else { return None };
    let double = (Expr::integer(2) * arguments.first()?.clone()).cos();
    let double = if *function == Function::Sin { -double } else { double };
    Some(Expr::ratio(1, 2) + Expr::ratio(1, 2) * double)
}

/// `c u' f(u)` with c free of the variable, found by dividing the rest by u'.
fn by_inner_derivative(factors: &[Expr], symbol: Symbol) -> Option<Expr> {
    (0..factors.len()).find_map(|place| {
        let (factor, others) = take(factors, |factor| Some(factor) == factors.get(place))?;
        let inner = match &factor {
            Expr::Power(pair) => pair.0.clone(),
            Expr::Apply(_, arguments) if arguments.len() == 1 => arguments.first()?.clone(),
            _ => return None,
        };
        let share = (Expr::product(others) / inner.differentiate(symbol)).simplify();
        if share.contains(symbol) {
            return None;
        }
        let integral = match &factor {
            Expr::Power(pair) => power_rule(&[Expr::one()], &inner, pair.1.as_number()?),
            Expr::Apply(function, _) => function.antiderivative(&inner)?,
            _ => return None,
        };
        Some(share * integral)
    })
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::AnyName;

    #[test]
    fn what_would_fill_pages_is_given_up() {
        for (text, found) in [("(t + t^3)^2*sin(a + 2*t)", true), ("((t + t^3)^3 + t)^3*sin(a + 2*t)", false)] {
            let mut names = AnyName::default();
            let (term, t) = (names.term(text), names.named("t"));
            assert_eq!(term.integrate(t).is_some(), found, "{text}");
        }
    }
}
