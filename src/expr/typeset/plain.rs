//! Typeset mathematics on one line of plain text.

use super::super::{Math, Operator};

impl Operator {
    /// Its sign in plain text, with the spaces around it.
    fn plain(self) -> &'static str {
        match self {
            Self::Plus => " + ",
            Self::Minus => " \u{2212} ",
            Self::Times => " \u{d7} ",
            Self::Juxtapose => " ",
            Self::Equals => " = ",
            Self::Approximately => " \u{2248} ",
            Self::Less => " < ",
            Self::AtMost => " \u{2264} ",
            Self::Greater => " > ",
            Self::AtLeast => " \u{2265} ",
            Self::Differs => " \u{2260} ",
            Self::Comma => ", ",
            Self::Implies => " \u{21d2} ",
            Self::PlusMinus => " \u{b1} ",
        }
    }
}

impl Math {
    /// Whether a minus sign stands in front.
    #[must_use]
    pub fn begins_with_minus(&self) -> bool {
        self.plain().starts_with('\u{2212}')
    }

    /// On one line, with true minus signs: `m_A v_A1 = (2 kg)(−3 m/s)`.
    ///
    /// ```
    /// use momentous_expr::{Math, Operator, name_math};
    /// let line = Math::relation(name_math("v_A2"), Operator::Equals, Math::Number("-0.40".into()));
    /// assert_eq!(line.plain(), "v_A2 = \u{2212}0.40");
    /// ```
    #[must_use]
    pub fn plain(&self) -> String {
        match self {
            Self::Row(parts) => row(parts),
            Self::Number(text) => text.replace('-', "\u{2212}"),
            Self::Identifier(text) | Self::Text(text) | Self::Function(text) | Self::Vector(text) => text.clone(),
            Self::Operator(operator) => operator.plain().trim().to_owned(),
            Self::Fraction(above, below) => format!("{}/{}", above.held(false), below.held(true)),
            Self::Sub(base, subscript) => format!("{}_{}", base.plain(), subscript.plain()),
            Self::Sup(base, exponent) => format!("{}^{}", base.plain(), exponent.held(true)),
            Self::SubSup(base, subscript, exponent) => {
                format!("{}_{}^{}", base.plain(), subscript.plain(), exponent.held(true))
            }
            Self::Root(inner) => format!("sqrt({})", inner.plain()),
            Self::Bracketed(inner) => format!("({})", inner.plain()),
            Self::Squared(inner) => format!("[{}]", inner.plain()),
            Self::Bars(inner) => format!("|{}|", inner.plain()),
            Self::Cases(cases) => {
                let case = |(condition, value): &(Self, Self)| format!("{} ({})", value.plain(), condition.plain());
                format!("{{{}}}", cases.iter().map(case).collect::<Vec<_>>().join("; "))
            }
            Self::Integral(low, high, integrand, variable) => {
                let (low, high) = (low.plain(), high.plain());
                format!("integral from {low} to {high} of {} d{}", integrand.plain(), variable.plain())
            }
        }
    }

    /// The same for parts side by side.
    #[must_use]
    pub fn row_plain(parts: &[Self]) -> String {
        row(parts)
    }

    /// In brackets where a fraction bar or a power would else seem to take a part of it.
    fn held(&self, tight: bool) -> String {
        let loose = match self {
            Self::Row(parts) => parts.iter().any(|part| match part {
                Self::Operator(Operator::Juxtapose) => tight,
                Self::Operator(_) => true,
                _ => tight && parts.len() > 1,
            }),
            Self::Fraction(..) => tight,
            _ => false,
        };
        if loose { format!("({})", self.plain()) } else { self.plain() }
    }
}

fn row(parts: &[Math]) -> String {
    let mut text = String::new();
    for (index, part) in parts.iter().enumerate() {
        let before = index.checked_sub(1).and_then(|index| parts.get(index));
        match part {
            Math::Operator(operator) if Math::is_prefix(before) => text.push_str(operator.plain().trim()),
            Math::Operator(operator) => text.push_str(operator.plain()),
            _ => {
                if Math::needs_space(before, part) {
                    text.push(' ');
                }
                text.push_str(&part.plain());
            }
        }
    }
    text
}
