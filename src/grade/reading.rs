//! Answers as they were read, and the memory of those that were read before.

use std::collections::HashMap;
use std::sync::Arc;
use std::sync::Mutex;

use super::expected::ExpectedKind;
use super::read::{Answer, DecimalMark, Unreadable, read};

/// So many readings of one part make a generation.
const MOST: usize = 1024;

/// An answer as it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// What was understood, or why nothing was.
    pub answer: Result<Answer, Unreadable>,
    /// What was understood, in words; why nothing was, where it cannot be read.
    pub told: String,
}

/// What was read as answers to one part. Reading knows nothing of the right value, so the same text is always read in the
/// same way, and need not be read again.
#[derive(Debug, Default)]
pub struct Readings(Mutex<Generations>);

/// What was met lately, and what was met before that; what is not met again while one generation fills is forgotten.
#[derive(Debug, Default)]
struct Generations {
    young: HashMap<String, Arc<Reading>>,
    old: HashMap<String, Arc<Reading>>,
}

impl Generations {
    fn find(&mut self, text: &str) -> Option<Arc<Reading>> {
        if let Some(known) = self.young.get(text) {
            return Some(Arc::clone(known));
        }
        let (text, reading) = self.old.remove_entry(text)?;
        self.put(text, Arc::clone(&reading));
        Some(reading)
    }

    fn put(&mut self, text: String, reading: Arc<Reading>) {
        if self.young.len() >= MOST {
            self.old = std::mem::take(&mut self.young);
        }
        self.young.insert(text, reading);
    }
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
    /// The same, from memory where the text was read before. Every text must be one for the same part and the same mark.
    pub fn read(&self, text: &str, asked: &ExpectedKind, mark: DecimalMark) -> Option<Arc<Reading>> {
        // Where another thread is at it, reading again is quicker than waiting.
        if let Ok(mut known) = self.0.try_lock()
            && let Some(reading) = known.find(text)
        {
            return Some(reading);
        }
        let reading = Arc::new(Reading::of(text, asked, mark)?);
        if let Ok(mut known) = self.0.try_lock() {
            known.put(text.to_owned(), Arc::clone(&reading));
        }
        Some(reading)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::ExpectedNumber;
    use crate::quantity::Unit;

    #[test]
    fn what_is_remembered_is_what_would_be_read() {
        let asked = ExpectedKind::Number(ExpectedNumber::new(1.0, Unit::parse("m/s").unwrap()));
        let readings = Readings::default();
        for turn in 0..2 {
            for number in 0..MOST + 10 {
                let text = format!("{number} m/s");
                let known = readings.read(&text, &asked, DecimalMark::Point);
                assert_eq!(known.as_deref(), Reading::of(&text, &asked, DecimalMark::Point).as_ref(), "{turn}");
            }
        }
        assert!(readings.read(" ", &asked, DecimalMark::Point).is_none());
        let known = readings.0.lock().unwrap();
        assert!(known.young.len() <= MOST && known.old.len() <= MOST);
    }
}
