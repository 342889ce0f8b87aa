//! A proof without algebra that a quantity does not matter: where it may grow by any factor, and others by powers of that factor,
//! without a single equation or condition noticing, what need not grow with it is the same whatever its value.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_quantity::Rational;

use super::system::Statement;
use super::system::System;

/// Whether every solution of a system turns into another one as `grown`, which is positive, grows: what is known besides stays,
/// and each quantity of `alike` grows as the one beside it, or stays where there is none. `zeros` are always zero.
///
/// All roots and all conditions are covered: solutions go over into solutions, so there are as many of them as before.
#[must_use]
pub fn may_grow(
    system: &System,
    known: &BTreeSet<Symbol>,
    zeros: &BTreeSet<Symbol>,
    grown: Symbol,
    alike: &[(Symbol, Option<Symbol>)],
) -> bool {
    let mut powers = Powers { system, known, zeros, grown, rows: BTreeMap::new() };
    let fits = |powers: &mut Powers<'_>| {
        for equation in &system.equations {
            match &equation.statement {
                Statement::Equal { left, right } => powers.balanced(left, right)?,
                Statement::FirstInteger { unknown, left, right, .. } => {
                    powers.equal(powers.of(*unknown), &Power::default())?;
                    powers.balanced(left, right)?;
                }
            }
        }
        for condition in &system.conditions {
            powers.balanced(&condition.left, &condition.right)?;
        }
        for (symbol, other) in alike {
            let other = other.map_or_else(Power::default, |other| powers.of(other));
            powers.equal(powers.of(*symbol), &other)?;
        }
        Ok::<(), Noticed>(())
    };
    fits(&mut powers).is_ok()
}

/// An equation or a condition notices that the quantity grows.
struct Noticed;

/// The power of the factor by which a term grows: a number, and multiples of the powers of unknown quantities.
#[derive(Clone, Debug, Default, PartialEq)]
struct Power {
    number: Rational,
    unknown: BTreeMap<Symbol, Rational>,
}

impl Power {
    fn plus(mut self, factor: &Rational, other: &Self) -> Self {
        self.number += factor * &other.number;
        for (symbol, coefficient) in &other.unknown {
            let sum = self.unknown.entry(*symbol).or_default();
            *sum += factor * coefficient;
        }
        self.unknown.retain(|_, coefficient| !coefficient.is_zero());
        self
    }
}

/// The powers known so far: some of them in terms of the others.
struct Powers<'a> {
    system: &'a System,
    known: &'a BTreeSet<Symbol>,
    zeros: &'a BTreeSet<Symbol>,
    grown: Symbol,
    rows: BTreeMap<Symbol, Power>,
}

