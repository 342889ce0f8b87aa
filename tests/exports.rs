//! What is exported is read back and marked as its target does: right answers, windows, mistakes, and hostile text.

#![allow(clippy::float_cmp, reason = "fractions are written as they are meant")]
#![allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]

use std::fs;
use std::sync::Arc;

use assert_cmd::Command;
use momentous::bank::Bank;
use momentous::exercise::{Exercise, Item, ItemAnswers, NumberItem};
use momentous::export::Moodle;
use momentous::problem::{compile, load};
use momentous::render::Renderer;
use proptest::prelude::*;

use moodle::{Field, Node};

#[path = "exports/moodle.rs"]
mod moodle;

/// The seeds of each form.
const SEEDS: [u64; 2] = [1, 8];

/// The letters that an idnumber may have.
const LONGEST_ID: usize = 100;

fn exported(items: &[Item]) -> String {
    let mut file = Moodle::new(Vec::new(), Renderer::new(None).unwrap()).unwrap();
    for item in items {
        file.write(item).unwrap();
    }
    String::from_utf8(file.finish().unwrap()).unwrap()
}

fn questions(root: &Node) -> Vec<&Node> {
    root.all("question").filter(|own| own.attribute("type") != "category").collect()
}

/// The numbers of a part.
fn numbers_of(part: &ItemAnswers) -> Vec<&NumberItem> {
    match part {
        ItemAnswers::Number(own) => vec![own],
        ItemAnswers::Roots(all) | ItemAnswers::Vector(all) => all.iter().collect(),
        ItemAnswers::Interval { low, high } => [low, high].into_iter().flatten().map(|own| &**own).collect(),
        _ => Vec::new(),
    }
}

/// The numbers of an item with the points of their parts, in the order of the fields.
fn numbers(item: &Item) -> Vec<(u32, &NumberItem)> {
    item.parts
        .iter()
        .flat_map(|part| numbers_of(&part.answers).into_iter().map(|own| (part.field.points, own)))
        .collect()
}

/// The points of the parts that go along.
fn points_asked(item: &Item) -> u32 {
    let parts = item.parts.iter().filter(|part| !is_left_out(&part.answers));
    parts.map(|part| part.field.points).sum()
}

/// A formula has no place where no usual mistake gives a wrong one.
fn is_left_out(answers: &ItemAnswers) -> bool {
    matches!(answers, ItemAnswers::Formula { mistaken } if mistaken.is_empty())
}

/// Marks every window of a number; gives how many mistakes were met.
fn mark_windows(field: &Field, number: &NumberItem, points: u32, about: &str) -> usize {
    let mut mistakes = 0;
    let printed = format!("{:.*e}", number.figures - 1, number.right);
    if !number.whole {
        assert_eq!(field.mark_number(printed.parse().unwrap()).0, 1.0, "{about}: {printed} {number:?}");
    }
    for window in &number.windows {
        let worth = window.points.0.to_f64().value() / f64::from(points);
        let middle = window.low + (window.high - window.low) / 2.0;
        let (share, said) = field.mark_number(middle);
        assert!((share - worth).abs() < 0.05, "{about}: {middle} earns {share}, {window:?}");
        assert!(window.feedback.iter().all(|own| said.contains(own.as_str())), "{about}: {said:?} {window:?}");
        mistakes += window.mistakes.len();
        if worth == 1.0 {
            assert_eq!(
                [window.low, window.high].map(|end| field.mark_number(end).0),
                [1.0, 1.0],
                "{about}: {window:?}"
            );
        }
        let beside = 1e-7 * (window.high - window.low);
        for outside in [window.low - beside, window.high + beside] {
            let is_within = |own: &momentous::exercise::Window| {
                number
                    .turn
                    .map_or(vec![0.0], |turn| vec![0.0, turn, -turn])
                    .iter()
                    .any(|turn| (own.low - beside / 2.0..=own.high + beside / 2.0).contains(&(outside + turn)))
            };
            if !number.windows.iter().any(is_within) {
                assert_eq!(field.mark_number(outside), (0.0, ""), "{about}: {outside} {number:?}");
            }
        }
    }
    mistakes
}

