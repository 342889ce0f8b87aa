//! A hunt for new failures: random chains, extreme mass ratios, every coefficient, near-simultaneous and grazing impacts.
//! No panic, no hang, no gain of energy, and nobody passes through anybody by the event-driven method.

use momentous::simulate::stability::every_method;
use momentous::simulate::{
    Body, Budget, Contact, EventDriven, Keep, Method, Refusal, Trajectory, Vector, Wall, World, direct_impact,
};
use proptest::prelude::*;

fn mass() -> impl Strategy<Value = f64> {
    (-12.0..12.0_f64).prop_map(|power| 10.0_f64.powf(power))
}

fn restitution() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(1.0), 0.0..=1.0_f64, (1.0..15.0_f64).prop_map(|power| 1.0 - 10.0_f64.powf(-power))]
}

/// Gaps that are ordinary, or so small that impacts nearly coincide, or none.
fn gap() -> impl Strategy<Value = f64> {
    prop_oneof![0.1..2.0_f64, (-15.0..-1.0_f64).prop_map(|power| 10.0_f64.powf(power)), Just(0.0)]
}

fn chain() -> impl Strategy<Value = World<1>> {
    let bead = (mass(), gap(), -5.0..5.0_f64, 0.0..0.5_f64);
    (restitution(), proptest::collection::vec(bead, 2..8), any::<bool>(), any::<bool>()).prop_map(
        |(restitution, beads, walls, falls)| {
            let mut world = World::new(restitution);
            let mut place = 0.0;
            for (index, (mass, gap, velocity, radius)) in beads.into_iter().enumerate() {
                place += gap + radius;
                world.bodies.push(Body::sphere(&index.to_string(), mass, radius, [place], [velocity]));
                place += radius;
            }
            if walls {
                world.walls.push(Wall::new("left", [1.0], 0.0));
                world.walls.push(Wall::new("right", [-1.0], -(place + 1.0)));
            }
            if falls {
                world.gravity = Vector::from([-9.81]);
            }
            world
        },
    )
}

/// The energy of a state, weight included.
fn energy<const D: usize>(world: &World<D>, positions: &[Vector<D>], velocities: &[Vector<D>]) -> f64 {
    let height = |(body, place): (&Body<D>, &Vector<D>)| -body.mass * world.gravity.dot(place);
    world.kinetic_energy(velocities) + world.bodies.iter().zip(positions).map(height).sum::<f64>()
}

