//! Marking: what is judged how, and what the report says.

use std::collections::BTreeMap;
use std::path::Path;

use momentous::grade::{
    Answer, Attempts, DecimalMark, Expected, ExpectedKind, ExpectedNumber, HintsSeen, History, Keep, Rubric, Typed,
    Verdict, grade, judge, read,
};
use momentous::quantity::{Decimal, Printed, Quantity, Rational, Tolerance, Unit};
use proptest::prelude::*;

fn expected(value: &str, unit: &str) -> ExpectedNumber {
    let value = Decimal::parse(value).unwrap_or_else(|fault| panic!("{value}: {fault}"));
    let unit = Unit::parse(unit).unwrap_or_else(|fault| panic!("{unit}: {fault}"));
    ExpectedNumber { exact: Some(value.to_rational()), ..ExpectedNumber::new(value.to_f64(), unit) }
}

fn part(number: ExpectedNumber) -> Expected {
    Expected { id: "v_A2".to_owned(), points: 2, kind: ExpectedKind::Number(number) }
}

/// The settings of a row of the table: a setting begins with a word of its own, so that values may hold spaces.
fn set(number: &mut ExpectedNumber, settings: &str) {
    const KEYS: [&str; 9] =
        ["tolerance", "allowance", "scale", "error", "senses", "magnitude", "whole", "cyclic", "inexact"];
    let mut found: Vec<String> = Vec::new();
    for word in settings.split_whitespace() {
        let key = word.split('=').next().unwrap_or_default();
        match found.last_mut() {
            Some(last) if !KEYS.contains(&key) => last.extend([" ", word]),
            _ => found.push(word.to_owned()),
        }
    }
    for setting in found {
        let (key, value) = setting.split_once('=').unwrap_or((&setting, ""));
        let float = || value.parse::<f64>().unwrap_or_else(|_| panic!("{setting}"));
        match key {
            "tolerance" => {
                let quantity = Quantity::parse(value).unwrap_or_else(|fault| panic!("{setting}: {fault}"));
                let make = if quantity.unit.is_none() { Tolerance::Relative } else { Tolerance::Absolute };
                number.tolerance = make(quantity.value);
            }
            "allowance" => number.allowance = float(),
            "scale" => number.scale = float(),
            "error" => number.error = float(),
            "senses" => {
                let (plus, minus) = value.split_once('|').unwrap_or_else(|| panic!("{setting}"));
                number.senses = Some([plus.to_owned(), minus.to_owned()]);
            }
            "magnitude" => number.signed = false,
            "whole" => number.whole = true,
            "cyclic" => number.cyclic = true,
            "inexact" => number.exact = None,
            _ => panic!("{setting}"),
        }
    }
}

fn rows() -> Vec<csv::StringRecord> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/answers/judged.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(path).expect("the table is there");
    reader.records().map(|row| row.expect("five columns")).collect()
}

fn understood(text: &str, part: &Expected) -> Answer {
    read(text, &part.kind, DecimalMark::Point).unwrap_or_else(|fault| panic!("{text}: {fault}"))
}

#[test]
fn answers_are_judged_as_the_table_says() {
    let mut wrong = Vec::new();
    for row in rows() {
        let [value, unit, settings, text, verdict] = [0, 1, 2, 3, 4].map(|column| &row[column]);
        let mut number = expected(value, unit);
        set(&mut number, settings);
        let part = part(number);
        let judgement = judge(&part, &understood(text, &part));
        let also = judgement.also.map(|also| format!("+{also}")).unwrap_or_default();
        let found = format!("{}{also}", judgement.verdict);
        if found != verdict {
            wrong.push(format!("{text} for {value} {unit} ({settings}): {found}, not {verdict}"));
        }
    }
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}

#[test]
fn no_message_holds_the_right_value() {
    for row in rows() {
        let [value, unit, settings, text] = [0, 1, 2, 3].map(|column| &row[column]);
        let mut number = expected(value, unit);
        set(&mut number, settings);
        let report = mark(&[part(number)], &[("v_A2", text)]);
        let message = &report.parts[0].message;
        let digits = value.trim_start_matches('-');
        // A message may say how many figures are asked, so one digit alone proves nothing.
        assert!(digits.len() < 2 || !message.contains(digits), "{text} for {value}: {message}");
    }
}

