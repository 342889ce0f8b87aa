//! Mathematics in one line of type: runs of one face, size and rise, for SVG text and for estimating widths.

use momentous_expr::Math;
use momentous_expr::Operator;
use momentous_expr::subscript_parts;

/// A face of type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Face {
    Upright,
    Italic,
    Bold,
}

/// How a piece of type looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    pub face: Face,
    /// Relative to the size of the label.
    pub size: f64,
    /// The rise of its baseline, in units of the label's size.
    pub rise: f64,
}

/// Text of one look.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    pub text: String,
    pub look: Look,
}

/// Scripts are this much smaller than their base.
const SCRIPT: f64 = 0.7;
/// Rise of a superscript and drop of a subscript, relative to the base.
const RISE: f64 = 0.36;
const DROP: f64 = 0.2;
/// Deeper than this, terms are no longer taken apart; no label comes near it.
const DEEPEST: u32 = 64;

/// A space that SVG does not collapse, and a thin one.
const SPACE: &str = "\u{a0}";
const THIN: &str = "\u{2009}";

/// The runs of a label, left to right.
pub(super) fn runs(math: &Math) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    set(math, &mut |piece, look| match runs.last_mut() {
        Some(last) if last.look == look => last.text.push_str(piece),
        _ => runs.push(Run { text: piece.to_owned(), look }),
    });
    runs
}

/// Hands the pieces of a label over, left to right; neighbours may look alike.
pub(super) fn set(math: &Math, put: &mut dyn FnMut(&str, Look)) {
    Line { put, size: 1.0, rise: 0.0, depth: 0 }.set(math);
}

struct Line<'a> {
    put: &'a mut dyn FnMut(&str, Look),
    size: f64,
    rise: f64,
    depth: u32,
}

