//! Orbits against a direct integration of Newton's law of gravity, which shares nothing with the laws of the program; and orbits that
//! are nearly parabolas, against their own energy in other words.

#![allow(clippy::cast_precision_loss, reason = "the numbers of steps are small")]

use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::{compile, load};

const GM: f64 = 3.986e14;

/// The answers of a satellite that starts at its nearest point, in base units.
fn solve(radius_km: f64, speed: &str, far_km: f64) -> Vec<f64> {
    let text = format!(
        "id: test/orbit
title: An orbit
level: core
scene:
  axes: polar
  bodies: {{ S: {{ name: the satellite }} }}
  points: {{ O: {{ name: the centre }} }}
  stages:
    - central: {{ body: S, about: O, gravity: GM, orbit: ellipse }}
given: {{ GM: 3.986e14 m^3/s^2, r_S1: {radius_km} km, v_S1.theta: {speed} m/s, v_S1.r: 0 m/s, r_S2: {far_km} km }}
where: [ v_S2.r > 0 ]
text: >
  A satellite of {{{{ GM }}}} at {{{{ r_S1 }}}} moves at {{{{ v_S1.theta }}}}, {{{{ v_S1.r }}}} outwards, and comes to {{{{ r_S2 }}}}.
ask:
  - {{ find: speed_S2, unit: m/s }}
  - {{ find: v_S2.theta, unit: m/s }}
  - {{ find: dt, unit: s }}
  - {{ find: r_S.max, unit: m }}
"
    );
    let problem = load(Source::new("orbit", &text)).and_then(|loaded| compile(loaded, None));
    let problem = Arc::new(problem.unwrap_or_else(|faults| panic!("{faults}")));
    let exercise = Exercise::draw(&problem, 0, 1).unwrap();
    let record = exercise.record(None);
    record["ask"].as_array().unwrap().iter().map(|part| part["value"].as_f64().unwrap()).collect()
}

/// Newton's law in rectangular components, by the classical method of Runge and Kutta, until the distance is reached:
/// time, speed and the component of the velocity across the radius.
fn integrate(radius: f64, speed: f64, far: f64, steps: f64) -> [f64; 3] {
    let slope = |[x, y, u, v]: [f64; 4]| {
        let cube = x.hypot(y).powi(3);
        [u, v, -GM * x / cube, -GM * y / cube]
    };
    let moved = |state: [f64; 4], slope: [f64; 4], by: f64| std::array::from_fn(|at| state[at] + by * slope[at]);
    let step = radius / speed / steps;
    let (mut state, mut time) = ([radius, 0.0, 0.0, speed], 0.0);
    loop {
        let a = slope(state);
        let b = slope(moved(state, a, step / 2.0));
        let c = slope(moved(state, b, step / 2.0));
        let d = slope(moved(state, c, step));
        let mean = std::array::from_fn(|at| (a[at] + 2.0 * b[at] + 2.0 * c[at] + d[at]) / 6.0);
        let next: [f64; 4] = moved(state, mean, step);
        let (before, after) = (state[0].hypot(state[1]), next[0].hypot(next[1]));
        if after >= far {
            // The distance grows evenly within so short a step.
            let share = (far - before) / (after - before);
            let [x, y, u, v] = moved(state, mean, step * share);
            return [time + step * share, u.hypot(v), (x * v - y * u) / x.hypot(y)];
        }
        (state, time) = (next, time + step);
    }
}

#[test]
fn orbits_agree_with_an_integration_of_newtons_law() {
    for (radius, speed, far) in [(7000.0, 8500.0, 9000.0), (6600.0, 9000.0, 12000.0), (8000.0, 9500.0, 30000.0)] {
        let [own_speed, across, time, _] = solve(radius, &speed.to_string(), far)[..] else { panic!("four answers") };
        let [their_time, their_speed, their_across] = integrate(radius * 1e3, speed, far * 1e3, 4000.0);
        for (ours, other) in [(time, their_time), (own_speed, their_speed), (across, their_across)] {
            assert!((ours / other - 1.0).abs() < 1e-6, "{radius} km, {speed} m/s: {ours} and {other}");
        }
    }
}

/// Just below the speed of escape the terms of the energy nearly cancel: the exact value of the far end is known from
/// rational arithmetic, `r_max = r^2 v^2 / (2 GM - r v^2)`.
#[test]
fn nearly_parabolic_orbits_stay_accurate() {
    // v^2 = 2 GM / r = 1.13885714...e8 m^2/s^2 at 7000 km: v = 10671.7249...; ever closer to it.
    for (speed, parts) in [("10671", 10_671_000_000_u128), ("10671.72", 10_671_720_000), ("10671.7249", 10_671_724_900)]
    {
        let far = solve(7000.0, speed, 20000.0)[3];
        // In units of 1e-12 m^2/s^2 everything is a whole number: r v^2 and 2 GM, with v in micrometres a second.
        let square = 7_000_000 * parts * parts;
        let twice = 797_200_000_000_000 * 1_000_000_000_000;
        let (left, radius) = ((twice - square) as f64, 7.0e6);
        let exact = radius * (square as f64) / left;
        assert!((far / exact - 1.0).abs() < 1e-12, "{speed}: {far} and {exact}");
    }
}
