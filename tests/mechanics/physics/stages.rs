//! Swings, slides, springs and strings with random numbers: what is balanced, whatever the numbers, the units and the side.

use momentous::problem::Worked;
use proptest::prelude::*;

use super::scenes::decimal;
use crate::variants::{sheet, solved, value};

/// Gravity where nothing is said, in m/s².
const GRAVITY: f64 = 9.81;

const LINE: &str = "axes: { x: to the right }\nbodies:\n  A: { name: block A }\n  B: { name: block B }\nstages:\n";
const ALONE: &str = "axes: { x: to the right }\nbodies:\n  A: { name: block A }\nstages:\n";

/// What is found of some names, in base units.
pub fn find<const N: usize>(scene: &str, given: &[(&str, String)], ask: [&str; N]) -> [f64; N] {
    let given: Vec<(&str, &str)> = given.iter().map(|(name, value)| (*name, value.as_str())).collect();
    let (problem, variant) = solved(&sheet(scene, &given, &ask));
    ask.map(|name| value(&problem, &variant, name).value)
}

fn kilograms(tenths: i64) -> String {
    format!("{} kg", decimal(tenths, 1))
}

fn grams(tenths: i64) -> String {
    format!("{} g", 100 * tenths)
}

fn metres_per_second(tenths: i64) -> String {
    format!("{} m/s", decimal(tenths, 1))
}

fn kilometres_per_hour(tenths: i64) -> String {
    format!("{} km/h", decimal(36 * tenths, 2))
}

#[allow(clippy::cast_precision_loss, reason = "it is small")]
pub fn tenth(value: i64) -> f64 {
    value as f64 / 10.0
}

pub fn close(one: f64, other: f64) -> Result<(), TestCaseError> {
    prop_assert!((one - other).abs() <= 1e-9 * one.abs().max(other.abs()).max(1.0), "{one} {other}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_swing_keeps_its_energy(mass in 1_i64..100, length in 1_i64..50, angle in 1_i64..90) {
        let scene = "axes: { x: to the right }\nplane: vertical\nbodies:\n  A: { name: bob A }\nstages:\n  - swing: { body: A, length: L, from: alpha }";
        let given = [("m_A", kilograms(mass)), ("L", format!("{} m", decimal(length, 1))), ("alpha", format!("{angle} deg")), ("v_A1", "0 m/s".into())];
        let [speed, tension] = find(scene, &given, ["v_A2", "tension_A2"]);
        let height = tenth(length) * (1.0 - tenth(10 * angle).to_radians().cos());
        close(speed * speed / 2.0, GRAVITY * height)?;
        close(tension, tenth(mass) * (GRAVITY + speed * speed / tenth(length)))?;
    }

    #[test]
    fn a_spring_stores_what_the_body_loses(mass in 1_i64..100, stiffness in 50_i64..5000, speed in 1_i64..80) {
        let solve = |direction: &str, sign: i64, metric: bool| {
            let scene = format!("{ALONE}  - spring: {{ body: A, stiffness: k, to: s, direction: {direction}, until: rest }}");
            let (mass, speed) = if metric { (kilograms(mass), metres_per_second(sign * speed)) } else { (grams(mass), kilometres_per_hour(sign * speed)) };
            find(&scene, &[("m_A", mass), ("v_A1", speed), ("k", format!("{stiffness} N/m"))], ["s"])[0]
        };
        let pressed = solve("to the right", 1, true);
        close(tenth(10 * stiffness) * pressed * pressed, tenth(mass) * tenth(speed) * tenth(speed))?;
        close(pressed, solve("to the right", 1, false))?;
        close(pressed, solve("to the left", -1, true))?;
    }

    #[test]
    fn a_spring_between_bodies_keeps_momentum_and_energy(
        masses in [1_i64..100, 1_i64..100], ahead in -40_i64..40, nearing in 1_i64..60, stiffness in 50_i64..5000,
    ) {
        let scene = format!("{LINE}  - spring: {{ between: [A, B], stiffness: k, to: s, until: rest }}");
        let (one, other) = (tenth(ahead + nearing), tenth(ahead));
        let given = [
            ("m_A", kilograms(masses[0])), ("m_B", kilograms(masses[1])), ("k", format!("{stiffness} N/m")),
            ("v_A1", metres_per_second(ahead + nearing)), ("v_B1", metres_per_second(ahead)),
        ];
        let [a, b, pressed] = find(&scene, &given, ["v_A2", "v_B2", "s"]);
        let [m, n] = masses.map(tenth);
        close(a, b)?;
        close(m * one + n * other, m * a + n * b)?;
        let stored = tenth(10 * stiffness) * pressed * pressed;
        close(m * one * one + n * other * other, m * a * a + n * b * b + stored)?;
    }

    #[test]
    fn friction_takes_what_a_slide_loses(mass in 1_i64..100, speed in 40_i64..100, friction in 1_i64..40, way in 1_i64..15) {
        let solve = |direction: &str, sign: i64, metric: bool| {
            let scene = format!("{ALONE}  - slide: {{ body: A, friction: mu, distance: d, direction: {direction} }}");
            let (mass, speed) = if metric { (kilograms(mass), metres_per_second(sign * speed)) } else { (grams(mass), kilometres_per_hour(sign * speed)) };
            let given = [("m_A", mass), ("v_A1", speed), ("mu", decimal(friction, 2)), ("d", format!("{} m", decimal(way, 1)))];
            find(&scene, &given, ["v_A2", "T_A1", "T_A2"])
        };
        let [after, first, last] = solve("to the right", 1, true);
        let work = tenth(friction) / 10.0 * tenth(mass) * GRAVITY * tenth(way);
        close(first - last, work)?;
        let [other, ..] = solve("to the right", 1, false);
        close(after, other)?;
        let [mirrored, ..] = solve("to the left", -1, true);
        close(after, -mirrored)?;
    }

    #[test]
    fn a_jerk_keeps_momentum_and_creates_no_energy(masses in [1_i64..100, 1_i64..100], behind in -40_i64..40, parting in 1_i64..60) {
        let scene = format!("{LINE}  - taut: {{ between: [A, B] }}");
        let solve = |mass: &dyn Fn(i64) -> String, speed: &dyn Fn(i64) -> String| {
            let given = [
                ("m_A", mass(masses[0])), ("m_B", mass(masses[1])),
                ("v_A1", speed(behind)), ("v_B1", speed(behind + parting)),
            ];
            find(&scene, &given, ["v_A2", "v_B2", "J_A", "T_lost"])
        };
        let [a, b, impulse, lost] = solve(&kilograms, &metres_per_second);
        let ([m, n], one, other) = (masses.map(tenth), tenth(behind), tenth(behind + parting));
        close(a, b)?;
        close(m * one + n * other, m * a + n * b)?;
        close(impulse, m * (a - one))?;
        close(lost, (m * one * one + n * other * other - m * a * a - n * b * b) / 2.0)?;
        prop_assert!(lost >= 0.0);
        close(a, solve(&grams, &kilometres_per_hour)[0])?;
    }

    #[test]
    fn the_pulley_turns_the_momentum_of_connected_bodies(masses in [1_i64..50, 50_i64..100], time in 1_i64..20) {
        let scene = "axes: { x: [along the string, back along the string] }\nbodies:\n  A: { name: block A }\n  B: { name: block B }\nstages:\n  - connected: { trailing: { body: A }, leading: { body: B }, duration: dt }";
        let given = [
            ("m_A", kilograms(masses[0])), ("m_B", kilograms(masses[1])),
            ("v_A1", "0 m/s".into()), ("v_B1", "0 m/s".into()), ("dt", format!("{} s", decimal(time, 1))),
        ];
        let [a, b, tension] = find(scene, &given, ["v_A2", "v_B2", "tension"]);
        let ([m, n], time) = (masses.map(tenth), tenth(time));
        close(a, b)?;
        // Along the string the weights act against each other; on the pulley both ends of the string pull down.
        close((n - m) * GRAVITY * time, m * a + n * b)?;
        close(((m + n) * GRAVITY - 2.0 * tension) * time, n * b - m * a)?;
    }
}

