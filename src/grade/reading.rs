//! Answers as they were read, and the memory of those that were read before.

use std::collections::HashMap;

use super::expected::ExpectedKind;
use super::read::{Answer, DecimalMark, Endings, Unreadable, read};

/// The number of readings of one part in a generation.
const MOST: usize = 1024;

/// An answer as it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The answer as it was understood, or why it was not.
    pub answer: Result<Answer, Unreadable>,
    /// The reading in words; why there is none, where it cannot be read.
    pub told: String,
}

/// What was read as answers to one part. Reading knows nothing of the right value, so the same text is always read in the
/// same way, and need not be read again; of a number with something behind it, only the number.
#[derive(Clone, Debug, Default)]
pub struct Readings {
    /// The endings of answers to a number.
    endings: Endings,
    /// The readings met lately, and those met before that; one that is not met again while a generation fills is forgotten.
    young: HashMap<String, Reading>,
    old: HashMap<String, Reading>,
}

impl Reading {
    /// Reads an answer; nothing where there is none.
    #[must_use]
    pub fn of(text: &str, asked: &ExpectedKind, mark: DecimalMark) -> Option<Self> {
        if text.trim().is_empty() {
            return None;
        }
        let answer = read(text, asked, mark);
        let told = answer.as_ref().map_or_else(ToString::to_string, Answer::echo);
        Some(Self { answer, told })
    }
}

impl Readings {
    /// The same, from memory where it was read before. Every text must be one for the same part and the same mark.
    pub fn read(&mut self, text: &str, asked: &ExpectedKind, mark: DecimalMark) -> Option<Reading> {
        if let Some((answer, told)) = self.endings.read(text, mark) {
            return Some(Reading { answer, told });
        }
        if let Some(reading) = self.find(text) {
            return Some(reading);
        }
        let reading = Reading::of(text, asked, mark)?;
        // In words a direction and its number are one.
        if matches!(asked, ExpectedKind::Number(expected) if expected.reference.is_none() || reading.answer.is_ok()) {
            self.endings.learn(text, mark, &reading.answer);
        }
        self.put(text.to_owned(), reading.clone());
        Some(reading)
    }

    fn find(&mut self, text: &str) -> Option<Reading> {
        if let Some(known) = self.young.get(text) {
            return Some(known.clone());
        }
        let (text, reading) = self.old.remove_entry(text)?;
        self.put(text, reading.clone());
        Some(reading)
    }

    fn put(&mut self, text: String, reading: Reading) {
        if self.young.len() >= MOST {
            self.old = std::mem::take(&mut self.young);
        }
        self.young.insert(text, reading);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ExpectedNumber;
    use momentous_quantity::Unit;

    fn same(readings: &mut Readings, text: &str, asked: &ExpectedKind, mark: DecimalMark) {
        let known = readings.read(text, asked, mark);
        assert_eq!(known, Reading::of(text, asked, mark), "{text}");
    }

    #[test]
    fn what_is_remembered_is_what_would_be_read() {
        let asked = ExpectedKind::Number(ExpectedNumber::new(1.0, Unit::parse("m/s").unwrap()));
        let mut readings = Readings::default();
        for _ in 0..2 {
            for number in 0..MOST + 10 {
                same(&mut readings, &format!("{number} + 1 m/s"), &asked, DecimalMark::Point);
            }
        }
        assert!(readings.read(" ", &asked, DecimalMark::Point).is_none());
        assert!(readings.young.len() <= MOST && readings.old.len() <= MOST);
    }

    #[test]
    fn an_ending_says_the_same_behind_every_number() {
        const NUMBERS: [&str; 12] =
            ["2.5", "-3", "+3", "1", "0", "007", "1.234", "1200", "0.0100", "0.40", "1234567.8", "v = 2"];
        const ENDINGS: [&str; 40] = [
            "",
            " m/s",
            "m/s",
            " m / s",
            " m/s to the left",
            " to the right",
            " m/s.",
            " km/h",
            " ft/s",
            " apples",
            " N",
            " lb",
            " 000 m/s",
            " 567",
            " 1/2 m/s",
            "/2 m/s",
            "/s",
            " per second",
            " x 10^3 m/s",
            "× 10^0 m/s",
            "*1 m/s",
            "e3 m/s",
            "e0",
            " e",
            "^2 m/s",
            "² m/s",
            ".",
            ". m/s",
            ",5 m/s",
            ",000",
            "_000",
            "%",
            "°",
            " (m/s)",
            " [m/s]",
            " ± 1 m/s",
            " m/s left right",
            " (to the left)",
            " π m/s",
            " + 1 m/s",
        ];
        let unit = Unit::parse("m/s").unwrap();
        let senses = Some(["to the right".to_owned(), "to the left".to_owned()]);
        let plain = ExpectedNumber::new(1.0, unit);
        let directed = ExpectedNumber { senses, ..plain.clone() };
        for (asked, mark) in [(plain, DecimalMark::Comma), (directed, DecimalMark::Point)] {
            let (mut readings, asked) = (Readings::default(), ExpectedKind::Number(asked));
            for number in NUMBERS {
                for ending in ENDINGS {
                    same(&mut readings, &format!("{number}{ending}"), &asked, mark);
                }
            }
        }
    }
}
