//! What is exported is read back and marked as its target does: right answers, windows, mistakes, and hostile text.

#![allow(clippy::float_cmp, reason = "fractions are written as they are meant")]
#![allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]

use std::fs;

use assert_cmd::Command;
use momentous::exercise::{Item, ItemAnswers};
use momentous::export::{Question, TARGETS};

use bank::{Faith, WHOLE, carts, check, choices, exported, file, forms, numbers, text, unpacked};
use moodle::Field;
use xml::{Node, decoded};

#[path = "exports/bank.rs"]
mod bank;
#[path = "exports/cases.rs"]
mod cases;
#[path = "exports/hostile.rs"]
mod hostile;
#[path = "exports/moodle.rs"]
mod moodle;
#[path = "exports/moodle_cases.rs"]
mod moodle_cases;
#[path = "exports/python.rs"]
mod python;
#[path = "exports/qti.rs"]
mod qti;
#[path = "exports/qti_cases.rs"]
mod qti_cases;
#[path = "exports/xml.rs"]
mod xml;

/// The letters that an idnumber may have.
const LONGEST_ID: usize = 100;

fn questions(root: &Node) -> Vec<&Node> {
    root.all("question").filter(|own| own.attribute("type") != "category").collect()
}

/// The points of the parts that go along.
fn points_asked(item: &Item) -> u32 {
    let is_left_out = |own: &ItemAnswers| matches!(own, ItemAnswers::Formula { mistaken } if mistaken.is_empty());
    item.parts.iter().filter(|part| !is_left_out(&part.answers)).map(|part| part.field.points).sum()
}

