//! Typeset mathematics as Typst, for the inside of `$...$`.

use super::super::{Math, Operator};

/// The gap between a number and its unit, or a word and what follows: it is read and copied as a space.
const GAP: &str = "\"\u{a0}\"";
/// The gap between factors.
const THIN: &str = "\"\u{2009}\"";

impl Operator {
    fn typst(self) -> &'static str {
        match self {
            Self::Plus => "+",
            Self::Minus => "\u{2212}",
            Self::Times => "\u{d7}",
            Self::Juxtapose => THIN,
            Self::Equals => "=",
            Self::Approximately => "\u{2248}",
            Self::Less => "<",
            Self::AtMost => "\u{2264}",
            Self::Greater => ">",
            Self::AtLeast => "\u{2265}",
            Self::Differs => "\u{2260}",
            Self::Comma => "\\,",
            Self::Implies => "\u{21d2}",
            Self::PlusMinus => "\u{b1}",
        }
    }
}

impl Math {
    /// Typst for math mode, without the dollar signs.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use momentous_expr::{Math, name_math};
    /// let fraction = Math::Fraction(Arc::new(name_math("J_A[hit]")), Arc::new(name_math("m_A")));
    /// assert_eq!(fraction.typst(), "frac(attach(J,b:A),attach(m,b:A))");
    /// ```
    #[must_use]
    pub fn typst(&self) -> String {
        let mut code = TypstMath::default();
        code.math(self);
        code.into_code()
    }
}

/// Typst's mathematics as it grows. Blanks stand only where letters or digits would run together: beside words, Typst would
/// print them.
#[derive(Debug, Default)]
pub struct TypstMath {
    code: String,
}

impl TypstMath {
    /// The text written so far.
    #[must_use]
    pub fn into_code(self) -> String {
        self.code
    }

    /// Code that is ready.
    pub fn put(&mut self, code: &str) {
        let runs_on = |letter: Option<char>| letter.is_some_and(char::is_alphanumeric);
        if runs_on(self.code.chars().next_back()) && runs_on(code.chars().next()) {
            self.code.push(' ');
        }
        self.code.push_str(code);
    }

    /// A call of a function; what `inner` writes stands in its brackets.
    pub fn call(&mut self, name: &str, inner: impl FnOnce(&mut Self)) {
        self.put(name);
        self.code.push('(');
        inner(self);
        self.code.push(')');
    }

    /// A further argument, named or not.
    pub fn argument(&mut self, name: &str) {
        self.code.push(',');
        self.code.push_str(name);
    }

    /// Upright words.
    pub fn words(&mut self, text: &str) {
        self.put(&quoted(text));
    }

    /// A sign by itself, whatever it means to Typst.
    pub fn sign(&mut self, sign: char) {
        if sign.is_alphanumeric() {
            self.put(sign.encode_utf8(&mut [0; 4]));
        } else if sign.is_whitespace() || sign.is_control() {
            self.put(GAP);
        } else {
            self.code.push('\\');
            self.code.push(sign);
        }
    }

    /// Digits with at most one point; anything else that a number may hold is quoted.
    pub fn number(&mut self, text: &str) {
        let (whole, fraction) = text.split_once('.').unwrap_or((text, "0"));
        let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        if digits(whole) && digits(fraction) { self.put(text) } else { self.words(text) }
    }

    /// A variable's name: a letter in italics, and so a longer name.
    fn identifier(&mut self, text: &str) {
        let mut letters = text.chars();
        match (letters.next(), letters.next()) {
            (Some(letter), None) if letter.is_alphanumeric() => self.sign(letter),
            (Some(_), Some(_)) => self.call("italic", |code| code.words(text)),
            _ => self.words(text),
        }
    }

    /// A layout tree.
    pub fn math(&mut self, math: &Math) {
        match math {
            Math::Row(parts) => self.row(parts),
            Math::Number(text) => match text.strip_prefix(['-', '\u{2212}']) {
                Some(size) => {
                    self.prefix(Operator::Minus);
                    self.number(size);
                }
                None => self.number(text),
            },
            Math::Identifier(text) => self.identifier(text),
            Math::Text(text) => self.text(text),
            Math::Operator(operator) => self.put(operator.typst()),
            Math::Fraction(above, below) => self.call("frac", |code| {
                code.math(above);
                code.argument("");
                code.math(below);
            }),
            Math::Sub(base, low) => self.attached(base, Some(low), None),
            Math::Sup(base, high) => self.attached(base, None, Some(high)),
            Math::SubSup(base, low, high) => self.attached(base, Some(low), Some(high)),
            Math::Root(inner) => self.call("sqrt", |code| code.math(inner)),
            Math::Bracketed(inner) => self.between('(', inner, ')'),
            Math::Squared(inner) => self.between('[', inner, ']'),
            Math::Bars(inner) => self.call("lr", |code| code.enclosed('|', inner, '|')),
            Math::Function(name) => self.call("op", |code| code.words(name)),
            Math::Cases(cases) => self.call("cases", |code| {
                for (index, (condition, value)) in cases.iter().enumerate() {
                    if index > 0 {
                        code.argument("");
                    }
                    code.math(value);
                    code.put("&");
                    code.math(condition);
                }
            }),
            Math::Integral(low, high, integrand, variable) => {
                self.call("attach", |code| {
                    code.put("integral");
                    code.argument("b:");
                    code.math(low);
                    code.argument("t:");
                    code.math(high);
                });
                self.math(integrand);
                self.put(THIN);
                self.words("d");
                self.math(variable);
            }
            Math::Vector(name) => self.call("bold", |code| code.words(name)),
        }
    }

