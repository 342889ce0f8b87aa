//! Each printed line of a worked solution can be computed again from what is printed on it.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::{Drawer, Exercise};
use momentous::explain::{Audience, Block, Detail, Inline};
use momentous::expr::Math;
use momentous::problem::{compile, load};

use super::printed::{Float, Printed, side, sides};

/// What was looked at.
#[derive(Default)]
struct Tally {
    lines: u64,
    wrong: Vec<String>,
}

impl Tally {
    fn solution(&mut self, exercise: &Exercise) {
        let outlines = [Detail::Short, Detail::Full].map(|detail| exercise.outline(Audience::Everyone, detail));
        let sections = outlines.iter().flat_map(|outline| &outline.sections);
        for block in sections.flat_map(|section| &section.blocks) {
            match block {
                Block::Equation { lines, .. } => self.chain(exercise, lines),
                Block::Paragraph(runs) => self.runs(exercise, runs),
                Block::List(rows) => rows.iter().for_each(|runs| self.runs(exercise, runs)),
                _ => {}
            }
        }
    }

    fn runs(&mut self, exercise: &Exercise, runs: &[Inline]) {
        for run in runs {
            if let Inline::Math(math) = run {
                self.chain(exercise, std::slice::from_ref(math));
            }
        }
    }

    /// What equals what: a number stands behind what is computed.
    fn chain(&mut self, exercise: &Exercise, lines: &[Math]) {
        let sides = sides(lines);
        let values: Vec<Option<Printed>> = sides.iter().map(|text| side(text)).collect();
        for (pair, shown) in values.windows(2).zip(sides.windows(2)) {
            let [Some(computed), Some(result)] = pair else { continue };
            let Some(halves) = &result.halves else { continue };
            self.lines += 1;
            let near = |(value, half): (&Float, &Float)| {
                computed.values.iter().any(|computed_value| within(computed_value, value, half))
            };
            if !result.values.iter().zip(halves).all(near) {
                let shown = shown.iter().map(|side| Math::Row(side.clone()).plain()).collect::<Vec<_>>().join(" = ");
                let identity = exercise.identity();
                let form = identity.form.unwrap_or_default();
                self.wrong.push(format!("{} {form} seed {}: {shown}", identity.problem, identity.seed.unwrap_or(0)));
            }
        }
    }
}

fn within(exact: &Float, value: &Float, half: &Float) -> bool {
    let off = exact.clone() - value.clone();
    let off = if off < Float::ZERO { -off } else { off };
    // Beyond fifty digits nothing is told.
    let slack = half.clone() * Float::try_from(1e-50).unwrap().with_precision(256).value();
    off <= half.clone() + slack
}

#[test]
fn every_line_of_the_bank_can_be_computed_again() {
    let seeds: u64 = std::env::var("MOMENTOUS_SEEDS").map_or(50, |text| text.parse().unwrap());
    let mut tally = Tally::default();
    for source in Bank::built_in().sources() {
        let problem = Arc::new(compile(load(source.clone()).unwrap(), None).unwrap());
        for form in 0..problem.forms().len() {
            let mut drawer = Drawer::new(&problem, form).unwrap();
            (1..=seeds).filter_map(|seed| drawer.draw(seed).ok()).for_each(|exercise| tally.solution(&exercise));
        }
    }
    let mut by_problem: BTreeMap<&str, usize> = BTreeMap::new();
    for line in &tally.wrong {
        *by_problem.entry(line.split(" seed").next().unwrap_or_default()).or_default() += 1;
    }
    let shown: Vec<&str> = tally.wrong.iter().take(40).map(String::as_str).collect();
    assert!(tally.wrong.is_empty(), "{} of {}\n{by_problem:#?}\n{}", tally.wrong.len(), tally.lines, shown.join("\n"));
    assert!(tally.lines > 900 * seeds, "{}", tally.lines);
}
