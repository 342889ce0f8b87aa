//! Measures `momentous grade` on tables of the mix that the benchmark marks: rows a second and the most memory, option by option,
//! as rows of a Markdown table. It runs the program that was built beside it, under Linux, whose kernel says how much memory a process took:
//! `cargo build --release && cargo run --release --example tables 1000000`.

#[path = "../benches/mix/mod.rs"]
mod mix;

use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::thread::sleep;
use std::time::{Duration, Instant};

use momentous::problem::Problem;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// Submissions that are drawn at a time.
const PORTION: u64 = 10_000;
/// The cells of a wide row.
const CELLS: usize = 10_000;
/// How often the memory of the program is looked at.
const LOOK: Duration = Duration::from_millis(2);

/// What is measured: what it is called, and what the program is told.
const RUNS: &[(&str, &[&str])] = &[
    ("a table", &["class.csv"]),
    ("JSON lines", &["class.jsonl"]),
    ("`--marks json`", &["class.csv", "--marks", "json"]),
    ("`--sheets seeds.csv`", &["class.csv", "--sheets", "seeds.csv"]),
    ("`--junit`", &["class.csv", "--junit", "class.xml"]),
    ("`--summary`", &["class.csv", "--summary", "class"]),
    ("`--changes`", &["class.csv", "--changes", "old.csv"]),
    ("`--any-order`", &["class.csv", "--any-order"]),
    ("rows of 10,000 cells", &["wide.csv"]),
    ("JSON lines of 1 MB", &["long.jsonl"]),
    ("unknown problems, each another", &["unknown.csv"]),
];

fn main() -> Outcome<()> {
    let count: u64 = std::env::args().nth(1).ok_or("say how many submissions")?.parse()?;
    let program = std::env::current_exe()?.ancestors().nth(2).ok_or("it stands in no folder")?.join("momentous");
    let folder = tempfile::tempdir()?;
    write_class(folder.path(), count)?;
    write_odd(folder.path(), count)?;
    run(&program, folder.path(), &["class.csv", "-o", "old.csv"])?;
    println!("| what | rows | rows a second | largest memory |\n|---|---:|---:|---:|");
    for (what, arguments) in RUNS {
        let rows = fs::read(folder.path().join(arguments[0]))?.split(|byte| *byte == b'\n').count() - 2;
        let (seconds, memory) = run(&program, folder.path(), &[arguments, &["-o", "marks.csv"][..]].concat())?;
        #[allow(clippy::cast_precision_loss, reason = "a count of rows")]
        let rate = rows as f64 / seconds;
        println!("| {what} | {rows} | {rate:.0} | {} MB |", memory / 1000);
    }
    Ok(())
}

/// Runs the program: how long it took in seconds, and how much memory it had at most, in thousands of bytes.
fn run(program: &Path, folder: &Path, arguments: &[&str]) -> Outcome<(f64, u64)> {
    let start = Instant::now();
    let mut child = Command::new(program)
        .arg("grade")
        .args(arguments)
        .current_dir(folder)
        .stderr(Stdio::null())
        .stdout(Stdio::null())
        .spawn()?;
    let status = format!("/proc/{}/status", child.id());
    let mut memory = 0;
    while child.try_wait()?.is_none() {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let most =
            text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.split_whitespace().next()?.parse::<u64>().ok());
        memory = memory.max(most.unwrap_or(0));
        sleep(LOOK);
    }
    Ok((start.elapsed().as_secs_f64(), memory * 1024 / 1000))
}

/// The class as a table and as JSON lines, and what goes with it: each student hands in each problem once.
fn write_class(folder: &Path, count: u64) -> Outcome<()> {
    let problems: Vec<Arc<Problem>> = mix::PROBLEMS.iter().map(|id| mix::problem(id)).collect();
    let ids = problems.iter().flat_map(|problem| &problem.forms()[0].parts).map(|part| part.id.as_str());
    let columns: Vec<&str> = ids.collect::<BTreeSet<&str>>().into_iter().collect();
    let mut table = csv::Writer::from_path(folder.join("class.csv"))?;
    let mut seeds = csv::Writer::from_path(folder.join("seeds.csv"))?;
    let mut lines = BufWriter::new(fs::File::create(folder.join("class.jsonl"))?);
    table.write_record(["student", "problem", "seed"].iter().chain(&columns))?;
    seeds.write_record(["student", "problem", "seed"])?;
    let mut line = 0;
    for from in (0..count).step_by(usize::try_from(PORTION)?) {
        for submission in mix::submissions(&problems, from, count.min(from + PORTION)) {
            let student = format!("s{}", line / mix::PROBLEMS.len());
            line += 1;
            let (problem, seed) = (mix::PROBLEMS[submission.problem], submission.seed.to_string());
            let cell = |column: &&str| {
                let found = submission.answers.iter().find(|(part, _)| part == column);
                found.map_or("", |(_, answer)| answer.as_str())
            };
            let keys = [student.as_str(), problem, seed.as_str()];
            table.write_record(keys.into_iter().chain(columns.iter().map(cell)))?;
            seeds.write_record(keys)?;
            let answers: serde_json::Map<String, serde_json::Value> =
                submission.answers.iter().map(|(part, answer)| (part.clone(), answer.as_str().into())).collect();
            let object =
                serde_json::json!({ "student": student, "problem": problem, "seed": seed, "answers": answers });
            writeln!(lines, "{object}")?;
        }
    }
    table.flush()?;
    seeds.flush()?;
    Ok(lines.flush()?)
}

/// What is unusual: wide rows, long lines, and names of problems that are not there.
fn write_odd(folder: &Path, count: u64) -> Outcome<()> {
    let wide = BufWriter::new(fs::File::create(folder.join("wide.csv"))?);
    let mut table = csv::Writer::from_writer(wide);
    let columns = (0..CELLS).map(|column| format!("c{column}"));
    table.write_record(["student".to_owned(), "problem".to_owned(), "seed".to_owned()].into_iter().chain(columns))?;
    for row in 0..count / 200 {
        let cells = (0..CELLS).map(|_| "1 m/s".to_owned());
        table.write_record(
            [format!("s{row}"), "impact/two-carts".to_owned(), "1".to_owned()].into_iter().chain(cells),
        )?;
    }
    table.flush()?;
    let answers: Vec<String> = (0..60_000).map(|part| format!("\"p{part}\":\"1 m/s\"")).collect();
    let answers = answers.join(",");
    let mut lines = BufWriter::new(fs::File::create(folder.join("long.jsonl"))?);
    for row in 0..count / 2000 {
        writeln!(
            lines,
            "{{\"student\":\"s{row}\",\"problem\":\"impact/two-carts\",\"seed\":1,\"answers\":{{{answers}}}}}"
        )?;
    }
    lines.flush()?;
    let mut unknown = BufWriter::new(fs::File::create(folder.join("unknown.csv"))?);
    writeln!(unknown, "student,problem,seed")?;
    for row in 0..count / 10 {
        writeln!(unknown, "s{row},impact/no-such-problem-{row},1")?;
    }
    Ok(unknown.flush()?)
}
