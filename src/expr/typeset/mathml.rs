//! Typeset mathematics as `MathML` Core, so that a page shows it without a script.

use std::borrow::Borrow;

use super::super::{Math, Operator};

impl Operator {
    /// Its sign; an invisible one for products that are only read.
    fn sign(self) -> &'static str {
        match self {
            Self::Plus => "+",
            Self::Minus => "\u{2212}",
            Self::Times => "\u{d7}",
            Self::Juxtapose => "\u{2062}",
            Self::Equals => "=",
            Self::Approximately => "\u{2248}",
            Self::Less => "&lt;",
            Self::AtMost => "\u{2264}",
            Self::Greater => "&gt;",
            Self::AtLeast => "\u{2265}",
            Self::Differs => "\u{2260}",
            Self::Comma => ",",
            Self::Implies => "\u{21d2}",
            Self::PlusMinus => "\u{b1}",
        }
    }
}

const SPACE: &str = r#"<mspace width="0.25em"/>"#;

impl Math {
    /// A whole `math` element, on a line of its own where `display` holds.
    ///
    /// ```
    /// use momentous_expr::Math;
    /// let element = Math::Number("-2.30".into()).mathml(false);
    /// assert!(element.ends_with("<mrow><mo form=\"prefix\">\u{2212}</mo><mn>2.30</mn></mrow></math>"));
    /// ```
    #[must_use]
    pub fn mathml(&self, display: bool) -> String {
        let display = if display { r#" display="block""# } else { "" };
        format!(r#"<math xmlns="http://www.w3.org/1998/Math/MathML"{display}>{}</math>"#, self.element())
    }

    /// Parts side by side, as one element without the `math` around it.
    pub fn row_element<M: Borrow<Self>>(parts: &[M]) -> String {
        row(parts)
    }

    /// One element without the `math` around it, for a caller that arranges several of them.
    #[must_use]
    pub fn element(&self) -> String {
        match self {
            Self::Row(parts) => row(parts),
            Self::Number(text) => match text.strip_prefix(['-', '\u{2212}']) {
                Some(size) => format!("<mrow><mo form=\"prefix\">\u{2212}</mo><mn>{}</mn></mrow>", escaped(size)),
                None => format!("<mn>{}</mn>", escaped(text)),
            },
            Self::Identifier(text) => format!("<mi>{}</mi>", escaped(text)),
            Self::Text(text) => words(text),
            Self::Operator(operator) => format!("<mo>{}</mo>", operator.sign()),
            Self::Fraction(above, below) => format!("<mfrac>{}{}</mfrac>", above.element(), below.element()),
            Self::Sub(base, subscript) => format!("<msub>{}{}</msub>", base.element(), subscript.subscript()),
            Self::Sup(base, exponent) => format!("<msup>{}{}</msup>", base.element(), exponent.element()),
            Self::SubSup(base, subscript, exponent) => {
                format!("<msubsup>{}{}{}</msubsup>", base.element(), subscript.subscript(), exponent.element())
            }
            Self::Root(inner) => format!("<msqrt>{}</msqrt>", inner.element()),
            Self::Bracketed(inner) => between("(", inner, ")"),
            Self::Squared(inner) => between("[", inner, "]"),
            Self::Bars(inner) => between("|", inner, "|"),
            Self::Function(name) => format!(r#"<mi mathvariant="normal">{}</mi>"#, escaped(name)),
            Self::Cases(cases) => {
                let cell = |math: &Self| format!("<mtd>{}</mtd>", math.element());
                let line = |(condition, value): &(Self, Self)| format!("<mtr>{}{}</mtr>", cell(value), cell(condition));
                let lines: String = cases.iter().map(line).collect();
                format!("<mrow><mo>{{</mo><mtable>{lines}</mtable></mrow>")
            }
            Self::Integral(low, high, integrand, variable) => {
                let sign = format!("<msubsup><mo>\u{222b}</mo>{}{}</msubsup>", low.element(), high.element());
                let differential = format!("<mi mathvariant=\"normal\">d</mi>{}", variable.element());
                format!("<mrow>{sign}{}<mspace width=\"0.1667em\"/>{differential}</mrow>", integrand.element())
            }
            Self::Vector(name) => {
                format!("<mi mathvariant=\"normal\">{}</mi>", name.chars().map(bold).collect::<String>())
            }
        }
    }

    /// Letters of a subscript in italics when single, upright when they form a word.
    fn subscript(&self) -> String {
        let Self::Text(text) = self else { return self.element() };
        let part = |part: &str| match part.chars().next() {
            Some(first) if first.is_ascii_digit() => format!("<mn>{part}</mn>"),
            Some(first) if first.is_alphabetic() => format!("<mi>{}</mi>", escaped(part)),
            _ => format!("<mtext>{}</mtext>", escaped(part)),
        };
        let parts: Vec<_> = super::math::subscript_parts(text).map(part).collect();
        if parts.len() == 1 { parts.concat() } else { format!("<mrow>{}</mrow>", parts.concat()) }
    }
}

/// Browsers set brackets that may grow with a gap, even where they need not: only those around what is tall may.
fn between(open: &str, inner: &Math, close: &str) -> String {
    let (stretchy, inside) = (inner.is_tall(), inner.element());
    let bracket = |sign, form| format!(r#"<mo form="{form}" stretchy="{stretchy}">{sign}</mo>"#);
    format!("<mrow>{}{inside}{}</mrow>", bracket(open, "prefix"), bracket(close, "postfix"))
}

fn row<M: Borrow<Math>>(parts: &[M]) -> String {
    let mut elements = String::new();
    let mut before = None;
    for part in parts.iter().map(M::borrow) {
        match part {
            Math::Operator(Operator::Juxtapose) => {
                elements.push_str("<mo lspace=\"0\" rspace=\"0.1667em\">\u{2062}</mo>");
            }
            Math::Operator(operator) if Math::is_prefix(before) => {
                elements.extend([r#"<mo form="prefix">"#, operator.sign(), "</mo>"]);
            }
            _ => {
                if Math::needs_space(before, part) {
                    elements.push_str(SPACE);
                }
                elements.push_str(&part.element());
            }
        }
        before = Some(part);
    }
    format!("<mrow>{elements}</mrow>")
}

/// Upright words or a unit; `^2` becomes a superscript, as in `m/s^2`.
fn words(text: &str) -> String {
    // a mtext trims ordinary spaces at its ends
    let element = |text: &str| {
        let kept = if text.trim() == text { escaped(text) } else { escaped(text).replace(' ', "\u{a0}") };
        format!("<mtext>{kept}</mtext>")
    };
    let (mut rest, mut elements) = (text, String::new());
    while let Some((base, raised)) = rest.split_once('^') {
        let end = raised.find(|c: char| !(c.is_ascii_digit() || c == '-')).unwrap_or(raised.len());
        let (power, after) = raised.split_at(end);
        let power = power.replace('-', "\u{2212}");
        elements.extend(["<msup>", &element(base), "<mn>", &power, "</mn></msup>"]);
        rest = after;
    }
    if elements.is_empty() {
        return element(rest);
    }
    if !rest.is_empty() {
        elements.push_str(&element(rest));
    }
    format!("<mrow>{elements}</mrow>")
}

/// The letter of the mathematical bold alphabet, since `MathML` Core has no bold variant.
fn bold(letter: char) -> char {
    let first = match letter {
        'a'..='z' => 0x1d41a - u32::from('a'),
        'A'..='Z' => 0x1d400 - u32::from('A'),
        '0'..='9' => 0x1d7ce - u32::from('0'),
        _ => return letter,
    };
    char::from_u32(u32::from(letter) + first).unwrap_or(letter)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::super::name_math;
    use super::*;

    /// Every element closed in its order, and no character that must be escaped.
    fn is_well_formed(xml: &str) -> bool {
        let mut open = Vec::new();
        for part in xml.split('<').skip(1) {
            let Some((tag, text)) = part.split_once('>') else { return false };
            let escaped = text.split('&').skip(1).all(|rest| rest.contains(';'));
            let name = tag.split_whitespace().next().unwrap_or_default();
            let closes = name.strip_prefix('/').is_none_or(|name| open.pop() == Some(name));
            if !closes || !escaped {
                return false;
            }
            if !tag.starts_with('/') && !tag.ends_with('/') {
                open.push(name);
            }
        }
        open.is_empty()
    }

    #[test]
    fn elements_are_those_of_mathml_core() {
        let unit = |number: &str, unit: &str| Math::Row(vec![Math::Number(number.into()), Math::Text(unit.into())]);
        for (math, expected) in [
            (name_math("v_A1"), "<msub><mi>v</mi><mrow><mi>A</mi><mn>1</mn></mrow></msub>"),
            (name_math("T_lost"), "<msub><mi>T</mi><mi>lost</mi></msub>"),
            (unit("2", "m/s"), "<mrow><mn>2</mn><mspace width=\"0.25em\"/><mtext>m/s</mtext></mrow>"),
            (unit("30", "\u{b0}"), "<mrow><mn>30</mn><mtext>\u{b0}</mtext></mrow>"),
            (Math::Text("m/s^2".into()), "<mrow><msup><mtext>m/s</mtext><mn>2</mn></msup></mrow>"),
            (Math::Text("a < b & c".into()), "<mtext>a &lt; b &amp; c</mtext>"),
            (Math::Vector("v".into()), "<mi mathvariant=\"normal\">\u{1d42f}</mi>"),
            (
                Math::relation(Math::Number("1".into()), Operator::Less, Math::Number("-2".into())),
                "<mrow><mn>1</mn><mo>&lt;</mo><mrow><mo form=\"prefix\">\u{2212}</mo><mn>2</mn></mrow></mrow>",
            ),
        ] {
            assert_eq!(math.element(), expected);
        }
    }

    #[test]
    fn every_construction_is_well_formed() {
        let number = || Arc::new(Math::Number("-1".into()));
        let all = Math::Row(vec![
            Math::Fraction(number(), number()),
            Math::Sup(number(), number()),
            Math::SubSup(number(), Arc::new(Math::Text("a<b".into())), number()),
            Math::Operator(Operator::Implies),
            Math::Root(number()),
            Math::Bracketed(number()),
            Math::Squared(number()),
            Math::Bars(number()),
            Math::Function("sin".into()),
            Math::Cases(vec![(Math::Text("t < 1".into()), Math::Number("-1".into()))]),
            Math::Integral(number(), number(), number(), number()),
        ]);
        let xml = all.mathml(true);
        assert!(is_well_formed(&xml), "{xml}");
        assert!(xml.starts_with("<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\"><mrow>"));
        assert!(!is_well_formed("<a><b></a></b>"));
    }
}
