//! Motions given as functions, and parts driven apart by a force, with random numbers: what must hold whatever they are.

use proptest::prelude::*;

use super::scenes::decimal;
use super::stages::{close, find, tenth};

fn si(tenths: i64, unit: &str) -> String {
    format!("{} {unit}", decimal(tenths, 1))
}

const ALONE: &str = "axes: { x: ahead }\nbodies:\n  A: { name: the sledge }\nstages:\n";

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_motion_and_the_push_that_causes_it_agree(mass in 1_i64..100, start in -50_i64..50, b in -50_i64..50, c in 1_i64..50, time in 1_i64..40) {
        let given = [
            ("m_A", si(mass, "kg")), ("b", si(b, "m/s^2")), ("c", si(c, "m/s^3")), ("dt", si(time, "s")),
        ];
        let told = format!("{ALONE}  - motion: {{ body: A, during: dt, velocity: w + b*t + c*t^2 }}");
        let caused = format!("{ALONE}  - push: {{ body: A, during: dt, forces: [ {{ value: m_A*(b + 2*c*t) }} ] }}");
        let told_given = [&given[..], &[("w", si(start, "m/s")), ("r_A1", "0 m".into())]].concat();
        let caused_given = [&given[..], &[("v_A1", si(start, "m/s"))]].concat();
        let [after, impulse, mean, place, force] = find(&told, &told_given, ["v_A2", "J_A", "F_avg_A", "r_A2", "F_A2"]);
        let [other, same] = find(&caused, &caused_given, ["v_A2", "J_A"]);
        close(after, other)?;
        close(impulse, same)?;
        close(mean * tenth(time), impulse)?;
        let [w, b, c, t] = [start, b, c, time].map(tenth);
        close(place, w * t + b * t * t / 2.0 + c * t.powi(3) / 3.0)?;
        close(force, tenth(mass) * (b + 2.0 * c * t))?;
    }

    #[test]
    fn a_velocity_by_place_is_one_by_time_too(start in 1_i64..50, k in 1_i64..20, share in 1_i64..9) {
        // v = w - k x is v = w exp(-k t) with x = (w/k)(1 - exp(-k t)).
        let scene = format!("{ALONE}  - motion: {{ body: A, velocity: w - k*x }}");
        let given = [
            ("m_A", "2 kg".to_owned()), ("w", si(start, "m/s")), ("k", si(k, "1/s")), ("r_A1", "0 m".into()),
            ("r_A2", format!("{}/{}*w/k", share, 10)),
        ];
        let [time, after, force] = find(&scene, &given, ["dt", "v_A2", "F_A2"]);
        close(after, tenth(start) * (-tenth(k) * time).exp())?;
        close(force, -2.0 * tenth(k) * after)?;
    }

    #[test]
    fn parts_driven_apart_keep_their_momentum(masses in [1_i64..100, 1_i64..100], start in -50_i64..50, peak in 1_i64..500, time in 1_i64..50, observer in -50_i64..50) {
        let scene = "axes: { x: ahead }\nbodies:\n  A: { name: slider A }\n  B: { name: slider B }\nstages:\n  - separate: { into: [A, B], duration: T, force: F*sin(pi*t/T) }";
        let solve = |observer: i64| {
            let given = [
                ("m_A", si(masses[0], "kg")), ("m_B", si(masses[1], "kg")), ("v_A1", si(start - observer, "m/s")),
                ("F", si(peak, "N")), ("T", si(time, "s")),
            ];
            find(scene, &given, ["v_A2", "v_B2", "J_B"])
        };
        let ([a, b, impulse], [m, n]) = (solve(0), masses.map(tenth));
        close(m * a + n * b, (m + n) * tenth(start))?;
        close(impulse, n * (b - tenth(start)))?;
        // The area under half a sine is 2/pi of the rectangle around it.
        close(impulse, tenth(peak) * tenth(time) * 2.0 / std::f64::consts::PI)?;
        let [seen, _, same] = solve(observer);
        close(seen, a - tenth(observer))?;
        close(same, impulse)?;
    }
}
