//! What must be true of bodies that come apart, are guided, or fly, whatever the numbers; each against a calculation by hand.

use momentous::problem::{Problem, Variant};
use proptest::prelude::*;

use crate::variants::{sheet, solved, value};

/// A solved sheet, to be asked for values.
struct Found(Problem, Variant);

impl Found {
    fn new(scene: &str, given: &[(&str, String)], ask: &[&str]) -> Self {
        let given: Vec<(&str, &str)> = given.iter().map(|(name, value)| (*name, value.as_str())).collect();
        let (problem, variant) = solved(&sheet(scene, &given, ask));
        Self(problem, variant)
    }

    fn of(&self, name: &str) -> f64 {
        value(&self.0, &self.1, name).value
    }
}

fn near(one: f64, other: f64, size: f64) -> Result<(), TestCaseError> {
    prop_assert!((one - other).abs() <= 1e-9 * size.max(1.0), "{one} {other}");
    Ok(())
}

const BURST: &str = "
axes: { x: to the right }
bodies: { A: { name: A }, B: { name: B } }
stages:
  - separate: { from: W, into: [A, B], energy: E }
";

const SHOT: &str = "
axes: { x: ahead, y: upwards }
plane: vertical
bodies: { A: { name: the gun, guide: { along: x } }, B: { name: the ball } }
stages:
  - separate: { from: W, into: [A, B], relative: { of: B, to: A, velocity: u, direction: alpha above +x } }
";

const WEDGE: &str = "
axes: { x: to the right, y: upwards }
plane: vertical
bodies: { A: { name: the ball }, B: { name: the wedge, guide: { along: x } } }
stages:
  - impact: { between: [A, B], restitution: e, line_of_impact: beta below +x }
";

const SHELL: &str = "
axes: { x: downwind, y: upwards }
plane: vertical
bodies: { W: { name: the shell }, A: { name: one half }, B: { name: the other half } }
stages:
  - flight: { body: W, until: top }
  - separate: { from: W, into: [A, B] }
  - flight: { bodies: [A, B], during: t_f }
";

/// The velocity of the raft after a jump from it, told relative to what it had before or has after.
fn raft(when: &str, masses: [i64; 2], tenths: [i64; 2]) -> Found {
    let scene = format!(
        "
axes: {{ x: to the right }}
bodies: {{ P: {{ name: P }}, R: {{ name: R }} }}
stages:
  - separate: {{ from: W, into: [P, R], relative: {{ of: P, to: R, velocity: u, when: {when} }} }}
"
    );
    let given = [
        ("m_P", format!("{} kg", masses[0])),
        ("m_R", format!("{} kg", masses[1])),
        ("v_W1", format!("{} m/s", decimal(tenths[0]))),
        ("u", format!("{} m/s", decimal(tenths[1]))),
    ];
    Found::new(&scene, &given, &["v_P2", "v_R2"])
}

fn decimal(tenths: i64) -> String {
    format!("{}{}.{}", if tenths < 0 { "-" } else { "" }, tenths.abs() / 10, tenths.abs() % 10)
}

