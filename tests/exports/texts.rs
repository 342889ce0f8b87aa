//! Text that some format could read arrives as text.

use std::fs;

use momentous::exercise::{Item, ItemAnswers};
use momentous::explain::Inline;
use momentous::export::Question;
use momentous::render::Markup;
use proptest::prelude::*;

use super::bank::{carts, exported, file, text, unpacked};
use super::marked::numbas;
use super::xml::{Node, decoded};
use super::{moodle, python, qti, questions, xml};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn hostile_text_arrives_as_text_in_moodle(case in hostile_case()) {
        let item = case.item();
        let root = xml::read(&text(exported("moodle", [&item])));
        let question = questions(&root)[0];
        prop_assert!(question.text_at(&["name", "text"]).starts_with(case.title.as_str()));
        prop_assert!(decoded(question.text_at(&["questiontext", "text"])).contains(case.title.as_str()));
        let fields = moodle::fields(question);
        let answers = &fields.last().unwrap().answers;
        prop_assert_eq!(&answers.iter().map(|answer| answer.text.clone()).collect::<Vec<_>>(), &case.options);
        prop_assert_eq!(answers[1].feedback.trim_end_matches('\n'), case.because.as_str());
        prop_assert_eq!(answers[0].feedback.trim_end_matches('\n'), case.title.as_str());
        prop_assert_eq!(answers.iter().map(|answer| answer.fraction).position(|answer| answer == 100.0), Some(1));
    }

    #[test]
    fn hostile_text_arrives_as_text_in_qti(case in hostile_case()) {
        for target in ["qti3", "qti21"] {
            let item = case.item();
            let files = unpacked(exported(target, [&item]));
            let written = qti::Item::read(file(&files, &format!("items/item-{}.xml", item.code)));
            prop_assert!(written.title().starts_with(case.title.as_str()));
            prop_assert!(written.text().contains(case.title.as_str()));
            let (name, _) = written.responses().pop().unwrap();
            let choices = written.choices(&name);
            prop_assert_eq!(&choices.iter().map(|(_, text)| text.clone()).collect::<Vec<_>>(), &case.options);
            for (place, said) in [(0, &case.title), (1, &case.because)] {
                let told = name.replace("RESPONSE", "FEEDBACK");
                let marked = written.mark(&[(&name, &choices[place].0)]);
                let shown = written.feedback(&told, &marked.outcomes[&told]).unwrap();
                prop_assert_eq!(shown.trim_end_matches('\n'), said.as_str());
            }
        }
    }

    #[test]
    fn hostile_text_arrives_as_text_in_canvas(case in hostile_case()) {
        let item = case.item();
        let files = unpacked(exported("canvas", [&item]));
        let root = xml::read(file(&files, &format!("quiz-{0}/quiz-{0}.xml", item.code)));
        let groups = root.at(&["assessment", "section"]).unwrap();
        let written = groups.all("section").last().unwrap().at(&["item"]).unwrap();
        prop_assert!(written.attribute("title").starts_with(case.title.as_str()));
        let html = |node: &Node| decoded(node.text_at(&["material", "mattext"]));
        prop_assert!(html(written.at(&["presentation"]).unwrap()).contains(case.title.as_str()));
        let labels = written.at(&["presentation", "response_lid", "render_choice"]).unwrap().all("response_label");
        prop_assert_eq!(&labels.map(html).collect::<Vec<_>>(), &case.options);
        let said = |name: &str| written.all("itemfeedback").find(|answer| answer.attribute("ident").ends_with(name)).unwrap();
        let said = |name: &str| html(said(name).at(&["flow_mat"]).unwrap()).trim_end_matches('\n').to_owned();
        prop_assert_eq!(said("-1_fb"), case.title.clone());
        prop_assert_eq!(said("-2_fb"), case.because.clone());
    }

    #[test]
    fn hostile_text_arrives_as_text_in_numbas(case in hostile_case()) {
        let exam = numbas([&case.item()]);
        let question = &exam["question_groups"][0]["questions"][0];
        let part = question["parts"].as_array().unwrap().last().unwrap();
        let literal = |text: &serde_json::Value| {
            let html = text.as_str().unwrap();
            assert!(html.starts_with("<div nosubvars>"), "{html}");
            decoded(html).trim_end_matches('\n').to_owned()
        };
        prop_assert!(literal(&part["prompt"]).contains(case.title.as_str()));
        let list = |name: &str| part[name].as_array().unwrap().iter().map(literal).collect::<Vec<_>>();
        prop_assert_eq!(&list("choices"), &case.options);
        let said = list("distractors");
        prop_assert_eq!(&said[0], &case.title);
        prop_assert_eq!(&said[1], &case.because);
        let title = case.title.replace(['{', '}'], "");
        prop_assert!(question["name"].as_str().unwrap().starts_with(&title));
    }

    #[test]
    fn hostile_text_arrives_as_text_in_rexams(case in hostile_case()) {
        let item = case.item();
        let files = unpacked(exported("rexams", [&item]));
        let page = &files[0].1;
        // Where the chunk of data ends, and nothing of the problem stands behind it.
        let (data, rest) = page.split_once("\n)\nvariant <- ").unwrap();
        prop_assert_eq!(data.matches("```").count(), 1, "one chunk begins, and none ends");
        prop_assert!(!rest.contains(&item.code));
        let strings: Vec<String> = strings(data);
        let escaped: Vec<String> = case.options.iter().map(|answer| Markup::Markdown.text(answer)).collect();
        let place = strings.windows(escaped.len()).position(|answer| answer == escaped.as_slice());
        prop_assert!(place.is_some(), "{:?} {:?}", strings, escaped);
    }
}

