//! How a quantity is shown in an explanation: its symbol, its number, its unit.

use std::cell::OnceCell;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Leaf;
use momentous_expr::LeafKind;
use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::Symbol;
use momentous_model::QuantityKind;
use momentous_problem::AskedUnit;
use momentous_problem::NumberPart;
use momentous_problem::Worked;
use momentous_quantity::Dimension;
use momentous_quantity::Printed;
use momentous_quantity::Rational;
use momentous_quantity::Unit;
use momentous_quantity::coherent_unit;
use momentous_solve::Closed;
use momentous_solve::Root;
use momentous_solve::Step;

use super::algebra::has_angle_of_point;
use super::ledger::Figures;
use super::letters::Letters;
use super::letters::Powers;
use super::manner::Manner;
use super::manner::MannerCache;
use super::term::Measured;
use super::term::Term;
use super::term::suffix;

/// The most characters above or below the bar of a fraction that is printed as such.
const SHORT_FRACTION: usize = 4;

/// The unit in which a quantity is usually printed, of the same size as a product of base units.
fn usual_unit(kind: &QuantityKind) -> Option<&'static str> {
    match kind {
        QuantityKind::Impulse
        | QuantityKind::DeformationImpulse
        | QuantityKind::RestitutionImpulse
        | QuantityKind::TimeIntegral => Some("N s"),
        QuantityKind::AngularVelocity => Some("rad/s"),
        // Of the dimension of an energy, and none.
        QuantityKind::Moment | QuantityKind::AngularMomentumRate => Some("N m"),
        _ => None,
    }
}

/// Shows the quantities of one variant.
#[derive(Clone, Copy)]
pub(crate) struct Display<'a> {
    pub worked: Worked<'a>,
    /// How quantities are shown, shared with the other variants that go its way.
    pub manners: &'a MannerCache,
    /// The terms shown before.
    pub shown: &'a PrintedTerms,
}

/// The quantities of a variant as they are printed, since a solution shows most of them many times.
#[derive(Clone, Debug, Default)]
pub(crate) struct PrintedTerms {
    pub leaves: RefCell<Vec<(Symbol, Leaf)>>,
    /// To how many figures, once all lines are known.
    pub figures: OnceCell<Figures>,
    /// The quantities that go by the name of another one.
    pub names: OnceCell<BTreeMap<Symbol, Symbol>>,
}

