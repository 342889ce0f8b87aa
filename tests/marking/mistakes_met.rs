//! Usual mistakes as students made them in problems of the bank: which one is named first.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::problem::{compile, load};

/// The mistakes that are named for an answer to a form of a problem with these values.
fn named(path: &str, form: usize, set: &[(&str, &str)], part: &str, answer: &str) -> Vec<&'static str> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("problem_bank").join(path);
    let text = std::fs::read_to_string(path).expect("the problem is there");
    let loaded = load(Source::new("test.yaml", &text)).unwrap_or_else(|faults| panic!("{faults}"));
    let problem = Arc::new(compile(loaded, None).unwrap_or_else(|faults| panic!("{faults}")));
    let set: Vec<(String, String)> =
        set.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
    let exercise = Exercise::with_values(&problem, form, 1, &set, &[]).unwrap_or_else(|faults| panic!("{faults}"));
    let report = exercise.grade(&BTreeMap::from([(part.to_owned(), answer.to_owned())]), DecimalMark::Point);
    let own = report.parts.iter().find(|own| own.id == part).expect("the part is asked");
    own.diagnosis.as_ref().map(|own| own.codes.clone()).unwrap_or_default()
}

/// The trailer forgotten: 80/3.6 - 44000 * 3/17000 = 14.46 m/s, 52.0 km/h, and 52.1 km/h after rounding. Its mass taken for 8.5 kg gives
/// the same.
#[test]
fn a_body_that_is_left_out_is_named_before_a_unit() {
    let lorry = [("m_L", "17 t"), ("m_T", "8.5 t"), ("v_L1", "80 km/h"), ("B", "44 kN"), ("dt", "3.0 s")];
    let found = named("strings/lorry-and-trailer.yaml", 0, &lorry, "v_L2", "52.1 km/h");
    assert_eq!(found.first(), Some(&"one-mass-for-system"), "{found:?}");
}

/// 2.5 kg from 0.55 m on a pan of 0.5 kg: -3.285 m/s, then 5/6 of it. A mistake about the spring comes later.
#[test]
fn a_sign_that_is_lost_is_not_put_down_to_a_later_stage() {
    let parcel = [("m_A", "2.5 kg"), ("m_B", "0.5 kg"), ("h", "0.55 m"), ("k", "2.4 kN/m")];
    let found = named("chains/parcel-on-scale.yaml", 0, &parcel, "v_C3", "2.74 m/s");
    assert_eq!(found, ["direction-reversed"]);
}

/// 4.75^2/(2 * 0.25 * 9.81) = 4.60 m on a plank that is held.
#[test]
fn a_lower_body_taken_as_fixed_is_recognised() {
    let plank = [("m", "3 kg"), ("M", "14 kg"), ("v_A1", "4.75 m/s"), ("mu_k", "0.25")];
    let found = named("conservation/block-on-a-plank.yaml", 0, &plank, "s", "4.60 m");
    assert_eq!(found.first(), Some(&"lower-body-taken-as-fixed"), "{found:?}");
}

#[test]
fn half_of_the_peak_is_recognised() {
    let ball = [("m", "58.5 g"), ("F_max", "780 N"), ("t_a", "0.9 ms"), ("t_b", "1.9 ms"), ("t_c", "3.4 ms")];
    let found = named("impulse/served-ball.yaml", 0, &ball, "F_avg_A", "390 N");
    assert_eq!(found.first(), Some(&"half-of-the-peak"), "{found:?}");
}

/// 3000 kg, less 700 kg of propellant, against 5600 N for 400 s; right is 2500 - 3200 ln(30/23) = 1650 m/s.
#[test]
fn a_rocket_that_keeps_its_mass_is_recognised() {
    let lander = [("m_0", "3000 kg"), ("q", "1.75 kg/s"), ("u", "3200 m/s"), ("dt", "400 s"), ("v_R1", "2500 m/s")];
    for (answer, code) in [
        ("1753 m/s", "rocket-mass-kept"), // 2500 - 2240000/3000
        ("1526 m/s", "rocket-mass-kept"), // 2500 - 2240000/2300
        ("3350 m/s", "impulse-reversed"), // 2500 + 850.2
    ] {
        let found = named("streams/moon-lander.yaml", 0, &lander, "v_R2", answer);
        assert_eq!(found.first(), Some(&code), "{answer}: {found:?}");
    }
}

/// The same follows from two angular momenta without their arms: two mistakes, not one.
#[test]
fn a_velocity_that_is_kept_is_named_before_two_arms_forgotten() {
    let puck = [("m", "290 g"), ("r_1", "85 cm"), ("r_2", "30 cm"), ("v_A1", "2.4 m/s")];
    for (part, answer) in [("v_A2", "2.4 m/s"), ("omega_A2", "8 rad/s")] {
        let found = named("angular-momentum/puck-on-string.yaml", 0, &puck, part, answer);
        assert_eq!(found.first(), Some(&"velocity-kept"), "{found:?}");
    }
}

