//! The same laws over the variants of the bank, wherever a scene has the stages that they speak of.

use momentous::problem::{Part, PartKind, Problem, Sampler, Variant};
use momentous::quantity::{Decimal, Unit};
use momentous::scene::Stage;
use momentous::scene::stage::Partners;
use proptest::prelude::*;

use crate::variants::{answers, bank, form_name, problem, seeds, sheet, value, value_if_known};

/// Looks at the variants of some seeds of every form of the bank.
fn each_variant(usual: u64, mut look: impl FnMut(&Problem, &Variant, &str)) {
    for problem in bank() {
        for form in 0..problem.forms().len() {
            let mut sampler = Sampler::new(&problem, form).unwrap();
            for seed in 0..seeds(usual) {
                let name = format!("{}, seed {seed}", form_name(&problem, form));
                let variant = sampler.variant(seed).unwrap_or_else(|reason| panic!("{name}: {reason}"));
                look(&problem, &variant, &name);
            }
        }
    }
}

/// Masses and velocities at an instant, where all of them are known: for each body its mass and its components.
fn state(problem: &Problem, variant: &Variant, bodies: &[&str], instant: usize) -> Option<Vec<(f64, Vec<f64>)>> {
    let scene = &problem.loaded().draft.scene;
    let letters: Vec<&str> = scene.axes.rectangular().into_iter().map(|(axis, _)| axis.letter()).collect();
    let of_body = |body: &&str| {
        let mass =
            scene.bodies.get(*body).and_then(|entry| entry.mass.clone()).map_or(format!("m_{body}"), |mass| mass.0);
        let mass = value_if_known(problem, variant, &mass)?.value;
        let component = |letter: &&str| {
            let name = if letters.len() == 1 { String::new() } else { format!(".{letter}") };
            Some(value_if_known(problem, variant, &format!("v_{body}{instant}{name}"))?.value)
        };
        Some((mass, letters.iter().map(component).collect::<Option<Vec<f64>>>()?))
    };
    bodies.iter().map(of_body).collect()
}

#[test]
fn every_impact_of_the_bank_keeps_momentum_and_makes_no_energy() {
    let mut seen = 0;
    each_variant(8, |problem, variant, name| {
        for (index, stage) in problem.loaded().draft.scene.stages.iter().enumerate() {
            let Stage::Impact(impact) = stage else { continue };
            let Some(Partners::Bodies(first, second)) = impact.partners() else { continue };
            let before = state(problem, variant, &[first, second], index + 1);
            let joined: Vec<&str> = impact.becomes.iter().map(String::as_str).collect();
            let bodies = if joined.is_empty() { vec![first, second] } else { joined };
            let after = state(problem, variant, &bodies, index + 2);
            let (Some(before), Some(after)) = (before, after) else { continue };
            seen += 1;
            let momentum = |state: &[(f64, Vec<f64>)], axis: usize| -> f64 {
                state.iter().map(|(mass, velocity)| mass * velocity[axis]).sum()
            };
            let energy = |state: &[(f64, Vec<f64>)]| -> f64 {
                state
                    .iter()
                    .map(|(mass, velocity)| mass / 2.0 * velocity.iter().map(|part| part * part).sum::<f64>())
                    .sum()
            };
            let mass: f64 = before.iter().map(|(mass, _)| mass).sum();
            let most = before
                .iter()
                .chain(&after)
                .flat_map(|(_, velocity)| velocity)
                .fold(0.0, |most: f64, part| most.max(part.abs()));
            // A guide gives an impulse from outside, at right angles to itself, and no energy.
            let scene = &problem.loaded().draft.scene;
            let guided =
                [first, second].iter().any(|body| scene.bodies.get(*body).is_some_and(|body| body.guide.is_some()));
            for axis in (0..before[0].1.len()).filter(|_| !guided) {
                let change = momentum(&after, axis) - momentum(&before, axis);
                assert!(change.abs() <= 1e-12 * mass * most, "{name}: momentum changes by {change}");
            }
            let made = energy(&after) - energy(&before);
            assert!(made <= 1e-12 * mass * most * most, "{name}: {made} J are made");
        }
    });
    assert!(seen > 100, "only {seen} impacts were looked at");
}

