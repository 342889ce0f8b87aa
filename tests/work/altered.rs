//! Lines that hold a law in a usual wrong form, alone or together with a right line: the mistake is named.

use std::collections::{BTreeMap, BTreeSet};

use momentous::grade::DecimalMark;
use momentous::quantity::UnitSystem;
use momentous::solve::Statement;
use momentous::work::{Judge, Verdict};
use rand::SeedableRng;
use rand::rngs::ChaCha8Rng;

use super::algebra::{Sides, combined, equations, has_pieces, typed};
use super::solutions::each;

/// A line that is longer is no line of a student's.
const LONGEST: usize = 400;

/// What became of a line with a known mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    /// Its mistake is among at most two.
    Named,
    /// Its mistake is among more.
    AmongMany,
    /// Its dimensions clash.
    Dimensions,
    /// It is true in this scene, or for these numbers.
    True,
    /// Another mistake is named, or none.
    Missed,
}

/// The line as its student writes it: whoever takes pounds of weight for pounds of mass writes no number for the unit of acceleration,
/// which is 0.3048 m/s^2 in feet.
fn without_unit_acceleration(text: &str, units: UnitSystem) -> String {
    match units {
        UnitSystem::Si => text.to_owned(),
        UnitSystem::Us => text.replace("0.3048*", "1*").replace("1250*", "1*").replace("/381", "/1"),
    }
}

/// Lines with every altered law of every form, with so many seeds: how many there were.
fn altered_lines(seeds: u64) -> usize {
    let mut rng = ChaCha8Rng::seed_from_u64(45);
    let mut counts: BTreeMap<Outcome, usize> = BTreeMap::new();
    let mut missed = Vec::new();
    each(1..=seeds, &mut |name, exercise| {
        let worked = exercise.worked();
        let all = equations(worked);
        let leaf = worked.leaf();
        let used: BTreeSet<usize> =
            leaf.answer_steps().iter().flat_map(|step| step.equations.iter().copied()).collect();
        let model = worked.problem.model();
        let mut judge = Judge::new(worked, DecimalMark::Point);
        for mistaken in model.mistaken(&leaf.system, &used, &worked.form.told, worked.problem.units()) {
            for equation in mistaken.wrong.iter().filter_map(|place| mistaken.system.equations.get(*place)) {
                let Statement::Equal { left, right } = &equation.statement else { continue };
                let alone: Sides = (left.clone(), right.clone());
                // The right form of the same law is no line beside the wrong one.
                let is_replaced = |sides: &&Sides| {
                    leaf.system.equations.iter().any(|other| {
                        let same = matches!(&other.statement, Statement::Equal { left, right } if (left, right) == (&sides.0, &sides.1));
                        other.tag == equation.tag && same
                    })
                };
                let others: Vec<Sides> = all.iter().filter(|sides| !is_replaced(sides)).cloned().collect();
                let together = combined(&mut rng, &model.symbols, &alone, &others);
                for sides in [Some(alone), together].into_iter().flatten() {
                    let text = without_unit_acceleration(&typed(worked, &sides), worked.problem.units());
                    if text.len() > LONGEST || has_pieces(&sides.0) || has_pieces(&sides.1) {
                        continue;
                    }
                    let judged = judge.line(&text);
                    let is_named = judged.mistakes.contains(&mistaken.of.id);
                    let outcome = match judged.verdict {
                        Verdict::Dimensions => Outcome::Dimensions,
                        Verdict::Coincidence => Outcome::True,
                        verdict if verdict.is_true() => Outcome::True,
                        _ if is_named && judged.mistakes.len() <= 2 => Outcome::Named,
                        _ if is_named => Outcome::AmongMany,
                        _ => Outcome::Missed,
                    };
                    *counts.entry(outcome).or_default() += 1;
                    if outcome == Outcome::Missed {
                        missed.push(format!("{name} {}: {text} {:?}", mistaken.of.id, judged.verdict));
                    }
                }
            }
        }
    });
    let count = |outcome| counts.get(&outcome).copied().unwrap_or(0);
    let judged = count(Outcome::Named) + count(Outcome::AmongMany) + count(Outcome::Missed);
    assert!(count(Outcome::Named) * 100 >= judged * 97, "{counts:?}\n{}", missed.join("\n"));
    assert!(missed.len() * 100 <= judged * 2, "{counts:?}\n{}", missed.join("\n"));
    eprintln!("{counts:?}");
    judged
}

#[test]
fn altered_laws_are_named() {
    assert!(altered_lines(1) > 4000);
}

#[test]
#[ignore = "takes minutes"]
fn altered_laws_of_ten_variants_are_named() {
    assert!(altered_lines(10) > 40_000);
}
