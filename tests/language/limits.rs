//! What one problem may ask for (`docs/language/reference.md`, *Limits*): as much as the limit is taken, one more is refused at its place.

use momentous::fault::Source;
use momentous::problem::{LONGEST_FILE, compile, load};

const CARTS: &str = "\
id: own/carts
title: Carts
level: intro
scene:
  axes: { x: to the right }
  bodies:
    A: { name: cart A, mass: m_A }
    B: { name: cart B, mass: m_B }
  stages:
    - impact: { between: [A, B], restitution: 1 }
given:
  m_A: { min: 4, max: 8, step: 1, unit: kg }
  m_B: { min: 1, max: 3, step: 1, unit: kg }
  v_A1: { min: 2, max: 5, step: 1, unit: m/s }
  v_B1: 0 m/s
text: >
  Cart A ({{ m_A }}) moves {{ v_A1 | motion }}; cart B ({{ m_B }}) {{ v_B1 | motion }}.
ask:
  - { find: v_A2, unit: m/s, points: 2 }
";

/// What is told of a file; nothing where it is taken.
fn told(text: &str) -> String {
    let compiled = load(Source::new("own.yaml", text)).and_then(|loaded| compile(loaded, None));
    compiled.map_or_else(|faults| faults.to_string(), |_| String::new())
}

/// An entry so many times, with the number of each for `#`.
fn repeated(entry: &str, count: usize) -> String {
    (0..count).map(|number| entry.replace('#', &number.to_string())).collect()
}

/// The carts, with so many more entries behind a line.
fn with(line: &str, entry: &str, count: usize) -> String {
    CARTS.replacen(&format!("{line}\n"), &format!("{line}\n{}", repeated(entry, count)), 1)
}

#[test]
fn one_more_than_a_limit_is_refused_at_its_place() {
    // The line of the list, what is added, how many are there already, the limit, and how they are called.
    let rows = [
        ("  bodies:", "    C#x: { name: cart, mass: m_A }\n", 2, 64, "bodies", "own.yaml:6:3"),
        ("  stages:", "    - impact: { between: [A, B], restitution: 1 }\n", 1, 64, "stages", "own.yaml:9:3"),
        ("given:", "  q#: 1 kg\n", 4, 512, "quantities", "own.yaml:11:1"),
        ("ask:", "  - { find: v_B2, id: q#, unit: m/s, points: 2 }\n", 1, 64, "questions", "own.yaml:18:1"),
    ];
    for (line, entry, already, most, what, place) in rows {
        let refusal = format!("these are {} {what}, and there may be at most {most}", most + 1);
        assert!(!told(&with(line, entry, most - already)).contains("there may be at most"), "{what}");
        let message = told(&with(line, entry, most - already + 1));
        assert!(message.contains(&refusal) && message.contains(place), "{message}");
    }
}

#[test]
fn forms_and_what_they_ask_for_are_bounded_too() {
    let ask = "ask:\n  - { find: v_A2, unit: m/s, points: 2 }\n";
    let forms = |count: usize, questions: usize| {
        let questions = "      - { find: v_A2, unit: m/s, points: 2 }\n".repeat(questions);
        let forms = repeated(&format!("  f#:\n    ask:\n{questions}"), count);
        told(&CARTS.replacen(ask, &format!("forms:\n{forms}"), 1))
    };
    let too_many = [(65, 1, "these are 65 forms", "own.yaml:18:1"), (1, 65, "these are 65 questions", "own.yaml:20:5")];
    for (count, questions, refusal, place) in too_many {
        let message = forms(count, questions);
        assert!(message.contains(refusal) && message.contains(place), "{message}");
    }
    assert!(!forms(64, 1).contains("there may be at most"));
    assert!(!forms(1, 64).contains("there may be at most"));
}

#[test]
fn a_file_is_read_up_to_its_longest() {
    let filled = |bytes: usize| format!("{CARTS}# {}\n", "a".repeat(bytes - CARTS.len() - 3));
    assert_eq!(told(&filled(LONGEST_FILE)), "");
    let message = told(&filled(LONGEST_FILE + 1));
    assert!(message.contains("the file has 262145 bytes, and a problem has at most 262144"), "{message}");
}

#[test]
fn lists_lie_in_one_another_up_to_a_depth() {
    let nested = |depth: usize| told(&format!("{CARTS}tags: {}{}\n", "[".repeat(depth), "]".repeat(depth)));
    let refusal = "lists and mappings are nested more than 32 deep";
    assert!(!nested(31).contains(refusal));
    let message = nested(33);
    assert!(message.contains(refusal) && message.contains("own.yaml:20:"), "{message}");
}

#[test]
fn of_many_faults_fifty_are_printed() {
    let faulty = |count: usize| {
        told(&format!("{CARTS}{}", repeated("k#: 1\n", count))).matches("is not a key of the file").count()
    };
    assert_eq!([faulty(50), faulty(60)], [50, 50]);
}
