//! The lines of the program's own solutions.

use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::{Drawer, Exercise};
use momentous::explain;
use momentous::expr::{Expr, Symbol};
use momentous::grade::DecimalMark;
use momentous::problem::{compile, load};
use momentous::work::{Judge, Verdict};

use super::algebra::{equations, typed};
use super::consequences::LONGEST;

/// Every form of the bank at some seeds.
pub fn each(seeds: std::ops::RangeInclusive<u64>, visit: &mut dyn FnMut(&str, &Exercise)) {
    for source in Bank::built_in().sources() {
        let problem = Arc::new(compile(load(source.clone()).unwrap(), None).unwrap());
        for form in 0..problem.forms().len() {
            let name = problem.forms()[form].question.name.clone().unwrap_or_default();
            let mut drawer = Drawer::new(&problem, form).unwrap();
            for exercise in seeds.clone().filter_map(|seed| drawer.draw(seed).ok()) {
                visit(&format!("{} {name}", problem.id()), &exercise);
            }
        }
    }
}

/// The lines of every solution with so many seeds: how many there were.
fn solution_lines(seeds: u64) -> usize {
    let (mut lines, mut other_laws) = (0, 0);
    let mut faults: Vec<String> = Vec::new();
    each(1..=seeds, &mut |entry, exercise| {
        let worked = exercise.worked();
        let mut judge = Judge::new(worked, DecimalMark::Point);
        for line in explain::lines(worked) {
            let Some(right) = &line.right else { continue };
            let has_pieces = [&line.left, right].into_iter().any(|side| side.contains(" while "));
            if line.relation != "=" || right.starts_with("integral") || has_pieces {
                continue;
            }
            let text = format!("{} = {right}", line.left);
            let judged = judge.line(&text);
            lines += 1;
            if !judged.verdict.is_true() {
                faults.push(format!("{entry} {:?} {text}: {}", judged.verdict, judged.message));
            }
            if let Some(law) = line.law
                && judged.verdict == Verdict::Follows
                && !judged.laws.contains(&law)
            {
                other_laws += 1;
                eprintln!("{entry} {text}: {:?} for {law}", judged.laws);
            }
        }
    });
    assert!(faults.is_empty(), "{} of {lines}\n{}", faults.len(), faults.join("\n"));
    assert!(other_laws == 0, "{other_laws}");
    lines
}

#[test]
fn the_lines_of_every_solution_follow() {
    assert!(solution_lines(2) > 2500);
}

#[test]
#[ignore = "takes minutes"]
fn the_lines_of_every_solution_of_twenty_variants_follow() {
    assert!(solution_lines(20) > 25_000);
}

/// The equations of every solution with so many seeds, written by a student who takes the other direction as positive: how many there were.
fn turned_lines(seeds: u64) -> usize {
    let (mut lines, mut faults) = (0, Vec::new());
    each(1..=seeds, &mut |entry, exercise| {
        let worked = exercise.worked();
        let problem = worked.problem;
        let symbols: Vec<Symbol> = problem.model().symbols.iter().map(|(symbol, _)| symbol).collect();
        let Some(direction) =
            symbols.iter().find_map(|symbol| problem.turns_with(*symbol)).map(|senses| senses.negative)
        else {
            return;
        };
        let is_turned = |symbol: Symbol| problem.turns_with(symbol).is_some_and(|senses| senses.negative == direction);
        let mut judge = Judge::new(worked, DecimalMark::Point);
        let convention = judge.line(&format!("take {direction} as positive"));
        assert_eq!(convention.verdict, Verdict::Convention, "{entry}: {direction}");
        for sides in equations(worked) {
            let turned = |symbol: Symbol| is_turned(symbol).then(|| -Expr::from(symbol));
            let text = typed(worked, &(sides.0.substitute(&turned), sides.1.substitute(&turned)));
            if text.len() > LONGEST {
                continue;
            }
            let judged = judge.line(&text);
            lines += 1;
            if !judged.verdict.is_true() {
                faults.push(format!("{entry} ({direction}) {:?} {text}: {}", judged.verdict, judged.message));
            }
        }
    });
    assert!(faults.is_empty(), "{} of {lines}\n{}", faults.len(), faults.join("\n"));
    lines
}

#[test]
fn the_lines_of_every_solution_follow_with_the_other_direction_as_positive() {
    assert!(turned_lines(1) > 500);
}

#[test]
#[ignore = "takes minutes"]
fn the_lines_of_twenty_variants_follow_with_the_other_direction_as_positive() {
    assert!(turned_lines(20) > 10_000);
}

/// Whoever writes what the hints say comes to every answer.
fn follow_the_hints(seeds: u64) {
    let mut faults: Vec<String> = Vec::new();
    each(1..=seeds, &mut |entry, exercise| {
        let worked = exercise.worked();
        let mut judge = Judge::new(worked, DecimalMark::Point);
        let mut written: Vec<String> = Vec::new();
        for _ in 0..40 {
            let (_, Some(next)) = judge.conclude(Vec::new()) else { break };
            for line in [&next.equation, &next.numbers].into_iter().filter(|line| !line.is_empty()) {
                let judged = judge.line(line);
                written.push(format!("{line}: {:?} {}", judged.verdict, judged.message));
            }
        }
        let (report, _) = judge.conclude(Vec::new());
        let misses = report.laws.iter().any(|needed| !needed.established)
            || report.answers.iter().any(|needed| !needed.established);
        if misses {
            faults
                .push(format!("{entry}\n  {}", written.iter().rev().take(8).cloned().collect::<Vec<_>>().join("\n  ")));
        }
    });
    assert!(faults.is_empty(), "{}\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn hints_lead_to_the_answers() {
    follow_the_hints(1);
}

#[test]
#[ignore = "takes minutes"]
fn hints_lead_to_the_answers_of_ten_variants() {
    follow_the_hints(10);
}
