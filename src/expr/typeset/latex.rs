//! Typeset mathematics as LaTeX (with amsmath).

use super::super::{Math, Operator};

/// Letters and signs that LaTeX knows by name.
const NAMED: [(char, &str); 25] = [
    ('\u{3b1}', r"\alpha"),
    ('\u{3b2}', r"\beta"),
    ('\u{3b3}', r"\gamma"),
    ('\u{3b4}', r"\delta"),
    ('\u{3b5}', r"\varepsilon"),
    ('\u{3b6}', r"\zeta"),
    ('\u{3b7}', r"\eta"),
    ('\u{3b8}', r"\theta"),
    ('\u{3ba}', r"\kappa"),
    ('\u{3bb}', r"\lambda"),
    ('\u{3bc}', r"\mu"),
    ('\u{3bd}', r"\nu"),
    ('\u{3c0}', r"\pi"),
    ('\u{3c1}', r"\rho"),
    ('\u{3c3}', r"\sigma"),
    ('\u{3c4}', r"\tau"),
    ('\u{3c6}', r"\varphi"),
    ('\u{3c8}', r"\psi"),
    ('\u{3c9}', r"\omega"),
    ('\u{3a9}', r"\Omega"),
    ('\u{394}', r"\Delta"),
    ('\u{3a3}', r"\Sigma"),
    ('\u{2220}', r"\angle"),
    ('\u{221e}', r"\infty"),
    ('\u{2113}', r"\ell"),
];

/// Characters of upright text that LaTeX would misread, or that its fonts lack.
const IN_TEXT: [(char, &str); 22] = [
    ('\\', r"\textbackslash{}"),
    ('{', r"\{"),
    ('}', r"\}"),
    ('$', r"\$"),
    ('&', r"\&"),
    ('#', r"\#"),
    ('%', r"\%"),
    ('_', r"\_"),
    ('~', r"\textasciitilde{}"),
    ('\u{b0}', r"$^\circ$"),
    ('\u{b7}', r"$\cdot$"),
    ('\u{22c5}', r"$\cdot$"),
    ('\u{d7}', r"$\times$"),
    ('\u{2212}', r"$-$"),
    ('\u{b5}', r"$\mu$"),
    ('\u{3bc}', r"$\mu$"),
    ('\u{3a9}', r"$\Omega$"),
    ('\u{b9}', r"$^1$"),
    ('\u{b2}', r"$^2$"),
    ('\u{b3}', r"$^3$"),
    ('\u{207b}', r"$^-$"),
    ('\u{2074}', r"$^4$"),
];

/// The room that most mathematics takes, in bytes.
const USUAL_LENGTH: usize = 48;

/// Functions that have a command of their own.
const COMMANDS: [&str; 8] = ["sin", "cos", "tan", "arcsin", "arccos", "arctan", "exp", "ln"];

impl Operator {
    fn latex(self) -> &'static str {
        match self {
            Self::Plus => " + ",
            Self::Minus => " - ",
            Self::Times => r" \times ",
            Self::Juxtapose => r"\,",
            Self::Equals => " = ",
            Self::Approximately => r" \approx ",
            Self::Less => " < ",
            Self::AtMost => r" \le ",
            Self::Greater => " > ",
            Self::AtLeast => r" \ge ",
            Self::Differs => r" \ne ",
            Self::Comma => r",\; ",
            Self::Implies => r" \Rightarrow ",
            Self::PlusMinus => r" \pm ",
        }
    }
}

impl Math {
    /// LaTeX for math mode, without the dollar signs.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use momentous_expr::{Math, name_math};
    /// let fraction = Math::Fraction(Arc::new(name_math("J_A[hit]")), Arc::new(name_math("m_A")));
    /// assert_eq!(fraction.latex(), r"\frac{J_{A}}{m_{A}}");
    /// ```
    #[must_use]
    pub fn latex(&self) -> String {
        let mut out = String::with_capacity(USUAL_LENGTH);
        self.write_latex(&mut out);
        out
    }

