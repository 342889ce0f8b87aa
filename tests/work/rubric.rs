//! The points for the work: the default, and what a rubric gives.

use std::sync::Arc;

use momentous::bank::Bank;
use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::problem::{compile, load};

/// Momentum before and after, and nothing of restitution.
const LINES: &str = "m_A v_A1 + m_B v_B1 = m_A v_A2 + m_B v_B2";

fn source(rubric: &str) -> Source {
    let source = Bank::built_in().find("impact/two-carts").unwrap().clone();
    Source::new("two-carts.yaml", &format!("{rubric}{}", source.text))
}

/// The points for the lines, of all.
fn points(rubric: &str) -> (u32, u32) {
    let problem = Arc::new(compile(load(source(rubric)).unwrap(), None).unwrap());
    let (report, _) = Exercise::draw(&problem, 0, 1).unwrap().judge_work(LINES, DecimalMark::Point);
    (report.points, report.out_of)
}

fn fault(rubric: &str) -> String {
    let faults = load(source(rubric)).and_then(|loaded| compile(loaded, None)).err().unwrap();
    faults.to_string()
}

#[test]
fn each_law_and_each_answer_is_worth_one_unless_the_rubric_says_otherwise() {
    // Momentum, restitution and the energy lost, and three answers.
    assert_eq!(points(""), (1, 6));
    assert_eq!(points("rubric: { work: { momentum: 2, restitution: 1, answer: 1 } }\n"), (2, 6));
    assert_eq!(points("rubric: { work: { conservation-of-momentum: 3, momentum: 2, answer: 0 } }\n"), (3, 3));
}

#[test]
fn points_for_what_the_scene_has_not_are_refused() {
    let said = fault("rubric: { work: { momentun: 2 } }\n");
    assert!(said.contains("`momentun`") && said.contains("did you mean `momentum`?"), "{said}");
    let said = fault("rubric: { work: { bouncing: 2 } }\n");
    assert!(said.contains("no law of this scene is or belongs to `bouncing`"), "{said}");
    let said = fault("rubric: { work: { momentum: 0 } }\n");
    assert!(said.contains("the work is worth no points"), "{said}");
    let said = fault("rubric: { work: { momentum: 1000 } }\n");
    assert!(said.contains("more than 100"), "{said}");
}
