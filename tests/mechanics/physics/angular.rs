//! Turning, and systems about their centre of mass, with random numbers: the vectors are worked out here a second time.

use proptest::prelude::*;

use super::scenes::decimal;
use crate::variants::{sheet, solved, value};

/// Gravity where nothing is said, in m/s².
const GRAVITY: f64 = 9.81;
const LETTERS: [&str; 3] = ["x", "y", "z"];

type Vector = [f64; 3];

#[allow(clippy::cast_precision_loss, reason = "it is small")]
fn tenth(value: i64) -> f64 {
    value as f64 / 10.0
}

fn cross([a, b, c]: Vector, [u, v, w]: Vector) -> Vector {
    [b * w - c * v, c * u - a * w, a * v - b * u]
}

fn less(one: Vector, other: Vector) -> Vector {
    [0, 1, 2].map(|axis| one[axis] - other[axis])
}

fn times(factor: f64, vector: Vector) -> Vector {
    vector.map(|part| factor * part)
}

fn square(vector: Vector) -> f64 {
    vector.iter().map(|part| part * part).sum()
}

fn close(one: f64, other: f64) -> Result<(), TestCaseError> {
    prop_assert!((one - other).abs() <= 1e-9 * one.abs().max(other.abs()).max(1.0), "{one} {other}");
    Ok(())
}

fn all_close(one: Vector, other: Vector) -> Result<(), TestCaseError> {
    (0..3).try_for_each(|axis| close(one[axis], other[axis]))
}

fn solve(scene: &str, given: &[(String, String)], ask: &[&str]) -> impl Fn(&str) -> f64 + use<> {
    let given: Vec<(&str, &str)> = given.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
    let (problem, variant) = solved(&sheet(scene, &given, ask));
    move |name| value(&problem, &variant, name).value
}

/// Masses, places and velocities, in tenths of base units.
#[derive(Clone, Debug)]
struct System {
    masses: Vec<i64>,
    places: Vec<[i64; 3]>,
    velocities: Vec<[i64; 3]>,
}

fn systems(count: usize) -> impl Strategy<Value = System> {
    let masses = proptest::collection::vec(1_i64..80, count);
    let vectors = || proptest::collection::vec(proptest::array::uniform3(-60_i64..60), count);
    (masses, vectors(), vectors()).prop_map(|(masses, places, velocities)| System { masses, places, velocities })
}

const NAMES: [&str; 3] = ["A", "B", "C"];

impl System {
    /// With nothing along the third axis.
    fn flat(mut self) -> Self {
        self.places.iter_mut().chain(&mut self.velocities).for_each(|vector| vector[2] = 0);
        self
    }

    fn bodies(&self) -> impl Iterator<Item = (f64, Vector, Vector)> {
        let vectors = |list: &[[i64; 3]]| list.iter().map(|vector| vector.map(tenth)).collect::<Vec<Vector>>();
        let pairs = vectors(&self.places).into_iter().zip(vectors(&self.velocities));
        self.masses.iter().map(|mass| tenth(*mass)).zip(pairs).map(|(mass, (place, velocity))| (mass, place, velocity))
    }

    fn given(&self, axes: usize, small_units: bool) -> Vec<(String, String)> {
        let mut given = Vec::new();
        for (position, name) in NAMES.iter().enumerate().take(self.masses.len()) {
            let (mass, length, speed) = (self.masses[position], self.places[position], self.velocities[position]);
            given.push((
                format!("m_{name}"),
                if small_units { format!("{} g", 100 * mass) } else { format!("{} kg", decimal(mass, 1)) },
            ));
            for axis in 0..axes {
                let letter = LETTERS[axis];
                let (place, velocity) = if small_units {
                    (format!("{} cm", 10 * length[axis]), format!("{} km/h", decimal(36 * speed[axis], 2)))
                } else {
                    (format!("{} m", decimal(length[axis], 1)), format!("{} m/s", decimal(speed[axis], 1)))
                };
                given.push((format!("r_{name}1.{letter}"), place));
                given.push((format!("v_{name}1.{letter}"), velocity));
            }
        }
        given
    }

    fn scene(&self, axes: usize, point: [i64; 3]) -> String {
        let axes = if axes == 3 { "{ x: east, y: north, z: upwards }" } else { "{ x: east, y: north }" };
        let bodies = NAMES[..self.masses.len()].iter().map(|letter| format!("  {letter}: {{ name: body {letter} }}\n"));
        let bodies = bodies.collect::<Vec<_>>().concat();
        let [x, y, z] = point.map(|coordinate| decimal(coordinate, 1));
        let at =
            if axes.contains('z') { format!("x: {x} m, y: {y} m, z: {z} m") } else { format!("x: {x} m, y: {y} m") };
        format!(
            "axes: {axes}\nbodies:\n{bodies}points:\n  O: {{ name: the origin }}\n  P: {{ name: the post, at: {{ {at} }} }}\n"
        )
    }

