//! Judging the lines of a student's work one after another.

use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_grade::DecimalMark;
use momentous_problem::Worked;

use super::aliases::Aliases;
use super::alphabet::alphabet;
use super::bare_units::BareUnits;
use super::clash::without_clash;
use super::found::{Accepted, LineFinding};
use super::ground::Ground;
use super::holds::{At, Holds, RESULT, results};
use super::meaning::meanings;
use super::prose;
use super::rates;
use super::reader::{NoLine, readings};
use super::report::JudgedLine;
use super::setting::unset;
use super::sides::{sides, statements};
use super::together::aliases;
use super::unread::said;
use super::vectors::{Vectors, unmarked};
use super::verdict::Verdict;
use super::way::Values;
use super::written::{Alphabet, Written};

/// The most lines that are judged.
pub const MOST_LINES: usize = 60;

/// How much is asked about a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Search {
    /// Whether it is true.
    Truth,
    /// Where it is not, also why.
    Mistakes,
}

/// A student's work on one variant: lines are judged in their order, since a line may go on from the one before.
pub struct Judge<'a> {
    pub(crate) worked: Worked<'a>,
    pub(crate) ground: Arc<Ground>,
    pub(crate) base: Values,
    /// The units in which bare numbers count.
    pub(crate) units: BareUnits,
    pub(crate) alphabet: Alphabet,
    aliases: Aliases,
    pub(crate) mark: DecimalMark,
    pub(crate) turned: Vec<Symbol>,
    pub(crate) before: Option<Written>,
    pub(crate) mistakes: Vec<(&'static str, usize)>,
    pub(crate) accepted: Vec<Accepted>,
    /// What short names stand for since a line held with it.
    pub(crate) meant: Vec<(Symbol, Expr)>,
    /// Letters of the student's own for numbers of which a line has made use that holds.
    pub(crate) used: BTreeSet<Symbol>,
    lines: usize,
    /// Whether the line that is judged is written in letters only.
    is_in_letters: bool,
}

impl<'a> Judge<'a> {
    /// A judge of work on a variant, before any line is read.
    #[must_use]
    pub fn new(worked: Worked<'a>, mark: DecimalMark) -> Self {
        let ground = Ground::of(worked);
        let base = ground.values(worked, 0);
        Self {
            alphabet: alphabet(worked, &ground),
            aliases: aliases(worked, &ground),
            units: BareUnits::coherent(worked.problem.units()),
            worked,
            ground,
            base,
            mark,
            turned: Vec::new(),
            before: None,
            mistakes: Vec::new(),
            accepted: Vec::new(),
            meant: Vec::new(),
            used: BTreeSet::new(),
            lines: 0,
            is_in_letters: true,
        }
    }

    /// Judges the next line.
    pub fn line(&mut self, text: &str) -> JudgedLine {
        self.lines += 1;
        self.is_in_letters = true;
        let written = rates::named(text, &|name| self.aliases.has(name) || self.aliases.has(&format!("{name}x")));
        self.learn(&written);
        let found = self.found(&written);
        if let Some(accepted) = &found.accepted {
            self.accepted.push(accepted.clone());
        }
        let model = self.worked.problem.model();
        let law = |position: &usize| {
            let instance = model.instances.get(self.ground.equations.get(*position)?.tag)?;
            Some(instance.law)
        };
        let laws: Vec<_> = found.support.laws.iter().filter_map(law).collect();
        // Conservation along each of two axes is named once.
        let mut names: Vec<&str> = Vec::new();
        for law in &laws {
            if !names.contains(&law.name) {
                names.push(law.name);
            }
        }
        let message = self.message(&found, &names);
        for mistake in &found.mistakes {
            self.mistakes.push((mistake.of.id, self.lines));
        }
        let mut ids: Vec<&'static str> = laws.iter().map(|law| law.id).collect();
        ids.dedup();
        JudgedLine {
            line: self.lines,
            text: text.trim().to_owned(),
            verdict: found.verdict,
            laws: ids,
            mistakes: found.mistakes.iter().map(|mistake| mistake.of.id).collect(),
            message,
            is_in_letters: self.is_in_letters,
        }
    }

