//! Systems of particles, and vectors with three components.

use super::Case;
use super::check;

#[test]
fn two_astronauts_pull_on_a_rope() {
    // 80 kg and 120 kg turn about their centre of mass, 6 m and 4 m from it, with 0.2 rad/s: sum m r^2 = 2880 + 1920 = 4800, H = 960.
    // At half the distances 1200: 0.8 rad/s, work = 960^2/2 (1/1200 - 1/4800) = 384 - 96 = 288 J.
    check(&Case {
        scene: "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: the first astronaut }\n  B: { name: the second astronaut }\npoints:\n  O: { name: their centre of mass }\nstages:\n  - rotate: { about: O, bodies: { A: [6 m, 3 m], B: [4 m, 2 m] } }\n",
        given: &[("m_A", "80 kg"), ("m_B", "120 kg"), ("omega_1", "0.2 rad/s")],
        more: "",
        answers: &[("H_O1", 960.0), ("omega_2", 0.8), ("work", 288.0), ("v_A2", 2.4)],
    });
}

#[test]
fn three_particles_in_space_and_their_mass_centre() {
    // m = 1, 2, 3; r = (0, 3, 0), (1, 0, 2), (2, 1, 0); v = (2, 0, 0), (0, 1, -1), (1, -1, 2).
    // p = (2 + 3, 2 - 3, -2 + 6) = (5, -1, 4); r_G = (8, 6, 4)/6 = (4/3, 1, 2/3).
    // H_O: A (0, 0, -6); B 2 (0*(-1) - 2*1, 2*0 - 1*(-1), 1*1) = (-4, 2, 2); C 3 (1*2, -2*2, 2*(-1) - 1*1) = (6, -12, -9): (2, -10, -13).
    // r_G x p = (1*4 - 2/3*(-1), 2/3*5 - 4/3*4, 4/3*(-1) - 1*5) = (14/3, -2, -19/3). H_G = (-8/3, -8, -20/3).
    // T = 2 + 2 + 9 = 13; T_G = 42/12 = 3.5; T_rel = 9.5.
    check(&Case {
        scene: "axes: { x: east, y: north, z: upwards }\nbodies:\n  A: { name: A }\n  B: { name: B }\n  C: { name: C }\npoints:\n  O: { name: the origin }\n",
        given: &[
            ("m_A", "1 kg"),
            ("m_B", "2 kg"),
            ("m_C", "3 kg"),
            ("r_A1.x", "0 m"),
            ("r_A1.y", "3 m"),
            ("r_A1.z", "0 m"),
            ("r_B1.x", "1 m"),
            ("r_B1.y", "0 m"),
            ("r_B1.z", "2 m"),
            ("r_C1.x", "2 m"),
            ("r_C1.y", "1 m"),
            ("r_C1.z", "0 m"),
            ("v_A1.x", "2 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_A1.z", "0 m/s"),
            ("v_B1.x", "0 m/s"),
            ("v_B1.y", "1 m/s"),
            ("v_B1.z", "-1 m/s"),
            ("v_C1.x", "1 m/s"),
            ("v_C1.y", "-1 m/s"),
            ("v_C1.z", "2 m/s"),
        ],
        more: "",
        answers: &[
            ("p_1.x", 5.0),
            ("p_1.y", -1.0),
            ("p_1.z", 4.0),
            ("r_G1.x", 4.0 / 3.0),
            ("r_G1.y", 1.0),
            ("r_G1.z", 2.0 / 3.0),
            ("H_O1.x", 2.0),
            ("H_O1.y", -10.0),
            ("H_O1.z", -13.0),
            ("H_G1.x", -8.0 / 3.0),
            ("H_G1.y", -8.0),
            ("H_G1.z", -20.0 / 3.0),
            ("T_G1", 3.5),
            ("T_rel_1", 9.5),
        ],
    });
}

