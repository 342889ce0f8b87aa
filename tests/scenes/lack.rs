//! What a refusal for lack of data says is true: two worlds agree on what is given and differ in the answer.

use super::draw::Drawn;
use super::system::{said, solved};
use super::table::Table;

/// What becomes of a refusal for lack of data.
pub enum Lack {
    /// Two worlds show it.
    Shown,
    /// No two worlds were found with the values that were tried.
    Open,
    /// Every world that was found has the same answer, so nothing is lacking.
    Nothing(String),
}

/// Values that are tried for what the refusal says is lacking, in the unit of the table.
const TRIED: [&str; 5] = ["0.7", "2", "-1.5", "25", "6"];

/// The sets of names of which a refusal says that one is to be given, too.
fn advised(refusal: &str) -> Vec<Vec<&str>> {
    let Some((_, advice)) = refusal.split_once("give also ") else { return Vec::new() };
    let advice = advice.lines().next().unwrap_or_default();
    let advice = advice.split("; ").next().unwrap_or_default();
    advice.split(", or ").map(|set| set.split('`').skip(1).step_by(2).collect()).collect()
}

/// Worlds with the same answer that say that it is fixed.
const SAME: usize = 3;

/// Looks for two worlds that agree on what is given and differ in the answer to a question.
pub fn lack(table: &Table, scene: &Drawn, question: usize, refusal: &str) -> Lack {
    if refusal.contains("admissible solutions") {
        return Lack::Shown;
    }
    let asked = &scene.questions[question].0;
    let mut all: Vec<f64> = Vec::new();
    let mut fixed = None;
    for set in advised(refusal) {
        let answers: Vec<f64> =
            (0..TRIED.len()).filter_map(|tried| answer(table, scene, question, &set, tried)).collect();
        all.extend(&answers);
        // What a given zero makes zero is fixed by that alone.
        if answers.len() >= SAME && !differ(&answers) && answers[0] != 0.0 {
            fixed = Some(format!("`{asked}` is {} whatever `{}` is\n{refusal}", answers[0], set.join("`, `")));
        }
    }
    let is_said_to_be_fixed = refusal.contains("does not matter");
    match fixed {
        _ if differ(&all) || is_said_to_be_fixed && !all.is_empty() => Lack::Shown,
        Some(why) => Lack::Nothing(why),
        None => Lack::Open,
    }
}

/// The answer to a question where further quantities are given, each with one of the values that are tried.
fn answer(table: &Table, scene: &Drawn, question: usize, set: &[&str], tried: usize) -> Option<f64> {
    let mut world = scene.clone();
    for (place, name) in set.iter().enumerate() {
        let (unit, value) = (table.unit_of(name)?, TRIED[(tried + place) % TRIED.len()]);
        world.given.push(((*name).to_owned(), format!("{value} {unit}").trim().to_owned()));
    }
    said(&solved(&world.file(question)).ok()?, &scene.questions[question].0)
}

fn differ(answers: &[f64]) -> bool {
    let (least, most) = answers
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), answer| (answer.min(least), answer.max(most)));
    most - least > 1e-9 * most.abs().max(least.abs())
}