#[test]
fn advice_on_figures_costs_nothing() {
    let asked = part(expected("3.1", "m/s"));
    let told = |text: &str| {
        let judgement = judge(&asked, &understood(text, &asked));
        (judgement.verdict, judgement.messages.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "))
    };
    assert_eq!(told("3.10 m/s"), (Verdict::Right, "Right.".to_owned()));
    assert_eq!(told("3.1 m/s"), (Verdict::Right, "Right. Write 3 significant figures.".to_owned()));
    assert_eq!(told("31/10 m/s"), (Verdict::Right, "Right.".to_owned()));
    let many = "Right. The data support no more than 3 significant figures.".to_owned();
    assert_eq!(told("3.1000 m/s"), (Verdict::Right, many));
    // Trailing zeros of an integer may or may not be figures.
    let hundred = part(expected("100", "m/s"));
    let judgement = judge(&hundred, &understood("100 m/s", &hundred));
    assert_eq!((judgement.verdict, judgement.messages.len()), (Verdict::Right, 1));
}

fn mark(expected: &[Expected], answers: &[(&str, &str)]) -> momentous::grade::Report {
    let answers: BTreeMap<String, String> =
        answers.iter().map(|(id, text)| ((*id).to_owned(), (*text).to_owned())).collect();
    grade(expected, &answers, DecimalMark::Either, &Rubric::default())
}

fn collision() -> Vec<Expected> {
    let senses = || Some(["to the right".to_owned(), "to the left".to_owned()]);
    let number = |id: &str, value: &str, unit: &str, senses| Expected {
        id: id.to_owned(),
        points: 2,
        kind: ExpectedKind::Number(ExpectedNumber { senses, ..expected(value, unit) }),
    };
    let choice = ExpectedKind::Choice {
        question: String::new(),
        options: vec!["conserved".to_owned(), "not conserved".to_owned()],
        right: 1,
        because: "the impact is not elastic".to_owned(),
    };
    vec![
        number("v_A2", "-0.4", "m/s", senses()),
        number("v_B2", "3.1", "m/s", senses()),
        number("T_lost", "7.65", "J", None),
        Expected { id: "a".to_owned(), points: 1, kind: choice },
    ]
}

#[test]
fn a_report_says_marks_and_reasons() {
    let answers =
        [("v_A2", "0.400 m/s"), ("v_B2", "3.10"), ("T_lost", "7,650 J"), ("a", "conserved"), ("T_los", "7.65 J")];
    let report = mark(&collision(), &answers);
    let expected = "\
v_A2: 1/2 [sense] The magnitude is right. State its direction, too: by a sign, or \"to the right\" or \"to the left\".
    read as: 0.400 metres per second
v_B2: 1/2 [unit_missing] The number is right. The unit is missing.
    read as: 3.10
T_lost: 0/2 [unreadable] Character 2: this can be read in two ways: write `7650` or `7.650`.
a: 0/1 [choice_wrong] Not this one.
    read as: conserved
T_los: not asked for
total: 2/7
";
    assert_eq!(report.to_string(), expected);
    assert!(!report.is_right() && report.is_unreadable());
}

#[test]
fn a_report_has_stable_keys() {
    let report = mark(&collision(), &[("v_A2", "0.400 m/s to the left"), ("a", "b")]);
    let json = serde_json::to_string(&report).expect("a report is data");
    let expected = concat!(
        r#"{"parts":[{"id":"v_A2","verdict":"right","points":2,"out_of":2,"understood":"0.400 metres per second to the left","fault":null,"message":"Right."},"#,
        r#"{"id":"v_B2","verdict":"unanswered","points":0,"out_of":2,"understood":null,"fault":null,"message":"No answer."},"#,
        r#"{"id":"T_lost","verdict":"unanswered","points":0,"out_of":2,"understood":null,"fault":null,"message":"No answer."},"#,
        r#"{"id":"a","verdict":"right","points":1,"out_of":1,"understood":"not conserved","fault":null,"message":"Right: the impact is not elastic."}],"#,
        r#""total":3,"out_of":7,"not_asked":[]}"#,
    );
    assert_eq!(json, expected);
}

#[test]
fn an_answer_that_cannot_be_read_says_where() {
    let report = mark(&collision(), &[("v_A2", "3..2 m/s")]);
    let json = serde_json::to_value(&report.parts[0]).expect("a report is data");
    assert_eq!(json["fault"], serde_json::json!({ "character": 2, "code": "marks" }));
    assert_eq!((&json["verdict"], &json["points"]), (&"unreadable".into(), &0.into()));
}

#[test]
fn a_wrong_number_is_never_called_right() {
    let report = mark(&collision(), &[("v_A2", "-0.5"), ("v_B2", "4 J")]);
    let messages: Vec<&str> = report.parts.iter().map(|part| part.message.as_ref()).take(2).collect();
    let dimension = "Not right. Check the unit: this is an energy, but the question asks for a velocity.";
    assert_eq!(messages, ["Not right. The unit is missing.", dimension]);
}

#[test]
fn findings_that_meet_multiply() {
    let report = mark(&collision(), &[("v_A2", "0.400")]);
    assert_eq!(report.total.to_string(), "0.5");
    assert_eq!(report.parts[0].verdict, Verdict::Sense);
    let strict = Rubric::default().with(Verdict::UnitMissing, Rational::ZERO);
    let answers = BTreeMap::from([("v_B2".to_owned(), "3.10".to_owned())]);
    assert_eq!(grade(&collision(), &answers, DecimalMark::Point, &strict).total.to_string(), "0");
}

/// Of the attempt that counts: its points and its verdict.
fn attempts_at(texts: &[&str], rubric: &Rubric, hints: u32) -> (String, String) {
    let part = || vec![part(expected("3.1", "m/s"))];
    let answers = |text: &str| BTreeMap::from([("v_A2".to_owned(), text.to_owned())]);
    let mut history = History::default();
    let mut reports = Vec::new();
    for text in texts {
        let typed = [Typed { text, seen: HintsSeen { hints, further: 0 }, readable: None }];
        reports.push(history.mark(&typed, &Rational::ONE, &rubric.attempts, &mut |texts, _| {
            grade(&part(), &answers(texts[0]), DecimalMark::Point, rubric)
        }));
    }
    let counting = usize::try_from(history.counting().expect("there are attempts")).expect("it is small");
    let report = &reports[counting - 1];
    (report.total.to_string(), report.parts[0].verdict.to_string())
}

#[test]
fn attempts_and_hints_cost_what_the_rubric_says() {
    let tenth = || Rational::ONE / Rational::from(10);
    let mut best = Rubric::default();
    best.attempts = Attempts { most: Some(3), penalty: tenth(), hint: tenth(), ..Attempts::default() };
    let mut last = best.clone();
    last.attempts.keep = Keep::Last;
    for (texts, hints, by_best, by_last) in [
        (&["3.1 m/s"][..], 0, ("2", "right"), ("2", "right")),
        (&["9 m/s", "3.1 m/s"], 0, ("1.8", "right"), ("1.8", "right")),
        // What is right is locked.
        (&["3.1 m/s", "9 m/s"], 0, ("2", "right"), ("2", "right")),
        (&["9 m/s", "3.1 m/s", "3.10 m/s"], 0, ("1.8", "right"), ("1.8", "right")),
        // A fourth attempt is none.
        (&["9 m/s", "8 m/s", "7 m/s", "3.1 m/s"], 0, ("0", "wrong"), ("0", "wrong")),
        // What cannot be read, what is empty and what was there before costs no attempt.
        (&["3..1 m/s", "", "3.1 m/s"], 0, ("2", "right"), ("2", "right")),
        (&["9 m/s", " 9 m/s", "3..1 m/s", "", "3.1 m/s"], 0, ("1.8", "right"), ("1.8", "right")),
        (&["3.1 m/s"], 2, ("1.6", "right"), ("1.6", "right")),
        (&["3.1", "3.1 m/s"], 0, ("1.8", "right"), ("1.8", "right")),
        // The better of two attempts counts, or the last.
        (&["3.1", "9 m/s"], 0, ("1", "unit_missing"), ("0", "wrong")),
        (&["3..1 m/s"], 0, ("0", "unreadable"), ("0", "unreadable")),
        (&["9 m/s", "3..1 m/s"], 0, ("0", "wrong"), ("0", "wrong")),
    ] {
        let owned = |(total, verdict): (&str, &str)| (total.to_owned(), verdict.to_owned());
        assert_eq!(attempts_at(texts, &best, hints), owned(by_best), "{texts:?}");
        assert_eq!(attempts_at(texts, &last, hints), owned(by_last), "{texts:?}");
    }
}

proptest! {
    #[test]
    fn the_printed_answer_is_right(value in -1e5..1e5_f64, figures in 3..8_usize) {
        let printed = Printed::new(value, figures).expect("it is finite").plain();
        let number = ExpectedNumber { value, exact: None, scale: value.abs(), ..expected("1", "N s") };
        let part = part(number);
        let judgement = judge(&part, &understood(&format!("{printed} N s"), &part));
        prop_assert_eq!(judgement.verdict, Verdict::Right);
    }

    #[test]
    fn units_do_not_matter(milli in 1..10_000_000_i64, off in -20..20_i64) {
        let value = Decimal::from_scaled(i128::from(milli), 3).to_string();
        let answer = Decimal::from_scaled(i128::from(milli * (1000 + off)), 6).to_string();
        let part = part(expected(&value, "m/s"));
        let here = judge(&part, &understood(&format!("{answer} m/s"), &part)).verdict;
        let there = judge(&part, &understood(&format!("{answer}*3.6 km/h"), &part)).verdict;
        prop_assert_eq!(here, if off.abs() <= 10 { Verdict::Right } else { Verdict::Wrong });
        prop_assert_eq!(there, here);
    }
}
