//! Sums, products and powers, with or without signs of multiplication. What can be read in two ways is never read in silence.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_quantity::Dimension;
use momentous_quantity::Rational;

use super::super::unreadable::{At, UnreadableKind};
use super::token::{Lexeme, MAX_DEPTH, Token};
use super::vocabulary::{BehindBars, Vocabulary};

/// The most numbers, names and operations.
const MAX_PARTS: usize = 200;
/// The most steps of reading, for what is asked back is read twice.
const MAX_STEPS: usize = 2000;
/// The most functions, which are costly at many digits.
const MAX_FUNCTIONS: usize = 16;
/// The largest power that is a number.
const MAX_POWER: i32 = 64;
/// The largest degree of a root that is written as a power.
const MAX_DEGREE: i32 = 1000;

/// A term, and whether a number without a unit stands in it as a summand: no angle then.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) value: Expr,
    pub(super) bare: bool,
}

pub(super) struct Grammar<'a> {
    lexemes: &'a [Lexeme],
    next: usize,
    /// The character behind the last.
    end: usize,
    vocabulary: &'a Vocabulary<'a>,
    depth: usize,
    parts: usize,
    steps: usize,
    functions: usize,
    /// Whether the innermost bracket that is open is a bar.
    inside_bars: bool,
    /// Whether `\over` is read like a plain fraction bar.
    pub(super) plain_bars: bool,
}

/// Where reading may go back to.
#[derive(Clone, Copy)]
pub(super) struct Mark {
    next: usize,
    parts: usize,
    functions: usize,
}

impl Term {
    pub(super) fn of(value: Expr) -> Self {
        Self { value, bare: false }
    }
}

impl<'a> Grammar<'a> {
    pub(super) fn new(lexemes: &'a [Lexeme], end: usize, vocabulary: &'a Vocabulary<'a>) -> Self {
        Self {
            lexemes,
            next: 0,
            end,
            vocabulary,
            depth: 0,
            parts: 0,
            steps: 0,
            functions: 0,
            inside_bars: false,
            plain_bars: false,
        }
    }

    pub(super) fn whole(&mut self) -> At<Expr> {
        let formula = self.group(false)?;
        match self.peek() {
            None => Ok(formula.value),
            Some(Token::PlusMinus) => self.fault(UnreadableKind::NotOneValue),
            Some(Token::Number { .. } | Token::Written { .. }) => self.fault(UnreadableKind::NumberBehind),
            Some(_) => self.fault(UnreadableKind::NotAFormula),
        }
    }

