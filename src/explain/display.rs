//! How a quantity is shown in an explanation: its symbol, its number, its unit.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::sync::Arc;

use crate::expr::Expr;
use crate::expr::Function;
use crate::expr::Leaf;
use crate::expr::LeafKind;
use crate::expr::Math;
use crate::expr::Operator;
use crate::expr::Symbol;
use crate::problem::AskedUnit;
use crate::problem::NumberPart;
use crate::problem::Worked;
use crate::quantity::Decimal;
use crate::quantity::Dimension;
use crate::quantity::Printed;
use crate::quantity::Unit;
use crate::quantity::coherent_unit;

use super::algebra::has_angle_of_point;
use super::term::Measured;
use super::term::Term;
use super::term::suffix;
use super::way::Manner;
use super::way::Way;

/// Figures of intermediate values.
const INTERMEDIATE: usize = 4;

/// The share of its terms below which a sum is nothing but their rounding.
const DUST: f64 = 1e-13;

/// The most digits of a given that was converted to another unit.
const MOST_DIGITS: usize = 8;

/// Units of the same size as a product of base units in which quantities are usually printed, by the beginnings of names.
const USUAL: [(&str, &str); 4] = [("J_", "N s"), ("I_", "N s"), ("M_", "N m"), ("omega", "rad/s")];

/// Shows the quantities of one variant.
#[derive(Clone, Copy)]
pub(super) struct Display<'a> {
    pub worked: Worked<'a>,
    /// What it shares with the other variants that go its way.
    pub way: &'a Way,
    /// What was shown before.
    pub shown: &'a Shown,
}

/// The quantities of a variant as they are printed, each to so many figures, since a solution shows most of them many times.
#[derive(Clone, Debug, Default)]
pub(super) struct Shown(RefCell<Vec<(Symbol, usize, Leaf)>>);

