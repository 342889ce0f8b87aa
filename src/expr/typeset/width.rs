//! How wide typeset mathematics is, for whoever must break a line: to about a twentieth, as a browser sets it in STIX Two.

use std::borrow::Borrow;

use super::super::{Math, Operator};

/// Scripts are this much smaller than their base.
const SCRIPT: f64 = 0.7;

/// The gap behind scripts.
const BEHIND_SCRIPTS: f64 = 0.1;

/// The space between a number and its unit.
const SPACE: f64 = 0.5;

/// What a sign takes that stands before its operand, and has no room around it.
const SIGN: f64 = 1.45;

impl Math {
    /// Its width, in widths of a digit.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.set(1.0)
    }

    /// The width of parts side by side.
    pub fn row_width<M: Borrow<Self>>(parts: impl IntoIterator<Item = M>) -> f64 {
        set_row(parts, 1.0)
    }

    /// The parts of rows within rows, one after another.
    pub fn spread<'a>(&'a self, put: &mut dyn FnMut(&'a Self)) {
        match self {
            Self::Row(parts) => parts.iter().for_each(|part| part.spread(put)),
            _ => put(self),
        }
    }

    /// Its width where fractions are set at that size: smaller ones within another.
    fn set(&self, fractions: f64) -> f64 {
        let script = |math: &Self| SCRIPT * math.set(fractions) + BEHIND_SCRIPTS;
        match self {
            Self::Row(parts) => set_row(parts, fractions),
            Self::Number(text) => match text.strip_prefix(['-', '\u{2212}']) {
                Some(size) => SIGN + characters(size),
                None => characters(text),
            },
            Self::Text(text) => words(text),
            Self::Identifier(text) | Self::Function(text) | Self::Vector(text) => characters(text),
            Self::Operator(operator) => operator.width(),
            Self::Fraction(over, under) => fractions * over.set(SCRIPT).max(under.set(SCRIPT)) + 0.2,
            Self::Sub(base, low) => base.set(fractions) + script(low),
            Self::Sup(base, high) => base.set(fractions) + script(high),
            Self::SubSup(base, low, high) => base.set(fractions) + script(low).max(script(high)),
            Self::Root(inner) => inner.set(fractions) + 2.0,
            Self::Bracketed(inner) | Self::Squared(inner) | Self::Bars(inner) => {
                inner.set(fractions) + if inner.is_tall() { 2.4 } else { 1.45 }
            }
            Self::Cases(cases) => {
                let case = |(when, value): &(Self, Self)| when.set(fractions) + value.set(fractions) + 3.0;
                cases.iter().map(case).fold(0.0, f64::max)
            }
            Self::Integral(low, high, inner, variable) => {
                let sign = 1.9 + script(low).max(script(high));
                sign + inner.set(fractions) + 1.4 + variable.set(fractions)
            }
        }
    }
}

impl Operator {
    /// Its sign, with the room on both sides of it.
    fn width(self) -> f64 {
        match self {
            Self::Juxtapose => 0.35,
            Self::Comma => 0.85,
            Self::Plus | Self::Minus | Self::PlusMinus | Self::Times => SIGN + 0.9,
            _ => SIGN + 1.1,
        }
    }
}

fn set_row<M: Borrow<Math>>(parts: impl IntoIterator<Item = M>, fractions: f64) -> f64 {
    let mut total = 0.0;
    let mut before: Option<M> = None;
    for part in parts {
        let (this, last) = (part.borrow(), before.as_ref().map(M::borrow));
        total += match this {
            Math::Operator(Operator::Plus | Operator::Minus | Operator::PlusMinus) if Math::is_prefix(last) => SIGN,
            _ if Math::needs_space(last, this) => SPACE + this.set(fractions),
            _ => this.set(fractions),
        };
        before = Some(part);
    }
    total
}

/// Words or a unit, where `^2` is a superscript.
fn words(text: &str) -> f64 {
    let mut parts = text.split('^');
    let first = parts.next().map_or(0.0, characters);
    let raised = |part: &str| {
        let end = part.find(|c: char| !(c.is_ascii_digit() || c == '-')).unwrap_or(part.len());
        let (power, behind) = part.split_at(end);
        SCRIPT * characters(power) + BEHIND_SCRIPTS + characters(behind)
    };
    first + parts.map(raised).sum::<f64>()
}

fn characters(text: &str) -> f64 {
    text.chars().map(character).sum()
}

fn character(character: char) -> f64 {
    match character {
        '0'..='9' => 1.0,
        '.' | ',' | ' ' | '\u{a0}' | '\u{b7}' => 0.5,
        'i' | 'l' | 't' => 0.6,
        'f' | 'j' | 'r' | 's' | 'I' | 'J' | '(' | ')' | '[' | ']' | '|' | '/' | '\u{b2}' | '\u{b3}' | '\u{b0}' => 0.75,
        'm' | 'w' | 'M' | 'W' => 1.65,
        'A'..='Z' | '\u{394}' | '\u{3c9}' => 1.35,
        '\u{2003}' => 2.0,
        _ => 1.05,
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;

    /// What Chromium measured, in widths of a digit.
    #[test]
    fn widths_are_those_of_a_browser_within_a_twentieth() {
        let quantity = |number: &str, unit: &str| Math::Row(vec![Math::Number(number.into()), Math::Text(unit.into())]);
        let bracketed = |math: Math| Math::Bracketed(Arc::new(math));
        let mass = bracketed(Math::Row(vec![
            quantity("0.9946", "slug"),
            Math::Operator(Operator::Plus),
            quantity("102.48", "slug"),
        ]));
        for (math, measured) in [
            (quantity("-16.10", "ft/s^2"), 10.07),
            (mass, 22.79),
            (Math::relation(Math::subscripted("v", "A1"), Operator::Equals, quantity("2.426", "m/s")), 13.59),
        ] {
            let width = math.width();
            assert!((width / measured - 1.0).abs() < 0.05, "{width} for {measured}: {}", math.mathml(false));
        }
    }
}