    /// Parts side by side.
    pub fn row(&mut self, parts: &[Math]) {
        let mut before: Option<&Math> = None;
        for part in parts {
            match part {
                // Typst sets the gap behind a function by itself.
                Math::Operator(Operator::Juxtapose) if is_function(before) => {}
                Math::Operator(operator) if Math::is_prefix(before) => self.prefix(*operator),
                _ => {
                    if Math::needs_space(before, part) {
                        self.put(GAP);
                    }
                    self.math(part);
                }
            }
            before = Some(part);
        }
    }

    /// A sign that belongs to what follows. At the start of the whole and behind most signs, Typst sees that by itself.
    fn prefix(&mut self, operator: Operator) {
        let joins = |last: char| last.is_alphanumeric() || matches!(last, '"' | ')' | ']');
        if matches!(operator, Operator::Minus | Operator::Plus | Operator::PlusMinus) && self.code.ends_with(joins) {
            self.call("class", |code| {
                code.words("unary");
                code.argument(operator.typst());
            });
        } else {
            self.put(operator.typst());
        }
    }

    /// Words or a unit; `^2` becomes a superscript, as in `m/s^2`.
    fn text(&mut self, text: &str) {
        let mut rest = text;
        while let Some((base, raised)) = rest.split_once('^') {
            let end = raised.find(|sign: char| !(sign.is_ascii_digit() || sign == '-')).unwrap_or(raised.len());
            let (power, after) = raised.split_at(end);
            self.call("attach", |code| {
                code.words(base);
                code.argument("t:");
                code.words(&power.replace('-', "\u{2212}"));
            });
            rest = after;
        }
        if !rest.is_empty() || text.is_empty() {
            self.words(rest);
        }
    }

    fn attached(&mut self, base: &Math, low: Option<&Math>, high: Option<&Math>) {
        self.call("attach", |code| {
            code.math(base);
            if let Some(low) = low {
                code.argument("b:");
                code.subscript(low);
            }
            if let Some(high) = high {
                code.argument("t:");
                code.math(high);
            }
        });
    }

    /// Letters of a subscript in italics when single, upright when they form a word: `A1`, `avg,A`.
    fn subscript(&mut self, math: &Math) {
        let Math::Text(text) = math else { return self.math(math) };
        for part in super::math::subscript_parts(text) {
            let is_single = part.chars().count() == 1 && part.chars().all(char::is_alphabetic);
            if is_single { self.put(part) } else { self.words(part) }
        }
    }

    /// Between brackets that grow only where something tall is inside.
    fn between(&mut self, open: char, inner: &Math, close: char) {
        if inner.is_tall() {
            self.call("lr", |code| code.enclosed(open, inner, close));
        } else {
            self.enclosed(open, inner, close);
        }
    }

    fn enclosed(&mut self, open: char, inner: &Math, close: char) {
        self.sign(open);
        self.math(inner);
        self.sign(close);
    }
}

fn is_function(part: Option<&Math>) -> bool {
    match part {
        Some(Math::Function(_)) => true,
        Some(Math::Sup(base, _)) => is_function(Some(base)),
        _ => false,
    }
}

/// A string literal of Typst.
#[must_use]
pub fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for sign in text.chars() {
        match sign {
            '"' | '\\' => out.extend(['\\', sign]),
            control if control.is_control() => out.push(' '),
            plain => out.push(plain),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::super::name_math;
    use super::*;

    #[test]
    fn constructions_are_calls_whose_parts_cannot_run_together() {
        let number = |text: &str| Math::Number(text.into());
        let row = |parts: &[Math]| Math::Row(parts.to_vec());
        for (math, expected) in [
            (name_math("v_A1"), "attach(v,b:A\"1\")"),
            (name_math("T_lost"), "attach(T,b:\"lost\")"),
            (row(&[number("2.50"), Math::Text("m/s".into())]), "2.50\"\u{a0}\"\"m/s\""),
            (Math::Text("m/s^2".into()), "attach(\"m/s\",t:\"2\")"),
            (Math::Text("a \"b\" \\ $".into()), "\"a \\\"b\\\" \\\\ $\""),
            (row(&[name_math("m"), number("-3")]), "m class(\"unary\",\u{2212})3"),
            (Math::relation(name_math("v"), Operator::Equals, number("-3")), "v=\u{2212}3"),
            (Math::Bracketed(Arc::new(number("-3"))), "\\(\u{2212}3\\)"),
            (row(&[Math::Function("sin".into()), Math::Operator(Operator::Juxtapose), name_math("x")]), "op(\"sin\")x"),
            (Math::Identifier("xy".into()), "italic(\"xy\")"),
            (row(&[name_math("a"), name_math("b")]), "a b"),
        ] {
            assert_eq!(math.typst(), expected);
        }
    }
}
