//! Variants of a form as a target marks them: what is right, near, mistaken or outside earns there what it earns here.

use std::fs;

use momentous::exercise::{Item, ItemAnswers, ItemPart, Window};
use momentous::export::Question;
use momentous::quantity::Rational;

use super::bank::{self, Faith, WHOLE, check, choices, exported, file, numbers, text, unpacked};
use super::moodle::{self, Field};
use super::xml::{self, Node, decoded};
use super::{python, qti, questions};

/// The letters that an idnumber may have.
const LONGEST_ID: usize = 100;

/// What was met.
#[derive(Clone, Copy, Debug, Default)]
pub struct Met {
    /// Numbers that were asked.
    pub numbers: usize,
    /// Choices that were asked.
    pub choices: usize,
    /// Mistakes of numbers.
    pub mistakes: usize,
    /// Answers that were typed with their units.
    pub typed: usize,
}

impl std::ops::AddAssign for Met {
    fn add_assign(&mut self, other: Self) {
        self.numbers += other.numbers;
        self.choices += other.choices;
        self.mistakes += other.mistakes;
        self.typed += other.typed;
    }
}

/// Checks variants of one form, of which each has something to ask.
pub fn marked_as_here(target: &str, items: &[Item]) -> Met {
    match target {
        _ if items.is_empty() => Met::default(),
        "moodle" => in_moodle(items),
        "qti3" | "qti21" => in_qti(target, items),
        "canvas" => in_canvas(items),
        "numbas" => in_numbas(items),
        "prairielearn" => in_prairielearn(items),
        "rexams" => in_rexams(items),
        other => panic!("{other} is not checked"),
    }
}

/// The points of the parts that go along.
fn points_asked(item: &Item) -> u32 {
    let is_left_out =
        |answers: &ItemAnswers| matches!(answers, ItemAnswers::Formula { mistaken, .. } if mistaken.is_empty());
    item.parts.iter().filter(|part| !is_left_out(&part.answers)).map(|part| part.field.points).sum()
}

fn in_moodle(items: &[Item]) -> Met {
    let mut met = Met::default();
    let root = xml::read(&text(exported("moodle", items)));
    let questions = questions(&root);
    assert_eq!(questions.len(), items.len());
    for (item, question) in items.iter().zip(questions) {
        let about = question.text_at(&["idnumber"]);
        assert!(!about.is_empty() && about.chars().count() <= LONGEST_ID, "{about}");
        let pictures: usize = item.parts.iter().map(|part| part.field.pictures.len()).sum();
        let files = question.at(&["questiontext"]).unwrap().all("file").count();
        assert_eq!(files, pictures + usize::from(item.sheet.figure.is_some()), "{about}");
        assert_eq!(question.all("hint").count(), item.sheet.hints.len(), "{about}");
        let solution = question.text_at(&["generalfeedback", "text"]);
        let shown = question.at(&["generalfeedback"]).unwrap().all("file").count();
        assert_eq!(solution.matches("@@PLUGINFILE@@").count(), shown, "{about}");
        let solution = decoded(solution);
        assert!(item.solution.sections.iter().all(|section| solution.contains(&section.heading)), "{about}");
        assert!(decoded(question.text_at(&["questiontext", "text"])).contains(&item.code), "{about}");
        let fields = moodle::fields(question);
        let weights: u32 = fields.iter().map(|field| field.weight).sum();
        assert!(weights > 0 && weights.is_multiple_of(points_asked(item)), "{about}: {weights}");
        let (asked, choosing): (Vec<&Field>, Vec<&Field>) = fields.iter().partition(|field| !field.is_choice);
        let numbers = numbers(item);
        assert_eq!(asked.len(), numbers.len(), "{about}");
        met.numbers += numbers.len();
        let coarse = question.attribute("type") != "cloze";
        for (field, (points, number)) in asked.into_iter().zip(&numbers) {
            let mark = |value: f64| {
                let (share, said) = field.mark_number(value);
                (share, said.to_owned())
            };
            met.mistakes += check(number, *points, Faith { credit: 0.05, coarse, ..WHOLE }, about, mark);
            if let [part] = &item.parts[..]
                && !field.units.is_empty()
            {
                assert_eq!(field.mark(&part.printed).0, 1.0, "{about}: {}", part.printed);
                met.typed += 1;
            }
        }
        for field in choosing {
            assert_eq!(field.answers.iter().filter(|answer| answer.fraction == 100.0).count(), 1, "{about}");
            met.choices += 1;
        }
    }
    met
}