#[test]
fn every_form_of_the_bank_is_marked_in_moodle_as_here() {
    let (mut mistakes, mut typed, mut chosen) = (0, 0, 0);
    for items in forms() {
        let root = xml::read(&text(exported("moodle", items)));
        let questions = questions(&root);
        assert_eq!(questions.len(), items.len());
        for (item, question) in items.iter().zip(questions) {
            let about = question.text_at(&["idnumber"]);
            assert!(!about.is_empty() && about.chars().count() <= LONGEST_ID, "{about}");
            assert_eq!(question.at(&["questiontext", "file"]).is_some(), item.sheet.figure.is_some(), "{about}");
            assert_eq!(question.all("hint").count(), item.sheet.hints.len(), "{about}");
            let solution = question.text_at(&["generalfeedback", "text"]);
            let shown = question.at(&["generalfeedback"]).unwrap().all("file").count();
            assert_eq!(solution.matches("@@PLUGINFILE@@").count(), shown, "{about}");
            let solution = decoded(solution);
            assert!(item.solution.sections.iter().all(|own| solution.contains(&own.heading)), "{about}");
            assert!(decoded(question.text_at(&["questiontext", "text"])).contains(&item.code), "{about}");
            let fields = moodle::fields(question);
            let weights: u32 = fields.iter().map(|own| own.weight).sum();
            assert!(weights > 0 && weights.is_multiple_of(points_asked(item)), "{about}: {weights}");
            let (asked, choosing): (Vec<&Field>, Vec<&Field>) = fields.iter().partition(|own| !own.is_choice);
            let numbers = numbers(item);
            assert_eq!(asked.len(), numbers.len(), "{about}");
            let coarse = question.attribute("type") != "cloze";
            for (field, (points, number)) in asked.into_iter().zip(&numbers) {
                let mark = |value: f64| {
                    let (share, said) = field.mark_number(value);
                    (share, said.to_owned())
                };
                mistakes += check(number, *points, Faith { credit: 0.05, coarse, ..WHOLE }, about, mark);
                if let [part] = &item.parts[..]
                    && !field.units.is_empty()
                {
                    assert_eq!(field.mark(&part.printed).0, 1.0, "{about}: {}", part.printed);
                    typed += 1;
                }
            }
            for field in choosing {
                assert_eq!(field.answers.iter().filter(|own| own.fraction == 100.0).count(), 1, "{about}");
                chosen += 1;
            }
        }
    }
    assert!(mistakes > 1000 && typed > 50 && chosen > 20, "{mistakes} {typed} {chosen}");
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
fn every_form_of_the_bank_is_marked_in_qti_as_here() {
    for target in ["qti3", "qti21"] {
        let (mut mistakes, mut chosen) = (0, 0);
        for items in forms() {
            let files = unpacked(exported(target, items));
            let test = xml::read(file(&files, "test.xml"));
            let section = test.all("qti-test-part").chain(test.all("testPart")).next().unwrap();
            assert_eq!(section.children.len(), usize::from(!items.is_empty()), "variants of a form are one section");
            for item in items {
                let written = qti::Item::read(file(&files, &format!("items/item-{}.xml", item.code)));
                let about = format!("{target} {} {}", item.identity.problem, written.identifier());
                mistakes += check_qti(item, &written, &about);
                chosen += choices(item).len();
                let solution = written.feedback("SOLUTION", "solution").unwrap();
                assert!(item.solution.sections.iter().all(|own| solution.contains(&own.heading)), "{about}");
            }
            let manifest = xml::read(file(&files, "imsmanifest.xml"));
            let mut listed = Vec::new();
            manifest.walk(&mut |node| listed.extend((node.name == "file").then(|| node.attribute("href").to_owned())));
            let mut names: Vec<String> = files.iter().map(|(name, _)| name.clone()).collect();
            names.retain(|name| name != "imsmanifest.xml");
            listed.sort_unstable();
            names.sort_unstable();
            assert_eq!(listed, names);
        }
        assert!(mistakes > 1000 && chosen > 20, "{mistakes} {chosen}");
    }
}

#[test]
#[ignore = "writes cases for other programs"]
fn cases_are_written() {
    let folder = std::env::var_os("EXPORT_CASES").expect("EXPORT_CASES names a folder");
    let target = std::env::var("EXPORT_TARGET").unwrap_or_else(|_| "qti3".to_owned());
    cases::write(&target, folder.as_ref());
}

/// Marks every field of an item by itself; gives how many mistakes were met.
fn check_qti(item: &Item, written: &qti::Item, about: &str) -> usize {
    let responses = written.responses();
    let all: Vec<(&str, &str)> = responses.iter().map(|(name, right)| (name.as_str(), right.as_str())).collect();
    let most = written.most();
    assert!((written.mark(&all).score - most).abs() < 1e-9, "{about}");
    assert_eq!(written.mark(&[]).score, 0.0, "{about}: empty");
    let (choosing, asked): (Vec<&(String, String)>, Vec<_>) =
        responses.iter().partition(|(name, _)| !written.choices(name).is_empty());
    let numbers = numbers(item);
    assert_eq!(asked.len(), numbers.len(), "{about}");
    let mut mistakes = 0;
    for ((name, right), (points, number)) in asked.into_iter().zip(numbers) {
        let full = written.mark(&[(name, right)]).score;
        let told = name.replace("RESPONSE", "FEEDBACK");
        mistakes += check(number, points, WHOLE, about, |value| {
            let marked = written.mark(&[(name, &value.to_string())]);
            let said = marked.outcomes.get(&told).map(|own| written.feedback(&told, own).unwrap());
            (marked.score / full, said.unwrap_or_default())
        });
    }
    for ((name, right), (options, place)) in choosing.into_iter().zip(choices(item)) {
        let found = written.choices(name);
        assert_eq!(found.iter().map(|(_, text)| text.clone()).collect::<Vec<_>>(), options, "{about}");
        assert_eq!(found[place].0, *right, "{about}");
        for (own, _) in &found {
            assert_eq!(written.mark(&[(name, own)]).score > 0.0, own == right, "{about}");
        }
    }
    mistakes
}

#[test]
fn every_form_of_the_bank_is_marked_in_canvas_as_here() {
    let (mut asked, mut chosen) = (0, 0);
    for items in forms().iter().filter(|items| !items.is_empty()) {
        let files = unpacked(exported("canvas", items));
        let quiz = format!("quiz-{}", items[0].code);
        let root = xml::read(file(&files, &format!("{quiz}/{quiz}.xml")));
        let groups: Vec<&Node> = root.at(&["assessment", "section"]).unwrap().all("section").collect();
        assert!(groups.iter().all(|own| own.all("item").count() <= items.len()));
        for item in items {
            let own: Vec<&Node> = groups
                .iter()
                .flat_map(|group| group.all("item"))
                .filter(|own| own.attribute("ident").starts_with(&item.code))
                .collect();
            let (numerical, choosing): (Vec<&Node>, Vec<&Node>) =
                own.into_iter().partition(|own| own.at(&["presentation", "response_str"]).is_some());
            let numbers = numbers(item);
            assert_eq!(numerical.len(), numbers.len());
            for (written, (points, number)) in numerical.into_iter().zip(numbers) {
                let mark = |value: f64| (if canvas_takes(written, value) { 1.0 } else { 0.0 }, String::new());
                let mut full = number.clone();
                // Canvas knows no credit: what earns less than everything earns nothing.
                full.windows.retain(|own| own.points.0 == momentous::quantity::Rational::from(points));
                check(&full, points, Faith { feedback: false, ..WHOLE }, &item.code, mark);
                asked += 1;
            }
            for (written, (options, _)) in choosing.into_iter().zip(choices(item)) {
                let labels = written.at(&["presentation", "response_lid", "render_choice"]).unwrap();
                let texts = labels.all("response_label").map(|own| decoded(own.text_at(&["material", "mattext"])));
                assert_eq!(texts.collect::<Vec<_>>(), options);
                chosen += 1;
            }
        }
    }
    assert!(asked > 300 && chosen > 20, "{asked} {chosen}");
}

fn canvas_takes(item: &Node, value: f64) -> bool {
    let end = |within: &Node, name| within.text_at(&[name]).parse::<f64>().ok();
    item.at(&["resprocessing"]).unwrap().all("respcondition").any(|own| {
        let within = own.at(&["conditionvar"]).unwrap();
        let ends = end(within, "vargte").zip(end(within, "varlte"));
        ends.is_some_and(|(low, high)| (low..=high).contains(&value))
    })
}

#[test]
fn every_form_of_the_bank_is_marked_in_numbas_as_here() {
    let mut mistakes = 0;
    for items in forms().iter().filter(|items| !items.is_empty()) {
        let exam = numbas(items);
        let group = &exam["question_groups"][0];
        assert_eq!(group["pickQuestions"], 1);
        let questions = group["questions"].as_array().unwrap();
        assert_eq!(questions.len(), items.len());
        for (item, question) in items.iter().zip(questions) {
            let parts = question["parts"].as_array().unwrap();
            let entries = parts.iter().filter(|own| own["type"] == "numberentry");
            let numbers = numbers(item);
            assert_eq!(entries.clone().count(), numbers.len());
            for (part, (points, number)) in entries.zip(numbers) {
                let read = part["notationStyles"].as_array().unwrap();
                assert!(read.contains(&"scientific".into()), "Numbas reads 1.5e3 only in this notation");
                mistakes += check(number, points, WHOLE, &item.code, |value| numbas_mark(part, value));
            }
        }
    }
    assert!(mistakes > 1000, "{mistakes}");
}

/// An exam as Numbas reads it.
fn numbas<'i>(items: impl IntoIterator<Item = &'i Item>) -> serde_json::Value {
    let exam = text(exported("numbas", items));
    let (first, rest) = exam.split_once('\n').unwrap();
    assert!(first.starts_with("// Numbas version:"));
    serde_json::from_str(rest).unwrap()
}

