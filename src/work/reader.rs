//! Reading a line: its sides as terms, with its integrals and series worked out and its vectors along each axis.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_grade::BehindBars;
use momentous_grade::DecimalMark;
use momentous_grade::Letters;
use momentous_grade::MAX_FORMULA;
use momentous_grade::Manner;
use momentous_grade::Unreadable;
use momentous_grade::UnreadableKind;
use momentous_grade::WrittenNumber;
use momentous_grade::read_term;
use momentous_quantity::Dimension;

use super::integrals::{self, BetweenLimits, IntegralFault, WrittenIntegral};
use super::series;
use super::sides::{Chain, sides};
use super::vectors::with_components;
use super::written::{Alphabet, Statement, Written};

/// The base of natural logarithms, where no quantity is called so.
pub(crate) const EULER: &str = "e";

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

/// The readings of a line, one as a rule; three where a letter behind a number may be a unit or a quantity. Some short names may stand for
/// something else instead of what is likeliest.
pub(crate) fn readings(
    line: &str,
    alphabet: &Alphabet,
    before: Option<&Written>,
    mark: DecimalMark,
    instead: &[(Symbol, Expr)],
) -> Result<Vec<Written>, NoLine> {
    let sides = sides(line).ok_or(NoLine::NoStatement)?;
    // The line before lends its last side, with its numbers, to a line that begins with a sign.
    let goes_on = sides.iter().flatten().any(|chain| chain.sides.first().is_some_and(|side| side.trim().is_empty()));
    let before = before.filter(|_| goes_on);
    let read = |manner| {
        let written = Written::blank(alphabet, before);
        let inserted = Vec::new();
        Reader { alphabet, instead, manner, mark, written, inserted, is_doubtful: false }.line(&sides)
    };
    let mut readings = Vec::new();
    for bars in [&[BehindBars::Doubtful][..], &[BehindBars::Above, BehindBars::Below]] {
        let mut first_fault = None;
        for behind_bars in bars.iter().copied() {
            match read(Manner { letters: Letters::Units, behind_bars }) {
                Ok((first, is_doubtful)) => {
                    readings.push(first);
                    let others = [Letters::Products, Letters::Names].into_iter().filter(|_| is_doubtful);
                    let others = others.filter_map(|letters| read(Manner { letters, behind_bars }).ok());
                    readings.extend(others.map(|(other, _)| other));
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
    within_length(side)?;
    let manner = Manner { letters: Letters::Units, behind_bars: BehindBars::Above };
    let written = Written::blank(alphabet, None);
    let inserted = Vec::new();
    let mut reader = Reader { alphabet, instead: &[], manner, mark, written, inserted, is_doubtful: false };
    let term = reader.side(1, side)?;
    Ok((term, reader.written))
}

struct Reader<'a> {
    alphabet: &'a Alphabet,
    /// The meanings of short names instead of the likeliest.
    instead: &'a [(Symbol, Expr)],
    manner: Manner,
    mark: DecimalMark,
    written: Written,
    /// Integrals and series, each under a name that stands in its place.
    inserted: Vec<(Symbol, Expr)>,
    is_doubtful: bool,
}

impl Reader<'_> {
    fn line(mut self, sides: &[Vec<Chain>]) -> Result<(Written, bool), NoLine> {
        self.written.is_of_root = sides.iter().flatten().any(|chain| chain.is_of_root);
        self.written.instead = self.instead.to_vec();
        for alternatives in sides {
            let stated = alternatives.iter().map(|chain| self.chain(chain)).collect::<Result<_, _>>()?;
            self.written.stated.push(stated);
        }
        Ok((self.written, self.is_doubtful))
    }

    fn chain(&mut self, chain: &Chain) -> Result<Vec<Statement>, NoLine> {
        chain.sides.iter().try_for_each(|side| within_length(side))?;
        let written: Vec<String> = chain.sides.iter().map(|side| with_components(side)).collect();
        let along = self.alphabet.vectors.components(&written);
        // What the sheet prints for sizes is read as arrows here.
        self.written.is_of_arrows |= along.is_some() && written.iter().any(|side| self.alphabet.has_printed_size(side));
        let as_printed = || written.iter().map(|side| self.alphabet.asked(side)).collect();
        let mut statements = Vec::new();
        for sides in along.unwrap_or_else(|| vec![as_printed()]) {
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
            return self.written.last.clone().ok_or(NoLine::NothingBefore);
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
        while let Some(between) = integrals::between_limits(&text) {
            let value = self.between_limits(&between)?;
            text = format!("{} ({}) {}", between.before, self.insert(value), between.behind);
        }
        while let Some(series) = series::first(&text) {
            let terms = series.terms.iter().map(|term| self.term(term, variable)).collect::<Result<Vec<_>, _>>()?;
            // A number that stands in several terms is the same in all of them.
            let first = |number: &WrittenNumber| {
                let is_same = |other: &&WrittenNumber| other.value == number.value && other.unit == number.unit;
                self.written.numbers.iter().find(is_same).map(|other| Expr::from(other.symbol))
            };
            let same = |symbol: Symbol| self.written.number(symbol).and_then(first);
            let terms: Vec<Expr> = terms.iter().map(|term| term.substitute(&same)).collect();
            let Some(value) = series::value(&terms) else { break };
            text = format!("{} {} {}", series.before, self.insert(value), series.behind);
        }
        let inserted = self.inserted.iter().map(|(symbol, _)| *symbol).chain(variable);
        let names: Vec<Symbol> = self.alphabet.names.iter().copied().chain(inserted).collect();
        let text = if self.alphabet.symbols.find(EULER).is_none() { with_euler(&text) } else { text };
        let read = read_term(&with_indices(&text), &mut self.written.symbols, &names, self.manner, self.mark);
        let read = read.map_err(NoLine::Unreadable)?;
        self.is_doubtful |= read.is_doubtful;
        self.written.numbers.extend(read.numbers);
        let inserted = |symbol: Symbol| self.inserted.iter().find(|(known, _)| *known == symbol);
        let Alphabet { others, loose, .. } = self.alphabet;
        let is_short = |symbol: &Symbol| others.contains_key(symbol) || loose.contains(symbol);
        for number in read.term.symbols().into_iter().filter_map(|symbol| self.alphabet.number(symbol)) {
            self.written.has_own = true;
            if self.written.number(number.symbol).is_none() {
                self.written.numbers.push(number);
            }
        }
        // What was worked out in numbers has lost its dimension.
        let lost = |symbol: &Symbol| self.alphabet.has_lost_dimension(*symbol);
        self.written.has_own |= read.term.symbols().iter().any(lost);
        self.written.shorts.extend(read.term.symbols().into_iter().filter(is_short));
        let term = self.alphabet.meant(&read.term, variable, self.instead);
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
    fn between_limits(&mut self, between: &BetweenLimits) -> Result<Expr, NoLine> {
        let term = self.term(&between.term, None)?;
        let [low, high] = [self.term(&between.limits[0], None)?, self.term(&between.limits[1], None)?];
        let is_variable =
            |symbol: &Symbol| self.alphabet.limits.contains_key(&self.written.symbols.entry(*symbol).name);
        let variable = term.symbols().into_iter().find(is_variable).ok_or(NoLine::Integral(IntegralFault::Variable))?;
        Ok(difference(&term, variable, [&low, &high]))
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
        Ok(difference(&whole, variable, [&low, &high]))
    }
}

/// Refuses a side that is too long before it is taken apart: what stands in an integral is read within it.
fn within_length(side: &str) -> Result<(), NoLine> {
    match side.chars().nth(MAX_FORMULA) {
        Some(_) => Err(NoLine::Unreadable(Unreadable { at: MAX_FORMULA, kind: UnreadableKind::TooLong(MAX_FORMULA) })),
        None => Ok(()),
    }
}

/// A term at the second end minus the term at the first.
fn difference(term: &Expr, variable: Symbol, ends: [&Expr; 2]) -> Expr {
    let [low, high] = ends.map(|end| term.substitute(&|symbol| (symbol == variable).then(|| end.clone())));
    Expr::sum([high, -low])
}

/// `300/e` as `300/exp(1)`; a power of ten stays: `9.5e-4`.
fn with_euler(side: &str) -> String {
    let mut text = String::with_capacity(side.len());
    let is_of_word = |sign: char| sign.is_alphanumeric() || matches!(sign, '_' | '\\' | '.' | '{');
    for (at, sign) in side.char_indices() {
        let behind = side[at + sign.len_utf8()..].chars().next();
        let is_alone = !side[..at].ends_with(is_of_word) && !behind.is_some_and(|next| is_of_word(next) || next == '^');
        if is_alone && sign.to_string() == EULER { text.push_str("exp(1)") } else { text.push(sign) }
    }
    text
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
