//! A course with one student and one sheet.

use momentous::course::{
    Assignment, Course, Extension, Item, Key, Member, Moment, Override, OverrideRule, Person, Policy, Release, Role,
    Share, Sheet, SolutionRelease, Solvers, Unsubmitted, Weights,
};
use momentous::grade::DecimalMark;
use momentous::problem::CourseSymbols;
use momentous::store::{AssignmentWithItems, Entry, Store};

use super::NOW;

/// A course with one student and one sheet.
pub struct Sample {
    pub course: Course,
    pub student: Person,
    pub member: Member,
    pub whole: AssignmentWithItems,
    pub sheet: Sheet,
}

impl Sample {
    /// Makes the course and keeps it.
    pub async fn kept(store: &Store) -> Self {
        let sample = Self::new();
        store
            .add_people(std::slice::from_ref(&sample.student), &Entry { course: None, ..sample.entry(40) })
            .await
            .unwrap();
        store.add_course(&sample.course, &sample.member, &sample.entry(41)).await.unwrap();
        store.save_assignment(&sample.whole, &sample.entry(42)).await.unwrap();
        for _ in 0..2 {
            // A page that is loaded twice at once draws one sheet.
            store.add_sheet(&sample.sheet).await.unwrap();
        }
        sample
    }

    fn new() -> Self {
        let student = Person {
            key: Key::new([1; 16]),
            login: "s17".into(),
            name: "Ada O'Neill \u{1F30D}".into(),
            operator: false,
            erased: None,
        };
        let course = Course {
            key: Key::new([2; 16]),
            title: "Mechanics <1>".into(),
            zone: "Europe/Berlin".into(),
            decimal: DecimalMark::Comma,
            secret: "a secret of the course".into(),
            retention_days: Some(365),
            grading: momentous::course::Grading::default(),
            created: NOW,
        };
        let member = Member {
            key: Key::new([3; 16]),
            course: course.key,
            person: student.key,
            role: Role::Student,
            section: "A".into(),
            left: None,
        };
        let assignment = Assignment {
            key: Key::new([4; 16]),
            course: course.key,
            title: "Sheet 1".into(),
            policy: policy(),
            pinned: None,
        };
        let item = Item {
            key: Key::new([6; 16]),
            assignment: assignment.key,
            position: 0,
            problem: "impact/two-carts".into(),
            form: Some("forward".into()),
            points: 5,
            weights: Weights::default(),
            repeat: 0,
            digest: None,
            letters: CourseSymbols::default(),
            issue: 0,
            dropped: false,
        };
        let sheet = Self::sheet(item.key, member.key);
        let whole = AssignmentWithItems { assignment, items: vec![item], revision: 0 };
        Self { course, student, member, whole, sheet }
    }

    pub fn entry(&self, key: u8) -> Entry {
        let key = Key::new([key; 16]);
        Entry { key, at: NOW, by: None, course: Some(self.course.key), what: "tried".into(), detail: String::new() }
    }

    /// Points that somebody set at the sheet.
    pub fn set(&self, points: Option<&str>, rule: OverrideRule) -> Override {
        let (sheet, by) = (self.sheet.key, self.student.key);
        let (points, reason, comment) = (points.map(str::to_owned), "viva".into(), "well said".into());
        Override { sheet, points, rule, reason, comment, by, at: NOW }
    }

    pub async fn revision(&self, store: &Store) -> i64 {
        store.assignment(self.whole.assignment.key).await.unwrap().unwrap().revision
    }

    pub fn extension(&self, closes: Moment) -> Extension {
        let assignment = self.whole.assignment.key;
        Extension { assignment, member: self.member.key, due: NOW, late_until: None, closes, reason: "was ill".into() }
    }
}

fn policy() -> Policy {
    Policy {
        attempts: Some(3),
        attempt_penalty: "10 %".parse::<Share>().unwrap(),
        hint_penalty: Share::default(),
        further_penalty: Share::default(),
        opens: NOW,
        due: NOW.after(1000),
        late_until: Some(NOW.after(2000)),
        late_penalty: Share::default(),
        closes: NOW.after(3000),
        verdicts: Release::AtOnce,
        solutions: SolutionRelease::AtClose,
        unsubmitted: Unsubmitted::Leave,
        solvers: Solvers::Shown,
    }
}
