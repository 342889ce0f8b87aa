//! A formula in the symbols of the sheet, with or without signs of multiplication.

use crate::expr::Expr;
use crate::expr::Function;
use crate::expr::Symbol;
use crate::quantity::Rational;

use super::super::expected::ExpectedFormula;
use super::answer::FormulaAnswer;
use super::arithmetic::{At, superscript};
use super::functions;
use super::names::{Names, Segment};
use super::numeral::{self, DecimalMark};
use super::plain::Plain;
use super::unreadable::{Unreadable, UnreadableKind};

/// The longest formula that is read, in characters.
pub const MAX_FORMULA: usize = 1000;
/// The most numbers, names and operations.
const MAX_PARTS: usize = 200;
/// How deeply brackets, functions and powers may be nested.
const MAX_DEPTH: usize = 24;
/// The largest whole power.
const MAX_POWER: i32 = 12;
/// The most functions, which are costly at many digits.
const MAX_FUNCTIONS: usize = 8;

/// The functions by name; `sqrt`, `arctan` and those of other spellings stand apart.
const FUNCTIONS: [(&str, Function); 10] = [
    ("sin", Function::Sin),
    ("cos", Function::Cos),
    ("tan", Function::Tan),
    ("arcsin", Function::Asin),
    ("asin", Function::Asin),
    ("arccos", Function::Acos),
    ("acos", Function::Acos),
    ("exp", Function::Exp),
    ("ln", Function::Ln),
    ("abs", Function::Abs),
];
const ROOTS: [&str; 2] = ["sqrt", "√"];
const ARCTANGENTS: [&str; 2] = ["arctan", "atan"];
/// The angle of the point (x, y), as our keys write it: `atan2(y, x)`.
const POINT_ANGLES: [&str; 2] = ["atan2", "arctan2"];

/// Reads a formula.
pub(super) fn read(answer: &str, asked: &ExpectedFormula, mark: DecimalMark) -> Result<FormulaAnswer, Unreadable> {
    let plain = Plain::limited(answer, MAX_FORMULA)?;
    let names = Names::new(asked);
    let text = plain.text();
    // The name of what is asked may stand before it: `v_B2 = ...`.
    let start = text
        .split_once('=')
        .filter(|(name, _)| names.is_asked(name.trim()))
        .map_or_else(|| text.len() - text.trim_start_matches([' ', '=']).len(), |(name, _)| name.len() + 1);
    let mut reader = Reader { text, at: start, mark, depth: 0, parts: 0, functions: 0, names: &names };
    let formula = reader.whole().map_err(|(at, kind)| plain.fault(at, kind))?;
    Ok(FormulaAnswer { text: formula.text(&asked.symbols), formula })
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    mark: DecimalMark,
    depth: usize,
    parts: usize,
    functions: usize,
    names: &'a Names<'a>,
}

