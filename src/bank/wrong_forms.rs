//! Whether the common mistakes can be distinguished from the right answer, and from each other, with the numbers that a form draws.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_exercise::Exercise;
use momentous_problem::Problem;
use momentous_problem::Sampler;

use super::answers::noted;
use super::promise::Outcome;

/// At most so many seeds are looked at: a share to the nearest per cent needs no more.
const MOST_SEEDS: u64 = 100;
/// A mistake that is told on a smaller share of the seeds, in per cent, passes for right.
const USUALLY: u64 = 50;

/// Statistics of the mistakes.
#[derive(Default)]
struct MistakeCounts {
    /// Seeds on which a mistake changes some answer.
    told: BTreeMap<&'static str, u64>,
    seeds: u64,
}

/// Says where every mistake that can be made in a form gives the right answers on most seeds: then marking finds none; and how often
/// draws are rejected for what stands under `discriminate`. `momentous diagnose --confused` says how often a single mistake gives a
/// right answer; an author who wants it told writes `discriminate`.
pub(super) fn told_apart(problem: &Arc<Problem>, form: usize, seeds: u64) -> Outcome {
    let mut counts = MistakeCounts::default();
    for seed in 1..=seeds.min(MOST_SEEDS) {
        let Ok(exercise) = Exercise::draw(problem, form, seed) else { continue };
        counts.count(&exercise);
    }
    if counts.seeds == 0 || counts.told.is_empty() {
        return Outcome::NotChecked("no common mistake applies to it");
    }
    let is_told = |told: &u64| 100 * told >= USUALLY * counts.seeds;
    if counts.told.values().any(is_told) {
        return noted(&rejected(problem, form, seeds));
    }
    let names: Vec<&str> = counts.told.keys().copied().collect();
    Outcome::Noted(format!(
        "every usual mistake gives the right answers on most seeds ({}): give other numbers, or name mistakes that must change an answer under `discriminate`",
        names.join(", ")
    ))
}

/// How often draws are rejected since a mistake that the author wants to see would change no answer.
fn rejected(problem: &Problem, form: usize, seeds: u64) -> Vec<String> {
    if problem.loaded().draft.discriminate.is_empty() {
        return Vec::new();
    }
    let Ok(mut sampler) = Sampler::new(problem, form) else { return Vec::new() };
    let drawn = (1..=seeds.min(MOST_SEEDS)).filter(|seed| sampler.draw(*seed).is_ok()).count() as u64;
    let attempts = drawn + sampler.rejected();
    let rejected = sampler.rejected_as_indistinct().iter();
    let rejected = rejected.map(|(mistake, times)| {
        format!("`{mistake}` would change no answer in {times} of {attempts} draws, which are drawn again")
    });
    rejected.collect()
}

impl MistakeCounts {
    fn count(&mut self, exercise: &Exercise) {
        self.seeds += 1;
        let worked = exercise.worked();
        let mut told = BTreeSet::new();
        for part in &worked.form.parts {
            let right = exercise.printed(part);
            let wrong = exercise.mistaken_answers(part).into_iter().filter(|(_, answer)| *answer != right);
            told.extend(wrong.map(|(code, _)| code));
        }
        for code in told {
            *self.told.entry(code).or_default() += 1;
        }
    }
}
