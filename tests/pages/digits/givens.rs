//! How givens are printed, and that they lead to the printed answers.

use std::sync::Arc;

use momentous::bank::{Outcome, Promise, Seeds, audit};
use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::{compile, load};
use momentous::render::Renderer;

/// A cart that meets a post and comes back, with these givens.
fn problem(given: &str, asked: &str) -> Source {
    let text = format!(
        "\
id: a/b
title: B
level: intro
scene:
  axes: {{ x: to the right }}
  bodies: {{ A: {{ name: the cart, mass: m_A }} }}
  surfaces: {{ post: {{ name: the post, normal: to the left }} }}
  stages:
    - impact: {{ body: A, against: post, restitution: e }}
given:
{given}
text: The cart ({{{{ m_A }}}}) {{{{ v_A1 | motion }}}} and hits a post with $e$ = {{{{ e }}}}.
ask:
  - {{ find: {asked} }}
"
    );
    Source::new("b.yaml", &text)
}

fn text(given: &str, seed: u64) -> String {
    let problem = Arc::new(compile(load(problem(given, "v_A2, unit: m/s")).unwrap(), None).unwrap());
    Exercise::draw(&problem, 0, seed).unwrap().sheet().statement.replace('\u{a0}', " ")
}

#[test]
fn ranges_print_the_decimals_of_their_step() {
    let given =
        "  m_A: { min: 1, max: 2, step: 0.25, unit: kg }\n  v_A1: { min: 5, max: 6.0, step: 1, unit: m/s }\n  e: 0.50";
    for seed in 1..20 {
        let text = text(given, seed);
        let mass = text.split_once('(').and_then(|(_, rest)| rest.split_once(" kg")).unwrap().0;
        assert_eq!(mass.split_once('.').unwrap().1.len(), 2, "{text}");
        assert!(text.contains("at 5.0 m/s") || text.contains("at 6.0 m/s"), "{text}");
        assert!(text.contains("= 0.50."), "{text}");
    }
}

#[test]
fn fixed_values_print_as_they_are_written() {
    let text = text("  m_A: 12.0 kg\n  v_A1: 50 m/s\n  e: 1/3", 1);
    assert_eq!(text, "The cart (12.0 kg) moves at 50 m/s to the right and hits a post with $e$ = 1/3.");
}

/// What the audit says of the promise that the sheet leads to the key.
fn from_the_sheet(given: &str, asked: &str) -> Outcome {
    let audit = audit(&problem(given, asked), Seeds { drawn: 20, simulated: 1 }, &Renderer::new(None).unwrap());
    assert_eq!(audit.faults, None);
    let finding = audit.forms[0].promises.iter().find(|finding| finding.promise == Promise::FromTheSheet);
    finding.unwrap().outcome.clone()
}

#[test]
fn a_number_that_is_printed_rounded_and_shows_in_the_answer_is_found_out() {
    let given = |e: &str| format!("  m_A: 12.0 kg\n  v_A1: {{ min: 2, max: 9, step: 0.5, unit: m/s }}\n  e: {e}");
    let asked = "v_A2, unit: m/s, figures: 5";
    for calculation in ["1/3", "sin(pi/5)^2"] {
        assert_eq!(
            from_the_sheet(&given(calculation), asked),
            Outcome::Kept,
            "{calculation} is printed as it is written"
        );
    }
    // It is printed beside the mass that it follows from, to three figures.
    let derived = given("0.912345*m_A/(m_A + 8 kg)");
    assert_eq!(from_the_sheet(&derived, asked), Outcome::Kept, "within one per cent it is right");
    let strict = from_the_sheet(&derived, "v_A2, unit: m/s, figures: 5, tolerance: to figures");
    assert!(matches!(&strict, Outcome::Broken(said) if said.contains("the printed numbers give")), "{strict:?}");
}