impl<'a> Reader<'a> {
    fn whole(&mut self) -> At<Expr> {
        let formula = self.sum()?;
        self.skip_spaces();
        let rest = self.rest().trim_end_matches(['.', ' ']);
        if rest.is_empty() { Ok(formula) } else { self.fault(UnreadableKind::NotAFormula) }
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn skip_spaces(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    fn take(&mut self, sign: &str) -> bool {
        let found = self.rest().starts_with(sign);
        self.at += if found { sign.len() } else { 0 };
        found
    }

    fn fault<T>(&self, kind: UnreadableKind) -> At<T> {
        Err((self.at, kind))
    }

    fn part(&mut self) -> At<()> {
        self.parts += 1;
        if self.parts > MAX_PARTS { self.fault(UnreadableKind::TooManyParts) } else { Ok(()) }
    }

    fn sum(&mut self) -> At<Expr> {
        let mut sum = self.product()?;
        loop {
            self.skip_spaces();
            let plus = self.rest().starts_with('+');
            if !plus && !self.rest().starts_with('-') {
                return Ok(sum);
            }
            self.at += 1;
            self.part()?;
            let term = self.product()?;
            sum = if plus { sum + term } else { sum - term };
        }
    }

    fn product(&mut self) -> At<Expr> {
        let start = self.at;
        let mut product = self.signed()?;
        let mut divided = false;
        loop {
            let gap = self.rest().starts_with(' ');
            self.skip_spaces();
            let at = self.at;
            if self.rest().starts_with("**") {
                return self.fault(UnreadableKind::NotAFormula);
            }
            if self.take("*") || self.take("·") || self.take("×") {
                self.part()?;
                product = product * self.signed()?;
            } else if self.take("/") {
                self.part()?;
                let divisor = self.signed()?;
                if divisor.is_zero() {
                    return Err((at, UnreadableKind::Undefined));
                }
                product = product / divisor;
                divided = true;
            } else if self.begins_factor() {
                // `1/2 m v^2` is plain; `a/b c` may mean either.
                let fraction = product.as_number().is_some() && gap && !self.text[start..at].contains('(');
                if divided && !fraction {
                    return self.fault(UnreadableKind::ProductAfterBar);
                }
                divided = false;
                self.part()?;
                product = product * self.power()?;
            } else {
                return Ok(product);
            }
        }
    }

    /// Whether a factor follows without a sign: a name, a bracket, a root; a number never.
    fn begins_factor(&self) -> bool {
        self.rest().starts_with(|next: char| next.is_alphabetic() || next == '(' || next == '√' || next == '\\')
    }

    fn signed(&mut self) -> At<Expr> {
        self.skip_spaces();
        let minus = self.rest().starts_with('-');
        if minus || self.rest().starts_with('+') {
            self.at += 1;
            self.skip_spaces();
            if self.rest().starts_with(['+', '-']) {
                return self.fault(UnreadableKind::TwoSigns);
            }
            self.part()?;
        }
        let term = self.power()?;
        Ok(if minus { -term } else { term })
    }

    fn power(&mut self) -> At<Expr> {
        let base = self.primary()?;
        self.raised(base)
    }

    /// The power of a base, where one is written.
    fn raised(&mut self, base: Expr) -> At<Expr> {
        match self.exponent()? {
            Some(exponent) => Ok(base.power(exponent)),
            None => Ok(base),
        }
    }

    fn exponent(&mut self) -> At<Option<Expr>> {
        let start = self.at;
        let exponent = if let Some((exponent, length)) = superscript(self.rest()) {
            self.at += length;
            Expr::integer(i64::from(exponent))
        } else if self.take("^") || self.take("**") {
            self.nested(|reader| {
                reader.skip_spaces();
                if !reader.take("{") {
                    return reader.signed();
                }
                let inner = reader.sum()?;
                if reader.take("}") { Ok(inner) } else { reader.fault(UnreadableKind::OpenBracket) }
            })?
        } else {
            return Ok(None);
        };
        self.part()?;
        let exponent = exponent.simplify();
        let small = |number: &Rational| {
            let limit = Rational::from(MAX_POWER);
            let whole = |below: i32| (number * Rational::from(below)).is_int();
            *number <= limit && *number >= -limit && (1..=MAX_POWER).any(whole)
        };
        if exponent.as_number().is_some_and(small) {
            return Ok(Some(exponent));
        }
        Err((start, if exponent.as_number().is_some() { UnreadableKind::TooLarge } else { UnreadableKind::NamedPower }))
    }

    /// A number, a bracket, a name, or a function with its argument.
    fn primary(&mut self) -> At<Expr> {
        self.skip_spaces();
        self.part()?;
        let rest = self.rest();
        if rest.starts_with(['(', '[', '|']) {
            return self.nested(Self::bracket);
        }
        if rest.strip_prefix('.').unwrap_or(rest).starts_with(|first: char| first.is_ascii_digit()) {
            return self.number();
        }
        if let Some(function) = self.function() {
            return function;
        }
        match self.names.first(rest).map_err(|kind| (self.at, kind))? {
            Some(Segment { symbol, length }) => {
                self.at += length;
                Ok(symbol.map_or(Expr::Pi, Expr::from))
            }
            None => self.fault(if rest.is_empty() { UnreadableKind::NotAFormula } else { UnreadableKind::NoTerm }),
        }
    }

    fn bracket(&mut self) -> At<Expr> {
        let open = self.at;
        let close = match self.rest().as_bytes().first() {
            Some(b'(') => ")",
            Some(b'[') => "]",
            _ => "|",
        };
        self.at += 1;
        let inner = self.sum()?;
        self.skip_spaces();
        if !self.take(close) {
            let ended = self.rest().is_empty();
            return Err(if ended {
                (open, UnreadableKind::OpenBracket)
            } else {
                (self.at, UnreadableKind::NotAFormula)
            });
        }
        Ok(if close == "|" { Expr::apply(Function::Abs, inner) } else { inner })
    }

    fn number(&mut self) -> At<Expr> {
        let start = self.at;
        let found = numeral::read(self.rest(), self.mark).map_err(|(at, kind)| (start + at, kind))?;
        let written = &self.text[start..start + found.length];
        // `2e3` is two thousand, unless e is known here.
        if written.contains(['e', 'E']) && self.names.knows("e") {
            return self.fault(UnreadableKind::AmbiguousName(written.to_owned()));
        }
        self.at += found.length;
        Ok(Expr::Number(found.decimal.to_rational()))
    }

    /// A function with its argument, where one stands here.
    fn function(&mut self) -> Option<At<Expr>> {
        let rest = self.rest().trim_start_matches('\\');
        let is_here = |name: &str| {
            let behind = rest.strip_prefix(name);
            behind.is_some_and(|behind| {
                !behind.starts_with(|next: char| next.is_alphabetic() || next.is_ascii_digit() || next == '_')
                    || name == "√"
            })
        };
        if let Some(name) = POINT_ANGLES.iter().find(|name| is_here(name)) {
            self.at = self.text.len() - rest.len() + name.len();
            return Some(self.nested(Self::angle_of_point));
        }
        let root = ROOTS.iter().find(|name| is_here(name));
        let arctangent = ARCTANGENTS.iter().find(|name| is_here(name));
        let other = FUNCTIONS.iter().find(|(name, _)| is_here(name));
        let name = root.or(arctangent).copied().or(other.map(|(name, _)| *name))?;
        self.at = self.text.len() - rest.len() + name.len();
        let other = other.map(|(_, function)| *function);
        Some(self.nested(|reader| reader.apply(root.is_some(), other)))
    }

    fn apply(&mut self, root: bool, function: Option<Function>) -> At<Expr> {
        self.functions += usize::from(!root);
        if self.functions > MAX_FUNCTIONS {
            return self.fault(UnreadableKind::TooManyParts);
        }
        // `sin^2(x)` is the square of the sine.
        let power = if root { None } else { self.exponent()? };
        self.skip_spaces();
        let start = self.at;
        let bracketed = self.take("(");
        let mut argument = if bracketed { self.sum()? } else { self.primary()? };
        if matches!(function, Some(Function::Sin | Function::Cos | Function::Tan)) {
            argument = self.angle(argument)?;
        }
        self.skip_spaces();
        if bracketed && !self.take(")") {
            return Err((start, UnreadableKind::OpenBracket));
        }
        let value = match function {
            _ if root => argument.sqrt(),
            Some(function) => Expr::apply(function, argument),
            None => argument.atan2(Expr::one()),
        };
        Ok(power.map_or(value.clone(), |power| value.power(power)))
    }

    fn angle_of_point(&mut self) -> At<Expr> {
        self.functions += 1;
        if self.functions > MAX_FUNCTIONS {
            return self.fault(UnreadableKind::TooManyParts);
        }
        let start = self.at;
        if !self.take("(") {
            return self.fault(UnreadableKind::NotAFormula);
        }
        let y = self.sum()?;
        self.skip_spaces();
        if !self.take(",") && !self.take(";") {
            return self.fault(UnreadableKind::NotAFormula);
        }
        let x = self.sum()?;
        self.skip_spaces();
        if self.take(")") { Ok(y.atan2(x)) } else { Err((start, UnreadableKind::OpenBracket)) }
    }

    /// A plain number needs a unit to be an angle.
    fn angle(&mut self, argument: Expr) -> At<Expr> {
        let rest = self.rest().trim_start();
        if let Some(behind) = rest.strip_prefix('°').or_else(|| rest.strip_prefix("deg")) {
            self.at = self.text.len() - behind.len();
            return Ok(argument * Expr::Pi / Expr::integer(180));
        }
        let bare = argument.as_number().is_some_and(|number| *number != Rational::ZERO);
        if bare && functions::find_angle_unit(rest.split(')').next().unwrap_or("")).is_none() {
            return self.fault(UnreadableKind::AngleUnit);
        }
        Ok(argument)
    }

    fn nested(&mut self, read: impl FnOnce(&mut Self) -> At<Expr>) -> At<Expr> {
        if self.depth >= MAX_DEPTH {
            return self.fault(UnreadableKind::TooDeep);
        }
        self.depth += 1;
        let found = read(self);
        self.depth -= 1;
        found
    }
}

/// The symbols that a formula may contain.
pub(super) fn allowed(asked: &ExpectedFormula) -> impl Iterator<Item = Symbol> + '_ {
    asked.domain.iter().map(|(symbol, ..)| *symbol).chain(asked.values.iter().map(|(symbol, _)| *symbol))
}
