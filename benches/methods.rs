//! How long each numerical method takes on each reference task, and how the cost of the event-driven one grows with bounces, balls and mass ratio.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use momentous::simulate::{
    Body, Budget, EventDriven, Force, IN_THE_PLANE, Keep, Method, MethodKind, ON_A_LINE, RungeKutta, Setting, Task,
    Vector, Wall, World,
};

mod plain;

/// As in the program, of which this is a part.
#[global_allocator]
static MEMORY: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// A ball dropped from 4 m.
fn dropped(restitution: f64) -> World<1> {
    let mut world = World::new(restitution);
    world.gravity = Vector::from([-9.81]);
    world.bodies.push(Body::particle("ball", 1.0, [4.0], [0.0]));
    world.walls.push(Wall::new("floor", [1.0], 0.0));
    world
}

/// A chain of balls between two walls, nothing lost; masses, places and velocities from a linear congruential generator, since a
/// regular sequence makes impacts coincide.
#[allow(clippy::cast_precision_loss, reason = "counts are small")]
fn chain(balls: usize) -> World<1> {
    let mut word = 1_u64;
    let mut draw = || {
        word = word.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (word >> 11) as f64 / 2.0_f64.powi(53)
    };
    let mut world = World::new(1.0);
    for index in 0..balls {
        let (mass, place, velocity) = (0.5 + draw(), index as f64 + 0.3 * draw(), 2.0 * draw() - 1.0);
        world.bodies.push(Body::sphere("ball", mass, 0.1, [place], [velocity]));
    }
    world.walls.push(Wall::new("left", [1.0], -1.0));
    world.walls.push(Wall::new("right", [-1.0], -(balls as f64 + 1.0)));
    world
}

/// Two blocks and a wall.
fn blocks(ratio: f64) -> World<1> {
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("small", 1.0, [1.0], [0.0]));
    world.bodies.push(Body::particle("large", ratio, [2.0], [-1.0]));
    world.walls.push(Wall::new("wall", [1.0], 0.0));
    world
}

/// Every method on a reference task, at a tolerance of 1e-9 or a step of 1 ms, where it does not refuse.
fn task<const D: usize>(criterion: &mut Criterion, task: &Task<D>) {
    let mut group = criterion.benchmark_group(task.name);
    group.sample_size(10).warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_secs(1));
    let case = (task.jittered)(0.0);
    let budget = case.budget.keep(Keep::Impacts);
    for kind in MethodKind::ALL {
        let method = kind.with::<D>(if kind.setting() == Setting::Tolerance { 1e-9 } else { 1e-3 });
        if method.run(&case.world, &budget).is_ok() {
            group.bench_function(method.name(), |bencher| bencher.iter(|| method.run(black_box(&case.world), &budget)));
        }
    }
    group.finish();
}

fn tasks(criterion: &mut Criterion) {
    for own in ON_A_LINE {
        task(criterion, own);
    }
    for own in IN_THE_PLANE {
        task(criterion, own);
    }
}

fn growth(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("event driven");
    group.sample_size(10);
    for bounces in [10, 1_000, 100_000, 10_000_000] {
        let (world, budget) = (dropped(1.0), Budget::impacts(bounces).steps(usize::MAX).keep(Keep::Count));
        group.bench_function(BenchmarkId::new("bounces", bounces), |bencher| {
            bencher.iter(|| EventDriven.run(black_box(&world), &budget));
        });
    }
    for balls in [2, 5, 10, 20, 50, 100, 200] {
        let (world, budget) = (chain(balls), Budget::impacts(100_000).keep(Keep::Count));
        group.bench_function(BenchmarkId::new("100000 impacts in a chain", balls), |bencher| {
            bencher.iter(|| EventDriven.run(black_box(&world), &budget));
        });
    }
    let (world, budget) = (chain(200), Budget::impacts(100_000));
    group.bench_function("100000 impacts in a chain, all of it kept", |bencher| {
        bencher.iter(|| EventDriven.run(black_box(&world), &budget));
    });
    for power in 1..=5 {
        let (world, budget) = (
            blocks(100.0_f64.powi(power)),
            Budget::until(100.0).at_most(usize::MAX).steps(usize::MAX).keep(Keep::Count),
        );
        group.bench_function(BenchmarkId::new("mass ratio 100^n", power), |bencher| {
            bencher.iter(|| EventDriven.run(black_box(&world), &budget));
        });
    }
    group.finish();
}

/// A hundred times round a centre, by the integrator and by a plain loop with the same pair: what events, walls and trajectories cost where
/// there are none.
fn integrator(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("a hundred times round a centre");
    group.sample_size(20);
    let (start, tolerance, until) = ([1.0, 0.0, 0.0, 1.2], 1e-9, 1000.0);
    let mut world = World::new(1.0);
    world.bodies.push(Body::particle("planet", 1.0, [start[0], start[1]], [start[2], start[3]]));
    world.forces.push(Force::Central { body: 0, centre: Vector::zeros(), parameter: 1.0 });
    let (method, budget) = (RungeKutta { tolerance }, Budget::until(until).steps(usize::MAX).keep(Keep::Count));
    group.bench_function("integrator", |bencher| bencher.iter(|| method.run(black_box(&world), &budget)));
    group.bench_function("plain loop", |bencher| bencher.iter(|| plain::run(1.0, black_box(start), until, tolerance)));
    group.finish();
}

criterion_group!(benches, tasks, growth, integrator);
criterion_main!(benches);