#[test]
fn which_velocity_makes_a_component_vanish() {
    // A: 2 kg at (1, 2, 0) with (0, 0, v); B: 1 kg at (0, 3, 1) with (2, 0, 4). H_x = 2 (2v) + (3*4 - 0) = 4v + 12 = 0: v = -3.
    // Then H_y = 2 (0 - 1*(-3)) + (1*2 - 0) = 8, H_z = 0 + (0 - 3*2) = -6.
    check(&Case {
        scene: "axes: { x: east, y: north, z: upwards }\nbodies:\n  A: { name: A }\n  B: { name: B }\npoints:\n  O: { name: the origin }\n",
        given: &[
            ("m_A", "2 kg"),
            ("m_B", "1 kg"),
            ("H_O1.x", "0 kg m^2/s"),
            ("r_A1.x", "1 m"),
            ("r_A1.y", "2 m"),
            ("r_A1.z", "0 m"),
            ("r_B1.x", "0 m"),
            ("r_B1.y", "3 m"),
            ("r_B1.z", "1 m"),
            ("v_A1.x", "0 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_B1.x", "2 m/s"),
            ("v_B1.y", "0 m/s"),
            ("v_B1.z", "4 m/s"),
        ],
        more: "",
        answers: &[("v_A1.z", -3.0), ("H_O1.y", 8.0), ("H_O1.z", -6.0)],
    });
}

#[test]
fn a_probe_comes_apart_in_space() {
    // 60 kg at the origin with (0, 0, 200) m/s into 20, 15 and 25 kg. After 3 s B is at (150, -120, 690), C at (-60, 96, 480).
    // The centre of mass is at (0, 0, 600): 20 x_A = -15*150 + 25*60 = -750, x = -37.5; 20 y = 1800 - 2400, y = -30;
    // 20 z = 36000 - 10350 - 12000 = 13650, z = 682.5. v_A = (-12.5, -10, 227.5).
    check(&Case {
        scene: "axes: { x: east, y: north, z: upwards }\nbodies:\n  A: { name: part A }\n  B: { name: part B }\n  C: { name: part C }\nstages:\n  - separate: { called: burst, from: W, into: [A, B, C] }\n  - flight: { bodies: [A, B, C], during: 3 s }\n",
        given: &[
            ("m_A", "20 kg"),
            ("m_B", "15 kg"),
            ("m_C", "25 kg"),
            ("r_W1.x", "0 m"),
            ("r_W1.y", "0 m"),
            ("r_W1.z", "0 m"),
            ("v_W1.x", "0 m/s"),
            ("v_W1.y", "0 m/s"),
            ("v_W1.z", "200 m/s"),
            ("r_B3.x", "150 m"),
            ("r_B3.y", "-120 m"),
            ("r_B3.z", "690 m"),
            ("r_C3.x", "-60 m"),
            ("r_C3.y", "96 m"),
            ("r_C3.z", "480 m"),
        ],
        more: "",
        answers: &[("r_A3.x", -37.5), ("r_A3.y", -30.0), ("r_A3.z", 682.5), ("v_A2.x", -12.5), ("v_A2.z", 227.5)],
    });
}

#[test]
fn a_plastic_impact_in_space() {
    // 3 kg with (4, 0, 2) and 1 kg with (0, -8, 2) become one: (3, -2, 2), speed sqrt(17) = 4.1231. T: 30 + 34 - 34 = 30 lost.
    check(&Case {
        scene: "axes: { x: east, y: north, z: upwards }\nbodies:\n  A: { name: drone A }\n  B: { name: drone B }\nstages:\n  - impact: { between: [A, B], plastic: true, becomes: C }\n",
        given: &[
            ("m_A", "3 kg"),
            ("m_B", "1 kg"),
            ("v_A1.x", "4 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_A1.z", "2 m/s"),
            ("v_B1.x", "0 m/s"),
            ("v_B1.y", "-8 m/s"),
            ("v_B1.z", "2 m/s"),
        ],
        more: "",
        answers: &[("v_C2.x", 3.0), ("v_C2.y", -2.0), ("v_C2.z", 2.0), ("speed_C2", 4.1231), ("T_lost", 30.0)],
    });
}

