//! Problems of the kinds that the chapters on angular momentum and on systems of particles of dynamics courses hold, with
//! numbers of our own. Each answer was worked out by hand, as the comment beside it says, in SI units.

mod forces;
mod systems;

use crate::variants::{sheet, solved, value};

/// A problem with fixed numbers, and its answers with four figures.
struct Case {
    scene: &'static str,
    given: &'static [(&'static str, &'static str)],
    /// What is added to the file, such as `where`.
    more: &'static str,
    answers: &'static [(&'static str, f64)],
}

fn check(case: &Case) {
    let ask: Vec<&str> = case.answers.iter().map(|(name, _)| *name).collect();
    let text = sheet(case.scene, case.given, &ask).replace("\nask:", &format!("\n{}ask:", case.more));
    let (problem, variant) = solved(&text);
    for (name, expected) in case.answers {
        let found = value(&problem, &variant, name).value;
        let off = (found - expected).abs();
        assert!(off <= 5e-4 * expected.abs().max(1e-6), "{name} is {found}, by hand {expected}\n{text}");
    }
}

#[test]
fn a_particle_in_space_and_a_force_on_it() {
    // r = (3, -1, 2), v = (2, 4, -1), m = 0.5: r x v = ((-1)(-1) - 2*4, 2*2 - 3*(-1), 3*4 - (-1)*2) = (-7, 7, 14), H = (-3.5, 3.5, 7).
    // F = (0, 6, -3): r x F = ((-1)(-3) - 2*6, 2*0 - 3*(-3), 3*6 - 0) = (-9, 9, 18), |M| = 9 sqrt(6) = 22.045.
    // About P = (1, 0, 2): r - r_P = (2, -1, 0); its product with v = ((-1)(-1) - 0, 0 - 2*(-1), 2*4 + 2) = (1, 2, 10), H_P = (0.5, 1, 5).
    check(&Case {
        scene: "axes: { x: ahead, y: [to port, to starboard], z: upwards }\nbodies:\n  A: { name: the probe, mass: m }\npoints:\n  O: { name: the beacon }\n  P: { name: the relay, at: { x: 1 m, z: 2 m } }\nstages:\n  - push: { body: A, during: dt, forces: [ { name: the thrust, value: { y: F, z: -3 N } } ] }\n",
        given: &[
            ("m", "0.5 kg"),
            ("F", "6 N"),
            ("r_A1.x", "3 m"),
            ("r_A1.y", "-1 m"),
            ("r_A1.z", "2 m"),
            ("v_A1.x", "2 m/s"),
            ("v_A1.y", "4 m/s"),
            ("v_A1.z", "-1 m/s"),
        ],
        more: "",
        answers: &[
            ("H_O1.x", -3.5),
            ("H_O1.y", 3.5),
            ("H_O1.z", 7.0),
            ("H_P1.x", 0.5),
            ("H_P1.y", 1.0),
            ("H_P1.z", 5.0),
            ("H_rate_O1.x", -9.0),
            ("H_rate_O1.y", 9.0),
            ("H_rate_O1.z", 18.0),
            ("magnitude(M_O1)", 22.045),
        ],
    });
}

#[test]
fn a_force_vector_that_changes_with_time() {
    // F = (4t, 6, -3t^2) N on 2 kg for 2 s, from rest at v = (0, 0, 5): J = (8, 12, -8), v = (4, 6, 5 - 4) = (4, 6, 1),
    // speed = sqrt(16 + 36 + 1) = 7.2801, angle to +z = acos(1/7.2801) = 82.105 deg = 1.43300 rad.
    check(&Case {
        scene: "axes: { x: ahead, y: [to port, to starboard], z: upwards }\nbodies:\n  A: { name: the drone, mass: m }\nstages:\n  - push: { body: A, during: 2 s, forces: [ { name: the thrust, value: { x: a*t, y: b, z: -c*t^2 } } ] }\n",
        given: &[
            ("m", "2 kg"),
            ("a", "4 N/s"),
            ("b", "6 N"),
            ("c", "3 N/s^2"),
            ("v_A1.x", "0 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_A1.z", "5 m/s"),
        ],
        more: "",
        answers: &[
            ("J_A.x", 8.0),
            ("J_A.z", -8.0),
            ("v_A2.x", 4.0),
            ("v_A2.y", 6.0),
            ("v_A2.z", 1.0),
            ("speed_A2", 7.2801),
            ("angle(v_A2, +z)", 1.43300),
        ],
    });
}

