//! A student at a sheet, as the tests need one.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use momentous::bank::Bank;
use momentous::course::{
    Accepted, Attempt, HandIn, HintShown, Item, Key, Moment, Policy, PolicyForm, Refusal, Sheet, StoredReport, Weights,
    Window, WorkedSheet,
};
use momentous::exercise::{Exercise, WORK};
use momentous::fault::Source;
use momentous::grade::DecimalMark;
use momentous::problem::{CourseSymbols, Problem, compile, load};

pub const ZONE: &str = "Europe/Berlin";

/// The carts of the bank, where seed 1 is 2.5 kg at 5.5 m/s and 2 kg at -3.5 m/s with e = 0.5: by hand -0.5 m/s, 4.0 m/s and 33.75 J.
pub fn text() -> String {
    Bank::built_in().find("impact/two-carts").unwrap().text.to_string()
}

/// The problem of a text, which is compiled once.
pub fn problem(text: &str) -> Arc<Problem> {
    static KNOWN: Mutex<BTreeMap<String, Arc<Problem>>> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN.lock().unwrap();
    let compiled = || Arc::new(compile(load(Source::new("two-carts.yaml", text)).unwrap(), None).unwrap());
    known.entry(text.to_owned()).or_insert_with(compiled).clone()
}

/// Two attempts before the third cost a tenth each, a hint a twentieth, a further one a fiftieth, and a day a fifth.
pub fn form() -> PolicyForm {
    PolicyForm {
        attempts: "3".into(),
        attempt_penalty: "10 %".into(),
        hint_penalty: "5 %".into(),
        further_penalty: "2 %".into(),
        opens: "2026-11-23T08:00".into(),
        due: "2026-11-30T18:00".into(),
        late_until: "2026-12-02T18:00".into(),
        late_penalty: "20 %".into(),
        closes: "2026-12-03T18:00".into(),
        ..PolicyForm::default()
    }
}

pub fn policy(form: &PolicyForm) -> Policy {
    Policy::read(form, ZONE).unwrap()
}

pub fn at(local: &str) -> Moment {
    Moment::local(local, ZONE).unwrap()
}

pub fn key<Of>(byte: u8) -> Key<Of> {
    Key::new([byte; 16])
}

pub fn item(position: u32, points: u32) -> Item {
    Item {
        key: key(100 + u8::try_from(position).unwrap()),
        assignment: key(1),
        position,
        problem: "impact/two-carts".into(),
        form: Some("forward".into()),
        points,
        weights: Weights::default(),
        repeat: 0,
        digest: None,
        letters: CourseSymbols::default(),
        issue: 1,
        dropped: false,
    }
}

/// A student who works on seed 1.
pub struct Desk {
    pub exercise: Exercise,
    pub policy: Policy,
    pub window: Window,
    pub sheet: Sheet,
    pub attempts: Vec<Attempt>,
    pub reports: Vec<StoredReport>,
    pub hints: Vec<HintShown>,
}

impl Desk {
    pub fn new(text: &str, policy: Policy, member: u8) -> Self {
        let exercise = Exercise::draw(&problem(text), 0, 1).unwrap();
        let window = Window::of(&policy, None, ZONE);
        let sheet = Sheet {
            key: key(member),
            item: key(100),
            member: key(member),
            issue: 1,
            issued: exercise.issue(None, DecimalMark::Point),
            seen: policy.opens,
        };
        Self { exercise, policy, window, sheet, attempts: Vec::new(), reports: Vec::new(), hints: Vec::new() }
    }

    /// Hands in texts of the three parts.
    pub fn hand_in(&mut self, texts: [&str; 3], local: &str) -> Result<Accepted, Refusal> {
        self.hand_in_all(answers(texts), local)
    }

    /// Hands in texts of the three parts and the work beside them.
    pub fn hand_in_with_work(&mut self, texts: [&str; 3], work: &str, local: &str) -> Result<Accepted, Refusal> {
        let mut answers = answers(texts);
        answers.insert(WORK.to_owned(), work.to_owned());
        self.hand_in_all(answers, local)
    }

    fn hand_in_all(&mut self, answers: BTreeMap<String, String>, local: &str) -> Result<Accepted, Refusal> {
        let received = at(local);
        let hand_in = HandIn {
            exercise: &self.exercise,
            decimal: DecimalMark::Point,
            last: self.reports.last(),
            answers: &answers,
            hints: &self.hints,
            policy: &self.policy,
            window: &self.window,
            at: received,
        };
        let accepted = hand_in.take()?;
        self.attempts.push(Attempt {
            sheet: self.sheet.key,
            number: accepted.stored.history.handed_in(),
            received,
            answers,
            report: serde_json::value::to_raw_value(&accepted.stored).unwrap(),
            request: String::new(),
        });
        // What the next attempt is marked with went through storage.
        let kept = StoredReport::of(self.attempts.last().unwrap()).unwrap();
        assert_eq!(kept, accepted.stored);
        self.reports.push(kept);
        Ok(accepted)
    }

    pub fn show_hint(&mut self, part: Option<&str>, number: u32, local: &str) {
        let part = part.map(str::to_owned);
        self.hints.push(HintShown { sheet: self.sheet.key, part, number, at: at(local) });
    }

    pub fn worked(&self) -> WorkedSheet<'_> {
        WorkedSheet {
            sheet: &self.sheet,
            attempts: &self.attempts,
            hints: &self.hints,
            reports: &self.reports,
            window: self.window.clone(),
        }
    }
}

pub fn answers(texts: [&str; 3]) -> BTreeMap<String, String> {
    ["v_A2", "v_B2", "T_lost"].into_iter().zip(texts).map(|(id, text)| (id.to_owned(), text.to_owned())).collect()
}

/// The points and verdicts of a report.
pub fn found(report: &StoredReport) -> String {
    report.parts.iter().map(|part| format!("{} {}", part.points, part.verdict)).collect::<Vec<_>>().join(", ")
}