    /// The same for parts side by side, at the end of a text.
    pub fn put_row_latex(parts: &[Self], out: &mut String) {
        write_row(parts, out);
    }

    fn write_latex(&self, out: &mut String) {
        match self {
            Self::Row(parts) => write_row(parts, out),
            Self::Number(text) => out.push_str(text),
            Self::Identifier(text) => write_identifier(text, out),
            Self::Text(text) => write_command("text", text, out),
            Self::Operator(operator) => out.push_str(operator.latex().trim()),
            Self::Fraction(above, below) => {
                out.push_str(r"\frac");
                above.write_group(out);
                below.write_group(out);
            }
            Self::Sub(base, subscript) => {
                base.write_latex(out);
                subscript.write_subscript(out);
            }
            Self::Sup(base, exponent) => {
                if matches!(**base, Self::Sup(..) | Self::SubSup(..)) {
                    base.write_group(out);
                } else {
                    base.write_latex(out);
                }
                out.push('^');
                exponent.write_group(out);
            }
            Self::SubSup(base, subscript, exponent) => {
                base.write_latex(out);
                subscript.write_subscript(out);
                out.push('^');
                exponent.write_group(out);
            }
            Self::Root(inner) => {
                out.push_str(r"\sqrt");
                inner.write_group(out);
            }
            Self::Bracketed(inner) => inner.write_between("(", ")", out),
            Self::Squared(inner) => inner.write_between("[", "]", out),
            Self::Bars(inner) => inner.write_between(r"\lvert ", r"\rvert ", out),
            Self::Function(name) if COMMANDS.contains(&name.as_str()) => out.extend(["\\", name]),
            Self::Function(name) => write_command("operatorname", name, out),
            Self::Cases(cases) => {
                out.push_str(r"\begin{cases} ");
                for (index, (condition, value)) in cases.iter().enumerate() {
                    out.push_str(if index > 0 { r" \\ " } else { "" });
                    value.write_latex(out);
                    out.push_str(" & ");
                    condition.write_latex(out);
                }
                out.push_str(r" \end{cases}");
            }
            Self::Integral(low, high, integrand, variable) => {
                out.push_str(r"\int_");
                low.write_group(out);
                out.push('^');
                high.write_group(out);
                out.push(' ');
                integrand.write_latex(out);
                out.push_str(r"\,d");
                let start = out.len();
                variable.write_latex(out);
                // A command needs a space before a letter that follows.
                if !out[start..].starts_with(char::is_alphabetic) {
                    out.insert(start, ' ');
                }
            }
            Self::Vector(name) => write_command("mathbf", name, out),
        }
    }

    /// In braces.
    fn write_group(&self, out: &mut String) {
        out.push('{');
        self.write_latex(out);
        out.push('}');
    }

    /// Letters of a subscript in italics when single, upright when they form a word: `A1`, `avg,A`.
    fn write_subscript(&self, out: &mut String) {
        out.push('_');
        let Self::Text(text) = self else { return self.write_group(out) };
        out.push('{');
        for part in super::math::subscript_parts(text) {
            let word = part.chars().count() > 1 && part.starts_with(char::is_alphabetic);
            if word || part.starts_with(' ') {
                write_command("text", part, out);
            } else {
                write_escaped(part, out);
            }
        }
        out.push('}');
    }

    /// Between delimiters that grow where something tall is inside.
    fn write_between(&self, open: &str, close: &str, out: &mut String) {
        let tall = self.is_tall();
        out.extend([if tall { r"\left" } else { "" }, open]);
        self.write_latex(out);
        out.extend(if tall { [r"\right", close] } else { ["", close.trim_end()] });
    }

    /// Whether brackets around it must grow.
    pub(super) fn is_tall(&self) -> bool {
        match self {
            Self::Fraction(..) | Self::Cases(_) | Self::Integral(..) => true,
            Self::Row(parts) => parts.iter().any(Self::is_tall),
            Self::Root(inner) | Self::Bracketed(inner) | Self::Squared(inner) | Self::Bars(inner) => inner.is_tall(),
            Self::Sup(base, _) | Self::Sub(base, _) | Self::SubSup(base, _, _) => base.is_tall(),
            _ => false,
        }
    }
}

