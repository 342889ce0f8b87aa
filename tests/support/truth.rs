//! The truth about a variant, to more than 40 digits: an exact replay of its program, held against the equations
//! themselves by arithmetic of our own. What satisfies every equation of a system that determines it is the solution,
//! however it was found.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::LazyLock;

use dashu::float::round::mode::HalfEven;
use dashu::float::{Context, FBig};
use momentous::expr::{Expr, Function, Symbol};
use momentous::problem::{AskedUnit, NumberPart, Origin, Problem, Variant};
use momentous::quantity::{Rational, Unit};
use momentous::solve::{Bounded, Equation, Exact, Precise, Real, Relation, Statement, Workspace};

/// Floating point of 300 bits, 90 digits.
pub type Long = FBig<HalfEven, 2>;

const BITS: usize = 300;
/// The share of the largest term of an equation that its sides may differ by.
const AGREE: f64 = 1e-60;

/// An exact number as a long one.
pub fn long(value: &Rational) -> Long {
    let part = |integer: dashu::Integer| Context::<HalfEven>::new(BITS).convert_int::<2>(integer).value();
    part(value.numerator().clone()) / part(value.denominator().clone().into())
}

/// A floating-point number as a long one.
pub fn long_f64(value: f64) -> Long {
    Long::try_from(value).unwrap().with_precision(BITS).value()
}

pub fn pi() -> Long {
    static PI: LazyLock<Long> = LazyLock::new(|| Context::<HalfEven>::new(BITS).pi::<2>(None).value());
    PI.clone()
}

/// The size of a number, roughly.
pub fn rough(value: &Long) -> f64 {
    value.to_f64().value()
}

/// The size of a unit in base units.
pub fn factor(unit: &Unit) -> Long {
    let factor = unit.factor();
    let turn = if factor.pi < 0 { Long::ONE / pi() } else { pi() };
    (0..factor.pi.unsigned_abs()).fold(long(&factor.rational), |value, _| value * turn.clone())
}

/// Everything that follows from a variant's givens.
#[derive(Default)]
pub struct Truth {
    values: BTreeMap<Symbol, Long>,
    /// Roots and functions that were evaluated before: most occur in many equations.
    evaluated: RefCell<BTreeMap<Expr, (Long, f64)>>,
}

impl Truth {
    /// The values of a variant. Panics where an equation, a condition or the sign of a positive quantity is not satisfied.
    pub fn of(problem: &Problem, variant: &Variant) -> Self {
        let form = &problem.forms()[variant.form()];
        let inputs: Vec<Exact> = form.solver.inputs().iter().map(|symbol| given(problem, variant, *symbol)).collect();
        let program = &form.solver.tree().leaves[variant.leaf()];
        let mut workspace = Workspace::default();
        let outcome = program.run_exact(&inputs, &mut workspace);
        assert_eq!(outcome.survivors(), 1, "{} has not one solution", problem.id());
        assert_eq!(outcome.choices(), variant.roots(), "{} takes another root", problem.id());
        let value = |symbol| match outcome.value(symbol)? {
            Precise::Rational(value) => Some((symbol, long(value))),
            ball => Some((symbol, digits(ball)?)),
        };
        let mut values: BTreeMap<Symbol, Long> =
            problem.model().symbols.iter().filter_map(|(symbol, _)| value(symbol)).collect();
        // What is given is known without any replay.
        values.extend(form.solver.inputs().iter().zip(&inputs).map(|(symbol, exact)| (*symbol, from_exact(exact))));
        let truth = Self { values, ..Self::default() };
        truth.satisfies(problem, variant);
        truth
    }

    /// The value of a quantity in base units.
    pub fn value(&self, symbol: Symbol) -> Option<&Long> {
        self.values.get(&symbol)
    }

    /// The value of an answer in the unit in which it is asked.
    pub fn answer(&self, number: &NumberPart) -> Long {
        let unit = match &number.unit {
            AskedUnit::Unit(unit) => factor(unit),
            AskedUnit::InTermsOf(symbol, unit) => self.values[symbol].clone() * factor(unit),
        };
        self.values[&number.symbol].clone() / unit
    }

