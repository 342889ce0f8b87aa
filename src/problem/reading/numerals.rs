//! Numbers in an author's prose: whether words without placeholders tell a value.

use core::f64::consts::FRAC_PI_2;

use momentous_quantity::Decimal;
use momentous_quantity::Unit;

/// Numbers that are written as words, each with its value.
const WORDS: &[(&str, f64)] = &[
    ("quarter", 0.25),
    ("half", 0.5),
    ("one", 1.0),
    ("first", 1.0),
    ("once", 1.0),
    ("two", 2.0),
    ("second", 2.0),
    ("twice", 2.0),
    ("three", 3.0),
    ("third", 3.0),
    ("four", 4.0),
    ("fourth", 4.0),
    ("five", 5.0),
    ("fifth", 5.0),
    ("six", 6.0),
    ("sixth", 6.0),
    ("seven", 7.0),
    ("seventh", 7.0),
    ("eight", 8.0),
    ("eighth", 8.0),
    ("nine", 9.0),
    ("ninth", 9.0),
    ("ten", 10.0),
    ("tenth", 10.0),
    ("eleven", 11.0),
    ("eleventh", 11.0),
    ("twelve", 12.0),
    ("twelfth", 12.0),
];

/// Relative distance at which a number in the text is the value.
const SAME: f64 = 1e-9;

/// Values that a story tells without a number: zero (at rest, at the origin) and right angles.
pub(crate) fn goes_without_saying(value: &Decimal, unit: &Unit) -> bool {
    let quarters = value.to_f64() * unit.factor().to_f64() / FRAC_PI_2;
    value.is_zero() || unit.has_pi() && (quarters - libm::round(quarters)).abs() < SAME
}

/// Whether a text tells a value by a number of its own, in the unit of the value or in another; signs are told by words.
pub(crate) fn tells(text: &str, value: &Decimal, unit: &Unit) -> bool {
    let size = value.to_f64().abs();
    let same = |one: f64, other: f64| (one - other).abs() <= SAME * other;
    let by_word = || {
        let words = text.split(|letter: char| !letter.is_alphabetic());
        words.filter_map(of_word).any(|number| same(number, size))
    };
    numbers(text).any(|(number, rest)| {
        let converted = || unit_at(rest).filter(|other| other.dimension() == unit.dimension());
        same(number, size)
            || converted().is_some_and(|other| same(number * other.factor().to_f64(), size * unit.factor().to_f64()))
    }) || by_word()
}

fn of_word(word: &str) -> Option<f64> {
    let word = word.to_lowercase();
    WORDS.iter().find(|(listed, _)| *listed == word).map(|(_, value)| *value)
}

/// Every number in digits, with what follows it.
fn numbers(text: &str) -> impl Iterator<Item = (f64, &str)> {
    let mut rest = text;
    core::iter::from_fn(move || {
        loop {
            let start = rest.find(|letter: char| letter.is_ascii_digit())?;
            // The digits of a name, as in `v_A1`, are no number.
            let in_name = rest[..start].ends_with(|letter: char| letter.is_alphanumeric() || letter == '_');
            let tail = &rest[start..];
            let length = digits(tail);
            rest = &tail[length..];
            let Ok(mut number) = tail[..length].parse::<f64>() else { continue };
            if let Some(below) =
                rest.strip_prefix('/').filter(|below| below.starts_with(|next: char| next.is_ascii_digit()))
            {
                let length = digits(below);
                rest = &below[length..];
                let Ok(below) = below[..length].parse::<f64>() else { continue };
                number /= below;
            }
            if !in_name {
                return Some((number, rest));
            }
        }
    })
}

/// How many bytes of a text that begins with a digit are its number: `2.5`, `3e8`.
fn digits(text: &str) -> usize {
    let run = |from: usize| {
        let length = text[from..].find(|letter: char| !letter.is_ascii_digit());
        length.map_or(text.len(), |length| from + length)
    };
    let mut end = run(0);
    if text[end..].starts_with('.') && run(end + 1) > end + 1 {
        end = run(end + 1);
    }
    let exponent = text[end..].strip_prefix(['e', 'E']).map(|rest| rest.strip_prefix('-').unwrap_or(rest).len());
    match exponent.map(|left| text.len() - left) {
        Some(from) if run(from) > from => run(from),
        _ => end,
    }
}

/// The unit that a text begins with, after blanks; the longest that can be read.
fn unit_at(text: &str) -> Option<Unit> {
    let text = text.trim_start_matches([' ', '\n', '~', '\u{a0}', '\u{202f}']);
    let words = text.split([',', ';', '.', ')', '$']).next()?;
    let ends = words.char_indices().filter(|(_, letter)| letter.is_whitespace()).map(|(at, _)| at);
    let ends: Vec<usize> = ends.chain([words.len()]).take(MOST_WORDS).collect();
    ends.into_iter().rev().filter(|end| *end > 0).find_map(|end| Unit::parse(&words[..end]).ok())
}

/// The most words of a unit: `kg m^2 / s^2` has four.
const MOST_WORDS: usize = 4;

/// Whether two texts read the same, however many figures their numbers have.
pub(crate) fn alike(one: &str, other: &str) -> bool {
    let plain = |text: &str| {
        let word = |word: &str| match Decimal::parse(&word.replace('−', "-")) {
            Ok(number) => number.to_f64().to_string(),
            Err(_) => word.to_lowercase(),
        };
        text.trim_end_matches('.').split_whitespace().map(word).collect::<Vec<_>>()
    };
    plain(one) == plain(other)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    fn value(text: &str) -> (Decimal, Unit) {
        let (number, unit) = text.split_once(' ').unwrap_or((text, ""));
        (Decimal::parse(number).unwrap(), Unit::parse(unit).unwrap())
    }

    #[test]
    fn a_value_is_told_by_digits_by_words_and_in_other_units() {
        let told = [
            ("for 3 s with", "3 s"),
            ("Then for $3$ seconds", "3 s"),
            ("for 500 ms.", "0.5 s"),
            ("at 36 km/h, it", "10 m/s"),
            ("30° above", "30 deg"),
            ("it loses 30 % of it", "0.3"),
            ("after its third impact", "3"),
            ("half a metre up", "0.5 m"),
            ("it is 1/2 here", "0.5"),
            ("at 5 m/s to the left", "-5 m/s"),
            ("GM = 3.986e14 m^3/s^2", "3.986e14 m^3/s^2"),
            ("it rises to 2.50 m. Then", "2.5 m"),
        ];
        for (text, text_of_value) in told {
            let (number, unit) = value(text_of_value);
            assert!(tells(text, &number, &unit), "{text}: {text_of_value}");
        }
        let not_told =
            [("ball A2 falls", "2 m"), ("for 30 s", "3 s"), ("at 1.62 m/s", "1.6 m/s"), ("falls", "9.81 m/s^2")];
        for (text, text_of_value) in not_told {
            let (number, unit) = value(text_of_value);
            assert!(!tells(text, &number, &unit), "{text}: {text_of_value}");
        }
    }

    #[test]
    fn rest_and_right_angles_need_no_number() {
        for (text, expected) in [("0 m/s", true), ("90 deg", true), ("-180 deg", true), ("45 deg", false), ("1", false)]
        {
            let (number, unit) = value(text);
            assert_eq!(goes_without_saying(&number, &unit), expected, "{text}");
        }
    }
}