impl<'a> Display<'a> {
    /// Quantities that are shown by their symbols only, since they may have any value.
    pub(super) fn free(self) -> &'a BTreeSet<Symbol> {
        self.way.free.get_or_init(|| self.worked.free())
    }

    /// Whether a quantity is shown by its symbol only.
    pub(super) fn is_free(self, symbol: Symbol) -> bool {
        self.free().contains(&symbol)
    }

    /// The unit in which explanations compute with a quantity: the system's own, degrees for angles.
    pub(super) fn unit(self, symbol: Symbol) -> &'a Unit {
        &self.manner(symbol).measured.unit
    }

    /// How a quantity is shown.
    pub(super) fn manner(self, symbol: Symbol) -> &'a Manner {
        // There is a place for every symbol of the model.
        self.way.manners[symbol.index()].get_or_init(|| {
            let problem = self.worked.problem;
            let unit = self.unit_chosen(symbol);
            let mut numbers = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
            let is_literal = problem.model().literals.iter().any(|(own, _)| *own == symbol);
            Manner {
                measured: Measured::new(unit),
                name: (!is_literal).then(|| problem.math_of(symbol)),
                senses: problem.senses(symbol),
                is_whole: numbers.any(|number| number.whole && number.symbol == symbol),
            }
        })
    }

    fn unit_chosen(self, symbol: Symbol) -> Unit {
        let problem = self.worked.problem;
        let entry = problem.model().symbols.entry(symbol);
        if entry.dimension == Dimension::NONE {
            return problem.unit_given(symbol).filter(|unit| unit.factor().pi != 0).unwrap_or_else(|| {
                if is_angle(&entry.name) { Unit::parse("deg").unwrap_or_default() } else { Unit::none() }
            });
        }
        let coherent = coherent_unit(entry.dimension, problem.units());
        let spoken_of = problem.unit_given(symbol).or_else(|| self.asked_unit(symbol));
        let usual = USUAL.iter().filter(|(start, _)| entry.name.starts_with(start));
        let usual = usual.filter_map(|(_, unit)| Unit::parse(unit).ok());
        let mut candidates = spoken_of.into_iter().flat_map(|unit| [unit.without_prefixes(), unit]).chain(usual);
        let same = |unit: &Unit| unit.dimension() == entry.dimension && unit.factor() == coherent.factor();
        candidates.find(same).unwrap_or(coherent)
    }

    /// The unit in which a quantity is asked.
    fn asked_unit(self, symbol: Symbol) -> Option<Unit> {
        let mut numbers = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
        numbers.find_map(|number| match number {
            NumberPart { symbol: own, unit: AskedUnit::Unit(unit), .. } if *own == symbol => Some(unit.clone()),
            _ => None,
        })
    }

    /// The unit of a term, from its dimension.
    pub(super) fn unit_of(self, expr: &Expr) -> Unit {
        let problem = self.worked.problem;
        let dimension = expr.dimension(&problem.model().symbols).unwrap_or_default();
        coherent_unit(dimension, problem.units())
    }

    /// A value in its display unit with so many figures, as it stands for its quantity in a term.
    fn leaf(self, symbol: Symbol, figures: usize) -> Leaf {
        let known = |(own, to, _): &&(Symbol, usize, Leaf)| *own == symbol && *to == figures;
        if let Some((.., leaf)) = self.shown.0.borrow().iter().find(known) {
            return leaf.clone();
        }
        let number = self.number(symbol, figures);
        let kind = LeafKind::Number { negative: number.starts_with('-') };
        let math = self.manner(symbol).measured.put(number_math(number));
        let leaf = Leaf { math: math.shared(), kind };
        self.shown.0.borrow_mut().push((symbol, figures, leaf.clone()));
        leaf
    }

    /// A value in its display unit, as it is printed with so many figures; `?` where it has none.
    fn number(self, symbol: Symbol, figures: usize) -> String {
        let manner = self.manner(symbol);
        let mut told = self.worked.variant.all_given().iter();
        if let Some((_, value, given)) = told.find(|(own, ..)| *own == symbol) {
            if *given == manner.measured.unit {
                return Printed::written(value).plain();
            }
            if !manner.is_whole
                && let Some(exact) = converted(value, given, &manner.measured.unit)
            {
                return exact;
            }
        }
        let Some(value) = self.worked.variant.value(symbol) else { return "?".into() };
        if manner.is_whole {
            format!("{:.0}", value.value)
        } else {
            printed(value.for_print() / manner.measured.size, figures)
        }
    }

    /// The number and its unit, to so many figures.
    pub(super) fn quantity_to(self, symbol: Symbol, figures: usize) -> Math {
        self.leaf(symbol, figures).math
    }

    /// Whether a term has a value of its own.
    pub(super) fn has_value(self, expr: &Expr) -> bool {
        expr.all_symbols(&|symbol| self.has_number(symbol))
    }

    /// Whether a quantity is shown by a number.
    pub(super) fn has_number(self, symbol: Symbol) -> bool {
        !self.is_free(symbol) && self.worked.variant.value(symbol).is_some()
    }

    /// The number and its unit, to the figures of an intermediate value.
    pub(super) fn quantity(self, symbol: Symbol) -> Math {
        self.quantity_to(symbol, INTERMEDIATE)
    }

    /// The symbol itself; a value that the author wrote into a term is shown as that value.
    pub(super) fn name(self, symbol: Symbol) -> Math {
        self.manner(symbol).name.clone().unwrap_or_else(|| self.quantity(symbol))
    }

    /// The symbol itself, or the author's value, as it stands in a term.
    fn named(self, symbol: Symbol) -> Leaf {
        match &self.manner(symbol).name {
            Some(name) => Leaf { math: name.clone(), kind: LeafKind::Name },
            None => self.leaf(symbol, INTERMEDIATE),
        }
    }

    /// A number where the quantity has one, else the symbol.
    fn put_in(self, symbol: Symbol) -> Leaf {
        if !self.is_free(symbol) {
            return self.leaf(symbol, INTERMEDIATE);
        }
        Leaf { math: self.name(symbol), kind: LeafKind::Name }
    }

    /// A term in symbols.
    pub(super) fn symbolic(self, expr: &Expr) -> Math {
        expr.layout(&|symbol| self.named(symbol))
    }

    /// A term that many solutions show, in symbols and ready for numbers.
    pub(super) fn term(self, expr: Expr) -> Term {
        let arranged = expr.arranged();
        Term {
            symbols: arranged.with(&|symbol| self.named(symbol)).shared(),
            unit: Measured::new(self.unit_of(&expr)),
            mentions: expr.symbols().into_iter().collect(),
            has_angle: has_angle_of_point(&expr),
            arranged,
            expr,
        }
    }

    /// A term in which every quantity given piece by piece is replaced by the piece that holds for this variant.
    pub(super) fn resolved(self, expr: &Expr) -> Expr {
        let Expr::Piecewise(piecewise) = expr else {
            return if has_pieces(expr) { expr.map_children(|part| self.resolved(part)) } else { expr.clone() };
        };
        let at = self.value_of(&piecewise.variable);
        let holds = |until: &Option<Expr>| until.as_ref().is_none_or(|until| at <= self.value_of(until));
        let piece = piecewise.pieces.iter().find(|(until, _)| holds(until)).or(piecewise.pieces.last());
        piece.map_or_else(|| expr.clone(), |(_, value)| self.resolved(value))
    }

    /// The condition under which the piece that holds for this variant does so; `None` for a term without pieces.
    pub(super) fn piece_that_holds(self, expr: &Expr) -> Option<Math> {
        let Expr::Piecewise(piecewise) = expr else {
            return expr.children().find_map(|part| self.piece_that_holds(part));
        };
        let at = self.value_of(&piecewise.variable);
        let mut passed: Option<&Expr> = None;
        for (until, _) in &piecewise.pieces {
            let Some(until) = until else { break };
            if at <= self.value_of(until) {
                return Some(Math::relation(
                    self.symbolic(&piecewise.variable),
                    Operator::AtMost,
                    self.symbolic(until),
                ));
            }
            passed = Some(until);
        }
        passed.map(|until| Math::relation(self.symbolic(&piecewise.variable), Operator::Greater, self.symbolic(until)))
    }

    /// A term with numbers and units in place of its symbols.
    pub(super) fn substituted(self, term: &Term) -> Math {
        term.arranged.with(&|symbol| self.put_in(symbol))
    }

    /// A term's value in a unit, to so many figures.
    pub(super) fn evaluated(self, expr: &Expr, unit: &Measured, figures: usize) -> Math {
        if let Expr::Symbol(symbol) = expr
            && self.unit(*symbol) == &unit.unit
        {
            return self.quantity_to(*symbol, figures);
        }
        // The last bits of a sum are not known: what may lie half-way between two printed numbers is rounded up.
        let value = self.value_of(expr) * (1.0 + 4.0 * f64::EPSILON) / unit.size;
        unit.put(number_math(printed(value, figures)))
    }

    /// A number in the unit in which a part asks it; none where that is a quantity.
    pub(super) fn in_unit_of(self, number: &NumberPart, value: Math) -> Math {
        let own = &self.manner(number.symbol).measured;
        match &number.unit {
            AskedUnit::Unit(unit) if *unit == own.unit => own.put(value),
            AskedUnit::Unit(unit) => with_unit(value, unit),
            AskedUnit::InTermsOf(_) => value,
        }
    }

    /// A term's value in SI units; a sum whose terms cancel but for their rounding is zero.
    pub(super) fn value_of(self, expr: &Expr) -> f64 {
        let value = |expr: &Expr| {
            expr.evaluate(&|symbol| self.worked.variant.value(symbol).map_or(f64::NAN, |value| value.value))
        };
        let whole = value(expr);
        match expr {
            Expr::Sum(terms) if whole.abs() < DUST * terms.iter().map(|term| value(term).abs()).sum::<f64>() => 0.0,
            _ => whole,
        }
    }

    /// Whether a term holds the angle of a point that a calculator's arctangent does not give for this variant: its
    /// denominator is negative or zero.
    pub(super) fn is_outside_arctangent(self, expr: &Expr) -> bool {
        let denominator = match expr {
            Expr::Apply(Function::Atan2, _) => expr.children().nth(1),
            _ => None,
        };
        denominator.is_some_and(|x| self.value_of(x) <= 0.0)
            || expr.children().any(|part| self.is_outside_arctangent(part))
    }

    /// `left = right`, in symbols.
    pub(super) fn equation(self, left: &Expr, right: &Expr) -> Math {
        Math::relation(self.symbolic(left), Operator::Equals, self.symbolic(right))
    }
}