    fn knows(&self, expr: &Expr) -> bool {
        expr.symbols().iter().all(|symbol| self.values.contains_key(symbol))
    }

    fn satisfies(&self, problem: &Problem, variant: &Variant) {
        let leaf = problem.forms()[variant.form()].solver.leaf(variant.leaf());
        for equation in &leaf.system.equations {
            let law = problem.model().instances[equation.tag].law.name;
            self.satisfies_equation(equation, &format!("{} seed {:?}: {law}", problem.id(), variant.seed()));
        }
        for condition in leaf
            .system
            .conditions
            .iter()
            .filter(|condition| self.knows(&condition.left) && self.knows(&condition.right))
        {
            let (difference, size) = self.difference(&condition.left, &condition.right);
            assert!(
                holds(condition.relation, &difference, size),
                "{} seed {:?}: {}",
                problem.id(),
                variant.seed(),
                problem.model().reasons[condition.tag]
            );
        }
        for symbol in &leaf.system.positive {
            assert!(self.value(*symbol).is_none_or(|value| *value >= Long::ZERO), "{} is negative", problem.id());
        }
    }

    fn satisfies_equation(&self, equation: &Equation, what: &str) {
        match &equation.statement {
            Statement::Equal { left, right } if self.knows(left) && self.knows(right) => {
                let (difference, size) = self.difference(left, right);
                assert!(rough(&difference).abs() <= AGREE * size, "{what}: {difference} is not zero beside {size}");
            }
            Statement::FirstInteger { unknown, from, left, relation, right } if self.values.contains_key(unknown) => {
                let found = self.values[unknown].clone();
                let mut candidate = Long::from(*from).with_precision(BITS).value();
                while candidate < found {
                    let mut extended = Self { values: self.values.clone(), ..Self::default() };
                    extended.values.insert(*unknown, candidate.clone());
                    let (difference, _) = extended.difference(left, right);
                    assert!(!holds(*relation, &difference, 0.0), "{what}: a smaller number satisfies it");
                    candidate += Long::ONE;
                }
                let (difference, _) = self.difference(left, right);
                assert!(candidate == found && holds(*relation, &difference, 0.0), "{what}: not counted rightly");
            }
            _ => {}
        }
    }

    /// How far one term is above another, and the size of the largest number that was added up on the way.
    fn difference(&self, left: &Expr, right: &Expr) -> (Long, f64) {
        let (left, right) = (self.evaluate(left), self.evaluate(right));
        (left.0 - right.0, left.1 + right.1)
    }

    /// The value of a term, and the size of the largest number that was added up on the way.
    pub fn evaluate(&self, expr: &Expr) -> (Long, f64) {
        let costly = matches!(expr, Expr::Power(_) | Expr::Apply(..));
        let before = if costly { self.evaluated.borrow().get(expr).cloned() } else { None };
        before.unwrap_or_else(|| {
            let value = self.work_out(expr);
            if costly {
                self.evaluated.borrow_mut().insert(expr.clone(), value.clone());
            }
            value
        })
    }

