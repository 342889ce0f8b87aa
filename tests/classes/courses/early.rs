//! Answers cannot be had early: where two problems print the same sheet and have other right answers, every byte that a student can get
//! before release is the same.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::course::{Moment, ProblemFile, Release};
use momentous::fault::Source;
use momentous::problem::{compile, load};

use super::university::{Answer, BEGIN, Browser, DAY, RELEASED, University};

/// How the carts rebound is printed nowhere; only the answers tell.
const PROBLEM: &str = "
id: impact/two-carts
title: Two carts
level: intro
scene:
  axes: { x: to the right }
  bodies:
    A: { name: cart A, mass: m_A }
    B: { name: cart B, mass: m_B }
  stages:
    - impact: { between: [A, B], restitution: HIDDEN }
given:
  m_A: { min: 1, max: 6, step: 0.5, unit: kg }
  m_B: { min: 1, max: 6, step: 0.5, unit: kg }
  v_A1: { min: 2, max: 6, step: 0.5, unit: m/s }
  v_B1: { min: -6, max: -2, step: 0.5, unit: m/s }
hints:
  - Momentum is conserved.
text: >
  Cart A ({{ m_A }}) {{ v_A1 | motion }}, cart B ({{ m_B }}) {{ v_B1 | motion }}. They collide. Find the velocities afterwards.
ask:
  - { find: v_A2, unit: m/s, points: 2 }
  - { find: v_B2, unit: m/s, points: 2 }
  - { classify: impact }
  - { conserved: energy, of: [A, B] }
";

/// The problem, right in two ways.
const HIDDEN: [&str; 2] = ["1", "1/2"];

/// Texts that a student might have read, to learn from how they are read.
const TEXTS: [&str; 7] = ["3.00 m/s", "-3.00 m/s", "elastic", "yes", "3..2", "5.00 J", ""];

fn source(hidden: &str) -> Source {
    Source::new("problem_bank/impact/two-carts.yaml", &PROBLEM.replace("HIDDEN", hidden))
}

/// A course whose assignment has the problem that is right in this way.
fn university(hidden: &str) -> (University, String) {
    let university = University::new();
    let source = source(hidden);
    let file = ProblemFile {
        text: source.text.to_string(),
        digest: load(source).unwrap().digest,
        problem: "impact/two-carts".to_owned(),
        course: Some(university.course.key),
        published: Some(Moment::from_millis(BEGIN)),
        saved: Moment::from_millis(BEGIN),
    };
    university.wait(async |store| store.save_problem_file(&file, None).await).unwrap();
    let whole = university.assignment(&[("impact/two-carts", "", 10)], |policy| policy.verdicts = Release::AtClose);
    let item = university.address(&format!("/items/{}", whole.items[0].key));
    (university, item)
}

/// What is right where `hidden` is, of Ada's sheet.
fn right(university: &University, hidden: &str) -> BTreeMap<String, String> {
    let sheets = university.wait(async |store| store.sheets_of(University::member("ada")).await).unwrap();
    let problem = compile(load(source(hidden)).unwrap(), Some(university.course.secret.as_bytes())).unwrap();
    let exercise = sheets[0].issued.draw(&Arc::new(problem)).unwrap();
    exercise.worked().form.parts.iter().map(|part| (part.id.clone(), exercise.printed(part))).collect()
}

/// A response as bytes that can be compared. The key of the next request is drawn at random.
fn bytes(answer: &Answer) -> String {
    let pieces = answer.text.split("name=\"request\" value=\"").enumerate();
    let text: String = pieces.map(|(place, piece)| if place == 0 { piece } else { &piece[32..] }).collect();
    format!("{} {:?}\n{text}", answer.status, answer.headers)
}

/// All that a student can get who tries everything; `typed` is handed in.
struct Tried<'b, 'u> {
    ada: &'b mut Browser<'u>,
    item: String,
    seen: Vec<(String, String)>,
}

impl Tried<'_, '_> {
    fn get(&mut self, address: &str) {
        let answer = self.ada.get(address);
        self.seen.push((format!("GET {address}"), bytes(&answer)));
    }