fn in_qti(target: &str, items: &[Item]) -> Met {
    let mut met = Met::default();
    let files = unpacked(exported(target, items));
    let test = xml::read(file(&files, "test.xml"));
    let section = test.all("qti-test-part").chain(test.all("testPart")).next().unwrap();
    assert_eq!(section.children.len(), 1, "variants of a form are one section");
    for item in items {
        let written = qti::Item::read(file(&files, &format!("items/item-{}.xml", item.code)));
        let about = format!("{target} {} {}", item.identity.problem, written.identifier());
        met.mistakes += check_qti(item, &written, &about);
        met.numbers += numbers(item).len();
        met.choices += choices(item).len();
        let solution = written.feedback("SOLUTION", "solution").unwrap();
        assert!(item.solution.sections.iter().all(|section| solution.contains(&section.heading)), "{about}");
    }
    let manifest = xml::read(file(&files, "imsmanifest.xml"));
    let mut listed = Vec::new();
    manifest.walk(&mut |node| listed.extend((node.name == "file").then(|| node.attribute("href").to_owned())));
    let mut names: Vec<String> = files.iter().map(|(name, _)| name.clone()).collect();
    names.retain(|name| name != "imsmanifest.xml");
    listed.sort_unstable();
    names.sort_unstable();
    assert_eq!(listed, names);
    met
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
            let said = marked.outcomes.get(&told).map(|outcome| written.feedback(&told, outcome).unwrap());
            (marked.score / full, said.unwrap_or_default())
        });
    }
    for ((name, right), (options, place)) in choosing.into_iter().zip(choices(item)) {
        let found = written.choices(name);
        assert!(found.iter().zip(&options).all(|((_, text), option)| option.is_shown_as(text)), "{about}: {found:?}");
        assert_eq!(found.len(), options.len(), "{about}");
        assert_eq!(found[place].0, *right, "{about}");
        for (name_of_option, _) in &found {
            assert_eq!(written.mark(&[(name, name_of_option)]).score > 0.0, name_of_option == right, "{about}");
        }
    }
    mistakes
}

fn in_canvas(items: &[Item]) -> Met {
    let mut met = Met::default();
    let files = unpacked(exported("canvas", items));
    let quiz = format!("quiz-{}", items[0].code);
    let root = xml::read(file(&files, &format!("{quiz}/{quiz}.xml")));
    let groups: Vec<&Node> = root.at(&["assessment", "section"]).unwrap().all("section").collect();
    assert!(groups.iter().all(|group| group.all("item").count() <= items.len()));
    for item in items {
        let groups_of_item: Vec<&Node> = groups
            .iter()
            .flat_map(|group| group.all("item"))
            .filter(|group| group.attribute("ident").starts_with(&item.code))
            .collect();
        let (numerical, choosing): (Vec<&Node>, Vec<&Node>) =
            groups_of_item.into_iter().partition(|group| group.at(&["presentation", "response_str"]).is_some());
        let numbers = numbers(item);
        assert_eq!(numerical.len(), numbers.len());
        for (written, (points, number)) in numerical.into_iter().zip(numbers) {
            let mark = |value: f64| (if canvas_takes(written, value) { 1.0 } else { 0.0 }, String::new());
            let mut full = number.clone();
            // Canvas knows no credit: what earns less than everything earns nothing.
            full.windows.retain(|window| window.points.0 == Rational::from(points));
            check(&full, points, Faith { feedback: false, ..WHOLE }, &item.code, mark);
            met.numbers += 1;
        }
        for (written, (options, _)) in choosing.into_iter().zip(choices(item)) {
            let labels = written.at(&["presentation", "response_lid", "render_choice"]).unwrap();
            let texts = labels.all("response_label").map(|label| decoded(label.text_at(&["material", "mattext"])));
            let texts: Vec<String> = texts.collect();
            assert!(
                texts.iter().zip(&options).all(|(text, groups_of_item)| groups_of_item.is_shown_as(text)),
                "{texts:?}"
            );
            assert_eq!(texts.len(), options.len());
            met.choices += 1;
        }
    }
    met
}