    fn work_out(&self, expr: &Expr) -> (Long, f64) {
        let (value, size) = match expr {
            Expr::Number(number) => (long(number), 0.0),
            Expr::Pi => (pi(), 0.0),
            Expr::Symbol(symbol) => (self.values[symbol].clone(), 0.0),
            Expr::Sum(terms) => {
                let start = (long_f64(0.0), 0.0);
                terms.iter().map(|term| self.evaluate(term)).fold(start, |sum, term| (sum.0 + term.0, sum.1 + term.1))
            }
            Expr::Product(factors) => factors
                .iter()
                .map(|factor| self.evaluate(factor))
                .fold((long_f64(1.0), 1.0), |product, factor| (product.0 * factor.0, product.1 * factor.1)),
            Expr::Power(pair) => {
                let (base, size) = self.evaluate(&pair.0);
                let power = |exponent: f64| size.powf(exponent.abs()).max(size.powf(exponent));
                match pair.1.as_number().map(|exponent| exponent.to_f64().value()) {
                    Some(0.5) => (base.sqrt(), size.sqrt()),
                    Some(-0.5) => (Long::ONE / base.sqrt(), 0.0),
                    Some(exponent) if exponent.fract() == 0.0 => {
                        let size = if exponent < 0.0 { 0.0 } else { power(exponent) };
                        #[allow(clippy::cast_possible_truncation, reason = "it is whole and small")]
                        (base.powi((exponent as i64).into()), size)
                    }
                    _ => ((base.ln() * self.evaluate(&pair.1).0).exp(), size),
                }
            }
            Expr::Apply(function, arguments) => {
                let arguments: Vec<(Long, f64)> = arguments.iter().map(|part| self.evaluate(part)).collect();
                let (argument, size) = &arguments[0];
                let value = match function {
                    Function::Sin => argument.sin(),
                    Function::Cos => argument.cos(),
                    Function::Tan => argument.tan(),
                    Function::Asin => argument.asin(),
                    Function::Acos => argument.acos(),
                    Function::Exp => argument.exp(),
                    Function::Ln => argument.ln(),
                    Function::Abs if *argument < Long::ZERO => -argument.clone(),
                    Function::Abs => argument.clone(),
                    Function::Atan2 => argument.atan2(&arguments[1].0),
                };
                (value, size.max(1.0))
            }
            Expr::Piecewise(piecewise) => {
                let (at, _) = self.evaluate(&piecewise.variable);
                let holds = |until: &Option<Expr>| until.as_ref().is_none_or(|until| at <= self.evaluate(until).0);
                let (_, piece) = piecewise.pieces.iter().find(|(until, _)| holds(until)).expect("a piece");
                self.evaluate(piece)
            }
        };
        let size = size.max(rough(&value).abs());
        (value, size)
    }
}

/// Whether a difference compares with zero as it should; what is zero within its error may be either.
fn holds(relation: Relation, difference: &Long, size: f64) -> bool {
    if rough(difference).abs() <= AGREE * size {
        return true;
    }
    match relation {
        Relation::Less => *difference < Long::ZERO,
        Relation::AtMost => *difference <= Long::ZERO,
        Relation::Greater => *difference > Long::ZERO,
        Relation::AtLeast => *difference >= Long::ZERO,
        Relation::Differs => *difference != Long::ZERO,
        Relation::Equals => *difference == Long::ZERO,
    }
}

/// The digits of a long number, taken off double by double.
fn digits(value: &Precise) -> Option<Long> {
    let mut rest = value.clone();
    let mut sum = long_f64(0.0);
    for _ in 0..5 {
        let double = rest.to_bounded().value;
        if !double.is_finite() {
            return None;
        }
        sum += long_f64(double);
        rest = rest.sub(&Precise::point(double));
    }
    Some(sum)
}

fn from_exact(exact: &Exact) -> Long {
    let turn = if exact.pi_power < 0 { Long::ONE / pi() } else { pi() };
    (0..exact.pi_power.unsigned_abs()).fold(long(&exact.rational), |value, _| value * turn.clone())
}

/// What a form is told of a symbol, exactly as it is printed. What must not matter is one.
fn given(problem: &Problem, variant: &Variant, symbol: Symbol) -> Exact {
    if let Some((value, unit)) = variant.given(symbol) {
        let factor = unit.factor();
        return Exact { rational: value.to_rational() * factor.rational, pi_power: factor.pi };
    }
    let known = problem.known().iter().find(|known| known.symbol == symbol).expect("a given");
    assert!(matches!(known.origin, Origin::Any), "{} is not printed", known.name);
    Rational::ONE.into()
}

/// Whether a certificate is true: the value lies within its bound of the truth, to 60 digits.
pub fn is_true(bounded: Bounded, truth: &Long) -> bool {
    if !bounded.error.is_finite() {
        return false;
    }
    let distance = rough(&(long_f64(bounded.value) - truth.clone())).abs();
    distance <= bounded.error * (1.0 + 1e-12) + rough(truth).abs() * 1e-60
}
