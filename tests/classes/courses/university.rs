//! A server with courses, and browsers that ask it.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicI64, Ordering};

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::http::{HeaderMap, Method, Request};
use momentous::course::{
    Assignment, Course, Item, Key, Member, Moment, Person, Policy, Release, Role, Share, SolutionRelease, Solvers,
    Unsubmitted, Weights,
};
use momentous::course_pages::{Clock, Courses, Post, invite};
use momentous::grade::DecimalMark;
use momentous::problem::CourseSymbols;
use momentous::store::{Address, AssignmentWithItems, Entry, Reach, Store, Ticket, TicketKind};
use momentous::web::{App, Settings, router};
use tempfile::TempDir;
use tokio::runtime::{Builder, Runtime};
use tower::ServiceExt;

/// When a test begins: 2025-12-01, 08:00 UTC.
pub const BEGIN: i64 = 1_764_576_000_000;
/// A day in milliseconds.
pub const DAY: i64 = 86_400_000;
/// So many milliseconds after the close what is released by it is shown.
pub const RELEASED: i64 = 60_001;
/// More than any response has.
const LONGEST: usize = 64 << 20;

/// A server with two courses. Ada and Bob are students of the first, Cleo of the second; Ann assists in the first, Ida teaches it, and
/// Olga runs the server.
pub struct University {
    runtime: Runtime,
    router: Router,
    pub store: Store,
    clock: Arc<AtomicI64>,
    pub course: Course,
    pub other: Course,
    _folder: TempDir,
}

/// A browser of one person.
pub struct Browser<'u> {
    university: &'u University,
    cookies: BTreeMap<String, String>,
    /// What a proxy says of who asks.
    pub from: Option<String>,
}

/// A response, read to its end.
pub struct Answer {
    pub status: u16,
    pub headers: HeaderMap,
    pub text: String,
}

impl University {
    pub fn new() -> Self {
        // Files are read on trial by the program, which the tests are not.
        let program = Some(env!("CARGO_BIN_EXE_momentous").into());
        Self::with(Settings { program, ..Settings::default() })
    }

    pub fn with(settings: Settings) -> Self {
        let university = Self::over(tempfile::tempdir().unwrap(), settings);
        university.fill();
        university
    }

    /// A server that sends letters.
    pub fn with_post(post: Post) -> Self {
        let university = Self::set_up(tempfile::tempdir().unwrap(), Settings::default(), Some(post));
        university.fill();
        university
    }

    /// A server over what is in the folder `data` of a folder.
    pub fn over(folder: TempDir, settings: Settings) -> Self {
        Self::set_up(folder, settings, None)
    }

    fn set_up(folder: TempDir, settings: Settings, post: Option<Post>) -> Self {
        let runtime = Builder::new_multi_thread().enable_all().build().unwrap();
        let clock = Arc::new(AtomicI64::new(BEGIN));
        let read = Arc::clone(&clock);
        let store = runtime.block_on(Store::serve(&Address::Folder(folder.path().join("data")))).unwrap();
        let clock_of_server = Clock::new(move || Moment::from_millis(read.load(Ordering::SeqCst)));
        let courses = Courses::new(store.clone(), clock_of_server).with_post(post);
        let app = App::new(settings).unwrap().with_companion(Arc::new(courses));
        let [course, other] = [("Mechanics <1>", 1), ("Mechanics 2", 2)].map(|(title, number)| Course {
            key: Key::new([number; 16]),
            title: title.to_owned(),
            zone: "Europe/Berlin".to_owned(),
            decimal: DecimalMark::Either,
            secret: format!("a secret of course {number}"),
            retention_days: None,
            grading: momentous::course::Grading::default(),
            created: Moment::from_millis(BEGIN),
        });
        let router = router(Arc::new(app));
        Self { runtime, router, store, clock, course, other, _folder: folder }
    }

