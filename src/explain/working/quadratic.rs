//! A quadratic equation as it is solved on paper: in symbols, with numbers, by the formula, both roots.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_solve::Move;
use momentous_solve::Step;
use momentous_solve::quadratic_formula;

use super::super::Block;
use super::super::Inline;
use super::super::terms::algebra::positive_first;
use super::super::terms::display::Display;
use super::super::terms::display::number_math;
use super::super::terms::display::printed;
use super::super::terms::entry::Item;
use super::super::terms::ledger::Ledger;
use super::super::terms::term::Measured;
use super::super::wording::join;

/// One coefficient: its value in its unit, the unit, its size, and the figures to which it is printed.
struct Coefficient {
    value: f64,
    unit: Arc<Measured>,
    size: f64,
    figures: usize,
}

impl Coefficient {
    fn new(display: Display<'_>, term: &Expr, item: Item) -> Self {
        let (unit, _) = display.measure(term);
        let size = display.size(&unit);
        let value = display.value_of(term) / size;
        Self { value, unit: Arc::new(unit), size, figures: display.figures(item, value) }
    }

    fn unsigned(&self) -> Math {
        self.unit.put(number_math(printed(self.value.abs(), self.figures)))
    }

    fn signed(&self) -> Math {
        self.unit.put(number_math(printed(self.value, self.figures)))
    }

    fn turned(&self) -> Self {
        Self { value: -self.value, unit: Arc::clone(&self.unit), ..*self }
    }

    fn bracketed(&self) -> Math {
        Math::Bracketed(Arc::new(self.signed()))
    }
}

/// A root as the formula for quadratic equations gives it.
pub(crate) struct Taught {
    pub value: Expr,
    /// The coefficient of the square, by which was divided.
    pub leading: Expr,
}

/// The root of that place of a step whose unknown is found from a quadratic equation; `formula` is how it is computed.
pub(crate) fn root(step: &Step, unknown: Symbol, place: usize, formula: &Expr) -> Option<Taught> {
    step.moves.iter().find_map(|step_move| match step_move {
        Move::Quadratic { unknown: squared, a, b, c, .. } if *squared == unknown => {
            let [plus, minus] = quadratic_formula([a, b, c]);
            let taught = if place == 0 { plus } else { minus };
            let value = if c.is_zero() { formula.clone() } else { taught };
            Some(Taught { value, leading: a.clone() })
        }
        _ => None,
    })
}

/// The equation with the numbers of its coefficients, and its roots; `None` where a coefficient has no value.
pub(crate) fn solution(display: Display<'_>, unknown: Symbol, coefficients: [&Expr; 3]) -> Option<Vec<Block>> {
    let terms = with_plain_square(coefficients);
    if display.is_free(unknown) {
        return Some(without_zeros(display, unknown, terms));
    }
    if !terms.iter().all(|term| display.has_value(term)) {
        return None;
    }
    let [a, b, c] = [0, 1, 2].map(|place| Coefficient::new(display, &terms[place], Item::Coefficient(unknown, place)));
    let name = display.name(unknown);
    let square = display.symbolic(&Expr::from(unknown).powi(2));
    let formula = match (b.value == 0.0, c.value == 0.0) {
        (true, false) => pure_root(&a, &c),
        (false, true) => quotient(&b, &a),
        _ => formula(&a, &b, &c),
    };
    let lines = vec![
        Math::relation(name.clone(), Operator::Equals, formula),
        Math::Row(vec![Math::Operator(Operator::Equals), roots(display, unknown, [&a, &b, &c])?]),
    ];
    Some(vec![
        Block::text("With numbers:"),
        Block::Equation { lines: vec![with_numbers([&square, &name], Some(&a), [&b, &c])], number: None },
        Block::Equation { lines, number: None },
    ])
}

/// How a short solution solves a quadratic equation.
pub(crate) enum Short {
    /// By this root, since nothing is linear in the unknown.
    Root(Expr),
    /// By the equation with these coefficients as numbers.
    Equation([Expr; 3]),
}

