//! A side of an equation as a student writes it: names, and numbers with units, each number as a symbol of its own. So what a number
//! stands for can still be asked when the term is read.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_expr::SymbolTable;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;
use momentous_quantity::Unit;

use super::super::numeral::DecimalMark;
use super::super::unreadable::{Unreadable, UnreadableKind};
use super::grammar::Grammar;
use super::names::{self, Names};
use super::token::{Lexeme, Token};
use super::vocabulary::{BehindBars, Letters, Manner, Vocabulary};
use super::{MAX_FORMULA, lexer, resolve};

/// A unit has no more words.
const MAX_WORDS: usize = 6;
/// Numbers have no more decimals than this where their last place counts.
const MOST_DECIMALS: isize = 6;
/// No power of ten behind a number is larger.
const MAX_POWER_OF_TEN: usize = 40;
/// A number without decimals stands for what rounds to it within this share, where it has fewer figures than that.
const WHOLE: (i64, i64) = (1, 200);

/// The least number of three figures.
const FEWEST_FIGURES: i64 = 100;
/// Functions of an angle.
const ANGULAR: [&str; 3] = ["sin", "cos", "tan"];
/// No angle in radians is larger than a whole turn.
const WHOLE_TURN: i64 = 6;

/// A number in a term.
#[derive(Clone, Debug, PartialEq)]
pub struct WrittenNumber {
    /// The symbol that stands for it in the term.
    pub symbol: Symbol,
    /// Its value in its unit.
    pub value: Rational,
    /// Its unit; none where none is written.
    pub unit: Option<Unit>,
    /// How far it may lie from what was rounded to it, in its unit.
    pub half: Rational,
}

/// A term, read.
#[derive(Clone, Debug, PartialEq)]
pub struct WrittenTerm {
    /// The term, with a symbol for each number.
    pub term: Expr,
    /// The numbers, in the order in which they are written.
    pub numbers: Vec<WrittenNumber>,
    /// Whether a letter behind a number may be a unit or a quantity.
    pub is_doubtful: bool,
}

/// Reads a term in which quantities and numbers with units may stand. Numbers are added to the symbols.
///
/// ```
/// use momentous_expr::{SymbolEntry, SymbolTable};
/// use momentous_grade::{BehindBars, DecimalMark, Letters, Manner, read_term};
/// use momentous_quantity::Dimension;
///
/// let mut symbols = SymbolTable::default();
/// let entry = SymbolEntry { name: "v_A1".into(), dimension: Dimension::VELOCITY, meaning: String::new() };
/// let names = [symbols.intern(entry)];
/// let manner = Manner { letters: Letters::Units, behind_bars: BehindBars::Doubtful };
/// let read = read_term("2.0 kg * v_{A1} + (3 kg)(1.5 m/s)", &mut symbols, &names, manner, DecimalMark::Point)?;
/// assert_eq!(read.numbers.len(), 3);
/// assert_eq!(read.term.dimension(&symbols), Ok(Dimension::MOMENTUM));
/// # Ok::<(), momentous_grade::Unreadable>(())
/// ```
///
/// # Errors
/// Where the text is no term, or may be read in two ways.
pub fn read_term(
    text: &str,
    symbols: &mut SymbolTable,
    names: &[Symbol],
    manner: Manner,
    mark: DecimalMark,
) -> Result<WrittenTerm, Unreadable> {
    if text.chars().nth(MAX_FORMULA).is_some() {
        return Err(Unreadable { at: MAX_FORMULA, kind: UnreadableKind::TooLong(MAX_FORMULA) });
    }
    let fault = |(at, kind)| Unreadable { at, kind };
    let (lexemes, numbers_taken) = {
        let known = Vocabulary {
            symbols,
            names: names.to_vec(),
            asked: None,
            numbers: Vec::new(),
            behind_bars: BehindBars::Doubtful,
        };
        let names = Names::new(&known);
        let lexemes = lexer::lexemes(text, mark, names.has_own_e()).map_err(fault)?;
        let mut numbers = Numbers { names: &names, letters: manner.letters, taken: Vec::new(), is_doubtful: false };
        let lexemes = numbers.replace(&lexemes);
        (resolve::resolve(lexemes, &names).map_err(fault)?, (numbers.taken, numbers.is_doubtful))
    };
    let (numbers, is_doubtful) = numbers_taken;
    let numbers: Vec<WrittenNumber> = numbers
        .into_iter()
        .map(|Number { value, unit, half }| {
            let dimension = unit.as_ref().map_or(Dimension::NONE, Unit::dimension);
            let name = format!("number {}", symbols.len());
            WrittenNumber {
                symbol: symbols.intern(SymbolEntry { name, dimension, meaning: String::new() }),
                value,
                unit,
                half,
            }
        })
        .collect();
    let written = numbers.iter().map(|number| number.symbol).collect();
    let known =
        Vocabulary { symbols, names: names.to_vec(), asked: None, numbers: written, behind_bars: manner.behind_bars };
    let end = text.trim_end().chars().count();
    let term = Grammar::new(&lexemes, end, &known).whole().map_err(fault)?;
    Ok(WrittenTerm { term, numbers, is_doubtful })
}

