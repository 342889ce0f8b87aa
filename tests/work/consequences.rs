//! Consequences of the scene, and lines that a slip has spoilt.

use std::sync::Arc;

use momentous::exercise::{Drawer, Exercise};
use momentous::expr::{Expr, Symbol};
use momentous::grade::DecimalMark;
use momentous::solve::{Bounded, Real, evaluate};
use momentous::work::{Judge, Verdict};
use rand::SeedableRng;
use rand::rngs::ChaCha8Rng;

use super::algebra::{equations, rearranged, spoilt, typed};
use super::solutions::each;

/// A line that is longer is no line of a student's.
pub const LONGEST: usize = 400;

/// How many lines of each form are tried.
#[derive(Clone, Copy)]
pub struct Size {
    pub seeds: u64,
    pub lines: usize,
}

pub const FEW: Size = Size { seeds: 1, lines: 6 };
pub const MANY: Size = Size { seeds: 20, lines: 230 };

fn consequences(size: Size) -> usize {
    let mut rng = ChaCha8Rng::seed_from_u64(43);
    let (mut lines, mut open, mut faults) = (0, 0, Vec::new());
    each(1..=size.seeds, &mut |name, exercise| {
        let worked = exercise.worked();
        let all = equations(worked);
        let mut judge = Judge::new(worked, DecimalMark::Point);
        for _ in 0..size.lines {
            let Some(sides) = rearranged(&mut rng, &worked.problem.model().symbols, &all) else { continue };
            let text = typed(worked, &sides);
            if text.len() > LONGEST {
                continue;
            }
            let judged = judge.line(&text);
            lines += 1;
            if matches!(judged.verdict, Verdict::Undecided | Verdict::Unreadable) {
                open += 1;
                eprintln!("{name} {:?} {text}: {}", judged.verdict, judged.message);
            } else if !judged.verdict.is_true() {
                faults.push(format!("{name} {:?} {text}: {}", judged.verdict, judged.message));
            }
        }
    });
    assert!(faults.is_empty(), "{} of {lines}\n{}", faults.len(), faults.join("\n"));
    assert!(open * 200 <= lines, "{open} of {lines} cannot be read or decided");
    lines
}

#[test]
fn consequences_are_never_called_wrong() {
    assert!(consequences(FEW) > 1000);
}

#[test]
#[ignore = "takes an hour"]
fn a_million_consequences_are_never_called_wrong() {
    assert!(consequences(MANY) > 900_000);
}

/// Whether an equation holds in other variants, with values that were solved without it, in one of the two senses of the axis across
/// the line of impact.
fn holds_elsewhere(exercise: &Exercise, drawer: &mut Drawer<'_>, sides: &(Expr, Expr)) -> bool {
    [false, true].iter().any(|is_turned| holds_in_sense(exercise, drawer, sides, *is_turned))
}

fn holds_in_sense(exercise: &Exercise, drawer: &mut Drawer<'_>, (left, right): &(Expr, Expr), is_turned: bool) -> bool {
    let symbols = &exercise.problem().model().symbols;
    let others = (500..540).filter_map(|seed| drawer.draw(seed).ok());
    others.filter(|other| other.variant().leaf() == exercise.variant().leaf()).all(|other| {
        let value = |symbol: Symbol| {
            let value = other.variant().value(symbol).unwrap_or_else(Bounded::not_real);
            if is_turned && symbols.entry(symbol).name.strip_suffix(".t").is_some() { value.neg() } else { value }
        };
        let [left, right]: [Bounded; 2] = [left, right].map(|side| evaluate(side, &value));
        let size = left.value.abs().max(right.value.abs());
        let is_close = (left.value - right.value).abs() <= left.error + right.error + 1e-9 * size;
        !left.is_real() || !right.is_real() || is_close
    })
}

/// Spoilt lines: how many there were. Of those that are taken as true each has to be shown to be so apart.
fn spoilt_lines(size: Size) -> usize {
    let mut rng = ChaCha8Rng::seed_from_u64(44);
    let (mut lines, mut faults) = (0, Vec::new());
    each(1..=size.seeds, &mut |name, exercise| {
        let worked = exercise.worked();
        let all = equations(worked);
        let table = &worked.problem.model().symbols;
        let problem = Arc::new(exercise.problem().clone());
        let mut drawer = Drawer::new(&problem, exercise.variant().form()).unwrap();
        let mut judge = Judge::new(worked, DecimalMark::Point);
        for _ in 0..size.lines {
            let Some(sides) = rearranged(&mut rng, table, &all).and_then(|sides| spoilt(&mut rng, table, &sides))
            else {
                continue;
            };
            let text = typed(worked, &sides);
            if text.len() > LONGEST {
                continue;
            }
            let judged = judge.line(&text);
            lines += 1;
            if judged.verdict.is_true() && !holds_elsewhere(exercise, &mut drawer, &sides) {
                faults.push(format!("{name} {:?} {text}: {}", judged.verdict, judged.message));
            }
        }
    });
    assert!(faults.len() * 100_000 <= lines, "{} of {lines}\n{}", faults.len(), faults.join("\n"));
    lines
}

#[test]
fn spoilt_lines_are_refused() {
    assert!(spoilt_lines(FEW) > 800);
}

#[test]
#[ignore = "takes an hour"]
fn a_million_spoilt_lines_are_refused() {
    assert!(spoilt_lines(MANY) > 700_000);
}
