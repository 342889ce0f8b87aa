//! A class in which somebody has handed something in.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::course::{Item, Moment, Policy, ProblemFile};
use momentous::fault::Source;
use momentous::problem::{compile, load};
use momentous::store::AssignmentWithItems;

use super::university::{BEGIN, DAY, University};

/// The problem that is handed in.
pub const CARTS: &str = "impact/two-carts";

/// The text of the problem in the bank.
pub fn text() -> String {
    Bank::built_in().find(CARTS).unwrap().text.to_string()
}

/// The right answers of a student who has seen the first item, as they are printed.
pub fn right(university: &University, login: &str) -> BTreeMap<String, String> {
    let sheets = university.wait(async |store| store.sheets_of(University::member(login)).await).unwrap();
    let source = Bank::built_in().find(CARTS).unwrap().clone();
    let problem = compile(load(source).unwrap(), Some(university.course.secret.as_bytes())).unwrap();
    let exercise = sheets[0].issued.draw(&Arc::new(problem)).unwrap();
    exercise.worked().form.parts.iter().map(|part| (part.id.clone(), exercise.printed(part))).collect()
}

/// A class in which Ada has handed in what is right at the first part, which is 2 of 5 points of a sheet worth 10, and nonsense at the
/// second; Bob has not opened anything.
pub struct Handed {
    pub university: University,
    pub whole: AssignmentWithItems,
}

impl Handed {
    pub fn new() -> Self {
        Self::with(|_| {})
    }

    pub fn with(change: impl FnOnce(&mut Policy)) -> Self {
        let university = University::new();
        let whole = university.assignment(&[(CARTS, "forward", 10)], change);
        let handed = Self { university, whole };
        let mut ada = handed.university.browser_of("ada");
        let address = handed.item("");
        ada.get(&address).text(200);
        let answers = right(&handed.university, "ada");
        handed.university.set_clock(DAY / 2);
        let fields = [("request", "1"), ("answer.v_A2", answers["v_A2"].as_str()), ("answer.v_B2", "ask 555-0199 <b>")];
        ada.post(&address, &fields).to();
        handed
    }

    /// An address below the first item.
    pub fn item(&self, path: &str) -> String {
        self.university.address(&format!("/items/{}{path}", self.whole.items[0].key))
    }

    /// Below the page of Ada's answers.
    pub fn answers(&self, path: &str) -> String {
        self.item(&format!("/students/{}{path}", University::member("ada")))
    }

    /// An address below the assignment.
    pub fn assignment(&self, path: &str) -> String {
        self.university.address(&format!("/assignments/{}{path}", self.whole.assignment.key))
    }

    /// Ada's row of the table.
    pub fn row(&self) -> String {
        let table = self.university.browser_of("ida").get(&self.assignment("/gradebook.csv")).text(200);
        table.lines().find(|line| line.starts_with("ada,")).unwrap().to_owned()
    }

    /// Publishes another file of the problem in the course.
    pub fn publish(&self, text: &str) {
        let source = Source::new(CARTS, text);
        let file = ProblemFile {
            digest: load(source).unwrap().digest,
            problem: CARTS.to_owned(),
            text: text.to_owned(),
            course: Some(self.university.course.key),
            published: Some(Moment::from_millis(BEGIN + DAY)),
            saved: Moment::from_millis(BEGIN + DAY),
        };
        self.university.wait(async |store| store.save_problem_file(&file, None).await).unwrap();
    }

    /// The fields of the form to take the published file in.
    pub fn choice<'a>(page: &'a str, choice: &'a str) -> [(&'a str, &'a str); 5] {
        let value = |name: &str| {
            let (_, rest) = page.split_once(&format!("name=\"{name}\" value=\"")).unwrap();
            rest.split('"').next().unwrap()
        };
        [
            ("revision", value("revision")),
            ("item", value("item")),
            ("digest", value("digest")),
            ("choice", choice),
            ("reason", "a wrong unit"),
        ]
    }

    pub fn kept(&self) -> Item {
        let key = self.whole.assignment.key;
        let whole = self.university.wait(async |store| store.assignment(key).await).unwrap().unwrap();
        whole.items[0].clone()
    }
}
