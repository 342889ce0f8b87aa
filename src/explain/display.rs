//! How a quantity is shown in an explanation: its symbol, its number, its unit.

use std::cell::OnceCell;
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
use crate::quantity::Dimension;
use crate::quantity::Printed;
use crate::quantity::Unit;
use crate::quantity::coherent_unit;
use crate::solve::Bounded;
use crate::solve::Closed;
use crate::solve::Root;
use crate::solve::Step;

use super::algebra::has_angle_of_point;
use super::ledger::Figures;
use super::term::Measured;
use super::term::Term;
use super::term::suffix;
use super::way::Manner;
use super::way::Way;

/// The most characters above or below the bar of a fraction that is printed as such.
const SHORT_FRACTION: usize = 4;

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

/// The quantities of a variant as they are printed, since a solution shows most of them many times.
#[derive(Clone, Debug, Default)]
pub(super) struct Shown {
    pub leaves: RefCell<Vec<(Symbol, Leaf)>>,
    /// To how many figures, once all lines are known.
    pub figures: OnceCell<Figures>,
}

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
                equals: self.equal(symbol),
                constant: self.constant(symbol),
            }
        })
    }

    /// The formula of what a step finds in one way only.
    fn formula(self, symbol: Symbol) -> Option<&'a Expr> {
        let mut steps = self.worked.leaf().answer_steps().iter();
        let root = |step: &'a Step| match &step.roots[..] {
            [Root { values }] => values.iter().find(|(own, _)| *own == symbol),
            _ => None,
        };
        match steps.find_map(root)? {
            (_, Closed::Formula(formula)) => Some(formula),
            _ => None,
        }
    }

    /// A pure number that a step finds to be a plain fraction, whatever is drawn: 1/3.
    fn constant(self, symbol: Symbol) -> Option<Math> {
        let is_pure = self.worked.problem.model().symbols.entry(symbol).dimension == Dimension::NONE;
        let formula = self.formula(symbol).filter(|_| is_pure)?;
        let number = formula.as_number().filter(|number| !number.is_zero())?;
        let short = |size: &str| size.len() <= SHORT_FRACTION;
        let is_short = short(&number.numerator().to_string()) && short(&number.denominator().to_string());
        is_short.then(|| self.symbolic(formula))
    }

    /// The quantity that another one equals, and whether with the other sign.
    fn equal(self, symbol: Symbol) -> Option<(Symbol, bool)> {
        match self.formula(symbol)? {
            Expr::Symbol(other) => Some((*other, false)),
            Expr::Product(factors) => match &factors[..] {
                [sign, Expr::Symbol(other)] if *sign == Expr::integer(-1) => Some((*other, true)),
                _ => None,
            },
            _ => None,
        }
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

    /// Whether a term has a value of its own.
    pub(super) fn has_value(self, expr: &Expr) -> bool {
        expr.all_symbols(&|symbol| self.has_number(symbol))
    }

    /// Whether a quantity is shown by a number.
    pub(super) fn has_number(self, symbol: Symbol) -> bool {
        !self.is_free(symbol) && self.worked.variant.value(symbol).is_some()
    }

    /// The symbol itself; a value that the author wrote into a term is shown as that value.
    pub(super) fn name(self, symbol: Symbol) -> Math {
        self.manner(symbol).name.clone().unwrap_or_else(|| self.quantity(symbol))
    }

    /// The symbol itself, or the author's value, as it stands in a term.
    fn named(self, symbol: Symbol) -> Leaf {
        match &self.manner(symbol).name {
            Some(name) => Leaf { math: name.clone(), kind: LeafKind::Name },
            None => self.leaf(symbol),
        }
    }

    /// A number where the quantity has one, else the symbol.
    fn put_in(self, symbol: Symbol) -> Leaf {
        if !self.is_free(symbol) {
            return self.leaf(symbol);
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
        let value = |symbol: Symbol| self.worked.variant.value(symbol).map_or(f64::NAN, Bounded::or_zero);
        term.arranged.with_numbers(&|symbol| self.put_in(symbol), &value)
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
