//! What a question says of its fields, and how it is called, in every target.

use std::collections::BTreeSet;

use momentous::exercise::Item;
use momentous::export::{Question, TARGETS};

use super::bank::{all_forms, carts, exported, text, unpacked, variants};

/// Everything that a target writes of items, as one text.
fn written(target: &str, items: &[Item]) -> String {
    let bytes = exported(target, items);
    let is_package = bytes.starts_with(b"PK");
    if is_package { unpacked(bytes).into_iter().map(|(_, content)| content).collect() } else { text(bytes) }
}

/// The first variant of the first form of a problem.
fn item_of(id: &str) -> Item {
    let (problem, form) = all_forms().iter().find(|(problem, _)| problem.id() == id).unwrap();
    variants(problem, *form, [1]).pop().unwrap()
}

#[test]
fn every_target_says_how_a_number_is_written_and_what_its_sign_says() {
    for target in TARGETS {
        let text = written(target.name, &[carts()]);
        assert!(text.contains("Type a number with a point for the decimals"), "{}", target.name);
        assert!(text.contains("positive to the right, negative to the left"), "{}", target.name);
        assert!(text.contains("Write numbers to three significant figures."), "{}", target.name);
        assert!(!text.contains("State its direction"), "{}", target.name);
    }
}

#[test]
fn components_and_several_values_are_labelled_at_their_fields() {
    let (vector, roots) = (item_of("angular-momentum/bolas"), item_of("concepts/two-roots"));
    for target in TARGETS {
        let text = written(target.name, std::slice::from_ref(&roots));
        assert!(text.contains("the smaller") && text.contains("the greater"), "{}", target.name);
        let text = written(target.name, std::slice::from_ref(&vector));
        let labels = [["x:", "y:"], ["\u{2013} x", "\u{2013} y"], ["\\u2013 x", "\\u2013 y"]];
        assert!(labels.iter().any(|several| several.iter().all(|label| text.contains(label))), "{}", target.name);
    }
}

#[test]
fn no_two_variants_are_called_alike() {
    let mut titles = BTreeSet::new();
    let mut count = 0;
    for (problem, form) in all_forms().iter().take(12) {
        for item in variants(problem, *form, 1..4) {
            assert!(!Question::new(&item).is_empty());
            let name = written("moodle", std::slice::from_ref(&item));
            let name = name.split("<name><text>").nth(1).unwrap().split('<').next().unwrap().to_owned();
            assert!(name.contains(&item.code), "{name}");
            titles.insert(name);
            count += 1;
        }
    }
    assert_eq!(titles.len(), count);
    let items = [item_of("impact/two-carts"), carts()];
    for target in ["qti3", "canvas", "numbas"] {
        let text = written(target, &items);
        assert!(text.contains("a quiz"), "{target}");
        for item in &items {
            assert!(text.contains(&format!("{}, forward, {}", item.sheet.title, item.code)), "{target}");
        }
    }
}

#[test]
fn formulas_to_choose_from_are_mathematics_in_every_target() {
    let item = item_of("concepts/recoil-in-symbols");
    for target in TARGETS {
        let text = written(target.name, std::slice::from_ref(&item));
        assert!(!text.contains("m_B*E") && !text.contains("sqrt(2*"), "{}", target.name);
    }
}

#[test]
fn r_exams_has_one_field_as_its_own_kind_with_its_points() {
    let text = written("rexams", &[item_of("impulse/capsule-braking")]);
    assert!(
        text.contains("\nextype: num\n") && !text.contains("exclozetype") && text.contains("points = \"2\""),
        "{text}"
    );
    let several = written("rexams", &[carts()]);
    assert!(several.contains("\nextype: cloze\n") && several.contains("points = \"2|2|1\""), "{several}");
    assert!(several.contains("\\\\begin{tikzpicture}") && several.contains("include_tikz"), "LaTeX reads no SVG");
}