fn check<const D: usize>(world: &World<D>, run: &Trajectory<D>) -> Result<(), TestCaseError> {
    let start = world.start();
    let (before, after) =
        (energy(world, &start.positions, &start.velocities), energy(world, &run.last.positions, &run.last.velocities));
    let scale = world.kinetic_energy(&start.velocities) + before.abs() + after.abs();
    prop_assert!(after - before <= 1e-9 * scale, "energy from {before} to {after}");
    for contact in world.contacts() {
        if D > 1 && matches!(contact, Contact::Bodies(..)) {
            continue;
        }
        let gap = world.gap(contact, &run.last);
        let reach = run.last.positions.iter().map(Vector::amax).fold(1.0, f64::max);
        prop_assert!(gap >= -1e-9 * reach, "{}: {gap}", world.name_of(contact));
    }
    for impact in &run.impacts {
        prop_assert!(impact.energy_lost >= -1e-12 * impact.energy_before, "{impact:?}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn chains_gain_no_energy_and_nobody_passes(world in chain()) {
        let budget = Budget::until(3.0).at_most(2_000).steps(2_000);
        match EventDriven.run(&world, &budget) {
            Ok(run) => check(&world, &run)?,
            Err(refusal) => prop_assert!(matches!(
                refusal,
                Refusal::LawRequired { .. } | Refusal::Collapse { .. } | Refusal::LastingContact { .. } | Refusal::Breakdown { .. }
            ), "{refusal}"),
        }
    }

    #[test]
    fn one_impact_keeps_momentum_and_restitution(
        m1 in mass(), m2 in mass(), v1 in -5.0..5.0_f64, v2 in -5.0..5.0_f64, e in restitution()
    ) {
        let [w1, w2] = direct_impact([m1, m2], [v1, v2], e);
        let momentum = m1 * (w1 - v1) + m2 * (w2 - v2);
        prop_assert!(momentum.abs() <= 1e-14 * (m1 + m2) * (v1.abs() + v2.abs()));
        prop_assert!((w2 - w1 + e * (v2 - v1)).abs() <= 1e-14 * (v1.abs() + v2.abs()));
    }

    /// Two discs that graze: the struck one leaves at cos = sqrt(d (2 - d)), however small d is.
    #[test]
    fn grazing_discs(power in 1_i32..50) {
        let d = 2.0_f64.powi(-power);
        let mut world = World::<2>::new(1.0);
        world.bodies.push(Body::sphere("A", 1.0, 0.5, [-1.5, 0.0], [1.0, 0.0]));
        world.bodies.push(Body::sphere("B", 1.0, 0.5, [0.0, 1.0 - d], [0.0, 0.0]));
        let run = EventDriven.run(&world, &Budget::until(4.0)).unwrap();
        let cosine = (d * (2.0 - d)).sqrt();
        prop_assert!((run.last.velocities[1].norm() / cosine - 1.0).abs() < 1e-13);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    /// Every method ends, with finite numbers or a name.
    #[test]
    fn no_method_hangs_or_panics(world in chain()) {
        let budget = Budget::until(1.0).at_most(300).steps(1000);
        for method in every_method(1e-2, 1e-8) {
            if let Ok(run) = method.run(&world, &budget) {
                prop_assert!(run.last.positions.iter().all(|place| place.x.is_finite()), "{}", method.name());
                prop_assert!(run.steps <= 1001);
            }
        }
    }
}

/// The impacts of a block that is `100^n` times as heavy as another with it and a wall: the digits of pi (Galperin).
const GALPERIN: [u64; 8] = [3, 31, 314, 3141, 31_415, 314_159, 3_141_592, 31_415_926];

/// The order of the impacts is forced, so the law alone decides: the energy must not drift while 31 million impacts turn a block
/// 10^14 times as heavy round.
#[test]
fn galperin_through_seven_digits() {
    for (power, expected) in (0..).zip(GALPERIN) {
        let heavy = 100.0_f64.powi(power);
        let (mut small, mut large) = (0.0, -1.0);
        let mut count = 0;
        loop {
            if small > large {
                [small, large] = direct_impact([1.0, heavy], [small, large], 1.0);
            } else if small < 0.0 {
                small = -small;
            } else {
                break;
            }
            count += 1;
        }
        let energy = (small * small + heavy * large * large) / heavy;
        assert_eq!(count, expected, "10^{power}");
        assert!((energy - 1.0).abs() < 1e-10, "10^{power}: {energy}");
    }
}

/// The same by the event-driven method, which has to find when each impact happens as well.
fn galperin_event_by_event(powers: core::ops::Range<usize>) {
    for power in powers {
        let heavy = 100.0_f64.powi(i32::try_from(power).unwrap());
        let mut world = World::<1>::new(1.0);
        world.bodies.push(Body::particle("small", 1.0, [1.0], [0.0]));
        world.bodies.push(Body::particle("large", heavy, [2.0], [-1.0]));
        world.walls.push(Wall::new("wall", [1.0], 0.0));
        let budget = Budget::until(100.0).at_most(usize::MAX).steps(usize::MAX).keep(Keep::Count);
        let run = EventDriven.run(&world, &budget).unwrap();
        let drift = world.kinetic_energy(&run.last.velocities) / (heavy / 2.0) - 1.0;
        assert_eq!(u64::try_from(run.impact_count), Ok(GALPERIN[power]), "10^{power}");
        assert!(drift.abs() < 1e-10, "10^{power}: {drift:e}");
    }
}

#[test]
fn galperin_event_by_event_through_four_digits() {
    galperin_event_by_event(0..5);
}

#[test]
#[ignore = "35 million impacts: cargo test --release --test mechanics hunt -- --ignored"]
fn galperin_event_by_event_through_seven_digits() {
    galperin_event_by_event(5..8);
}

/// A drop from 4 m with the number nearest to e = 1 - 1e-6: when the millionth bounce is and how high it goes, from 50 digits.
#[test]
#[ignore = "a million impacts: cargo test --release --test mechanics hunt -- --ignored"]
fn a_million_bounces_one_by_one() {
    let mut world = World::<1>::new(1.0 - 1e-6);
    world.gravity = Vector::from([-9.81]);
    world.bodies.push(Body::particle("ball", 1.0, [4.0], [0.0]));
    world.walls.push(Wall::new("floor", [1.0], 0.0));
    let budget = Budget::impacts(1_000_000).keep(Keep::Count);
    let run = EventDriven.run(&world, &budget).unwrap();
    assert!((run.last.time / 1_141_668.934_208_483_5 - 1.0).abs() < 1e-12, "{}", run.last.time);
    let rises = run.last.velocities[0].x.powi(2) / (2.0 * 9.81);
    assert!((rises / 0.541_340_591_574_094_3 - 1.0).abs() < 1e-11, "{rises}");
}
