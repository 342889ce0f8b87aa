//! A line as equations in the quantities of a problem, with a symbol for each number that stands in it.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_expr::SymbolTable;
use momentous_grade::BehindBars;
use momentous_grade::DecimalMark;
use momentous_grade::Letters;
use momentous_grade::Manner;
use momentous_grade::Unreadable;
use momentous_grade::UnreadableKind;
use momentous_grade::WrittenNumber;
use momentous_grade::read_term;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::integrals::{self, BetweenLimits, IntegralFault, WrittenIntegral};
use super::series;
use super::sides::{Chain, Compared, sides};
use super::vectors::{Vectors, with_components};

/// Larger whole numbers are no constants of a formula.
const LARGEST_WHOLE: u32 = 100;
/// Larger numbers of quarters are no constants of a formula.
const LARGEST_QUARTERS: u32 = 3;

/// The letters that lines may hold, and what each stands for.
#[derive(Clone, Debug)]
pub(crate) struct Alphabet {
    /// The quantities of the problem, and behind them the short names.
    pub(crate) symbols: SymbolTable,
    /// The quantities and short names that a line may hold.
    pub(crate) names: Vec<Symbol>,
    /// What each short name stands for.
    pub(crate) short: Vec<(Symbol, Expr)>,
    /// Spellings that are no names, each with the short name in its place: `|H_O1|`.
    pub(crate) spelt: Vec<(String, String)>,
    /// Short names that the student has introduced.
    pub(crate) own: BTreeSet<String>,
    /// The vectors of the problem.
    pub(crate) vectors: Vectors,
    /// The only limits between which the problem integrates over a variable, by its name.
    pub(crate) limits: BTreeMap<String, [Expr; 2]>,
}

impl Alphabet {
    /// Adds a short name for a term, where the problem has no quantity of that name.
    pub(crate) fn shorten(&mut self, name: &str, term: Expr) {
        let Ok(dimension) = term.dimension(&self.symbols) else { return };
        if let Some(known) = self.symbols.find(name) {
            // A letter of the student's own may be given another meaning.
            self.short
                .iter_mut()
                .filter(|(short, _)| *short == known && self.own.contains(name))
                .for_each(|(_, own)| *own = term.clone());
        } else {
            let short = self.symbols.intern(SymbolEntry { name: name.to_owned(), dimension, meaning: String::new() });
            self.names.push(short);
            self.short.push((short, term));
        }
    }

    /// A term with what short names stand for; the variable of an integral stands for nothing.
    fn meant(&self, term: &Expr, variable: Option<Symbol>) -> Expr {
        let short = |symbol: Symbol| self.short.iter().find(|(short, _)| *short == symbol && Some(*short) != variable);
        term.substitute(&|symbol| short(symbol).map(|(_, own)| own.clone()))
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
    /// What it states, one after another; of the alternatives of each one has to hold, with all its statements.
    pub(crate) stated: Vec<Vec<Vec<Statement>>>,
    /// The numbers.
    pub(crate) numbers: Vec<WrittenNumber>,
    /// The quantities, and behind them the numbers.
    pub(crate) symbols: SymbolTable,
    /// The last side, on which a line that begins with a sign goes on.
    pub(crate) last: Option<Expr>,
}

/// Why a line is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum NoLine {
    /// No sides are compared in it.
    NoStatement,
    /// A side cannot be read.
    Unreadable(Unreadable),
    /// An integral cannot be worked out.
    Integral(IntegralFault),
    /// It begins with a sign, and nothing stands before it.
    NothingBefore,
}

