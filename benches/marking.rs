//! Marking at scale, and its worst cases: `cargo bench --bench marking`. The mix is that of `benches/mix`.

use std::hint::black_box;
use std::sync::Arc;

use criterion::Criterion;
use criterion::Throughput;
use criterion::criterion_group;
use criterion::criterion_main;
use momentous::exercise::Drawer;
use momentous::exercise::Marker;
use momentous::expr::Expr;
use momentous::expr::SymbolEntry;
use momentous::expr::SymbolTable;
use momentous::grade::Answer;
use momentous::grade::DecimalMark;
use momentous::grade::Expected;
use momentous::grade::ExpectedFormula;
use momentous::grade::ExpectedKind;
use momentous::grade::ExpectedNumber;
use momentous::grade::Sitting;
use momentous::grade::judge;
use momentous::grade::read;
use momentous::problem::Problem;
use momentous::quantity::Dimension;
use momentous::quantity::Unit;
use rayon::prelude::*;

/// As in the program, of which this is a part.
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;

mod mix;

/// Submissions, grouped by problem.
const SUBMISSIONS: u64 = 10_000;
/// What a core takes at a time, so that none of them waits long for the others.
const PORTION: usize = 100;

struct Row {
    seed: u64,
    answers: Vec<(String, String)>,
}

/// Draws and marks one after the other; how many parts are right.
fn marked(problem: &Arc<Problem>, marker: &Marker, rows: &[Row]) -> usize {
    let Ok(mut drawer) = Drawer::new(problem, 0) else { return 0 };
    let mut marker = marker.clone();
    let reports = rows.iter().filter_map(|row| {
        let answers: Vec<(&str, &str)> = row.answers.iter().map(|(id, text)| (id.as_str(), text.as_str())).collect();
        let exercise = drawer.draw(row.seed).ok()?;
        Some(marker.mark(exercise.worked(), &answers, Sitting::default()))
    });
    reports.map(|report| report.parts.iter().filter(|part| part.verdict.is_right()).count()).sum()
}

fn marking(criterion: &mut Criterion) {
    let problems: Vec<Arc<Problem>> = mix::PROBLEMS.iter().map(|id| mix::problem(id)).collect();
    let markers: Vec<Marker> = problems.iter().filter_map(|own| Marker::new(own, 0, DecimalMark::Point).ok()).collect();
    let mut groups: Vec<Vec<Row>> = mix::PROBLEMS.iter().map(|_| Vec::new()).collect();
    let mut answers = 0;
    for submission in mix::submissions(&problems, 0, SUBMISSIONS) {
        answers += submission.answers.len() as u64;
        groups[submission.problem].push(Row { seed: submission.seed, answers: submission.answers });
    }
    let mut group = criterion.benchmark_group("marking");
    group.sample_size(10).throughput(Throughput::Elements(answers));
    for cores in [1, 2] {
        let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(cores).build() else { continue };
        group.bench_function(format!("answers, {cores} cores"), |bencher| {
            let portions = |((problem, marker), rows): ((_, _), &Vec<Row>)| {
                rows.par_chunks(PORTION).map(|rows| marked(problem, marker, rows)).sum::<usize>()
            };
            let all = || problems.par_iter().zip(&markers).zip(&groups).map(portions).sum::<usize>();
            bencher.iter(|| black_box(pool.install(all)));
        });
    }
    group.finish();
}

/// Texts that were made to take long. Each is repeated to ten thousand characters, and cut to the longest that is read.
const HOSTILE: [(&str, &str); 8] = [
    ("digits", "9"),
    ("brackets", "("),
    ("powers", "9^9"),
    ("powers of powers", "9^999/7^999+"),
    ("roots", "sqrt(2)*"),
    ("words", "left "),
    ("unknown units", "m kgm/ssq "),
    ("signs of LaTeX", "\\cdot{"),
];

