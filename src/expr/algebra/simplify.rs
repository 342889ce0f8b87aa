//! Terms brought into readable form, and read as polynomials in chosen symbols.

use super::super::calculus::curvature::is_curved;
use super::super::{Expr, Function, Symbol, equal};
use super::canonical::{Rules, is_plain, none_positive};
use super::quotient::Quotient;

impl Expr {
    /// The canonical form, written readably; the term itself where that would be much longer than the term.
    ///
    /// ```
    /// use momentous_expr::Expr;
    /// let x = Expr::Pi;
    /// let quotient = (x.clone().powi(2) - Expr::one()) / (x.clone() - Expr::one());
    /// assert_eq!(quotient.simplify(), Expr::one() + x);
    /// ```
    #[must_use]
    pub fn simplify(&self) -> Self {
        self.simplify_where(&none_positive)
    }

    /// The same, with the symbols for which `positive` holds known to be positive: then `sqrt(b^2)` is `b`.
    #[must_use]
    pub fn simplify_where(&self, positive: &dyn Fn(Symbol) -> bool) -> Self {
        if is_plain(self) {
            return self.clone();
        }
        let simple = readable_form(self, positive).map(|form| form.to_expr());
        simple.filter(|simple| simple.size() <= 2 * self.size() + 8).unwrap_or_else(|| self.clone())
    }

    /// The number of numbers, symbols and operations that the term has.
    #[must_use]
    pub fn size(&self) -> usize {
        1 + self.children().map(Self::size).sum::<usize>()
    }

    /// The coefficients of the powers 0, 1, 2, ... of `symbol` in the numerator, once denominators are cleared, and the
    /// denominator that cleared them.
    ///
    /// `None` where the symbol stands inside a root, a function or an exponent, or where the term is too large.
    #[must_use]
    pub fn collect(&self, symbol: Symbol) -> Option<(Vec<Self>, Self)> {
        let form = readable_form(self, &none_positive)?;
        let base = Self::Symbol(symbol);
        if form.numerator.atoms().into_iter().any(|atom| *atom != base && atom.contains(symbol)) {
            return None;
        }
        let by_power = form.numerator.coefficients(&base);
        let degree = by_power.last_key_value().map_or(0, |(power, _)| *power);
        let read = |power| by_power.get(&power).map_or_else(Self::zero, |sum| Quotient::from(sum.clone()).to_expr());
        let coefficients = (0..=degree).map(read).collect();
        Some((coefficients, Quotient::from(form.denominator.clone()).to_expr()))
    }

    /// The coefficients of `symbols` and the rest, where the term is linear in them jointly; `None` where it is not.
    ///
    /// Coefficients stay as they are written where no algebra is needed to find them.
    #[must_use]
    pub fn linear_coefficients(&self, symbols: &[Symbol]) -> Option<(Vec<Self>, Self)> {
        let algebra = || if is_curved(self, symbols) { None } else { after_algebra(self, symbols) };
        let (parts, rest) = as_written(self, symbols).or_else(algebra)?;
        let tidy = |terms: Vec<Self>| match terms.len() {
            0 => Self::zero(),
            1 => Self::sum(terms),
            _ => {
                let sum = Self::sum(terms);
                if equal(&sum, &Self::zero()) { Self::zero() } else { sum }
            }
        };
        Some((parts.into_iter().map(tidy).collect(), Self::sum(rest)))
    }
}

/// The form with fewer terms of the two: with squares of sines, or with squares of cosines in their place.
fn readable_form(expr: &Expr, positive: &dyn Fn(Symbol) -> bool) -> Option<Quotient> {
    let rules = Rules { pythagoras: false, expand: false, positive };
    let form = rules.quotient(expr)?;
    if !has_sine(expr) {
        return Some(form);
    }
    let length = |form: &Quotient| form.numerator.len() + form.denominator.len();
    let other = Rules { pythagoras: true, ..rules }.lowered_form(&form).flatten();
    Some(other.filter(|other| length(other) < length(&form)).unwrap_or(form))
}

fn has_sine(expr: &Expr) -> bool {
    matches!(expr, Expr::Apply(Function::Sin | Function::Tan, _)) || expr.children().any(has_sine)
}

/// For each symbol the terms of its coefficient, and the terms of the rest.
type Linear = (Vec<Vec<Expr>>, Vec<Expr>);