fn canvas_takes(item: &Node, value: f64) -> bool {
    let end = |within: &Node, name| within.text_at(&[name]).parse::<f64>().ok();
    item.at(&["resprocessing"]).unwrap().all("respcondition").any(|condition| {
        let within = condition.at(&["conditionvar"]).unwrap();
        let ends = end(within, "vargte").zip(end(within, "varlte"));
        ends.is_some_and(|(low, high)| (low..=high).contains(&value))
    })
}

fn in_numbas(items: &[Item]) -> Met {
    let mut met = Met::default();
    let exam = numbas(items);
    let group = &exam["question_groups"][0];
    assert_eq!(group["pickQuestions"], 1);
    let questions = group["questions"].as_array().unwrap();
    assert_eq!(questions.len(), items.len());
    for (item, question) in items.iter().zip(questions) {
        let parts = question["parts"].as_array().unwrap();
        let entries = parts.iter().filter(|part| part["type"] == "numberentry");
        let numbers = numbers(item);
        assert_eq!(entries.clone().count(), numbers.len());
        met.numbers += numbers.len();
        for (part, (points, number)) in entries.zip(numbers) {
            let read = part["notationStyles"].as_array().unwrap();
            assert!(read.contains(&"scientific".into()), "Numbas reads 1.5e3 only in this notation");
            met.mistakes += check(number, points, WHOLE, &item.code, |value| numbas_mark(part, value));
        }
    }
    met
}

/// An exam as Numbas reads it.
pub fn numbas<'i>(items: impl IntoIterator<Item = &'i Item>) -> serde_json::Value {
    let exam = text(exported("numbas", items));
    let (first, rest) = exam.split_once('\n').unwrap();
    assert!(first.starts_with("// Numbas version:"));
    serde_json::from_str(rest).unwrap()
}

/// The first interval that holds the number counts, that of the part itself first.
fn numbas_mark(part: &serde_json::Value, value: f64) -> (f64, String) {
    let full = part["marks"].as_f64().unwrap();
    let end = |entry: &serde_json::Value, name: &str| entry[name].as_str().unwrap().parse::<f64>().unwrap();
    let all = std::iter::once(part).chain(part["alternatives"].as_array().unwrap());
    let mut fitting =
        all.filter(|alternative| (end(alternative, "minValue")..=end(alternative, "maxValue")).contains(&value));
    fitting.next().map_or((0.0, String::new()), |alternative| {
        let said = decoded(alternative["alternativeFeedbackMessage"].as_str().unwrap_or_default());
        (alternative["marks"].as_f64().unwrap() / full, said)
    })
}

