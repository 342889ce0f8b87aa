//! Whether marking says of an author's own answers what the file expects.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous_exercise::Exercise;
use momentous_fault::did_you_mean;
use momentous_grade::DecimalMark;
use momentous_grade::Verdict;
use momentous_problem::Part;
use momentous_problem::Problem;

use super::promise::Outcome;

/// The seed to whose sheet an author's answers belong.
const SEED: u64 = 1;

/// Marks each answer alone.
pub(super) fn holds(problem: &Arc<Problem>, form: usize) -> Outcome {
    let Ok(exercise) = Exercise::draw(problem, form, SEED) else { return Outcome::NotChecked("nothing was drawn") };
    let parts = exercise.worked().form.parts.iter();
    let other: Vec<String> = parts.flat_map(|part| others(&exercise, part)).collect();
    if other.is_empty() { Outcome::Kept } else { Outcome::Broken(other.join("; ")) }
}

/// The differences between the verdicts on answers to a part and those expected.
fn others(exercise: &Exercise, part: &Part) -> Vec<String> {
    let other = |(typed, code): (&str, &String)| {
        let id = &part.id;
        let Some(expected) = Verdict::of(code) else {
            let near = did_you_mean(code, Verdict::all().map(Verdict::code))
                .map_or_else(String::new, |near| format!(", did you mean `{near}`?"));
            return Some(format!("`{id}` expects a verdict `{code}`, which there is not{near}"));
        };
        let report = exercise.grade(&BTreeMap::from([(id.clone(), typed.to_owned())]), DecimalMark::Point);
        let marked = report.parts.iter().find(|marked| marked.id == *id)?;
        (marked.verdict != expected).then(|| {
            let right = exercise.printed(part);
            let (points, out_of) = (&marked.points, marked.out_of);
            format!(
                "`{id}` = {typed} is marked {} ({points}/{out_of}), not {code}: with seed {SEED} the answer is {right}",
                marked.verdict.code()
            )
        })
    };
    part.expected.iter().filter_map(other).collect()
}
