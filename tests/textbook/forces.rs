//! Forces of which a constant is sought, and an impact on a body that is guided.

use super::Case;
use super::check;
use super::variants::{solved, value};

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
