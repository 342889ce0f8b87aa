//! A quadratic equation as it is solved on paper: in symbols, with numbers, by the formula, both roots.

use std::sync::Arc;

use crate::expr::Expr;
use crate::expr::Math;
use crate::expr::Operator;
use crate::expr::Symbol;
use crate::quantity::Unit;

use super::Block;
use super::Inline;
use super::algebra::positive_first;
use super::display::Display;
use super::display::number_math;
use super::display::printed;
use super::display::with_unit;

/// One coefficient: its value in its unit, the unit, and the figures to which it is printed.
struct Coefficient {
    value: f64,
    unit: Unit,
    figures: usize,
}

impl Coefficient {
    fn new(display: Display<'_>, term: &Expr, figures: usize) -> Self {
        let unit = display.unit_of(term);
        Self { value: display.value_of(term) / unit.factor().to_f64(), unit, figures }
    }

    fn size(&self) -> Math {
        with_unit(number_math(printed(self.value.abs(), self.figures)), &self.unit)
    }

    fn signed(&self) -> Math {
        with_unit(number_math(printed(self.value, self.figures)), &self.unit)
    }

    fn bracketed(&self) -> Math {
        Math::Bracketed(Arc::new(self.signed()))
    }
}

/// The equation with those coefficients and its roots; `None` where a coefficient has no value.
pub(super) fn solution(
    display: Display<'_>,
    unknown: Symbol,
    [a, b, c]: [&Expr; 3],
    figures: usize,
) -> Option<Vec<Block>> {
    if display.is_free(unknown) {
        return Some(in_symbols(display, unknown, [a, b, c]));
    }
    if ![a, b, c].into_iter().all(|term| display.has_value(term)) {
        return None;
    }
    let reversed = display.value_of(a) < 0.0;
    let terms = [a, b, c].map(|term| if reversed { (-term.clone()).simplify() } else { term.clone() });
    let [a, b, c] = terms.each_ref().map(|term| Coefficient::new(display, term, figures));
    let x = Expr::from(unknown);
    let [square, linear, rest] = terms;
    let left = Expr::sum([square * x.clone().powi(2), linear * x.clone(), rest]);
    let name = display.name(unknown);
    let lines = vec![
        Math::relation(name.clone(), Operator::Equals, formula(&a, &b, &c)),
        Math::Row(vec![Math::Operator(Operator::Equals), roots(display, unknown, [&a, &b, &c], figures)?]),
    ];
    Some(vec![
        Block::Paragraph(vec![
            Inline::Text("This is a quadratic equation in ".into()),
            Inline::Math(name.clone()),
            Inline::Text(":".into()),
        ]),
        Block::Equation { lines: vec![display.equation(&left, &Expr::zero())], number: None },
        Block::Equation { lines: vec![with_numbers([&display.symbolic(&x.powi(2)), &name], &a, &b, &c)], number: None },
        Block::Equation { lines, number: None },
    ])
}

/// The equation without numbers, what is given as zero left out.
fn in_symbols(display: Display<'_>, unknown: Symbol, coefficients: [&Expr; 3]) -> Vec<Block> {
    let values = display.worked.alphabet().values;
    let [a, b, c] = coefficients.map(|term| term.substitute(&|own| values.get(&own).cloned()).simplify());
    let x = Expr::from(unknown);
    let left = Expr::sum([a * x.clone().powi(2), b * x, c]);
    vec![
        Block::Paragraph(vec![
            Inline::Text("This is a quadratic equation in ".into()),
            Inline::Math(display.name(unknown)),
            Inline::Text(":".into()),
        ]),
        Block::Equation { lines: vec![display.equation(&positive_first(&left), &Expr::zero())], number: None },
    ]
}

/// `(18.9 kg) v^2 - (43.47 kg m/s) v + 10.90 J = 0`.
fn with_numbers([square, name]: [&Math; 2], a: &Coefficient, b: &Coefficient, c: &Coefficient) -> Math {
    let space = Math::Operator(Operator::Juxtapose);
    let sign = |value: f64| Math::Operator(if value < 0.0 { Operator::Minus } else { Operator::Plus });
    let mut parts = vec![Math::Bracketed(Arc::new(a.size())), space.clone(), square.clone()];
    if b.value != 0.0 {
        parts.extend([sign(b.value), Math::Bracketed(Arc::new(b.size())), space, name.clone()]);
    }
    if c.value != 0.0 {
        parts.extend([sign(c.value), c.size()]);
    }
    parts.extend([Math::Operator(Operator::Equals), Math::Number("0".into())]);
    Math::Row(parts)
}

/// `(-b +- sqrt(b^2 - 4 a c)) / (2 a)` with numbers.
fn formula(a: &Coefficient, b: &Coefficient, c: &Coefficient) -> Math {
    let square = Math::Sup(Arc::new(b.bracketed()), Arc::new(Math::Number("2".into())));
    let product = [Math::Number("4".into()), a.bracketed(), c.bracketed()];
    let inside = [vec![square, Math::Operator(Operator::Minus)], product.to_vec()].concat();
    let root = Math::Root(Arc::new(Math::Row(inside)));
    let minus_b = Coefficient { value: -b.value, unit: b.unit.clone(), figures: b.figures };
    let above = Math::Row(vec![minus_b.signed(), Math::Operator(Operator::PlusMinus), root]);
    let below = Math::Row(vec![Math::Number("2".into()), a.bracketed()]);
    Math::Fraction(Arc::new(above), Arc::new(below))
}

/// The value taken, and the other.
fn roots(display: Display<'_>, unknown: Symbol, [a, b, c]: [&Coefficient; 3], figures: usize) -> Option<Math> {
    let unit = display.unit(unknown);
    let taken = display.worked.variant.value(unknown)?.value;
    let scale = a.unit.factor().to_f64();
    let sum = -(b.value * b.unit.factor().to_f64()) / (a.value * scale);
    let product = c.value * c.unit.factor().to_f64() / (a.value * scale);
    // By Vieta: the product of the roots tells the other one without a difference of almost equal numbers.
    let other = if taken == 0.0 { sum } else { product / taken };
    let shown = |value: f64| with_unit(number_math(printed(value / unit.factor().to_f64(), figures)), unit);
    Some(Math::Row(vec![display.quantity_to(unknown, figures), Math::Text(" or ".into()), shown(other)]))
}
