//! A line as equations in the quantities of a problem, with a symbol for each number that stands in it.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_expr::SymbolTable;
use momentous_grade::WrittenNumber;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::sides::Compared;
use super::spelling::{letters, printed};
use super::vectors::Vectors;

/// Larger whole numbers are no constants of a formula.
const LARGEST_WHOLE: u32 = 100;
/// Larger numbers of quarters are no constants of a formula.
const LARGEST_QUARTERS: u32 = 3;

/// One part in so many of a number that a letter stands for may have been rounded away.
const SHARE_ROUNDED: i64 = 200;
/// A line is tried with no more meanings of its short names.
const MOST_MEANINGS: usize = 16;

/// The letters that lines may hold, and what each stands for.
#[derive(Clone, Debug)]
pub(crate) struct Alphabet {
    /// The quantities of the problem, and behind them the short names.
    pub(crate) symbols: SymbolTable,
    /// The quantities and short names that a line may hold.
    pub(crate) names: Vec<Symbol>,
    /// The meaning of each short name.
    pub(crate) short: Vec<(Symbol, Expr)>,
    /// Spellings that are no names, each with the short name in its place: `|H_O1|`.
    pub(crate) spelt: Vec<(String, String)>,
    /// The other meanings that short names may have.
    pub(crate) others: BTreeMap<Symbol, Vec<Expr>>,
    /// Short names that the student may use for something else.
    pub(crate) loose: BTreeSet<Symbol>,
    /// Letters of the student's own that stand for numbers that were worked out.
    pub(crate) numbers: BTreeMap<Symbol, Rational>,
    /// Short names that the student has introduced.
    pub(crate) own_letters: BTreeSet<String>,
    /// The vectors of the problem.
    pub(crate) vectors: Vectors,
    /// The only limits between which the problem integrates over a variable, by its name.
    pub(crate) limits: BTreeMap<String, [Expr; 2]>,
    /// The letters over which the problem integrates: they have no value.
    pub(crate) variables: BTreeSet<Symbol>,
    /// The instants to which quantities belong.
    pub(crate) instants: BTreeMap<Symbol, usize>,
    /// The names of what is asked, by the symbols that the sheet prints for it.
    pub(crate) asked: BTreeMap<String, String>,
}