    fn found(&mut self, text: &str) -> LineFinding {
        if self.turn(text) {
            return LineFinding::of(Verdict::Convention);
        }
        if let Some(unclear) = self.unclear_convention(text) {
            return LineFinding::of(Verdict::Unreadable).because(unclear);
        }
        let parts: Vec<String> = statements(text).into_iter().filter(|part| sides(part).is_some()).collect();
        if parts.len() < 2 {
            return self.stated(text);
        }
        // Where one is a sentence that cannot be read, the others are judged.
        let (mut left_out, mut is_read) = (None, false);
        // Of several statements a wrong one is told, of true ones the one that says most, and each may show what it shows.
        let mut told: Option<LineFinding> = None;
        for part in &parts {
            let found = self.stated(part);
            if found.verdict == Verdict::Unreadable && prose::is_sentence(part) {
                left_out = Some(found);
                continue;
            }
            is_read = true;
            self.accepted.extend(found.accepted.clone());
            let found = LineFinding { accepted: None, ..found };
            let is_told = told.as_ref().is_none_or(|earlier| {
                let are_true = earlier.verdict.is_true() && found.verdict.is_true();
                if are_true { found.verdict < earlier.verdict } else { found.verdict > earlier.verdict }
            });
            if is_told {
                told = Some(found);
            }
        }
        let rest = left_out.filter(|_| !is_read);
        rest.or(told).unwrap_or_else(|| LineFinding::of(Verdict::Remark))
    }

    /// The finding on one statement, or on the equation in it where it is a sentence that cannot be read as a whole.
    pub(crate) fn stated(&mut self, text: &str) -> LineFinding {
        let text = match self.with_direction(text) {
            Ok(text) => text,
            Err(unclear) => return LineFinding::of(Verdict::Unreadable).because(unclear),
        };
        let text = text.as_str();
        let found = self.plainly_stated(text);
        if found.verdict != Verdict::Unreadable {
            return found;
        }
        if let Some(found) = self.with_letter_guessed(text) {
            return found;
        }
        if let Some(found) = self.with_readable_sides(text) {
            return found;
        }
        let mut rest = text.to_owned();
        while let Some(equation) = prose::equation(&rest) {
            let within = match self.equation_with_direction(&equation, &rest) {
                Ok(equation) => self.plainly_stated(&equation),
                Err(unclear) => LineFinding::of(Verdict::Unreadable).because(unclear),
            };
            if within.verdict != Verdict::Unreadable {
                return within;
            }
            rest = equation;
        }
        found
    }

    /// The finding on one statement. The sheet does not tell the sense of the axis across the line of impact: a line may count it
    /// the other way round.
    pub(crate) fn plainly_stated(&mut self, text: &str) -> LineFinding {
        if let Some(found) = self.own_letter(text) {
            return found;
        }
        let before = self.before.clone();
        let found = self.read(text);
        if !found.verdict.is_wrong() || !self.turned.is_empty() {
            return found;
        }
        let model = self.worked.problem.model();
        let is_across = |symbol: &Symbol| model.name(*symbol).component.as_deref() == Some("t");
        self.turned = model.symbols.iter().map(|(symbol, _)| symbol).filter(is_across).collect();
        if self.turned.is_empty() {
            return found;
        }
        let after = std::mem::replace(&mut self.before, before);
        let turned = self.read(text);
        self.turned.clear();
        if turned.verdict.is_true() {
            return turned;
        }
        self.before = after;
        found
    }

    /// Learns the short names that stand in a line.
    fn learn(&mut self, text: &str) {
        let known = self.alphabet.names.len();
        self.aliases.learn(&unmarked(&unset(text)), &mut self.alphabet);
        if self.alphabet.names.len() > known {
            self.alphabet.vectors = Vectors::among(&self.alphabet.symbols);
        }
    }