#[test]
fn every_form_of_the_bank_is_marked_in_moodle_as_here() {
    let bank = Bank::built_in();
    let (mut mistakes, mut typed, mut choices) = (0, 0, 0);
    for source in bank.sources().cloned() {
        let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
        for form in 0..problem.forms().len() {
            let items = SEEDS.map(|seed| Exercise::draw(&problem, form, seed).unwrap().item());
            let root = moodle::read(&exported(&items));
            let questions = questions(&root);
            let kept: Vec<&Item> = items.iter().filter(|item| points_asked(item) > 0).collect();
            assert_eq!(questions.len(), kept.len(), "{}", problem.id());
            for (item, question) in kept.into_iter().zip(questions) {
                let about = question.text_at(&["idnumber"]);
                assert!(!about.is_empty() && about.chars().count() <= LONGEST_ID, "{about}");
                assert_eq!(question.at(&["questiontext", "file"]).is_some(), item.sheet.figure.is_some(), "{about}");
                assert_eq!(question.all("hint").count(), item.sheet.hints.len(), "{about}");
                let solution = moodle::decoded(question.text_at(&["generalfeedback", "text"]));
                assert!(item.solution.sections.iter().all(|own| solution.contains(&own.heading)), "{about}");
                let fields = moodle::fields(question);
                let weights: u32 = fields.iter().map(|own| own.weight).sum();
                assert!(weights > 0 && weights.is_multiple_of(points_asked(item)), "{about}: {weights}");
                let (asked, chosen): (Vec<&Field>, Vec<&Field>) = fields.iter().partition(|own| !own.is_choice);
                let numbers = numbers(item);
                assert_eq!(asked.len(), numbers.len(), "{about}");
                for (field, (points, number)) in asked.into_iter().zip(&numbers) {
                    mistakes += mark_windows(field, number, *points, about);
                    if let [part] = &item.parts[..]
                        && !field.units.is_empty()
                    {
                        assert_eq!(field.mark(&part.printed).0, 1.0, "{about}: {}", part.printed);
                        typed += 1;
                    }
                }
                for field in chosen {
                    assert_eq!(field.answers.iter().filter(|own| own.fraction == 100.0).count(), 1, "{about}");
                    choices += 1;
                }
            }
        }
    }
    assert!(mistakes > 1000 && typed > 50 && choices > 20, "{mistakes} {typed} {choices}");
}

#[test]
fn a_unit_that_is_missing_costs_its_penalty_and_another_spelling_nothing() {
    let item = carts(0);
    let number = numbers(&item)[0].1.clone();
    let item = Item { parts: item.parts[..1].to_vec(), ..item };
    let root = moodle::read(&exported(&[item]));
    let field = &moodle::fields(questions(&root)[0])[0];
    let [metres, kilometres] = [number.right, number.right * 3.6];
    assert_eq!(field.mark(&format!("{metres} m/s")).0, 1.0);
    assert_eq!(field.mark(&format!("{kilometres} km/h")).0, 1.0);
    assert_eq!(field.mark(&metres.to_string()).0, 0.5);
}

/// An item of two carts.
fn carts(form: usize) -> Item {
    let source = Bank::built_in().find("impact/two-carts").unwrap().clone();
    let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
    Exercise::draw(&problem, form, 7).unwrap().item()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn hostile_text_arrives_as_text(
        title in hostile(),
        options in proptest::collection::vec(hostile(), 2..5),
        because in hostile(),
        several in any::<bool>(),
    ) {
        let mut item = carts(0);
        item.sheet.title.clone_from(&title);
        item.parts.truncate(1);
        let mut choice = item.parts[0].clone();
        choice.field.question = vec![momentous::explain::Inline::Text(title.clone())];
        choice.answers = ItemAnswers::Choice { options: options.clone(), right: 1, because: because.clone(), wrong: vec![title.clone()] };
        if several {
            item.parts.push(choice);
        } else {
            item.parts = vec![choice];
        }
        let root = moodle::read(&exported(&[item]));
        let question = questions(&root)[0];
        prop_assert!(question.text_at(&["name", "text"]).starts_with(title.as_str()));
        prop_assert!(moodle::decoded(question.text_at(&["questiontext", "text"])).contains(title.as_str()));
        let fields = moodle::fields(question);
        let answers = &fields.last().unwrap().answers;
        prop_assert_eq!(answers.iter().map(|own| own.text.clone()).collect::<Vec<_>>(), options);
        prop_assert_eq!(&answers[1].feedback, &because);
        prop_assert_eq!(&answers[0].feedback, &title);
        prop_assert_eq!(answers.iter().map(|own| own.fraction).position(|own| own == 100.0), Some(1));
    }
}

/// Text of signs that some format reads.
fn hostile() -> impl Strategy<Value = String> {
    "([<&>{}~#$=%\\\\\"':;a1]|\\]\\]>|&amp;|\\\\\\)){1,12}"
}

#[test]
fn the_command_writes_the_same_bytes_twice_and_says_what_did_not_go_along() {
    let folder = tempfile::tempdir().unwrap();
    let written = ["a.xml", "b.xml"].map(|name| {
        let path = folder.path().join(name);
        let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
        command.args(["export", "moodle", "impact/two-carts", "--count", "3", "-o"]).arg(&path);
        let output = command.assert().success().get_output().clone();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains("units in a question of several fields (3): printed behind each field"), "{said}");
        fs::read_to_string(path).unwrap()
    });
    assert_eq!(written[0], written[1]);
    let root = moodle::read(&written[0]);
    assert_eq!(questions(&root).len(), 3);
    let path = root.all("question").next().unwrap().text_at(&["category", "text"]);
    assert!(path.starts_with("top/momentous/impact//two-carts/"), "{path}");
}

#[test]
fn the_table_of_targets_names_every_feature() {
    let output = Command::new(env!("CARGO_BIN_EXE_momentous")).args(["export", "--targets"]).assert().success();
    let text = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    assert!(text.starts_with("moodle\n") && text.lines().count() == momentous::export::FEATURES.len() + 1, "{text}");
}