    pub(super) fn peek(&self) -> Option<&'a Token> {
        self.ahead(0)
    }

    pub(super) fn ahead(&self, distance: usize) -> Option<&'a Token> {
        self.lexemes.get(self.next + distance).map(|own| &own.token)
    }

    /// Whether a space stands before the next token.
    fn gap(&self) -> bool {
        self.lexemes.get(self.next).is_some_and(|own| own.gap)
    }

    pub(super) fn at(&self) -> usize {
        self.lexemes.get(self.next).map_or(self.end, |own| own.at)
    }

    pub(super) fn advance(&mut self) {
        self.next += 1;
    }

    pub(super) fn take(&mut self, token: &Token) -> bool {
        let found = self.peek() == Some(token);
        self.next += usize::from(found);
        found
    }

    pub(super) fn fault<T>(&self, kind: UnreadableKind) -> At<T> {
        Err((self.at(), kind))
    }

    pub(super) fn mark(&self) -> Mark {
        Mark { next: self.next, parts: self.parts, functions: self.functions }
    }

    pub(super) fn back_to(&mut self, mark: Mark) {
        (self.next, self.parts, self.functions) = (mark.next, mark.parts, mark.functions);
    }

    pub(super) fn part(&mut self) -> At<()> {
        self.parts += 1;
        self.steps += 1;
        let many = self.parts > MAX_PARTS || self.steps > MAX_STEPS;
        if many { self.fault(UnreadableKind::TooManyParts) } else { Ok(()) }
    }

    /// Counts functions.
    pub(super) fn count(&mut self, functions: usize) -> At<()> {
        self.functions += functions;
        if self.functions > MAX_FUNCTIONS { self.fault(UnreadableKind::TooManyParts) } else { Ok(()) }
    }

    pub(super) fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> At<T>) -> At<T> {
        if self.depth >= MAX_DEPTH {
            return self.fault(UnreadableKind::TooDeep);
        }
        self.depth += 1;
        let found = read(self);
        self.depth -= 1;
        found
    }

    /// Whether a term measures nothing: it may be the argument of a sine, or an exponent.
    pub(super) fn is_pure(&self, term: &Expr) -> bool {
        term.dimension(self.vocabulary.symbols) == Ok(Dimension::NONE)
    }

    /// Whether a term holds numbers only.
    fn is_numeric(&self, term: &Expr) -> bool {
        let symbols = term.symbols();
        let is_written = !symbols.is_empty() && symbols.iter().all(|symbol| self.vocabulary.is_written(*symbol));
        is_written || term.as_number().is_some()
    }

    /// The fault of a text that has two readings; of those that are shown, the first stands first.
    pub(super) fn two_readings<T>(&self, at: usize, readings: [&Expr; 2]) -> At<T> {
        let readings = readings.map(|reading| reading.text(self.vocabulary.symbols));
        Err((at, UnreadableKind::TwoReadings(readings)))
    }

    pub(super) fn sum(&mut self) -> At<Term> {
        let first = self.product()?;
        let mut terms = vec![first];
        loop {
            let plus = match self.peek() {
                Some(Token::Plus) => true,
                Some(Token::Minus) => false,
                _ => break,
            };
            self.advance();
            self.part()?;
            let term = self.product()?;
            terms.push(Term { value: if plus { term.value } else { -term.value }, bare: term.bare });
        }
        let bare = terms.iter().any(|term| term.bare);
        Ok(Term { value: Expr::sum(terms.into_iter().map(|term| term.value)), bare })
    }

    fn product(&mut self) -> At<Term> {
        let first = self.signed()?;
        self.product_from(first)
    }

    /// A product whose first factor is read.
    pub(super) fn product_from(&mut self, first: Term) -> At<Term> {
        let mut product = first;
        let mut divided = false;
        let mut bracketed = false;
        loop {
            let at = self.at();
            match self.peek() {
                Some(Token::Times) => {
                    self.advance();
                    self.part()?;
                    let factor = self.signed()?;
                    product = Term { bare: product.bare && factor.bare, value: product.value * factor.value };
                    divided = false;
                }
                Some(bar) if *bar == Token::Over || *bar == Token::WholeOver && self.plain_bars => {
                    self.advance();
                    self.part()?;
                    bracketed |= matches!(self.peek(), Some(Token::Open(_)));
                    let divisor = self.signed()?;
                    if divisor.value.is_zero() {
                        return Err((at, UnreadableKind::Undefined));
                    }
                    product = Term { bare: product.bare && divisor.bare, value: product.value / divisor.value };
                    divided = true;
                }
                Some(next)
                    if self.is_factor(next) || next.is_decimal() && self.gap() && !self.is_numeric(&product.value) =>
                {
                    // `1/2 m v^2` is plain; `a/b c` may mean either.
                    let fraction = self.is_numeric(&product.value) && self.gap() && !bracketed;
                    let is_below = divided && !fraction && self.vocabulary.behind_bars == BehindBars::Below;
                    if divided && !fraction && self.vocabulary.behind_bars == BehindBars::Doubtful {
                        return Err((at, UnreadableKind::ProductAfterBar));
                    }
                    divided = is_below;
                    self.part()?;
                    let factor = self.power()?;
                    if is_below {
                        if factor.value.is_zero() {
                            return Err((at, UnreadableKind::Undefined));
                        }
                        product = Term { bare: product.bare && factor.bare, value: product.value / factor.value };
                        continue;
                    }
                    product = Term { bare: product.bare && factor.bare, value: product.value * factor.value };
                }
                _ => return Ok(product),
            }
        }
    }

    /// Whether a factor follows without a sign.
    pub(super) fn is_factor(&self, token: &Token) -> bool {
        token.begins_factor() || *token == Token::Bar && !self.inside_bars
    }

    pub(super) fn signed(&mut self) -> At<Term> {
        let minus = self.peek() == Some(&Token::Minus);
        if minus || self.peek() == Some(&Token::Plus) {
            self.advance();
            if matches!(self.peek(), Some(Token::Plus | Token::Minus | Token::PlusMinus)) {
                return self.fault(UnreadableKind::TwoSigns);
            }
            self.part()?;
        }
        let term = self.power()?;
        Ok(Term { value: if minus { -term.value } else { term.value }, ..term })
    }

    pub(super) fn power(&mut self) -> At<Term> {
        let base = self.primary()?;
        self.raised(base)
    }

    /// The power of a base, where one is written.
    pub(super) fn raised(&mut self, base: Term) -> At<Term> {
        if self.peek() != Some(&Token::Power) {
            return Ok(base);
        }
        // `e^2n` is meant as often for a power of 2n.
        let is_e = matches!(base.value, Expr::Symbol(own) if self.vocabulary.symbols.entry(own).name == "e");
        let value = self.exponent(&|exponent| base.value.clone().power(exponent), is_e)?;
        Ok(Term { value, bare: base.bare })
    }

    /// A power, its sign next: what `power` makes of the exponent. Where it is not in brackets and goes on behind, it is asked
    /// back how far it goes.
    pub(super) fn exponent(&mut self, power: &dyn Fn(Expr) -> Expr, of_e: bool) -> At<Expr> {
        let at = self.at();
        self.advance();
        self.part()?;
        let bracketed = matches!(self.peek(), Some(Token::Open(_) | Token::Fraction));
        let exponent = self.nested(Self::signed)?.value;
        if let Some(number) = exponent.as_number() {
            if !is_small(number) {
                return Err((at, UnreadableKind::TooLarge));
            }
            let is_root = !number.is_int() && *number.denominator() != 2_u8.into();
            self.count(if is_root { 2 } else { 0 })?;
        } else {
            self.count(2)?;
        }
        let unit = exponent
            .as_number()
            .is_some_and(|number| number.is_int() && (number.is_one() || *number == -Rational::ONE));
        let open = exponent.as_number().is_none() || of_e;
        let goes_on = match self.peek() {
            Some(Token::Over) if unit => matches!(self.ahead(1), Some(Token::Number { .. } | Token::Written { .. })),
            Some(Token::Over) => open,
            Some(next) => open && self.is_factor(next) && !self.gap(),
            None => false,
        };
        if bracketed || !goes_on {
            return Ok(power(exponent));
        }
        let mark = self.mark();
        let long = self.product_from(Term::of(exponent.clone()))?.value;
        self.back_to(mark);
        let short = self.product_from(Term::of(power(exponent.clone())))?.value;
        self.back_to(mark);
        if !self.is_pure(&long) && self.is_pure(&exponent) {
            return Ok(power(exponent));
        }
        self.two_readings(at, [&short, &power(long)])
    }

    /// A number, a bracket, a name, or a function with its argument.
    pub(super) fn primary(&mut self) -> At<Term> {
        self.part()?;
        let at = self.at();
        let term = match self.peek() {
            Some(Token::Open(_) | Token::Bar) => self.nested(Self::bracket)?,
            Some(Token::Number { value, .. }) => {
                self.advance();
                Term { value: Expr::Number(value.clone()), bare: !value.is_zero() }
            }
            Some(Token::Name(symbol)) => {
                self.advance();
                Term::of(Expr::from(*symbol))
            }
            Some(Token::Written { place, measured }) => {
                let Some(symbol) = self.vocabulary.numbers.get(*place) else {
                    return self.fault(UnreadableKind::NoTerm);
                };
                self.advance();
                Term { value: Expr::from(*symbol), bare: !measured }
            }
            Some(Token::Pi) => {
                self.advance();
                Term::of(Expr::Pi)
            }
            Some(Token::Euler) => {
                self.advance();
                self.count(1)?;
                Term::of(self.exponent(&|exponent| Expr::apply(Function::Exp, exponent), true)?)
            }
            Some(Token::Function(_) | Token::Root(_) | Token::IndexedRoot | Token::Fraction) => {
                self.nested(Self::applied)?
            }
            Some(Token::PlusMinus) => return self.fault(UnreadableKind::NotOneValue),
            None => {
                return self.fault(if self.next == 0 { UnreadableKind::NotAFormula } else { UnreadableKind::NoTerm });
            }
            Some(_) => return self.fault(UnreadableKind::NoTerm),
        };
        self.measured(term, at)
    }

    /// An angle with its unit.
    fn measured(&mut self, term: Term, at: usize) -> At<Term> {
        let factor = match self.peek() {
            Some(Token::Degree) => Expr::Pi / Expr::integer(180),
            Some(Token::Radian) => Expr::one(),
            _ => return Ok(term),
        };
        if term.value.as_number().is_none() {
            return Err((at, UnreadableKind::NotANumber));
        }
        self.advance();
        Ok(Term::of(term.value * factor))
    }

    pub(super) fn bracket(&mut self) -> At<Term> {
        let open = self.at();
        let close = match self.peek() {
            Some(Token::Open(close)) => Token::Close(*close),
            _ => Token::Bar,
        };
        self.advance();
        let outside = std::mem::replace(&mut self.inside_bars, close == Token::Bar);
        let inner = self.group(close == Token::Close('}'))?;
        self.inside_bars = outside;
        if !self.take(&close) {
            return match self.peek() {
                None => Err((open, UnreadableKind::OpenBracket)),
                Some(Token::PlusMinus) => self.fault(UnreadableKind::NotOneValue),
                Some(_) => self.fault(UnreadableKind::NotAFormula),
            };
        }
        Ok(if close == Token::Bar { Term::of(Expr::apply(Function::Abs, inner.value)) } else { inner })
    }
}

/// Whether a number is an exponent that is worked with.
pub(super) fn is_small(number: &Rational) -> bool {
    let limit = Rational::from(MAX_POWER);
    *number <= limit && *number >= -limit && Rational::from(number.denominator().clone()) <= Rational::from(MAX_DEGREE)
}