    fn read(&mut self, text: &str) -> LineFinding {
        let (found, reading) = self.tried(text);
        let Some(reading) = reading else { return found };
        self.take(found, reading)
    }

    /// The finding on one statement, and the reading in which it is found. Where it does not hold or says nothing new, its short names are
    /// tried with whatever else they may mean; a name keeps the meaning with which an earlier line held.
    pub(crate) fn tried(&self, text: &str) -> (LineFinding, Option<Written>) {
        let (found, first) = match self.tried_as(text, &self.meant, Search::Mistakes) {
            Ok(first) => first,
            Err(found) => return (*found, None),
        };
        let is_empty = matches!(found.verdict, Verdict::Restates | Verdict::Identity) && !first.quantities().is_empty();
        let is_value = found.verdict == Verdict::AsFigures && !results(&first).is_empty();
        if found.verdict.is_true() && !is_empty && !is_value || first.shorts.is_empty() {
            return (found, Some(first));
        }
        let is_better = |other: Verdict| match (is_value, is_empty) {
            // Of several quantities with one value that which is asked.
            (true, _) => other == Verdict::Answer,
            (_, true) => other < Verdict::Definition,
            _ => other.is_true(),
        };
        let others = self.alphabet.meanings(&first).into_iter().filter_map(|instead| {
            let (other, reading) = self.tried_as(text, &instead, Search::Truth).ok()?;
            is_better(other.verdict).then_some((instead, other, reading))
        });
        let mut others: Vec<_> = others.collect();
        others.sort_by_key(|(_, other, reading)| other.verdict != Verdict::Answer || results(reading).is_empty());
        if let Some((instead, other, reading)) = others.into_iter().next() {
            return match self.meant_otherwise(&instead, &reading) {
                // What is true stands as it was.
                Some(_) if is_empty || is_value => (found, Some(first)),
                Some(unclear) => (unclear, None),
                None => (other, Some(reading)),
            };
        }
        let has_variable = !first.quantities().is_disjoint(&self.alphabet.variables);
        let is_open = found.verdict == Verdict::Undecided && has_variable;
        let decided = is_open.then(|| self.decided(text, &first)).flatten();
        let (found, first) = decided.unwrap_or((found, first));
        let is_open = |short: &&Symbol| self.alphabet.loose.contains(short) && !self.has_meaning(**short);
        let loose = first.shorts.iter().find(is_open);
        match loose {
            Some(short) if found.verdict.is_wrong() => (self.asked_back(*short), None),
            _ => (found, Some(first)),
        }
    }

    /// The finding on a line that does not hold with the likeliest meaning of its short names with which it can be decided.
    fn decided(&self, text: &str, line: &Written) -> Option<(LineFinding, Written)> {
        let mut all = self.alphabet.meanings(line).into_iter();
        all.find_map(|instead| {
            let tried = self.tried_as(text, &instead, Search::Mistakes).ok()?;
            tried.0.verdict.is_wrong().then_some(tried)
        })
    }

    /// A short name that may stand for too much.
    fn asked_back(&self, short: Symbol) -> LineFinding {
        let name = self.alphabet.symbols.entry(short).name.clone();
        LineFinding::of(Verdict::Unreadable)
            .because(format!("say what `{name}` stands for: it may be several things here"))
    }

