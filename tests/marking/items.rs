//! The windows of items and the judge are one: what an export would mark, marking marks alike.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use momentous::bank::Bank;
use momentous::exercise::{Exercise, ItemAnswers, NumberItem, Window};
use momentous::grade::{DecimalMark, Expected, ExpectedKind, Verdict, Writing, judge, read};
use momentous::problem::{AskedUnit, Part, PartKind, compile, load};

/// The seeds of each form.
const SEEDS: [u64; 2] = [1, 8];

/// The parts of an exercise that are numbers.
type Numbers = Vec<(Part, NumberItem)>;

/// Every exercise of the bank with its numbers.
static EXERCISES: LazyLock<Vec<(Exercise, Numbers)>> = LazyLock::new(|| {
    exercises()
        .map(|exercise| {
            let numbers = numbers(&exercise);
            (exercise, numbers)
        })
        .collect()
});

/// Every exercise of the bank with these seeds.
fn exercises() -> impl Iterator<Item = Exercise> {
    let bank = Bank::built_in();
    let sources: Vec<_> = bank.sources().cloned().collect();
    sources.into_iter().flat_map(|source| {
        let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
        let forms = 0..problem.forms().len();
        let all: Vec<Exercise> =
            forms.flat_map(|form| SEEDS.map(|seed| Exercise::draw(&problem, form, seed).unwrap())).collect();
        all
    })
}

/// A part with its number, where it is one with a unit that can be typed and one root.
fn numbers(exercise: &Exercise) -> Numbers {
    let item = exercise.item();
    let parts = exercise.worked().form.parts.iter().cloned().zip(item.parts);
    let plain = |part: &Part| match &part.kind {
        PartKind::Number(number) => {
            matches!(number.unit, AskedUnit::Unit(_)) && exercise.worked().answers(number).len() == 1
        }
        _ => false,
    };
    parts
        .filter(|(part, _)| plain(part))
        .filter_map(|(part, own)| match own.answers {
            ItemAnswers::Number(number) => Some((part, *number)),
            _ => None,
        })
        .collect()
}

/// A number as it is typed, with more figures than rounding leaves, and its unit.
fn typed(value: f64, item: &NumberItem) -> String {
    if item.whole { format!("{}", value.round()) } else { format!("{value:.11e} {}", item.unit) }
}

/// What the judge makes of a number, however it is written.
fn verdict(exercise: &Exercise, part: &Part, text: &str) -> Verdict {
    let mut expected: Expected = exercise.expected(part);
    if let ExpectedKind::Number(number) = &mut expected.kind {
        number.writing = Writing::Ignore;
    }
    judge(&expected, &read(text, &expected.kind, DecimalMark::Point).unwrap()).verdict
}

/// Numbers within a window: its middle, and as near to its ends as rounding lets one tell.
fn within(window: &Window, whole: bool) -> Vec<f64> {
    let margin = 1e-8 * (window.low.abs() + window.high.abs());
    if whole {
        return vec![window.low + (window.high - window.low) / 2.0];
    }
    vec![window.low + margin, window.low + (window.high - window.low) / 2.0, window.high - margin]
}

#[test]
fn windows_are_disjoint_and_the_right_answer_lies_in_one_that_is_right() {
    for (exercise, numbers) in EXERCISES.iter() {
        for (part, item) in numbers {
            assert!(item.windows.windows(2).all(|pair| pair[0].high <= pair[1].low), "{}", part.id);
            let right = item.windows.iter().find(|own| (own.low..=own.high).contains(&item.right));
            // A whole number has no width.
            let is_right = right.is_some_and(|own| own.verdict.is_right() && own.points.0 == part.points.into());
            assert!(is_right, "{} {}", exercise.problem().id(), part.id);
        }
    }
}

#[test]
fn the_judge_agrees_with_every_window() {
    let mut compared = 0;
    for (exercise, numbers) in EXERCISES.iter() {
        for (part, item) in numbers {
            for window in &item.windows {
                for value in within(window, item.whole) {
                    let found = verdict(exercise, part, &typed(value, item));
                    // Without its sign a number says nothing of the direction; typed with one, it says the wrong one.
                    let same =
                        found == window.verdict || found == Verdict::SenseReversed && window.verdict == Verdict::Sense;
                    assert!(same, "{} {}: {value} is {found:?}, {window:?}", exercise.problem().id(), part.id);
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 3000, "{compared}");
}

#[test]
fn the_judge_finds_nothing_between_windows() {
    for (exercise, numbers) in EXERCISES.iter() {
        for (part, item) in numbers {
            for pair in item.windows.windows(2) {
                let gap = pair[1].low - pair[0].high;
                if gap <= 1e-6 * (pair[0].high.abs() + pair[1].low.abs()) || item.whole {
                    continue;
                }
                let value = pair[0].high + gap / 2.0;
                let found = verdict(exercise, part, &typed(value, item));
                assert_eq!(found, Verdict::Wrong, "{} {}: {value}", exercise.problem().id(), part.id);
            }
        }
    }
}

#[test]
fn marking_finds_the_mistakes_of_every_window() {
    let mut compared = 0;
    for (exercise, numbers) in EXERCISES.iter() {
        for (part, item) in numbers {
            for window in item.windows.iter().filter(|own| !own.mistakes.is_empty()) {
                // Not the middle, which may be the right answer cut to two figures: that is taken for rounding.
                let value = window.low + (window.high - window.low) * if item.whole { 0.5 } else { 0.4 };
                let answers = BTreeMap::from([(part.id.clone(), typed(value, item))]);
                let report = exercise.grade(&answers, DecimalMark::Point);
                let own = report.parts.iter().find(|own| own.id == part.id).unwrap();
                let Some(diagnosis) = &own.diagnosis else {
                    panic!("{} {}: {window:?} is not diagnosed", exercise.problem().id(), part.id)
                };
                assert_eq!(diagnosis.codes, window.mistakes, "{} {}", exercise.problem().id(), part.id);
                assert_eq!(diagnosis.hints, window.feedback);
                compared += 1;
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}
