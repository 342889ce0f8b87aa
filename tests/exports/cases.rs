//! Cases for other programs: what to answer, and what it has to give. They are written where `EXPORT_CASES` names a folder.

use std::fs;
use std::path::Path;

use momentous::exercise::{NumberItem, Window};
use momentous::export::Question;

use super::bank::{exported, forms};
use super::{moodle_cases, qti_cases};

/// Writes the whole bank for a target: with cases for Moodle and players of QTI, else a file for each form.
pub fn write(target: &str, folder: &Path) {
    match target {
        "moodle" => moodle_cases::write(folder),
        "qti3" | "qti21" => qti_cases::write(target, folder),
        _ => {
            for items in forms().iter().filter(|items| !items.is_empty()) {
                fs::write(folder.join(Question::new(&items[0]).name()), exported(target, items)).unwrap();
            }
        }
    }
}

/// An answer to a number, the share of the points that it earns, and what is said of it.
#[derive(Clone, Copy)]
pub struct Answer<'i> {
    pub value: f64,
    pub share: f64,
    pub said: &'i [String],
}

/// An answer to each number of a question, where there is one of the kind.
pub struct Try<'i> {
    pub name: &'static str,
    pub answers: Vec<Option<Answer<'i>>>,
}

/// Each end of the right windows, what lies outside of every window, and so many mistakes, each in all numbers at once.
pub fn tries<'i>(numbers: &[(u32, &'i NumberItem)], mistakes: usize) -> Vec<Try<'i>> {
    let mut all = Vec::new();
    let mut add = |name, answer: &dyn Fn(u32, &'i NumberItem) -> Option<Answer<'i>>| {
        let answers: Vec<_> = numbers.iter().map(|(points, number)| answer(*points, number)).collect();
        if answers.iter().any(Option::is_some) {
            all.push(Try { name, answers });
        }
    };
    let answer =
        |value, window: &'i Window, points| Answer { value, share: share(window, points), said: &window.feedback };
    for (name, end) in [("low", (|window| window.low) as fn(&Window) -> f64), ("high", |window| window.high)] {
        add(name, &|points, number| {
            let full = number.windows.iter().find(|window| share(window, points) >= 1.0)?;
            Some(answer(end(full), full, points))
        });
    }
    add("outside", &|_, number| {
        let value = number.windows.iter().fold(1e9, |outside, window| outside + window.high.abs());
        Some(Answer { value, share: 0.0, said: &[] })
    });
    for place in 0..mistakes {
        add("mistake", &|points, number| {
            let window = number.windows.iter().filter(|window| !window.mistakes.is_empty()).nth(place)?;
            Some(answer(window.low + (window.high - window.low) / 2.0, window, points))
        });
    }
    all
}

fn share(window: &Window, points: u32) -> f64 {
    window.points.0.to_f64().value() / f64::from(points)
}