impl Alphabet {
    /// Adds a short name for a term, where the problem has no quantity of that name.
    pub(crate) fn shorten(&mut self, name: &str, term: Expr) {
        // What was worked out in numbers has lost its dimension.
        let is_own = self.own_letters.contains(name);
        let Some(dimension) = term.dimension(&self.symbols).ok().or(is_own.then_some(Dimension::NONE)) else { return };
        if let Some(known) = self.symbols.find(name) {
            // A letter of the student's own may be given another meaning.
            if self.own_letters.contains(name) {
                self.numbers.remove(&known);
                self.short.retain(|(short, _)| *short != known);
                self.short.push((known, term));
                self.others.remove(&known);
                self.symbols.measure(known, dimension);
            }
        } else {
            let short = self.symbols.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() });
            self.names.push(short);
            self.short.push((short, term));
        }
    }

    /// Adds a short name for the first of several terms; it may stand for the others, and for anything where it is loose. Where there is a name with the
    /// same letters, that one may stand for them too.
    pub(crate) fn name(&mut self, name: &str, terms: &[Expr], is_loose: bool) {
        let spelt = letters(name);
        let known = self.names.iter().copied().find(|symbol| letters(&self.symbols.entry(*symbol).name) == spelt);
        if known.is_some_and(|known| self.is_settled(known, name)) {
            return;
        }
        let first = known.is_none().then(|| terms.first()).flatten();
        if let Some(first) = first {
            self.shorten(name, first.clone());
        }
        let Some(short) = known.or_else(|| self.symbols.find(name)) else { return };
        let is_other = |term: &&Expr| **term != Expr::from(short);
        let others: Vec<Expr> = terms.iter().skip(usize::from(known.is_none())).filter(is_other).cloned().collect();
        if known.is_none() && is_loose {
            self.loose.insert(short);
        }
        self.others.insert(short, others);
    }

    /// Takes a letter of the student's own for a term, whatever else it may have stood for.
    pub(crate) fn introduce(&mut self, name: &str, term: Expr) {
        let spelt = letters(name);
        let is_same = |symbol: &Symbol| letters(&self.symbols.entry(*symbol).name) == spelt;
        let loose: BTreeSet<Symbol> = self.loose.iter().copied().filter(is_same).collect();
        self.names.retain(|symbol| !loose.contains(symbol) || self.symbols.entry(*symbol).name == name);
        self.loose.retain(|symbol| !loose.contains(symbol));
        self.own_letters.insert(name.to_owned());
        self.shorten(name, term);
    }

    /// A side as it is read: where it is the symbol that the sheet prints for what is asked, the name of that.
    pub(crate) fn asked(&self, side: &str) -> String {
        let printed = printed(side);
        let known = self.asked.get(&printed).or_else(|| self.asked.get(printed.trim_matches('|')));
        known.filter(|_| is_one_name(side)).cloned().unwrap_or_else(|| side.to_owned())
    }

    /// Whether a side is what a letter stands for.
    pub(crate) fn is_meaning(&self, side: &Expr) -> bool {
        let others = self.others.values().flatten();
        self.short.iter().map(|(_, meaning)| meaning).chain(others).any(|meaning| meaning == side)
    }

    /// A word as the product of letters of the problem: `mu` as `m u`.
    pub(crate) fn product(&self, word: &str) -> Option<Expr> {
        let mut letters = word.chars().map(|letter| self.symbols.find(&letter.to_string()));
        let is_word = word.len() > 1 && word.chars().all(|sign| sign.is_ascii_lowercase());
        let factors = is_word.then(|| letters.by_ref().collect::<Option<Vec<_>>>()).flatten()?;
        Some(factors.into_iter().map(Expr::from).fold(Expr::one(), |product, factor| product * factor))
    }

    /// Whether a name stands in a side that the sheet prints for a size, though its letters are those of an arrow.
    pub(crate) fn has_printed_size(&self, side: &str) -> bool {
        let mut names = side.split(|sign: char| !(sign.is_alphanumeric() || matches!(sign, '_' | '{' | '}')));
        names.any(|name| !name.is_empty() && self.asked.contains_key(&printed(name)))
    }

    /// Says whether a name may stand for something else, too.
    pub(crate) fn loosen(&mut self, name: &str, is_loose: bool) {
        self.loose.extend(self.symbols.find(name).filter(|_| is_loose));
    }

    /// Whether a name may stand for something else, too.
    pub(crate) fn is_loose(&self, name: &str) -> bool {
        self.symbols.find(name).is_some_and(|symbol| self.loose.contains(&symbol))
    }

    /// Takes a letter of the student's own for a number that was worked out.
    pub(crate) fn introduce_number(&mut self, name: &str, value: Rational) {
        self.introduce(name, Expr::zero());
        if let Some(symbol) = self.symbols.find(name) {
            self.short.retain(|(short, _)| *short != symbol);
            self.numbers.insert(symbol, value);
        }
    }

    /// Whether a letter of the student's own stands for a term with numbers in it that were worked out.
    pub(crate) fn has_lost_dimension(&self, symbol: Symbol) -> bool {
        let meaning = self.short.iter().find(|(short, _)| *short == symbol).map(|(_, meaning)| meaning);
        let is_own = || self.own_letters.contains(&self.symbols.entry(symbol).name);
        meaning.is_some_and(|meaning| is_own() && meaning.dimension(&self.symbols).is_err())
    }

    /// The number for which a letter of the student's own stands; its last figures were rounded away.
    pub(crate) fn number(&self, symbol: Symbol) -> Option<WrittenNumber> {
        let value = self.numbers.get(&symbol)?.clone();
        let half = if value < Rational::ZERO { -value.clone() } else { value.clone() } / Rational::from(SHARE_ROUNDED);
        Some(WrittenNumber { symbol, value, unit: None, half })
    }

    /// The meanings that short names may have, each in all combinations with the others.
    pub(crate) fn meanings(&self, line: &Written) -> Vec<Vec<(Symbol, Expr)>> {
        let mut sets: Vec<Vec<(Symbol, Expr)>> = vec![Vec::new()];
        // A letter of the sheet stands for something else only where nothing but numbers stands beside it, or where it has no value.
        let is_alone = line.quantities().len() == 1;
        let is_short =
            |symbol: &Symbol| self.short.iter().any(|(short, _)| short == symbol) || self.variables.contains(symbol);
        let shorts = line.shorts.iter().filter(|symbol| is_alone || is_short(symbol));
        for (short, others) in shorts.filter_map(|short| Some((*short, self.others.get(short)?))) {
            let with = |set: &Vec<(Symbol, Expr)>| {
                let longer = |other: &Expr| set.iter().cloned().chain([(short, other.clone())]).collect();
                std::iter::once(set.clone()).chain(others.iter().map(longer)).collect::<Vec<_>>()
            };
            sets = sets.iter().flat_map(with).take(MOST_MEANINGS).collect();
        }
        let mut sets: Vec<_> = sets.into_iter().filter(|set| !set.is_empty()).collect();
        // Likeliest are those in which all letters speak of one instant.
        sets.sort_by_cached_key(|set| {
            let meaning = |short: &Symbol| {
                let mut all = set.iter().chain(&self.short);
                all.find(|(known, _)| known == short).map(|(_, meaning)| meaning)
            };
            let symbols = line.shorts.iter().filter_map(meaning).flat_map(Expr::symbols);
            let instants: BTreeSet<usize> = symbols.filter_map(|symbol| self.instants.get(&symbol).copied()).collect();
            instants.len()
        });
        sets
    }

    /// Whether nothing is to be added to a name: it is more than a letter and one of the sheet, or of the student's own, or has been added
    /// to.
    fn is_settled(&self, known: Symbol, name: &str) -> bool {
        let entry = &self.symbols.entry(known).name;
        let is_short = self.short.iter().any(|(short, _)| *short == known);
        self.others.contains_key(&known)
            || self.own_letters.contains(entry)
            || !is_short && entry == name && entry.chars().count() > 1
    }

    /// A term with what short names stand for; the variable of an integral stands for nothing.
    pub(crate) fn meant(&self, term: &Expr, variable: Option<Symbol>, instead: &[(Symbol, Expr)]) -> Expr {
        let short = |symbol: Symbol| {
            let all = instead.iter().chain(&self.short);
            all.into_iter().find(|(short, _)| *short == symbol && Some(*short) != variable)
        };
        term.substitute(&|symbol| short(symbol).map(|(_, short_form)| short_form.clone()))
    }
}