/// The strings of a piece of R, read as R reads them.
fn strings(code: &str) -> Vec<String> {
    let mut all = Vec::new();
    let mut letters = code.chars();
    while letters.by_ref().any(|letter| letter == '"') {
        let mut text = String::new();
        while let Some(letter) = letters.next().filter(|letter| *letter != '"') {
            text.push(match letter {
                '\\' => match letters.next().unwrap() {
                    'n' => '\n',
                    't' => '\t',
                    'r' => '\r',
                    sign @ ('"' | '\\') => sign,
                    other => panic!("\\{other}"),
                },
                letter => letter,
            });
        }
        all.push(text);
    }
    all
}

#[test]
fn hostile_text_arrives_as_text_in_prairielearn() {
    let Some(python) = python::found() else { return };
    let folder = tempfile::tempdir().unwrap();
    let title = r#"<b>&amp; ]]> \ "quoted" 'x' $ {{a}} {% b %} ~ #1 """ \n \u0041 €"#;
    let case = Case {
        title: title.to_owned(),
        options: vec![title.to_owned(), "b".to_owned()],
        because: title.to_owned(),
        several: false,
    };
    let item = case.item();
    let files = unpacked(exported("prairielearn", [&item]));
    let form = Question::new(&item).name();
    fs::write(folder.path().join(format!("{form}.py")), file(&files, &format!("{form}/server.py"))).unwrap();
    let about: serde_json::Value = serde_json::from_str(file(&files, &format!("{form}/info.json"))).unwrap();
    assert!(about["title"].as_str().unwrap().starts_with(title));
    let label = &item.parts[0].field.label;
    let probe = serde_json::json!([[form, 0, label, "a"], [form, 0, label, "b"]]);
    let marked = python::run(&python, folder.path(), python::PLAY, &probe);
    assert_eq!(marked[0][0], 0.0);
    assert_eq!(marked[1][0], 1.0);
    for found in [&marked[0][1], &marked[1][1], &marked[0][2]] {
        assert!(decoded(found.as_str().unwrap()).contains(title), "{found}");
    }
}

/// Texts that some format could read.
#[derive(Clone, Debug)]
struct Case {
    title: String,
    options: Vec<String>,
    because: String,
    several: bool,
}

impl Case {
    /// Two carts with a choice of those texts, alone or behind a number.
    fn item(&self) -> Item {
        let mut item = carts();
        // The worked solution is long, and none of these texts stands in it.
        item.solution.sections.clear();
        item.sheet.title.clone_from(&self.title);
        item.parts.truncate(1);
        let mut choice = item.parts[0].clone();
        choice.field.unit = None;
        choice.field.question = vec![Inline::Text(self.title.clone())];
        choice.answers = ItemAnswers::Choice {
            options: self.options.clone(),
            right: 1,
            because: self.because.clone(),
            wrong: vec![vec![self.title.clone()]; self.options.len()],
        };
        if self.several {
            "b".clone_into(&mut choice.field.label);
            item.parts.push(choice);
        } else {
            item.parts = vec![choice];
        }
        item
    }
}

fn hostile_case() -> impl Strategy<Value = Case> {
    // Between dollars an option holds mathematics, unless a space follows the first.
    let option = hostile().prop_map(|text| text.replace('$', "$ a"));
    let options = proptest::collection::vec(option, 2..5);
    (hostile(), options, hostile(), any::<bool>()).prop_map(|(title, options, because, several)| Case {
        title,
        options,
        because,
        several,
    })
}

/// Text of signs that some format reads.
fn hostile() -> impl Strategy<Value = String> {
    "([<&>{}~#$=%\\\\\"':;`|a1]|\\]\\]>|&amp;|\\\\\\)|\\\\\\(|```|`r 1`){1,12}"
}

#[test]
fn control_characters_break_no_format() {
    let odd = "a\u{0}b\u{1}\u{b}\u{1b}c\u{7f}\u{fffe}\n\td";
    let case = Case {
        title: odd.to_owned(),
        options: vec![odd.to_owned(), "b".to_owned()],
        because: odd.to_owned(),
        several: true,
    };
    let item = case.item();
    xml::read(&text(exported("moodle", [&item])));
    numbas([&item]);
    for target in ["qti3", "qti21", "canvas", "prairielearn", "rexams"] {
        for (name, content) in unpacked(exported(target, [&item])) {
            if target.starts_with("qti") && !name.contains(".svg") || name == "imsmanifest.xml" {
                xml::read(&content);
            }
            let is_odd = |letter: char| letter.is_control() && !matches!(letter, '\n' | '\t' | '\r' | '\u{7f}');
            assert!(!content.contains(is_odd), "{target} {name}");
        }
    }
}
