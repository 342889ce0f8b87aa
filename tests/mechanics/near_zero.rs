//! What is small beside its problem is judged by itself: neither nothing nor the opposite is right for it.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::{Drawer, Exercise};
use momentous::fault::Source;
use momentous::grade::{DecimalMark, Verdict};
use momentous::problem::{Scheme, compile, load};

fn exercise(yaml: &str) -> Exercise {
    let loaded = load(Source::new("small.yaml", yaml)).unwrap_or_else(|faults| panic!("{faults}"));
    let problem = Arc::new(compile(loaded, None).unwrap_or_else(|faults| panic!("{faults}")));
    Exercise::draw(&problem, 0, 1).unwrap_or_else(|reason| panic!("{reason}"))
}

fn verdict(exercise: &Exercise, part: &str, answer: &str) -> Verdict {
    let answers = BTreeMap::from([(part.to_owned(), answer.to_owned())]);
    let report = exercise.grade(&answers, DecimalMark::Point);
    report.parts.iter().find(|reported| reported.id == part).expect("the part is asked").verdict
}

/// A body at 30 m/s meets one at rest that is `ratio` times as heavy.
fn meeting(ratio: u64) -> Exercise {
    exercise(&format!(
        "
id: impact/small-and-large
title: A small body and a large one
level: core
scene:
  axes: {{ x: to the right }}
  bodies:
    A: {{ name: the small body }}
    B: {{ name: the large body }}
  stages:
    - impact: {{ between: [A, B], restitution: e }}
given:
  m_A: 2 g
  m_B: {} g
  v_A1: 30 m/s
  v_B1: 0 m/s
  e: 0.5
text: >
  A small body ({{{{ m_A }}}}) {{{{ v_A1 | motion }}}} and hits a large one ({{{{ m_B }}}}), which {{{{ v_B1 | motion }}}}. The coefficient of
  restitution is {{{{ e }}}}.
ask:
  - {{ find: v_B2, unit: m/s }}
  - {{ find: T_B2, unit: J }}
  - {{ find: J_B, unit: N s }}
",
        2 * ratio
    ))
}

/// By hand: `v = (1 + e) v_A/(1 + ratio)`, `T = m_B v²/2`, `J = m_B v`.
fn keys(ratio: u64) -> [(&'static str, f64, &'static str); 3] {
    #[allow(clippy::cast_precision_loss, reason = "a million at most")]
    let ratio = ratio as f64;
    let speed = 1.5 * 30.0 / (1.0 + ratio);
    let mass = 0.002 * ratio;
    [("v_B2", speed, "m/s"), ("T_B2", mass * speed * speed / 2.0, "J"), ("J_B", mass * speed, "N s")]
}

#[test]
fn small_answers_are_judged_by_themselves() {
    for power in 0..=6 {
        let ratio = 10_u64.pow(power);
        let exercise = meeting(ratio);
        for (part, key, unit) in keys(ratio) {
            let answered = |factor: f64| verdict(&exercise, part, &format!("{:.6e} {unit}", factor * key));
            let told = format!("{part} at a ratio of {ratio}");
            assert_eq!(answered(1.0), Verdict::Right, "{told}");
            assert!(!verdict(&exercise, part, &format!("0 {unit}")).is_right(), "{told}: nothing");
            // The sign of an energy is a slip of the pen, and costs nothing anywhere.
            let opposite = if part == "T_B2" { Verdict::RightWithNote } else { Verdict::SenseReversed };
            assert_eq!(answered(-1.0), opposite, "{told}");
            for factor in [0.98, 1.02] {
                assert_ne!(answered(factor), Verdict::Right, "{told}: {factor} times the key");
            }
        }
    }
}

/// A ball is slowed from 5.01 to 5.00 m/s: 1.50 kg × 0.01 m/s.
fn slowed(after: &str) -> Exercise {
    exercise(&format!(
        "
id: impulse/slowed-a-little
title: Slowed a little
level: core
scene:
  axes: {{ x: to the right }}
  bodies:
    ball: {{ name: the ball }}
  stages:
    - blow: {{ body: ball, by: the brush }}
given:
  m_ball: 1.50 kg
  v_ball1: 5.01 m/s
  v_ball2: {after} m/s
text: A ball ({{{{ m_ball }}}}) {{{{ v_ball1 | motion }}}}. A brush touches it, and now it {{{{ v_ball2 | motion }}}}.
ask:
  - {{ find: J_ball, unit: N s }}
"
    ))
}

#[test]
fn a_small_difference_is_judged_by_itself() {
    let exercise = slowed("5.00");
    for (answer, right) in
        [("-0.0150 N s", true), ("0 N s", false), ("0.0150 N s", false), ("-0.02 N s", false), ("-0.0151 N s", true)]
    {
        assert_eq!(verdict(&exercise, "J_ball", answer).is_right(), right, "{answer}");
    }
}