/// The readings of a line, one as a rule; two where a letter behind a number may be a unit or a quantity.
pub(crate) fn readings(
    line: &str,
    alphabet: &Alphabet,
    before: Option<&Written>,
    mark: DecimalMark,
) -> Result<Vec<Written>, NoLine> {
    let sides = sides(line).ok_or(NoLine::NoStatement)?;
    // The line before lends its last side, with its numbers, to a line that begins with a sign.
    let goes_on = sides.iter().flatten().any(|chain| chain.sides.first().is_some_and(|side| side.trim().is_empty()));
    let before = before.filter(|_| goes_on);
    let read = |manner| {
        let written = Written::blank(alphabet, before);
        Reader { alphabet, manner, mark, before, written, inserted: Vec::new(), is_doubtful: false }.line(&sides)
    };
    let mut readings = Vec::new();
    for bars in [&[BehindBars::Doubtful][..], &[BehindBars::Above, BehindBars::Below]] {
        let mut first_fault = None;
        for behind_bars in bars.iter().copied() {
            match read(Manner { letters: Letters::Units, behind_bars }) {
                Ok((first, is_doubtful)) => {
                    readings.push(first);
                    let second = Manner { letters: Letters::Names, behind_bars };
                    readings.extend(is_doubtful.then(|| read(second).ok()).flatten().map(|(second, _)| second));
                }
                Err(fault) => {
                    first_fault.get_or_insert(fault);
                }
            }
        }
        let is_doubtful = |fault: &NoLine| matches!(fault, NoLine::Unreadable(fault) if fault.kind == UnreadableKind::ProductAfterBar);
        match first_fault {
            Some(fault) if readings.is_empty() && !is_doubtful(&fault) => return Err(fault),
            _ if !readings.is_empty() => break,
            _ => {}
        }
    }
    if readings.is_empty() { Err(NoLine::NoStatement) } else { Ok(readings) }
}

/// A line that is one side only, in its first reading.
pub(crate) fn term(side: &str, alphabet: &Alphabet, mark: DecimalMark) -> Result<(Expr, Written), NoLine> {
    let manner = Manner { letters: Letters::Units, behind_bars: BehindBars::Above };
    let written = Written::blank(alphabet, None);
    let mut reader = Reader { alphabet, manner, mark, before: None, written, inserted: Vec::new(), is_doubtful: false };
    let term = reader.side(1, side)?;
    Ok((term, reader.written))
}

impl Written {
    fn blank(alphabet: &Alphabet, before: Option<&Self>) -> Self {
        let symbols = before.map_or_else(|| alphabet.symbols.clone(), |before| before.symbols.clone());
        let numbers = before.map_or_else(Vec::new, |before| before.numbers.clone());
        Self { stated: Vec::new(), numbers, symbols, last: None }
    }

    /// Whether a symbol stands for a number.
    pub(crate) fn number(&self, symbol: Symbol) -> Option<&WrittenNumber> {
        self.numbers.iter().find(|number| number.symbol == symbol)
    }

    /// Whether each term holds a quantity and each bare number may be a constant, so that bare numbers are pure.
    pub(crate) fn is_in_symbols(&self) -> bool {
        let is_measured =
            |own: &WrittenNumber| own.unit.as_ref().is_some_and(|unit| unit.dimension() != Dimension::NONE);
        let is_quantity =
            |symbol: &Symbol| self.number(*symbol).is_none_or(|own| is_measured(own) || own.value.is_zero());
        let has_quantity = |term: &Expr| term.is_zero() || term.symbols().iter().any(is_quantity);
        let side = |side: &Expr| match side {
            Expr::Sum(terms) => terms.iter().all(has_quantity),
            other => has_quantity(other),
        };
        let is_plain = |own: &WrittenNumber| own.unit.is_some() || is_constant(&own.value);
        self.numbers.iter().all(is_plain) && self.statements().all(|own| side(&own.left) && side(&own.right))
    }

    /// Whether each term holds a letter or is zero, and each number is a constant of a formula: no value stands in it.
    pub(crate) fn is_in_letters(&self) -> bool {
        let is_letter =
            |symbol: &Symbol| self.number(*symbol).is_none_or(|own| own.unit.is_none() && own.value.is_zero());
        let has_letter = |term: &Expr| term.is_zero() || term.symbols().iter().any(is_letter);
        let side = |side: &Expr| match side {
            Expr::Sum(terms) => terms.iter().all(has_letter),
            other => has_letter(other),
        };
        let is_plain = |own: &WrittenNumber| own.unit.is_none() && is_constant(&own.value);
        self.numbers.iter().all(is_plain) && self.statements().all(|own| side(&own.left) && side(&own.right))
    }