    /// The finding on the best reading of a statement.
    pub(crate) fn tried_as(
        &self,
        text: &str,
        instead: &[(Symbol, Expr)],
        search: Search,
    ) -> Result<(LineFinding, Written), Box<LineFinding>> {
        let because = |detail: String| Box::new(LineFinding::of(Verdict::Unreadable).because(detail));
        let readings = readings(text, &self.alphabet, self.before.as_ref(), self.mark, instead);
        let readings = readings.map_err(|fault| match fault {
            NoLine::NoStatement => Box::new(LineFinding::of(Verdict::Remark)),
            NoLine::NothingBefore => because("it begins with a sign, and no line stands before it".to_owned()),
            NoLine::Integral(fault) => because(fault.said().to_owned()),
            NoLine::Unreadable(fault) => because(said(&fault, &self.names_of_sheet())),
        })?;
        let mut best: Option<(LineFinding, Written)> = None;
        let in_units = readings.iter().filter_map(|written| self.in_unit_of_result(written));
        let in_terms = readings.iter().filter_map(|written| self.in_terms_asked(written));
        let others: Vec<Written> = in_units.chain(in_terms).collect();
        for mut reading in readings.into_iter().chain(others) {
            self.measure_results(&mut reading);
            let found = self.judged(&reading, search);
            // Units that do not agree are no better than another fault of the reading before.
            // A unit that is a letter, too, is one where the line holds so.
            let is_better = |(best, first): &(LineFinding, Written)| {
                let mut further = reading.shorts.difference(&first.shorts);
                let is_decided = best.verdict != Verdict::Undecided;
                let is_likely =
                    found.verdict.is_true() || is_decided && !further.any(|short| self.alphabet.loose.contains(short));
                found.verdict < best.verdict && found.verdict != Verdict::Dimensions && is_likely
            };
            if best.as_ref().is_none_or(is_better) {
                best = Some((found, reading));
            }
        }
        best.ok_or_else(|| Box::new(LineFinding::of(Verdict::Remark)))
    }

    /// Takes what is found of a reading.
    pub(crate) fn take(&mut self, found: LineFinding, reading: Written) -> LineFinding {
        self.is_in_letters &= reading.is_in_letters();
        if found.verdict.is_wrong() {
            // Of several values of one quantity the last counts: a list of guesses is worth no more than one.
            let guessed = results(&reading);
            self.accepted.iter_mut().for_each(|accepted| accepted.answers.retain(|answer| !guessed.contains(answer)));
        }
        if found.verdict.is_true() {
            let letters = reading.numbers.iter().map(|number| number.symbol);
            self.used.extend(letters.filter(|symbol| self.alphabet.numbers.contains_key(symbol)));
        }
        self.keep_meanings(&found, &reading);
        let is_of_arrows = reading.is_of_arrows;
        self.before = Some(reading);
        LineFinding { is_of_arrows, ..found }
    }

    /// The names of the quantities of the problem.
    fn names_of_sheet(&self) -> Vec<String> {
        let entries = self.worked.problem.model().symbols.iter();
        entries.map(|(_, entry)| entry.name.clone()).collect()
    }

    /// The names that a line may hold.
    pub(crate) fn printed_names(&self) -> Vec<String> {
        let names = self.alphabet.names.iter().map(|symbol| self.alphabet.symbols.entry(*symbol).name.clone());
        names.collect()
    }

    fn judged(&self, line: &Written, search: Search) -> LineFinding {
        let place = self.ground.place(&self.base);
        let value = |symbol: Symbol| place.value(symbol);
        let at = At { value: &value, units: self.units, turned: &self.turned, share: RESULT };
        let sets = meanings(line, self.worked);
        // Where a bare number may be that of a given, its dimension is not known.
        let has_given = sets
            .iter()
            .any(|set| line.numbers.iter().any(|number| number.unit.is_none() && set.is_given(number.symbol)));
        let sets = match without_clash(line, &sets) {
            Ok(sets) => sets,
            Err(_) if has_given || line.has_own => sets,
            Err(clash) => return LineFinding::of(Verdict::Dimensions).because(clash),
        };
        let here: Vec<Holds> = sets.iter().map(|set| at.line(line, set)).collect();
        let best = here.iter().copied().min().unwrap_or(Holds::Open);
        match best {
            Holds::Yes | Holds::AsFigures => match self.with_false_alternative(line, place, &sets) {
                Some(found) => found,
                None => self.holding(line, place, &sets, &here),
            },
            Holds::Open => self.open(line, place, &sets),
            Holds::No => {
                let holds = self.in_units_of_sheet(line, place, &sets);
                holds.unwrap_or_else(|| match search {
                    Search::Mistakes => self.failing(line, place, &sets, &at),
                    Search::Truth => LineFinding::of(Verdict::DoesNotFollow),
                })
            }
        }
    }
}
