//! Marking at scale: `cargo bench --bench marking`. The mix is that of `benches/mix`.

use std::collections::BTreeMap;
use std::hint::black_box;
use std::sync::Arc;

use criterion::Criterion;
use criterion::Throughput;
use criterion::criterion_group;
use criterion::criterion_main;
use momentous::exercise::Drawer;
use momentous::grade::DecimalMark;
use momentous::problem::Problem;
use rayon::prelude::*;

mod mix;

/// Submissions, grouped by problem as the command groups them.
const SUBMISSIONS: u64 = 10_000;

struct Row {
    seed: u64,
    answers: BTreeMap<String, String>,
}

/// Draws and marks one after the other; how many parts are right.
fn marked(problem: &Arc<Problem>, rows: &[Row]) -> usize {
    let Ok(mut drawer) = Drawer::new(problem, 0) else { return 0 };
    let reports =
        rows.iter().filter_map(|row| Some(drawer.draw(row.seed).ok()?.grade(&row.answers, DecimalMark::Point)));
    reports.map(|report| report.parts.iter().filter(|part| part.verdict.is_right()).count()).sum()
}

fn marking(criterion: &mut Criterion) {
    let problems: Vec<Arc<Problem>> = mix::PROBLEMS.iter().map(|id| mix::problem(id)).collect();
    let mut groups: Vec<Vec<Row>> = mix::PROBLEMS.iter().map(|_| Vec::new()).collect();
    let mut answers = 0;
    for submission in mix::submissions(&problems, 0, SUBMISSIONS) {
        answers += submission.answers.len() as u64;
        let row = Row { seed: submission.seed, answers: submission.answers.into_iter().collect() };
        groups[submission.problem].push(row);
    }
    let mut group = criterion.benchmark_group("marking");
    group.sample_size(10).throughput(Throughput::Elements(answers));
    for cores in [1, 2] {
        let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(cores).build() else { continue };
        group.bench_function(format!("answers, {cores} cores"), |bencher| {
            let all = || problems.par_iter().zip(&groups).map(|(problem, rows)| marked(problem, rows)).sum::<usize>();
            bencher.iter(|| black_box(pool.install(all)));
        });
    }
    group.finish();
}

criterion_group!(benches, marking);
criterion_main!(benches);
