//! Typeset mathematics as LaTeX (with amsmath).

use super::{Math, Operator};

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
    /// As LaTeX for math mode, without the dollar signs.
    ///
    /// ```
    /// use momentous::expr::{Math, name_math};
    /// let fraction = Math::Fraction(Box::new(name_math("J_A[hit]")), Box::new(name_math("m_A")));
    /// assert_eq!(fraction.latex(), r"\frac{J_{A}}{m_{A}}");
    /// ```
    #[must_use]
    pub fn latex(&self) -> String {
        match self {
            Self::Row(parts) => row(parts),
            Self::Number(text) => text.clone(),
            Self::Identifier(text) => identifier(text),
            Self::Text(text) => format!(r"\text{{{}}}", escaped(text)),
            Self::Operator(operator) => operator.latex().trim().to_owned(),
            Self::Fraction(above, below) => format!(r"\frac{{{}}}{{{}}}", above.latex(), below.latex()),
            Self::Sub(base, subscript) => format!("{}_{{{}}}", base.latex(), subscript.latex_subscript()),
            Self::Sup(base, exponent) => format!("{}^{{{}}}", base.latex_base(), exponent.latex()),
            Self::SubSup(base, subscript, exponent) => {
                format!("{}_{{{}}}^{{{}}}", base.latex(), subscript.latex_subscript(), exponent.latex())
            }
            Self::Root(inner) => format!(r"\sqrt{{{}}}", inner.latex()),
            Self::Bracketed(inner) => inner.latex_between("(", ")"),
            Self::Squared(inner) => inner.latex_between("[", "]"),
            Self::Bars(inner) => inner.latex_between(r"\lvert ", r"\rvert "),
            Self::Function(name) if COMMANDS.contains(&name.as_str()) => format!(r"\{name}"),
            Self::Function(name) => format!(r"\operatorname{{{}}}", escaped(name)),
            Self::Cases(cases) => {
                let case = |(condition, value): &(Self, Self)| format!("{} & {}", value.latex(), condition.latex());
                let rows: Vec<_> = cases.iter().map(case).collect();
                format!(r"\begin{{cases}} {} \end{{cases}}", rows.join(r" \\ "))
            }
            Self::Integral(low, high, integrand, variable) => {
                let (low, high) = (low.latex(), high.latex());
                format!(r"\int_{{{low}}}^{{{high}}} {}\,d{}", integrand.latex(), spaced(&variable.latex()))
            }
            Self::Vector(name) => format!(r"\mathbf{{{}}}", escaped(name)),
        }
    }

    /// The same for parts side by side.
    pub(crate) fn row_latex(parts: &[Self]) -> String {
        row(parts)
    }

    /// Letters of a subscript in italics when single, upright when they form a word: `A1`, `avg,A`.
    fn latex_subscript(&self) -> String {
        let Self::Text(text) = self else { return self.latex() };
        let parts = super::math::subscript_parts(text);
        let part = |part: &str| {
            let word = part.chars().count() > 1 && part.starts_with(char::is_alphabetic);
            if word || part.starts_with(' ') { format!(r"\text{{{}}}", escaped(part)) } else { escaped(part) }
        };
        parts.into_iter().map(part).collect()
    }

    fn latex_base(&self) -> String {
        match self {
            Self::Sup(..) | Self::SubSup(..) => format!("{{{}}}", self.latex()),
            other => other.latex(),
        }
    }

    /// Between delimiters that grow where something tall is inside.
    fn latex_between(&self, open: &str, close: &str) -> String {
        let inside = self.latex();
        if self.is_tall() {
            format!(r"\left{open}{inside}\right{close}")
        } else {
            format!("{open}{inside}{}", close.trim_end())
        }
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

fn identifier(text: &str) -> String {
    let mut letters = text.chars();
    match (letters.next(), letters.next()) {
        (Some(single), None) => match NAMED.iter().find(|(own, _)| *own == single) {
            Some((_, command)) => (*command).to_owned(),
            None => escaped(text),
        },
        (None, _) => "{}".to_owned(),
        _ => format!(r"\mathit{{{}}}", escaped(text)),
    }
}

/// A command needs a space before a letter that follows.
fn spaced(latex: &str) -> String {
    if latex.starts_with(char::is_alphabetic) { latex.to_owned() } else { format!(" {latex}") }
}

/// Upright text with what LaTeX would misread replaced; `^2` becomes a superscript, as in `m/s^2`.
fn escaped(text: &str) -> String {
    let mut result = String::new();
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        if letter == '^' {
            let mut power = String::new();
            while let Some(digit) = letters.next_if(|c| c.is_ascii_digit() || *c == '-') {
                power.push(digit);
            }
            if power.is_empty() {
                result.push_str(r"\textasciicircum{}");
            } else {
                result.extend(["$^{", &power, "}$"]);
            }
            continue;
        }
        match IN_TEXT.iter().find(|(own, _)| *own == letter) {
            Some((_, replacement)) => result.push_str(replacement),
            None => result.push(letter),
        }
    }
    result
}

fn row(parts: &[Math]) -> String {
    let mut text = String::new();
    for (index, part) in parts.iter().enumerate() {
        let before = index.checked_sub(1).and_then(|index| parts.get(index));
        let latex = match part {
            Math::Operator(Operator::Juxtapose) if matches!(before, Some(Math::Function(_) | Math::Sup(..))) => {
                if is_function(before) {
                    " ".to_owned()
                } else {
                    r"\,".to_owned()
                }
            }
            Math::Operator(operator) if Math::is_prefix(before) => operator.latex().trim().to_owned(),
            Math::Operator(operator) => operator.latex().to_owned(),
            part => {
                if Math::needs_space(before, part) {
                    text.push_str(r"\ ");
                }
                part.latex()
            }
        };
        // `\pi` and `r` must not run together to `\pir`
        if ends_with_command(&text) && latex.starts_with(|c: char| c.is_ascii_alphabetic()) {
            text.push(' ');
        }
        text.push_str(&latex);
    }
    text
}

fn is_function(part: Option<&Math>) -> bool {
    match part {
        Some(Math::Function(_)) => true,
        Some(Math::Sup(base, _)) => is_function(Some(base)),
        _ => false,
    }
}

fn ends_with_command(latex: &str) -> bool {
    latex.rfind('\\').is_some_and(|start| {
        let name = latex.get(start + 1..).unwrap_or_default();
        !name.is_empty() && name.chars().all(|c| c.is_ascii_alphabetic())
    })
}