#[test]
fn a_blow_in_space() {
    // 0.4 kg from (10, 0, -2) to (-6, 8, 4): J = 0.4 (-16, 8, 6) = (-6.4, 3.2, 2.4), |J| = 0.4 sqrt(356) = 7.5472;
    // over 20 ms an average force of 377.36 N.
    check(&Case {
        scene: "axes: { x: ahead, y: [to the left, to the right], z: upwards }\nbodies:\n  A: { name: the ball, mass: m }\nstages:\n  - blow: { body: A, by: the bat, duration: 20 ms }\n",
        given: &[
            ("m", "0.4 kg"),
            ("v_A1.x", "10 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_A1.z", "-2 m/s"),
            ("v_A2.x", "-6 m/s"),
            ("v_A2.y", "8 m/s"),
            ("v_A2.z", "4 m/s"),
        ],
        more: "",
        answers: &[("J_A.x", -6.4), ("J_A.y", 3.2), ("J_A.z", 2.4), ("J_A", 7.5472), ("F_avg_A", 377.36)],
    });
}

#[test]
fn four_spheres_on_a_cross_and_a_moment() {
    // Two of 3 kg at 0.5 m and two of 2 kg at 0.3 m: sum m r^2 = 1.5 + 0.36 = 1.86. M = 4 + 3t for 2 s: 8 + 6 = 14.
    // omega = 14/1.86 = 7.5269; the outer spheres move at 3.7634, T = 14^2/(2*1.86) = 52.688.
    check(&Case {
        scene: "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: sphere A, mass: m }\n  B: { name: sphere B, mass: m }\n  C: { name: sphere C, mass: n }\n  D: { name: sphere D, mass: n }\npoints:\n  O: { name: the shaft }\nstages:\n  - rotate: { about: O, bodies: { A: a, B: a, C: b, D: b }, moment: M_0 + k*t, during: 2 s }\n",
        given: &[
            ("m", "3 kg"),
            ("n", "2 kg"),
            ("a", "0.5 m"),
            ("b", "0.3 m"),
            ("M_0", "4 N m"),
            ("k", "3 N m/s"),
            ("omega_1", "0 rad/s"),
        ],
        more: "",
        answers: &[("omega_2", 7.5269), ("v_A2", 3.7634), ("T_2", 52.688), ("work", 52.688)],
    });
}

#[test]
fn how_long_a_brake_takes() {
    // 5 kg at 0.6 m with 12 rad/s: H = 5*0.36*12 = 21.6; a moment of -3 N m stops it in 7.2 s.
    check(&Case {
        scene: "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: the block }\npoints:\n  O: { name: the post }\nstages:\n  - rotate: { body: A, about: O, arm: L, moment: -M, during: dt }\n",
        given: &[("m_A", "5 kg"), ("L", "0.6 m"), ("M", "3 N m"), ("omega_A1", "12 rad/s"), ("v_A2", "0 m/s")],
        more: "",
        answers: &[("H_O1", 21.6), ("dt", 7.2)],
    });
}

