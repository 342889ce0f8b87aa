//! Letters that the problem does not have: those that a student introduces, and those that can stand for one quantity only.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_grade::Unreadable;
use momentous_grade::UnreadableKind;
use momentous_quantity::Rational;

use super::found::LineFinding;
use super::holds::coherent_value;
use super::judge::{Judge, Search};
use super::meaning::meanings;
use super::reader::{EULER, NoLine, readings, term};
use super::sides::{Compared, sides};
use super::verdict::Verdict;
use super::written::{Alphabet, Written};

/// A value that differs from another by no more than this share was rounded to it.
const ROUNDED: f64 = 0.02;
/// A chain that begins with a letter of a student's own has no more sides behind it.
const MOST_SIDES: usize = 12;
/// A letter of a student's own has no more letters.
const LONGEST_LETTER: usize = 3;

impl Judge<'_> {
    /// Takes a line that begins with a letter that the problem does not have, as what that letter stands for; where the line goes on,
    /// the rest is judged.
    pub(crate) fn own_letter(&mut self, text: &str) -> Option<LineFinding> {
        let sides = sides(text)?;
        let [alternatives] = sides.as_slice() else { return None };
        let [chain] = alternatives.as_slice() else { return None };
        let (name, rest) = (chain.sides.first()?.trim(), chain.sides.get(1..)?);
        if chain.signs.iter().any(|sign| *sign != Compared::Equal) || !is_name(name) || rest.len() > MOST_SIDES {
            return None;
        }
        let is_own = self.alphabet.own_letters.contains(name);
        // A value of which no line has made use may be corrected.
        let is_used = |symbol: Symbol| !self.alphabet.numbers.contains_key(&symbol) || self.used.contains(&symbol);
        let is_kept = self.alphabet.symbols.find(name).is_none_or(is_used);
        let mut has_meaning = is_own && !self.alphabet.is_loose(name) && is_kept;
        let (is_unknown, is_loose) = match term(name, &self.alphabet, self.mark) {
            Err(fault) => (is_unknown_name(&fault), false),
            Ok(_) if name == EULER && self.alphabet.symbols.find(EULER).is_none() => (true, false),
            Ok((_, line)) => {
                has_meaning |= line.shorts.iter().any(|short| self.has_meaning(*short));
                (is_own, !is_own && !line.shorts.is_disjoint(&self.alphabet.loose))
            }
        };
        if self.alphabet.vectors.is_vector(name) && !is_loose {
            return None;
        }
        // A slip in a letter of the sheet is none of one's own.
        let is_slip = !is_own && self.printed_names().iter().any(|printed| printed.eq_ignore_ascii_case(name));
        if !is_loose && (!is_unknown || is_slip) {
            return None;
        }
        // A letter that has a meaning keeps it.
        if has_meaning {
            let (found, reading) = self.tried(text);
            if reading.is_none() && !found.detail.is_empty() {
                return Some(found);
            }
            if let Some(reading) = reading.filter(|_| found.verdict.is_true() || found.verdict.is_wrong()) {
                let found = if is_own && found.verdict.is_wrong() { contradicting(found, name) } else { found };
                return Some(self.take(found, reading));
            }
        }
        if is_loose
            && let (found, Some(reading)) = self.tried(text)
            && found.verdict.is_true()
        {
            return Some(self.take(found, reading));
        }
        let read = rest.iter().map(|side| term(side, &self.alphabet, self.mark));
        // A letter that was introduced in words only stands for what the other sides say.
        let read =
            read.filter(|reading| !reading.as_ref().is_err_and(is_unknown_name)).collect::<Result<Vec<_>, _>>().ok()?;
        let is_whole = read.len() == rest.len() && rest.len() > 1;
        let found = if is_whole { self.stated(&rest.join(" = ")) } else { LineFinding::of(Verdict::Definition) };
        let is_in_letters =
            |(sum, line): &&(Expr, Written)| sum.symbols().iter().any(|symbol| line.number(*symbol).is_none());
        // Where a short name in it may stand for several quantities, it stands for that with which the rest of the line holds.
        let held = self.before.as_ref().filter(|_| is_whole && found.verdict.is_true());
        let held = held.and_then(|line| Some((line.statements().next()?.left.clone(), line.clone())));
        match held.iter().chain(&read).find(is_in_letters) {
            Some((stands, line)) => {
                let sets = meanings(line, self.worked);
                let set = sets.iter().find(|set| set.is_general(line)).or(sets.first())?;
                let value = self.in_values(line, set, stands);
                let is_doubtful = !found.verdict.is_true() || !is_whole;
                let is_loose = is_doubtful && !line.shorts.is_disjoint(&self.alphabet.loose);
                self.alphabet.introduce(name, value);
                self.alphabet.loosen(name, is_loose);
            }
            None => {
                self.alphabet.introduce_number(name, self.number(&read)?);
                if let Some(symbol) = self.alphabet.symbols.find(name) {
                    self.used.remove(&symbol);
                }
                self.alphabet.loosen(name, is_loose);
            }
        }
        let wrong = found.verdict.is_wrong();
        Some(if wrong { found } else { LineFinding { detail: name.to_owned(), ..LineFinding::of(Verdict::OwnLetter) } })
    }

    /// The number that several sides are: the first, where the last is as it was rounded.
    fn number(&self, sides: &[(Expr, Written)]) -> Option<Rational> {
        let value = |(sum, line): &(Expr, Written)| {
            let units = self.units;
            sum.evaluate(&|symbol| line.number(symbol).map_or(f64::NAN, |number| coherent_value(number, units)))
        };
        let last = value(sides.last()?);
        let first = value(sides.first()?);
        let is_as_last = (first - last).abs() <= ROUNDED * last.abs();
        Rational::try_from(if is_as_last { first } else { last }).ok()
    }

    /// The finding on a chain without those of its sides in which a letter is not known; `None` where no two are left.
    pub(crate) fn with_readable_sides(&mut self, text: &str) -> Option<LineFinding> {
        let sides = sides(text)?;
        let [alternatives] = sides.as_slice() else { return None };
        let [chain] = alternatives.as_slice() else { return None };
        let is_readable =
            |side: &&String| !term(side, &self.alphabet, self.mark).is_err_and(|fault| is_unknown_name(&fault));
        // Of the first side the others say something.
        if chain.sides.first().is_none_or(|first| !is_readable(&first)) {
            return None;
        }
        let readable: Vec<&str> = chain.sides.iter().filter(is_readable).map(String::as_str).collect();
        let is_part = readable.len() >= 2 && readable.len() < chain.sides.len();
        let is_equal = chain.signs.iter().all(|sign| *sign == Compared::Equal);
        let found = (is_part && is_equal).then(|| self.plainly_stated(&readable.join(" = ")))?;
        (found.verdict != Verdict::Unreadable).then_some(found)
    }

    /// The finding on a statement with one letter that the problem does not have, where it holds if that letter is one quantity
    /// of the scene, and for no other.
    pub(crate) fn with_letter_guessed(&mut self, text: &str) -> Option<LineFinding> {
        let fault = readings(text, &self.alphabet, self.before.as_ref(), self.mark, &[]).err()?;
        let NoLine::Unreadable(Unreadable { kind: UnreadableKind::UnknownName { name: unknown, .. }, .. }) = fault
        else {
            return None;
        };
        if !is_name(&unknown) || unknown.chars().filter(|sign| sign.is_alphabetic()).count() > LONGEST_LETTER {
            return None;
        }
        let known = self.alphabet.clone();
        let told = self.ground.told.clone();
        let sought = self.ground.sought();
        let each = || told.iter().chain(&sought).map(|symbol| (symbol, Expr::from(*symbol)));
        let has_direction = |symbol: &Symbol| self.senses(*symbol).is_some();
        // A letter may be a size that is counted against the axis.
        let sizes: Vec<(&Symbol, Expr)> =
            each().filter(|(symbol, _)| has_direction(symbol)).map(|(symbol, term)| (symbol, -term)).collect();
        let mut holding: Vec<(Alphabet, LineFinding, Written)> = Vec::new();
        for (place, (symbol, stands)) in each().chain(sizes).enumerate() {
            if place >= told.len() + sought.len() && !holding.is_empty() {
                break;
            }
            self.alphabet.introduce(&unknown, stands);
            let tried = self.tried_as(text, &[], Search::Truth);
            let alphabet = std::mem::replace(&mut self.alphabet, known.clone());
            let Ok((found, reading)) = tried else { continue };
            // In letters it holds whatever the numbers are; among numbers, for what is sought only.
            let is_shown = if sought.contains(symbol) { found.verdict.is_true() } else { reading.is_in_letters() };
            let shows = matches!(found.verdict, Verdict::Follows | Verdict::Definition | Verdict::AsFigures);
            if is_shown && shows {
                holding.push((alphabet, found, reading));
            }
        }
        let Ok([(alphabet, found, reading)]) = <[_; 1]>::try_from(holding) else { return None };
        self.alphabet = alphabet;
        Some(self.take(found, reading))
    }
}

/// The finding on a line that says of a letter something else than before.
fn contradicting(found: LineFinding, name: &str) -> LineFinding {
    if found.verdict != Verdict::DoesNotFollow {
        return found;
    }
    found.because(format!("Does not follow: `{name}` has another value in the lines before."))
}

/// Whether a side has a name that is not known.
fn is_unknown_name(fault: &NoLine) -> bool {
    matches!(fault, NoLine::Unreadable(fault) if matches!(fault.kind, UnreadableKind::UnknownName { .. }))
}

/// Whether a side is one letter with its index.
fn is_name(side: &str) -> bool {
    side.starts_with(char::is_alphabetic)
        && side.chars().all(|sign| sign.is_alphanumeric() || matches!(sign, '_' | '{' | '}' | '\'' | ','))
}