    fn post(&mut self, path: &str, fields: &[(&str, &str)]) {
        let answer = self.ada.post(&format!("{}{path}", self.item), fields);
        self.seen.push((format!("POST {path} {fields:?}"), bytes(&answer)));
    }

    /// Every page on which something of the item stands.
    fn pages(&mut self, university: &University) {
        let assignment = university.address(&format!("/assignments/{}", momentous::course::Key::<()>::new([9; 16])));
        let addresses = [self.item.clone(), format!("{}/solution", self.item), assignment, university.address("")];
        for address in addresses {
            self.get(&address);
        }
        let elsewhere =
            ["practice", "solution", "solve", "play"].map(|page| format!("/{page}/impact/two-carts?seed=7"));
        for address in elsewhere.iter().map(String::as_str).chain(["/courses", "/"]) {
            self.get(address);
        }
    }
}

/// Everything that Ada sees before release, and after.
fn tried(hidden: &str) -> [Vec<(String, String)>; 2] {
    let (university, item) = university(hidden);
    let mut ada = university.browser_of("ada");
    let mut tried = Tried { ada: &mut ada, item, seen: Vec::new() };
    tried.pages(&university);
    // In both worlds what is right in the first is handed in.
    let answers = right(&university, HIDDEN[0]);
    let other = right(&university, HIDDEN[1]);
    assert!(answers.iter().all(|(part, text)| other[part] != *text), "{answers:?} {other:?}");
    for (part, text) in &answers {
        for text in TEXTS.into_iter().chain([text.as_str(), &other[part]]) {
            tried.post("/read", &[("part", part), ("text", text)]);
        }
        tried.post("/read", &[("part", part), ("text", "x".repeat(5000).as_str())]);
    }
    let named: Vec<(String, &str)> =
        answers.iter().map(|(part, text)| (format!("answer.{part}"), text.as_str())).collect();
    let fields: Vec<(&str, &str)> = named.iter().map(|(name, text)| (name.as_str(), *text)).collect();
    tried.post("/draft", &fields);
    tried.post("/draft", &[&fields[..], &[("do", "script")]].concat());
    tried.post("/hint", &[]);
    tried.post("/hint", &[]);
    tried.post("", &[("request", "unreadable"), ("answer.v_A2", "3..2")]);
    tried.pages(&university);
    for request in ["first", "first", "again"] {
        tried.post("", &[&[("request", request)][..], &fields].concat());
        tried.pages(&university);
    }
    for part in answers.keys() {
        tried.post(&format!("/further/{part}"), &[]);
    }
    // A right part would be locked, and a wrong one would lose an attempt.
    for (request, text) in [("2", "1.00 m/s"), ("3", "2.00 m/s"), ("4", "3.00 m/s"), ("5", "4.00 m/s")] {
        tried.post("", &[("request", request), ("answer.v_A2", text), ("answer.nothing", text)]);
        tried.pages(&university);
    }
    university.set_clock(DAY + 1);
    tried.post("", &[("request", "late"), ("answer.v_B2", "7.00 m/s")]);
    tried.pages(&university);
    let before = std::mem::take(&mut tried.seen);
    university.set_clock(3 * DAY + RELEASED);
    tried.pages(&university);
    [before, tried.seen]
}

#[test]
fn before_release_no_byte_depends_on_what_is_right() {
    let [one, other] = HIDDEN.map(tried);
    for ((asked, seen), (_, instead)) in one[0].iter().zip(&other[0]) {
        assert_eq!(seen, instead, "{asked}");
    }
    assert_eq!(one[0].len(), other[0].len());
    let text: String = one[0].iter().map(|(_, seen)| seen.as_str()).collect();
    for shown in
        ["Momentum is conserved", "Read as", "no attempt is left", "It is late", "part of an assignment that is open"]
    {
        assert!(text.contains(shown), "nothing was tried that shows `{shown}`");
    }
    assert_ne!(one[1], other[1], "after release the answers are told");
}
