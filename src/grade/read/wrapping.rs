//! What people put around a whole answer: quotation marks, marks for bold letters, the letter of the part.

use super::super::expected::ExpectedKind;

/// Marks that stand before and behind.
const PAIRS: [(&str, &str); 8] =
    [("**", "**"), ("__", "__"), ("`", "`"), ("\"", "\""), ("'", "'"), ("“", "”"), ("‘", "’"), ("«", "»")];

/// The answer without them, and how many characters stand before it.
pub(super) fn unwrapped<'t>(text: &'t str, asked: &ExpectedKind) -> (usize, &'t str) {
    let mut bare = text.trim();
    if matches!(asked, ExpectedKind::Choice { .. }) {
        return (0, text);
    }
    if matches!(asked, ExpectedKind::Number(_) | ExpectedKind::Interval(_)) {
        bare = behind_letter(bare).unwrap_or(bare);
    }
    for (open, close) in PAIRS {
        let inner = bare.strip_prefix(open).and_then(|inner| inner.strip_suffix(close));
        // `5' 3'` is no text in quotation marks.
        if let Some(inner) = inner.filter(|inner| !inner.contains(open) && !inner.trim().is_empty()) {
            bare = inner.trim();
        }
    }
    let before = text.len() - text.trim_start().len();
    let at = text.find(bare).unwrap_or(before);
    if bare.len() == text.trim().len() { (0, text) } else { (text[..at].chars().count(), bare) }
}

/// The answer behind the letter of its part: `a) 1.73 m/s`, `(a) 1.73 m/s`.
fn behind_letter(text: &str) -> Option<&str> {
    let inner = text.strip_prefix('(').unwrap_or(text);
    let rest = inner.strip_prefix(|letter: char| letter.is_ascii_lowercase())?.strip_prefix(") ")?;
    Some(rest.trim_start()).filter(|rest| !rest.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expected::ExpectedNumber;
    use momentous_quantity::Unit;

    #[test]
    fn an_answer_is_taken_out_of_its_marks() {
        let number = ExpectedKind::Number(ExpectedNumber::new(1.0, Unit::degree()));
        for (text, bare) in [
            ("**1.73 m/s**", (2, "1.73 m/s")),
            (" `1.73 m/s`", (2, "1.73 m/s")),
            ("(a) 1.73 m/s", (4, "1.73 m/s")),
            ("'1.73'", (1, "1.73")),
            ("5' 3\"", (0, "5' 3\"")),
            ("1.73 m/s", (0, "1.73 m/s")),
        ] {
            assert_eq!(unwrapped(text, &number), bare, "{text}");
        }
    }
}
