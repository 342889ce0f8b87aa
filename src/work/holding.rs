//! Lines whose sides agree: which kind of truth they are, and from which laws.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_problem::PartKind;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;
use momentous_quantity::Unit;

use super::found::{Accepted, LineFinding};
use super::ground::Place;
use super::holds::{At, Holds, is_identity};
use super::judge::Judge;
use super::meaning::{Meaning, Meanings};
use super::support::{Slopes, Support};
use super::verdict::Verdict;
use super::written::{Statement, Written};

impl Judge<'_> {
    /// The finding on a line whose sides agree for this variant.
    pub(crate) fn holding(&self, line: &Written, place: Place<'_>, sets: &[Meanings], here: &[Holds]) -> LineFinding {
        let everywhere = |set: &Meanings| {
            let holds = |place: Place<'_>| {
                let value = |symbol: Symbol| place.value(symbol);
                At { value: &value, units: self.units, turned: &self.turned }.line(line, set)
            };
            let holds_there: Vec<Holds> = self.ground.places().map(holds).collect();
            holds_there.iter().all(|holds| matches!(holds, Holds::Yes | Holds::Open))
        };
        let exactly = sets.iter().zip(here).filter(|(set, holds)| **holds == Holds::Yes && set.is_general(line));
        let mut is_general_here = false;
        for (set, _) in exactly {
            is_general_here = true;
            if everywhere(set) {
                return self.classed(line, place, set, true);
            }
        }
        let rounded = sets.iter().zip(here).find(|(set, holds)| **holds <= Holds::AsFigures && !set.is_general(line));
        match rounded {
            Some((set, _)) if !(line.numbers.is_empty() || is_general_here && line.is_in_symbols()) => {
                self.classed(line, place, set, false)
            }
            _ if is_general_here
                && self.counts()
                && line.statements().any(|statement| has_numeric_power(&statement.residual())) =>
            {
                // A number that counts was written as an exponent, which other variants have otherwise.
                self.classed(line, place, &sets[0], false)
            }
            _ if is_general_here => LineFinding::of(Verdict::Coincidence),
            _ => LineFinding::of(Verdict::Undecided),
        }
    }

    /// Whether something that is counted is told.
    fn counts(&self) -> bool {
        let model = self.worked.problem.model();
        let is_pure = |symbol: &&Symbol| model.symbols.entry(**symbol).dimension == Dimension::NONE;
        let is_whole = |symbol: &Symbol| {
            self.base.get(symbol).is_some_and(|number| number.value.fract() == 0.0 && number.value > 1.0)
        };
        self.ground.told.iter().filter(is_pure).any(is_whole)
    }

    /// Which kind of true line it is.
    fn classed(&self, line: &Written, place: Place<'_>, set: &Meanings, is_general: bool) -> LineFinding {
        if is_general && is_identity(line, set) {
            return LineFinding::of(Verdict::Identity);
        }
        let statements: Vec<_> = line.statements().cloned().collect();
        let residuals: Vec<Expr> =
            statements.iter().map(|statement| self.in_values(line, set, &statement.residual())).collect();
        let unknown: BTreeSet<Symbol> =
            residuals.iter().flat_map(Expr::symbols).filter(|symbol| !self.ground.told.contains(symbol)).collect();
        if unknown.is_empty() {
            return LineFinding { accepted: None, ..LineFinding::of(Verdict::Restates) };
        }
        let slopes = Slopes::new(&self.ground, place, &unknown);
        let mut support = Support::default();
        for residual in &residuals {
            let of_residual = slopes.support(place, residual);
            support.laws.extend(of_residual.laws);
            support.is_step |= of_residual.is_step;
        }
        let wanted = self.answers_asked();
        let answers: Vec<Symbol> = line
            .stated
            .iter()
            .flatten()
            .filter(|chain| {
                chain.iter().any(|statement| {
                    [&statement.left, &statement.right].into_iter().any(|side| self.is_known(line, side))
                })
            })
            .flat_map(|chain| chain.iter().flat_map(|statement| [&statement.left, &statement.right]))
            .filter_map(|side| match side {
                Expr::Symbol(symbol) if wanted.contains(symbol) => Some(*symbol),
                _ => None,
            })
            .collect();
        let verdict = match (answers.is_empty(), support.is_step, is_general) {
            (false, ..) => Verdict::Answer,
            (true, false, _) => Verdict::Definition,
            (true, true, true) => Verdict::Follows,
            (true, true, false) => Verdict::AsFigures,
        };
        let is_value = |statement: &Statement| {
            [&statement.left, &statement.right].iter().any(|side| line.number_alone(side).is_some())
        };
        let shows_laws = is_general
            || !statements.iter().all(|statement| {
                is_value(statement)
                    && [&statement.left, &statement.right].iter().any(|side| line.letter_alone(side).is_some())
            });
        let accepted = Accepted { residuals, support: support.clone(), answers, shows_laws };
        LineFinding { support, accepted: Some(accepted), ..LineFinding::of(verdict) }
    }

    /// Whether a side holds nothing but numbers, what is given and the letters in which a formula is asked.
    fn is_known(&self, line: &Written, side: &Expr) -> bool {
        let letters = self.worked.form.parts.iter().filter_map(|part| match &part.kind {
            PartKind::Formula(formula) => self.worked.formula(formula),
            _ => None,
        });
        let units = self.worked.form.units();
        let letters: BTreeSet<Symbol> = letters.flat_map(|formula| formula.symbols()).chain(units).collect();
        let is_known = |symbol: &Symbol| self.ground.told.contains(symbol) || letters.contains(symbol);
        side.symbols().iter().all(|symbol| line.number(*symbol).is_some() || is_known(symbol))
    }

    /// The quantities that are asked and can be written as a line.
    pub(crate) fn answers_asked(&self) -> Vec<Symbol> {
        self.worked.form.parts.iter().flat_map(|part| written_answers(&part.kind)).collect()
    }

    /// A term with its numbers as values, and with what the student counts the other way round as the scene counts it.
    pub(crate) fn in_values(&self, line: &Written, set: &Meanings, term: &Expr) -> Expr {
        term.substitute(&|symbol| {
            let Some(number) = line.number(symbol) else {
                return self.turned.contains(&symbol).then(|| -Expr::from(symbol));
            };
            match set.of(symbol) {
                Meaning::Given { symbol, reversed } => Some(if reversed { -Expr::from(symbol) } else { symbol.into() }),
                Meaning::Constant => Some(Expr::Number(number.value.clone())),
                Meaning::Computed => {
                    let factor = number.unit.as_ref().map(Unit::factor);
                    let rational = factor.as_ref().map_or(Rational::ONE, |factor| factor.rational.clone());
                    let turns = factor.map_or(0, |factor| i64::from(factor.pi));
                    let value = Expr::Number(&number.value * rational);
                    Some(if turns == 0 { value } else { value * Expr::Pi.powi(turns) })
                }
            }
        })
    }
}

/// The quantities of a part that can be written as a line.
pub(crate) fn written_answers(part: &PartKind) -> Vec<Symbol> {
    match part {
        PartKind::Number(number) => vec![number.symbol],
        PartKind::Vector(vector) => vector.components.iter().map(|component| component.symbol).collect(),
        PartKind::Formula(formula) => vec![formula.symbol],
        _ => Vec::new(),
    }
}

/// Whether a term has a number as the exponent of another.
fn has_numeric_power(term: &Expr) -> bool {
    let is_own = matches!(term, Expr::Power(pair) if pair.1.as_number().is_some_and(|exponent| exponent.is_int() && *exponent > Rational::from(2)));
    is_own || term.children().any(has_numeric_power)
}
