//! Streams, thrusts, drifts and bounces with random numbers: what is balanced, whoever looks, in whatever units, and at extremes.

use proptest::prelude::*;

use super::scenes::decimal;
use super::stages::{close, find, tenth};

/// Gravity where nothing is said, in m/s².
const GRAVITY: f64 = 9.81;

fn si(tenths: i64, unit: &str) -> String {
    format!("{} {unit}", decimal(tenths, 1))
}

/// The same speed in another unit.
fn kilometres_per_hour(tenths: i64) -> String {
    format!("{} km/h", decimal(36 * tenths, 2))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_vane_feels_what_the_jet_loses(flow in 1_i64..200, speed in 10_i64..400, turned in 1_i64..180) {
        let scene = "axes: { x: ahead, y: to the left }\nbodies:\n  V: { name: the vane }\nstages:\n  - stream: { body: V, by: the jet, flow: q, speed: v, turned: theta }";
        let solve = |flow: String, speed: String| {
            find(scene, &[("q", flow), ("v", speed), ("theta", format!("{turned} deg"))], ["F_V.x", "F_V.y", "F_V"])
        };
        let [x, y, size] = solve(si(flow, "kg/s"), si(speed, "m/s"));
        let (momentum, angle) = (tenth(flow) * tenth(speed), tenth(10 * turned).to_radians());
        // What arrives in a second has this momentum, and keeps its size.
        close(x, momentum * (1.0 - angle.cos()))?;
        close(y, -momentum * angle.sin())?;
        close(size, x.hypot(y))?;
        prop_assert!(size <= 2.0 * momentum * (1.0 + 1e-12));
        close(size, solve(format!("{} kg/min", decimal(60 * flow, 1)), kilometres_per_hour(speed))[2])?;
    }

    #[test]
    fn a_moving_observer_sees_the_same_force_of_a_jet(speed in 100_i64..400, away in 0_i64..90, moves in -50_i64..50) {
        let scene = "axes: { x: ahead }\nbodies:\n  V: { name: the plate }\nstages:\n  - stream: { body: V, by: the jet, density: rho, area: A, speed: v, moves: u }";
        let solve = |observer: i64| {
            let given = [
                ("rho", "1000 kg/m^3".to_owned()), ("A", "5 cm^2".into()),
                ("v", si(speed - observer, "m/s")), ("u", si(away - observer, "m/s")),
            ];
            find(scene, &given, ["F_V"])[0]
        };
        let force = solve(0);
        let relative = tenth(speed) - tenth(away);
        close(force, 1000.0 * 5e-4 * relative * relative)?;
        close(force, solve(moves))?;
    }

    #[test]
    fn a_burn_keeps_the_momentum_of_rocket_and_gas(first in 20_i64..100, burnt in 1_i64..19, exhaust in 10_i64..300, start in -100_i64..100) {
        let scene = "axes: { x: ahead }\nbodies:\n  R: { name: the probe }\nstages:\n  - thrust: { body: R, mass: [m_0, m_1], exhaust: u }";
        let solve = |observer: i64| {
            let given = [
                ("m_0", si(first, "kg")), ("m_1", si(first - burnt, "kg")),
                ("u", si(exhaust, "m/s")), ("v_R1", si(start - observer, "m/s")),
            ];
            find(scene, &given, ["v_R2"])[0]
        };
        let after = solve(0);
        close(after - solve(start), tenth(start))?;
        // Steps of a thousandth of the fuel, each an exact balance of momentum: the gain of many small throws.
        let (mut mass, mut speed, step) = (tenth(first), tenth(start), tenth(burnt) / 20_000.0);
        for _ in 0..20_000 {
            let rest = mass - step;
            speed += tenth(exhaust) * step / (mass - step / 2.0);
            mass = rest;
        }
        prop_assert!((after - speed).abs() < 1e-6 * (1.0 + after.abs()), "{after} {speed}");
    }

    #[test]
    fn a_small_burn_gains_what_its_thrust_gives(first in 500_i64..1000, exhaust in 1000_i64..3000, flow in 1_i64..5) {
        let scene = "axes: { y: upwards }\nplane: vertical\nbodies:\n  R: { name: the rocket }\nstages:\n  - thrust: { body: R, mass: m_0, exhaust: u, flow: q, during: dt }";
        let given = [
            ("m_0", format!("{first} kg")), ("u", format!("{exhaust} m/s")), ("q", si(flow, "kg/s")),
            ("dt", "1 ms".to_owned()), ("v_R1", "0 m/s".into()),
        ];
        let [speed, thrust] = find(scene, &given, ["v_R2", "F_R"]);
        close(thrust, tenth(flow) * tenth(10 * exhaust))?;
        let gained = (thrust / tenth(10 * first) - GRAVITY) * 1e-3;
        prop_assert!((speed - gained).abs() < 1e-6 * (1.0 + gained.abs()), "{speed} {gained}");
    }

    #[test]
    fn a_drift_ends_where_both_are_whoever_looks(gap in 1_i64..100, fast in 11_i64..50, slow in -50_i64..10, observer in -50_i64..50) {
        let scene = "axes: { x: ahead }\nbodies:\n  A: { name: cart A }\n  B: { name: cart B }\nstages:\n  - drift: { until: x_A = x_B }";
        let solve = |observer: i64| {
            let given = [
                ("x_A1", "0 m".to_owned()), ("x_B1", si(gap, "m")),
                ("v_A1", si(fast - observer, "m/s")), ("v_B1", si(slow - observer, "m/s")),
            ];
            find(scene, &given, ["t_2", "x_A2", "x_B2"])
        };
        let ([time, here, there], [other, seen, _]) = (solve(0), solve(observer));
        close(time * (tenth(fast) - tenth(slow)), tenth(gap))?;
        close(here, there)?;
        close(time, other)?;
        close(here, seen + tenth(observer) * time)?;
    }

    #[test]
    fn bounces_add_up_one_by_one(along in -50_i64..50, up in 10_i64..100, e in 1_i64..9, count in 1_i32..6, slope in 0_i64..40) {
        let scene = "axes: { x: down the slope, y: away from the slope }\nbodies:\n  A: { name: the ball }\nstages:\n  - flight: { body: A, until: y = 0 m, incline: alpha }\n  - bounces: { body: A, restitution: e, count: n, incline: alpha }";
        let given = [
            ("r_A1.x", "0 m".to_owned()), ("r_A1.y", "0 m".into()), ("v_A1.x", si(along, "m/s")), ("v_A1.y", si(up, "m/s")),
            ("e", decimal(e, 1)), ("n", count.to_string()), ("alpha", format!("{slope} deg")),
        ];
        let [place, range, time, end] = find(scene, &given, ["x_n", "range_n", "t_n", "t_total"]);
        let angle = tenth(10 * slope).to_radians();
        let (press, pull) = (GRAVITY * angle.cos(), GRAVITY * angle.sin());
        // One flight after the other: each begins with e times the speed away from the slope.
        let (mut x, mut speed, mut away, mut clock, mut last) = (0.0, tenth(along), tenth(up), 0.0, 0.0);
        for _ in 0..=count {
            let flight = 2.0 * away / press;
            last = speed * flight + pull * flight * flight / 2.0;
            (x, speed, away, clock) = (x + last, speed + pull * flight, away * tenth(e), clock + flight);
        }
        close(place, x - last)?;
        close(range, last)?;
        let latest = 2.0 * away / tenth(e) / press;
        close(time, clock - latest)?;
        prop_assert!(end >= time);
        close(end, 2.0 * tenth(up) / press / (1.0 - tenth(e)))?;
    }
}
