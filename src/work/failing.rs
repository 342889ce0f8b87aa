//! Lines whose sides do not agree, or cannot be tried: why.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_quantity::Dimension;
use momentous_solve::Bounded;

use super::bare_units::BareUnits;
use super::clash::without_clash;
use super::elsewhere::{Elsewhere, elsewhere};
use super::found::LineFinding;
use super::ground::Place;
use super::holds::{At, Holds, RESULT, is_identity};
use super::judge::Judge;
use super::meaning::Meanings;
use super::sides::Compared;
use super::verdict::{Verdict, list};
use super::written::{Statement, Written};
use super::wrong::WrongSystems;

/// The shares of the way between its limits at which a function is tried.
const SHARES: [f64; 3] = [0.17, 0.48, 0.81];

impl Judge<'_> {
    /// The verdict on a line that cannot be tried.
    pub(crate) fn open(&self, line: &Written, place: Place<'_>, sets: &[Meanings]) -> LineFinding {
        let missing = line.quantities().into_iter().find(|symbol| place.value(*symbol).is_none());
        if let Some(verdict) = missing.and_then(|variable| self.of_function(line, place, sets, variable)) {
            return LineFinding::of(verdict);
        }
        if missing.is_none() && sets.iter().any(|set| set.is_general(line) && is_identity(line, set)) {
            return LineFinding::of(Verdict::Identity);
        }
        let detail = missing.map_or_else(
            || "its numbers are too close to tell".to_owned(),
            |symbol| format!("{} does not follow from what is given", self.worked.problem.name_of(symbol)),
        );
        LineFinding::of(Verdict::Undecided).because(detail)
    }

    /// The verdict on a function of a variable over which the scene integrates, `F = F_0 e^(-t/T)`: it says what is given where it
    /// holds between the limits.
    fn of_function(&self, line: &Written, place: Place<'_>, sets: &[Meanings], variable: Symbol) -> Option<Verdict> {
        let limits = self.alphabet.limits.get(&line.symbols.entry(variable).name)?;
        let number = |symbol: Symbol| place.value(symbol).map_or(f64::NAN, |number| number.value);
        let [low, high] = limits.each_ref().map(|limit| limit.evaluate(&number));
        let holds = |set: &Meanings| {
            let at_share = |share: f64| {
                let between = Bounded::exactly(low + share * (high - low));
                let value = |symbol: Symbol| if symbol == variable { Some(between) } else { place.value(symbol) };
                At { value: &value, units: self.units, turned: &self.turned, share: RESULT }.line(line, set)
            };
            SHARES.map(at_share).into_iter().max().unwrap_or(Holds::Open)
        };
        // What belongs to one instant is something else at another.
        let model = self.worked.problem.model();
        let is_momentary =
            |symbol: &Symbol| symbol.index() < model.symbols.len() && model.name(*symbol).instant.is_some();
        match sets.iter().map(holds).min()? {
            Holds::Yes | Holds::AsFigures => Some(Verdict::Restates),
            Holds::Open => None,
            Holds::No if line.quantities().iter().any(is_momentary) => None,
            Holds::No => Some(Verdict::DoesNotFollow),
        }
    }

    /// Whether a bare number is that of a given in a unit in which bare numbers do not count.
    fn has_printed_number(&self, line: &Written, units: BareUnits) -> bool {
        self.worked.variant.all_given().iter().any(|(_, value, unit)| {
            let is_other = unit.dimension() != Dimension::NONE && !units.has(unit);
            let printed = value.to_rational();
            is_other && line.numbers.iter().any(|number| number.unit.is_none() && number.value == printed)
        })
    }

    /// The finding on a line where its bare numbers count in the units of the sheet, with which it holds.
    pub(crate) fn in_units_of_sheet(&self, line: &Written, place: Place<'_>, sets: &[Meanings]) -> Option<LineFinding> {
        let units = BareUnits::of_sheet(self.worked).filter(|_| self.has_printed_number(line, self.units))?;
        let value = |symbol: Symbol| place.value(symbol);
        let at = At { value: &value, units, turned: &self.turned, share: RESULT };
        let here: Vec<Holds> = sets.iter().map(|set| at.line(line, set)).collect();
        let is_held = here.iter().any(|holds| matches!(holds, Holds::Yes | Holds::AsFigures));
        is_held.then(|| self.holding(line, place, sets, &here))
    }

    /// The question about a value that is right but for its sign, where the sign is a direction.
    fn opposite(&self, line: &Written, sets: &[Meanings], at: &At<'_>) -> Option<String> {
        let [alternatives] = line.stated.as_slice() else { return None };
        let [chain] = alternatives.as_slice() else { return None };
        let letter = line.letter_alone(&chain.first()?.left)?;
        let [positive, negative] = self.senses(letter)?;
        let is_value = |side: &Expr| line.number_alone(side).is_some() || has_root(side);
        let are_equal = chain.iter().all(|statement| statement.compared == Compared::Equal);
        if !are_equal || !chain.iter().any(|statement| is_value(&statement.right)) {
            return None;
        }
        let turned = |symbol: Symbol| (symbol == letter).then(|| -Expr::from(letter));
        let opposite =
            |statement: &Statement| Statement { left: statement.left.substitute(&turned), ..statement.clone() };
        let opposite: Vec<Statement> = chain.iter().map(opposite).collect();
        let holds = sets.iter().any(|set| at.chain(line, &opposite, set) <= Holds::AsFigures);
        holds.then(|| {
            format!("Does not follow: the size is right, and the sign is not. Is it {positive} or {negative}?")
        })
    }

    /// The question about an equation whose sides have the same size and opposite signs, where these are directions.
    fn opposite_sides(&self, line: &Written, sets: &[Meanings], at: &At<'_>) -> Option<String> {
        let [alternatives] = line.stated.as_slice() else { return None };
        let [chain] = alternatives.as_slice() else { return None };
        let has_senses = |side: &Expr| side.symbols().iter().any(|symbol| self.senses(*symbol).is_some());
        let is_one = |side: &Expr| !matches!(side, Expr::Sum(_)) && has_senses(side);
        let is_such = |statement: &Statement| {
            statement.compared == Compared::Equal && is_one(&statement.left) && is_one(&statement.right)
        };
        if !chain.iter().all(is_such) {
            return None;
        }
        let opposite = |statement: &Statement| Statement { left: -statement.left.clone(), ..statement.clone() };
        let opposite: Vec<Statement> = chain.iter().map(opposite).collect();
        let holds = sets.iter().any(|set| at.chain(line, &opposite, set) <= Holds::AsFigures);
        holds.then(|| {
            "Does not follow: both sides have the same size, and opposite signs. Which way does each point?".to_owned()
        })
    }

    /// The request for the letters that the sheet gives without a value, where a line holds only if they are one.
    fn without_letters(&self, line: &Written, sets: &[Meanings]) -> Option<String> {
        let (letters, ones) = self.ground.letters_as_one(self.worked)?;
        let place = self.ground.place(&ones);
        let value = |symbol: Symbol| place.value(symbol);
        let at = At { value: &value, units: self.units, turned: &self.turned, share: RESULT };
        let holds = sets.iter().any(|set| at.line(line, set) <= Holds::AsFigures);
        let names: Vec<String> =
            letters.iter().map(|letter| format!("`{}`", self.worked.problem.name_of(*letter))).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        holds.then(|| format!("it holds only where {} are one. Write these letters in it", list(&names)))
    }

    /// Why a line does not hold.
    pub(crate) fn failing(&self, line: &Written, place: Place<'_>, sets: &[Meanings], at: &At<'_>) -> LineFinding {
        if let Err(clash) = without_clash(line, sets)
            && !line.has_own
        {
            return LineFinding::of(Verdict::Dimensions).because(clash);
        }
        if let Some(request) = self.without_letters(line, sets) {
            return LineFinding::of(Verdict::Undecided).because(request);
        }
        if let Some(question) = self.opposite(line, sets, at) {
            return LineFinding::of(Verdict::DoesNotFollow).because(question);
        }
        // An inequality holds with many a mistake.
        if line.statements().all(|statement| statement.compared != Compared::Equal) {
            return LineFinding::of(Verdict::DoesNotFollow);
        }
        let follows = WrongSystems::of(&self.ground, self.worked, place, (line, sets), at, &self.mistakes);
        if !follows.iter().any(|follows| follows.is_itself)
            && let Some(question) = self.opposite_sides(line, sets, at)
        {
            return LineFinding::of(Verdict::DoesNotFollow).because(question);
        }
        if !follows.is_empty() {
            return LineFinding { mistakes: follows, ..LineFinding::of(Verdict::Mistake) };
        }
        // Bare numbers in the units of the sheet: their results may be in any.
        let of_sheet = BareUnits::of_sheet(self.worked).is_some_and(|units| !self.has_printed_number(line, units));
        if self.has_printed_number(line, self.units) && !of_sheet && !line.is_in_symbols() {
            return LineFinding::of(Verdict::Undecided).because("write the units of its numbers".to_owned());
        }
        match elsewhere(self.worked, place, (line, sets), at) {
            Some((Elsewhere::Instant, symbol)) => {
                LineFinding::of(Verdict::OtherInstant).because(self.worked.problem.name_of(symbol))
            }
            Some((Elsewhere::Body, symbol)) => {
                LineFinding::of(Verdict::OtherBody).because(self.worked.problem.name_of(symbol))
            }
            None => LineFinding::of(Verdict::DoesNotFollow),
        }
    }
}

/// Whether a term has a root in it, whose sign is chosen.
fn has_root(term: &Expr) -> bool {
    let is_root = matches!(term, Expr::Power(pair) if pair.1.as_number().is_some_and(|exponent| !exponent.is_int()));
    is_root || term.children().any(has_root)
}