    fn fill(&self) {
        let people = ["ada", "bob", "cleo", "ann", "ida", "olga"];
        let person = |login: &str| Person {
            key: Self::key(login),
            login: login.to_owned(),
            name: format!("{login} <script>"),
            operator: login == "olga",
            erased: None,
        };
        let people: Vec<Person> = people.into_iter().map(person).collect();
        let member = |course: &Course, login: &str, role| Member {
            key: Self::member(login),
            course: course.key,
            person: Self::key(login),
            role,
            section: "A".to_owned(),
            left: None,
        };
        let members = [
            member(&self.course, "ada", Role::Student),
            member(&self.course, "bob", Role::Student),
            member(&self.course, "ann", Role::Assistant),
        ];
        self.wait(async |store| {
            store.add_people(&people, &Self::entry(1)).await.unwrap();
            store
                .add_course(&self.course, &member(&self.course, "ida", Role::Instructor), &Self::entry(2))
                .await
                .unwrap();
            store.add_course(&self.other, &member(&self.other, "cleo", Role::Student), &Self::entry(3)).await.unwrap();
            store.save_members(&[], &members, &Self::entry(4)).await.unwrap();
        });
    }

    /// The key of a person of that name.
    pub fn key(login: &str) -> Key<Person> {
        Key::new(bytes("person", login))
    }

    /// The key of that person's place in its course.
    pub fn member(login: &str) -> Key<Member> {
        Key::new(bytes("member", login))
    }

    pub fn entry(number: u8) -> Entry {
        let key = Key::new([number; 16]);
        Entry {
            key,
            at: Moment::from_millis(BEGIN),
            by: None,
            course: None,
            what: "tried".into(),
            detail: String::new(),
        }
    }

    /// Does something with the records.
    pub fn wait<T>(&self, work: impl AsyncFnOnce(&Store) -> T) -> T {
        self.runtime.block_on(work(&self.store))
    }

    /// An assignment of the first course that is open from the beginning: due after one day, late for another, closed after three.
    pub fn assignment(&self, problems: &[(&str, &str, u32)], change: impl FnOnce(&mut Policy)) -> AssignmentWithItems {
        let mut policy = Policy {
            attempts: Some(3),
            attempt_penalty: "10 %".parse::<Share>().unwrap(),
            hint_penalty: "10 %".parse::<Share>().unwrap(),
            further_penalty: Share::default(),
            opens: Moment::from_millis(BEGIN),
            due: Moment::from_millis(BEGIN + DAY),
            late_until: Some(Moment::from_millis(BEGIN + 2 * DAY)),
            late_penalty: "20 %".parse::<Share>().unwrap(),
            closes: Moment::from_millis(BEGIN + 3 * DAY),
            verdicts: Release::AtOnce,
            solutions: SolutionRelease::AtClose,
            unsubmitted: Unsubmitted::Leave,
            solvers: Solvers::Shown,
        };
        change(&mut policy);
        let title = "Sheet <b>1</b>".to_owned();
        let assignment = Assignment { key: Key::new([9; 16]), course: self.course.key, title, policy, pinned: None };
        let items = problems.iter().zip(0..).map(|((problem, form, points), position)| Item {
            key: Key::new([10 + u8::try_from(position).unwrap(); 16]),
            assignment: assignment.key,
            position,
            problem: (*problem).to_owned(),
            form: (!form.is_empty()).then(|| (*form).to_owned()),
            points: *points,
            weights: Weights::default(),
            repeat: 0,
            digest: None,
            letters: CourseSymbols::default(),
            issue: 0,
            dropped: false,
        });
        let whole = AssignmentWithItems { items: items.collect(), assignment, revision: 0 };
        self.wait(async |store| store.save_assignment(&whole, &Self::entry(8)).await.unwrap());
        whole
    }

    /// Sets the clock so many milliseconds after the beginning.
    pub fn set_clock(&self, millis: i64) {
        self.clock.store(BEGIN + millis, Ordering::SeqCst);
    }

