//! A class that hands in: one assignment that is open now, and students who have signed in.

use std::time::{SystemTime, UNIX_EPOCH};

use momentous::course::{
    Assignment, Course, Item, Key, Member, Moment, Person, Policy, Release, Role, Share, SolutionRelease, Solvers,
    Unsubmitted, Weights,
};
use momentous::course_pages::{Clock, invite};
use momentous::grade::DecimalMark;
use momentous::problem::CourseSymbols;
use momentous::store::{AssignmentWithItems, Entry, Store};

use super::client::Client;

const HOUR: i64 = 3_600_000;

/// A class that hands in.
pub struct Class {
    pub assignment: Assignment,
    /// The addresses of the items.
    pub items: Vec<String>,
    pub students: Vec<Student>,
}

/// A student of the class.
pub struct Student {
    pub member: Key<Member>,
    /// The path of the link that signs in.
    pub link: String,
}

impl Class {
    /// Keeps a course with so many students, whose assignment has these problems and forms. Any number of attempts is taken.
    pub async fn kept(store: &Store, students: u32, problems: &[(&str, &str)]) -> Self {
        let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let now = Moment::from_millis(i64::try_from(now.as_millis()).unwrap());
        let course = Course {
            key: key(0, 1),
            title: "Mechanics".into(),
            zone: "UTC".into(),
            decimal: DecimalMark::Point,
            secret: "a secret of the course".into(),
            retention_days: None,
            grading: momentous::course::Grading::default(),
            created: now,
        };
        let people: Vec<Person> = (0..=students).map(person).collect();
        let members: Vec<Member> = (0..=students).map(|number| member(&course, number)).collect();
        store.add_people(&people, &entry(1, now)).await.unwrap();
        store.add_course(&course, &members[0], &entry(2, now)).await.unwrap();
        store.save_members(&[], &members[1..], &entry(3, now)).await.unwrap();
        let assignment = Assignment {
            key: key(0, 2),
            course: course.key,
            title: "Sheet 1".into(),
            policy: policy(now),
            pinned: None,
        };
        let items: Vec<Item> =
            problems.iter().zip(0..).map(|(problem, place)| item(&assignment, *problem, place)).collect();
        let addresses = items.iter().map(|item| format!("/courses/{}/items/{}", course.key, item.key)).collect();
        let whole = AssignmentWithItems { assignment, items, revision: 0 };
        store.save_assignment(&whole, &entry(4, now)).await.unwrap();
        let mut signed = Vec::new();
        for member in &members[1..] {
            let login = &people[signed.len() + 1].login;
            let link = invite::link(store, login, &Clock::default()).await.unwrap().unwrap();
            signed.push(Student { member: member.key, link });
        }
        Self { assignment: whole.assignment, items: addresses, students: signed }
    }
}

impl Student {
    /// Signs in, and gives the cookie that says so.
    pub fn sign_in(&self, client: &mut Client) -> String {
        client.post(&self.link, "", &[]).unwrap().cookie.unwrap()
    }
}

fn key<Of>(kind: u8, number: u32) -> Key<Of> {
    let mut bytes = [kind; 16];
    bytes[..4].copy_from_slice(&number.to_be_bytes());
    Key::new(bytes)
}

fn person(number: u32) -> Person {
    let login = format!("s{number}");
    Person { key: key(1, number), name: login.clone(), login, operator: false, erased: None }
}

/// The first teaches the course.
fn member(course: &Course, number: u32) -> Member {
    let role = if number == 0 { Role::Instructor } else { Role::Student };
    let (key, person) = (key(2, number), key(1, number));
    Member { key, course: course.key, person, role, section: String::new(), left: None }
}

fn item(assignment: &Assignment, (problem, form): (&str, &str), position: u32) -> Item {
    Item {
        key: key(3, position),
        assignment: assignment.key,
        position,
        problem: problem.to_owned(),
        form: (!form.is_empty()).then(|| form.to_owned()),
        points: 5,
        weights: Weights::default(),
        repeat: 0,
        digest: None,
        letters: CourseSymbols::default(),
        issue: 0,
        dropped: false,
    }
}

fn policy(now: Moment) -> Policy {
    Policy {
        attempts: None,
        attempt_penalty: Share::default(),
        hint_penalty: Share::default(),
        further_penalty: Share::default(),
        opens: now.after(-HOUR),
        due: now.after(24 * HOUR),
        late_until: None,
        late_penalty: Share::default(),
        closes: now.after(24 * HOUR),
        verdicts: Release::AtOnce,
        solutions: SolutionRelease::AtClose,
        unsubmitted: Unsubmitted::Leave,
        solvers: Solvers::Shown,
    }
}

fn entry(number: u32, at: Moment) -> Entry {
    Entry { key: key(4, number), at, by: None, course: None, what: "made".into(), detail: String::new() }
}