fn reading(criterion: &mut Criterion) {
    let unit = Unit::parse("m/s").unwrap_or_default();
    let senses = Some(["to the right".to_owned(), "to the left".to_owned()]);
    let asked = ExpectedKind::Number(ExpectedNumber { senses, ..ExpectedNumber::new(1.0, unit) });
    let mut group = criterion.benchmark_group("reading");
    group.sample_size(10);
    for (name, text) in HOSTILE {
        for length in [10_000, 200] {
            let text: String = text.chars().cycle().take(length).collect();
            group.bench_function(format!("{name}, {length} characters"), |bencher| {
                bencher.iter(|| black_box(read(&text, &asked, DecimalMark::Point).is_ok()));
            });
        }
    }
    group.finish();
}

/// Formulas of about two hundred parts that equal `a + b`, so that no point tells them apart.
fn formulas(criterion: &mut Criterion) {
    let mut symbols = SymbolTable::default();
    let entry = |name: &str| SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() };
    let [a, b, asked] = ["a", "b", "x"].map(|name| symbols.intern(entry(name)));
    let formula = Expr::from(a) + Expr::from(b);
    let domain = vec![(a, 1.0, 3.0), (b, 2.0, 5.0)];
    let expected = ExpectedFormula::new(formula, Arc::new(symbols), asked, domain);
    let part = Expected { id: "x".to_owned(), points: 1, kind: ExpectedKind::Formula(expected) };
    let hostile = [
        ("a sum", format!("a + b{}", "+a-a".repeat(47))),
        ("nested fractions", format!("{}a + b{}", "1/(1/(".repeat(10), "))".repeat(10))),
        ("powers of sums", format!("(a + b)^12/(a + b)^11{}", "*(a+b)/(b+a)".repeat(22))),
        ("sines", format!("a + b{}", "+sin(a*b)-sin(b*a)".repeat(4))),
    ];
    let mut group = criterion.benchmark_group("formulas");
    group.sample_size(10);
    for (name, text) in hostile {
        let Ok(answer) = read(&text, &part.kind, DecimalMark::Point) else { continue };
        group.bench_function(name, |bencher| bencher.iter(|| black_box(judge(&part, &answer))));
    }
    group.finish();
}

/// A formula that is typed often, and costly ones as far as they are read; each is judged anew, for without samples none is remembered.
fn typed_formulas(criterion: &mut Criterion) {
    let arcs = "atan(x^(1/11))+atan(1/(x^(1/11)))-pi/2+";
    let arc_sum = format!("{}x", arcs.repeat(2));
    let sum = format!("x{}", "+x-x".repeat(49));
    let rows = [
        ("typical", "m*v/(m + M)", "m v/(M + m)"),
        ("typical, an arc", "atan(v_y/v_x)", "arcsin(v_y/sqrt(v_x^2 + v_y^2))"),
        ("arcs and roots of degree 11", "x", arc_sum.as_str()),
        ("200 parts", "x", sum.as_str()),
    ];
    let mut group = criterion.benchmark_group("typed formulas");
    group.sample_size(20);
    for (name, right, answer) in rows {
        let mut symbols = SymbolTable::default();
        let entry = |name: &str| SymbolEntry { name: name.into(), dimension: Dimension::NONE, meaning: String::new() };
        let domain: Vec<_> =
            ["m", "M", "v", "v_x", "v_y", "x"].map(|name| (symbols.intern(entry(name)), 1.0, 3.0)).to_vec();
        let asked = symbols.intern(entry("Q_asked"));
        let blank = ExpectedFormula::new(Expr::one(), Arc::new(symbols), asked, domain);
        let kind = ExpectedKind::Formula(blank.clone());
        let Ok(Answer::Formula(right)) = read(right, &kind, DecimalMark::Point) else { continue };
        let kind = ExpectedKind::Formula(ExpectedFormula { formula: right.formula, ..blank });
        let part = Expected { id: "Q".to_owned(), points: 1, kind };
        assert!(read(answer, &part.kind, DecimalMark::Point).is_ok(), "{name} is not read");
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                let answer = read(answer, &part.kind, DecimalMark::Point);
                black_box(answer.map(|answer| judge(&part, &answer)))
            });
        });
    }
    group.finish();
}

criterion_group!(benches, marking, reading, formulas, typed_formulas);
criterion_main!(benches);
