//! What `momentous check` finds of a form, and what its author may mean all the same.

use momentous::bank::Outcome;
use momentous::bank::Promise;
use momentous::bank::Seeds;
use momentous::bank::audit;
use momentous::fault::Source;
use momentous::render::Renderer;

/// Two gliders of one mass that exchange their velocities, so that an answer is always a given.
const TWINS: &str = "\
id: a/b
title: B
level: intro
scene:
  axes: { x: to the right }
  bodies: { A: { name: glider A, mass: m }, B: { name: glider B, mass: m } }
  stages: [{ impact: { between: [A, B], restitution: 1 } }]
given:
  m: { min: 1, max: 6, step: 0.5, unit: kg }
  v_A1: { min: 2, max: 6, step: 0.5, unit: m/s }
  v_B1: { min: -3, max: -1, step: 0.5, unit: m/s }
text: Glider A ({{ m }}) {{ v_A1 | motion }} and hits its twin, which {{ v_B1 | motion }}.
ask: [{ find: v_B2, unit: m/s }]
";

const KINDS: &str = "\
id: a/c
title: C
level: intro
scene:
  axes: { x: to the right }
  bodies: { A: { name: glider A }, B: { name: glider B } }
  stages: [{ impact: { between: [A, B], plastic: true } }]
given:
  m_A: { min: 1, max: 6, step: 0.5, unit: kg }
  m_B: { min: 1, max: 6, step: 0.5, unit: kg }
  v_A1: { min: 2, max: 6, step: 0.5, unit: m/s }
  v_B1: 0 m/s
text: Glider A ({{ m_A }}, {{ m_B }}) {{ v_A1 | motion }} and hits glider B, which {{ v_B1 | motion }}.
ask: [{ classify: impact }]
";

const THROWN: &str = "\
id: a/d
title: D
level: intro
scene:
  axes: { y: upwards }
  plane: vertical
  bodies: { A: { name: the ball } }
  stages: [{ blow: { body: A, by: the bat, duration: dt } }]
given:
  m_A: { min: 0.1, max: 0.2, step: 0.01, unit: kg }
  v_A1: 0 m/s
  v_A2: { min: 9, max: 10, step: 0.1, unit: m/s }
  dt: { min: 40, max: 50, step: 1, unit: ms }
text: A bat strikes a ball ({{ m_A }}) straight up; it {{ v_A1 | motion }}, and leaves at {{ v_A2 }} after {{ dt }}.
ask: [{ find: F_avg_A, unit: N }]
";

/// A crate that rebounds to the left, and is said to slide to the right then.
const REBOUNDING: &str = "\
id: a/e
title: E
level: intro
scene:
  axes: { x: to the right }
  bodies: { A: { name: the crate }, B: { name: the block } }
  stages:
    - impact: { between: [A, B], restitution: 0.8 }
    - push: { body: A, during: dt, forces: [{ friction: { kinetic: 0.2 } }] }
given:
  m_A: 2 kg
  m_B: 8 kg
  v_A1: { min: 5, max: 7, step: 0.1, unit: m/s }
  v_B1: 0 m/s
  dt: 0.2 s
text: A crate ({{ m_A }}) slides {{ v_A1 | motion }} into a block ({{ m_B }}) that {{ v_B1 | motion }}, and slides on for {{ dt }}.
ask: [{ find: v_A3, unit: m/s }]
";

/// One component of the vector that is asked stays as it is given; the vector does not.
const TURNED: &str = include_str!("../fixtures/problems/torque_on_all.yaml");

/// One of its answers is the same for every seed, which it allows.
const ONE_CONSTANT: &str = include_str!("../fixtures/found/one_constant_part.yaml");

/// A file, what is added to it, a promise, what is found of that and a word of the remark.
const FOUND: &[(&str, &str, Promise, &str, &str)] = &[
    (TWINS, "", Promise::NotGiven, "broken", "`v_B2` equals a given"),
    (TWINS, "allow: [equals-given]\n", Promise::NotGiven, "kept", ""),
    (TURNED, "", Promise::NotGiven, "kept", ""),
    (TWINS, "", Promise::Variety, "kept", ""),
    (KINDS, "", Promise::Variety, "noted", "the same answers"),
    (KINDS, "allow: [one-answer]\n", Promise::Variety, "kept", ""),
    (KINDS, "allow: [one-sheet]\n", Promise::Variety, "noted", "the same answers"),
    (ONE_CONSTANT, "", Promise::Varies, "kept", ""),
    (REBOUNDING, "", Promise::Draws, "broken", "attempts: in the push, the crate would have to slide"),
    (REBOUNDING, "", Promise::Draws, "broken", "if that is meant, write `direction` in that stage"),
    (THROWN, "", Promise::Neglected, "noted", "% of the change of momentum of the ball"),
];

fn found(text: &str, promise: Promise) -> Outcome {
    let audit = audit(&Source::new("a.yaml", text), Seeds { drawn: 200, simulated: 1 }, &Renderer::new(None).unwrap());
    audit.forms.first().and_then(|form| form.outcome(promise)).cloned().unwrap()
}

#[test]
fn what_is_found_and_what_is_meant() {
    for (file, added, promise, outcome, remark) in FOUND {
        let outcome_found = found(&format!("{file}{added}"), *promise);
        assert_eq!(outcome_found.name(), *outcome, "{added}{}: {outcome_found:?}", promise.name());
        assert!(outcome_found.remark().unwrap_or_default().contains(remark), "{outcome_found:?}");
    }
}

#[test]
fn a_constant_part_is_broken_with_the_way_out() {
    let outcome = found(&ONE_CONSTANT.replace("allow: [one-answer]\n", ""), Promise::Varies);
    assert_eq!(outcome.name(), "broken");
    assert_eq!(outcome.remark(), Some("`share` is always 88.9; if that is meant, write `allow: [one-answer]`"));
}

#[test]
fn the_text_that_prints_no_number_has_one_sheet() {
    let silent = KINDS.replace("({{ m_A }}, {{ m_B }}) {{ v_A1 | motion }}", "moves to the right");
    let outcome = found(&silent, Promise::Variety);
    assert!(outcome.remark().is_some_and(|remark| remark.contains("the same sheet")), "{outcome:?}");
    assert_eq!(found(&format!("{silent}allow: [one-sheet]\n"), Promise::Variety), Outcome::Kept);
}
