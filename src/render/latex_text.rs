//! Text and mathematics that pdfLaTeX prints as they are, whatever signs they hold.

use std::borrow::Cow;
use std::fmt::Write;

use momentous_expr::Math;

use super::equation::Row;

/// Signs that LaTeX reads as commands, or that its fonts or ligatures would change.
const SPECIAL: [(char, &str); 14] = [
    ('\\', r"\textbackslash{}"),
    ('{', r"\{"),
    ('}', r"\}"),
    ('$', r"\$"),
    ('&', r"\&"),
    ('#', r"\#"),
    ('%', r"\%"),
    ('_', r"\_"),
    ('^', r"\textasciicircum{}"),
    ('~', r"\textasciitilde{}"),
    ('<', r"\textless{}"),
    ('>', r"\textgreater{}"),
    ('"', r"\textquotedbl{}"),
    ('`', r"\textasciigrave{}"),
];

/// Commands for signs in mathematics that the usual text fonts lack.
///
/// ```
/// assert_eq!(momentous_render::latex_sign('Δ'), Some(r"\Delta"));
/// assert_eq!(momentous_render::latex_sign('D'), None);
/// ```
#[must_use]
pub fn latex_sign(sign: char) -> Option<&'static str> {
    find(&SIGNS, sign)
}

/// Signs that the usual text fonts lack; mathematics has them.
const SIGNS: [(char, &str); 54] = [
    ('\u{2212}', "-"),
    ('\u{b1}', r"\pm"),
    ('\u{d7}', r"\times"),
    ('\u{f7}', r"\div"),
    ('\u{b7}', r"\cdot"),
    ('\u{22c5}', r"\cdot"),
    ('\u{b0}', r"^{\circ}"),
    ('\u{2032}', r"^{\prime}"),
    ('\u{221a}', r"\surd"),
    ('\u{221e}', r"\infty"),
    ('\u{2248}', r"\approx"),
    ('\u{2260}', r"\neq"),
    ('\u{2264}', r"\leq"),
    ('\u{2265}', r"\geq"),
    ('\u{2190}', r"\leftarrow"),
    ('\u{2191}', r"\uparrow"),
    ('\u{2192}', r"\rightarrow"),
    ('\u{2193}', r"\downarrow"),
    ('\u{2194}', r"\leftrightarrow"),
    ('\u{21d2}', r"\Rightarrow"),
    ('\u{2211}', r"\sum"),
    ('\u{222b}', r"\int"),
    ('\u{2202}', r"\partial"),
    ('\u{2220}', r"\angle"),
    ('\u{2225}', r"\parallel"),
    ('\u{22a5}', r"\perp"),
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
    ('\u{b5}', r"\mu"),
    ('\u{3bd}', r"\nu"),
    ('\u{3be}', r"\xi"),
    ('\u{3c0}', r"\pi"),
    ('\u{3c1}', r"\rho"),
    ('\u{3c3}', r"\sigma"),
    ('\u{3c4}', r"\tau"),
    ('\u{3c6}', r"\varphi"),
    ('\u{3c7}', r"\chi"),
    ('\u{3c8}', r"\psi"),
    ('\u{3c9}', r"\omega"),
    ('\u{393}', r"\Gamma"),
    ('\u{394}', r"\Delta"),
    ('\u{398}', r"\Theta"),
    ('\u{3a3}', r"\Sigma"),
    ('\u{3a6}', r"\Phi"),
    ('\u{3a9}', r"\Omega"),
];

/// Raised signs and what they raise.
const RAISED: [(char, char); 14] = [
    ('\u{2070}', '0'),
    ('\u{b9}', '1'),
    ('\u{b2}', '2'),
    ('\u{b3}', '3'),
    ('\u{2074}', '4'),
    ('\u{2075}', '5'),
    ('\u{2076}', '6'),
    ('\u{2077}', '7'),
    ('\u{2078}', '8'),
    ('\u{2079}', '9'),
    ('\u{207a}', '+'),
    ('\u{207b}', '-'),
    ('\u{207f}', 'n'),
    ('\u{2071}', 'i'),
];

/// Combining accents and the commands that set them on a letter.
const ACCENTS: [(char, char); 11] = [
    ('\u{300}', '`'),
    ('\u{301}', '\''),
    ('\u{302}', '^'),
    ('\u{303}', '~'),
    ('\u{304}', '='),
    ('\u{306}', 'u'),
    ('\u{307}', '.'),
    ('\u{308}', '"'),
    ('\u{30a}', 'r'),
    ('\u{30c}', 'v'),
    ('\u{327}', 'c'),
];

/// Spaces and joiners that only say how wide a gap is, and whether a line may break there.
const SPACES: [(char, &str); 8] = [
    ('\u{a0}', "~"),
    ('\u{202f}', r"\,"),
    ('\u{2009}', r"\,"),
    ('\u{2002}', r"\enspace{}"),
    ('\u{2003}', r"\quad{}"),
    ('\u{200b}', ""),
    ('\u{2060}', ""),
    ('\u{ad}', r"\-"),
];

fn find<T: Copy>(table: &[(char, T)], character: char) -> Option<T> {
    table.iter().find(|(key, _)| *key == character).map(|(_, value)| *value)
}