#[allow(clippy::cast_precision_loss, reason = "whole numbers that are small")]
fn real(value: i64) -> f64 {
    value as f64
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Seen from the centre of mass, the parts share the energy against their masses: the relative speed is sqrt(2 E / reduced mass).
    #[test]
    fn an_explosion_shares_its_energy(a in 1_i64..200, b in 1_i64..200, v in -200_i64..200, energy in 1_i64..5000) {
        let given = [("m_A", format!("{a} kg")), ("m_B", format!("{b} kg")), ("v_W1", format!("{} m/s", decimal(v))), ("E", format!("{energy} J"))];
        let found = Found::new(BURST, &given, &["v_A2", "v_B2"]);
        let (a, b, v, energy) = (real(a), real(b), real(v) / 10.0, real(energy));
        let apart = (2.0 * energy * (a + b) / (a * b)).sqrt();
        near(found.of("v_B2"), v + apart * a / (a + b), apart + v.abs())?;
        near(found.of("v_A2"), v - apart * b / (a + b), apart + v.abs())?;
    }

    #[test]
    fn a_relative_velocity_is_what_is_told(p in 1_i64..200, r in 1_i64..200, v in -50_i64..50, u in -100_i64..100) {
        prop_assume!(u != 0);
        let (mass_p, mass_r, speed, relative) = (real(p), real(r), real(v) / 10.0, real(u) / 10.0);
        for when in ["after", "before"] {
            let found = raft(when, [p, r], [v, u]);
            let (jumper, rest) = (found.of("v_P2"), found.of("v_R2"));
            near(mass_p * jumper + mass_r * rest, (mass_p + mass_r) * speed, 1e3)?;
            near(jumper - if when == "after" { rest } else { speed }, relative, 1e2)?;
        }
    }

    /// What a moving observer sees differs by the observer's velocity, and by nothing else.
    #[test]
    fn a_moving_observer_sees_the_same_jump(p in 1_i64..200, r in 1_i64..200, v in -50_i64..50, moves in -50_i64..50) {
        let (here, there) = (raft("after", [p, r], [v, 25]), raft("after", [p, r], [v - moves, 25]));
        for name in ["v_P2", "v_R2"] {
            near(here.of(name) - real(moves) / 10.0, there.of(name), 1e2)?;
        }
    }

    #[test]
    fn a_guide_takes_what_is_at_right_angles_to_it(gun in 100_i64..2000, ball in 1_i64..40, u in 50_i64..500, turn in 5_i64..80) {
        let given = [
            ("m_A", format!("{gun} kg")), ("m_B", format!("{ball} kg")), ("v_W1.x", "0 m/s".into()),
            ("u", format!("{u} m/s")), ("alpha", format!("{turn} deg")),
        ];
        let found = Found::new(SHOT, &given, &["v_A2.x", "v_B2.x", "v_B2.y", "R_A"]);
        let (gun, ball, u, turn) = (real(gun), real(ball), real(u), real(turn).to_radians());
        near(found.of("v_A2.x"), -ball * u * turn.cos() / (gun + ball), u)?;
        near(found.of("v_A2.y"), 0.0, 1.0)?;
        near(found.of("v_B2.y"), u * turn.sin(), u)?;
        near(found.of("R_A"), ball * u * turn.sin(), ball * u)?;
    }

    /// The contact impulse J = (1 + e) v_n / (1/m + cos^2/M): the wedge gives way along its guide only.
    #[test]
    fn a_guided_wedge_gives_way_along_its_guide(ball in 1_i64..50, wedge in 1_i64..200, speed in 1_i64..100, turn in 10_i64..80, e in 0_i64..=100) {
        let given = [
            ("m_A", format!("{ball} kg")), ("m_B", format!("{wedge} kg")), ("v_A1.x", format!("{} m/s", decimal(speed))), ("v_A1.y", "-1 m/s".into()),
            ("v_B1.x", "0 m/s".into()), ("beta", format!("{turn} deg")), ("e", format!("{}.{:02}", e / 100, e % 100)),
        ];
        let found = Found::new(WEDGE, &given, &["v_A2.x", "v_A2.y", "v_B2.x", "R_B"]);
        let (ball, wedge, speed, turn, e) = (real(ball), real(wedge), real(speed) / 10.0, real(turn).to_radians(), real(e) / 100.0);
        let [x, y] = [turn.cos(), -turn.sin()];
        let approach = speed * x - y;
        let contact = (1.0 + e) * approach / (1.0 / ball + x * x / wedge);
        near(found.of("v_B2.x"), contact * x / wedge, 1e2)?;
        near(found.of("v_A2.x"), speed - contact * x / ball, 1e2)?;
        near(found.of("v_A2.y"), -1.0 - contact * y / ball, 1e2)?;
        near(found.of("R_B"), -contact * y, 1e3)?;
        let energy = |v: [f64; 2], w: f64| ball * (v[0] * v[0] + v[1] * v[1]) / 2.0 + wedge * w * w / 2.0;
        let (before, after) = (energy([speed, -1.0], 0.0), energy([found.of("v_A2.x"), found.of("v_A2.y")], found.of("v_B2.x")));
        prop_assert!(after <= before * (1.0 + 1e-9), "{before} {after}");
    }

    /// The centre of mass goes on as the whole would have done.
    #[test]
    fn a_burst_leaves_the_path_of_the_mass_centre(a in 1_i64..20, b in 1_i64..20, x in 5_i64..40, y in 5_i64..40, kick in [-30_i64..30, -30_i64..30], time in 1_i64..20) {
        let zero = || "0 m".to_owned();
        let given = [
            ("m_A", format!("{a} kg")), ("m_B", format!("{b} kg")), ("r_W1.x", zero()), ("r_W1.y", zero()), ("v_W1.x", format!("{x} m/s")), ("v_W1.y", format!("{y} m/s")),
            ("v_A3.x", format!("{} m/s", kick[0])), ("v_A3.y", format!("{} m/s", kick[1])), ("t_f", format!("{} s", decimal(time))), ("g", "10 m/s^2".into()),
        ];
        let found = Found::new(SHELL, &given, &["r_A4.x", "r_B4.x", "r_A4.y", "r_B4.y", "r_G4.x", "r_G4.y"]);
        let (x, y, late) = (real(x), real(y), real(time) / 10.0);
        let whole = [x * (y / 10.0 + late), y * y / 20.0 - 5.0 * late * late];
        for (letter, expected) in ["x", "y"].into_iter().zip(whole) {
            let [one, other] = ["A", "B"].map(|body| found.of(&format!("r_{body}4.{letter}")));
            near((real(a) * one + real(b) * other) / real(a + b), expected, 1e3)?;
            near(found.of(&format!("r_G4.{letter}")), expected, 1e3)?;
        }
    }
}

