//! The numbers of a solution: each quantity in one form, exactly or to the figures that the lines need.

use std::collections::BTreeMap;

use momentous_expr::Expr;
use momentous_expr::Leaf;
use momentous_expr::LeafKind;
use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_problem::AskedUnit;
use momentous_problem::NumberPart;
use momentous_quantity::Decimal;
use momentous_quantity::Printed;
use momentous_quantity::Unit;
use momentous_quantity::round_to_figures;
use momentous_quantity::unit_of_place;
use momentous_solve::Bounded;
use momentous_solve::Real;
use momentous_solve::evaluate;

use super::algebra::positive_first;
use super::display::Display;
use super::display::number_math;
use super::display::printed;
use super::display::with_unit;
use super::entry::FEWEST;
use super::entry::Item;
use super::entry::is_same_size;
use super::ledger::Ledger;
use super::ledger::at_least;
use super::term::Measured;
use super::term::Term;

/// The most digits of a given that was converted to another unit.
const MOST_DIGITS: usize = 8;

/// The share of terms that cancel within which they come out as nothing, where each is printed with at most eight figures.
const CANCELLED: f64 = 1e-7;

/// A number that is printed as it is.
pub(crate) struct Exact {
    math: Math,
    negative: bool,
    /// Half a unit of its last place, in the unit in which it is printed.
    half: f64,
}

impl Exact {
    /// The same number with the other sign.
    fn turned(self) -> Self {
        let sign = |digits: &str| digits.strip_prefix('-').map_or_else(|| format!("-{digits}"), str::to_owned);
        let math = match &self.math {
            Math::Number(digits) if digits != "0" => Math::Number(sign(digits)),
            Math::Row(parts) => match parts.split_first() {
                Some((Math::Number(digits), rest)) => Math::Row([&[Math::Number(sign(digits))], rest].concat()),
                _ => self.math,
            },
            _ => self.math,
        };
        Self { negative: math.begins_with_minus(), math, half: self.half }
    }
}

