//! What must be true of every impact, whatever the numbers: momentum, energy, observers, units, mirrors, extremes.

mod angular;
mod bank;
mod motions;
mod scenes;
mod stages;
mod streams;

use proptest::prelude::*;

use scenes::{Impact, Kind, impacts};

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn momentum_is_balanced_and_no_energy_created(impact in impacts()) {
        let after = impact.solve();
        for axis in 0..impact.axes() {
            let [before, now] = [&impact.velocities(), &after.velocities]
                .map(|pair| impact.mass(0) * pair[0][axis] + impact.mass(1) * pair[1][axis]);
            let size = impact.mass(0) * impact.fastest() + impact.mass(1) * impact.fastest();
            prop_assert!((before - now).abs() <= 1e-12 * size, "{before} {now}");
            // The impulse on each body is its change of momentum.
            for body in 0..2 {
                let change = impact.mass(body) * (after.velocities[body][axis] - impact.velocities()[body][axis]);
                let given = after.impulses[body][axis];
                prop_assert!((change - given).abs() <= 1e-12 * size, "{change} {given}");
            }
        }
        let (before, now) = (impact.energy(&impact.velocities()), impact.energy(&after.velocities));
        prop_assert!(after.lost.value >= -after.lost.error, "{:?}", after.lost);
        prop_assert!((before - now - after.lost.value).abs() <= 1e-12 * before + after.lost.error);
    }

    #[test]
    fn a_moving_observer_sees_the_same_impact(impact in impacts(), along in -300_i64..300, across in -300_i64..300) {
        let seen = impact.seen_from([along, across]);
        let (here, there) = (impact.solve(), seen.solve());
        same(&here.velocities, &there.velocities, if impact.plane { [along, across] } else { [along, 0] })?;
        prop_assert!((here.lost.value - there.lost.value).abs() <= 1e-12 * here.lost.value.abs() + here.lost.error + there.lost.error);
        for body in 0..2 {
            for axis in 0..impact.axes() {
                let (one, other) = (here.impulses[body][axis], there.impulses[body][axis]);
                prop_assert!((one - other).abs() <= 1e-11 * impact.mass(0) * impact.fastest().max(60.0));
            }
        }
    }

    #[test]
    fn units_do_not_matter(impact in impacts()) {
        let metric = impact.solve();
        let other = Impact { small_units: true, ..impact.clone() }.solve();
        same(&metric.velocities, &other.velocities, [0, 0])?;
        prop_assert!((metric.lost.value - other.lost.value).abs() <= metric.lost.error + other.lost.error);
    }

    #[test]
    fn a_mirror_only_turns_things_round(impact in impacts()) {
        let here = impact.solve();
        for axis in 0..impact.axes() {
            let there = impact.mirrored(axis).solve();
            let mut turned = there.velocities;
            for velocity in &mut turned {
                velocity[axis] *= -1.0;
            }
            same(&here.velocities, &turned, [0, 0])?;
            prop_assert!((here.lost.value - there.lost.value).abs() <= here.lost.error + there.lost.error);
        }
    }

    #[test]
    fn it_does_not_matter_who_is_called_first(impact in impacts()) {
        let (here, there) = (impact.solve(), impact.exchanged().solve());
        same(&here.velocities, &[there.velocities[1], there.velocities[0]], [0, 0])?;
    }

    #[test]
    fn the_extremes_of_restitution(impact in impacts()) {
        prop_assume!(impact.kind == Kind::Separate);
        let [cos, sin] = impact.normal();
        let along = |velocity: [f64; 2]| cos * velocity[0] + sin * velocity[1];
        let across = |velocity: [f64; 2]| cos * velocity[1] - sin * velocity[0];
        let fastest = impact.fastest();
        for (e, kept) in [(0, false), (100, true)] {
            let impact = Impact { e, ..impact.clone() };
            let after = impact.solve();
            let [a, b] = after.velocities;
            if kept {
                prop_assert!(after.lost.value.abs() <= after.lost.error, "{:?}", after.lost);
            } else {
                prop_assert!((along(a) - along(b)).abs() <= 1e-12 * fastest, "{} {}", along(a), along(b));
            }
            for (body, velocity) in [a, b].into_iter().enumerate() {
                let before = across(impact.velocities()[body]);
                prop_assert!((across(velocity) - before).abs() <= 1e-12 * fastest);
            }
        }
    }

    #[test]
    fn what_is_asked_backwards_is_what_was_given(impact in impacts()) {
        prop_assume!(impact.kind == Kind::Separate && (5..=95).contains(&impact.e));
        let after = impact.solve();
        for name in impact.backwards() {
            let (found, given) = impact.ask_back(name, &after);
            if !impact.lets_find(name) {
                prop_assert!(found.error.is_infinite(), "{name} cannot follow: {found:?}\n{}", impact.text());
                continue;
            }
            let size = given.abs().max(0.05);
            prop_assert!((found.value - given).abs() <= 1e-7 * size, "{name}: {found:?}, not {given}\n{}", impact.text());
        }
    }
}

fn same(one: &[[f64; 2]; 2], other: &[[f64; 2]; 2], moved: [i64; 2]) -> Result<(), TestCaseError> {
    for (one, other) in one.iter().zip(other) {
        for axis in 0..2 {
            #[allow(clippy::cast_precision_loss, reason = "it is small")]
            let seen = one[axis] - moved[axis] as f64 / 10.0;
            let size = one[axis].abs().max(other[axis].abs()).max(20.0);
            prop_assert!((seen - other[axis]).abs() <= 1e-12 * size, "{one:?} {other:?}");
        }
    }
    Ok(())
}