/// The ramp gives way with v = sqrt(2 m^2 g h cos^2 / ((m + M)(M + m sin^2))), as every book on mechanics works out.
#[test]
fn a_ramp_on_wheels_gives_way() {
    let scene = "
axes: { x: to the right, y: upwards }
plane: vertical
bodies: { A: { name: the block }, B: { name: the ramp, guide: { along: x } } }
stages:
  - slide_off: { body: A, on: B, height: h, direction: beta below +x }
";
    for (block, ramp, height, turn) in [(2.0, 8.0, 0.5, 30.0), (5.0, 5.0, 1.25, 60.0), (1.0, 100.0, 2.0, 12.0)] {
        let given = [
            ("m_A", format!("{block} kg")),
            ("m_B", format!("{ramp} kg")),
            ("h", format!("{height} m")),
            ("beta", format!("{turn} deg")),
            ("g", "10 m/s^2".into()),
        ];
        let found = Found::new(scene, &given, &["v_A2.x", "v_B2.x", "v_A2.y"]);
        let (sin, cos) = f64::to_radians(turn).sin_cos();
        let square = 2.0 * block * block * 10.0 * height * cos * cos / ((block + ramp) * (ramp + block * sin * sin));
        assert!((found.of("v_B2.x") + square.sqrt()).abs() < 1e-9, "{}", found.of("v_B2.x"));
        assert!((found.of("v_A2.x") * block - square.sqrt() * ramp).abs() < 1e-9);
        assert!(found.of("v_A2.y") < 0.0);
    }
}

#[test]
fn a_walk_leaves_the_mass_centre_where_it_is() {
    let scene = "
axes: { x: to the right }
bodies: { P: { name: the person }, B: { name: the boat } }
stages:
  - walk: { body: P, on: B, distance: L }
";
    let given = [("m_P", "60 kg".to_owned()), ("m_B", "180 kg".to_owned()), ("L", "-4 m".to_owned())];
    let found = Found::new(scene, &given, &["s_P", "s_B"]);
    assert!((found.of("s_P") + 3.0).abs() < 1e-12 && (found.of("s_B") - 1.0).abs() < 1e-12);
}

/// Equal smooth bodies, one of them at rest, part at a right angle where no energy is lost; and the two phases of the impact
/// add up to the whole impulse.
#[test]
fn equal_balls_part_at_a_right_angle() {
    let scene = "
axes: { x: ahead, y: to the left }
bodies: { A: { name: A }, B: { name: B } }
stages:
  - impact: { between: [A, B], restitution: e, line_of_impact: 30 deg above +x }
";
    for (e, right) in [("1", true), ("0.5", false)] {
        let given: Vec<(&str, String)> = [
            ("m_A", "2 kg"),
            ("m_B", "2 kg"),
            ("v_A1.x", "4 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_B1.x", "0 m/s"),
            ("v_B1.y", "0 m/s"),
            ("e", e),
        ]
        .map(|(name, value)| (name, value.to_owned()))
        .into();
        let found = Found::new(scene, &given, &["angle(v_A2, v_B2)", "J_def", "J_rest", "J_B.n", "v_common"]);
        let angle = found.of("angle(v_A2, v_B2)").to_degrees();
        assert_eq!((angle - 90.0).abs() < 1e-9, right, "{angle}");
        assert!((found.of("J_def") + found.of("J_rest") - found.of("J_B.n")).abs() < 1e-12);
        assert!((found.of("v_common") - 3f64.sqrt()).abs() < 1e-12);
    }
}

/// What was caught can be thrown again: a body exists twice, and is a part of another in between.
#[test]
fn a_ball_is_caught_and_thrown_on() {
    let scene = "
axes: { x: to the right }
bodies: { A: { name: the ball }, B: { name: the skater } }
stages:
  - impact: { between: [A, B], plastic: true, becomes: C }
  - separate: { from: C, into: [A, B] }
";
    let given = ["m_A: 1 kg", "m_B: 49 kg", "v_A1: 10 m/s", "v_B1: 0 m/s", "v_A3: -10 m/s"];
    let given: Vec<(&str, String)> =
        given.iter().map(|line| line.split_once(": ").map(|(name, value)| (name, value.to_owned())).unwrap()).collect();
    let found = Found::new(scene, &given, &["v_C2", "v_B3"]);
    assert!((found.of("v_C2") - 0.2).abs() < 1e-12);
    assert!((found.of("v_B3") - 20.0 / 49.0).abs() < 1e-12);
}
