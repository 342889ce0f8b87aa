//! The number of an answer: a decimal, a fraction or a small calculation.

use std::f64::consts::PI;

use momentous_quantity::Rational;

use super::super::number::Number;
use super::doubtful;
use super::functions::{self, Function};
use super::mixed::{begins_ten, is_glued_sign, proper_fraction, spaced_exponent, vulgar};
use super::numeral::{self, DecimalMark};
use super::unreadable::{At, UnreadableKind};

pub(super) use super::form::Form;
pub(super) use super::mixed::superscript;

/// How deeply brackets, functions and powers may be nested.
const MAX_DEPTH: usize = 16;

/// The most numbers, brackets and functions: what they are made of is bounded, and so is all the work.
const MAX_PARTS: usize = 60;

/// A value and how it came to be written.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) number: Number,
    pub(super) form: Form,
}

/// Reads the calculation at the start of a text, and how many bytes it takes; a unit may follow.
pub(super) fn read(text: &str, mark: DecimalMark) -> At<(Term, usize)> {
    let mut reader = Reader { text, at: 0, mark, depth: 0, parts: 0 };
    let term = reader.sum()?;
    doubtful::check(&text[..reader.at])?;
    Ok((term, reader.at))
}

/// Whether a number begins here, perhaps behind spaces, signs, opening brackets and bars.
pub(super) fn begins_number(text: &str) -> bool {
    let rest = text.trim_start_matches([' ', '(', '+', '-', '|']);
    let decimals = rest.strip_prefix('.').unwrap_or(rest);
    decimals.starts_with(|first: char| first.is_ascii_digit()) || begins_word(rest) || vulgar(rest).is_some()
}

/// Whether a function or pi begins here.
fn begins_word(text: &str) -> bool {
    text.starts_with(['√', 'π']) || word(text) == "pi" || functions::find(word(text)).is_some()
}

fn word(text: &str) -> &str {
    if text.starts_with("log10") {
        return &text[..5];
    }
    &text[..text.find(|next: char| !next.is_alphabetic()).unwrap_or(text.len())]
}

struct Reader<'text> {
    text: &'text str,
    at: usize,
    mark: DecimalMark,
    depth: usize,
    parts: usize,
}

/// Whether a bracket with a calculation stands directly here; with a single number it is an uncertainty, `4.65(3)`.
fn begins_calculation(text: &str) -> bool {
    let Some(inner) = text.strip_prefix('(').filter(|inner| begins_number(inner)) else { return false };
    inner
        .split(')')
        .next()
        .is_some_and(|inner| inner.trim_start_matches(['+', '-', ' ']).contains(['+', '-', '*', '/', '·', '×']))
}