/// Whether the kinetic energy of A lasts through a stage.
fn keeps_energy(plane: &str, stage: &str, given: &str, of: &str) -> (String, String) {
    let text = format!(
        "id: test/kept\ntitle: Kept\nlevel: core\nscene:\n  axes: {{ x: to the right }}\n  plane: {plane}\n  bodies:\n    A: {{ name: block A }}\n    B: {{ name: block B }}\n  stages:\n    - {stage}\ngiven: {{ {given} }}\ntext: Something moves.\nask:\n  - {{ conserved: energy, of: [{of}] }}\n"
    );
    let (problem, variant) = solved(&text);
    let momentous::problem::PartKind::Choice(choice) = &problem.forms()[0].parts[0].kind else {
        panic!("a question of yes or no");
    };
    let decision = choice.decided(&Worked::new(&problem, &variant).unwrap());
    (decision.options[decision.right].clone(), decision.because.clone())
}

#[test]
fn whether_kinetic_energy_lasts_is_told_with_what_does_work() {
    let rows = [
        ("vertical", "swing: { body: A, length: 1 m }", "m_A: 1 kg, v_A1: 1 m/s", "A", "no", "weight"),
        (
            "horizontal",
            "slide: { body: A, friction: 0.2, duration: 1 s }",
            "m_A: 1 kg, v_A1: 5 m/s",
            "A",
            "no",
            "friction",
        ),
        ("horizontal", "slide: { body: A, duration: 1 s }", "m_A: 1 kg, v_A1: 5 m/s", "A", "yes", "no force does work"),
        (
            "horizontal",
            "slide: { body: A, incline: 20 deg above +x, duration: 1 s }",
            "m_A: 1 kg, v_A1: 5 m/s",
            "A",
            "no",
            "weight",
        ),
        (
            "horizontal",
            "spring: { between: [A, B], stiffness: 9 N/m, from: 1 m }",
            "m_A: 1 kg, m_B: 1 kg, v_A1: 0 m/s, v_B1: 0 m/s",
            "A, B",
            "no",
            "spring",
        ),
        (
            "horizontal",
            "taut: { between: [A, B] }",
            "m_A: 1 kg, m_B: 1 kg, v_A1: 0 m/s, v_B1: 1 m/s",
            "A, B",
            "no",
            "inelastically",
        ),
    ];
    for (plane, stage, given, of, answer, reason) in rows {
        let (found, because) = keeps_energy(plane, stage, given, of);
        assert_eq!(found, answer, "{stage}: {because}");
        assert!(because.contains(reason), "{stage}: {because}");
    }
}
