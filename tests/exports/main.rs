//! What is exported is read back and marked as its target does: right answers, windows, mistakes, and hostile text.

#![allow(clippy::float_cmp, reason = "fractions are written as they are meant")]
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test says bluntly what it expects")]

use std::fs;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use assert_cmd::Command;
use momentous::exercise::Item;
use momentous::export::{TARGETS, Target};

use bank::{all_forms, carts, exported, forms, numbers, text, variants};
use marked::{Met, marked_as_here};
use xml::Node;

mod bank;
mod cases;
mod fields;
mod marked;
mod moodle;
mod moodle_cases;
mod practice_page;
mod python;
mod qti;
mod qti_cases;
mod responses;
mod texts;
mod xml;

fn questions(root: &Node) -> Vec<&Node> {
    root.all("question").filter(|question| question.attribute("type") != "category").collect()
}

/// Marks every form of the bank in a target.
fn whole_bank(target: &str) -> Met {
    let mut met = Met::default();
    for items in forms() {
        met += marked_as_here(target, items);
    }
    met
}

#[test]
fn every_form_of_the_bank_is_marked_in_moodle_as_here() {
    let met = whole_bank("moodle");
    assert!(met.mistakes > 1000 && met.typed > 50 && met.choices > 20, "{met:?}");
}

#[test]
fn every_form_of_the_bank_is_marked_in_qti_as_here() {
    for target in ["qti3", "qti21"] {
        let met = whole_bank(target);
        assert!(met.mistakes > 1000 && met.choices > 20, "{met:?}");
    }
}

#[test]
fn every_form_of_the_bank_is_marked_in_canvas_as_here() {
    let met = whole_bank("canvas");
    assert!(met.numbers > 300 && met.choices > 20, "{met:?}");
}

#[test]
fn every_form_of_the_bank_is_marked_in_numbas_as_here() {
    let met = whole_bank("numbas");
    assert!(met.mistakes > 1000, "{met:?}");
}

#[test]
fn every_form_of_the_bank_is_marked_in_prairielearn_as_here() {
    let met = whole_bank("prairielearn");
    assert!(python::found().is_none() || met.mistakes > 1000, "{met:?}");
}

#[test]
fn every_form_of_the_bank_is_marked_in_rexams_as_here() {
    let met = whole_bank("rexams");
    assert!(met.numbers > 300 && met.choices > 20, "{met:?}");
}

/// The seeds of variants other than those above.
const FIVE: Range<u64> = 101..106;
const TWENTY: Range<u64> = 101..121;

/// Marks variants of every form in the targets of the form, which is known by its place.
fn sweep(seeds: &Range<u64>, targets: impl Fn(usize) -> &'static [Target] + Sync) -> Met {
    let forms = all_forms();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut met = Met::default();
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some((problem, form)) = forms.get(place) else { return met };
            let items = variants(problem, *form, seeds.clone());
            for target in targets(place) {
                met += marked_as_here(target.name, &items);
            }
        }
    };
    let mut met = Met::default();
    thread::scope(|scope| {
        let workers: Vec<_> =
            (0..thread::available_parallelism().map_or(1, usize::from)).map(|_| scope.spawn(work)).collect();
        for worker in workers {
            met += worker.join().unwrap();
        }
    });
    met
}

/// The targets take turns.
#[test]
fn five_variants_of_every_form_are_marked_in_one_target_as_here() {
    let met = sweep(&FIVE, |place| TARGETS.iter().cycle().nth(place).map_or(&[], std::slice::from_ref));
    assert!(met.numbers > 1000 && met.choices > 100, "{met:?}");
}

#[test]
#[ignore = "takes long; `.ci/soak exports` runs it"]
fn twenty_variants_of_every_form_are_marked_in_every_target_as_here() {
    let met = sweep(&TWENTY, |_| &TARGETS);
    assert!(met.numbers > 30_000 && met.choices > 3000, "{met:?}");
}

#[test]
fn a_unit_that_is_missing_costs_its_penalty_and_another_spelling_nothing() {
    let item = carts();
    let number = numbers(&item)[0].1.clone();
    let item = Item { parts: item.parts[..1].to_vec(), ..item };
    let root = xml::read(&text(exported("moodle", [&item])));
    let field = &moodle::fields(questions(&root)[0])[0];
    let [metres, kilometres] = [number.right, number.right * 3.6];
    assert_eq!(field.mark(&format!("{metres} m/s")).0, 1.0);
    assert_eq!(field.mark(&format!("{kilometres} km/h")).0, 1.0);
    assert_eq!(field.mark(&metres.to_string()).0, 0.5);
}

#[test]
#[ignore = "writes cases for other programs"]
fn cases_are_written() {
    let folder = std::env::var_os("EXPORT_CASES").expect("EXPORT_CASES names a folder");
    let target = std::env::var("EXPORT_TARGET").unwrap_or_else(|_| "qti3".to_owned());
    cases::write(&target, folder.as_ref());
}

#[test]
fn the_command_writes_the_same_bytes_twice_and_says_what_did_not_go_along() {
    let folder = tempfile::tempdir().unwrap();
    for target in TARGETS {
        let written = ["a", "b"].map(|name| {
            let path = folder.path().join(name);
            let mut command = Command::new(env!("CARGO_BIN_EXE_momentous"));
            command.args(["export", target.name, "impact/two-carts", "--count", "3", "-o"]).arg(&path);
            let output = command.assert().success().get_output().clone();
            let said = String::from_utf8(output.stderr).unwrap();
            assert!(said.contains("units in a question of several fields (3): printed behind the field"), "{said}");
            // Two carts has three fields, each with slips of the power of ten.
            let is_silent = ["moodle", "canvas", "rexams"].contains(&target.name);
            assert_eq!(said.contains("only the power of ten is wrong"), is_silent, "{said}");
            fs::read(path).unwrap()
        });
        assert!(!written[0].is_empty() && written[0] == written[1], "{}", target.name);
        if target.name == "moodle" {
            let root = xml::read(&text(written[0].clone()));
            assert_eq!(questions(&root).len(), 3);
            let path = root.all("question").next().unwrap().text_at(&["category", "text"]);
            assert!(path.starts_with("top/momentous/impact//two-carts/"), "{path}");
        }
    }
}

#[test]
fn the_table_of_targets_names_every_feature() {
    let output = Command::new(env!("CARGO_BIN_EXE_momentous")).args(["export", "--targets"]).assert().success();
    let text = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    let lines = (momentous::export::FEATURES.len() + 1) * TARGETS.len();
    assert!(text.starts_with("moodle: ") && text.lines().count() == lines, "{text}");
}