#[test]
fn billiards_with_three_balls() {
    // A of 1 kg at (0, 0.5) with (5, 0) scatters two balls at rest. Afterwards B of 1 kg goes along +x with u through (1, 0.2), C of 1 kg
    // along -y with w through (0.8, 0.1), and A along +y with v, through (x, 0). Momentum: u = 5, v = w. Without loss: 25 = 25 + 2 v^2,
    // so let B be lighter: 0.5 kg. Then 0.5 u = 5 -> u = 10, 25/2 < 0.25*100 = 25: impossible; so B weighs 2 kg: u = 2.5,
    // 12.5 = 6.25 + v^2, v = w = 2.5. H_O: -0.5*5 = -2.5 = x*2.5 - 0.2*2*2.5 - 0.8*2.5 = 2.5 x - 3: x = 0.2.
    check(&Case {
        scene: "axes: { x: to the right, y: away from you }\nbodies:\n  A: { name: ball A }\n  B: { name: ball B }\n  C: { name: ball C }\npoints:\n  O: { name: the corner }\nstages:\n  - interact: { between: [A, B, C], elastic: true }\n",
        given: &[
            ("m_A", "1 kg"),
            ("m_B", "2 kg"),
            ("m_C", "1 kg"),
            ("r_A1.x", "0 m"),
            ("r_A1.y", "0.5 m"),
            ("v_A1.x", "5 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_B1.x", "0 m/s"),
            ("v_B1.y", "0 m/s"),
            ("v_C1.x", "0 m/s"),
            ("v_C1.y", "0 m/s"),
            ("r_B1.x", "0.4 m"),
            ("r_B1.y", "0.4 m"),
            ("r_C1.x", "0.8 m"),
            ("r_C1.y", "0.4 m"),
            ("v_A2.x", "0 m/s"),
            ("v_B2.y", "0 m/s"),
            ("v_C2.x", "0 m/s"),
            ("r_A2.y", "0 m"),
            ("r_B2.x", "1 m"),
            ("r_B2.y", "0.2 m"),
            ("r_C2.x", "0.8 m"),
            ("r_C2.y", "0.1 m"),
        ],
        more: "where: [ v_A2.y > 0 m/s ]\n",
        answers: &[("v_B2.x", 2.5), ("v_A2.y", 2.5), ("v_C2.y", -2.5), ("r_A2.x", 0.2)],
    });
}

#[test]
fn two_discs_whose_cord_is_cut() {
    // A: 2 kg at (0, 0.5) with (4, 0); B: 3 kg at (0, 0) with (1, 0). Afterwards A goes with (1, 1) through (2, 0): v_B = ((8 + 3 - 2)/3, -2/3) = (3, -2/3).
    // H: -4 = 2*2*1 - 3*3 y at x = 0: y = 8/9. Lost: 16 + 1.5 - 2/2*2 - 1.5 (9 + 4/9) = 17.5 - 2 - 14.1667 = 1.3333.
    check(&Case {
        scene: "axes: { x: to the right, y: away from you }\nbodies:\n  A: { name: disc A }\n  B: { name: disc B }\npoints:\n  O: { name: the corner }\nstages:\n  - interact: { between: [A, B] }\n",
        given: &[
            ("m_A", "2 kg"),
            ("m_B", "3 kg"),
            ("r_A1.x", "0 m"),
            ("r_A1.y", "0.5 m"),
            ("r_B1.x", "0 m"),
            ("r_B1.y", "0 m"),
            ("v_A1.x", "4 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_B1.x", "1 m/s"),
            ("v_B1.y", "0 m/s"),
            ("v_A2.x", "1 m/s"),
            ("v_A2.y", "1 m/s"),
            ("r_A2.x", "2 m"),
            ("r_A2.y", "0 m"),
            ("r_B2.x", "0 m"),
        ],
        more: "",
        answers: &[("v_B2.x", 3.0), ("v_B2.y", -2.0 / 3.0), ("r_B2.y", 8.0 / 9.0), ("T_lost", 4.0 / 3.0)],
    });
}

