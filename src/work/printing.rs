//! How numbers and brackets stand in a line that a student would type.

use std::fmt::Display;

/// Whole numbers of more digits are written with a power of ten.
const MOST_DIGITS: usize = 8;
/// So many zeros behind a point are no figures.
const MANY_ZEROS: usize = 6;

/// A number as it is typed: `1.327e20`, and a count without zeros behind a point.
pub(crate) fn plain_number(value: &impl Display) -> String {
    let text = value.to_string();
    if let Some((whole, fraction)) = text.split_once('.') {
        let is_count = fraction.len() >= MANY_ZEROS && fraction.chars().all(|digit| digit == '0');
        return if is_count { whole.to_owned() } else { text };
    }
    let digits = text.trim_start_matches('-');
    if digits.len() <= MOST_DIGITS || !digits.chars().all(|digit| digit.is_ascii_digit()) {
        return text;
    }
    let sign = &text[..text.len() - digits.len()];
    let figures = digits.trim_end_matches('0');
    let (first, rest) = figures.split_at(figures.len().min(1));
    let point = if rest.is_empty() { "" } else { "." };
    format!("{sign}{first}{point}{rest}e{}", digits.len() - 1)
}

/// A term with `((22 deg))` as `(22 deg)`.
pub(crate) fn with_single_brackets(term: &str) -> String {
    let (mut text, mut rest) = (String::with_capacity(term.len()), term);
    while let Some((before, behind)) = rest.split_once("((") {
        text.push_str(before);
        let inner = behind.find(['(', ')']).filter(|end| behind[*end..].starts_with("))"));
        match inner {
            Some(end) => {
                text.extend(["(", &behind[..=end]]);
                rest = &behind[end + 2..];
            }
            None => {
                text.push('(');
                rest = &rest[before.len() + 1..];
            }
        }
    }
    text + rest
}

#[cfg(test)]
mod tests {
    use super::{plain_number, with_single_brackets};

    #[test]
    fn numbers_are_as_they_are_typed() {
        let cases = [
            ("132700000000000000000", "1.327e20"),
            ("-20000000000", "-2e10"),
            ("94100", "94100"),
            ("4.00000000000", "4"),
            ("4.00", "4.00"),
        ];
        for (number, typed) in cases {
            assert_eq!(plain_number(&number), typed);
        }
    }

    #[test]
    fn brackets_are_single() {
        assert_eq!(with_single_brackets("3*tan((22 deg)) + ((2 kg) + (3 kg))"), "3*tan(22 deg) + ((2 kg) + (3 kg))");
    }
}
