//! The pipeline, step by step, on bank problems: `cargo bench --bench pipeline`.

use std::collections::BTreeMap;
use std::hint::black_box;
use std::process::Command;
use std::sync::Arc;

use criterion::Criterion;
use criterion::criterion_group;
use criterion::criterion_main;
use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::problem::Problem;
use momentous::problem::Sampler;
use momentous::problem::compile;
use momentous::problem::load;
use momentous::render::Format;
use momentous::render::Renderer;
use momentous::render::Solution;

/// As in the program, of which this is a part.
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// The problem of the targets, and the hardest of the bank: turned axes with the most equations to choose among, blocks that
/// refuse to be closed, regimes with the fewest admissible draws.
const PROBLEMS: [&str; 4] =
    ["impact/two-carts", "impact/hockey-pucks", "impact/ball-on-roof", "impulse/crate-ramp-force"];

/// The slowest of the bank to load: the most algebra, the most equations that hold together, the most ways to go.
const SLOWEST: [&str; 5] = [
    "conservation/firework-burst",
    "impact/ball-on-wedge",
    "angular-momentum/roundabout",
    "conservation/cannon-on-carriage",
    "impact/croquet-glance",
];

fn source(id: &str) -> Source {
    let path = format!("{}/problem_bank/{id}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_default();
    Source::new(&path, &text)
}

fn problem(id: &str) -> Arc<Problem> {
    let compiled = load(source(id)).and_then(|loaded| compile(loaded, None));
    match compiled {
        Ok(problem) => Arc::new(problem),
        Err(faults) => panic!("{faults}"),
    }
}

fn file_to_plan(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("file to plan");
    let loads = |source: &Source| load(black_box(source.clone())).and_then(|loaded| compile(loaded, None)).is_ok();
    for id in PROBLEMS.into_iter().chain(SLOWEST) {
        let source = source(id);
        group.bench_function(id, |bencher| bencher.iter(|| loads(&source)));
    }
    let bank = Bank::built_in();
    group.sample_size(10).bench_function("the whole bank", |bencher| {
        bencher.iter(|| bank.sources().filter(|source| loads(source)).count());
    });
    group.finish();
}

fn draw_and_solve(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("draw, solve, certify");
    for id in PROBLEMS {
        let problem = problem(id);
        let asked: Vec<_> = problem.forms()[0].wanted().collect();
        let Ok(mut sampler) = Sampler::new(&problem, 0) else { continue };
        let mut seed = 0;
        group.bench_function(id, |bencher| {
            bencher.iter(|| {
                seed += 1;
                assert!(sampler.draw(seed).is_ok());
                asked.iter().map(|symbol| sampler.answer(*symbol).map_or(0.0, |answer| answer.error)).sum::<f64>()
            });
        });
    }
    group.finish();
}

fn exercise(id: &str) -> Exercise {
    match Exercise::draw(&problem(id), 0, 1) {
        Ok(exercise) => exercise,
        Err(reason) => panic!("{reason}"),
    }
}

fn worked_solution(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("worked solution");
    let Ok(renderer) = Renderer::new(None) else { return };
    for id in [PROBLEMS[0], PROBLEMS[1]] {
        let exercise = exercise(id);
        for format in [Format::Markdown, Format::Html] {
            group.bench_function(format!("{id}, {}", format.name()), |bencher| {
                bencher.iter(|| {
                    let solution = Solution {
                        outline: black_box(&exercise).outline(Audience::Everyone, Detail::Short),
                        identity: exercise.identity(),
                        audience: Audience::Everyone,
                        faded: None,
                    };
                    renderer.render_solution(&solution, format).is_ok()
                });
            });
        }
        group.bench_function(format!("{id}, outline alone"), |bencher| {
            bencher.iter(|| black_box(&exercise).outline(Audience::Everyone, Detail::Short));
        });
    }
    group.finish();
}

fn grade_answers(criterion: &mut Criterion) {
    let exercise = exercise(PROBLEMS[0]);
    let parts = exercise.worked().form.parts.iter();
    let answers: BTreeMap<String, String> = parts.map(|part| (part.id.clone(), exercise.printed(part))).collect();
    criterion.bench_function("grade three answers", |bencher| {
        bencher.iter(|| exercise.grade(black_box(&answers), DecimalMark::Point));
    });
}

fn start_to_end(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("binary");
    group.sample_size(20);
    let generate = ["generate", "impact/two-carts", "--seed", "1"];
    let thousand = [&generate[..2], &["--count", "1000", "--format", "json"]].concat();
    for arguments in [&["--version"][..], &generate, &thousand] {
        group.bench_function(arguments.join(" "), |bencher| {
            bencher.iter(|| {
                Command::new(env!("CARGO_BIN_EXE_momentous")).args(arguments).output().map(|output| output.status)
            });
        });
    }
    group.finish();
}

criterion_group!(pipeline, file_to_plan, draw_and_solve, worked_solution, grade_answers, start_to_end);
criterion_main!(pipeline);