fn as_written(expr: &Expr, symbols: &[Symbol]) -> Option<Linear> {
    let involved = |expr: &Expr| symbols.iter().any(|symbol| expr.contains(*symbol));
    let mut parts = vec![Vec::new(); symbols.len()];
    if !involved(expr) {
        return Some((parts, vec![expr.clone()]));
    }
    match expr {
        Expr::Symbol(written) => {
            let place = symbols.iter().position(|symbol| symbol == written)?;
            parts.get_mut(place)?.push(Expr::one());
            Some((parts, Vec::new()))
        }
        Expr::Sum(terms) => {
            let mut rest = Vec::new();
            for term in terms.iter() {
                let (coefficients, left) = as_written(term, symbols)?;
                parts.iter_mut().zip(coefficients).for_each(|(part, terms)| part.extend(terms));
                rest.extend(left);
            }
            Some((parts, rest))
        }
        Expr::Product(factors) => {
            let mut places = factors.iter().enumerate().filter(|(_, factor)| involved(factor));
            let (place, factor) = places.next()?;
            if places.next().is_some() {
                return None;
            }
            let (coefficients, rest) = as_written(factor, symbols)?;
            let with = |inner: Expr| {
                let others = factors.iter().enumerate();
                Expr::product(others.map(|(index, factor)| if index == place { inner.clone() } else { factor.clone() }))
            };
            let scale = |terms: Vec<Expr>| terms.into_iter().map(with).collect::<Vec<_>>();
            Some((coefficients.into_iter().map(scale).collect(), scale(rest)))
        }
        _ => None,
    }
}

fn after_algebra(expr: &Expr, symbols: &[Symbol]) -> Option<Linear> {
    let form = readable_form(expr, &none_positive)?;
    let involved = |atom: &Expr| symbols.iter().any(|symbol| atom.contains(*symbol));
    let hidden = |atom: &&Expr| involved(atom) && !matches!(atom, Expr::Symbol(_));
    if form.denominator.atoms().into_iter().any(involved) || form.numerator.atoms().iter().any(hidden) {
        return None;
    }
    let mut sums = vec![super::polynomial::Polynomial::default(); symbols.len() + 1];
    for (monomial, value) in form.numerator.terms() {
        let (involving, others) = monomial.partition(involved);
        let mut powers = involving.powers();
        let place = match (powers.next(), powers.next()) {
            (None, _) => symbols.len(),
            (Some((Expr::Symbol(written), 1)), None) => symbols.iter().position(|symbol| symbol == written)?,
            _ => return None,
        };
        let sum = sums.get_mut(place)?;
        *sum = sum.plus(&super::polynomial::Polynomial::term(value.clone(), others));
    }
    let read = |sum| Quotient::reduced(sum, &form.denominator).map(|form| vec![form.to_expr()]);
    let mut parts: Vec<_> = sums.iter().map(read).collect::<Option<_>>()?;
    let rest = parts.pop()?;
    Some((parts, rest))
}

#[cfg(test)]
mod tests {
    use super::super::super::testing::AnyName;
    use super::*;

    #[test]
    fn terms_read_as_a_person_writes_them() {
        for (text, expected) in [
            ("m_A*v_A - m_A*v_B", "m_A*(v_A - v_B)"),
            ("-m_A*(v_A - v_B)", "m_A*(v_B - v_A)"),
            ("(x^2 - 1)/(x - 1)", "1 + x"),
            ("x*(a+b)/(a^2 + 2*a*b + b^2)", "x/(a+b)"),
            (
                "(m_A*v_A + m_B*v_B - e*m_B*(v_A - v_B))/(m_A + m_B)",
                "(m_A*v_A + m_B*v_B - m_B*e*(v_A - v_B))/(m_A + m_B)",
            ),
            (
                "m_A*v_A^2/2 + m_B*v_B^2/2 - (m_A*v_A + m_B*v_B)^2/(2*(m_A + m_B))",
                "m_A*m_B*(v_A - v_B)^2/(2*(m_A + m_B))",
            ),
            ("x_0 + v_0*t + g*t^2/2", "x_0 + v_0*t + g*t^2/2"),
            ("sqrt(2*m*g*h/m)", "sqrt(2*g*h)"),
            ("sqrt(8)", "2*sqrt(2)"),
            ("sqrt(x)*sqrt(x)*x", "x^2"),
            ("sqrt((a-b)^2)", "abs(a-b)"),
            ("m*g/c*(1 - exp(-(c*t/m)))", "m*g*(1 - exp(-(c*t/m)))/c"),
            ("v*sin(a)^2 + v*cos(a)^2", "v"),
            ("v*sin(a)^2/2", "v*sin(a)^2/2"),
            ("sin(pi/6) + cos(pi) + sin(x + pi/2)", "cos(x) - 1/2"),
            ("e^(2*n)*e", "e*e^(2*n)"),
            ("0.7*v - v", "-0.3*v"),
            ("exp(ln(x)*2)", "x^2"),
        ] {
            let mut names = AnyName::default();
            // names come in the order of the expected text, so that products keep it
            let expected = names.term(expected);
            let term = names.term(text);
            assert_eq!(term.simplify().text(&names.0), expected.text(&names.0), "{text}");
            assert!(equal(&term, &expected), "{text}");
        }
    }