/// How a quadratic equation is solved in short; nothing where a coefficient has no value.
pub(crate) fn short(display: Display<'_>, unknown: Symbol, coefficients: [&Expr; 3]) -> Option<Short> {
    let [a, b, c] = with_plain_square(coefficients);
    if display.is_free(unknown) || ![&a, &b, &c].into_iter().all(|term| display.has_value(term)) {
        return None;
    }
    let over_a = |term: &Expr| (term.clone() / a.clone()).simplify();
    if display.value_of(&b) == 0.0 {
        let size = (-over_a(&c)).simplify().power(Expr::ratio(1, 2));
        let is_negative = display.value_of(&unknown.into()) < 0.0;
        return Some(Short::Root(positive_first(&if is_negative { -size } else { size })));
    }
    // A mass, which means nothing in the equation, is divided out.
    let dimension = a.dimension(&display.worked.problem.model().symbols);
    let has_mass = dimension.is_ok_and(|dimension| dimension.mass != 0);
    let coefficients = if has_mass { [Expr::one(), over_a(&b), over_a(&c)] } else { [a, b, c] };
    Some(Short::Equation(coefficients))
}

/// The equation with the numbers of its coefficients, and both its values.
pub(super) fn in_numbers(display: Display<'_>, unknown: Symbol, terms: &[Expr; 3]) -> Option<[Math; 2]> {
    let [a, b, c] = [0, 1, 2].map(|place| Coefficient::new(display, &terms[place], Item::Coefficient(unknown, place)));
    let name = display.name(unknown);
    let square = display.symbolic(&Expr::from(unknown).powi(2));
    let values = Math::relation(name.clone(), Operator::Equals, roots(display, unknown, [&a, &b, &c])?);
    let leading = (!terms[0].is_one()).then_some(&a);
    let equation =
        if c.value == 0.0 { factored(&name, leading, &b) } else { with_numbers([&square, &name], leading, [&b, &c]) };
    Some([equation, values])
}

/// The coefficients, their signs changed where that of the square begins with a minus: as the equation is written.
fn with_plain_square(coefficients: [&Expr; 3]) -> [Expr; 3] {
    let turns = coefficients[0].begins_with_minus();
    coefficients.map(|term| if turns { (-term.clone()).simplify() } else { term.clone() })
}

/// Enters the coefficients and the roots into the ledger of a solution.
pub(crate) fn enter(display: Display<'_>, ledger: &mut Ledger, unknown: Symbol, coefficients: [&Expr; 3]) {
    let terms = with_plain_square(coefficients);
    if !terms.iter().all(|term| display.has_value(term)) {
        return;
    }
    for (place, term) in terms.iter().enumerate() {
        let unit = display.size(&display.measure(term).0);
        display.enter_value(ledger, term, unit, Item::Coefficient(unknown, place));
    }
    let [a, b, c] = terms.each_ref().map(|term| display.value_of(term));
    let Some(taken) = display.worked.variant.value(unknown).map(|value| value.value) else { return };
    let other = other_root([a, b, c], taken);
    display.enter(ledger, unknown);
    let unit = display.size(&display.manner(unknown).measured);
    display.enter_rounded(ledger, Item::OtherRoot(unknown), other, unit);
    ledger.root(unknown, taken >= other, Item::Quantity(unknown));
    ledger.root(unknown, other > taken, Item::OtherRoot(unknown));
}

/// By Vieta: the product of the roots tells the other one without a difference of almost equal numbers.
fn other_root([a, b, c]: [f64; 3], taken: f64) -> f64 {
    if taken == 0.0 { -b / a } else { c / a / taken }
}

/// The equation in symbols once more, what is given as zero left out; nothing where that is nothing new.
fn without_zeros(display: Display<'_>, unknown: Symbol, coefficients: [Expr; 3]) -> Vec<Block> {
    let values = display.worked.alphabet().values;
    let zero: Vec<Symbol> = coefficients
        .iter()
        .flat_map(Expr::symbols)
        .filter(|symbol| values.get(symbol).is_some_and(Expr::is_zero))
        .collect();
    if zero.is_empty() {
        return Vec::new();
    }
    let is_zero = |symbol| zero.contains(&symbol).then(Expr::zero);
    let [a, b, c] = coefficients.map(|term| term.substitute(&is_zero).simplify());
    let x = Expr::from(unknown);
    let left = Expr::sum([a * x.clone().powi(2), b * x, c]);
    let mut named: Vec<Vec<Inline>> = Vec::new();
    for (place, symbol) in zero.iter().enumerate() {
        if !zero[..place].contains(symbol) {
            named.push(vec![Inline::Math(display.equation(&(*symbol).into(), &Expr::zero()))]);
        }
    }
    let words = [vec![Inline::Text("With ".into())], join(named), vec![Inline::Text(":".into())]].concat();
    vec![
        Block::Paragraph(words),
        Block::Equation { lines: vec![display.equation(&positive_first(&left), &Expr::zero())], number: None },
    ]
}

