//! Writes a table of submissions for `momentous grade`, of the mix that the benchmark marks:
//! `cargo run --release --example submissions 1000000 > submissions.csv`.

#[path = "../benches/mix/mod.rs"]
mod mix;

use std::collections::BTreeSet;
use std::error::Error;
use std::sync::Arc;

use momentous::problem::Problem;

/// Submissions that are drawn at a time.
const PORTION: usize = 10_000;

fn main() -> Result<(), Box<dyn Error>> {
    let count: u64 = std::env::args().nth(1).ok_or("say how many submissions")?.parse()?;
    let problems: Vec<Arc<Problem>> = mix::PROBLEMS.iter().map(|id| mix::problem(id)).collect();
    let ids = problems.iter().flat_map(|problem| &problem.forms()[0].parts).map(|part| part.id.as_str());
    let columns: Vec<&str> = ids.collect::<BTreeSet<&str>>().into_iter().collect();
    let mut table = csv::Writer::from_writer(std::io::stdout().lock());
    table.write_record(["student", "problem", "seed"].iter().chain(&columns))?;
    let mut line = 0;
    for from in (0..count).step_by(PORTION) {
        for submission in mix::submissions(&problems, from, count.min(from + PORTION as u64)) {
            // Each student hands in each problem once.
            let student = format!("s{}", line / mix::PROBLEMS.len());
            line += 1;
            let seed = submission.seed.to_string();
            let cell = |column: &&str| {
                let found = submission.answers.iter().find(|(part, _)| part == column);
                found.map_or("", |(_, answer)| answer.as_str())
            };
            let keys = [student.as_str(), mix::PROBLEMS[submission.problem], seed.as_str()];
            table.write_record(keys.into_iter().chain(columns.iter().map(cell)))?;
        }
    }
    table.flush()?;
    Ok(())
}
