//! Forces of which a constant is sought, guided bodies, cords and strings.

use super::Case;
use super::check;
use crate::variants::{solved, value};

/// A problem in which one constant of the force is asked, and its answer in SI units.
fn sought(force: &str, given: &str, name: &str, unit: &str) -> f64 {
    let (problem, variant) = solved(&format!(
        "id: test/force\ntitle: A force\nlevel: core\nscene:\n  axes: {{ x: east }}\n  bodies: {{ A: {{ name: the puck }} }}\n  stages: [ {{ push: {{ body: A, during: tau, forces: [ {{ value: \"{force}\" }} ] }} }} ]\ngiven: {{ m_A: 0.2 kg, v_A1: 0 m/s, v_A2: 30 m/s, {given} }}\ntext: \"{{{{ m_A }}}} {{{{ v_A1 }}}} {{{{ v_A2 }}}} {{{{ {} }}}}\"\nask: [ {{ find: {name}, unit: {unit} }} ]\n",
        given.split(':').next().unwrap_or_default()
    ));
    value(&problem, &variant, name).value
}

#[test]
fn the_height_and_the_length_of_half_a_sine_wave() {
    // The area is 2 F tau/pi = m v = 6 N s: with tau = 10 ms F = 300 pi N, and with F = 300 pi N tau = 10 ms.
    let force = "F_m*sin(pi*t/tau)";
    let height = sought(force, "tau: 10 ms", "F_m", "N");
    assert!((height - 300.0 * std::f64::consts::PI).abs() < 1e-9, "{height}");
    let length = sought(force, "F_m: 942.4777960769379 N", "tau", "s");
    assert!((length - 0.01).abs() < 1e-12, "{length}");
}

#[test]
fn the_constant_of_a_force_that_dies_away() {
    // With F_0 exp(-t/s), s = 5 ms, over 10 ms the area is F_0 s (1 - e^-2) = 6 N s.
    let found = sought("F_0*exp(-t/(5 ms))", "tau: 10 ms", "F_0", "N");
    assert!((found - 6.0 / (0.005 * (1.0 - (-2.0_f64).exp()))).abs() < 1e-9, "{found}");
}

#[test]
fn clay_thrown_on_a_block_on_rails() {
    // 1 kg at 10 m/s, 60 degrees below the horizontal, on 4 kg at rest: along the rails 5 = 5 v, v = 1 m/s. The rails stop
    // the vertical 5 sqrt(3) N s, and 50 J - 2.5 J are lost.
    check(&Case {
        scene: "axes: { x: to the right, y: upwards }\nplane: vertical\nbodies:\n  A: { name: the clay }\n  B: { name: the block, guide: { along: x, by: the rails } }\nstages:\n  - impact: { between: [A, B], plastic: true }\n",
        given: &[
            ("m_A", "1 kg"),
            ("m_B", "4 kg"),
            ("speed_A1", "10 m/s"),
            ("angle_A1", "-60 deg"),
            ("v_B1.x", "0 m/s"),
        ],
        more: "",
        answers: &[("v_B2.x", 1.0), ("R_B", 8.660_254), ("T_lost", 47.5), ("J_A.x", -4.0)],
    });
}

#[test]
fn a_load_on_a_movable_pulley() {
    // 6 kg on two strands, 4 kg on one, g = 10 m/s^2: 6 a = 2 T - 60 and 4 (2 a) = 40 - T give a = 10/11 m/s^2 and
    // T = 360/11 N. After 1.1 s the load rises at 1 m/s and the weight sinks at 2 m/s.
    check(&Case {
        scene: "axes: { x: [along, back] }\nbodies:\n  A: { name: the load }\n  B: { name: the weight }\nstages:\n  - connected: { trailing: { body: A, strands: 2 }, leading: { body: B }, duration: dt }\n",
        given: &[("m_A", "6 kg"), ("m_B", "4 kg"), ("g", "10 m/s^2"), ("v_A1", "0 m/s"), ("dt", "1.1 s")],
        more: "",
        answers: &[("v_A2", 1.0), ("v_B2", 2.0), ("tension", 360.0 / 11.0)],
    });
}