    fn mass(&self) -> f64 {
        self.bodies().map(|(mass, ..)| mass).sum()
    }

    fn sum(&self, of: impl Fn(f64, Vector, Vector) -> Vector) -> Vector {
        self.bodies()
            .map(|(mass, place, velocity)| of(mass, place, velocity))
            .fold([0.0; 3], |sum, part| [0, 1, 2].map(|axis| sum[axis] + part[axis]))
    }

    /// Angular momentum about a place.
    fn about(&self, centre: Vector) -> Vector {
        self.sum(|mass, place, velocity| times(mass, cross(less(place, centre), velocity)))
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn angular_momentum_in_space_is_the_vector_product(system in systems(2), point in proptest::array::uniform3(-30_i64..30)) {
        let ask = ["H_O1.x", "H_O1.y", "H_O1.z", "H_P1.x", "H_P1.y", "H_P1.z", "magnitude(H_P1)"];
        let found = solve(&system.scene(3, point), &system.given(3, false), &ask);
        let vector = |name: &str| LETTERS.map(|letter| found(&format!("{name}.{letter}")));
        all_close(vector("H_O1"), system.about([0.0; 3]))?;
        let about = system.about(point.map(tenth));
        all_close(vector("H_P1"), about)?;
        close(found("magnitude(H_P1)"), square(about).sqrt())?;
        // From one point to another: H_O = H_P + r_P x p.
        let momentum = system.sum(|mass, _, velocity| times(mass, velocity));
        let moved = cross(point.map(tenth), momentum);
        all_close(less(vector("H_O1"), vector("H_P1")), moved)?;
        let other = solve(&system.scene(3, point), &system.given(3, true), &ask);
        all_close(LETTERS.map(|letter| other(&format!("H_P1.{letter}"))), about)?;
    }

    #[test]
    fn in_a_plane_it_is_the_third_component(system in systems(3), point in proptest::array::uniform3(-30_i64..30)) {
        let (system, point) = (system.flat(), [point[0], point[1], 0]);
        let found = solve(&system.scene(2, point), &system.given(2, false), &["H_O1", "H_P1"]);
        close(found("H_O1"), system.about([0.0; 3])[2])?;
        close(found("H_P1"), system.about(point.map(tenth))[2])?;
    }

    #[test]
    fn koenig_holds(system in systems(3), space in any::<bool>()) {
        let (system, axes) = if space { (system, 3) } else { (system.flat(), 2) };
        let of = |base: &str| LETTERS[..axes].iter().map(|letter| format!("{base}.{letter}")).collect::<Vec<String>>();
        let turning = |base: &str| if space { of(base) } else { vec![base.to_owned()] };
        let names = [of("v_rel_A1"), of("v_rel_B1"), of("v_rel_C1"), turning("H_G1"), vec!["T_1".into(), "T_G1".into(), "T_rel_1".into()]].concat();
        let ask: Vec<&str> = names.iter().map(String::as_str).collect();
        let found = solve(&system.scene(axes, [0; 3]), &system.given(axes, false), &ask);
        let total = system.mass();
        let centre = times(1.0 / total, system.sum(|mass, place, _| times(mass, place)));
        let velocity = times(1.0 / total, system.sum(|mass, _, velocity| times(mass, velocity)));
        close(found("T_1"), found("T_G1") + found("T_rel_1"))?;
        close(found("T_G1"), total / 2.0 * square(velocity))?;
        let relative: f64 = system.bodies().map(|(mass, _, moving)| mass / 2.0 * square(less(moving, velocity))).sum();
        close(found("T_rel_1"), relative)?;
        for (position, letter) in LETTERS[..axes].iter().enumerate() {
            let momentum: f64 = system.bodies().zip(NAMES).map(|((mass, ..), name)| mass * found(&format!("v_rel_{name}1.{letter}"))).sum();
            close(momentum, 0.0)?;
            close(found(&format!("v_rel_A1.{letter}")), tenth(system.velocities[0][position]) - velocity[position])?;
        }
        // The moment of the relative momenta about the centre of mass is the same as that of the momenta.
        let about = system.sum(|mass, place, moving| times(mass, cross(less(place, centre), less(moving, velocity))));
        let turned = if space { LETTERS.map(|letter| found(&format!("H_G1.{letter}"))) } else { [0.0, 0.0, found("H_G1")] };
        all_close(turned, about)?;
    }

    #[test]
    fn the_moment_of_a_force_changes_angular_momentum(system in systems(1), force in proptest::array::uniform3(1_i64..50)) {
        let scene = format!(
            "{}plane: vertical\nstages:\n  - push: {{ body: A, during: 2 s, forces: [ {{ name: the thrust, value: {{ x: F, y: G_y, z: Q }} }} ] }}\n",
            system.scene(3, [0; 3])
        );
        let mut given = system.given(3, false);
        for (name, force) in ["F", "G_y", "Q"].into_iter().zip(force) {
            given.push((name.to_owned(), format!("{} N", decimal(force, 1))));
        }
        let names: Vec<String> = LETTERS.iter().flat_map(|letter| [format!("M_O1.{letter}"), format!("J_A.{letter}"), format!("v_A2.{letter}")]).collect();
        let found = solve(&scene, &given, &names.iter().map(String::as_str).collect::<Vec<_>>());
        let (mass, place, velocity) = system.bodies().next().unwrap();
        let all = less(force.map(tenth), [0.0, 0.0, mass * GRAVITY]);
        all_close(LETTERS.map(|letter| found(&format!("M_O1.{letter}"))), cross(place, all))?;
        let impulse = times(2.0, all);
        all_close(LETTERS.map(|letter| found(&format!("J_A.{letter}"))), impulse)?;
        all_close(less(LETTERS.map(|letter| found(&format!("v_A2.{letter}"))), velocity), times(1.0 / mass, impulse))?;
    }

    #[test]
    fn bodies_on_one_arm_share_its_turning(
        masses in [1_i64..50, 1_i64..50], arms in [1_i64..20, 1_i64..20], inner in 1_i64..20, turn in 1_i64..60, moment in -40_i64..80,
    ) {
        let scene = "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: ball A }\n  B: { name: ball B }\npoints:\n  O: { name: the shaft }\nstages:\n  - rotate: { name: drive, about: O, bodies: { A: a, B: b }, moment: k*t, during: 3 s }\n  - rotate: { name: draw, about: O, bodies: { A: a, B: [b, c] } }";
        let given = [
            ("m_A", format!("{} kg", decimal(masses[0], 1))), ("m_B", format!("{} kg", decimal(masses[1], 1))),
            ("a", format!("{} m", decimal(arms[0], 1))), ("b", format!("{} m", decimal(arms[1], 1))), ("c", format!("{} m", decimal(inner, 1))),
            ("omega_1", format!("{} rad/s", decimal(turn, 1))), ("k", format!("{} N m/s", decimal(moment, 1))),
        ];
        let given: Vec<(String, String)> = given.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
        let found = solve(scene, &given, &["omega_2", "omega_3", "v_B3", "work[drive]", "work[draw]"]);
        let ([m, n], [a, b], c) = (masses.map(tenth), arms.map(tenth), tenth(inner));
        let (wide, narrow) = (m * a * a + n * b * b, m * a * a + n * c * c);
        let middle = tenth(turn) + tenth(moment) * 4.5 / wide;
        close(found("omega_2"), middle)?;
        close(found("omega_3") * narrow, middle * wide)?;
        close(found("v_B3"), c * found("omega_3"))?;
        close(found("work[drive]"), wide / 2.0 * (middle * middle - tenth(turn) * tenth(turn)))?;
        close(found("work[draw]"), (narrow * found("omega_3") * found("omega_3") - wide * middle * middle) / 2.0)?;
    }

    #[test]
    fn a_pellet_and_an_arm_keep_angular_momentum(
        masses in [1_i64..50, 1_i64..20], arm in 1_i64..20, at in 1_i64..20, turn in -30_i64..30, ahead in 1_i64..200, e in 0_i64..=10,
    ) {
        let scene = "axes: { x: [counter-clockwise, clockwise] }\nbodies:\n  A: { name: ball A }\n  P: { name: the pellet }\npoints:\n  O: { name: the shaft }\nstages:\n  - strike: { body: P, about: O, at: b, carries: { A: a }, restitution: e }";
        let before = tenth(at) * tenth(turn) + tenth(ahead);
        let given = [
            ("m_A", format!("{} kg", decimal(masses[0], 1))), ("m_P", format!("{} kg", decimal(masses[1], 1))),
            ("a", format!("{} m", decimal(arm, 1))), ("b", format!("{} m", decimal(at, 1))), ("e", decimal(e, 1)),
            ("omega_1", format!("{} rad/s", decimal(turn, 1))), ("v_P1", format!("{} m/s", decimal(at * turn + 10 * ahead, 2))),
        ];
        let given: Vec<(String, String)> = given.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
        let found = solve(scene, &given, &["omega_2", "v_P2", "T_lost"]);
        let ([m, n], a, b, first, e) = (masses.map(tenth), tenth(arm), tenth(at), tenth(turn), tenth(e));
        let (second, after) = (found("omega_2"), found("v_P2"));
        close(m * a * a * first + n * b * before, m * a * a * second + n * b * after)?;
        close(b * second - after, e * (before - b * first))?;
        let energy = |turn: f64, velocity: f64| m / 2.0 * (a * turn).powi(2) + n / 2.0 * velocity * velocity;
        let lost = energy(first, before) - energy(second, after);
        close(found("T_lost"), lost)?;
        prop_assert!(found("T_lost") >= -1e-9 * lost.abs().max(1.0));
    }

    #[test]
    fn a_smooth_wall_keeps_energy_and_angular_momentum(radius in 20_i64..60, share in 30_i64..95, across in 1_i64..60) {
        let inner = radius * share / 100;
        let scene = "axes: polar\nplane: vertical\nbodies:\n  A: { name: the bead }\npoints:\n  O: { name: the axis }\nstages:\n  - bowl: { body: A, about: O, way: down, sphere: R, horizontal: start }";
        let given = [
            ("R", format!("{} m", decimal(radius, 1))), ("r_A1", format!("{} m", decimal(radius, 1))),
            ("r_A2", format!("{} m", decimal(inner, 1))), ("v_A1.theta", format!("{} m/s", decimal(across, 1))),
        ];
        let given: Vec<(String, String)> = given.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
        let (r, s, v) = (tenth(radius), tenth(inner), tenth(across));
        let depth = (r * r - s * s).sqrt();
        // It gets there only if the energy suffices for the turning.
        prop_assume!(v * v + 2.0 * GRAVITY * depth > 1.01 * (r * v / s).powi(2));
        let found = solve(scene, &given, &["v_A2.theta", "speed_A2", "angle_A2"]);
        close(found("v_A2.theta") * s, v * r)?;
        close(found("speed_A2").powi(2), v * v + 2.0 * GRAVITY * depth)?;
        close(found("speed_A2") * found("angle_A2").cos(), found("v_A2.theta"))?;
    }

    #[test]
    fn a_conical_pendulum_keeps_angular_momentum(length in 10_i64..30, share in 30_i64..150, angle in 5_i64..70) {
        let scene = "axes: { x: [counter-clockwise, clockwise] }\nplane: vertical\nbodies:\n  A: { name: the ball }\npoints:\n  O: { name: the ring }\nstages:\n  - conical: { body: A, about: O, length: [L_1, L_2] }";
        let other = length * share / 100;
        let given = [
            ("m_A", "0.4 kg".to_owned()), ("L_1", format!("{} m", decimal(length, 1))), ("L_2", format!("{} m", decimal(other, 1))),
            ("angle_A1", format!("{angle} deg")),
        ];
        let given: Vec<(String, String)> = given.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
        let given: Vec<(&str, &str)> = given.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
        let text = sheet(scene, &given, &["v_A1", "angle_A2", "v_A2"]).replace("ask:", "where: [ v_A1 > 0 m/s ]\nask:");
        let (problem, variant) = solved(&text);
        let found = |name: &str| value(&problem, &variant, name).value;
        let (one, two) = (tenth(10 * angle).to_radians(), found("angle_A2"));
        close(found("v_A1").powi(2), GRAVITY * tenth(length) * one.sin() * one.tan())?;
        close(found("v_A2").powi(2), GRAVITY * tenth(other) * two.sin() * two.tan())?;
        close(tenth(length) * one.sin() * found("v_A1"), tenth(other) * two.sin() * found("v_A2"))?;
    }
}

#[test]
fn a_scene_in_a_plane_makes_no_third_equation() {
    let system =
        System { masses: vec![10, 20], places: vec![[1, 2, 0], [3, 4, 0]], velocities: vec![[5, 6, 0], [7, 8, 0]] };
    let given = system.given(2, false);
    let given: Vec<(&str, &str)> = given.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
    let ask = ["H_O1", "H_P1", "H_G1", "T_rel_1", "v_G1.x"];
    let (problem, _) = solved(&sheet(&system.scene(2, [1, 1, 0]), &given, &ask));
    let third: Vec<&str> = problem
        .model()
        .symbols
        .iter()
        .map(|(_, entry)| entry.name.as_str())
        .filter(|name| name.contains(".z"))
        .collect();
    assert_eq!(third, Vec::<&str>::new());
}