    /// The quantities in it, without its numbers.
    pub(crate) fn quantities(&self) -> BTreeSet<Symbol> {
        let symbols = self.statements().flat_map(|own| own.left.symbols().into_iter().chain(own.right.symbols()));
        symbols.filter(|symbol| self.number(*symbol).is_none()).collect()
    }

    /// All statements.
    pub(crate) fn statements(&self) -> impl Iterator<Item = &Statement> {
        self.stated.iter().flatten().flatten()
    }
}

struct Reader<'a> {
    alphabet: &'a Alphabet,
    manner: Manner,
    mark: DecimalMark,
    before: Option<&'a Written>,
    written: Written,
    /// Integrals and series, each under a name that stands in its place.
    inserted: Vec<(Symbol, Expr)>,
    is_doubtful: bool,
}

impl Reader<'_> {
    fn line(mut self, sides: &[Vec<Chain>]) -> Result<(Written, bool), NoLine> {
        for alternatives in sides {
            let stated = alternatives.iter().map(|chain| self.chain(chain)).collect::<Result<_, _>>()?;
            self.written.stated.push(stated);
        }
        Ok((self.written, self.is_doubtful))
    }

    fn chain(&mut self, chain: &Chain) -> Result<Vec<Statement>, NoLine> {
        let written: Vec<String> = chain.sides.iter().map(|side| with_components(side)).collect();
        let along = self.alphabet.vectors.components(&written);
        let mut statements = Vec::new();
        for sides in along.as_deref().unwrap_or(std::slice::from_ref(&written)) {
            let terms: Vec<Expr> =
                sides.iter().enumerate().map(|(place, side)| self.side(place, side)).collect::<Result<_, _>>()?;
            let pairs = terms.windows(2).zip(&chain.signs);
            statements.extend(pairs.filter_map(|(pair, sign)| match pair {
                [left, right] => Some(Statement { left: left.clone(), compared: *sign, right: right.clone() }),
                _ => None,
            }));
            self.written.last = terms.last().cloned();
        }
        Ok(statements)
    }

    fn side(&mut self, place: usize, side: &str) -> Result<Expr, NoLine> {
        if side.trim().is_empty() && place == 0 {
            let last = self.written.last.clone().or_else(|| self.before.and_then(|before| before.last.clone()));
            return last.ok_or(NoLine::NothingBefore);
        }
        let side = self.alphabet.spelt.iter().fold(side.to_owned(), |side, (text, name)| side.replace(text, name));
        self.term(&side, None)
    }

    /// A term, whose integrals and series are worked out first. The variable is that of the integral in which it stands.
    fn term(&mut self, text: &str, variable: Option<Symbol>) -> Result<Expr, NoLine> {
        let mut text = self.alphabet.vectors.with_sizes(text);
        while let Some(integral) = integrals::first(&text) {
            let integral = integral.map_err(NoLine::Integral)?;
            let value = self.integral(&integral)?;
            text = format!("{} {} {}", integral.before, self.insert(value), integral.behind);
        }
        while let Some(own) = integrals::between_limits(&text) {
            let value = self.between_limits(&own)?;
            text = format!("{} ({}) {}", own.before, self.insert(value), own.behind);
        }
        while let Some(series) = series::first(&text) {
            let terms = series.terms.iter().map(|term| self.term(term, variable)).collect::<Result<Vec<_>, _>>()?;
            // A number that stands in several terms is the same in all of them.
            let first = |own: &WrittenNumber| {
                let is_same = |other: &&WrittenNumber| other.value == own.value && other.unit == own.unit;
                self.written.numbers.iter().find(is_same).map(|other| Expr::from(other.symbol))
            };
            let same = |symbol: Symbol| self.written.number(symbol).and_then(first);
            let terms: Vec<Expr> = terms.iter().map(|term| term.substitute(&same)).collect();
            let Some(value) = series::value(&terms) else { break };
            text = format!("{} {} {}", series.before, self.insert(value), series.behind);
        }
        let inserted = self.inserted.iter().map(|(symbol, _)| *symbol).chain(variable);
        let names: Vec<Symbol> = self.alphabet.names.iter().copied().chain(inserted).collect();
        let read = read_term(&with_indices(&text), &mut self.written.symbols, &names, self.manner, self.mark);
        let read = read.map_err(NoLine::Unreadable)?;
        self.is_doubtful |= read.is_doubtful;
        self.written.numbers.extend(read.numbers);
        let inserted = |symbol: Symbol| self.inserted.iter().find(|(own, _)| *own == symbol);
        let term = self.alphabet.meant(&read.term, variable);
        Ok(term.substitute(&|symbol| inserted(symbol).map(|(_, value)| value.clone())))
    }

    /// The name that stands for a value in what is still to be read.
    fn insert(&mut self, value: Expr) -> String {
        let name = format!("inserted_{}", self.inserted.len() + 1);
        let dimension = value.dimension(&self.written.symbols).unwrap_or(Dimension::NONE);
        let entry = SymbolEntry { name: name.clone(), dimension, meaning: String::new() };
        self.inserted.push((self.written.symbols.intern(entry), value));
        name
    }

    /// The difference of a term at two limits: of the variable over which the scene integrates.
    fn between_limits(&mut self, own: &BetweenLimits) -> Result<Expr, NoLine> {
        let term = self.term(&own.term, None)?;
        let [low, high] = [self.term(&own.limits[0], None)?, self.term(&own.limits[1], None)?];
        let is_variable =
            |symbol: &Symbol| self.alphabet.limits.contains_key(&self.written.symbols.entry(*symbol).name);
        let variable = term.symbols().into_iter().find(is_variable).ok_or(NoLine::Integral(IntegralFault::Variable))?;
        let at = |end: &Expr| term.substitute(&|symbol| (symbol == variable).then(|| end.clone()));
        Ok(Expr::sum([at(&high), -at(&low)]))
    }

    fn integral(&mut self, integral: &WrittenIntegral) -> Result<Expr, NoLine> {
        let [low, high] = match &integral.limits {
            Some([low, high]) => [self.term(low, None)?, self.term(high, None)?],
            None => {
                let known = self.alphabet.limits.get(&integral.variable);
                known.cloned().ok_or(NoLine::Integral(IntegralFault::Limits))?
            }
        };
        let dimension = high.dimension(&self.written.symbols).unwrap_or(Dimension::NONE);
        let entry = SymbolEntry { name: integral.variable.clone(), dimension, meaning: String::new() };
        let variable =
            self.written.symbols.find(&integral.variable).unwrap_or_else(|| self.written.symbols.intern(entry));
        let integrand = self.term(&integral.integrand, Some(variable))?;
        let whole = integrand.integrate(variable).ok_or(NoLine::Integral(IntegralFault::Formula))?;
        let at = |end: &Expr| whole.substitute(&|symbol| (symbol == variable).then(|| end.clone()));
        Ok(Expr::sum([at(&high), -at(&low)]))
    }
}