/// A number as it stands in the text.
struct Number {
    value: Rational,
    unit: Option<Unit>,
    half: Rational,
}

/// Takes the numbers out of a text.
struct Numbers<'a> {
    names: &'a Names<'a>,
    letters: Letters,
    taken: Vec<Number>,
    is_doubtful: bool,
}

impl Numbers<'_> {
    /// The tokens with each number and its unit as one; exponents and the degrees of roots stay what they are.
    fn replace(&mut self, lexemes: &[Lexeme]) -> Vec<Lexeme> {
        let mut kept = Vec::with_capacity(lexemes.len());
        let mut at = 0;
        while let Some(lexeme) = lexemes.get(at) {
            match &lexeme.token {
                Token::Power | Token::IndexedRoot => {
                    let end = behind_exponent(lexemes, at + 1);
                    kept.extend_from_slice(&lexemes[at..end]);
                    at = end;
                }
                Token::Number { value, half } => {
                    let power = power_of_ten(lexemes, at + 1);
                    // Before a power of ten the figures are those that count: `2.2*10^3`.
                    let figures = power.as_ref().and_then(|_| half_of_last_place(value));
                    let (factor, behind) = power.unwrap_or((Rational::ONE, at + 1));
                    let half = half.clone().or(figures).unwrap_or_else(|| rounding(value));
                    let (unit, end) = self.unit(lexemes, behind, *value == Rational::from(2));
                    let unit = unit.or_else(|| is_in_degrees(&kept, value, lexemes.get(end)).then(Unit::degree));
                    let token = Token::Written { place: self.taken.len(), measured: unit.is_some() };
                    self.taken.push(Number { value: value * &factor, half: half * factor, unit });
                    kept.push(Lexeme { token, ..lexeme.clone() });
                    at = end;
                }
                _ => {
                    kept.push(lexeme.clone());
                    at += 1;
                }
            }
        }
        kept
    }

    /// Whether what stands behind a letter goes on with its product: another quantity, a bracket or a function; or it is divided, and more
    /// stands behind: `sqrt(2 h/g)`.
    fn is_in_product(&self, lexemes: &[Lexeme], at: usize) -> bool {
        match lexemes.get(at).map(|lexeme| &lexeme.token) {
            Some(Token::Word(letters)) => self.names.whole(letters).is_some(),
            Some(Token::Over) => match lexemes.get(at + 1).map(|lexeme| &lexeme.token) {
                Some(Token::Word(letters)) => self.names.whole(letters).is_some() && lexemes.len() > at + 2,
                divisor => matches!(divisor, Some(Token::Open(_) | Token::Number { .. } | Token::Written { .. })),
            },
            Some(Token::Open(_) | Token::Function(_)) => true,
            _ => false,
        }
    }

    /// The unit that begins at a token, the longest that can be read, and the token behind it.
    fn unit(&mut self, lexemes: &[Lexeme], from: usize, is_two: bool) -> (Option<Unit>, usize) {
        let (mut text, mut at, mut words) = (String::new(), from, 0);
        let (mut is_name, mut is_split) = (false, false);
        let mut longest = (None, from);
        while let Some(lexeme) = lexemes.get(at) {
            match &lexeme.token {
                Token::Word(letters) if words < MAX_WORDS => {
                    let is_several = words == 0 && self.names.is_several(letters);
                    is_name |= self.names.whole(letters).is_some();
                    let is_before_word =
                        matches!(lexemes.get(at + 1).map(|lexeme| &lexeme.token), Some(Token::Word(_)));
                    // `2 g h` is no number of gram hours, and `v^2/(2 g)` holds no mass.
                    let is_gravity = (is_before_word || is_two) && names::text(letters) == "g";
                    let is_factor = words == 0
                        && self.letters == Letters::Products
                        && (is_several || is_name && self.is_in_product(lexemes, at + 1));
                    if is_factor || is_name && (self.letters == Letters::Names || is_gravity) {
                        break;
                    }
                    if words > 0 && !text.ends_with(['/', '*']) {
                        text.push(' ');
                    }
                    text.push_str(&names::text(letters));
                    words += 1;
                    is_split |= is_several;
                }
                Token::Degree if words == 0 => {
                    return (Some(Unit::degree()), at + 1);
                }
                Token::Over if words > 0 => text.push('/'),
                Token::Times if words > 0 => text.push('*'),
                Token::Power if words > 0 => {
                    let end = behind_exponent(lexemes, at + 1);
                    let Some(exponent) = whole_exponent(&lexemes[at + 1..end]) else { break };
                    text.push('^');
                    text.push_str(&exponent);
                    at = end - 1;
                }
                _ => break,
            }
            at += 1;
            if let Ok(unit) = Unit::parse(&text) {
                longest = (Some(unit), at);
                self.is_doubtful |= is_name || is_split;
            }
        }
        longest
    }
}