#[test]
fn the_bank_does_not_mind_in_which_units_it_is_told() {
    // Powers of ten from the unit of a file to another one.
    const OTHER: &[(&str, &str, i32)] = &[
        ("kg", "g", 3),
        ("g", "kg", -3),
        ("t", "kg", 3),
        ("m/s", "cm/s", 2),
        ("km/h", "m/h", 3),
        ("s", "ms", 3),
        ("ms", "s", -3),
        ("m", "mm", 3),
        ("cm", "m", -2),
        ("N", "kN", -3),
        ("kN", "N", 3),
    ];
    let mut changed = 0;
    each_variant(4, |problem, variant, name| {
        let told: Vec<_> = variant
            .all_given()
            .iter()
            .map(|(symbol, value, unit)| {
                let other = OTHER.iter().find(|(from, ..)| unit.to_string() == *from);
                let Some((_, to, power)) = other else { return (*symbol, value.clone(), unit.clone()) };
                changed += 1;
                (*symbol, Decimal::parse(&format!("{value}e{power}")).unwrap(), Unit::parse(to).unwrap())
            })
            .collect();
        if !problem.forms()[variant.form()].reveal.is_empty() {
            return; // what is revealed was solved from values that are not told
        }
        let is_range = |part: &Part| matches!(part.kind, PartKind::Range(_));
        if problem.forms()[variant.form()].parts.iter().any(is_range) {
            return; // a range is found at both ends of what is asked, which is drawn and not told
        }
        let mut sampler = Sampler::new(problem, variant.form()).unwrap();
        let there =
            sampler.with_values(variant.seed().unwrap(), &told).unwrap_or_else(|reason| panic!("{name}: {reason}"));
        let (here, there) = (answers(problem, variant), answers(problem, &there));
        for (part, answer) in &here {
            let other = there[part];
            assert!(
                (answer.value - other.value).abs() <= answer.error + other.error,
                "{name}, {part}: {answer:?} {other:?}"
            );
        }
    });
    assert!(changed > 200, "only {changed} values were told in other units");
}

const WALL: &str = "\
axes: { x: to the right, y: up }
bodies:
  A: { name: the ball }
surfaces:
  W: { name: the plate, normal: up, velocity: u }
stages:
  - impact: { body: A, against: W, restitution: e }
";

const RANGE: &str = "{ one_of: [-1, 1], unit: m/s }";

const WALL_GIVEN: &[(&str, &str)] = &[
    ("m_A", "{ one_of: [1, 2], unit: kg }"),
    ("v_A1.x", RANGE),
    ("v_A1.y", "{ one_of: [-2, -1], unit: m/s }"),
    ("u", "{ one_of: [0, 1], unit: m/s }"),
    ("e", "{ one_of: [0.1, 0.2] }"),
];

thread_local! {
    static PLATE: Problem = problem("wall.yaml", &sheet(WALL, WALL_GIVEN, &["v_A2.x", "v_A2.y", "J_A"]));
}

/// The velocity after a ball strikes a plate that moves along its normal, and the impulse on it; all in tenths but e, which
/// is in hundredths.
fn strike([x, y, plate]: [i64; 3], mass: i64, e: i64) -> [f64; 3] {
    PLATE.with(|problem| {
        let given = |name: &str, value: i64, shift: u32, unit: &str| {
            let symbol = problem.model().symbol_of(name).unwrap();
            (symbol, Decimal::from_scaled(value, shift), Unit::parse(unit).unwrap())
        };
        let speeds = [("v_A1.x", x), ("v_A1.y", y), ("u", plate)].map(|(name, speed)| given(name, speed, 1, "m/s"));
        let values = [&speeds[..], &[given("m_A", mass, 1, "kg"), given("e", e, 2, "")]].concat();
        let variant = Sampler::new(problem, 0).unwrap().with_values(0, &values).unwrap();
        ["v_A2.x", "v_A2.y", "J_A"].map(|name| value(problem, &variant, name).value)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_moving_observer_sees_walls_move_along(
        x in -200_i64..200, plate in -100_i64..100, approach in 1_i64..300, mass in 1_i64..500, e in 0_i64..=100,
        along in -300_i64..300, across in -300_i64..300,
    ) {
        let y = plate - approach;
        let here = strike([x, y, plate], mass, e);
        let there = strike([x - along, y - across, plate - across], mass, e);
        #[allow(clippy::cast_precision_loss, reason = "they are small")]
        let [along, across, mass, e, approach] = [along, across, mass, 10 * e, approach].map(|tenths| tenths as f64 / 10.0);
        prop_assert!((here[0] - along - there[0]).abs() < 1e-11, "{here:?} {there:?}");
        prop_assert!((here[1] - across - there[1]).abs() < 1e-11, "{here:?} {there:?}");
        // Standing on the plate, the ball comes with `approach` and leaves with e times as much.
        let impulse = mass * (1.0 + e / 100.0) * approach;
        prop_assert!((here[2] - impulse).abs() < 1e-11 * impulse && (there[2] - impulse).abs() < 1e-11 * impulse, "{here:?} {there:?}");
    }
}