#[test]
fn an_angular_impulse_in_space_given_by_its_moment() {
    // H = (1, 2, 3), M = (2t, -4, 0) for 3 s: (1 + 9, 2 - 12, 3), magnitude sqrt(209) = 14.457.
    check(&Case {
        scene: "axes: { x: east, y: north, z: upwards }\nbodies:\n  A: { name: the gyro }\npoints:\n  O: { name: the pivot }\nstages:\n  - moment: { about: O, value: { x: k*t, y: -4 N m }, during: 3 s }\n",
        given: &[("k", "2 N m/s"), ("H_O1.x", "1 N m s"), ("H_O1.y", "2 N m s"), ("H_O1.z", "3 N m s")],
        more: "",
        answers: &[("H_O2.x", 10.0), ("H_O2.y", -10.0), ("H_O2.z", 3.0), ("magnitude(H_O2)", 14.457)],
    });
}

#[test]
fn a_moment_about_the_mass_centre_of_two_pucks() {
    // 1 kg each, 0.4 m apart on the x axis, sliding with (3, 0) both: H_G = 0. A moment of 0.2 N m for 2 s gives H_G = 0.4.
    check(&Case {
        scene: "axes: { x: to the right, y: away from you }\nbodies:\n  A: { name: puck A }\n  B: { name: puck B }\nstages:\n  - moment: { about: G, value: M, during: 2 s }\n",
        given: &[
            ("M", "0.2 N m"),
            ("m_A", "1 kg"),
            ("m_B", "1 kg"),
            ("r_A1.x", "0 m"),
            ("r_A1.y", "0 m"),
            ("r_B1.x", "0.4 m"),
            ("r_B1.y", "0 m"),
            ("v_A1.x", "3 m/s"),
            ("v_A1.y", "0 m/s"),
            ("v_B1.x", "3 m/s"),
            ("v_B1.y", "0 m/s"),
        ],
        more: "",
        answers: &[("H_G2", 0.4)],
    });
}

#[test]
fn a_system_by_its_mass_centre_alone() {
    // Masses 2 and 4 kg, the centre of mass at (2, 1) with (3, -1), H_G = 5: H_O = 6 (2*(-1) - 1*3) + 5 = -25.
    check(&Case {
        scene: "axes: { x: east, y: north }\nbodies:\n  A: { name: A }\n  B: { name: B }\npoints:\n  O: { name: the origin }\n",
        given: &[
            ("m_A", "2 kg"),
            ("m_B", "4 kg"),
            ("r_G1.x", "2 m"),
            ("r_G1.y", "1 m"),
            ("v_G1.x", "3 m/s"),
            ("v_G1.y", "-1 m/s"),
            ("H_G1", "5 kg m^2/s"),
        ],
        more: "",
        answers: &[("H_O1", -25.0)],
    });
}

#[test]
fn a_toboggan_down_a_banked_spiral() {
    // From 60 m from the axis at 5 m/s, horizontally, down 20 m to 40 m: v_theta = 7.5, speed = sqrt(25 + 392.4) = 20.430,
    // angle = acos(7.5/20.430) = 68.462 deg = 1.19489 rad.
    check(&Case {
        scene: "axes: polar\nplane: vertical\nbodies:\n  A: { name: the toboggan }\npoints:\n  O: { name: the axis }\nstages:\n  - bowl: { body: A, about: O, way: down, height: 20 m, horizontal: start }\n",
        given: &[("r_A1", "60 m"), ("r_A2", "40 m"), ("v_A1.theta", "5 m/s")],
        more: "",
        answers: &[("v_A2.theta", 7.5), ("speed_A2", 20.430), ("angle_A2", 1.19489)],
    });
}