#[test]
fn numbers_that_let_rounding_turn_the_sign_are_drawn_by_the_first_scheme_only() {
    let source = Bank::built_in().find("impulse/lift-cable").expect("it is in the bank").clone();
    let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
    let mut drawer = Drawer::new(&problem, 0).unwrap();
    // The lift comes to 0.0032 ft/s, from impulses of thousands of pound seconds.
    let mut is_ill_chosen = |scheme| {
        let exercise = drawer.draw_by(42, scheme).unwrap();
        let worked = exercise.worked();
        worked.is_ill_chosen(&worked.form.parts[0])
    };
    assert!(is_ill_chosen(Scheme::Solvable) && !is_ill_chosen(Scheme::Markable));
}

#[test]
fn what_is_exactly_nothing_is_judged_by_what_cancels_in_it() {
    // 1.50 kg × 5.01 m/s stands on both sides: 1 % of both is 0.15 N s.
    let exercise = slowed("5.01");
    for (answer, right) in [("0 N s", true), ("0.14 N s", true), ("-0.14 N s", true), ("0.2 N s", false)] {
        assert_eq!(verdict(&exercise, "J_ball", answer).is_right(), right, "{answer}");
    }
}

/// A ball that leaves a cushion as it came: its velocities before and after by these two values.
fn unchanged(values: &[(&str, &str); 2]) -> String {
    let both = [1, 2]
        .into_iter()
        .flat_map(|instant| values.map(|(name, value)| (name.replace('#', &instant.to_string()), value)));
    let given: Vec<String> = both.clone().map(|(name, value)| format!("  {name}: {value}")).collect();
    let told: Vec<String> = both.map(|(name, _)| format!("{{{{ {name} }}}}")).collect();
    format!(
        "
id: impulse/no-impulse
title: No impulse
level: core
scene:
  axes: {{ x: to the right, y: upwards }}
  bodies:
    ball: {{ name: the ball }}
  stages:
    - blow: {{ body: ball, by: the cushion }}
given:
  m_ball: 0.2 kg
{}
text: A ball ({{{{ m_ball }}}}) meets a cushion; its velocity is told by {}.
ask:
  - {{ find: angle_J_ball, unit: deg, from: +x, sense: counter-clockwise }}
",
        given.join("\n"),
        told.join(", ")
    )
}

#[test]
fn the_direction_of_a_vector_that_is_zero_is_a_fault() {
    let by_components = [("v_ball#.x", "3 m/s"), ("v_ball#.y", "4 m/s")];
    let by_angle = [("speed_ball#", "3 m/s"), ("angle_ball#", "35 deg")];
    for values in [by_components, by_angle] {
        let loaded = load(Source::new("zero.yaml", &unchanged(&values))).unwrap_or_else(|faults| panic!("{faults}"));
        let fault = compile(loaded, None).expect_err("there is no direction").to_string();
        assert!(fault.contains("that vector is zero and has none"), "{fault}");
    }
}

/// A blow between two speeds whose directions are right angles apart, or opposite: the sine of 180° and the cosine of 90° are nothing.
#[test]
fn directions_along_an_axis_leave_nothing_across_it() {
    for (angles, across, impulse, direction) in
        [(["0 deg", "180 deg"], "J_A.y", "J_A.x", "180 deg"), (["90 deg", "-90 deg"], "J_A.x", "J_A.y", "-90 deg")]
    {
        let [before, after] = angles;
        let exercise = exercise(&format!(
            "
id: impulse/turned-back
title: A puck is turned back
level: core
scene:
  axes: {{ x: to the east, y: to the north }}
  bodies:
    A: {{ name: the puck }}
  stages:
    - blow: {{ body: A, by: a stick }}
given:
  m_A: 2 kg
  speed_A1: 3 m/s
  angle_A1: {before}
  speed_A2: 4 m/s
  angle_A2: {after}
text: >
  A puck ({{{{ m_A }}}}) moves at {{{{ speed_A1 }}}} ({{{{ angle_A1 }}}} from +x), and after a blow at {{{{ speed_A2 }}}} ({{{{ angle_A2 }}}} from +x).
ask:
  - {{ find: J_A.x, unit: N s }}
  - {{ find: J_A.y, unit: N s }}
  - {{ find: angle_J_A, unit: deg, from: +x, sense: counter-clockwise }}
"
        ));
        // By hand: 2 kg (-4 m/s - 3 m/s).
        for (part, answer) in [(across, "0 N s"), (impulse, "-14 N s"), ("angle_J_A", direction)] {
            assert_eq!(verdict(&exercise, part, answer), Verdict::Right, "{part} from {before} to {after}");
        }
    }
}