#[test]
fn a_ball_is_drawn_in_on_its_cord() {
    // Weight 8 lb, from 3 ft at 4 ft/s to 1.5 ft: v = 8 ft/s = 2.4384 m/s. Work = (8/32.2)/2 (64 - 16) = 5.9627 ft lb = 8.0843 J.
    check(&Case {
        scene: "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: the ball }\npoints:\n  O: { name: the hole }\nstages:\n  - rotate: { body: A, about: O, arm: [a, b] }\n",
        given: &[("W_A", "8 lb"), ("g", "32.2 ft/s^2"), ("a", "3 ft"), ("b", "1.5 ft"), ("v_A1", "4 ft/s")],
        more: "",
        answers: &[("v_A2", 2.4384), ("work", 8.0843)],
    });
}

#[test]
fn a_ball_whose_cord_is_drawn_in_at_a_steady_rate() {
    // From 0.6 m at 3 m/s to 0.4 m while drawn in at 2 m/s: v_theta = 4.5, speed = sqrt(20.25 + 4) = 4.9244.
    // Work on 0.8 kg: 0.4 (24.25 - 9) = 6.1 J.
    check(&Case {
        scene: "axes: polar\nbodies:\n  A: { name: the ball }\npoints:\n  O: { name: the hole }\nstages:\n  - central: { body: A, about: O }\n",
        given: &[
            ("m_A", "0.8 kg"),
            ("r_A1", "0.6 m"),
            ("r_A2", "0.4 m"),
            ("v_A1.theta", "3 m/s"),
            ("v_A1.r", "0 m/s"),
            ("v_A2.r", "-2 m/s"),
        ],
        more: "",
        answers: &[("v_A2.theta", 4.5), ("speed_A2", 4.9244), ("work", 6.1)],
    });
}

#[test]
fn a_ball_on_an_elastic_cord() {
    // 0.6 kg, k = 150 N/m, unstretched 0.5 m; at 0.9 m with 4 m/s across: energy = 4.8 + 75*0.16 = 16.8 J. At 0.6 m: v_theta = 6,
    // 16.8 = 0.3 v^2 + 75*0.01, v^2 = 53.5, v = 7.3144, v_r = -sqrt(53.5 - 36) = -4.1833.
    check(&Case {
        scene: "axes: polar\nbodies:\n  A: { name: the ball }\npoints:\n  O: { name: the nail }\nstages:\n  - central: { body: A, about: O, spring: { stiffness: k, unstretched: l } }\n",
        given: &[
            ("m_A", "0.6 kg"),
            ("k", "150 N/m"),
            ("l", "0.5 m"),
            ("r_A1", "0.9 m"),
            ("r_A2", "0.6 m"),
            ("v_A1.theta", "4 m/s"),
            ("v_A1.r", "0 m/s"),
        ],
        more: "where: [ v_A2.r < 0 m/s ]\n",
        answers: &[("v_A2.theta", 6.0), ("speed_A2", 7.3144), ("v_A2.r", -4.1833)],
    });
}

#[test]
fn a_bead_sent_off_at_the_rim_of_a_bowl() {
    // Radius 0.8 m, at 3 m/s along the rim; 0.5 m below it: r = sqrt(0.64 - 0.25) = 0.62450, v_theta = 2.4/0.62450 = 3.8431,
    // speed = sqrt(9 + 9.81) = 4.3370, angle = acos(3.8431/4.3370) = 27.614 deg = 0.48196 rad.
    check(&Case {
        scene: "axes: polar\nplane: vertical\nbodies:\n  A: { name: the bead }\npoints:\n  O: { name: the axis }\nstages:\n  - bowl: { body: A, about: O, way: down, height: 0.5 m, sphere: R, horizontal: start }\n",
        given: &[("R", "0.8 m"), ("r_A1", "0.8 m"), ("v_A1.theta", "3 m/s")],
        more: "",
        answers: &[("r_A2", 0.62450), ("v_A2.theta", 3.8431), ("speed_A2", 4.3370), ("angle_A2", 0.48196)],
    });
}