/// Two sides of a line.
#[derive(Clone, Debug)]
pub(crate) struct Statement {
    /// The left side.
    pub(crate) left: Expr,
    /// How the sides compare.
    pub(crate) compared: Compared,
    /// The right side.
    pub(crate) right: Expr,
}

impl Statement {
    /// The difference of the sides.
    pub(crate) fn residual(&self) -> Expr {
        Expr::sum([self.left.clone(), -self.right.clone()])
    }
}

/// A line in one reading.
#[derive(Clone, Debug)]
pub(crate) struct Written {
    /// Its statements, one after another; of the alternatives of each one has to hold, with all its statements.
    pub(crate) stated: Vec<Vec<Vec<Statement>>>,
    /// The numbers.
    pub(crate) numbers: Vec<WrittenNumber>,
    /// The quantities, and behind them the numbers.
    pub(crate) symbols: SymbolTable,
    /// The last side, on which a line that begins with a sign goes on.
    pub(crate) last: Option<Expr>,
    /// Its short names that may stand for something else.
    pub(crate) shorts: BTreeSet<Symbol>,
    /// Whether a letter of the student's own stands in it that has lost its dimension.
    pub(crate) has_own: bool,
    /// Whether its alternatives are the two signs of a root.
    pub(crate) is_of_root: bool,
    /// Whether names that the sheet has for sizes stand for arrows in it.
    pub(crate) is_of_arrows: bool,
    /// What its short names stand for in this reading, where that is not the likeliest.
    pub(crate) instead: Vec<(Symbol, Expr)>,
}

impl Written {
    /// A line of which nothing is read yet; it may go on from the one before, whose last side and numbers it then has.
    pub(crate) fn blank(alphabet: &Alphabet, before: Option<&Self>) -> Self {
        let mut written = Self {
            stated: Vec::new(),
            numbers: Vec::new(),
            symbols: alphabet.symbols.clone(),
            last: None,
            shorts: BTreeSet::new(),
            has_own: false,
            is_of_root: false,
            is_of_arrows: false,
            instead: Vec::new(),
        };
        let Some(before) = before else { return written };
        // The alphabet may have grown since, so that its new names have the places of those numbers.
        let mut places: BTreeMap<Symbol, Symbol> = BTreeMap::new();
        for number in before.numbers.iter().filter(|number| !alphabet.numbers.contains_key(&number.symbol)) {
            let name = format!("number {}", written.symbols.len());
            let dimension = before.symbols.entry(number.symbol).dimension;
            let symbol = written.symbols.intern(SymbolEntry { name, dimension, meaning: String::new() });
            places.insert(number.symbol, symbol);
            written.numbers.push(WrittenNumber { symbol, ..number.clone() });
        }
        let place = |symbol: Symbol| places.get(&symbol).map(|place| Expr::from(*place));
        written.last = before.last.as_ref().map(|last| last.substitute(&place));
        written
    }

