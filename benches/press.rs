//! Documents as PDF beside the same documents as HTML: `cargo bench --bench press --features pdf`.

use std::hint::black_box;
use std::sync::Arc;

use criterion::Criterion;
use criterion::criterion_group;
use criterion::criterion_main;
use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::problem::Problem;
use momentous::problem::compile;
use momentous::problem::load;
use momentous::render::Format;
use momentous::render::Page;
use momentous::render::Press;
use momentous::render::Renderer;
use momentous::render::Solution;

/// As in the program, of which this is a part.
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// How many sheets a class has.
const CLASS: usize = 40;

fn problem() -> Option<Arc<Problem>> {
    let bank = Bank::built_in();
    let source = bank.sources().find(|source| source.name.ends_with("impact/two-carts.yaml"))?;
    load(source.clone()).and_then(|loaded| compile(loaded, None)).ok().map(Arc::new)
}

fn solution(exercise: &Exercise) -> Page {
    let (outline, identity) = (exercise.outline(Audience::Everyone, Detail::Short), exercise.identity());
    Page::Solution(Solution { outline, identity, audience: Audience::Everyone, faded: None })
}

/// The rows differ in the format alone. No two documents are the same, so nothing of one is taken for another.
fn documents(criterion: &mut Criterion) {
    let (Some(problem), Ok(renderer), Ok(press)) = (problem(), Renderer::new(None), Press::new(None)) else { return };
    let variants: Vec<Exercise> = (1..=1000).filter_map(|seed| Exercise::draw(&problem, 0, seed).ok()).collect();
    let class: Vec<Page> = variants.iter().take(CLASS).map(|exercise| Page::Sheet(exercise.sheet())).collect();
    let mut group = criterion.benchmark_group("documents");
    group.sample_size(20);
    for (name, format) in [("HTML", Format::Html), ("Typst", Format::Typst), ("PDF", Format::Typst)] {
        let print = |pages: &[Page]| {
            let text =
                renderer.render(black_box(pages), format).map_or_else(|_| String::new(), |document| document.text);
            if name == "PDF" { press.pdf(&text).map_or(0, |pdf| pdf.len()) } else { text.len() }
        };
        let mut next = variants.iter().cycle();
        let mut solved = || next.next().map(solution).into_iter().collect::<Vec<Page>>();
        group.bench_function(format!("a worked solution as {name}"), |bencher| {
            bencher.iter_with_large_drop(|| print(&solved()));
        });
        group.bench_function(format!("{CLASS} sheets as {name}"), |bencher| bencher.iter(|| print(&class)));
    }
    group.finish();
}

criterion_group!(benches, documents);
criterion_main!(benches);