/// Text, every sign of it printed as it is.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 8);
    let mut rest = text.chars().peekable();
    while let Some(character) = rest.next() {
        let accent = rest.peek().and_then(|next| find(&ACCENTS, *next)).filter(|_| character.is_ascii_alphabetic());
        if let Some(accent) = accent {
            rest.next();
            let _ = write!(out, "\\{accent}{{{character}}}");
        } else if let Some(first) = find(&RAISED, character) {
            let mut raised = String::from(first);
            while let Some(next) = rest.peek().and_then(|next| find(&RAISED, *next)) {
                raised.push(next);
                rest.next();
            }
            let _ = write!(out, "\\ensuremath{{^{{{raised}}}}}");
        } else if character == '-' && rest.peek() == Some(&'-') {
            out.push_str("-{}"); // two hyphens would become a dash
        } else if let Some(command) = find(&SPECIAL, character) {
            out.push_str(command);
        } else {
            push_plain(&mut out, character);
        }
    }
    out
}

/// Mathematics in LaTeX, whose signs beyond ASCII are made into commands.
pub(super) fn math(tex: &str) -> Cow<'_, str> {
    if tex.is_ascii() {
        return Cow::Borrowed(tex);
    }
    let mut out = String::with_capacity(tex.len() + 16);
    let mut rest = tex;
    while let Some(start) = rest.find(|character: char| !character.is_ascii()) {
        let (ascii, signs) = rest.split_at(start);
        let end = signs.find(|character: char| character.is_ascii()).unwrap_or(signs.len());
        out.push_str(ascii);
        out.push_str(&math_signs(&signs[..end]));
        rest = &signs[end..];
    }
    out.push_str(rest);
    Cow::Owned(out)
}

/// Signs beyond ASCII within mathematics: those of mathematics as they are, letters as text.
fn math_signs(signs: &str) -> String {
    let is_sign = |character: char| {
        find(&SIGNS, character).is_some() || find(&RAISED, character).is_some() || find(&SPACES, character).is_some()
    };
    let escaped = escape(signs);
    if signs.chars().all(is_sign) { escaped } else { format!("\\text{{{escaped}}}") }
}

fn push_plain(out: &mut String, character: char) {
    if let Some(command) = find(&SIGNS, character) {
        let _ = write!(out, "\\ensuremath{{{command}}}");
    } else if let Some(space) = find(&SPACES, character) {
        out.push_str(space);
    } else if character.is_control() {
        out.push(' ');
    } else if character.is_ascii() || has_glyph(character) {
        out.push(character);
    } else {
        let _ = write!(out, "\\texttt{{U+{:04X}}}", u32::from(character));
    }
}

/// Whether LaTeX's usual text encodings (T1, TS1) have the sign: the letters of Latin-1 and Latin Extended-A, and marks.
fn has_glyph(character: char) -> bool {
    matches!(character,
        '\u{a1}'..='\u{125}' | '\u{128}'..='\u{137}' | '\u{139}'..='\u{13e}' | '\u{141}'..='\u{148}'
        | '\u{14a}'..='\u{165}' | '\u{168}'..='\u{17e}' | '\u{2013}' | '\u{2014}' | '\u{2018}'..='\u{201a}'
        | '\u{201c}'..='\u{201e}' | '\u{2020}'..='\u{2022}' | '\u{2026}' | '\u{2030}' | '\u{2039}' | '\u{203a}'
        | '\u{20ac}' | '\u{2122}')
}

/// The room that most equations take, in bytes.
const USUAL_LENGTH: usize = 256;

/// The inside of a displayed equation, for LaTeX and Markdown alike: one row as it is, several aligned.
pub(super) fn equation(rows: &[Row<'_>], number: Option<u32>) -> String {
    let mut out = String::with_capacity(USUAL_LENGTH);
    if let [row] = rows {
        Math::put_row_latex(row.whole(), &mut out);
    } else {
        out.push_str("\\begin{aligned}\n");
        for (index, row) in rows.iter().enumerate() {
            out.push_str(if index > 0 { " \\\\\n" } else { "" });
            Math::put_row_latex(row.left(), &mut out);
            out.push_str(" & ");
            Math::put_row_latex(row.right(), &mut out);
        }
        out.push_str("\n\\end{aligned}");
    }
    if let Some(number) = number {
        let _ = write!(out, " \\tag{{{number}}}");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_sign_of_latex_survives() {
        assert_eq!(
            escape(r"\input{x} $5 & 3% #1 a_b ^~"),
            r"\textbackslash{}input\{x\} \$5 \& 3\% \#1 a\_b \textasciicircum{}\textasciitilde{}"
        );
    }

    #[test]
    fn signs_beyond_ascii_are_printed() {
        assert_eq!(escape("30° − é"), "30\\ensuremath{^{\\circ}} \\ensuremath{-} é");
        assert_eq!(escape("m·s⁻¹"), "m\\ensuremath{\\cdot}s\\ensuremath{^{-1}}");
        assert_eq!(escape("e\u{301}"), "\\'{e}");
        assert_eq!(escape("\u{4e2d}"), "\\texttt{U+4E2D}");
    }

    #[test]
    fn mathematics_keeps_its_commands() {
        assert_eq!(math(r"v_{é} = 3\,\text{m}"), "v_{\\text{é}} = 3\\,\\text{m}");
        assert_eq!(math("θ⁻¹"), "\\ensuremath{\\theta}\\ensuremath{^{-1}}");
    }
}
