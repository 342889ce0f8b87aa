//! Questions whose answer is not one number, taken from the file to the mark.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::problem::{compile, load};

/// One variant of a problem whose givens are all fixed.
fn exercise(text: &str) -> Exercise {
    let problem =
        compile(load(Source::new("asks.yaml", text)).unwrap(), None).unwrap_or_else(|faults| panic!("{faults}"));
    Exercise::draw(&Arc::new(problem), 0, 1).unwrap_or_else(|reason| panic!("{reason}"))
}

/// The verdict on an answer to the part of that name.
fn verdict(exercise: &Exercise, part: &str, answer: &str) -> String {
    let answers = BTreeMap::from([(part.to_owned(), answer.to_owned())]);
    let report = exercise.grade(&answers, DecimalMark::Point);
    report.parts.iter().find(|own| own.id == part).unwrap().verdict.to_string()
}

fn printed(exercise: &Exercise) -> Vec<String> {
    exercise.worked().form.parts.iter().map(|part| exercise.printed(part)).collect()
}

/// m v is kept along both axes: (2 kg)(3, 0) m/s = (1 kg)(1, 2) m/s + (1 kg)(5, -2) m/s.
const SKATERS: &str = "
id: test/skaters
title: Skaters
level: intro
scene:
  axes: { x: east, y: north }
  bodies: { A: { name: the first skater }, B: { name: the second skater } }
  stages: [ { separate: { called: push, from: W, into: [A, B] } } ]
given: { m_A: 1 kg, m_B: 1 kg, v_W1.x: 3 m/s, v_W1.y: 0 m/s, v_A2.x: 1 m/s, v_A2.y: 2 m/s }
text: 'Two skaters ({{ m_A }}, {{ m_B }}) part; {{ v_W1.x }}, {{ v_A2.x }}, {{ v_A2.y }}.'
ask: [ { find: v_B2, unit: m/s } ]
";

#[test]
fn a_vector_is_asked_by_its_components() {
    let skaters = exercise(SKATERS);
    assert_eq!(printed(&skaters), ["(5.00, -2.00) m/s"]);
    let verdicts = [
        ("(5, -2) m/s", "right"),
        ("5 i - 2 j m/s", "right"),
        ("(18, -7.2) km/h", "right"),
        ("5.385 m/s at 21.8° below +x", "right"),
        ("(-2, 5) m/s", "components_exchanged"),
        ("(-5, 2) m/s", "sense_reversed"),
        ("(5, -2)", "unit_missing"),
        ("(5, 2) m/s", "component_sign"),
        ("(4, 3) m/s", "wrong"),
    ];
    for (answer, code) in verdicts {
        assert_eq!(verdict(&skaters, "v_B2", answer), code, "{answer}");
    }
    let record = skaters.record(None);
    let asked = &record["ask"][0];
    assert_eq!((&asked["kind"], &asked["axes"]), (&"vector".into(), &serde_json::json!(["x", "y"])));
    assert_eq!(asked["value"], serde_json::json!([5.0, -2.0]));
}

/// With B at rest, `v_A2 = (m_A - e m_B) v_A1 / (m_A + m_B)`, which is negative where `e > m_A/m_B = 1/4`.
const BUMPERS: &str = "
id: test/bumpers
title: Bumpers
level: intro
scene:
  axes: { x: to the right }
  bodies: { A: { name: trolley A }, B: { name: trolley B } }
  stages: [ { impact: { between: [A, B], restitution: e } } ]
given: { m_A: 1 kg, m_B: 4 kg, v_A1: 5 m/s, v_B1: 0 m/s }
text: 'Two trolleys ({{ m_A }}, {{ m_B }}) collide; the first {{ v_A1 | motion }}.'
ask: [ { range: e, where: CLAIM } ]
";

#[test]
fn a_range_is_asked_by_what_holds_in_it() {
    let above = exercise(&BUMPERS.replace("CLAIM", "v_A2 < 0 m/s"));
    assert_eq!(printed(&above), ["0.250 < e <= 1"]);
    let verdicts = [
        ("0.25 < e <= 1", "right"),
        ("(0.25, 1]", "right"),
        ("e > 0.25", "right"),
        ("e >= 0.25", "interval_ends"),
        ("e < 0.25", "interval_half"),
        ("0.5 < e <= 1", "interval_half"),
        ("e > 0.5", "wrong"),
    ];
    for (answer, code) in verdicts {
        assert_eq!(verdict(&above, "e", answer), code, "{answer}");
    }
    let claims = [
        ("v_A2 <= 0 m/s", "0.250 <= e <= 1"),
        ("v_A2 > 0 m/s", "0 <= e < 0.250"),
        ("v_A2 >= 0.5 m/s", "0 <= e <= 0.125"),
        ("v_B2 > 3*v_A2", "0.154 < e <= 1"),
    ];
    for (claim, interval) in claims {
        assert_eq!(printed(&exercise(&BUMPERS.replace("CLAIM", &format!("\"{claim}\"")))), [interval], "{claim}");
    }
}