fn write_identifier(text: &str, out: &mut String) {
    let mut letters = text.chars();
    match (letters.next(), letters.next()) {
        (Some(single), None) => match NAMED.iter().find(|(sign, _)| !single.is_ascii() && *sign == single) {
            Some((_, command)) => out.push_str(command),
            None => write_escaped(text, out),
        },
        (None, _) => out.push_str("{}"),
        _ => write_command("mathit", text, out),
    }
}

fn write_command(name: &str, text: &str, out: &mut String) {
    out.extend(["\\", name, "{"]);
    write_escaped(text, out);
    out.push('}');
}

/// Upright text with what LaTeX would misread replaced; `^2` becomes a superscript, as in `m/s^2`.
fn write_escaped(text: &str, out: &mut String) {
    let mut rest = text;
    while let Some(place) = rest.find(is_marked) {
        let (plain, marked) = rest.split_at(place);
        out.push_str(plain);
        rest = match marked.strip_prefix('^') {
            Some(power) => write_power(power, out),
            None => write_sign(marked, out),
        };
    }
    out.push_str(rest);
}

/// Whether LaTeX might read it as something else: letters, digits and the usual marks it does not.
fn is_marked(letter: char) -> bool {
    !(letter.is_ascii_alphanumeric() || matches!(letter, ' ' | '\u{a0}' | '/' | '.' | ',' | '-'))
}

/// The digits after `^`, raised; gives what stands behind them.
fn write_power<'a>(text: &'a str, out: &mut String) -> &'a str {
    let end = text.find(|letter: char| !(letter.is_ascii_digit() || letter == '-')).unwrap_or(text.len());
    let (power, rest) = text.split_at(end);
    if power.is_empty() {
        out.push_str(r"\textasciicircum{}");
    } else {
        out.extend(["$^{", power, "}$"]);
    }
    rest
}

/// The first letter, or what stands for it; gives what stands behind it.
fn write_sign<'a>(text: &'a str, out: &mut String) -> &'a str {
    let mut letters = text.chars();
    if let Some(letter) = letters.next() {
        match IN_TEXT.iter().find(|(escaped, _)| *escaped == letter) {
            Some((_, replacement)) => out.push_str(replacement),
            None => out.push(letter),
        }
    }
    letters.as_str()
}

fn write_row(parts: &[Math], out: &mut String) {
    let start = out.len();
    let mut before: Option<&Math> = None;
    for part in parts {
        let mark = match part {
            Math::Operator(_) => out.len(),
            _ => {
                if Math::needs_space(before, part) {
                    out.push_str(r"\ ");
                }
                out.len()
            }
        };
        match part {
            Math::Operator(Operator::Juxtapose) if is_function(before) => out.push(' '),
            Math::Operator(Operator::Juxtapose) if matches!(before, Some(Math::Sup(..))) => {
                out.push_str(r"\,");
            }
            Math::Operator(operator) if Math::is_prefix(before) => out.push_str(operator.latex().trim()),
            Math::Operator(operator) => out.push_str(operator.latex()),
            _ => part.write_latex(out),
        }
        // `\pi` and `r` must not run together to `\pir`
        if out[mark..].starts_with(|c: char| c.is_ascii_alphabetic()) && ends_with_command(&out[start..mark]) {
            out.insert(mark, ' ');
        }
        before = Some(part);
    }
}

fn is_function(part: Option<&Math>) -> bool {
    match part {
        Some(Math::Function(_)) => true,
        Some(Math::Sup(base, _)) => is_function(Some(base)),
        _ => false,
    }
}

fn ends_with_command(latex: &str) -> bool {
    let letters = latex.bytes().rev().take_while(u8::is_ascii_alphabetic).count();
    letters > 0 && latex.as_bytes().get(..latex.len() - letters).is_some_and(|before| before.ends_with(b"\\"))
}