#[test]
fn a_weight_on_three_strands_raises_a_load_on_one() {
    // 1 kg on one strand, 6 kg on three: the load moves three times as far. Over 0.5 m of the weight's way the load rises
    // 1.5 m: (6*0.5 - 1*1.5)*10 = 15 J = 6 v^2/2 + (3 v)^2/2 = 7.5 v^2, v^2 = 2 m^2/s^2.
    check(&Case {
        scene: "axes: { x: [along, back] }\nbodies:\n  A: { name: the load }\n  B: { name: the weight }\nstages:\n  - connected: { trailing: { body: A }, leading: { body: B, strands: 3 }, distance: d }\n",
        given: &[("m_A", "1 kg"), ("m_B", "6 kg"), ("g", "10 m/s^2"), ("v_B1", "0 m/s"), ("d", "0.5 m")],
        more: "",
        answers: &[("v_B2", std::f64::consts::SQRT_2), ("v_A2", 3.0 * std::f64::consts::SQRT_2)],
    });
}

#[test]
fn a_string_is_drawn_in_with_a_given_work() {
    // 0.4 kg at 1.2 m/s, 0.5 m from a hole: T_1 = 0.288 J, with 0.9 J more 1.188 J, v = sqrt(2*1.188/0.4) = 2.43721 m/s; m r v
    // stays 0.24: r = 0.6/2.43721 = 0.246183 m.
    check(&Case {
        scene: "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: the puck }\npoints:\n  O: { name: the hole }\nstages:\n  - rotate: { body: A, about: O, arm: [a, b] }\n",
        given: &[("m_A", "0.4 kg"), ("a", "0.5 m"), ("v_A1", "1.2 m/s"), ("work", "0.9 J")],
        more: "",
        answers: &[("b", 0.246_183), ("v_A2", 2.437_21)],
    });
}

#[test]
fn a_pendulum_meets_a_peg() {
    // From 40 deg on 1.2 m: v^2 = 2*10*1.2*(1 - cos 40 deg) = 5.61493, v = 2.36959. On the 0.7 m below the peg: 1 - cos = 5.61493/14
    // = 0.401066, 53.206 deg = 0.928628 rad. Before the peg the tension is 0.5*(10 + v^2/1.2) = 7.33956 N, after it
    // 0.5*(10 + v^2/0.7) = 9.01066 N.
    check(&Case {
        scene: "axes: { x: to the right }\nplane: vertical\nbodies:\n  A: { name: the bob }\nstages:\n  - swing: { name: down, body: A, length: L, from: alpha }\n  - swing: { name: up, body: A, length: L - d }\n",
        given: &[
            ("m_A", "0.5 kg"),
            ("g", "10 m/s^2"),
            ("L", "1.2 m"),
            ("d", "0.5 m"),
            ("alpha", "40 deg"),
            ("v_A1", "0 m/s"),
        ],
        more: "",
        answers: &[
            ("v_A2", 2.369_59),
            ("angle_A3", 0.928_628),
            ("tension_A2[down]", 7.339_56),
            ("tension_A2[up]", 9.010_66),
        ],
    });
}

#[test]
fn a_block_swings_right_round() {
    // 0.1 kg at 80 m/s into 0.9 kg: 8 m/s; at the top of a circle of 0.9 m v^2 = 64 - 4*10*0.9 = 28, tension = 28/0.9 - 10 = 21.1111 N.
    check(&Case {
        scene: "axes: { x: to the right }\nplane: vertical\nbodies:\n  A: { name: the dart }\n  B: { name: the block }\nstages:\n  - impact: { between: [A, B], plastic: true, becomes: C }\n  - swing: { body: C, length: L, to: 180 deg }\n",
        given: &[
            ("m_A", "0.1 kg"),
            ("m_B", "0.9 kg"),
            ("g", "10 m/s^2"),
            ("v_A1", "80 m/s"),
            ("v_B1", "0 m/s"),
            ("L", "0.9 m"),
        ],
        more: "",
        answers: &[("tension_C3", 21.1111)],
    });
}

#[test]
fn a_walk_begins_and_ends_at_rest() {
    // 60 kg walks 4 m along 140 kg: the boat moves back 4*60/200 = 1.2 m, and the walker comes from 3 m to
    // 5.8 m. Then a jump at 2 m/s from the boat: v_B = -2*60/200.
    check(&Case {
        scene: "axes: { x: to the right }\nbodies:\n  P: { name: the walker }\n  B: { name: the boat }\nstages:\n  - walk: { body: P, on: B, distance: L }\n  - separate: { called: jump, into: [B, P], relative: { of: P, to: B, velocity: u } }\n",
        given: &[("m_P", "60 kg"), ("m_B", "140 kg"), ("L", "4 m"), ("u", "2 m/s"), ("x_P1", "3 m")],
        more: "",
        answers: &[("s_B", -1.2), ("x_P2", 5.8), ("v_B3", -0.6), ("T_gained[jump]", 84.0)],
    });
}
