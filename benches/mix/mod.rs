//! A class as marking meets it: 70 % of the answers right, 20 % wrong, 10 % with trouble in the unit or in the reading.

use std::sync::Arc;

use momentous::exercise::Drawer;
use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::Part;
use momentous::problem::PartKind;
use momentous::problem::Problem;
use momentous::problem::compile;
use momentous::problem::load;

/// Twenty problems, some from every topic of the bank.
pub const PROBLEMS: [&str; 20] = [
    "angular-momentum/puck-on-string",
    "bouncing/rubber-ball",
    "central-force/satellite",
    "chains/ballistic-pendulum",
    "concepts/two-trains",
    "conservation/canoe-jump",
    "conservation/coupling-wagons",
    "conservation/crossing-cars",
    "impact/dropped-basketball",
    "impact/hockey-pucks",
    "impact/squash-wall",
    "impact/two-carts",
    "impulse/bobsleigh-start",
    "impulse/lift-cable",
    "impulse/softball-hit",
    "impulse/tennis-return",
    "mass-centre/walk-along-barge",
    "streams/fire-hose",
    "strings/towed-sledges",
    "vectors/cushion-shot",
];

/// Seeds come from 1 to this.
const SEEDS: u64 = 100_000;

/// One student's answers to one variant.
pub struct Submission {
    /// The problem's position in [`PROBLEMS`].
    pub problem: usize,
    /// The seed.
    pub seed: u64,
    /// Part and answer.
    pub answers: Vec<(String, String)>,
}

/// The problem of the bank with that identity.
pub fn problem(id: &str) -> Arc<Problem> {
    let path = format!("{}/problem_bank/{id}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_default();
    match load(Source::new(&path, &text)).and_then(|loaded| compile(loaded, None)) {
        Ok(problem) => Arc::new(problem),
        Err(faults) => panic!("{faults}"),
    }
}

/// The submissions from one position to another; each position has its own problem, seed and mistakes, always the same.
pub fn submissions(problems: &[Arc<Problem>], from: u64, to: u64) -> Vec<Submission> {
    let mut drawers: Vec<_> = problems.iter().map(|problem| Drawer::new(problem, 0).ok()).collect();
    let mut all = Vec::new();
    for position in from..to {
        let problem = (position % problems.len() as u64) as usize;
        let seed = 1 + mixed(position) % SEEDS;
        let exercise = drawers.get_mut(problem).and_then(Option::as_mut).and_then(|drawer| drawer.draw(seed).ok());
        let Some(exercise) = exercise else { continue };
        let parts = exercise.worked().form.parts.iter().enumerate();
        let answers = parts.map(|(index, part)| {
            let chance = mixed(position ^ ((index as u64 + 1) << 40));
            (part.id.clone(), answer(&exercise, part, chance))
        });
        all.push(Submission { problem, seed, answers: answers.collect() });
    }
    all
}

fn answer(exercise: &Exercise, part: &Part, chance: u64) -> String {
    let right = exercise.printed(part);
    let (kind, more) = (chance % 10, chance / 10);
    if let PartKind::Choice(choice) = &part.kind {
        let options = choice.decided(&exercise.worked()).options;
        return match kind {
            0..7 => right,
            7..9 => options[(more % options.len() as u64) as usize].clone(),
            _ => "no idea".to_owned(),
        };
    }
    let number = right.split(' ').next().unwrap_or_default().to_owned();
    match kind {
        0..7 => right,
        // Half of what is wrong is a usual mistake, the other half is anything.
        7 => {
            let mistaken = exercise.mistaken_answers(part);
            let count = mistaken.len().max(1) as u64;
            mistaken.get((more % count) as usize).map_or_else(|| format!("1{right}"), |(_, text)| text.clone())
        }
        8 => format!("{}{right}", 1 + more % 9),
        _ => match more % 4 {
            0 => number,
            1 => format!("{number} kg"),
            2 => format!("{number} apples"),
            _ => format!("{right} ?"),
        },
    }
}

/// A word that looks like chance: the finaliser of `SplitMix64`.
fn mixed(number: u64) -> u64 {
    let mut word = number.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}
