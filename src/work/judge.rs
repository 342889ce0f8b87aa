//! Judging the lines of a student's work one after another.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_grade::DecimalMark;
use momentous_grade::UnreadableKind;
use momentous_problem::Worked;

use super::alphabet::alphabet;
use super::clash::without_clash;
use super::found::{Accepted, Found};
use super::ground::Ground;
use super::holds::{At, Holds, results};
use super::meaning::meanings;
use super::reader::{NoLine, readings, term};
use super::report::JudgedLine;
use super::sides::{Compared, sides, statements};
use super::unread::said;
use super::verdict::Verdict;
use super::way::Values;
use super::written::{Alphabet, Written};

/// The most lines that are judged.
pub const MOST_LINES: usize = 60;

/// A student's work on one variant: lines are judged in their order, since a line may go on from the one before.
pub struct Judge<'a> {
    pub(crate) worked: Worked<'a>,
    pub(crate) ground: Arc<Ground>,
    pub(crate) base: Values,
    pub(crate) alphabet: Alphabet,
    mark: DecimalMark,
    pub(crate) turned: Vec<Symbol>,
    before: Option<Written>,
    pub(crate) mistakes: Vec<(&'static str, usize)>,
    pub(crate) accepted: Vec<Accepted>,
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
            worked,
            ground,
            base,
            mark,
            turned: Vec::new(),
            before: None,
            mistakes: Vec::new(),
            accepted: Vec::new(),
            lines: 0,
            is_in_letters: true,
        }
    }

    /// Judges the next line.
    pub fn line(&mut self, text: &str) -> JudgedLine {
        self.lines += 1;
        self.is_in_letters = true;
        let found = self.found(text);
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
        let mut names: Vec<&str> = laws.iter().map(|law| law.name).collect();
        names.dedup();
        let message = self.message(&found, &names);
        for own in &found.mistakes {
            self.mistakes.push((own.of.id, self.lines));
        }
        let mut ids: Vec<&'static str> = laws.iter().map(|law| law.id).collect();
        ids.dedup();
        JudgedLine {
            line: self.lines,
            text: text.trim().to_owned(),
            verdict: found.verdict,
            laws: ids,
            mistakes: found.mistakes.iter().map(|own| own.of.id).collect(),
            message,
            is_in_letters: self.is_in_letters,
        }
    }

    fn found(&mut self, text: &str) -> Found {
        if self.turn(text) {
            return Found::of(Verdict::Convention);
        }
        let parts: Vec<String> = statements(text).into_iter().filter(|part| sides(part).is_some()).collect();
        if parts.len() < 2 {
            return self.stated(text);
        }
        // Of several statements the worst is told, and each may show what it shows.
        let mut worst: Option<Found> = None;
        for part in &parts {
            let found = self.stated(part);
            if let Some(earlier) = &worst {
                self.accepted.extend(earlier.accepted.clone().filter(|_| found.verdict > earlier.verdict));
            }
            match &worst {
                Some(earlier) if found.verdict <= earlier.verdict => self.accepted.extend(found.accepted),
                _ => worst = Some(found),
            }
        }
        worst.unwrap_or_else(|| Found::of(Verdict::Remark))
    }

    /// What is found of one statement. The sheet does not tell the sense of the axis across the line of impact: a line may count it
    /// the other way round.
    fn stated(&mut self, text: &str) -> Found {
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

    fn read(&mut self, text: &str) -> Found {
        let readings = match readings(text, &self.alphabet, self.before.as_ref(), self.mark) {
            Ok(readings) => readings,
            Err(NoLine::NoStatement) => return Found::of(Verdict::Remark),
            Err(NoLine::NothingBefore) => {
                return Found::of(Verdict::Unreadable)
                    .because("it begins with a sign, and no line stands before it".to_owned());
            }
            Err(NoLine::Integral(fault)) => return Found::of(Verdict::Unreadable).because(fault.said().to_owned()),
            Err(NoLine::Unreadable(fault)) => {
                return Found::of(Verdict::Unreadable).because(said(&fault, &self.printed_names()));
            }
        };
        let mut best: Option<(Found, Written)> = None;
        let in_units: Vec<Written> = readings.iter().filter_map(|own| self.in_unit_of_result(own)).collect();
        for mut reading in readings.into_iter().chain(in_units) {
            self.measure_results(&mut reading);
            let found = self.judged(&reading);
            if best.as_ref().is_none_or(|(best, _)| found.verdict < best.verdict) {
                best = Some((found, reading));
            }
        }
        let Some((found, reading)) = best else { return Found::of(Verdict::Remark) };
        self.is_in_letters &= reading.is_in_letters();
        if found.verdict.is_wrong() {
            // Of several values of one quantity the last counts: a list of guesses is worth no more than one.
            let guessed = results(&reading);
            self.accepted.iter_mut().for_each(|own| own.answers.retain(|answer| !guessed.contains(answer)));
        }
        self.before = Some(reading);
        found
    }

    /// Takes a line that begins with a letter that the problem does not have, as what that letter stands for; where the line goes on,
    /// the rest is judged.
    fn own_letter(&mut self, text: &str) -> Option<Found> {
        let sides = sides(text)?;
        let [alternatives] = sides.as_slice() else { return None };
        let [chain] = alternatives.as_slice() else { return None };
        let (name, rest) = (chain.sides.first()?.trim(), chain.sides.get(1..)?);
        if chain.signs.iter().any(|sign| *sign != Compared::Equal)
            || !is_name(name)
            || self.alphabet.vectors.is_vector(name)
        {
            return None;
        }
        let is_unknown = match term(name, &self.alphabet, self.mark) {
            Err(NoLine::Unreadable(fault)) => matches!(fault.kind, UnreadableKind::UnknownName { .. }),
            Err(_) => false,
            Ok(_) => self.alphabet.own.contains(name),
        };
        // A slip in a letter of the sheet is none of one's own.
        let is_own = self.alphabet.own.contains(name);
        let is_slip = !is_own && self.printed_names().iter().any(|own| own.eq_ignore_ascii_case(name));
        if !is_unknown || is_slip {
            return None;
        }
        let read = rest.iter().map(|side| term(side, &self.alphabet, self.mark)).collect::<Result<Vec<_>, _>>().ok()?;
        let is_in_letters =
            |(own, line): &&(Expr, Written)| own.symbols().iter().any(|symbol| line.number(*symbol).is_none());
        let (stands, line) = read.iter().find(is_in_letters).or(read.last())?.clone();
        let sets = meanings(&line, self.worked);
        let set = sets.iter().find(|set| set.is_general(&line)).or(sets.first())?;
        let value = self.in_values(&line, set, &stands);
        let found = if rest.len() > 1 { self.stated(&rest.join(" = ")) } else { Found::of(Verdict::Definition) };
        self.alphabet.own.insert(name.to_owned());
        self.alphabet.shorten(name, value);
        let wrong = found.verdict.is_wrong();
        Some(if wrong { found } else { Found { detail: name.to_owned(), ..Found::of(Verdict::OwnLetter) } })
    }

    /// The names that a line may hold.
    pub(crate) fn printed_names(&self) -> Vec<String> {
        let names = self.alphabet.names.iter().map(|symbol| self.alphabet.symbols.entry(*symbol).name.clone());
        names.collect()
    }

    fn judged(&self, line: &Written) -> Found {
        let place = self.ground.place(&self.base);
        let value = |symbol: Symbol| place.value(symbol);
        let at = At { value: &value, units: self.worked.problem.units(), turned: &self.turned };
        let sets = meanings(line, self.worked);
        // Where a bare number may be that of a given, its dimension is not known.
        let has_given =
            sets.iter().any(|set| line.numbers.iter().any(|own| own.unit.is_none() && set.is_given(own.symbol)));
        let sets = match without_clash(line, &sets) {
            Ok(sets) => sets,
            Err(_) if has_given => sets,
            Err(clash) => return Found::of(Verdict::Dimensions).because(clash),
        };
        let here: Vec<Holds> = sets.iter().map(|set| at.line(line, set)).collect();
        let best = here.iter().copied().min().unwrap_or(Holds::Open);
        match best {
            Holds::Yes | Holds::AsFigures => self.holding(line, place, &sets, &here),
            Holds::Open => self.open(line, place, &sets),
            Holds::No => self.failing(line, place, &sets, &at),
        }
    }
}

/// Whether a side is one letter with its index.
fn is_name(side: &str) -> bool {
    side.starts_with(char::is_alphabetic)
        && side.chars().all(|sign| sign.is_alphanumeric() || matches!(sign, '_' | '{' | '}' | '\'' | ','))
}