impl Powers<'_> {
    fn of(&self, symbol: Symbol) -> Power {
        if symbol == self.grown {
            return Power { number: Rational::ONE, unknown: BTreeMap::new() };
        }
        if self.known.contains(&symbol) || self.system.fixed.contains_key(&symbol) {
            return Power::default();
        }
        let alone = || Power { number: Rational::ZERO, unknown: BTreeMap::from([(symbol, Rational::ONE)]) };
        self.rows.get(&symbol).cloned().unwrap_or_else(alone)
    }

    /// A power in terms of those that are still open.
    fn resolved(&self, power: Power) -> Power {
        let number = Power { number: power.number, unknown: BTreeMap::new() };
        power.unknown.iter().fold(number, |sum, (symbol, factor)| sum.plus(factor, &self.of(*symbol)))
    }

    /// Two powers have to be the same.
    fn equal(&mut self, one: Power, other: &Power) -> Result<(), Noticed> {
        let rest = self.resolved(one.plus(&-Rational::ONE, other));
        let Some((pivot, factor)) = rest.unknown.iter().next().map(|(symbol, factor)| (*symbol, factor.clone())) else {
            return if rest.number.is_zero() { Ok(()) } else { Err(Noticed) };
        };
        let mut row = Power::default().plus(&(-Rational::ONE / &factor), &rest);
        row.unknown.remove(&pivot);
        for relation in self.rows.values_mut() {
            if let Some(share) = relation.unknown.remove(&pivot) {
                *relation = std::mem::take(relation).plus(&share, &row);
            }
        }
        self.rows.insert(pivot, row);
        Ok(())
    }

    /// Both sides have to grow alike; what is zero may grow as it likes.
    fn balanced(&mut self, left: &Expr, right: &Expr) -> Result<(), Noticed> {
        match (self.term(left)?, self.term(right)?) {
            (Some(left), Some(right)) => self.equal(left, &right),
            _ => Ok(()),
        }
    }

    /// A number that must not grow: an angle, an exponent.
    fn pure(&mut self, expr: &Expr) -> Result<Option<Power>, Noticed> {
        if let Some(power) = self.term(expr)? {
            self.equal(power, &Power::default())?;
        }
        Ok(Some(Power::default()))
    }

    /// All terms have to grow alike.
    fn common<'e>(&mut self, terms: impl IntoIterator<Item = &'e Expr>) -> Result<Option<Power>, Noticed> {
        let mut common: Option<Power> = None;
        for term in terms {
            let Some(power) = self.term(term)? else { continue };
            match &common {
                Some(first) => self.equal(first.clone(), &power)?,
                None => common = Some(power),
            }
        }
        Ok(common)
    }

    /// How a term grows, if it grows as a whole; none where it is zero.
    fn term(&mut self, expr: &Expr) -> Result<Option<Power>, Noticed> {
        Ok(match expr {
            Expr::Number(value) => (!value.is_zero()).then(Power::default),
            Expr::Pi => Some(Power::default()),
            Expr::Symbol(symbol) => (!self.zeros.contains(symbol)).then(|| self.of(*symbol)),
            Expr::Sum(terms) => self.common(terms.iter())?,
            Expr::Product(factors) => {
                let mut product = Power::default();
                for factor in factors.iter() {
                    let Some(power) = self.term(factor)? else { return Ok(None) };
                    product = product.plus(&Rational::ONE, &power);
                }
                Some(product)
            }
            Expr::Power(pair) => match pair.1.as_number() {
                Some(exponent) => self.term(&pair.0)?.map(|base| Power::default().plus(exponent, &base)),
                None => {
                    self.pure(&pair.0)?;
                    self.pure(&pair.1)?
                }
            },
            Expr::Apply(Function::Abs, arguments) => self.common(arguments.iter())?,
            Expr::Apply(Function::Atan2, arguments) => {
                self.common(arguments.iter())?;
                Some(Power::default())
            }
            Expr::Apply(_, arguments) => {
                for argument in arguments.iter() {
                    self.pure(argument)?;
                }
                Some(Power::default())
            }
            Expr::Piecewise(piecewise) => {
                let ends = piecewise.pieces.iter().filter_map(|(until, _)| until.as_ref());
                self.common(ends.chain([&piecewise.variable]))?;
                self.common(piecewise.pieces.iter().map(|(_, value)| value))?
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Condition;
    use crate::Equation;
    use crate::Relation;
    use momentous_expr::SymbolEntry;
    use momentous_expr::SymbolTable;
    use momentous_quantity::Dimension;

    const NAMES: [&str; 4] = ["mass", "speed", "energy", "height"];

    /// Mass, speed, energy and height of a body that flies up as far as it can.
    fn symbols() -> [Symbol; 4] {
        let mut table = SymbolTable::default();
        let entry = |name: &str| SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() };
        NAMES.map(|name| table.intern(entry(name)))
    }

    fn equal(left: Expr, right: Expr) -> Equation {
        Equation { statement: Statement::Equal { left, right }, tag: 0, cost: 1 }
    }

    fn energy() -> System {
        let [mass, speed, energy, height] = symbols().map(Expr::from);
        let kinetic = equal(energy.clone(), Expr::ratio(1, 2) * mass.clone() * speed.powi(2));
        System { equations: vec![kinetic, equal(energy, mass * height)], ..System::default() }
    }

    #[test]
    fn a_mass_that_drops_out_may_grow() {
        let [mass, speed, whole, height] = symbols();
        let known = BTreeSet::from([mass, speed]);
        assert!(may_grow(&energy(), &known, &BTreeSet::new(), mass, &[(height, None)]));
        assert!(may_grow(&energy(), &known, &BTreeSet::new(), mass, &[(whole, Some(mass)), (height, None)]));
        assert!(!may_grow(&energy(), &known, &BTreeSet::new(), mass, &[(whole, None)]));
        assert!(!may_grow(&energy(), &known, &BTreeSet::new(), speed, &[(height, None)]));
    }

    #[test]
    fn a_condition_that_notices_is_no_proof() {
        let [mass, speed, _, height] = symbols();
        let told = Condition { left: mass.into(), relation: Relation::Less, right: Expr::integer(2), tag: 0 };
        let system = System { conditions: vec![told], ..energy() };
        assert!(!may_grow(&system, &BTreeSet::from([mass, speed]), &BTreeSet::new(), mass, &[(height, None)]));
    }

    #[test]
    fn what_is_zero_notices_nothing() {
        let [mass, speed, whole, height] = symbols();
        // The potential energy of the start is added; it is zero.
        let [of_mass, of_speed, of_whole] = [mass, speed, whole].map(Expr::from);
        let sum = of_whole.clone() + Expr::from(height);
        let system = System { equations: vec![equal(sum, of_mass * of_speed.powi(2))], ..System::default() };
        let known = BTreeSet::from([mass, speed, height]);
        assert!(!may_grow(&system, &known, &BTreeSet::new(), mass, &[(whole, Some(mass))]));
        assert!(may_grow(&system, &known, &BTreeSet::from([height]), mass, &[(whole, Some(mass))]));
    }
}
