//! The figures of every problem in the bank, over many seeds: nothing overlaps, nothing is infinite, and the sheet's figure
//! tells nothing that is not given.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::sync::LazyLock;

use momentous::explain;
use momentous::explain::Audience;
use momentous::explain::Block;
use momentous::expr::Math;
use momentous::expr::name_math;
use momentous::fault::Source;
use momentous::figure::Drawing;
use momentous::figure::Point;
use momentous::figure::Role;
use momentous::figure::Shape;
use momentous::figure::overlaps;
use momentous::figure::svg;
use momentous::problem;
use momentous::problem::Ask;
use momentous::problem::PartKind;
use momentous::problem::Problem;
use momentous::problem::Sampler;
use momentous::problem::Worked;
use momentous::render::Fragment;
use momentous::scene::Stage;
use rayon::prelude::*;

mod drawn;

use crate::problems;

const SEEDS: u64 = 200;

/// The problems of the bank, and scenes that are not in it; read once for all tests.
fn bank() -> &'static [Problem] {
    static BANK: LazyLock<Vec<Problem>> = LazyLock::new(read_bank);
    &BANK
}

fn read_bank() -> Vec<Problem> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let topics =
        fs::read_dir(root.join("problem_bank")).expect("the bank").map(|entry| entry.expect("a folder").path());
    let folders = topics.chain([root.join("tests/fixtures/pictures")]);
    let mut files: Vec<PathBuf> = folders
        .flat_map(|folder| fs::read_dir(folder).expect("a topic").map(|entry| entry.expect("a file").path()))
        .collect();
    files.sort();
    assert!(files.len() >= 14, "the bank is nearly empty");
    let read = |file: &PathBuf| {
        let text = fs::read_to_string(file).expect("a problem");
        let name = file.display().to_string();
        let loaded = problem::load(Source::new(&name, &text)).unwrap_or_else(|faults| panic!("{name}: {faults}"));
        problem::compile(loaded, None).unwrap_or_else(|faults| panic!("{name}: {faults}"))
    };
    files.par_iter().map(read).collect()
}