/// Whether a number is such as stands in formulas: `2`, `1/2`, `0.75`.
fn is_constant(value: &Rational) -> bool {
    let quarters = value * Rational::from(4);
    let largest = if value.is_int() { LARGEST_WHOLE } else { LARGEST_QUARTERS };
    quarters.is_int() && *value <= Rational::from(largest)
}

/// A side with the stages and instants of names as indices: `J_A[hit]` as `J_A_{hit}`, `v_A@top` as `v_A_{top}`.
fn with_indices(side: &str) -> String {
    let mut text = String::with_capacity(side.len());
    let mut rest = side;
    while let Some(first) = rest.chars().next() {
        let behind = &rest[first.len_utf8()..];
        let is_of_name = text.ends_with(|before: char| before.is_alphanumeric() || before == '}');
        let is_letter = |sign: char| sign.is_alphanumeric() || sign == '_';
        let (index, after) = match first {
            '[' if is_of_name => behind.split_once(']').unwrap_or(("", behind)),
            '@' if is_of_name => behind.split_at(behind.find(|sign: char| !is_letter(sign)).unwrap_or(behind.len())),
            _ => ("", behind),
        };
        if !index.is_empty() && index.chars().all(is_letter) {
            text.extend(["_{", index, "}"]);
            rest = after;
        } else {
            text.push(first);
            rest = behind;
        }
    }
    text
}