    /// The line without the numbers at the ends of its chains: what was computed, without its results.
    pub(crate) fn without_results(&self) -> Self {
        let without = |chain: &Vec<Statement>| {
            let ends = chain.iter().rev().take_while(|statement| self.number_alone(&statement.right).is_some()).count();
            chain[..(chain.len() - ends).max(1)].to_vec()
        };
        let stated: Vec<Vec<Vec<Statement>>> =
            self.stated.iter().map(|alternatives| alternatives.iter().map(without).collect()).collect();
        let kept: BTreeSet<Symbol> = stated
            .iter()
            .flatten()
            .flatten()
            .flat_map(|statement| statement.left.symbols().into_iter().chain(statement.right.symbols()))
            .collect();
        let numbers = self.numbers.iter().filter(|number| kept.contains(&number.symbol)).cloned().collect();
        Self { stated, numbers, ..self.clone() }
    }

    /// Whether a symbol stands for a number.
    pub(crate) fn number(&self, symbol: Symbol) -> Option<&WrittenNumber> {
        self.numbers.iter().find(|number| number.symbol == symbol)
    }

    /// The number that a side is, perhaps with a sign.
    pub(crate) fn number_alone(&self, side: &Expr) -> Option<&WrittenNumber> {
        match side {
            Expr::Symbol(symbol) => self.number(*symbol),
            Expr::Product(parts) => match parts.as_ref() {
                [Expr::Number(_), Expr::Symbol(symbol)] => self.number(*symbol),
                _ => None,
            },
            _ => None,
        }
    }

    /// The quantity that a side is.
    pub(crate) fn letter_alone(&self, side: &Expr) -> Option<Symbol> {
        match side {
            Expr::Symbol(symbol) if self.number(*symbol).is_none() => Some(*symbol),
            _ => None,
        }
    }

    /// Whether each term holds a quantity and each bare number may be a constant, so that bare numbers are pure.
    pub(crate) fn is_in_symbols(&self) -> bool {
        let is_measured =
            |number: &WrittenNumber| number.unit.as_ref().is_some_and(|unit| unit.dimension() != Dimension::NONE);
        self.is_made_of(
            |number| number.unit.is_some() || is_constant(&number.value),
            |number| is_measured(number) || number.value.is_zero(),
        )
    }

    /// Whether each term holds a letter or is zero, and each number is a constant of a formula: no value stands in it.
    pub(crate) fn is_in_letters(&self) -> bool {
        self.is_made_of(
            |number| number.unit.is_none() && is_constant(&number.value),
            |number| number.unit.is_none() && number.value.is_zero(),
        )
    }

    /// Whether its numbers are such, and each term holds a letter or a number that is as good as one.
    fn is_made_of(
        &self,
        is_such: impl Fn(&WrittenNumber) -> bool,
        is_as_letter: impl Fn(&WrittenNumber) -> bool,
    ) -> bool {
        let is_letter = |symbol: &Symbol| self.number(*symbol).is_none_or(&is_as_letter);
        let has_letter = |term: &Expr| term.is_zero() || term.symbols().iter().any(is_letter);
        let side = |side: &Expr| match side {
            Expr::Sum(terms) => terms.iter().all(has_letter),
            other => has_letter(other),
        };
        self.numbers.iter().all(is_such)
            && self.statements().all(|statement| side(&statement.left) && side(&statement.right))
    }

    /// The quantities in it, without its numbers.
    pub(crate) fn quantities(&self) -> BTreeSet<Symbol> {
        let symbols = self
            .statements()
            .flat_map(|statement| statement.left.symbols().into_iter().chain(statement.right.symbols()));
        symbols.filter(|symbol| self.number(*symbol).is_none()).collect()
    }

    /// All statements.
    pub(crate) fn statements(&self) -> impl Iterator<Item = &Statement> {
        self.stated.iter().flatten().flatten()
    }
}

/// Whether nothing is computed in a side.
fn is_one_name(side: &str) -> bool {
    !side.contains(['+', '*', '/', '^', '=']) && !side.trim_start().starts_with('-')
}

/// Whether a number is such as stands in formulas: `2`, `1/2`, `0.75`.
fn is_constant(value: &Rational) -> bool {
    let quarters = value * Rational::from(4);
    let largest = if value.is_int() { LARGEST_WHOLE } else { LARGEST_QUARTERS };
    quarters.is_int() && *value <= Rational::from(largest)
}
