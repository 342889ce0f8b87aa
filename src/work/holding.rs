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
use super::holds::{At, Holds, RESULT, is_identity};
use super::judge::Judge;
use super::meaning::{Meaning, Meanings};
use super::sides::Compared;
use super::support::{Slopes, Support};
use super::verdict::Verdict;
use super::written::{Statement, Written};

/// What is said of a line without any letter.
const ARITHMETIC: &str = "The arithmetic is right. Say which quantity it is: write its letter before the numbers.";
/// What is said of a line that only works something out of what is given.
const WORKED_OUT: &str = "True, and worked out of what is given. Say which quantity it is: write its letter before it.";
/// What is said of a line that only compares.
const INEQUALITY: &str = "True. An inequality is no answer, and shows no law.";

impl Judge<'_> {
    /// The finding on a line whose sides agree for this variant.
    pub(crate) fn holding(&self, line: &Written, place: Place<'_>, sets: &[Meanings], here: &[Holds]) -> LineFinding {
        let exactly = sets.iter().zip(here).filter(|(set, holds)| **holds == Holds::Yes && set.is_general(line));
        let mut is_general_here = false;
        for (set, _) in exactly {
            is_general_here = true;
            if self.holds_everywhere(line, set) {
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
            _ if is_general_here => self
                .giving_value(line, place, sets, here)
                .or_else(|| self.by_equal_givens(line, place, sets, here))
                .unwrap_or_else(|| LineFinding::of(Verdict::Coincidence)),
            _ => LineFinding::of(Verdict::Undecided),
        }
    }

    /// Whether a line holds in the other variants, too.
    fn holds_everywhere(&self, line: &Written, set: &Meanings) -> bool {
        self.ground.places().all(|place| {
            let value = |symbol: Symbol| place.value(symbol);
            let at = At { value: &value, units: self.units, turned: &self.turned, share: RESULT };
            matches!(at.line(line, set), Holds::Yes | Holds::Open)
        })
    }

    /// The finding on a line that holds in other variants but for the value of what is asked, or for the number at the end of a chain:
    /// such a number is a result, even where it is that of a given.
    fn giving_value(&self, line: &Written, place: Place<'_>, sets: &[Meanings], here: &[Holds]) -> Option<LineFinding> {
        let wanted = self.answers_asked();
        let gives = |letter: &Expr, value: &Expr| {
            line.letter_alone(letter).is_some_and(|letter| wanted.contains(&letter)) && self.is_value(line, value)
        };
        let is_result = |chain: &[Statement], at: usize| {
            chain.get(at).is_some_and(|Statement { left, right, .. }| {
                let ends = at > 0 && at + 1 == chain.len() && line.number_alone(right).is_some();
                ends || gives(left, right) || gives(right, left)
            })
        };
        let without_results = |chain: &Vec<Statement>| {
            let kept = chain.iter().enumerate().filter(|(at, _)| !is_result(chain, *at));
            kept.map(|(_, statement)| statement.clone()).collect::<Vec<_>>()
        };
        let stated: Vec<Vec<Vec<Statement>>> =
            line.stated.iter().map(|alternatives| alternatives.iter().map(without_results).collect()).collect();
        let rest = Written { stated, ..line.clone() };
        if rest.statements().count() == line.statements().count() {
            return None;
        }
        let mut holding = sets.iter().zip(here).filter(|(_, holds)| **holds <= Holds::AsFigures);
        let (set, _) = holding.find(|(set, _)| self.holds_everywhere(&rest, set))?;
        Some(self.classed(line, place, set, false))
    }

    /// Whether a side is a value: a number, perhaps times letters for which the sheet has no value.
    fn is_value(&self, line: &Written, side: &Expr) -> bool {
        let symbols = side.symbols();
        let units: BTreeSet<Symbol> = self.worked.form.units().collect();
        let is_open = |symbol: &Symbol| {
            let is_any = self.ground.told.contains(symbol) && self.worked.variant.given(*symbol).is_none();
            is_any || units.contains(symbol)
        };
        let has_number = symbols.iter().any(|symbol| line.number(*symbol).is_some());
        has_number && symbols.iter().all(|symbol| line.number(*symbol).is_some() || is_open(symbol))
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
    pub(crate) fn classed(&self, line: &Written, place: Place<'_>, set: &Meanings, is_general: bool) -> LineFinding {
        if line.quantities().is_empty() {
            return LineFinding::of(Verdict::Restates).because(ARITHMETIC.to_owned());
        }
        if is_general && is_identity(line, set) {
            let is_given = |statement: &Statement| {
                let is_given = |side: &Expr| line.number_alone(side).is_some_and(|number| set.is_given(number.symbol));
                is_given(&statement.left) || is_given(&statement.right)
            };
            let restates = line.statements().all(is_given);
            return LineFinding::of(if restates { Verdict::Restates } else { Verdict::Identity });
        }
        let value = |symbol: Symbol| place.value(symbol);
        let at = At { value: &value, units: self.units, turned: &self.turned, share: RESULT };
        // Of alternatives those say something of the scene that hold in it, and an answer is given by what holds in all of them.
        let chains: Vec<(&Vec<Statement>, bool)> = line
            .stated
            .iter()
            .flat_map(|alternatives| {
                let is_only = alternatives.len() == 1;
                let holds = |chain: &&Vec<Statement>| is_only || at.chain(line, chain, set) <= Holds::AsFigures;
                let holding: Vec<&Vec<Statement>> = alternatives.iter().filter(holds).collect();
                let are_all = holding.len() == alternatives.len();
                holding.into_iter().map(move |chain| (chain, are_all))
            })
            .collect();
        let equations: Vec<&Statement> = chains
            .iter()
            .flat_map(|(chain, _)| *chain)
            .filter(|statement| statement.compared == Compared::Equal)
            .collect();
        let residual = |statement: &Statement| self.in_values(line, set, &statement.residual());
        let unknown = |residuals: &[Expr]| -> BTreeSet<Symbol> {
            residuals.iter().flat_map(Expr::symbols).filter(|symbol| !self.ground.told.contains(symbol)).collect()
        };
        if unknown(&line.statements().map(residual).collect::<Vec<_>>()).is_empty() {
            let is_letter = |side: &Expr| {
                let is_one = line.letter_alone(side).is_some() || line.number_alone(side).is_some();
                is_one || self.alphabet.is_meaning(side)
            };
            let is_worked_out =
                line.statements().any(|statement| !is_letter(&statement.left) && !is_letter(&statement.right));
            let detail = if is_worked_out { WORKED_OUT } else { "" };
            return LineFinding::of(Verdict::Restates).because(detail.to_owned());
        }
        if equations.is_empty() {
            return LineFinding::of(Verdict::Follows).because(INEQUALITY.to_owned());
        }
        let residuals: Vec<Expr> = equations.iter().map(|statement| residual(statement)).collect();
        let slopes = Slopes::new(&self.ground, place, &unknown(&residuals));
        let mut support = Support::default();
        for residual in &residuals {
            let of_residual = slopes.support(place, residual);
            support.laws.extend(of_residual.laws);
            support.is_step |= of_residual.is_step;
        }
        let answers: Vec<Symbol> =
            chains.iter().flat_map(|(chain, are_all)| self.given_in(line, chain, *are_all)).collect();
        let verdict = match (answers.is_empty(), support.is_step, is_general) {
            (false, ..) => Verdict::Answer,
            (true, false, _) => Verdict::Definition,
            (true, true, true) => Verdict::Follows,
            (true, true, false) => Verdict::AsFigures,
        };
        let is_of_value = |statement: &&Statement| {
            let sides = || [&statement.left, &statement.right].into_iter();
            let is_value = |side: &Expr| {
                let is_multiple = side.symbols().iter().any(|symbol| line.number(*symbol).is_none());
                line.number_alone(side).is_some() || is_multiple && self.is_value(line, side)
            };
            let is_letter = |side: &Expr| line.letter_alone(side).is_some() || self.alphabet.is_meaning(side);
            sides().any(is_value) && sides().any(is_letter)
        };
        let shows_laws = is_general || !equations.iter().all(is_of_value);
        let named = match residuals.as_slice() {
            [only] if verdict == Verdict::Definition => slopes.naming(place, only),
            _ => None,
        };
        let law = named.and_then(|position| {
            let tag = self.ground.equations.get(position)?.tag;
            Some(self.worked.problem.model().instances.get(tag)?.law.name)
        });
        let detail = law.map_or_else(String::new, |law| format!("True, by {law}."));
        let accepted = Accepted { residuals, support: support.clone(), answers, shows_laws };
        LineFinding { support, detail, accepted: Some(accepted), ..LineFinding::of(verdict) }
    }

    /// The quantities that are asked and whose value or formula a chain gives. Of several alternatives that do not all hold in the scene
    /// only all roots that are asked are an answer.
    fn given_in(&self, line: &Written, chain: &[Statement], is_only: bool) -> Vec<Symbol> {
        let numbers = || self.worked.form.parts.iter().flat_map(|part| part.kind.numbers());
        let is_answer = |symbol: &Symbol| {
            let asks_all = || numbers().any(|number| number.symbol == *symbol && number.every_root);
            is_only || asks_all()
        };
        let wanted: Vec<Symbol> = self.answers_asked().into_iter().filter(is_answer).collect();
        let sides = |run: &[Statement]| -> Vec<Expr> {
            run.iter().flat_map(|statement| [statement.left.clone(), statement.right.clone()]).collect()
        };
        let runs = chain.split(|statement| statement.compared != Compared::Equal).map(sides);
        let runs = runs.filter(|sides| sides.iter().any(|side| self.is_known(line, side)));
        let asked = runs.flatten().filter_map(|side| match side {
            Expr::Symbol(symbol) if wanted.contains(&symbol) => Some(symbol),
            _ => None,
        });
        asked.collect()
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
