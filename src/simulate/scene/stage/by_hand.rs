//! Every kind of stage against what comes out by hand.

#![allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]

mod carried;
mod pushes;
mod row;

use crate::record::Moment;
use crate::scene::{NothingToSimulate, Observed, follow, observe};
use momentous_scene::Scene;

use carried::CARRIED;
use pushes::PUSHES;
use row::{BOTH, POLAR, RIGHT, Row, SLOPE, SPACE, UP, UPHILL};

/// Axes, a stage, what is given, and what comes out, all worked out by hand with g = 10 m/s².
const BY_HAND: &[Row] = &[
    (UPHILL, r#"{"slide":{"body":"A","incline":"30 deg","distance":"d","until":"rest"}}"#, "v_A1 6", "d 3.6, dt 1.2"),
    (RIGHT, r#"{"slide":{"body":"A","friction":0.5,"distance":"d","until":"rest"}}"#, "v_A1 10", "d 10, dt 2, v_A2 0"),
    (RIGHT, r#"{"slide":{"body":"A","height":"0.8 m"}}"#, "v_A1 3", "v_A2 5"),
    (RIGHT, r#"{"spring":{"body":"A","stiffness":"200 N/m","to":"s","until":"rest"}}"#, "m_A 2, v_A1 1", "s 0.1"),
    (RIGHT, r#"{"spring":{"body":"A","stiffness":"200 N/m","from":"0.1 m"}}"#, "m_A 2, v_A1 0", "v_A2 1"),
    (
        RIGHT,
        r#"{"spring":{"between":["A","B"],"stiffness":"300 N/m","from":"0.2 m"}}"#,
        "m_A 1, m_B 3, v_A1 0, v_B1 0",
        "v_A2 -3, v_B2 1",
    ),
    (
        RIGHT,
        r#"{"swing":{"body":"A","length":"2.5 m"}}"#,
        "m_A 2, v_A1 5",
        "h_A 1.25, angle_A2 1.0471975511965976, tension_A1 40",
    ),
    (RIGHT, r#"{"swing":{"body":"A","length":"2.5 m","from":"60 deg"}}"#, "m_A 2", "v_A2 5, tension_A2 40"),
    (RIGHT, r#"{"swing":{"body":"A","height":"1.25 m","way":"down"}}"#, "m_A 2", "v_A2 5"),
    (
        RIGHT,
        r#"{"taut":{"between":["A","B"],"duration":"0.1 s"}}"#,
        "m_A 1, m_B 3, v_A1 0, v_B1 4",
        "v_A2 3, v_B2 3, F_avg_A 30, T_lost 6",
    ),
    (
        RIGHT,
        r#"{"connected":{"trailing":{"body":"A"},"leading":{"body":"B"},"duration":"2 s"}}"#,
        "m_A 1, m_B 3, v_A1 0",
        "v_A2 10, v_B2 10, tension 15",
    ),
    (
        RIGHT,
        r#"{"connected":{"trailing":{"body":"A","on":"level","friction":0.5},"leading":{"body":"B"},"distance":"4 m"}}"#,
        "m_A 2, m_B 2, v_A1 1",
        "v_B2 4.58257569495584, tension 15",
    ),
    (
        RIGHT,
        r#"{"blow":{"body":"A","by":"the bat","duration":"0.01 s"}}"#,
        "m_A 2, v_A1 -3, J_A 10",
        "v_A2 2, F_avg_A 1000",
    ),
    (RIGHT, r#"{"blow":{"body":"A","by":"the bat"}}"#, "m_A 2, v_A1 -3, v_A2 2", "J_A 10"),
    (RIGHT, r#"{"rotate":{"body":"A","about":"O","arm":["2 m","1 m"]}}"#, "m_A 2, v_A1 3", "v_A2 6, omega_A2 6"),
    (
        RIGHT,
        r#"{"rotate":{"body":"A","about":"O","arm":"2 m","moment":"6*t*1 N m/s","during":"2 s"}}"#,
        "m_A 3, v_A1 1",
        "v_A2 3",
    ),
    (
        POLAR,
        r#"{"central":{"body":"A","about":"O"}}"#,
        "r_A1 1, r_A2 2, v_A1.theta 3",
        "v_A2.theta 1.5, areal_rate 1.5",
    ),
    (
        POLAR,
        r#"{"central":{"body":"A","about":"O","gravity":"GM","orbit":"ellipse"}}"#,
        "GM 4, r_A1 1, r_A2 2, v_A1.theta 2.449489742783178",
        "a_A 2, r_A.max 3, ecc_A 0.5, period_A 8.88576587631673, speed_A2 1.4142135623730951",
    ),
    (
        POLAR,
        r#"{"central":{"body":"A","about":"O","spring":{"stiffness":"3 N/m","unstretched":"1 m"}}}"#,
        "m_A 1, r_A1 2, r_A2 1, v_A1.r 0, v_A1.theta 0.5",
        "v_A2.theta 1, v_A2.r -1.5, H_O2 1",
    ),
    (
        RIGHT,
        r#"{"rotate":{"about":"O","bodies":{"A":"1 m","B":["2 m","1 m"]}}}"#,
        "m_A 1, m_B 2, omega_1 2",
        "omega_2 6, v_A2 6, v_B2 6, work 36",
    ),
    (
        RIGHT,
        r#"{"strike":{"body":"G","about":"O","at":"1 m","carries":{"A":"2 m"},"restitution":0.5}}"#,
        "m_G 2, m_A 1, v_G1 6, omega_1 0",
        "omega_2 3, v_A2 6, v_G2 0, H_O2 12, T_lost 18",
    ),
    (
        RIGHT,
        r#"{"strike":{"body":"G","about":"O","at":"1 m","carries":{"A":"2 m"},"plastic":true}}"#,
        "m_G 2, m_A 1, v_G1 6, omega_1 0",
        "omega_2 2, v_G2 2, T_lost 24",
    ),
    (
        RIGHT,
        r#"{"conical":{"body":"A","about":"O","length":["2 m","1 m"]}}"#,
        "m_A 1, angle_A1 0.7853981633974483",
        "v_A1 3.760603093086394, tension_A1 14.142135623730951, H_O2 5.318295896944988",
    ),
    (
        POLAR,
        r#"{"bowl":{"body":"A","about":"O","way":"down","cone":"45 deg","height":"1 m","horizontal":"start"}}"#,
        "m_A 1, r_A1 2, v_A1.theta 2",
        "r_A2 1, v_A2.theta 4, speed_A2 4.898979485566356, angle_A2 0.6154797086703874",
    ),
    (
        POLAR,
        r#"{"bowl":{"body":"A","about":"O","way":"down","sphere":"5 m","height":"h","horizontal":"both"}}"#,
        "m_A 1, r_A1 4, v_A1.theta 0.001",
        "h 1.99999996",
    ),
    (BOTH, r#"{"moment":{"about":"O","value":"6*t*1 N m/s","during":"2 s"}}"#, "H_O1 -4", "H_O2 8, dt 2"),
    (
        SPACE,
        r#"{"moment":{"about":"O","value":{"x":"3 N m","z":"t*1 N m/s"},"during":"2 s"}}"#,
        "H_O1.x 1, H_O1.y 2, H_O1.z 3",
        "H_O2.x 7, H_O2.y 2, H_O2.z 5",
    ),
    (
        SPACE,
        r#"{"separate":{"from":"W","into":["A","B","C"]}}"#,
        "m_A 2, m_B 1, m_C 1, v_W1.x 1, v_W1.y 0, v_W1.z 0, v_B2.x 1, v_B2.y 2, v_B2.z 0, v_C2.x 3, v_C2.y 0, v_C2.z 4",
        "v_A2.x 0, v_A2.y -1, v_A2.z -2, J_A.x -2, J_C.z 4, T_gained 18",
    ),
    (
        SPACE,
        r#"{"impact":{"between":["A","B"],"plastic":true,"becomes":"C"}}"#,
        "m_A 1, m_B 3, v_A1.x 4, v_A1.y 0, v_A1.z 8, v_B1.x 0, v_B1.y 4, v_B1.z 0",
        "v_C2.x 1, v_C2.y 3, v_C2.z 2, J_B.z 6",
    ),
    (
        UP,
        r#"{"bounces":{"body":"A","restitution":0.5,"count":2}}"#,
        "h_0 5",
        "h_n 0.3125, path_total 8.333333333333334",
    ),
    (
        BOTH,
        r#"{"bounces":{"body":"A","restitution":0.5,"count":2}}"#,
        "v_A1.x 3, v_A1.y -10, r_A1.x 1",
        "v_n 2.5, t_n 1, x_n 4, dt_n 0.5, range_n 1.5, h_n 0.3125, t_total 2, x_total 7",
    ),
    (
        SLOPE,
        r#"{"bounces":{"body":"A","restitution":0.5,"count":1,"incline":"30 deg"}}"#,
        "v_A1.x 0, v_A1.y -8.660254037844386",
        "dt_n 1, range_n 2.5, t_total 2, x_total 10",
    ),
    (
        SLOPE,
        r#"{"flight":{"body":"A","until":"y = 0 m","incline":"30 deg"}}"#,
        "v_A1.x 0, v_A1.y 4.330127018922193, r_A1.x 0, r_A1.y 0",
        "dt 1, r_A2.x 2.5, v_A2.x 5",
    ),
    (
        RIGHT,
        r#"{"stream":{"body":"A","by":"the jet","speed":"10 m/s","moves":"4 m/s","density":"1000 kg/m^3","area":"0.001 m^2"}}"#,
        "",
        "flow_A 6, F_A 36, F_hold_A -36, P_A 144",
    ),
    (
        RIGHT,
        r#"{"stream":{"body":"A","by":"the jet","speed":"10 m/s","flow":"2 kg/s","turned":"180 deg"}}"#,
        "",
        "F_A 40",
    ),
    (RIGHT, r#"{"stream":{"body":"A","by":"the hail","drop":"5 m","flow":"2 kg/s","restitution":0.5}}"#, "", "F_A 30"),
    (
        UP,
        r#"{"stream":{"body":"A","by":"the sand","direction":"downwards","speed":"5 m/s","flow":"2 kg/s","during":"3 s","stays":true}}"#,
        "m_A 4",
        "N_A 110, F_A -10",
    ),
    (
        RIGHT,
        r#"{"thrust":{"body":"A","mass":["2 kg","1 kg"],"exhaust":"1 km/s","flow":"0.1 kg/s"}}"#,
        "v_A1 0",
        "v_A2 693.1471805599453, F_A 100, dt 10",
    ),
    (
        UP,
        r#"{"thrust":{"body":"A","mass":["20 kg","10 kg"],"exhaust":"100 m/s","flow":"1.5 kg/s","on_ground":true}}"#,
        "v_A1 0",
        "t_start 3.3333333333333335, v_A2 7.213177477483106",
    ),
    (
        RIGHT,
        r#"{"tow":{"front":{"body":"A","force":"30 N"},"rear":{"body":"B","friction":0.1},"duration":"2 s"}}"#,
        "m_A 4, m_B 5, v_A1 1",
        "v_A2 6.555555555555555, v_B2 6.555555555555555, tension 18.88888888888889, dt 2",
    ),
    (
        UPHILL,
        r#"{"tow":{"front":{"body":"A"},"rear":{"body":"B","force":"50 N"},"incline":"30 deg","distance":"d"}}"#,
        "m_A 3, m_B 5, v_A1 0, d 4",
        "v_B2 3.1622776601683795, tension -18.75",
    ),
    (RIGHT, r#"{"walk":{"body":"A","on":"B","distance":"4 m"}}"#, "m_A 1, m_B 3", "s_A 3, s_B -1"),
    (
        RIGHT,
        r#"{"separate":{"from":"W","into":["A","B"],"energy":"6 J"}}"#,
        "m_A 1, m_B 3, v_W1 1",
        "v_A2 -2, v_B2 2, T_gained 6",
    ),
    (
        RIGHT,
        r#"{"separate":{"from":"W","into":["A","B"],"relative":{"of":"A","to":"B","velocity":"4 m/s"}}}"#,
        "m_A 1, m_B 3, v_W1 0",
        "v_A2 3, v_B2 -1, J_A 3",
    ),
    (
        BOTH,
        r#"{"slide_off":{"body":"A","on":"G","height":"0.6 m","direction":"to the right"}}"#,
        "m_A 1, m_G 3",
        "v_A2.x 3, v_G2.x -1",
    ),
    (
        BOTH,
        r#"{"slide_off":{"body":"A","on":"G","height":"0.6 m","direction":"45 deg below +x"}}"#,
        "m_A 1, m_G 1",
        "v_G2.x -1.4142135623730951, v_A2.y -2.8284271247461903",
    ),
    (RIGHT, r#"{"drift":{"until":"x_A = x_B"}}"#, "v_A1 3, v_B1 1, r_A1 0, r_B1 6", "dt 3, r_A2 9, t_2 3"),
    (
        BOTH,
        r#"{"flight":{"body":"A","until":"y = 0 m"}}"#,
        "v_A1.x 3, v_A1.y 10, r_A1.x 0, r_A1.y 0",
        "dt 2, r_A2.x 6, v_A2.y -10",
    ),
    (
        BOTH,
        r#"{"flight":{"body":"A","during":"1 s"}}"#,
        "m_A 2, v_A1.x 3, v_A1.y 10, r_A1.x 4, r_A1.y 5",
        "r_A2.x 7, H_rate_O1 -80, M_O2 -140",
    ),
    (BOTH, r#"{"flight":{"body":"A","until":"top"}}"#, "v_A1.x 3, v_A1.y 10", "dt 1, v_A2.y 0"),
    (
        RIGHT,
        r#"{"motion":{"body":"A","during":["1 s","3 s"],"velocity":"3*t^2*1 m/s^3"}}"#,
        "m_A 2, r_A1 1",
        "v_A1 3, v_A2 27, r_A2 27, F_A1 12, F_A2 36, J_A 48, F_avg_A 24",
    ),
    (
        RIGHT,
        r#"{"motion":{"body":"A","velocity":"2*x/(1 s)"}}"#,
        "m_A 1, r_A1 1, dt 1",
        "r_A2 7.38905609893065, a_A1 4",
    ),
    (
        BOTH,
        r#"{"motion":{"body":"A","during":"2 s","position":{"x":"t^2*1 m/s^2","y":"3*t*1 m/s"}}}"#,
        "m_A 5",
        "r_A2.x 4, r_A2.y 6, v_A2.x 4, v_A2.y 3, a_A2.x 2, F_A1.x 10, F_A2.y 0, J_A.x 20, J_A.y 0",
    ),
    (
        RIGHT,
        r#"{"impact":{"between":["A","B"],"loss":"6 J"}}"#,
        "m_A 2, m_B 2, v_A1 4, v_B1 0",
        "v_common 2, J_B 6, T_lost 6",
    ),
];

fn scene(axes: &str, stage: &str) -> Scene {
    let plane = if axes.contains("upwards") { "vertical" } else { "horizontal" };
    let text = format!(
        r#"{{"axes":{axes},"plane":"{plane}","points":{{"O":{{"name":"o"}}}},"bodies":{{"A":{{"name":"a"}},
        "B":{{"name":"b"}},"C":{{"name":"c"}},"G":{{"name":"g","guide":{{"along":"x"}}}}}},"stages":[{stage}]}}"#
    );
    serde_json::from_str(&text).unwrap()
}

fn numbers(text: &str) -> Vec<(&str, f64)> {
    let rows = text.split(", ").filter_map(|row| row.rsplit_once(' '));
    rows.map(|(name, value)| (name, value.parse().unwrap())).collect()
}

/// Looks at a stage with what is given of it, and g = 10 m/s².
fn with<T>(axes: &str, stage: &str, told: &str, look: impl FnOnce(&Scene, &dyn Fn(&str) -> Option<f64>) -> T) -> T {
    let told = numbers(told);
    let value = |name: &str| {
        let told_value = told.iter().find(|(told_name, _)| *told_name == name).map(|(_, value)| *value);
        told_value.or(if name == "g" { Some(10.0) } else { None })
    };
    look(&scene(axes, stage), &value)
}

fn run(axes: &str, stage: &str, told: &str) -> Result<Observed, NothingToSimulate> {
    with(axes, stage, told, |scene, value| observe(scene, 0, value, 1e-11))
}

#[test]
fn every_kind_of_stage_ends_as_it_does_by_hand() {
    for (axes, stage, told, expected) in BY_HAND.iter().chain(PUSHES).chain(CARRIED) {
        let observed = run(axes, stage, told).unwrap_or_else(|reason| panic!("{stage}: {reason:?}"));
        for (name, expected) in numbers(expected) {
            let mut all = observed.found.iter().chain(&observed.terms);
            let reached = all.find(|reached| reached.name == name).unwrap_or_else(|| panic!("{stage}: no {name}"));
            let scale = 1.0 + expected.abs();
            // A rate is a quotient of differences, which says itself how far off it may be.
            let allowed = if reached.name.contains("rate") || reached.name.starts_with("M_") {
                reached.error.min(1e-7 * scale)
            } else {
                1e-9 * scale
            };
            assert!((reached.value - expected).abs() <= allowed, "{stage}: {reached:?}, not {expected}");
        }
    }
}

#[test]
fn what_cannot_be_simulated_says_why() {
    let three = r#"{"separate":{"from":"W","into":["A","B","G"]}}"#;
    for (stage, told, reason) in [
        (r#"{"blow":{"body":"A","by":"the bat"}}"#, "m_A 1, v_A1 1", NothingToSimulate::ValueMissing),
        (r#"{"impact":{"between":["A","B"]}}"#, "m_A 1, m_B 1, v_A1 1, v_B1 0", NothingToSimulate::NoRestitution),
        (three, "m_A 1, m_B 1, m_G 1, v_W1 1", NothingToSimulate::ValueMissing),
    ] {
        assert_eq!(run(RIGHT, stage, told).unwrap_err(), reason, "{stage}");
    }
}

/// Invariants by hand: the momentum along each axis less the impulse from outside, and the energy.
#[test]
fn the_balances_of_what_is_watched_are_level() {
    let mut watched = 0;
    for (axes, stage, told, _) in BY_HAND.iter().chain(PUSHES).chain(CARRIED) {
        let motions = with(axes, stage, told, |scene, value| follow(scene, 0, value, 1e-10)).unwrap_or_default();
        for motion in &motions {
            let moments = &motion.record.moments;
            let kept = |moment: &Moment| -> Vec<f64> {
                let momenta = moment.momentum.iter().zip(&moment.outside).map(|(all, outside)| all - outside);
                momenta.chain([moment.balance()]).collect()
            };
            let first = kept(&moments[0]);
            for moment in moments {
                let size = moment
                    .masses
                    .iter()
                    .zip(&moment.velocities)
                    .flat_map(|(mass, velocity)| velocity.iter().map(move |part| mass * part.abs()));
                let size =
                    1.0 + size.sum::<f64>() + moment.kinetic + moment.potential.abs() + moment.lost + moment.work.abs();
                for (now, first) in kept(moment).iter().zip(&first) {
                    assert!((now - first).abs() < 1e-7 * size, "{stage}: {now} after {first} at {} s", moment.time);
                }
            }
            watched += 1;
        }
    }
    assert!(watched >= 30, "only {watched}");
}