fn in_prairielearn(items: &[Item]) -> Met {
    let Some(python) = python::found() else { return Met::default() };
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in unpacked(exported("prairielearn", items)) {
        if let Some(form) = name.strip_suffix("/server.py") {
            fs::write(folder.path().join(format!("{form}.py")), content).unwrap();
        }
    }
    let (mut met, mut probes, mut asked) = (Met::default(), Vec::new(), Vec::new());
    for (place, item) in items.iter().enumerate() {
        let form = Question::new(item).name();
        for (field, (points, number)) in number_fields(item).into_iter().zip(numbers(item)) {
            met.numbers += 1;
            for window in &number.windows {
                let worth = window.points.0.to_f64().value() / f64::from(points);
                let middle = window.low + (window.high - window.low) / 2.0;
                probes.push(serde_json::json!([form, place, field, middle]));
                asked.push((worth, window.feedback.clone(), format!("{} {field} {middle}", item.code)));
                met.mistakes += window.mistakes.len();
            }
        }
    }
    let marked = python::run(&python, folder.path(), python::PLAY, &serde_json::json!(probes));
    let marked = marked.as_array().unwrap();
    assert_eq!(marked.len(), asked.len());
    for ((worth, feedback, about), found) in asked.iter().zip(marked) {
        assert!((found[0].as_f64().unwrap() - worth).abs() < 1e-9, "{about}: {found} {worth}");
        let said = decoded(found[1].as_str().unwrap());
        assert!(
            feedback.iter().all(|feedback_part| said.contains(feedback_part.as_str())),
            "{about}: {said} {feedback:?}"
        );
    }
    met
}

/// The names of the fields for numbers: the label of the part, and a number where it has several.
fn number_fields(item: &Item) -> Vec<String> {
    let names = |part: &ItemPart| {
        let label = part.field.label.clone();
        match bank::numbers_of(&part.answers).len() {
            1 => vec![label],
            count => (1..=count).map(|place| format!("{label}{place}")).collect(),
        }
    };
    item.parts.iter().flat_map(names).collect()
}

/// R/exams knows a number and a tolerance.
fn in_rexams(items: &[Item]) -> Met {
    let mut met = Met::default();
    let files = unpacked(exported("rexams", items));
    let asked = files[0].1.lines().filter_map(|line| line.trim().strip_prefix("types = "));
    let asked: Vec<Vec<&str>> = asked.map(|line| line.split('"').skip(1).step_by(2).collect()).collect();
    assert_eq!(asked.len(), items.len());
    for (item, asked) in items.iter().zip(asked) {
        let [kinds, right, tolerance, points] = [0, 1, 2, 3].map(|place| asked[place].split('|').collect::<Vec<_>>());
        let all: u32 = points.iter().map(|points| points.parse::<u32>().unwrap()).sum();
        assert!(all.is_multiple_of(points_asked(item)), "{}: {points:?}", item.code);
        let fields = kinds.iter().zip(right.iter().zip(tolerance));
        let of_numbers = fields.filter(|(kind, _)| **kind == "num").map(|(_, field)| field);
        let numbers = numbers(item);
        assert_eq!(of_numbers.clone().count(), numbers.len(), "{}", item.code);
        for ((right, tolerance), (points, number)) in of_numbers.zip(numbers) {
            let [right, tolerance]: [f64; 2] = [*right, tolerance].map(|text| text.parse().unwrap());
            let is_home = |window: &&Window| (window.low..=window.high).contains(&number.right);
            let full = number.windows.iter().find(is_home).unwrap();
            assert_eq!(full.points.0, Rational::from(points), "{}", item.code);
            let is_right = |value: f64| (value - right).abs() <= tolerance;
            assert!([full.low, full.high, number.right].into_iter().all(is_right), "{}: {full:?}", item.code);
            // The solution is the printed value, which is off the middle by no more than rounding.
            let mut ends = [full.low, full.high];
            for window in number.windows.iter().filter(|window| window.points.0 == full.points.0) {
                if window.low <= ends[1] && window.high >= ends[0] {
                    ends = [ends[0].min(window.low), ends[1].max(window.high)];
                }
            }
            let furthest = (right - ends[0]).max(ends[1] - right);
            assert!(tolerance <= furthest * (1.0 + 1e-9) + 1e-12 * right.abs(), "{}: {tolerance} {full:?}", item.code);
            assert!((right - number.right).abs() <= 0.006 * number.right.abs(), "{}: {right}", item.code);
            met.numbers += 1;
        }
        met.choices += choices(item).len();
    }
    met
}
