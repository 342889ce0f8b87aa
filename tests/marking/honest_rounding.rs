//! A student who does everything right and rounds every value on the way never loses a mark.

use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::{Drawer, Exercise, ItemAnswers, Marker, NumberItem};
use momentous::grade::{DecimalMark, Report, Sitting, Verdict};
use momentous::problem::{Problem, compile, load};

/// What an honest student is told who rounds on the way, where that is not simply right. Where the author fixed numbers
/// whose rounding shifts an answer by more than a few tolerances nothing is promised, and `momentous check` says so.
fn wronged(marker: &mut Marker, exercise: &Exercise) -> Option<Report> {
    let answers = exercise.rounded_answers();
    let answers: Vec<(&str, &str)> = answers.iter().map(|(part, text)| (part.as_str(), text.as_str())).collect();
    let report = marker.mark(exercise.worked(), &answers, Sitting::default());
    let worked = exercise.worked();
    let is_ill_chosen = |id: &str| {
        let part = worked.form.parts.iter().find(|part| part.id == id);
        part.is_some_and(|part| worked.is_ill_chosen(part))
    };
    let is_wronged = report.parts.iter().any(|part| {
        (part.diagnosis.is_some() || part.follows.is_some() || !part.verdict.is_right()) && !is_ill_chosen(&part.id)
    });
    is_wronged.then_some(report)
}

fn all_wronged(problem: &Arc<Problem>, seeds: u64) -> Vec<String> {
    let mut found = Vec::new();
    for form in 0..problem.forms().len() {
        let mut marker = Marker::new(problem, form, DecimalMark::Point).expect("the form is there");
        let mut drawer = Drawer::new(problem, form).expect("the form is there");
        for seed in 1..=seeds {
            let Ok(exercise) = drawer.draw(seed) else { continue };
            let report = wronged(&mut marker, &exercise);
            found.extend(report.map(|report| format!("{} form {form} seed {seed}\n{report}", problem.id())));
        }
    }
    found
}

#[test]
fn no_answer_of_the_bank_is_blurred_by_honest_rounding() {
    let mut ill_chosen = Vec::new();
    for source in Bank::built_in().sources() {
        let problem = Arc::new(compile(load(source.clone()).expect("it loads"), None).expect("it compiles"));
        for form in 0..problem.forms().len() {
            let mut drawer = Drawer::new(&problem, form).expect("the form is there");
            for (seed, exercise) in (1..=10).filter_map(|seed| Some((seed, drawer.draw(seed).ok()?))) {
                let worked = exercise.worked();
                let blurred = worked.form.parts.iter().filter(|part| worked.is_ill_chosen(part));
                ill_chosen.extend(blurred.map(|part| format!("{} form {form} seed {seed}: {}", problem.id(), part.id)));
            }
        }
    }
    assert!(ill_chosen.is_empty(), "{}", ill_chosen.join("\n"));
}

/// The numbers that are asked in a variant, each with the name of its answer.
fn numbers(exercise: &Exercise) -> Vec<(String, NumberItem)> {
    let mut numbers = Vec::new();
    for part in exercise.item().parts {
        let own = match part.answers {
            ItemAnswers::Number(number) => vec![*number],
            ItemAnswers::Roots(numbers) => numbers,
            _ => Vec::new(),
        };
        numbers.extend(own.into_iter().map(|number| (part.printed.clone(), number)));
    }
    numbers
}

/// How far the numbers reach that get a verdict, from the right one.
fn reach(number: &NumberItem, verdict: Verdict) -> f64 {
    let own = number.windows.iter().filter(|window| window.verdict == verdict);
    own.map(|window| (window.high - number.right).abs().max((window.low - number.right).abs())).fold(0.0, f64::max)
}

/// With more `SEEDS`, the widest windows of the bank are measured.
#[test]
fn rounding_is_never_allowed_for_beyond_three_tolerances() {
    let seeds = std::env::var("SEEDS").map_or(2, |text| text.parse().expect("a number"));
    let mut widest = Vec::new();
    for source in Bank::built_in().sources() {
        let problem = Arc::new(compile(load(source.clone()).expect("it loads"), None).expect("it compiles"));
        for form in 0..problem.forms().len() {
            let mut drawer = Drawer::new(&problem, form).expect("the form is there");
            for (seed, exercise) in (1..=seeds).filter_map(|seed| Some((seed, drawer.draw(seed).ok()?))) {
                for (part, number) in numbers(&exercise) {
                    let times = reach(&number, Verdict::RightRounded) / reach(&number, Verdict::Right);
                    widest
                        .push((times, format!("{} form {form} seed {seed}: {part} = {}", problem.id(), number.right)));
                }
            }
        }
    }
    widest.retain(|(times, _)| !times.is_nan());
    widest.sort_by(|one, other| other.0.total_cmp(&one.0));
    let shown: Vec<String> = widest.iter().take(12).map(|(times, number)| format!("{times:.3} {number}")).collect();
    println!("{} numbers; windows in tolerances:\n{}", widest.len(), shown.join("\n"));
    assert!(widest.len() > 400 && widest[0].0 < 3.0 + 1e-9, "{}", shown.join("\n"));
}

#[test]
fn honest_rounding_never_costs_a_mark() {
    let mut found = Vec::new();
    for source in Bank::built_in().sources() {
        let problem = Arc::new(compile(load(source.clone()).expect("it loads"), None).expect("it compiles"));
        found.extend(all_wronged(&problem, 40));
    }
    assert!(found.is_empty(), "{} are wronged:\n{}", found.len(), found.join("\n"));
}

/// The allowance fell short here: an angle rounded once more in degrees, a value beside a power of ten, a slope that changes.
#[test]
fn honest_rounding_costs_no_mark_where_small_differences_remain() {
    for id in ["impact/hockey-pucks", "impulse/lift-cable", "impulse/softball-hit", "streams/moon-lander"] {
        let source = Bank::built_in().find(id).expect("it is in the bank").clone();
        let problem = Arc::new(compile(load(source).expect("it loads"), None).expect("it compiles"));
        let found = all_wronged(&problem, 1000);
        assert!(found.is_empty(), "{} are wronged:\n{}", found.len(), found.join("\n"));
    }
}