/// The token behind an exponent that begins at a token: a number with its sign, or what stands in brackets.
fn behind_exponent(lexemes: &[Lexeme], from: usize) -> usize {
    let is_sign = |at: usize| matches!(lexemes.get(at).map(|lexeme| &lexeme.token), Some(Token::Minus | Token::Plus));
    let start = from + usize::from(is_sign(from));
    if !matches!(lexemes.get(start).map(|lexeme| &lexeme.token), Some(Token::Open(_))) {
        return (start + 1).min(lexemes.len());
    }
    let mut depth = 0_usize;
    for (at, lexeme) in lexemes.iter().enumerate().skip(start) {
        match lexeme.token {
            Token::Open(_) => depth += 1,
            Token::Close(_) => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    lexemes.len()
}

/// A whole exponent as text: `2`, `-1`, `(2)`.
fn whole_exponent(lexemes: &[Lexeme]) -> Option<String> {
    let mut text = String::new();
    for lexeme in lexemes {
        match &lexeme.token {
            Token::Minus => text.push('-'),
            Token::Number { value, half: None } if value.is_int() => text.push_str(&value.to_string()),
            Token::Open(_) | Token::Close(_) | Token::Plus => {}
            _ => return None,
        }
    }
    Some(text)
}

/// Whether a bare number is an angle in degrees: the argument of a sine, and more than a whole turn in radians.
fn is_in_degrees(before: &[Lexeme], value: &Rational, next: Option<&Lexeme>) -> bool {
    let next = next.map(|lexeme| &lexeme.token);
    let is_closed = matches!(next, Some(Token::Close(_)));
    let function = match before {
        [.., function, open] if is_closed && matches!(open.token, Token::Open(_)) => function,
        [.., function] => function,
        [] => return false,
    };
    let is_of_angle = match &function.token {
        Token::Word(letters) => ANGULAR.iter().any(|ending| names::text(letters).ends_with(ending)),
        Token::Function(named) => named.takes_angle(),
        _ => false,
    };
    // In `sin 10 t` the number is a part of the angle.
    is_of_angle
        && !matches!(next, Some(Token::Word(_) | Token::Open(_) | Token::Power))
        && *value > Rational::from(WHOLE_TURN)
}

/// `* 10^3` behind a number: the factor, and the token behind it.
fn power_of_ten(lexemes: &[Lexeme], from: usize) -> Option<(Rational, usize)> {
    let token = |at: usize| lexemes.get(at).map(|lexeme| &lexeme.token);
    let is_ten = matches!(token(from + 1), Some(Token::Number { value, half: None }) if *value == Rational::from(10));
    if token(from) != Some(&Token::Times) || !is_ten || token(from + 2) != Some(&Token::Power) {
        return None;
    }
    let end = behind_exponent(lexemes, from + 3);
    let exponent: isize = whole_exponent(lexemes.get(from + 3..end)?)?.parse().ok()?;
    (exponent.unsigned_abs() <= MAX_POWER_OF_TEN).then(|| (Rational::from(10).pow(exponent), end))
}

/// Half a unit of the last decimal of a number; nothing where it has none.
#[must_use]
pub fn half_of_last_place(value: &Rational) -> Option<Rational> {
    let ten = Rational::from(10);
    let decimals = (1..=MOST_DECIMALS).find(|decimals| (value * ten.pow(*decimals)).is_int())?;
    (!value.is_int()).then(|| Rational::from(1) / (Rational::from(2) * ten.pow(decimals)))
}

/// How far a number without decimals, or with few figures, may lie from what was rounded to it: half a unit of its last figure that is not
/// zero, where three figures are left, and no more than a share of it.
fn rounding(value: &Rational) -> Rational {
    let size = if *value < Rational::ZERO { -value.clone() } else { value.clone() };
    let share = size.clone() * Rational::from(WHOLE.0) / Rational::from(WHOLE.1);
    let ten = Rational::from(10);
    let mut place = Rational::ONE;
    let is_shorter = |figures: Rational| figures.is_int() && figures >= Rational::from(FEWEST_FIGURES);
    while is_shorter(size.clone() / (place.clone() * ten.clone())) {
        place *= ten.clone();
    }
    let half = place / Rational::from(2);
    if value.is_int() && share > half { half } else { share }
}