/// The first interval that holds the number counts, that of the part itself first.
fn numbas_mark(part: &serde_json::Value, value: f64) -> (f64, String) {
    let full = part["marks"].as_f64().unwrap();
    let end = |own: &serde_json::Value, name: &str| own[name].as_str().unwrap().parse::<f64>().unwrap();
    let all = std::iter::once(part).chain(part["alternatives"].as_array().unwrap());
    let mut fitting = all.filter(|own| (end(own, "minValue")..=end(own, "maxValue")).contains(&value));
    fitting.next().map_or((0.0, String::new()), |own| {
        let said = decoded(own["alternativeFeedbackMessage"].as_str().unwrap_or_default());
        (own["marks"].as_f64().unwrap() / full, said)
    })
}

#[test]
fn every_form_of_the_bank_is_marked_in_prairielearn_as_here() {
    let Some(python) = python::found() else { return };
    let mut asked = Vec::new();
    let folder = tempfile::tempdir().unwrap();
    let mut probes = Vec::new();
    for items in forms().iter().filter(|items| !items.is_empty()) {
        for (name, content) in unpacked(exported("prairielearn", items)) {
            if let Some(form) = name.strip_suffix("/server.py") {
                fs::write(folder.path().join(format!("{form}.py")), content).unwrap();
            }
        }
        for (place, item) in items.iter().enumerate() {
            let form = Question::new(item).name();
            for (field, (points, number)) in number_fields(item).into_iter().zip(numbers(item)) {
                for window in &number.windows {
                    let worth = window.points.0.to_f64().value() / f64::from(points);
                    let middle = window.low + (window.high - window.low) / 2.0;
                    probes.push(serde_json::json!([form, place, field, middle]));
                    asked.push((worth, window.feedback.clone(), format!("{} {field} {middle}", item.code)));
                }
            }
        }
    }
    let marked = python::run(&python, folder.path(), python::PLAY, &serde_json::json!(probes));
    let marked = marked.as_array().unwrap();
    assert_eq!(marked.len(), asked.len());
    for ((worth, feedback, about), found) in asked.iter().zip(marked) {
        assert!((found[0].as_f64().unwrap() - worth).abs() < 1e-9, "{about}: {found} {worth}");
        let said = decoded(found[1].as_str().unwrap());
        assert!(feedback.iter().all(|own| said.contains(own.as_str())), "{about}: {said} {feedback:?}");
    }
    assert!(asked.len() > 3000, "{}", asked.len());
}

/// The names of the fields for numbers: the label of the part, and a number where it has several.
fn number_fields(item: &Item) -> Vec<String> {
    let names = |part: &momentous::exercise::ItemPart| {
        let label = part.field.label.clone();
        match bank::numbers_of(&part.answers).len() {
            1 => vec![label],
            count => (1..=count).map(|place| format!("{label}{place}")).collect(),
        }
    };
    item.parts.iter().flat_map(names).collect()
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