/// Whether a part of a term is given piece by piece.
pub(super) fn has_pieces(expr: &Expr) -> bool {
    matches!(expr, Expr::Piecewise(_)) || expr.children().any(has_pieces)
}

/// A given in another unit, where the conversion is exact and short: 360 g is 0.36 kg, and 36.0 km/h is 10.0 m/s.
fn converted(value: &Decimal, given: &Unit, unit: &Unit) -> Option<String> {
    let (from, to) = (given.factor(), unit.factor());
    let exact = value.to_rational() * from.rational / to.rational;
    let figures = (value.least_figures()..=MOST_DIGITS).filter(|_| from.pi == to.pi);
    let printed = figures.map(|figures| Printed::exact(&exact, figures));
    let mut fitting = printed.filter(|printed| printed.to_decimal().to_rational() == exact);
    fitting.next().map(|printed| printed.plain())
}

/// A number followed by its unit.
pub(super) fn with_unit(number: Math, unit: &Unit) -> Math {
    match suffix(unit) {
        Some(suffix) => Math::Row(vec![number, suffix]),
        None => number,
    }
}

/// A printed number as mathematics, powers of ten included.
pub(super) fn number_math(text: String) -> Math {
    if text.is_ascii() {
        return Math::Number(text);
    }
    match text.split_once(" × 10^") {
        Some((mantissa, exponent)) => {
            let ten = Math::Sup(Arc::new(Math::Number("10".into())), Arc::new(Math::Number(exponent.into())));
            Math::Row(vec![Math::Number(mantissa.into()), Math::Operator(Operator::Times), ten])
        }
        None => Math::Number(text.replace('\u{2212}', "-")),
    }
}

/// A value to so many figures, as plain text.
pub(super) fn printed(value: f64, figures: usize) -> String {
    Printed::new(value, figures).map_or_else(|| "?".into(), |printed| printed.plain())
}

fn is_angle(name: &str) -> bool {
    name.starts_with("angle") || ["alpha", "beta", "theta", "phi", "psi"].iter().any(|greek| name.starts_with(greek))
}
