//! Every write of the store, each as it is tried. A method that writes and has no row here fails the suite.

use std::collections::BTreeMap;
use std::fs;
use std::pin::Pin;

use momentous::course::{
    Asker, Attempt, Code, Correction, CorrectionChoice, CourseCode, Draft, HintShown, Item, Key, MailAddress, Member,
    Moment, Override, OverrideRule, Person, PlaceRequest, ProblemFile, Role, Sheet,
};
use momentous::store::{HandIn, HandedIn, MailedLink, Rate, Reach, Regrade, Store, StoreFault, Ticket, TicketKind};

use super::super::NOW;
use super::super::sample::Sample;

/// Whether a write said that it was done.
pub type Doing<'a> = Pin<Box<dyn Future<Output = Result<bool, StoreFault>> + Send + 'a>>;

/// What the writes are tried on: a course in which something was handed in already.
pub struct Tried {
    pub own: Sample,
    /// The revision of the assignment.
    revision: i64,
}

/// A write of the store.
pub struct Write {
    /// The method.
    pub name: &'static str,
    /// The same each time, under the same keys.
    pub run: for<'a> fn(&'a Store, &'a Tried) -> Doing<'a>,
}

macro_rules! writes {
    ($($name:ident: |$store:ident, $tried:ident| $run:expr;)+) => {
        /// Every write.
        pub const WRITES: &[Write] =
            &[$(Write { name: stringify!($name), run: |$store, $tried| Box::pin(async move { $run }) }),+];
    };
}