impl<'text> Reader<'text> {
    fn rest(&self) -> &'text str {
        &self.text[self.at..]
    }

    fn skip_spaces(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    fn take(&mut self, sign: &str) -> bool {
        let is_there = self.rest().starts_with(sign);
        self.at += if is_there { sign.len() } else { 0 };
        is_there
    }

    fn fault<T>(&self, kind: UnreadableKind) -> At<T> {
        Err((self.at, kind))
    }

    fn computed(&self, number: Option<Number>, or: UnreadableKind) -> At<Term> {
        number.map(|number| Term { number, form: Form::Computed }).ok_or((self.at, or))
    }

    /// Terms joined by plus and minus signs, as far as numbers follow them.
    fn sum(&mut self) -> At<Term> {
        let mut sum = self.product()?;
        loop {
            let signed = self.rest().trim_start();
            let behind = signed.strip_prefix(['+', '-']);
            if !behind.is_some_and(begins_number) {
                return Ok(sum);
            }
            self.skip_spaces();
            self.at += 1;
            let term = self.product()?;
            if (sum.form == Form::Arc) != (term.form == Form::Arc) {
                return self.fault(UnreadableKind::AngleUnit);
            }
            let total =
                if signed.starts_with('+') { sum.number.plus(&term.number) } else { sum.number.minus(&term.number) };
            let form = if sum.form == Form::Arc { Form::Arc } else { Form::Computed };
            sum = Term { form, ..self.computed(total, UnreadableKind::TooLarge)? };
        }
    }

    fn product(&mut self) -> At<Term> {
        let mut product = self.signed(false)?;
        let mut divided = false;
        loop {
            let Some(operator) = self.operator() else { return Ok(product) };
            let start = self.at;
            if divided && operator == Operator::Juxtaposed {
                return self.fault(UnreadableKind::ProductAfterBar);
            }
            let factor = self.signed(operator == Operator::Times)?;
            product = match operator {
                Operator::Over => {
                    divided = true;
                    let undefined = factor.number.is_zero();
                    let number = product.number.over(&factor.number);
                    let form = match (product.form, factor.form) {
                        (form @ (Form::Radians | Form::Arc), other) if !matches!(other, Form::Radians | Form::Arc) => {
                            form
                        }
                        _ => Form::Computed,
                    };
                    let fault = if undefined { UnreadableKind::Undefined } else { UnreadableKind::TooLarge };
                    Term { number: number.ok_or((start, fault))?, form }
                }
                Operator::Times | Operator::Juxtaposed => Term {
                    number: product.number.times(&factor.number).ok_or((start, UnreadableKind::TooLarge))?,
                    form: product.form.times(factor.form),
                },
            };
        }
    }

    /// The operator before a further factor, taken where a number follows it.
    fn operator(&mut self) -> Option<Operator> {
        let rest = self.rest().trim_start();
        let times =
            rest.strip_prefix(['*', '×', '·']).filter(|behind| !behind.starts_with('*') && begins_number(behind));
        let over = rest.strip_prefix('/').filter(|behind| begins_number(behind));
        // The letter stands for a product before a power of ten only.
        let is_zero = |before: &str| !before.ends_with(|last: char| last.is_ascii_digit() || ".,'".contains(last));
        let is_hexadecimal =
            rest.len() == self.rest().len() && self.text[..self.at].strip_suffix('0').is_some_and(is_zero);
        let letter = rest.strip_prefix(['x', 'X']).filter(|behind| begins_ten(behind) && !is_hexadecimal);
        let (operator, behind) = match (times.or(letter), over) {
            (Some(behind), _) => (Operator::Times, behind),
            (_, Some(behind)) => (Operator::Over, behind),
            _ if begins_word(rest) => (Operator::Juxtaposed, rest),
            _ if self.text[..self.at].ends_with(')') && rest.starts_with('(') && begins_number(rest) => {
                (Operator::Juxtaposed, rest)
            }
            _ if self.text[..self.at].ends_with(|last: char| last.is_ascii_digit())
                && begins_calculation(self.rest()) =>
            {
                (Operator::Juxtaposed, rest)
            }
            _ => return None,
        };
        self.at = self.text.len() - behind.len();
        Some(operator)
    }

    /// A power with at most one sign before it. After a times sign, `10-3` is probably a lost exponent.
    fn signed(&mut self, after_times: bool) -> At<Term> {
        self.skip_spaces();
        let minus = self.rest().starts_with('-');
        if minus || self.rest().starts_with('+') {
            self.at += 1;
            self.skip_spaces();
            if self.rest().starts_with(['+', '-']) {
                return self.fault(UnreadableKind::TwoSigns);
            }
        }
        let start = self.at;
        let term = self.power()?;
        if after_times && &self.text[start..self.at] == "10" && is_glued_sign(self.rest()) {
            return self.fault(UnreadableKind::LostExponent);
        }
        Ok(if minus { Term { number: term.number.negated(), ..term } } else { term })
    }

    fn power(&mut self) -> At<Term> {
        let (start, base) = (self.at, self.primary()?);
        let is_ten = &self.text[start..self.at] == "10";
        let exponent = if let Some((exponent, length)) = superscript(self.rest()) {
            self.at += length;
            Number::exact(Rational::from(exponent))
        } else if self.take_power() {
            self.nested(Self::exponent)?.number
        } else {
            return Ok(base);
        };
        let undefined = base.number.is_zero() || base.number.is_negative() && !exponent.value().is_int();
        let fault = if undefined { UnreadableKind::Undefined } else { UnreadableKind::TooLarge };
        let number = base.number.power(&exponent).ok_or((start, fault))?;
        Ok(Term { number, form: if is_ten { Form::PowerOfTen } else { Form::Computed } })
    }

    /// The sign of a power, perhaps behind spaces.
    fn take_power(&mut self) -> bool {
        let rest = self.rest().trim_start();
        let Some(behind) = rest.strip_prefix("**").or(rest.strip_prefix('^')) else { return false };
        // A sign of a degree is no power.
        if behind.starts_with(char::is_alphabetic) && !begins_number(behind) {
            return false;
        }
        self.at = self.text.len() - behind.len();
        true
    }

    fn exponent(&mut self) -> At<Term> {
        self.skip_spaces();
        if !self.take("{") {
            return self.signed(false);
        }
        let inner = self.sum()?;
        self.skip_spaces();
        if self.take("}") { Ok(inner) } else { self.fault(UnreadableKind::OpenBracket) }
    }

    /// A number, a bracket, pi, or a function with its argument.
    fn primary(&mut self) -> At<Term> {
        self.skip_spaces();
        self.parts += 1;
        if self.parts > MAX_PARTS {
            return self.fault(UnreadableKind::TooManyParts);
        }
        let rest = self.rest();
        if rest.starts_with('(') {
            return self.nested(|reader| reader.bracket("(", ")"));
        }
        if rest.starts_with('|') {
            let inner = self.nested(|reader| reader.bracket("|", "|"))?;
            return self.computed(Function::Absolute.apply(&inner.number), UnreadableKind::TooLarge);
        }
        if self.take("π") || word(rest) == "pi" && self.take("pi") {
            let pi = Number::rounded(PI);
            return pi.map(|number| Term { number, form: Form::Radians }).ok_or((self.at, UnreadableKind::TooLarge));
        }
        if self.take("√") {
            return self.nested(|reader| reader.apply(Function::SquareRoot));
        }
        if let Some(function) = functions::find(word(rest)) {
            self.at += word(rest).len();
            return self.nested(|reader| reader.raised_function(function));
        }
        if let Some((part, length)) = vulgar(rest) {
            self.at += length;
            return self.computed(Some(part), UnreadableKind::TooLarge);
        }
        self.decimal()
    }

    /// `sin^2(30°)` is a square, `sin^-1(0.5)` an angle.
    fn raised_function(&mut self, function: Function) -> At<Term> {
        if let Some(inverse) = function.inverse()
            && let Some(sign) = ["^{-1}", "^(-1)", "^-1", "⁻¹"].into_iter().find(|sign| self.rest().starts_with(sign))
        {
            self.at += sign.len();
            return self.apply(inverse);
        }
        let start = self.at;
        let exponent = if let Some((exponent, length)) = superscript(self.rest()) {
            self.at += length;
            Number::exact(Rational::from(exponent))
        } else if self.rest().starts_with('^') {
            self.at += 1;
            // A bracket behind the power holds the argument.
            self.nested(Self::decimal)?.number
        } else {
            return self.apply(function);
        };
        let value = self.apply(function)?;
        self.computed(value.number.power(&exponent), UnreadableKind::TooLarge).map_err(|(_, kind)| (start, kind))
    }

    fn decimal(&mut self) -> At<Term> {
        let rest = self.rest();
        if !rest.strip_prefix('.').unwrap_or(rest).starts_with(|first: char| first.is_ascii_digit()) {
            return self.fault(UnreadableKind::NotANumber);
        }
        let start = self.at;
        let numeral = numeral::read(rest, self.mark).map_err(|(at, kind)| (start + at, kind))?;
        self.at += numeral.length;
        let mut decimal = numeral.decimal;
        let mut least = numeral.least;
        // `1.2 e3`: nothing else can be meant.
        if let Some((spaced, length)) = spaced_exponent(&self.text[start..self.at], self.rest()) {
            self.at += length;
            least = spaced.figures();
            decimal = spaced;
        }
        let is_fraction = self.rest().trim_start().strip_prefix('/').is_some_and(begins_number);
        if numeral.spaced && is_fraction {
            return Err((start, UnreadableKind::MixedOrGrouped));
        }
        let value = Number::from(&decimal);
        let part = proper_fraction(self.rest()).or_else(|| vulgar(self.rest()));
        if let Some((part, length)) = part.filter(|_| numeral.digits_only) {
            self.at += length;
            return self.computed(value.plus(&part), UnreadableKind::TooLarge);
        }
        let form = Form::Decimal { least, most: decimal.figures() };
        Ok(Term { number: value, form })
    }

    fn bracket(&mut self, opening: &str, closing: &str) -> At<Term> {
        let open = self.at;
        self.take(opening);
        let inner = self.sum()?;
        self.skip_spaces();
        if !self.take(closing) {
            let kind = if self.rest().is_empty() { UnreadableKind::OpenBracket } else { UnreadableKind::NotANumber };
            return Err((if self.rest().is_empty() { open } else { self.at }, kind));
        }
        let is_angle = matches!(inner.form, Form::Radians | Form::Arc);
        Ok(Term { form: if is_angle { inner.form } else { Form::Computed }, ..inner })
    }

    /// The value of a function; an angle needs its unit, for nobody can know what `sin(30)` means.
    fn apply(&mut self, function: Function) -> At<Term> {
        self.skip_spaces();
        let start = self.at;
        let bracketed = self.take("(");
        let argument = if bracketed { self.sum()? } else { self.primary()? };
        let argument = if function.takes_angle() { self.angle(argument)? } else { argument.number };
        self.skip_spaces();
        if bracketed && !self.take(")") {
            return Err((start, UnreadableKind::OpenBracket));
        }
        let value = function.apply(&argument).ok_or((start, UnreadableKind::Undefined))?;
        Ok(Term { number: value, form: if function.is_arc() { Form::Arc } else { Form::Computed } })
    }

    fn angle(&mut self, argument: Term) -> At<Number> {
        let rest = self.rest().trim_start();
        let name = if rest.starts_with('°') { "°" } else { word(rest) };
        match functions::find_angle_unit(name) {
            Some(unit) => {
                self.skip_spaces();
                self.at += name.len();
                unit.to_radians(&argument.number).ok_or((self.at, UnreadableKind::TooLarge))
            }
            None if matches!(argument.form, Form::Radians | Form::Arc) || argument.number.is_zero() => {
                Ok(argument.number)
            }
            None => self.fault(UnreadableKind::AngleUnit),
        }
    }

    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> At<T>) -> At<T> {
        if self.depth >= MAX_DEPTH {
            return self.fault(UnreadableKind::TooDeep);
        }
        self.depth += 1;
        let found = read(self);
        self.depth -= 1;
        found
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Operator {
    Times,
    Over,
    /// No sign at all: `2 sqrt(3)`, `3π`.
    Juxtaposed,
}