impl Line<'_> {
    fn put(&mut self, text: &str, face: Face) {
        (self.put)(text, Look { face, size: self.size, rise: self.rise });
    }

    /// The text with something else in place of a character.
    fn put_with(&mut self, text: &str, character: char, instead: &str) {
        for (index, piece) in text.split(character).enumerate() {
            self.put(if index > 0 { instead } else { "" }, Face::Upright);
            self.put(piece, Face::Upright);
        }
    }

    fn shifted(&mut self, shift: f64, set: impl FnOnce(&mut Self)) {
        let before = (self.size, self.rise);
        self.rise += shift * self.size;
        self.size *= SCRIPT;
        set(self);
        (self.size, self.rise) = before;
    }

    fn script(&mut self, math: &Math, shift: f64) {
        self.shifted(shift, |line| line.set(math));
    }

    fn set(&mut self, math: &Math) {
        if self.depth >= DEEPEST {
            return self.put("\u{2026}", Face::Upright);
        }
        self.depth += 1;
        self.set_parts(math);
        self.depth -= 1;
    }

    fn set_parts(&mut self, math: &Math) {
        match math {
            Math::Row(parts) => self.row(parts),
            Math::Number(digits) => self.put_with(digits, '-', "\u{2212}"),
            Math::Identifier(name) => self.put(name, Face::Italic),
            Math::Text(words) => self.put_with(words, ' ', SPACE),
            Math::Function(name) => self.put(name, Face::Upright),
            Math::Vector(name) => self.put(name, Face::Bold),
            Math::Operator(operator) => self.operator(*operator, false),
            Math::Fraction(above, below) => {
                self.grouped(above);
                self.put("/", Face::Upright);
                self.grouped(below);
            }
            Math::Sub(base, below) => {
                self.set(base);
                self.subscript(below);
            }
            Math::Sup(base, above) => {
                self.set(base);
                self.script(above, RISE);
            }
            Math::SubSup(base, below, above) => {
                self.set(base);
                self.subscript(below);
                self.script(above, RISE);
            }
            Math::Root(inner) => {
                self.put("\u{221a}", Face::Upright);
                self.grouped(inner);
            }
            Math::Bracketed(inner) => self.enclosed("(", inner, ")"),
            Math::Squared(inner) => self.enclosed("[", inner, "]"),
            Math::Bars(inner) => self.enclosed("|", inner, "|"),
            Math::Cases(cases) => {
                for (index, (condition, value)) in cases.iter().enumerate() {
                    self.put(if index > 0 { ";\u{a0}" } else { "" }, Face::Upright);
                    self.set(value);
                    self.put(SPACE, Face::Upright);
                    self.set(condition);
                }
            }
            Math::Integral(lower, upper, integrand, variable) => {
                self.put("\u{222b}", Face::Upright);
                self.script(lower, -DROP);
                self.script(upper, RISE);
                self.put(THIN, Face::Upright);
                self.set(integrand);
                self.put("\u{2009}d", Face::Upright);
                self.set(variable);
            }
        }
    }

    fn row(&mut self, parts: &[Math]) {
        let mut before: Option<&Math> = None;
        for part in parts {
            if Math::needs_space(before, part) {
                self.put(SPACE, Face::Upright);
            }
            match part {
                Math::Operator(operator) => self.operator(*operator, Math::is_prefix(before)),
                _ => self.set(part),
            }
            before = Some(part);
        }
    }

    /// Single letters slanted, words and digits upright, as the writer for LaTeX sets them.
    fn subscript(&mut self, math: &Math) {
        let Math::Text(text) = math else { return self.script(math, -DROP) };
        self.shifted(-DROP, |line| {
            for part in subscript_parts(text) {
                let is_letter = part.chars().count() == 1 && part.starts_with(char::is_alphabetic);
                if is_letter { line.put(part, Face::Italic) } else { line.put_with(part, ' ', SPACE) }
            }
        });
    }

    fn enclosed(&mut self, open: &str, inner: &Math, close: &str) {
        self.put(open, Face::Upright);
        self.set(inner);
        self.put(close, Face::Upright);
    }

    /// In brackets where a stroke or a root would otherwise take only the first part.
    fn grouped(&mut self, inner: &Math) {
        match inner {
            Math::Row(parts) if parts.len() > 1 => self.enclosed("(", inner, ")"),
            _ => self.set(inner),
        }
    }

    fn operator(&mut self, operator: Operator, leading: bool) {
        let sign = match operator {
            Operator::Juxtapose => return self.put(THIN, Face::Upright),
            Operator::Comma => return self.put(",\u{a0}", Face::Upright),
            Operator::Plus => "+",
            Operator::Minus => "\u{2212}",
            Operator::Times => "\u{d7}",
            Operator::Equals => "=",
            Operator::Approximately => "\u{2248}",
            Operator::Less => "<",
            Operator::AtMost => "\u{2264}",
            Operator::Greater => ">",
            Operator::AtLeast => "\u{2265}",
            Operator::Differs => "\u{2260}",
            Operator::Implies => "\u{21d2}",
            Operator::PlusMinus => "\u{b1}",
        };
        let space = if leading { "" } else { SPACE };
        for piece in [space, sign, space] {
            self.put(piece, Face::Upright);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_subscript_is_smaller_and_lower_and_the_line_returns() {
        let math = Math::relation(Math::subscripted("v", "A1"), Operator::Equals, Math::Number("-2".into()));
        let runs = runs(&math);
        let texts: Vec<_> = runs.iter().map(|run| run.text.as_str()).collect();
        assert_eq!(texts, ["v", "A", "1", "\u{a0}=\u{a0}\u{2212}2"]);
        assert!(runs[1].look.rise < 0.0 && runs[1].look.size < 1.0);
        assert_eq!((runs[3].look.rise, runs[3].look.size), (0.0, 1.0));
    }

    #[test]
    fn a_leading_minus_is_a_sign_and_not_a_difference() {
        let math = Math::Row(vec![Math::Operator(Operator::Minus), Math::Identifier("J".into())]);
        assert_eq!(runs(&math)[0].text, "\u{2212}");
    }

    #[test]
    fn very_deep_terms_are_cut_off() {
        let deep = (0..500).fold(Math::Identifier("x".into()), |inner, _| Math::Root(inner.into()));
        assert!(runs(&deep).iter().any(|run| run.text.contains('\u{2026}')));
    }
}