/// The boats approach each other by 10.5 m: the first by 360/580 of it, with the masses exchanged by 220/580.
#[test]
fn masses_exchanged_are_recognised() {
    let boats = [("m_A", "220 kg"), ("m_B", "360 kg"), ("r_B1", "13 m"), ("d", "2.5 m")];
    let found = named("mass-centre/rope-between-boats.yaml", 0, &boats, "r_A2", "3.98 m");
    assert!(found.contains(&"masses-exchanged"), "{found:?}");
}

/// With the carousel 431/270 = 1.596 rad/s; without one 116.08/140.2 = 0.828 rad/s.
#[test]
fn an_angular_velocity_that_several_bodies_keep_is_recognised() {
    let carousel = [("m_R", "120 kg"), ("R", "1.5 m"), ("m_A", "33 kg"), ("m_B", "27 kg"), ("r", "0.7 m")];
    let carousel: Vec<_> =
        carousel.into_iter().chain([("omega_1", "0.3 rad/s"), ("M", "100 N m"), ("tau", "3.5 s")]).collect();
    let found = named("angular-momentum/playground-carousel.yaml", 1, &carousel, "omega_3", "1.60 rad/s");
    assert!(found.contains(&"angular-velocity-kept"), "{found:?}");
    let light = [("m_A", "32 kg"), ("m_B", "32 kg"), ("m_C", "41 kg"), ("a", "1.4 m"), ("b", "0.6 m"), ("c", "0.5 m")];
    let light: Vec<_> =
        light.into_iter().chain([("omega_1", "0.4 rad/s"), ("M_0", "40 N m"), ("tau", "3 s")]).collect();
    let found = named("angular-momentum/roundabout.yaml", 1, &light, "omega_3", "0.828 rad/s");
    assert!(found.contains(&"angular-velocity-kept"), "{found:?}");
}

/// 1.53 kg at 1.137 m/s on a cord of 1.9 m: 15.0 N and 1.04 N, right is their sum.
#[test]
fn a_tension_without_one_of_its_two_parts_is_recognised() {
    let arrow = [("m_A", "30 g"), ("m_B", "1.5 kg"), ("v_A1", "58 m/s"), ("L", "1.9 m")];
    for (answer, code) in [("15.0 N", "balance-on-a-circle"), ("1.04 N", "weight-forgotten-on-a-circle")] {
        let found = named("chains/ballistic-pendulum.yaml", 0, &arrow, "tension_C@after", answer);
        assert!(found.contains(&code), "{answer}: {found:?}");
    }
}

/// cos 70° * 1 m = 0.342 m in place of 0.658 m: sqrt(2 * 9.81 * 0.342)/3 = 0.863 m/s.
#[test]
fn a_height_from_the_centre_is_recognised() {
    let track = [("m_A", "4 kg"), ("m_B", "8 kg"), ("R", "1 m"), ("alpha", "70 deg")];
    let found = named("chains/crate-on-a-track.yaml", 1, &track, "v_C3", "0.863 m/s");
    assert!(found.contains(&"height-from-fixed-end"), "{found:?}");
}

/// A capsule is braked: 3.25 - 550 * 16/8500 = 2.21 m/s. A ram strikes a pile, and the ground stops both: the common velocity is
/// 600/900 of sqrt(2 * 9.81 * 1.5), which leaves 5886 J, and 5886/(80000 - 8829) = 82.7 mm.
#[test]
fn what_is_given_may_be_left_out_or_stand_in_another_place() {
    let capsule = [("m", "8.5 t"), ("v_S1", "3.25 m/s"), ("F", "550 N"), ("dt", "16 s")];
    for (answer, code) in [
        ("1.04 m/s", "velocity-left-out"), // 1.035
        ("3.14 m/s", "weight-for-mass"),   // 3.25 - 1.035/9.81
        ("3.19 m/s", "duration-left-out"), // 3.25 - 550/8500
    ] {
        let found = named("impulse/capsule-braking.yaml", 0, &capsule, "v_S2", answer);
        assert!(found.contains(&code), "{answer}: {found:?}");
    }
    assert!(named("impulse/capsule-braking.yaml", 0, &capsule, "v_S2", "1.62 m/s").is_empty());
    let driver = [("m_A", "600 kg"), ("m_B", "300 kg"), ("h", "1.5 m"), ("R", "80 kN")];
    for (answer, code) in [
        ("20.7 mm", "masses-exchanged"),         // 300/900 of the velocity: 1471.5/71171
        ("73.6 mm", "work-of-weight-forgotten"), // 5886/80000
    ] {
        let found = named("chains/pile-driver.yaml", 0, &driver, "d", answer);
        assert!(found.contains(&code), "{answer}: {found:?}");
    }
}