impl Display<'_> {
    /// A value in its display unit, as it stands for its quantity in a term.
    pub(crate) fn leaf(self, symbol: Symbol) -> Leaf {
        let known = |(assumed, _): &&(Symbol, Leaf)| *assumed == symbol;
        if let Some((_, leaf)) = self.shown.leaves.borrow().iter().find(known) {
            return leaf.clone();
        }
        if let Some(other) = self.same_as(symbol) {
            return self.leaf(other);
        }
        let measured = &self.manner(symbol).measured;
        let leaf = match self.exact(symbol) {
            Some(Exact { math, .. }) if measured.letters.is_some() && math == Math::Number("1".into()) => {
                Leaf { math: measured.put(math), kind: LeafKind::Name }
            }
            Some(Exact { math, negative, .. }) => {
                Leaf { math: measured.put(math), kind: LeafKind::Number { negative } }
            }
            None => {
                let value = self.worked.variant.value(symbol).map_or(f64::NAN, Bounded::for_print);
                let shown = value / self.size(measured);
                let number = self.written_like_it(shown, measured).unwrap_or_else(|| {
                    let figures = self.figures(Item::Quantity(symbol), shown);
                    printed(shown, self.without_padding(shown, figures))
                });
                let kind = LeafKind::Number { negative: number.starts_with('-') };
                Leaf { math: measured.put(number_math(number)), kind }
            }
        };
        self.shown.leaves.borrow_mut().push((symbol, leaf.clone()));
        leaf
    }

    /// The quantity as which one is printed that always equals it.
    fn same_as(self, symbol: Symbol) -> Option<Symbol> {
        let (other, turned) = self.manner(symbol).equals?;
        (!turned && self.unit(other) == self.unit(symbol) && self.has_number(other)).then_some(other)
    }

    /// How a value is printed that is not rounded: what is given, counted, a plain fraction, or zero.
    pub(crate) fn exact(self, symbol: Symbol) -> Option<Exact> {
        let manner = self.manner(symbol);
        if let Some(letters) = &manner.measured.letters {
            return self.multiple(symbol, letters);
        }
        if let Some(math) = &manner.constant {
            return Some(Exact { math: math.clone(), negative: math.begins_with_minus(), half: 0.0 });
        }
        if let Some((other, turned)) = manner.equals {
            let exact = self.exact(other).filter(|_| self.unit(other) == self.unit(symbol));
            return exact.map(|exact| if turned { exact.turned() } else { exact });
        }
        let value = self.worked.variant.value(symbol);
        let mut told = self.worked.variant.all_given().iter();
        let printed = if manner.is_whole {
            Printed::written(&round_to_figures(value?.value.round(), 20)?)
        } else if let Some((_, value, given)) = told.find(|(told_symbol, ..)| *told_symbol == symbol) {
            let same = *given == manner.measured.unit;
            if same { Printed::written(value) } else { converted(value, given, &manner.measured.unit)? }
        } else {
            Printed::new(0.0, 1).filter(|_| value.is_some_and(Bounded::is_zero))?
        };
        let decimal = printed.to_decimal();
        let half = 0.5 * unit_of_place(-decimal.scale());
        Some(Exact { math: number_math(printed.plain()), negative: decimal.is_negative(), half })
    }

    /// Whether a quantity is a multiple of letters that is printed exactly.
    pub(crate) fn is_exact_multiple(self, symbol: Symbol) -> bool {
        self.is_open(symbol) && self.exact(symbol).is_some()
    }

    /// A multiple of letters that is printed exactly: a whole one, or one that nothing but algebra gives.
    fn multiple(self, symbol: Symbol, letters: &Expr) -> Option<Exact> {
        let whole = self.worked.in_givens(symbol, &self.worked.alphabet().values)?;
        let factor = (whole.clone() / letters.clone()).simplify();
        let is_algebra = factor == (self.worked.in_givens(symbol, &BTreeMap::new())? / letters.clone()).simplify();
        let number = factor.as_number().filter(|number| number.is_int() || is_algebra)?;
        let math = self.symbolic(&Expr::Number(number.clone()));
        Some(Exact { negative: math.begins_with_minus(), math, half: 0.05 })
    }

    /// To how many figures a number is printed.
    pub(crate) fn figures(self, item: Item, shown: f64) -> usize {
        let settled = self.shown.figures.get().and_then(|figures| figures.of(item));
        settled.unwrap_or_else(|| at_least(self.usual(item), shown))
    }

    /// To how many figures a number is printed where no line needs more: one more than is asked.
    fn usual(self, item: Item) -> usize {
        let asked = self.worked.problem.loaded().draft.significant_figures() + 1;
        let figures_of = |symbol: Symbol| {
            let numbers = self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
            numbers.filter(|number| number.symbol == symbol).map(|number| number.figures).max()
        };
        let figures_given = if let Item::Quantity(symbol) = item { figures_of(symbol) } else { None };
        FEWEST.max(asked).max(figures_given.unwrap_or(0))
    }

    /// Enters a quantity into the ledger of a solution, as it will be printed.
    pub(crate) fn enter(self, ledger: &mut Ledger, symbol: Symbol) {
        let item = Item::Quantity(symbol);
        let value = self.worked.variant.value(symbol).filter(|_| self.has_number(symbol) && !ledger.knows(item));
        let Some(value) = value else { return };
        if let Some(other) = self.same_as(symbol) {
            self.enter(ledger, other);
            return ledger.alias(symbol, other);
        }
        let unit = self.size(&self.manner(symbol).measured);
        match self.exact(symbol) {
            Some(Exact { half, .. }) => ledger.exact(item, value.or_zero(), unit, half * unit),
            None => ledger.rounded(item, value.for_print(), unit, self.usual(item)),
        }
    }

    /// Enters a result and the term whose value it is.
    pub(crate) fn enter_term(self, ledger: &mut Ledger, term: &Term, result: Item) {
        self.enter_line(ledger, &term.expr, &term.mentions, result);
    }

    fn enter_line(self, ledger: &mut Ledger, term: &Expr, mentions: &[Symbol], result: Item) {
        for symbol in mentions {
            self.enter(ledger, *symbol);
        }
        if let Item::Quantity(symbol) = result {
            self.enter(ledger, symbol);
        }
        ledger.term(term, mentions, result);
    }

    /// Enters a number that is no quantity of the problem: the value of a term.
    pub(crate) fn enter_value(self, ledger: &mut Ledger, term: &Expr, unit: f64, item: Item) {
        let mentions: Vec<Symbol> = term.symbols().into_iter().collect();
        let value = self.bounded(term).for_print();
        match term {
            // Terms that cancel leave nothing within the figures with which they are printed.
            Expr::Sum(parts) if value == 0.0 => {
                let size: f64 = parts.iter().map(|part| self.bounded(part).for_print().abs()).sum();
                ledger.exact(item, value, unit, (0.5 * unit).max(CANCELLED * size));
            }
            _ => self.enter_rounded(ledger, item, value, unit),
        }
        self.enter_line(ledger, term, &mentions, item);
    }

    /// Enters a number with the usual figures at least.
    pub(crate) fn enter_rounded(self, ledger: &mut Ledger, item: Item, value: f64, unit: f64) {
        ledger.rounded(item, value, unit, self.usual(item));
    }

    /// An unknown as a formula in what is told exactly; none where it holds anything else.
    pub(crate) fn in_what_is_told(self, unknown: Symbol) -> Option<Expr> {
        let whole = self.worked.in_givens(unknown, &self.worked.alphabet().values)?;
        let is_told = |symbol: Symbol| self.worked.variant.given(symbol).is_some() && !self.is_open(symbol);
        whole.all_symbols(&is_told).then(|| positive_first(&whole))
    }

    /// A term with what is told in place of its symbols, each in its own unit.
    pub(crate) fn as_told(self, expr: &Expr) -> Math {
        expr.layout(&|symbol| {
            let Some((value, unit)) = self.worked.variant.given(symbol) else { return self.leaf(symbol) };
            let math = with_unit(number_math(Printed::written(&value).plain()), &unit);
            Leaf { math, kind: LeafKind::Number { negative: value.is_negative() } }
        })
    }

    /// The number and its unit.
    pub(crate) fn quantity(self, symbol: Symbol) -> Math {
        self.leaf(symbol).math
    }

    /// The number and its unit, to so many figures where it is rounded.
    pub(crate) fn quantity_to(self, symbol: Symbol, figures: usize) -> Math {
        if self.exact(symbol).is_some() {
            return self.quantity(symbol);
        }
        let measured = &self.manner(symbol).measured;
        let value = self.worked.variant.value(symbol).map_or(f64::NAN, Bounded::for_print);
        measured.put(number_math(printed(value / self.size(measured), figures)))
    }

    /// A term's value in a unit, as a number of the solution.
    pub(crate) fn evaluated(self, expr: &Expr, unit: &Measured, item: Item) -> Math {
        let named = match (item, expr) {
            (Item::Quantity(symbol), _) => Some(symbol),
            (Item::Side(..), Expr::Symbol(symbol)) => Some(*symbol).filter(|symbol| self.unit(*symbol) == &unit.unit),
            _ => None,
        };
        if let Some(symbol) = named {
            return self.quantity(symbol);
        }
        let shown = self.bounded(expr).for_print() / self.size(unit);
        unit.put(number_math(printed(shown, self.without_padding(shown, self.figures(item, shown)))))
    }

    /// A given of that size and unit as the text writes it: what is 2.0 m/s there is not 2.000 m/s later.
    fn written_like_it(self, shown: f64, measured: &Measured) -> Option<String> {
        let unit = Some(&measured.unit).filter(|unit| !unit.is_none() && measured.letters.is_none())?;
        let mut told = self.worked.variant.all_given().iter().filter(|(.., given)| given == unit);
        let (_, value, _) = told.find(|(_, value, _)| is_same_size(value.to_f64(), shown))?;
        let size = Printed::written(&value.abs()).plain();
        Some(if shown < 0.0 { format!("-{size}") } else { size })
    }

    /// The figures of a number without zeros at its end that add nothing: at least as many as are asked.
    fn without_padding(self, shown: f64, figures: usize) -> usize {
        let asked = self.worked.problem.loaded().draft.significant_figures();
        let is_exact = |fewer: &usize| {
            round_to_figures(shown, *fewer).is_some_and(|rounded| is_same_size(rounded.to_f64(), shown))
        };
        (asked..figures).find(is_exact).unwrap_or(figures)
    }

    /// A number in the unit in which a part asks it; none where that is a quantity.
    pub(crate) fn in_unit_of(self, number: &NumberPart, value: Math) -> Math {
        let measured = &self.manner(number.symbol).measured;
        match &number.unit {
            AskedUnit::Unit(unit) if *unit == measured.unit => measured.put(value),
            AskedUnit::Unit(unit) => with_unit(value, unit),
            AskedUnit::InTermsOf(..) => value,
        }
    }

    /// A term's value in SI units; zero where nothing tells it from that.
    pub(crate) fn value_of(self, expr: &Expr) -> f64 {
        self.bounded(expr).or_zero()
    }

    fn bounded(self, expr: &Expr) -> Bounded {
        evaluate(expr, &|symbol| self.worked.variant.value(symbol).unwrap_or_else(Bounded::not_real))
    }
}

/// A given in another unit, where the conversion is exact and short: 360 g is 0.36 kg, and 36.0 km/h is 10.0 m/s.
fn converted(value: &Decimal, given: &Unit, unit: &Unit) -> Option<Printed> {
    let (from, to) = (given.factor(), unit.factor());
    let exact = value.to_rational() * from.rational / to.rational;
    let figures = (value.least_figures()..=MOST_DIGITS).filter(|_| from.pi == to.pi);
    let printed = figures.map(|figures| Printed::exact(&exact, figures));
    let mut fitting = printed.filter(|printed| printed.to_decimal().to_rational() == exact);
    fitting.next()
}