writes! {
    add_people: |store, tried| done(store.add_people(&[another()], &tried.own.entry(100)).await);
    save_person: |store, tried| {
        let person = Person { name: "Ada Lovelace".into(), ..tried.own.student.clone() };
        done(store.save_person(&person, &tried.own.entry(101)).await)
    };
    erase_person: |store, tried| {
        let erased = Person { login: String::new(), erased: Some(NOW), ..tried.own.student.clone() };
        done(store.erase_person(&erased, &[tried.own.entry(102)]).await)
    };
    set_password: |store, tried| {
        done(store.set_password(tried.own.student.key, "other".into(), Some(ticket(&tried.own, "next")), &[tried.own.entry(103)]).await)
    };
    add_course: |store, tried| {
        let course = momentous::course::Course { key: Key::new([104; 16]), ..tried.own.course.clone() };
        let first = Member { key: Key::new([105; 16]), course: course.key, role: Role::Instructor, ..tried.own.member.clone() };
        done(store.add_course(&course, &first, &tried.own.entry(104)).await)
    };
    save_course: |store, tried| {
        let course = momentous::course::Course { title: "Dynamics".into(), ..tried.own.course.clone() };
        done(store.save_course(&course, &tried.own.entry(106)).await)
    };
    save_members: |store, tried| {
        let member = Member { key: Key::new([107; 16]), person: another().key, ..tried.own.member.clone() };
        done(store.save_members(&[another()], &[member], &tried.own.entry(107)).await)
    };
    save_code: |store, tried| done(store.save_code(&code(&tried.own, 2), &tried.own.entry(126)).await);
    end_code: |store, tried| done(store.end_code(tried.own.course.key, &tried.own.entry(127)).await);
    ask_for_place: |store, tried| done(store.ask_for_place(&request(&tried.own, 128)).await);
    settle_requests: |store, tried| {
        let people = [(another(), "hash".to_owned())];
        let member = Member { key: Key::new([129; 16]), person: another().key, ..tried.own.member.clone() };
        store.settle_requests(&[request(&tried.own, 124).key], &people, &[member], &tried.own.entry(129)).await
    };
    save_problem_file: |store, tried| {
        let file = ProblemFile { digest: "other".into(), ..file(&tried.own) };
        done(store.save_problem_file(&file, None).await)
    };
    save_assignment: |store, tried| {
        let mut whole = tried.own.whole.clone();
        whole.revision = tried.revision;
        whole.assignment.title = "Sheet 2".into();
        store.save_assignment(&whole, &tried.own.entry(108)).await
    };
    save_items: |store, tried| {
        let item = Item { dropped: true, ..tried.own.whole.items[0].clone() };
        done(store.save_items(&[item], &tried.own.entry(109)).await)
    };
    extend: |store, tried| done(store.extend(&[(tried.own.extension(NOW.after(9000)), tried.own.entry(110))]).await);
    add_sheets: |store, tried| {
        let sheet = |key, issue| Sheet { key: Key::new([key; 16]), issue, ..tried.own.sheet.clone() };
        done(store.add_sheets(&[sheet(111, 1), sheet(112, 2)]).await)
    };
    hand_in: |store, tried| {
        let attempt = tried.own.attempt(2, "second");
        let (assignment, revision) = (tried.own.whole.assignment.key, tried.revision);
        let handed_in = store.hand_in(HandIn { attempt: &attempt, assignment, revision }).await?;
        Ok(!matches!(handed_in, HandedIn::Stale))
    };
    redact: |store, tried| {
        let attempt = Attempt { answers: BTreeMap::new(), ..tried.own.attempt(1, "first") };
        done(store.redact(&[attempt], &tried.own.entry(113)).await)
    };
    show_hint: |store, tried| done(store.show_hint(&hint(&tried.own, 2)).await);
    save_draft: |store, tried| done(store.save_draft(&draft(tried.own.sheet.key, "2")).await);
    set_points: |store, tried| {
        done(store.set_points(Key::new([114; 16]), &points(&tried.own), &tried.own.entry(114)).await)
    };
    regrade: |store, tried| {
        let item = Item { digest: Some("b".into()), ..tried.own.whole.items[0].clone() };
        let choice = CorrectionChoice::Remark;
        let correction = Correction {
            item: item.key,
            from: "a".into(),
            to: "b".into(),
            choice,
            never_lower: true,
            reason: "r".into(),
            comment: String::new(),
            at: NOW,
        };
        let attempts = [tried.own.attempt(1, "first")];
        let kept = [(Key::new([119; 16]), points(&tried.own))];
        let step = Regrade { item: &item, correction: &correction, attempts: &attempts, kept: &kept, revision: tried.revision, handed_in: 1 };
        store.regrade(Key::new([115; 16]), &step, &tried.own.entry(115)).await
    };
    forget_answers: |store, tried| done(store.forget_answers(tried.own.course.key, &tried.own.entry(116)).await);
    add_tickets: |store, tried| {
        let tickets = vec![ticket(&tried.own, "one"), ticket(&tried.own, "other")];
        done(store.add_tickets(tickets, NOW, &[tried.own.entry(117)]).await)
    };
    set_mail_address: |store, tried| {
        let entries = [tried.own.entry(131)];
        done(store.set_mail_address(tried.own.student.key, Some(&address("new")), &entries).await)
    };
    add_mailed_links: |store, tried| {
        let links = vec![mailed(&tried.own, "one"), mailed(&tried.own, "other")];
        done(store.add_mailed_links(links, NOW).await)
    };
    take_mailed_link: |store, tried| {
        let entries = [tried.own.entry(132)];
        store.take_mailed_link("mailed", &address("ada"), ticket(&tried.own, "by mail"), &entries).await
    };
    allow: |store, _tried| store.allow("a hash", Rate { at_once: 1, interval: 1 }, NOW).await;
    take_ticket: |store, tried| store.take_ticket("link", Some(ticket(&tried.own, "session")), &[tried.own.entry(118)]).await;
}