/// Shows every variant of every form to `look`.
fn each_variant(seeds: u64, look: impl Fn(&str, Worked<'_>) + Sync) {
    bank().par_iter().for_each(|problem| each_variant_of(problem, seeds, &look));
}

fn each_variant_of(problem: &Problem, seeds: u64, look: &impl Fn(&str, Worked<'_>)) {
    for form in 0..problem.forms().len() {
        let mut sampler = Sampler::new(problem, form).expect("a form");
        for seed in 1..=seeds {
            let variant = sampler.variant(seed).expect("a variant");
            let at = format!("{}, form {form}, seed {seed}", problem.id());
            look(&at, Worked::new(problem, &variant).expect("its own problem"));
        }
    }
}

/// Whether something is asked that the sheet does not tell enough to find: it cannot be drawn either.
fn is_open(worked: Worked<'_>) -> bool {
    let mut parts = worked.form.parts.iter().zip(&worked.form.question.ask);
    parts.any(|(part, ask)| match (&part.kind, ask) {
        (PartKind::Choice(choice), Ask::Enough(_)) => choice.decided(&worked).right == 1,
        _ => false,
    })
}

fn drawings_of_solution(worked: Worked<'_>) -> Vec<Drawing> {
    let blocks = explain::solution(worked, Audience::Everyone, explain::Detail::Full)
        .sections
        .into_iter()
        .flat_map(|section| section.blocks);
    let figure = |block| match block {
        Block::Figure(drawing) => Some(*drawing),
        _ => None,
    };
    blocks.filter_map(figure).collect()
}

fn points(shape: &Shape) -> Vec<Point> {
    match shape {
        Shape::Line { points, .. } | Shape::Area { points, .. } => points.clone(),
        Shape::Arrow { from, to, .. } => vec![*from, *to],
        Shape::Circle { centre, radius, .. } => vec![*centre, Point::new(*radius, 0.0)],
        Shape::Rectangle { centre, size, angle, .. } => vec![*centre, *size, Point::new(*angle, 0.0)],
        Shape::Arc { centre, radius, from, to, .. } => vec![*centre, Point::new(*radius, 0.0), Point::new(*from, *to)],
        Shape::Label { at, .. } => vec![*at],
    }
}

fn labels(drawing: &Drawing) -> Vec<&Math> {
    let label =
        drawing.shapes.iter().map(|shape| if let Shape::Label { text, .. } = shape { Some(text) } else { None });
    label.flatten().collect()
}

#[test]
fn no_label_touches_anything_and_every_coordinate_is_finite() {
    each_variant(SEEDS, |at, worked| {
        let sheet = explain::situation(worked);
        for drawing in sheet.iter().chain(&drawings_of_solution(worked)) {
            let found = overlaps(drawing);
            assert!(found.is_empty(), "{at}, {}: {found:?}", drawing.title);
            let corners = [drawing.low, drawing.high];
            let finite =
                drawing.shapes.iter().flat_map(points).chain(corners).all(|p| p.x.is_finite() && p.y.is_finite());
            assert!(finite, "{at}, {}: a coordinate is not finite", drawing.title);
        }
    });
}

#[test]
fn every_figure_says_what_it_is() {
    each_variant(2, |at, worked| {
        let sheet = explain::situation(worked);
        let solution = drawings_of_solution(worked);
        assert!(sheet.as_ref().is_none_or(|sheet| !sheet.is_bare()), "{at}: the sheet's figure shows bare outlines");
        assert!(is_open(worked) || !solution.is_empty(), "{at}: no figure in the solution");
        for drawing in sheet.iter().chain(&solution) {
            for words in [&drawing.title, &drawing.description, &drawing.caption] {
                assert!(words.starts_with(char::is_uppercase), "{at}: {words:?}");
                assert!(!words.contains("NaN") && !words.contains("  "), "{at}: {words:?}");
            }
        }
    });
}

#[test]
fn every_stage_has_its_diagram() {
    each_variant(3, |at, worked| {
        if is_open(worked) {
            return;
        }
        let all = &worked.problem.loaded().draft.scene.stages;
        let Some(stages) = all.get(..explain::last_instant(worked) - 1) else { return };
        // Where nothing acts nothing is drawn; a swing, a ramp and a walk have figures of their own.
        let momentum = |stage: &&Stage| match stage {
            Stage::Slide(slide) => !slide.is_ramp(),
            // Of bodies that were at rest, the displacements are drawn.
            Stage::Interact(interact) => !interact.at_rest,
            // What leaks out carries momentum away, which the diagram of one body would not balance.
            Stage::Push(push) => push.loses.is_none(),
            Stage::Impact(_)
            | Stage::Blow(_)
            | Stage::Separate(_)
            | Stage::SlideOff(_)
            | Stage::Spring(_)
            | Stage::Taut(_)
            | Stage::Connected(_)
            | Stage::Stream(_)
            | Stage::Thrust(_) => true,
            _ => false,
        };
        let swing = |stage: &&Stage| matches!(stage, Stage::Swing(_));
        let angular = |stage: &&Stage| {
            matches!(
                stage,
                Stage::Rotate(_)
                    | Stage::Central(_)
                    | Stage::Moment(_)
                    | Stage::Strike(_)
                    | Stage::Conical(_)
                    | Stage::Bowl(_)
            )
        };
        let drawings = drawings_of_solution(worked);
        let titled = |start: &str| drawings.iter().filter(|drawing| drawing.title.starts_with(start)).count();
        // What work or the balance of forces solves has its forces, and what the energy of a spring solves the velocities beside it.
        let balanced = titled("Impulse-momentum") + titled("Free-body diagram") + titled("Velocities of");
        assert!(balanced >= stages.iter().filter(momentum).count(), "{at}");
        let on_circle = |title: &str| title.ends_with("on the cord") || title.ends_with("on the circular track");
        let swings = drawings.iter().filter(|drawing| on_circle(&drawing.title)).count();
        assert_eq!(swings, stages.iter().filter(swing).count(), "{at}");
        assert_eq!(titled("Angular impulse-momentum"), stages.iter().filter(angular).count(), "{at}");
        let unknown = drawings.iter().flat_map(labels).any(|label| label.plain().ends_with("= ?"));
        assert!(!unknown, "{at}: a momentum or an impulse is not known");
    });
}

/// The names that a label may stand for: a quantity, and its vector where it is a component or a speed.
fn spellings(name: &str) -> BTreeSet<String> {
    // A figure shows one stage, so that its names need none.
    let of_any_stage = match (name.find('['), name.rfind(']')) {
        (Some(open), Some(close)) => format!("{}{}", &name[..open], &name[close + 1..]),
        _ => name.to_owned(),
    };
    let vector = of_any_stage.split('.').next().unwrap_or(name);
    [name, vector].iter().map(|name| name_math(name).plain()).collect()
}

#[test]
fn the_sheet_names_nothing_that_is_not_given() {
    each_variant(20, |at, worked| {
        let Some(drawing) = explain::situation(worked) else { return };
        let symbols = &worked.problem.model().symbols;
        let told: BTreeSet<_> = worked.form.told.union(&worked.form.printed).copied().collect();
        let given: BTreeSet<String> = told.iter().flat_map(|symbol| spellings(&symbols.entry(*symbol).name)).collect();
        let hidden: BTreeSet<String> = symbols
            .iter()
            .filter(|(symbol, _)| !told.contains(symbol))
            .map(|(_, entry)| name_math(&entry.name).plain())
            // Variables of functions are no secrets, and an axis has the name of the place along it.
            .filter(|name| !given.contains(name) && !["t", "x", "y", "z"].contains(&name.as_str()))
            .collect();
        let asked: BTreeSet<String> =
            worked.form.wanted().map(|symbol| name_math(&symbols.entry(symbol).name).plain()).collect();
        for label in labels(&drawing) {
            let label = label.plain();
            let (name, value) = label.split_once(" = ").unwrap_or((&label, ""));
            let is_question = value == "?" && asked.contains(name);
            assert!(is_question || !hidden.contains(name), "{at}: the sheet's figure names {name}");
        }
    });
}

/// The figure of a sheet as it is printed.
fn figure(worked: Worked<'_>) -> Option<String> {
    explain::situation(worked).map(|drawing| svg(&drawing))
}

/// The figure of a sheet with other answers than its own: no arrow, no angle and no length gives one away.
#[test]
fn the_sheet_is_drawn_alike_whatever_the_answers_are() {
    each_variant(20, |at, worked| {
        let told: BTreeSet<_> = worked.form.told.union(&worked.form.printed).copied().collect();
        let expected = figure(worked);
        for change in [|value: f64| -value, |value| 3.0 * value + 0.7, |_| 0.0] {
            let other = worked.variant.with_others_than(&told, change);
            let other = figure(Worked::new(worked.problem, &other).expect("its own problem"));
            assert_eq!(other, expected, "{at}: the sheet's figure depends on an answer");
        }
    });
}

/// What is asked of what the figure shows has its question mark.
#[test]
fn the_sheet_shows_what_is_asked_of_its_instant() {
    let asked = [
        ("conservation/coupling-wagons", 1, "v_A1"),
        ("chains/locked-bumpers", 1, "v_A1"),
        ("impact/racket-meets-ball", 1, "u"),
        ("angular-momentum/telescope-in-orbit", 1, "M_x"),
        ("vectors/two-tugs", 1, "F_2"),
        ("impulse/capsule-braking", 1, "F"),
        ("streams/grain-belt", 1, "u"),
    ];
    for (id, form, name) in asked {
        let problem = bank().iter().find(|problem| problem.id() == id).expect("a problem");
        let variant = Sampler::new(problem, form).expect("a form").variant(1).expect("a variant");
        let drawing = explain::situation(Worked::new(problem, &variant).expect("its own problem")).expect("a figure");
        let expected = format!("{} = ?", name_math(name).plain());
        let labels: Vec<String> = labels(&drawing).into_iter().map(Math::plain).collect();
        assert!(labels.contains(&expected), "{id}: {expected} is not among {labels:?}");
    }
}

/// A moment acts for a time that the solution names after its stage; the diagram has that name.
#[test]
fn a_diagram_names_a_duration_as_the_solution_does() {
    let text = "
id: x/second
title: A second moment
level: core
scene:
  axes: { x: [counter-clockwise, clockwise] }
  bodies: { A: { name: the ball, mass: m } }
  points: { O: { name: the pivot } }
  stages:
    - rotate: { name: first, body: A, about: O, arm: L, moment: M_0, during: T }
    - rotate: { name: second, body: A, about: O, arm: L, moment: K }
given: { m: 2 kg, L: 0.5 m, M_0: 3 N m, T: 2 s, v_A1: 0 m/s, K: 1 N m, v_A3: 20 m/s }
text: A ball ({{ m }}, {{ L }}, {{ M_0 }}, {{ T }}, {{ v_A1 }}), then {{ K }} and {{ v_A3 }}.
ask: [ { find: \"dt[second]\", unit: s } ]
";
    let problem = problem::load(Source::new("second.yaml", text)).and_then(|loaded| problem::compile(loaded, None));
    let problem = problem.unwrap_or_else(|faults| panic!("{faults}"));
    let variant = Sampler::new(&problem, 0).expect("a form").variant(1).expect("a variant");
    let drawings = drawings_of_solution(Worked::new(&problem, &variant).expect("its own problem"));
    let written: Vec<String> = drawings.iter().flat_map(labels).map(Math::plain).collect();
    let expected = format!("K {}", name_math("dt[second]").plain());
    assert!(written.contains(&expected), "{expected}: {written:?}");
}

/// A body that falls until a string is taut falls on nothing, before it is solved and after.
#[test]
fn a_fall_that_a_string_ends_has_no_floor() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/found/falls_on_a_string.yaml");
    let text = fs::read_to_string(path).expect("a problem");
    let problem = problem::load(Source::new("falls.yaml", &text)).and_then(|loaded| problem::compile(loaded, None));
    let problem = problem.unwrap_or_else(|faults| panic!("{faults}"));
    let variant = Sampler::new(&problem, 0).expect("a form").variant(1).expect("a variant");
    let worked = Worked::new(&problem, &variant).expect("its own problem");
    let sheet = explain::situation(worked).expect("a figure");
    let solution = drawings_of_solution(worked);
    let falls = solution.iter().filter(|drawing| drawing.title.starts_with("The fall of"));
    let falls: Vec<&Drawing> = falls.chain([&sheet]).collect();
    assert_eq!(falls.len(), 2, "{solution:?}");
    for fall in falls {
        let is_floor = |shape: &Shape| matches!(shape, Shape::Line { role: Role::Surface, .. });
        assert!(!fall.shapes.iter().any(is_floor), "{fall:?}");
    }
}

/// Which picture is right is not known by the length of its text.
#[test]
fn pictures_to_choose_from_have_one_length() {
    let mut choices = 0;
    for exercise in problems::exercises(1) {
        for part in exercise.sheet().parts.iter().filter(|part| !part.pictures.is_empty()) {
            choices += 1;
            let figures = Fragment::figures(&part.pictures);
            let texts: BTreeSet<&str> = figures.iter().map(Fragment::as_str).collect();
            let lengths: BTreeSet<usize> = texts.iter().map(|text| text.len()).collect();
            assert_eq!((texts.len(), lengths.len()), (figures.len(), 1), "{}", exercise.problem().id());
        }
    }
    assert!(choices > 0);
}