    /// A browser in which nobody has signed in.
    pub fn browser(&self) -> Browser<'_> {
        Browser { university: self, cookies: BTreeMap::new(), from: None }
    }

    /// A browser in which somebody has signed in by a link.
    pub fn browser_of(&self, login: &str) -> Browser<'_> {
        let mut browser = self.browser();
        let link = self.link(login);
        assert_eq!(browser.post(&link, &[]).status, 303, "{login} signs in");
        browser
    }

    /// A browser with a session that reaches so far.
    pub fn browser_reaching(&self, login: &str, reach: Reach) -> Browser<'_> {
        // As `sha256sum` writes it of the cookie's value.
        let hash = "3c469e9d6c5875d37a43f353d4f88e61fcf812c66eee3457465a40b0da4153e0".to_owned();
        let expires = Moment::from_millis(BEGIN + DAY);
        let ticket = Ticket { hash, person: Self::key(login), kind: TicketKind::Session, reach, expires };
        self.wait(async |store| store.add_tickets(vec![ticket], Moment::from_millis(BEGIN), &[]).await.unwrap());
        let cookies = [("momentous-session".to_owned(), "token".to_owned())].into();
        Browser { cookies, ..self.browser() }
    }

    /// What so many browsers that ask at the same time get.
    pub fn at_once<T: Send>(&self, browsers: usize, ask: impl Fn(&mut Browser<'_>) -> T + Sync) -> Vec<T> {
        std::thread::scope(|scope| {
            let started: Vec<_> = (0..browsers).map(|_| scope.spawn(|| ask(&mut self.browser()))).collect();
            started.into_iter().map(|thread| thread.join().unwrap()).collect()
        })
    }

    /// The path of a new link for somebody.
    pub fn link(&self, login: &str) -> String {
        self.wait(async |store| invite::link(store, login, &self.clock()).await).unwrap().unwrap()
    }

    fn clock(&self) -> Clock {
        let read = Arc::clone(&self.clock);
        Clock::new(move || Moment::from_millis(read.load(Ordering::SeqCst)))
    }

    /// An address of the first course.
    pub fn address(&self, path: &str) -> String {
        format!("/courses/{}{path}", self.course.key)
    }
}

/// Bytes that differ from name to name.
fn bytes(kind: &str, name: &str) -> [u8; 16] {
    let mut bytes = [0; 16];
    for (place, byte) in bytes.iter_mut().zip(kind.bytes().chain(name.bytes())) {
        *place = byte;
    }
    bytes
}

impl Browser<'_> {
    pub fn get(&mut self, address: &str) -> Answer {
        self.ask(Method::GET, address, None, Some("http://localhost"))
    }

    /// A form, as a browser sends it from a page of the server.
    pub fn post(&mut self, address: &str, fields: &[(&str, &str)]) -> Answer {
        self.post_from(Some("http://localhost"), address, fields)
    }

    /// The same from a page of this origin.
    pub fn post_from(&mut self, origin: Option<&str>, address: &str, fields: &[(&str, &str)]) -> Answer {
        self.ask(Method::POST, address, Some(encoded(fields)), origin)
    }

    pub fn ask(&mut self, method: Method, address: &str, body: Option<String>, origin: Option<&str>) -> Answer {
        let mut request = Request::builder().method(method).uri(address).header("host", "localhost");
        for (name, token) in &self.cookies {
            request = request.header("cookie", format!("{name}={token}"));
        }
        if let Some(origin) = origin {
            request = request.header("origin", origin);
        }
        if let Some(from) = &self.from {
            request = request.header("x-forwarded-for", from);
        }
        if body.is_some() {
            request = request.header("content-type", "application/x-www-form-urlencoded");
        }
        let request = request.body(body.map_or_else(Body::empty, Body::from)).unwrap();
        let answer = self.university.runtime.block_on(async {
            let response = self.university.router.clone().oneshot(request).await.unwrap();
            let (parts, body) = response.into_parts();
            let bytes = to_bytes(body, LONGEST).await.unwrap().to_vec();
            let text = String::from_utf8_lossy(&bytes).into_owned();
            Answer { status: parts.status.as_u16(), headers: parts.headers, text }
        });
        if let Some(cookie) = answer.header("set-cookie") {
            let (name, token) = cookie.split(';').next().unwrap().split_once('=').unwrap();
            self.cookies.insert(name.to_owned(), token.to_owned());
        }
        answer
    }
}

impl Answer {
    pub fn header(&self, name: &str) -> Option<&str> {
        self.headers.get(name).map(|value| value.to_str().unwrap())
    }

    /// The text of a page that has this status.
    #[track_caller]
    pub fn text(self, status: u16) -> String {
        assert_eq!(self.status, status, "{}", self.text);
        self.text
    }

    /// Where a browser is sent.
    #[track_caller]
    pub fn to(&self) -> &str {
        assert_eq!(self.status, 303, "{}", self.text);
        self.header("location").unwrap()
    }
}

/// Fields as a browser encodes them.
pub fn encoded(fields: &[(&str, &str)]) -> String {
    let escaped = |text: &str| {
        text.bytes().fold(String::new(), |all, byte| {
            if byte.is_ascii_alphanumeric() {
                all + &char::from(byte).to_string()
            } else {
                all + &format!("%{byte:02X}")
            }
        })
    };
    fields.iter().map(|(name, value)| format!("{}={}", escaped(name), escaped(value))).collect::<Vec<_>>().join("&")
}