    #[test]
    fn what_is_positive_leaves_roots_and_bars() {
        let mut names = AnyName::default();
        let b = names.named("b");
        for (text, expected) in [
            ("sqrt(b^2)", "b"),
            ("abs(-2*b*x)", "2*b*abs(x)"),
            ("sqrt(b^2*x/4)", "b*sqrt(x)/2"),
            ("sqrt(x^2)", "abs(x)"),
        ] {
            let (term, expected) = (names.term(text), names.term(expected));
            assert_eq!(term.simplify_where(&|symbol| symbol == b), expected, "{text}");
        }
        for (left, right, always) in [
            ("sqrt(b^2)", "b", false),
            ("sqrt(b*x)", "sqrt(b)*sqrt(x)", false),
            ("ln(b/2) + x", "ln(b) + x - ln(2)", true),
            ("ln(b*x)", "ln(b) + ln(x)", false),
            ("sin(x + y)", "sin(x)*cos(y) + cos(x)*sin(y)", true),
            ("sin(2*x)", "2*sin(x)*cos(x)", true),
            ("cos(x)^2 - sin(x)^2", "cos(2*x)", true),
            ("sqrt(2)*sqrt(3)", "sqrt(6)", true),
            ("1/(sqrt(3) - sqrt(2))", "sqrt(3) + sqrt(2)", true),
            ("tan(asin(x))", "x/sqrt(1 - x^2)", true),
            ("exp(x + y)", "exp(x)*exp(y)", true),
            ("e^(n + 1)", "e*e^n", true),
            ("2/4", "0.5", true),
            ("atan2(2*b*x, b)", "atan2(2*x, 1)", false),
            ("atan2(-x, 1) + atan2(x, 1)", "0", true),
            ("acos(x) + asin(x)", "pi/2", true),
        ] {
            let (left, right) = (names.term(left), names.term(right));
            assert_eq!(equal(&left, &right), always, "{}", left.text(&names.0));
            assert!(
                super::super::super::equal_where(&left, &right, &|symbol| symbol == b || symbol.index() == 1),
                "{}",
                left.text(&names.0)
            );
        }
        for (left, right) in [("x", "y"), ("sqrt(x^2)", "x"), ("sin(x)", "sin(2*x)"), ("1/0.5", "0.5")] {
            assert!(!equal(&names.term(left), &names.term(right)), "{left}");
        }
    }

    #[test]
    fn coefficients_stay_as_written() {
        for (text, unknowns, expected, rest) in [
            ("m_A*v_A2 + m_B*v_B2 - m_A*v_A1", vec!["v_A2", "v_B2"], vec!["m_A", "m_B"], "-m_A*v_A1"),
            ("v_B2 - v_A2 - e*(v_A1 - v_B1)", vec!["v_A2", "v_B2"], vec!["-1", "1"], "-e*(v_A1 - v_B1)"),
            ("m*(v - u) - J", vec!["v", "J"], vec!["m", "-1"], "-m*u - J + J"),
            ("v - v + a", vec!["v"], vec!["0"], "a"),
            ("(x^2 - 1)/(x - 1) + a*x", vec!["x"], vec!["1 + a"], "1"),
        ] {
            let mut names = AnyName::default();
            let term = names.term(text);
            let symbols: Vec<_> = unknowns.iter().map(|name| names.named(name)).collect();
            let Some((coefficients, found)) = term.linear_coefficients(&symbols) else { panic!("{text} is linear") };
            let texts: Vec<_> = coefficients.iter().map(|part| part.text(&names.0)).collect();
            assert_eq!(texts, expected, "{text}");
            assert!(equal(&found, &names.term(rest)), "{text}");
        }
        let mut names = AnyName::default();
        let (x, y) = (names.named("x"), names.named("y"));
        for text in ["x*y", "x^2", "sin(x)", "1/x", "sqrt(x) + y"] {
            assert!(names.term(text).linear_coefficients(&[x, y]).is_none(), "{text}");
        }
    }

    #[test]
    fn numerators_are_polynomials_in_a_symbol() {
        for (text, expected) in [
            ("a*x^2/2 + b*x - c", Some(vec!["-c", "b", "a/2"])),
            ("(x + 1)*(x - 1)/y", Some(vec!["-1", "0", "1"])),
            ("a/x - b", Some(vec!["a", "-b"])),
            ("a", Some(vec!["a"])),
            ("sin(x) + x", None),
            ("e^x", None),
        ] {
            let mut names = AnyName::default();
            let (x, term) = (names.named("x"), names.term(text));
            let found = term.collect(x);
            let texts = found.map(|(parts, _)| parts.iter().map(|part| part.text(&names.0)).collect::<Vec<_>>());
            assert_eq!(texts, expected.map(|parts| parts.into_iter().map(str::to_owned).collect()), "{text}");
        }
    }
}