/// `+-sqrt(c/a)` with numbers, the root where nothing is linear in the unknown.
fn pure_root(a: &Coefficient, c: &Coefficient) -> Math {
    let fraction = Math::Fraction(Arc::new(c.turned().signed()), Arc::new(a.signed()));
    Math::Row(vec![Math::Operator(Operator::PlusMinus), Math::Root(Arc::new(fraction))])
}

/// `-b/a` with numbers, the root that is not zero where nothing stands without the unknown.
fn quotient(b: &Coefficient, a: &Coefficient) -> Math {
    let fraction = Math::Fraction(Arc::new(b.turned().signed()), Arc::new(a.signed()));
    Math::Row(vec![fraction, Math::Text(" or ".into()), Math::Number("0".into())])
}

/// `(18.9 kg) v^2 - (43.47 kg m/s) v + 10.90 J = 0`, the square by itself where it has no coefficient.
fn with_numbers([square, name]: [&Math; 2], a: Option<&Coefficient>, [b, c]: [&Coefficient; 2]) -> Math {
    let space = Math::Operator(Operator::Juxtapose);
    let sign = |value: f64| Math::Operator(if value < 0.0 { Operator::Minus } else { Operator::Plus });
    let mut parts: Vec<Math> =
        a.into_iter().flat_map(|a| [a.bracketed(), space.clone()]).chain([square.clone()]).collect();
    if b.value != 0.0 {
        parts.extend([sign(b.value), Math::Bracketed(Arc::new(b.unsigned())), space, name.clone()]);
    }
    if c.value != 0.0 {
        parts.extend([sign(c.value), c.unsigned()]);
    }
    parts.extend([Math::Operator(Operator::Equals), Math::Number("0".into())]);
    Math::Row(parts)
}

/// `v [v - 1.76 m/s] = 0`, where nothing stands without the unknown.
fn factored(name: &Math, a: Option<&Coefficient>, b: &Coefficient) -> Math {
    let space = Math::Operator(Operator::Juxtapose);
    let sign = Math::Operator(if b.value < 0.0 { Operator::Minus } else { Operator::Plus });
    let linear: Vec<Math> =
        a.into_iter().flat_map(|a| [a.bracketed(), space.clone()]).chain([name.clone(), sign, b.unsigned()]).collect();
    let row = vec![name.clone(), space, Math::Squared(Arc::new(Math::Row(linear))), Math::Operator(Operator::Equals)];
    Math::Row(row.into_iter().chain([Math::Number("0".into())]).collect())
}

/// `(-b +- sqrt(b^2 - 4 a c)) / (2 a)` with numbers.
fn formula(a: &Coefficient, b: &Coefficient, c: &Coefficient) -> Math {
    let square = Math::Sup(Arc::new(b.bracketed()), Arc::new(Math::Number("2".into())));
    let product = [Math::Number("4".into()), a.bracketed(), c.bracketed()];
    let inside = [vec![square, Math::Operator(Operator::Minus)], product.to_vec()].concat();
    let root = Math::Root(Arc::new(Math::Row(inside)));
    let above = Math::Row(vec![b.turned().signed(), Math::Operator(Operator::PlusMinus), root]);
    let below = Math::Row(vec![Math::Number("2".into()), a.bracketed()]);
    Math::Fraction(Arc::new(above), Arc::new(below))
}

/// The value taken, and the other.
fn roots(display: Display<'_>, unknown: Symbol, coefficients: [&Coefficient; 3]) -> Option<Math> {
    let unit = &display.manner(unknown).measured;
    let taken = display.worked.variant.value(unknown)?.value;
    let in_si = coefficients.map(|coefficient| coefficient.value * coefficient.size);
    let other = other_root(in_si, taken) / display.size(unit);
    let other = printed(other, display.figures(Item::OtherRoot(unknown), other));
    let other = unit.put(number_math(other));
    Some(Math::Row(vec![display.quantity(unknown), Math::Text(" or ".into()), other]))
}
