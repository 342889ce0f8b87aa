//! Whether the common mistakes can be distinguished from the right answer, and from each other, with the numbers that a form draws.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_exercise::Exercise;
use momentous_problem::Problem;

use super::promise::Outcome;

/// At most so many seeds are looked at: a share to the nearest per cent needs no more.
const MOST_SEEDS: u64 = 100;
/// What happens on a smaller share of the seeds, in per cent, is not worth a remark.
const WORTH_SAYING: u64 = 10;

/// What was seen of the mistakes.
#[derive(Default)]
struct Seen {
    /// Seeds on which a mistake changes some answer.
    told: BTreeMap<&'static str, u64>,
    /// Seeds on which two mistakes change the answers alike.
    alike: BTreeMap<(&'static str, &'static str), u64>,
    seeds: u64,
}

/// Says of each mistake that can be made in a form on how many seeds it hides, and which mistakes coincide.
pub(super) fn told_apart(problem: &Arc<Problem>, form: usize, seeds: u64) -> Outcome {
    let mut seen = Seen::default();
    for seed in 1..=seeds.min(MOST_SEEDS) {
        let Ok(exercise) = Exercise::draw(problem, form, seed) else { continue };
        seen.look(&exercise);
    }
    if seen.seeds == 0 || seen.told.is_empty() {
        return Outcome::NotChecked("no common mistake applies to it");
    }
    let share = |count: u64| 100 * count / seen.seeds;
    let hidden = seen.told.iter().map(|(code, told)| (code, share(seen.seeds - told)));
    let hidden = hidden.filter(|(_, share)| *share >= WORTH_SAYING).map(|(code, share)| format!("{code} ({share} %)"));
    let alike = seen.alike.iter().map(|(pair, count)| (pair, share(*count)));
    let alike = alike
        .filter(|(_, share)| *share >= WORTH_SAYING)
        .map(|((one, other), share)| format!("{one} and {other} ({share} %)"));
    let remarks = [
        ("give the right answers for some seeds", hidden.collect::<Vec<_>>()),
        ("cannot be distinguished", alike.collect()),
    ];
    let remarks = remarks.iter().filter(|(_, found)| !found.is_empty());
    let said: Vec<String> =
        remarks.map(|(what, found)| format!("mistakes that {what}: {}", found.join(", "))).collect();
    if said.is_empty() { Outcome::Kept } else { Outcome::Noted(said.join("; ")) }
}

impl Seen {
    fn look(&mut self, exercise: &Exercise) {
        self.seeds += 1;
        let worked = exercise.worked();
        // By mistake, everything that it makes of the parts; what is right is left out.
        let mut made: BTreeMap<&'static str, BTreeSet<(usize, String)>> = BTreeMap::new();
        for (place, part) in worked.form.parts.iter().enumerate() {
            let right = exercise.printed(part);
            for (code, answer) in exercise.mistaken_answers(part) {
                if answer != right {
                    made.entry(code).or_default().insert((place, answer));
                }
            }
        }
        for code in made.keys() {
            *self.told.entry(code).or_default() += 1;
        }
        for (one, answers) in &made {
            for (other, _) in made.range(*one..).skip(1).filter(|(_, own)| *own == answers) {
                *self.alike.entry((one, other)).or_default() += 1;
            }
        }
    }
}