#[test]
fn a_range_without_a_boundary_is_refused() {
    let text = BUMPERS.replace("CLAIM", "v_A2 < 2 m/s");
    let faults = compile(load(Source::new("asks.yaml", &text)).unwrap(), None).unwrap_err().to_string();
    assert!(faults.contains("the values have no admissible solution"), "{faults}");
}

/// `v_A2 + v_B2 = 2 m/s` and `v_A2^2 + v_B2^2 = 2 + 2 E = 20 (m/s)^2`, so that one is 4 m/s and the other -2 m/s. B is in front.
const RELEASE: &str = "
id: test/release
title: Release
level: intro
scene:
  axes: { x: to the right }
  bodies: { A: { name: trolley A }, B: { name: trolley B } }
  stages: [ { separate: { called: release, from: W, into: [A, B], energy: E } } ]
given: { m_A: 1 kg, m_B: 1 kg, v_W1: 1 m/s, E: 9 J }
text: 'Two trolleys ({{ m_A }}, {{ m_B }}) {{ v_W1 | motion }} and are pushed apart with {{ E }}.'
ask: [ { find: NAME, unit: m/s, roots: every, points: 2 }, { physical: NAME } ]
";

#[test]
fn both_roots_are_asked_and_which_of_them_is_possible() {
    let through = "is impossible, because trolley A would pass through trolley B";
    for (name, roots, right, wrong) in
        [("v_B2", "4.00 m/s or -2.00 m/s", "1", "2"), ("v_A2", "-2.00 m/s or 4.00 m/s", "2", "1")]
    {
        let release = exercise(&RELEASE.replace("NAME", name));
        let reason = if right == "1" { "the greater; the lesser" } else { "the lesser; the greater" };
        assert_eq!(printed(&release), [roots.to_owned(), format!("{reason} {through}")]);
        assert_eq!(verdict(&release, "b", right), "right");
        for other in [wrong, "3", "4", "5"] {
            assert_eq!(verdict(&release, "b", other), "choice_wrong", "{name} {other}");
        }
        let answers = BTreeMap::from([(name.to_owned(), "-2 m/s or 4 m/s".to_owned())]);
        let report = release.grade(&answers, DecimalMark::Point);
        let reached: Vec<String> = report.parts.iter().map(|part| part.verdict.to_string()).collect();
        assert_eq!(reached, ["right", "unanswered"]);
        assert_eq!(
            release
                .grade(&BTreeMap::from([(name.to_owned(), "4 m/s".to_owned())]), DecimalMark::Point)
                .total
                .to_string(),
            "1"
        );
    }
}

#[test]
fn an_equation_with_one_root_leaves_nothing_to_choose() {
    let text = BUMPERS
        .replace("ask: [ { range: e, where: CLAIM } ]", "ask: [ { physical: v_A2 } ]")
        .replace("given: {", "given: { e: 0.5,")
        .replace("first {{", "first with e = {{ e }} {{");
    let faults = compile(load(Source::new("asks.yaml", &text)).unwrap(), None).unwrap_err().to_string();
    assert!(faults.contains("only one value"), "{faults}");
}

/// Each seed offers the author's options in an order of its own; what is right and what is said of an option go with it.
#[test]
fn options_are_marked_by_their_text_and_by_their_letter_on_the_sheet_of_the_seed() {
    let text = include_str!("../../problem_bank/concepts/what-becomes-of-it.yaml");
    let problem = Arc::new(compile(load(Source::new("options.yaml", text)).unwrap(), None).unwrap());
    let (mut orders, mut right) = (std::collections::BTreeSet::new(), std::collections::BTreeSet::new());
    let mut marker = momentous::exercise::Marker::new(&problem, 0, DecimalMark::Point).unwrap();
    for seed in 1..80 {
        let exercise = Exercise::draw(&problem, 0, seed).unwrap();
        let velocity = exercise.record(None)["ask"][0]["value"].as_str().unwrap().to_owned();
        right.insert(velocity.clone());
        let options = &exercise.sheet().parts[0].options;
        assert_eq!(options.last().unwrap(), "None of these.");
        orders.insert(options.clone());
        for (option, letter) in options.iter().zip(["a", "B", "(c)", "D."]) {
            let expected = if *option == velocity { "right" } else { "choice_wrong" };
            let report = marker.mark(exercise.worked(), &[("a", letter)], momentous::grade::Sitting::default());
            assert_eq!(report.parts[0].verdict.to_string(), expected, "{seed}: {letter}");
            assert_eq!(verdict(&exercise, "a", option), expected, "{seed}: {option}");
            let is_told = report.parts[0].message.contains("perfectly plastic");
            assert_eq!(is_told, option.contains("together"), "{seed}: {option}: {}", report.parts[0].message);
        }
    }
    assert_eq!((orders.len(), right.len()), (6, 3), "{orders:?} {right:?}");
}

