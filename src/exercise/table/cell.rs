//! Cells that a spreadsheet would run as a formula, written so that it shows them.

use std::borrow::Cow;

/// The beginnings of a formula, in one spreadsheet or another.
const STARTS: [char; 11] = ['=', '+', '-', '@', '\t', '\r', '\n', '＝', '＋', '－', '＠'];

/// The sign that spreadsheets put before a text that would else be a formula.
const MARK: char = '\'';

/// The signs between cells in one spreadsheet or another: those of a table with commas take a semicolon or a tab for the end of a
/// cell where their users' decimals have commas.
const BETWEEN: [char; 2] = [';', '\t'];

/// A cell as it is safe to open in a spreadsheet: what would be a formula there gets an apostrophe before it. [`super::Table`] takes
/// it away again, so that every text reads back as it was. A lone number keeps its sign.
///
/// ```
/// use momentous_exercise::defused;
/// assert_eq!(["=1+1", "-0.5", "-0.5 m/s", "s17"].map(defused), ["'=1+1", "-0.5", "'-0.5 m/s", "s17"]);
/// assert_eq!(["x;=1+1;y", "3;-5"].map(defused), ["x;'=1+1;y", "3;-5"]);
/// ```
#[must_use]
pub fn defused(cell: &str) -> Cow<'_, str> {
    let runs = |(place, piece): (usize, &str)| {
        let formula = if place == 0 { cell } else { piece.trim_end_matches(BETWEEN) };
        is_formula(piece.trim_start_matches(MARK)) && !is_number(formula)
    };
    if !pieces(cell).enumerate().any(runs) {
        return Cow::Borrowed(cell);
    }
    let mut safe = String::with_capacity(cell.len() + 1);
    for (place, piece) in pieces(cell).enumerate() {
        if runs((place, piece)) {
            safe.push(MARK);
        }
        safe.push_str(piece);
    }
    Cow::Owned(safe)
}

/// The text that is meant by a cell.
pub(super) fn meant(cell: &str) -> Cow<'_, str> {
    let plain = |piece: &'_ str| match piece.strip_prefix(MARK) {
        Some(rest) if is_formula(rest.trim_start_matches(MARK)) => rest.to_owned(),
        _ => piece.to_owned(),
    };
    if cell.contains(MARK) { Cow::Owned(pieces(cell).map(plain).collect()) } else { Cow::Borrowed(cell) }
}

/// The pieces that a spreadsheet may take for cells, each with what parts it from the next. One that begins with such a sign is a
/// piece of its own.
fn pieces(cell: &str) -> impl Iterator<Item = &str> {
    cell.split_inclusive(BETWEEN)
}

fn is_formula(text: &str) -> bool {
    text.starts_with(STARTS)
}

/// Whether a text is one decimal number, with a point or a comma.
fn is_number(text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let unsigned = |text: &'_ str| text.strip_prefix(['+', '-']).unwrap_or(text).to_owned();
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(unsigned(exponent))),
        None => (text, None),
    };
    let mantissa = unsigned(mantissa);
    let (whole, decimals) = mantissa.split_once(['.', ',']).unwrap_or((&mantissa, ""));
    (digits(whole) && (decimals.is_empty() || digits(decimals)) || whole.is_empty() && digits(decimals))
        && exponent.is_none_or(|exponent| digits(&exponent))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn only_one_number_keeps_its_sign() {
        for number in ["-5", "+3.1", "-.5", "-0,5", "-1.5e3", "+1E-7", "-3."] {
            assert_eq!(defused(number), number);
        }
        for formula in
            ["-", "-5 m/s", "-5-5", "--5", "-5e", "+1e+2+3", "@SUM(A1)", "＝1", "'=1", "-2+cmd|' /C calc'!A0", "-5;x"]
        {
            assert_eq!(defused(formula), format!("'{formula}"));
        }
        assert_eq!(defused("'quoted'"), "'quoted'");
        for (cell, written) in [
            ("x;=1+1;y", "x;'=1+1;y"),
            ("x\t@SUM(A1)", "x\t'@SUM(A1)"),
            ("3;-5;7", "3;-5;7"),
            ("3;-5 m/s", "3;'-5 m/s"),
            ("\t=1", "'\t'=1"),
        ] {
            assert_eq!(defused(cell), written);
        }
    }

    proptest! {
        #[test]
        fn every_text_reads_back_as_it_was(text in "['=+@ae0-9.;\t-]{0,10}", other in any::<String>()) {
            for text in [text, other] {
                let written = defused(&text);
                prop_assert_eq!(meant(&written), text.as_str());
                prop_assert!(!is_formula(&written) || is_number(&written), "{}", written);
                for piece in written.split(BETWEEN) {
                    prop_assert!(!is_formula(piece) || is_number(piece), "{}", written);
                }
            }
        }
    }
}
