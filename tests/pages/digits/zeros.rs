//! What is exactly zero is printed as zero: no rounding error stands for it.

use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::{Drawer, Exercise};
use momentous::explain::{Audience, Block, Detail, Inline};
use momentous::expr::Math;
use momentous::problem::{compile, load};

/// Quantities of the bank are larger than this power of ten; what is smaller is the rounding of a double.
const LEAST_POWER: i32 = -9;

/// Whether a printed text holds a number that is nothing but rounding.
fn is_noisy(text: &str) -> bool {
    let powers = text.split("10^").skip(1);
    let power = |rest: &str| {
        let rest = rest.trim_start_matches(['(', '{']).replace('\u{2212}', "-");
        let end = rest.find(|letter: char| letter != '-' && !letter.is_ascii_digit()).unwrap_or(rest.len());
        rest[..end].parse::<i32>().ok()
    };
    powers.filter_map(power).any(|power| power < LEAST_POWER)
}

fn solution(exercise: &Exercise) -> Vec<String> {
    let mut texts = Vec::new();
    let outlines = [Detail::Short, Detail::Full].map(|detail| exercise.outline(Audience::Everyone, detail));
    let sections = outlines.iter().flat_map(|outline| &outline.sections);
    for block in sections.flat_map(|section| &section.blocks) {
        match block {
            Block::Equation { lines, .. } => texts.extend(lines.iter().map(Math::plain)),
            Block::Paragraph(runs) => texts.extend(runs.iter().filter_map(|run| match run {
                Inline::Math(math) => Some(math.plain()),
                _ => None,
            })),
            _ => {}
        }
    }
    texts
}

#[test]
fn noise_is_told_from_numbers() {
    assert!(is_noisy("3.878 × 10^-14 m") && is_noisy("= 2.46 × 10^\u{2212}74°"));
    assert!(!is_noisy("6.674 × 10^8 J") && !is_noisy("4.1 × 10^-7 s"));
}

#[test]
fn sheets_keys_and_solutions_print_no_noise() {
    let mut noisy = Vec::new();
    for source in Bank::built_in().sources() {
        let problem = Arc::new(compile(load(source.clone()).unwrap(), None).unwrap());
        // Seeds at which something cancels.
        let seeds: &[u64] = match problem.id() {
            "concepts/two-trains" => &[1, 93],
            "vectors/two-tugs" => &[1, 47],
            _ => &[1, 2, 3],
        };
        for form in 0..problem.forms().len() {
            let mut drawer = Drawer::new(&problem, form).unwrap();
            for exercise in seeds.iter().filter_map(|seed| drawer.draw(*seed).ok()) {
                let key = exercise.worked().form.parts.iter().map(|part| exercise.printed(part));
                let texts = solution(&exercise).into_iter().chain(key).chain([exercise.sheet().statement]);
                noisy.extend(texts.filter(|text| is_noisy(text)).map(|text| format!("{}: {text}", problem.id())));
            }
        }
    }
    assert!(noisy.is_empty(), "{noisy:#?}");
}
