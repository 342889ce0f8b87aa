//! About how wide typeset mathematics is, for whoever must break a line.

use super::super::{Math, Operator};

/// Scripts are this much smaller than their base.
const SCRIPT: f64 = 0.7;

impl Math {
    /// A rough width, in widths of a digit.
    pub fn width(&self) -> f64 {
        match self {
            Self::Row(parts) => parts.iter().map(Self::width).sum(),
            Self::Number(text)
            | Self::Identifier(text)
            | Self::Text(text)
            | Self::Function(text)
            | Self::Vector(text) => u32::try_from(text.chars().count()).map_or(f64::INFINITY, f64::from),
            Self::Operator(Operator::Juxtapose) => 0.4,
            Self::Operator(Operator::Comma) => 1.0,
            Self::Operator(_) => 2.4,
            Self::Fraction(over, under) => over.width().max(under.width()) + 0.5,
            Self::Sub(base, script) | Self::Sup(base, script) => base.width() + SCRIPT * script.width(),
            Self::SubSup(base, low, high) => base.width() + SCRIPT * low.width().max(high.width()),
            Self::Root(inner) | Self::Bracketed(inner) | Self::Squared(inner) | Self::Bars(inner) => {
                inner.width() + 1.5
            }
            Self::Cases(cases) => {
                cases.iter().map(|(when, value)| when.width() + value.width() + 3.0).fold(0.0, f64::max)
            }
            Self::Integral(low, high, inner, variable) => {
                2.0 + SCRIPT * low.width().max(high.width()) + inner.width() + variable.width()
            }
        }
    }

    /// The parts of rows within rows, one after another.
    pub fn spread<'a>(&'a self, put: &mut dyn FnMut(&'a Self)) {
        match self {
            Self::Row(parts) => parts.iter().for_each(|part| part.spread(put)),
            _ => put(self),
        }
    }
}