impl<'a> Display<'a> {
    fn letters(self) -> &'a Letters {
        self.manners.letters(self.worked)
    }

    /// Whether a quantity is shown by its symbol only, since no multiple of the letters that are left open is its value.
    pub(crate) fn is_free(self, symbol: Symbol) -> bool {
        self.letters().is_free(symbol)
    }

    /// Whether a quantity hangs on letters that are left open.
    pub(crate) fn is_open(self, symbol: Symbol) -> bool {
        self.letters().is_open(symbol)
    }

    /// The letters that are left open in the value of a term; none where it is no multiple of them.
    pub(crate) fn letters_of(self, term: &Expr) -> Option<Powers> {
        self.letters().powers(self.worked, term)
    }

    /// How the value of a term is printed with that unit, and whether it is a number or a multiple of letters.
    fn measured(self, term: &Expr, unit: impl FnOnce(Dimension) -> Unit) -> (Measured, bool) {
        let letters = self.letters_of(term);
        let is_multiple = letters.is_some();
        (self.measured_by(letters.unwrap_or_default(), term, unit), is_multiple)
    }

    /// How a term's value is printed to which other steps than those of the answer lead; none where it is no multiple of letters.
    pub(crate) fn measured_along(self, steps: &[Step], term: &Expr) -> Option<Measured> {
        let powers = Letters::along(self.worked, steps, &|_| None).powers(self.worked, term)?;
        Some(self.measured_by(powers, term, |dimension| coherent_unit(dimension, self.worked.problem.units())))
    }

    fn measured_by(self, powers: Powers, term: &Expr, unit: impl FnOnce(Dimension) -> Unit) -> Measured {
        let symbols = &self.worked.problem.model().symbols;
        let dimension = term.dimension(symbols).unwrap_or_default();
        if powers.is_empty() {
            return Measured::new(unit(dimension));
        }
        let mut powers: Vec<(Symbol, Rational)> = powers.into_iter().collect();
        powers.sort_by_key(|(letter, _)| symbols.entry(*letter).dimension != Dimension::MASS);
        let powers = powers.into_iter().map(|(letter, power)| Expr::from(letter).power(Expr::Number(power)));
        let product = Expr::product(powers);
        let rest = (term.clone() / product.clone()).dimension(symbols).unwrap_or_default();
        // Not as `symbolic`, which asks for this very measure.
        let named = |letter| Leaf { math: self.worked.problem.math_of(letter), kind: LeafKind::Name };
        let math = product.layout(&named);
        Measured::new(coherent_unit(rest, self.worked.problem.units())).with_letters(product, math)
    }

    /// The size of a unit in SI units, letters included.
    pub(crate) fn size(self, measured: &Measured) -> f64 {
        let letters = measured.letters.as_ref().map_or(1.0, |letters| self.value_of(letters));
        measured.unit.factor().to_f64() * letters
    }

    /// The unit in which explanations compute with a quantity: the system's own, degrees for angles.
    pub(crate) fn unit(self, symbol: Symbol) -> &'a Unit {
        &self.manner(symbol).measured.unit
    }

    /// How a quantity is shown.
    pub(crate) fn manner(self, symbol: Symbol) -> &'a Manner {
        self.manners.of(symbol, || {
            let problem = self.worked.problem;
            let (measured, _) = self.measured(&symbol.into(), |_| self.unit_chosen(symbol));
            let mut numbers = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
            let is_literal = problem.model().literals.iter().any(|(literal, _)| *literal == symbol);
            Manner {
                measured,
                name: (!is_literal).then(|| problem.math_of(symbol)),
                senses: problem.directions_told(symbol),
                is_whole: numbers.any(|number| number.whole && number.symbol == symbol),
                equals: self.equal(symbol),
                constant: self.constant(symbol),
            }
        })
    }

    /// The symbols that a reader of the steps knows: those told, and those that the steps found.
    pub(crate) fn known_to_the_reader(self) -> BTreeSet<Symbol> {
        let told = self.worked.variant.all_given().iter().map(|(symbol, ..)| *symbol);
        told.chain(self.worked.leaf().answer_steps().iter().flat_map(|step| step.unknowns.iter().copied())).collect()
    }

    /// The formula of what a step finds in one way only.
    fn formula(self, symbol: Symbol) -> Option<&'a Expr> {
        let mut steps = self.worked.leaf().answer_steps().iter();
        let root = |step: &'a Step| match &step.roots[..] {
            [Root { values }] => values.iter().find(|(root_of, _)| *root_of == symbol),
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
        let kind = &problem.model().name(symbol).kind;
        if entry.dimension == Dimension::NONE {
            return problem
                .unit_given(symbol)
                .filter(|unit| unit.factor().pi != 0)
                .unwrap_or_else(|| if kind.is_angle() { Unit::degree() } else { Unit::none() });
        }
        let coherent = coherent_unit(entry.dimension, problem.units());
        let spoken_of = problem.unit_given(symbol).or_else(|| self.asked_unit(symbol));
        let usual = usual_unit(kind).and_then(|unit| Unit::parse(unit).ok());
        let mut candidates = spoken_of.into_iter().flat_map(|unit| [unit.without_prefixes(), unit]).chain(usual);
        let same = |unit: &Unit| unit.dimension() == entry.dimension && unit.factor() == coherent.factor();
        candidates.find(same).unwrap_or(coherent)
    }

    /// The unit in which a quantity is asked.
    fn asked_unit(self, symbol: Symbol) -> Option<Unit> {
        let mut numbers = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
        numbers.find_map(|number| match number {
            NumberPart { symbol: asked, unit: AskedUnit::Unit(unit), .. } if *asked == symbol => Some(unit.clone()),
            _ => None,
        })
    }

    /// How the value of a term is printed, and whether it is a number or a multiple of letters.
    pub(crate) fn measure(self, expr: &Expr) -> (Measured, bool) {
        self.measured(expr, |dimension| coherent_unit(dimension, self.worked.problem.units()))
    }

    /// Whether a term has a value of its own.
    pub(crate) fn has_value(self, expr: &Expr) -> bool {
        expr.all_symbols(&|symbol| self.has_number(symbol)) && self.letters_of(expr).is_some()
    }

    /// Whether a quantity is shown by a number, or by a multiple of letters.
    pub(crate) fn has_number(self, symbol: Symbol) -> bool {
        !self.is_free(symbol) && self.worked.variant.value(symbol).is_some()
    }

    /// The symbol itself; a value that the author wrote into a term is shown as that value.
    pub(crate) fn name(self, symbol: Symbol) -> Math {
        self.manner(self.known_as(symbol)).name.clone().unwrap_or_else(|| self.quantity(symbol))
    }

    /// Whether a solution calls a quantity by the name of another one.
    pub(crate) fn has_other_name(self, symbol: Symbol) -> bool {
        self.known_as(symbol) != symbol
    }

    /// The quantity by whose name a solution calls another one.
    fn known_as(self, symbol: Symbol) -> Symbol {
        self.shown.names.get().and_then(|names| names.get(&symbol)).copied().unwrap_or(symbol)
    }

    /// The symbol itself, or the author's value, as it stands in a term.
    pub(super) fn named(self, symbol: Symbol) -> Leaf {
        match &self.manner(self.known_as(symbol)).name {
            Some(name) => Leaf { math: name.clone(), kind: LeafKind::Name },
            None => self.leaf(symbol),
        }
    }

    /// A number where the quantity has one, else the symbol.
    pub(super) fn put_in(self, symbol: Symbol) -> Leaf {
        if !self.is_free(symbol) {
            return self.leaf(symbol);
        }
        Leaf { math: self.name(symbol), kind: LeafKind::Name }
    }

    /// A term in symbols.
    pub(crate) fn symbolic(self, expr: &Expr) -> Math {
        expr.layout(&|symbol| self.named(symbol))
    }

    /// A term that many solutions show, in symbols and ready for numbers.
    pub(crate) fn term(self, expr: Expr) -> Term {
        let arranged = expr.arranged();
        let (unit, is_multiple) = self.measure(&expr);
        Term {
            symbols: arranged.with(&|symbol| self.named(symbol)),
            unit,
            is_multiple,
            mentions: expr.symbols().into_iter().collect(),
            has_angle: has_angle_of_point(&expr),
            arranged,
            expr,
        }
    }

    /// A term in which every quantity given piece by piece is replaced by the piece that holds for this variant.
    pub(crate) fn resolved(self, expr: &Expr) -> Expr {
        let Expr::Piecewise(piecewise) = expr else {
            return if has_pieces(expr) { expr.map_children(|part| self.resolved(part)) } else { expr.clone() };
        };
        let at = self.value_of(&piecewise.variable);
        let holds = |until: &Option<Expr>| until.as_ref().is_none_or(|until| at <= self.value_of(until));
        let piece = piecewise.pieces.iter().find(|(until, _)| holds(until)).or(piecewise.pieces.last());
        piece.map_or_else(|| expr.clone(), |(_, value)| self.resolved(value))
    }

    /// The condition under which the piece that holds for this variant does so; `None` for a term without pieces.
    pub(crate) fn piece_that_holds(self, expr: &Expr) -> Option<Math> {
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

    /// Whether a term holds the angle of a point that a calculator's arctangent does not give for this variant: its
    /// denominator is negative or zero.
    pub(crate) fn is_outside_arctangent(self, expr: &Expr) -> bool {
        let denominator = match expr {
            Expr::Apply(Function::Atan2, _) => expr.children().nth(1),
            _ => None,
        };
        denominator.is_some_and(|x| self.value_of(x) <= 0.0)
            || expr.children().any(|part| self.is_outside_arctangent(part))
    }

    /// `left = right`, in symbols.
    pub(crate) fn equation(self, left: &Expr, right: &Expr) -> Math {
        Math::relation(self.symbolic(left), Operator::Equals, self.symbolic(right))
    }
}

/// Whether a part of a term is given piece by piece.
pub(crate) fn has_pieces(expr: &Expr) -> bool {
    matches!(expr, Expr::Piecewise(_)) || expr.children().any(has_pieces)
}

/// A number followed by its unit.
pub(crate) fn with_unit(number: Math, unit: &Unit) -> Math {
    match suffix(unit) {
        Some(suffix) => Math::Row(vec![number, suffix]),
        None => number,
    }
}

/// A printed number as mathematics, powers of ten included.
pub(crate) fn number_math(text: String) -> Math {
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
pub(crate) fn printed(value: f64, figures: usize) -> String {
    Printed::new(value, figures).map_or_else(|| "?".into(), |printed| printed.plain())
}