impl Tried {
    /// Keeps what the writes are tried on: something in every table that one of them changes.
    pub async fn kept(store: &Store) -> Self {
        let sample = Sample::kept(store).await;
        let (attempt, revision) = (sample.attempt(1, "first"), sample.revision(store).await);
        store.set_password(sample.student.key, "hash".into(), None, &[sample.entry(120)]).await.unwrap();
        store.save_problem_file(&file(&sample), None).await.unwrap();
        store.hand_in(HandIn { attempt: &attempt, assignment: sample.whole.assignment.key, revision }).await.unwrap();
        store.show_hint(&hint(&sample, 1)).await.unwrap();
        store.save_draft(&draft(sample.sheet.key, "1")).await.unwrap();
        store.set_points(Key::new([121; 16]), &points(&sample), &sample.entry(121)).await.unwrap();
        store.add_tickets(vec![ticket(&sample, "link")], NOW, &[]).await.unwrap();
        store.set_mail_address(sample.student.key, Some(&address("ada")), &[]).await.unwrap();
        store.add_mailed_links(vec![mailed(&sample, "mailed")], NOW).await.unwrap();
        store.save_code(&code(&sample, 1), &sample.entry(122)).await.unwrap();
        store.ask_for_place(&request(&sample, 124)).await.unwrap();
        Self { own: sample, revision }
    }
}

fn done(told: Result<(), StoreFault>) -> Result<bool, StoreFault> {
    told.map(|()| true)
}

fn another() -> Person {
    Person { key: Key::new([130; 16]), login: "s18".into(), name: "Bo".into(), operator: false, erased: None }
}

fn code(sample: &Sample, number: u8) -> CourseCode {
    CourseCode { course: sample.course.key, code: Code::drawn([number; 8]), expires: NOW.after(1000) }
}

fn request(sample: &Sample, number: u8) -> PlaceRequest {
    let asker = Asker::New { login: "s19".into(), name: "Cy".into(), password: "hash".into() };
    PlaceRequest { key: Key::new([number; 16]), course: sample.course.key, asker, at: NOW }
}

fn file(sample: &Sample) -> ProblemFile {
    let (digest, problem, course) = ("d".into(), "impact/own".into(), Some(sample.course.key));
    ProblemFile { digest, problem, text: "title: Own\n".repeat(50), course, published: None, saved: NOW }
}

fn hint(sample: &Sample, number: u32) -> HintShown {
    HintShown { sheet: sample.sheet.key, part: None, number, at: NOW }
}

/// What was typed on a sheet.
pub fn draft(sheet: Key<Sheet>, text: &str) -> Draft {
    let answers = BTreeMap::from([("v_A2".to_owned(), text.to_owned())]);
    Draft { sheet, answers, saved: NOW, settled: None }
}

fn points(sample: &Sample) -> Override {
    Override {
        sheet: sample.sheet.key,
        points: Some("1/3".into()),
        rule: OverrideRule::AtLeast,
        reason: "r".into(),
        comment: String::new(),
        by: sample.student.key,
        at: NOW,
    }
}

fn ticket(sample: &Sample, hash: &str) -> Ticket {
    let expires = Moment::from_millis(NOW.millis() + 1000);
    Ticket { hash: hash.into(), person: sample.student.key, kind: TicketKind::Session, reach: Reach::All, expires }
}

fn address(name: &str) -> MailAddress {
    MailAddress::read(&format!("{name}@example.edu")).unwrap()
}

fn mailed(sample: &Sample, hash: &str) -> MailedLink {
    MailedLink { hash: hash.into(), person: sample.student.key, address: address("ada"), expires: NOW.after(1000) }
}

/// The public methods in the sources of the store that call the writer.
fn written() -> Vec<String> {
    let mut methods = Vec::new();
    for file in fs::read_dir("src/store").unwrap() {
        let path = file.unwrap().path();
        let Ok(text) = fs::read_to_string(&path) else { continue };
        for method in text.split("pub async fn ").skip(1) {
            let name = method.split(['(', '<']).next().unwrap();
            if method.contains("self.write(") || method.contains("self.write_if(") {
                methods.push(name.to_owned());
            }
        }
    }
    methods.sort();
    methods
}

#[test]
fn every_write_of_the_store_is_swept() {
    let mut swept: Vec<_> = WRITES.iter().map(|write| write.name.to_owned()).collect();
    swept.sort();
    assert_eq!(written(), swept, "a method of the store that writes needs a row in {}", file!());
}