/// Momentum is one equation for two velocities; for the velocity of the centre of mass it is enough. With e it is enough for both.
#[test]
fn whether_there_is_enough_information_is_answered_by_counting_equations() {
    const IMPACT: &str = "
id: test/enough
title: Enough
level: core
scene:
  axes: { x: to the right }
  bodies: { A: { name: cart A }, B: { name: cart B } }
  stages: [ { impact: { between: [A, B], restitution: e } } ]
given: { m_A: 2 kg, m_B: 1 kg, v_A1: 3 m/s, v_B1: 0 m/s }
text: 'Cart A ({{ m_A }}) {{ v_A1 | motion }} and hits cart B ({{ m_B }}), which {{ v_B1 | motion }}.'
ask: [ { enough: v_B2 }, { enough: v_G2 } ]
";
    let open = exercise(IMPACT);
    assert_eq!(printed(&open), ["no", "yes"]);
    assert_eq!(verdict(&open, "a", "yes"), "choice_wrong");
    let told = IMPACT.replace("v_B1: 0 m/s }", "v_B1: 0 m/s, e: 0.5 }").replace("}}.'", "}}; e = {{ e }}.'");
    assert_eq!(printed(&exercise(&told)), ["yes", "yes"]);
    // A drawn number that the sheet does not print is not known.
    let untold = IMPACT.replace("v_B1: 0 m/s }", "v_B1: 0 m/s, e: { one_of: [0.25, 0.5] } }");
    assert_eq!(printed(&exercise(&untold)), ["no", "yes"]);
}

/// 0.2 kg at 5 m/s comes back at 3 m/s: 1.0 N s, -1.6 N s and -0.6 N s, of which the longest is drawn as 10 units.
const REBOUND: &str = "
id: test/rebound
title: Rebound
level: core
scene:
  axes: { x: to the right }
  bodies: { A: { name: ball A } }
  surfaces: { wall: { name: the wall, normal: to the left } }
  stages: [ { impact: { body: A, against: wall } } ]
given: { m_A: 0.2 kg, v_A1: 5 m/s, v_A2: -3 m/s }
text: 'Ball A ({{ m_A }}) {{ v_A1 | motion }} and hits a wall; afterwards it {{ v_A2 | motion }}.'
ask: [ { choose: Which diagram is right?, pictures: impulse-momentum } ]
";

#[test]
fn pictures_are_those_of_usual_mistakes_and_no_two_look_alike() {
    let problem = Arc::new(compile(load(Source::new("asks.yaml", REBOUND)).unwrap(), None).unwrap());
    let arrow = |size: &str, way: &str| format!("{size} units long to the {way}");
    let (left, right) = ("left", "right");
    let all = [
        (None, [arrow("6.25", right), arrow("10.0", left), arrow("3.75", left)]),
        // Sizes without their signs: from 1.0 N s to 0.6 N s, so 0.4 N s less.
        (Some("sign-lost"), [arrow("10.0", right), arrow("4.00", left), arrow("6.00", right)]),
        (Some("impulse-reversed"), [arrow("6.25", right), arrow("10.0", right), arrow("3.75", left)]),
        (Some("start-momentum-forgotten"), [arrow("10.0", right), arrow("6.00", left), arrow("6.00", left)]),
    ];
    let mut orders = std::collections::BTreeSet::new();
    for seed in 1..30 {
        let exercise = Exercise::draw(&problem, 0, seed).unwrap();
        let mut marker = momentous::exercise::Marker::new(&problem, 0, DecimalMark::Point).unwrap();
        let pictures = &exercise.sheet().parts[0].pictures;
        let mut order = Vec::new();
        for (picture, letter) in pictures.iter().zip(["A", "B", "C", "D"]) {
            let report = marker.mark(exercise.worked(), &[("a", letter)], momentous::grade::Sitting::default());
            let behind = report.parts[0].diagnosis.as_ref().map(|own| own.codes[0]);
            let (_, arrows) = all.iter().find(|(mistake, _)| *mistake == behind).unwrap();
            assert_eq!(picture.caption, format!("Diagram {letter}"));
            let described = arrows.iter().all(|arrow| picture.description.contains(arrow.as_str()));
            assert!(described, "{behind:?}: {}", picture.description);
            assert_eq!(report.parts[0].verdict.to_string() == "right", behind.is_none());
            let alike = pictures.iter().filter(|other| other.shapes == picture.shapes).count();
            assert_eq!(alike, 1);
            order.push(behind);
        }
        assert_eq!(order.len(), 4);
        orders.insert(order);
    }
    assert!(orders.len() > 10, "{}", orders.len());
}
