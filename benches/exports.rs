//! What an export costs beside the records of the same variants: `cargo bench --bench exports`.

use std::hint::black_box;
use std::io;
use std::sync::Arc;

use criterion::Criterion;
use criterion::Throughput;
use criterion::criterion_group;
use criterion::criterion_main;
use momentous::bank::Bank;
use momentous::exercise::Drawer;
use momentous::export::Question;
use momentous::export::TARGETS;
use momentous::problem::compile;
use momentous::problem::load;

/// As in the program, of which this is a part.
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// The variants of each export.
const VARIANTS: u64 = 1000;

fn exports(criterion: &mut Criterion) {
    let source = Bank::built_in().find("impact/two-carts").cloned();
    let Ok(problem) = source.and_then(load).and_then(|loaded| compile(loaded, None)) else { return };
    let problem = Arc::new(problem);
    let mut group = criterion.benchmark_group("two carts");
    group.sample_size(10).throughput(Throughput::Elements(VARIANTS));
    group.bench_function("json", |bencher| {
        bencher.iter(|| {
            let Ok(mut drawer) = Drawer::new(&problem, 0) else { return 0 };
            let records = (0..VARIANTS).filter_map(|seed| Some(drawer.draw(seed).ok()?.record(None)));
            records.filter_map(|record| serde_json::to_string(&record).ok()).map(|json| black_box(json).len()).sum()
        });
    });
    for target in TARGETS {
        group.bench_function(target.name, |bencher| {
            bencher.iter(|| {
                let Ok(mut drawer) = Drawer::new(&problem, 0) else { return };
                let Ok(mut file) = target.begin(Box::new(io::sink()), target.markup[0], "") else { return };
                for seed in 0..VARIANTS {
                    let Ok(exercise) = drawer.draw(seed) else { return };
                    let item = exercise.item();
                    let Ok(()) = file.write(&Question::new(&item)) else { return };
                }
                black_box(file.finish().is_ok());
            });
        });
    }
    group.finish();
}

criterion_group!(benches, exports);
criterion_main!(benches);
