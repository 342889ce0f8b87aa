//! What a reader sees of the bank: the sheet, the worked solution and the record of every form at one seed, as a whole.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use momentous::exercise::Exercise;
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::render::Figures;
use momentous::render::Format;
use momentous::render::Key;
use momentous::render::Page;
use momentous::render::Renderer;
use momentous::render::Solution;

use crate::problems;

/// Every form of the bank at the seed of all snapshots.
static EXERCISES: LazyLock<Vec<Exercise>> = LazyLock::new(|| problems::exercises(1));

/// Pages as Markdown; figures lie beside it, so that the text stays readable.
fn markdown(pages: &[Page]) -> String {
    let renderer = Renderer::new(None).unwrap().figures(Figures::Beside("figure".into()));
    renderer.render(pages, Format::Markdown).unwrap().text
}

fn solution(exercise: &Exercise, faded: Option<usize>) -> Page {
    detailed_or_short(exercise, Detail::Short, faded)
}

fn detailed_or_short(exercise: &Exercise, detail: Detail, faded: Option<usize>) -> Page {
    let (outline, identity) = (exercise.outline(Audience::Instructor, detail), exercise.identity());
    Page::Solution(Solution { outline, identity, audience: Audience::Everyone, faded })
}

/// What a page says without its footer, which is tested elsewhere: a digest in every snapshot would hide what has changed.
fn check(name: &str, text: &str) {
    let is_digest = |line: &&str| line.contains(" · digest ") || line.trim_start().starts_with("\"digest\": ");
    let text: Vec<&str> = text.lines().filter(|line| !is_digest(line)).collect();
    let text = text.join("\n");
    insta::with_settings!({ snapshot_path => "snapshots/bank", prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!(name, text);
    });
}

#[test]
fn every_form_reads_well() {
    for exercise in EXERCISES.iter() {
        let pages = [Page::Sheet(exercise.sheet()), solution(exercise, None)];
        check(&problems::name(exercise), &markdown(&pages));
    }
}

/// One form of each topic, since every step in full is long.
#[test]
fn one_form_of_each_topic_reads_well_in_full() {
    let mut topics = BTreeSet::new();
    for exercise in EXERCISES.iter() {
        let name = problems::name(exercise);
        if topics.insert(exercise.problem().id().split('/').next().map(str::to_owned)) {
            check(&format!("{name}-detailed"), &markdown(&[detailed_or_short(exercise, Detail::Full, None)]));
        }
    }
}

#[test]
fn every_form_has_its_record() {
    for exercise in EXERCISES.iter() {
        let record = serde_json::to_string_pretty(&exercise.record(None)).unwrap();
        // How tight a bound is depends on the way in which it was found; `tests/solver/certificates.rs` judges bounds.
        let lines: Vec<&str> = record.lines().filter(|line| !line.contains("\"error_bound\": ")).collect();
        check(&format!("{}.json", problems::name(exercise)), &lines.join("\n"));
    }
}

#[test]
fn a_faded_solution_leaves_the_last_steps_to_the_student() {
    for exercise in EXERCISES.iter() {
        let name = problems::name(exercise);
        if ["impact-curling-stones-forward", "conservation-coupling-wagons-forward"].contains(&name.as_str()) {
            check(&format!("{name}-faded"), &markdown(&[solution(exercise, Some(2))]));
        }
    }
}

#[test]
fn the_key_has_every_answer() {
    let rows = EXERCISES.iter().flat_map(Exercise::key).collect();
    check("key", &markdown(&[Page::Key(Key { title: "Answers".into(), rows })]));
}
