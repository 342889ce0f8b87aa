//! Every answer's certificate is true: the answer lies within its bound of the truth, which is known to more than 40
//! digits; and the bound is worth having. `MOMENTOUS_SEEDS=5000 cargo test --release --test solver certificates` looks further.

mod looked;
mod nearness;
mod replays;

use momentous::problem::{Problem, Sampler, Variant};
use momentous::quantity::Rational;

use crate::variants::truth::{Truth, is_true, long, long_f64, rough};
use crate::variants::{bank_problem, rational, seeds, sheet, solved, value};
use looked::{BESIDE, SHARE, faults, whole_bank};

#[test]
fn of_the_whole_bank() {
    let wrong: Vec<&str> = whole_bank().iter().flat_map(|form| &form.faults).map(String::as_str).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Formulas from the textbook, in rational arithmetic of our own: they share nothing with the laws or the solver.
#[test]
fn of_rational_problems_by_their_textbook_formulas() {
    let cases: &[Textbook] = &[
        ("impact/two-carts", 0, &["m_A", "m_B", "v_A1", "v_B1", "e"], |g| {
            let [a, b, u, v, e] = five(g);
            let (v_a, v_b) = impact(&a, &b, &u, &v, &e);
            let lost = energy(&a, &u) + energy(&b, &v) - energy(&a, &v_a) - energy(&b, &v_b);
            vec![("v_A2", v_a), ("v_B2", v_b), ("T_lost", lost)]
        }),
        ("impact/two-carts", 1, &["m_A", "m_B", "v_A1", "v_B1", "v_A2"], |g| {
            let [a, b, u, v, v_a] = five(g);
            let v_b = (&a * &u + &b * &v - &a * &v_a) / &b;
            vec![("e", (v_b - v_a) / (u - v))]
        }),
        ("conservation/coupling-wagons", 0, &["m_A", "m_B", "v_A1", "v_B1"], |g| {
            let (a, b, u, v) = (&g[0], &g[1], &g[2], &g[3]);
            let common = (a * u + b * v) / (a + b);
            let lost = a * b / (a + b) * (u - v) * (u - v) / Rational::from(2);
            vec![("J_B", b * (&common - v)), ("v_C2", common), ("T_lost", lost)]
        }),
        ("central-force/satellite", 0, &["r_S1", "v_S1.theta", "r_S2"], |g| {
            let swept = &g[0] * &g[1];
            vec![("v_S2.theta", &swept / &g[2]), ("areal_rate", swept / Rational::from(2))]
        }),
        ("impulse/capsule-braking", 2, &["m", "v_S1", "F", "v_S2"], |g| vec![("dt", &g[0] * (&g[1] - &g[3]) / &g[2])]),
        ("impulse/launch-sled", 0, &["m", "F_0", "t_e"], |g| {
            let impulse = &g[1] * &g[2] * Rational::from(2) / Rational::from(3);
            vec![("v_A2", &impulse / &g[0]), ("J_A", impulse)]
        }),
    ];
    for (id, form, given, formulas) in cases {
        let problem = bank_problem(id);
        let mut sampler = Sampler::new(&problem, *form).unwrap();
        for seed in 0..seeds(300) {
            let variant = sampler.variant(seed).unwrap();
            let given: Vec<Rational> = given.iter().map(|name| rational(&problem, &variant, name)).collect();
            for (name, truth) in formulas(&given) {
                let bounded = value(&problem, &variant, name);
                assert!(is_true(bounded, &long(&truth)), "{id} seed {seed}: {name} is {truth}, not {bounded:?}");
            }
        }
    }
}

type Textbook = (&'static str, usize, &'static [&'static str], fn(&[Rational]) -> Vec<(&'static str, Rational)>);

fn five(given: &[Rational]) -> [Rational; 5] {
    given.to_vec().try_into().unwrap()
}

/// Newton's impact law: the velocities afterwards.
fn impact(a: &Rational, b: &Rational, u: &Rational, v: &Rational, e: &Rational) -> (Rational, Rational) {
    let change = (Rational::ONE + e) * (u - v) / (a + b);
    (u - b * &change, v + a * &change)
}

fn energy(mass: &Rational, velocity: &Rational) -> Rational {
    mass * velocity * velocity / Rational::from(2)
}

/// A direct impact with these values: `m_A, m_B, v_A1, v_B1, e`; what is asked follows.
fn direct(values: [&str; 5], ask: &[&str]) -> (Problem, Variant) {
    let given: Vec<(&str, &str)> = ["m_A", "m_B", "v_A1", "v_B1", "e"].into_iter().zip(values).collect();
    let scene = "
axes: { x: to the right }
bodies:
  A: { name: A }
  B: { name: B }
stages:
  - impact: { between: [A, B], restitution: e }";
    solved(&sheet(scene, &given, ask))
}

/// The answers of a direct impact against the textbook formulas, with numbers too large, too small or too nearly equal
/// for the first formula that comes to mind.
#[test]
fn of_nasty_direct_impacts() {
    let cases = [
        ["3 kg", "2 kg", "1000.001 m/s", "1000 m/s", "0.7"],
        ["1 kg", "1 kg", "1000000.001 m/s", "1000000 m/s", "0.999999"],
        ["0.25 kg", "5.97e24 kg", "12 m/s", "0 m/s", "0.7"],
        ["5.97e24 kg", "0.25 kg", "30 km/s", "-12 m/s", "0.7"],
        ["0.25 kg", "5.97e24 kg", "12 m/s", "0 m/s", "1"],
        ["1e-27 kg", "1e-27 kg", "3e8 m/s", "-3e8 m/s", "0.1"],
        ["3 kg", "2 kg", "3 m/s", "-2 m/s", "0.7"],
        ["3 kg", "2 kg", "3 m/s", "-2 m/s", "0"],
        ["3 kg", "2 kg", "3 m/s", "-2 m/s", "1"],
        ["0.7 kg", "1 kg", "0.3 m/s", "0 m/s", "0.7"],
        ["0.1 kg", "0.1 kg", "0.1 m/s", "-0.1 m/s", "0"],
        ["2 kg", "3 kg", "3 m/s", "-2 m/s", "0"],
    ];
    for values in cases {
        let names = ["v_A2", "v_B2", "T_1", "T_2", "T_lost", "J_A", "J_B"];
        let (problem, variant) = direct(values, &names);
        let [a, b, u, v, e] = ["m_A", "m_B", "v_A1", "v_B1", "e"].map(|name| rational(&problem, &variant, name));
        let (v_a, v_b) = impact(&a, &b, &u, &v, &e);
        let (before, after) = (energy(&a, &u) + energy(&b, &v), energy(&a, &v_a) + energy(&b, &v_b));
        let impulse = &b * (&v_b - &v);
        let truths = [v_a, v_b, before.clone(), after.clone(), before - after, -impulse.clone(), impulse];
        for (name, truth) in names.iter().zip(truths) {
            let bounded = value(&problem, &variant, name);
            assert!(is_true(bounded, &long(&truth)), "{values:?}: {name} is {truth}, not {bounded:?}");
            let size = bounded.value.abs();
            assert!(bounded.error <= SHARE * size + BESIDE, "{values:?}: {name} is known as {bounded:?}");
        }
        assert_eq!(faults(&problem, &variant, &Truth::of(&problem, &variant)), [""; 0]);
    }
}

#[test]
fn of_the_energy_lost_by_nearly_equal_speeds() {
    let (problem, variant) = direct(["3 kg", "2 kg", "1000.001 m/s", "1000 m/s", "0.7"], &["T_lost"]);
    let lost = value(&problem, &variant, "T_lost");
    // 6/5 kg (1 - 0.49) (1 mm/s)^2 / 2
    assert!((lost.value - 3.06e-7).abs() < 1e-21 && lost.error < 1e-20, "{lost:?}");
}

#[test]
fn of_answers_that_are_zero() {
    let zeros = [
        (["2 kg", "2 kg", "3 m/s", "0 m/s", "1"], "v_A2"),
        (["0.7 kg", "1 kg", "0.3 m/s", "0 m/s", "0.7"], "v_A2"),
        (["2 kg", "3 kg", "3 m/s", "-2 m/s", "0"], "v_B2"),
        (["3 kg", "2 kg", "3 m/s", "-2 m/s", "1"], "T_lost"),
        (["0.1 kg", "0.3 kg", "0.3 m/s", "-0.1 m/s", "1"], "T_lost"),
    ];
    for (values, name) in zeros {
        let (problem, variant) = direct(values, &[name]);
        let zero = value(&problem, &variant, name);
        assert!(zero.value == 0.0 && zero.error < 1e-60, "{values:?}: {name} is {zero:?}");
    }
}

/// A fall through a picometre, thrown down at 3 m/s: the textbook root of the quadratic for the time loses every digit.
#[test]
fn of_the_small_root() {
    let scene = "
axes: { y: upwards }
plane: vertical
bodies:
  A: { name: the ball }
stages:
  - fall: { body: A, height: h }";
    let (problem, variant) = solved(&sheet(scene, &[("h", "1e-12 m"), ("v_A1", "-3 m/s")], &["dt", "v_A2"]));
    assert_eq!(faults(&problem, &variant, &Truth::of(&problem, &variant)), [""; 0]);
    // 2 h / (v + sqrt(v^2 + 2 g h)), with the root by hand.
    let (h, g) = (long(&rational(&problem, &variant, "h")), long(&rational(&problem, &variant, "g")));
    let root = (long_f64(9.0) + long_f64(2.0) * g * h.clone()).sqrt();
    let time = long_f64(2.0) * h / (long_f64(3.0) + root);
    let found = value(&problem, &variant, "dt");
    assert!(is_true(found, &time), "{found:?} is not {}", rough(&time));
    assert!(found.error < 1e-22, "{found:?}");
}

/// A million bounces that lose a millionth each: with the nearest number for e the textbook's sums are off by 1.2e-11.
#[test]
fn of_sums_where_e_is_nearly_1() {
    let scene = "
axes: { y: upwards }
plane: vertical
bodies:
  A: { name: the ball }
stages:
  - bounces: { body: A, restitution: e, count: n }";
    let given = [("h_0", "4 m"), ("e", "0.999999"), ("n", "1000000")];
    let (problem, variant) = solved(&sheet(scene, &given, &["t_n", "h_n", "t_total"]));
    // From 50 digits.
    for (name, right) in
        [("t_n", 1_141_668.934_222_207), ("h_n", 0.541_340_591_605_227_6), ("t_total", 1_806_093.660_895_641_6)]
    {
        let found = value(&problem, &variant, name);
        assert!((found.value / right - 1.0).abs() < 1e-15 && found.error < 1e-14 * right, "{name}: {found:?}");
    }
}