#[test]
fn the_highest_level_in_a_cone() {
    // 45 degrees, 0.2 m from the axis at 2 m/s, horizontally: v^2 (r + x) = 2 g x^2: 4 (0.2 + x) = 19.62 x^2,
    // x = (4 + sqrt(16 + 62.784))/39.24 = 0.32814; the height is 0.12814, the speed there 0.4/0.32814 = 1.2190.
    check(&Case {
        scene: "axes: polar\nplane: vertical\nbodies:\n  A: { name: the marble }\npoints:\n  O: { name: the axis }\nstages:\n  - bowl: { body: A, about: O, way: up, cone: 45 deg, horizontal: both }\n",
        given: &[("r_A1", "0.2 m"), ("v_A1.theta", "2 m/s")],
        more: "",
        answers: &[("r_A2", 0.32814), ("h_A", 0.12814), ("speed_A2", 1.2190)],
    });
}

#[test]
fn a_conical_pendulum_is_shortened() {
    // 30 degrees, 0.8 m to 0.4 m: (0.8)^3 sin^3 30 tan 30 = 0.064*0.57735 = 0.036950 = 0.064 sin^3 tan, so sin^3 tan = 0.57735,
    // at 50.948 degrees: sin = 0.77655, sin^3 = 0.46829, tan = 1.23289. Speed = sqrt(9.81*0.4*0.77655*1.23289) = 1.9382.
    check(&Case {
        scene: "axes: { x: [counter-clockwise, clockwise] }\nplane: vertical\nbodies:\n  A: { name: the ball }\npoints:\n  O: { name: the tube }\nstages:\n  - conical: { body: A, about: O, length: [0.8 m, 0.4 m] }\n",
        given: &[("m_A", "0.5 kg"), ("angle_A1", "30 deg")],
        more: "where: [ v_A1 > 0 m/s ]\n",
        answers: &[("angle_A2", 0.88921), ("v_A2", 1.9382)],
    });
}

#[test]
fn clay_strikes_a_rod_with_two_spheres() {
    // 0.2 kg at 15 m/s strikes 0.5 m out; spheres of 1 kg at 0.5 m and of 2 kg at 0.3 m, at rest: H = 1.5.
    // sum m r^2 = 0.25 + 0.18 + 0.05 = 0.48, omega = 3.125; lost: 22.5 - 1.5^2/0.96 = 22.5 - 2.34375 = 20.156.
    check(&Case {
        scene: "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: sphere A }\n  B: { name: sphere B }\n  P: { name: the clay }\npoints:\n  O: { name: the pin }\nstages:\n  - strike: { body: P, about: O, at: 0.5 m, carries: { A: 0.5 m, B: 0.3 m }, plastic: true }\n",
        given: &[("m_A", "1 kg"), ("m_B", "2 kg"), ("m_P", "0.2 kg"), ("omega_1", "0 rad/s"), ("v_P1", "15 m/s")],
        more: "",
        answers: &[("omega_2", 3.125), ("v_P2", 1.5625), ("T_lost", 20.156)],
    });
}

#[test]
fn a_ball_bounces_off_a_turning_arm() {
    // 0.3 kg at 8 m/s meets, 0.4 m out, an arm with 1.2 kg at 0.6 m that comes against it with -2 rad/s; e = 0.5.
    // H = 0.3*0.4*8 + 0.432*(-2) = 0.96 - 0.864 = 0.096 = 0.12 v + 0.432 w; 0.4 w - v = 0.5 (8 + 0.8) = 4.4.
    // 0.096 = 0.12 (0.4 w - 4.4) + 0.432 w = 0.48 w - 0.528: w = 1.3, v = -3.88.
    check(&Case {
        scene: "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: the weight }\n  P: { name: the ball }\npoints:\n  O: { name: the pin }\nstages:\n  - strike: { body: P, about: O, at: 0.4 m, carries: { A: 0.6 m }, restitution: 0.5 }\n",
        given: &[("m_A", "1.2 kg"), ("m_P", "0.3 kg"), ("omega_1", "-2 rad/s"), ("v_P1", "8 m/s")],
        more: "",
        answers: &[("omega_2", 1.3), ("v_P2", -3.88)],
    });
}
