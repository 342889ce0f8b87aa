//! What text of any kind is tried as, and what must hold of it. The tests run each target a bounded number of times; the crate in
//! `fuzz/` runs the same functions for hours under a fuzzer that looks for new paths through the program.

use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::http::{Request, Uri};
use momentous::bank::Bank;
use momentous::exercise::{Column, Exercise, Listed, Place, Student, Submission, Table};
use momentous::explain::Audience;
use momentous::explain::Detail;
use momentous::fault::{Faults, Source};
use momentous::grade::{DecimalMark, Verdict};
use momentous::problem::{Part, PartKind, compile, load};
use momentous::render::{Format, Page, Renderer, Solution};
use momentous::web::{App, Settings, router};
use tokio::runtime::{Builder, Runtime};
use tower::ServiceExt;

/// One kind of text that comes from outside.
pub struct Target {
    /// Its name.
    pub name: &'static str,
    /// Pieces of such texts, one on each line, where `⏎` is the end of a line and `␣` a space.
    pub pieces: &'static str,
    /// Tries a text; the number chooses what it is tried with.
    pub run: fn(u8, &str),
}

/// All of them.
pub const TARGETS: [Target; 6] = [
    Target { name: "problem_file", pieces: include_str!("files.txt"), run: problem_file },
    Target { name: "answer", pieces: include_str!("answers.txt"), run: answer },
    Target { name: "formula", pieces: include_str!("formulas.txt"), run: formula },
    Target { name: "table", pieces: TABLES, run: table },
    Target { name: "roster", pieces: TABLES, run: roster },
    Target { name: "route", pieces: include_str!("routes.txt"), run: route },
];

/// Pieces of tables and of lines of JSON.
const TABLES: &str = include_str!("tables.txt");

impl Target {
    /// The target with that name.
    pub fn named(name: &str) -> Self {
        TARGETS.into_iter().find(|target| target.name == name).expect("there is such a target")
    }

    /// Its pieces.
    pub fn pieces(&self) -> Vec<String> {
        self.pieces.lines().map(|line| line.replace('⏎', "\n").replace('␣', " ")).collect()
    }
}

fn within(faults: &Faults, length: usize) {
    assert!(!faults.list.is_empty() && !faults.to_string().is_empty());
    for fault in &faults.list {
        assert!(fault.span.is_none_or(|span| span.start <= span.end && span.end <= length), "{fault:?}");
    }
}

thread_local! {
    /// Slow to make; each thread has its own.
    static RENDERER: Renderer = Renderer::new(None).expect("the built-in templates are well formed");
}

/// A problem file loads, compiles, draws and is printed with its solution, or says what is wrong and where.
fn problem_file(chosen: u8, text: &str) {
    let loaded = match load(Source::new("fuzz.yaml", text)) {
        Ok(loaded) => loaded,
        Err(faults) => return within(&faults, text.len()),
    };
    let problem = match compile(loaded, None) {
        Ok(problem) => Arc::new(problem),
        Err(faults) => return within(&faults, text.len()),
    };
    let form = usize::from(chosen) % problem.forms().len().max(1);
    let Ok(exercise) = Exercise::draw(&problem, form, u64::from(chosen)) else { return };
    if let Err(faults) = exercise.printable() {
        return within(&faults, text.len());
    }
    let (audience, faded) = (Audience::Instructor, None);
    let detail = if chosen.is_multiple_of(2) { Detail::Short } else { Detail::Full };
    let solution =
        Solution { outline: exercise.outline(audience, detail), identity: exercise.identity(), audience, faded };
    let format = Format::ALL[usize::from(chosen) % Format::ALL.len()];
    let pages = [Page::Sheet(exercise.sheet()), Page::Solution(solution)];
    let printed = RENDERER.with(|renderer| renderer.render(&pages, format));
    assert!(printed.is_ok_and(|document| !document.text.is_empty()), "what is printable is printed:\n{text}");
}

/// One variant of every form of the bank.
static BANK: LazyLock<Vec<Exercise>> = LazyLock::new(|| {
    let mut exercises = Vec::new();
    for source in Bank::built_in().sources() {
        let problem = load(source.clone()).ok().and_then(|loaded| compile(loaded, None).ok()).map(Arc::new);
        let Some(problem) = problem else { continue };
        exercises.extend((0..problem.forms().len()).filter_map(|form| Exercise::draw(&problem, form, 1).ok()));
    }
    exercises
});

/// Its parts, each with its variant: those that ask for no formula, and those that do.
static PARTS: LazyLock<[Vec<(&Exercise, &Part)>; 2]> = LazyLock::new(|| {
    let parts = |exercise: &'static Exercise| exercise.worked().form.parts.iter().map(move |part| (exercise, part));
    BANK.iter().flat_map(parts).partition(|(_, part)| !matches!(part.kind, PartKind::Formula(_))).into()
});

/// Marks a text as the answer to one of these parts: it gets a verdict, and its marks lie between none and all.
fn mark(text: &str, chosen: u8, parts: &[(&Exercise, &Part)]) {
    let Some((exercise, part)) = parts.get(usize::from(chosen) * parts.len() / 256) else { return };
    for decimal in [DecimalMark::Point, DecimalMark::Comma] {
        let report = exercise.grade(&BTreeMap::from([(part.id.clone(), text.to_owned())]), decimal);
        let reported = report.parts.iter().find(|reported| reported.id == part.id).expect("every part is reported");
        let points = reported.points.0.to_f64().value();
        assert!((0.0..=f64::from(reported.out_of)).contains(&points), "{text:?}: {points} of {}", reported.out_of);
        assert!(reported.verdict != Verdict::Unreadable || !reported.message.is_empty(), "{text:?}");
    }
}

/// An answer that is no formula is marked, or it is said why it cannot be read.
fn answer(chosen: u8, text: &str) {
    mark(text, chosen, &PARTS[0]);
}

/// The same for a formula.
fn formula(chosen: u8, text: &str) {
    mark(text, chosen, &PARTS[1]);
}

/// Every row of a table of submissions is a submission, or is refused with a reason; the same for lines of JSON, and for a file of YAML.
fn table(_: u8, text: &str) {
    submissions(text);
    for (number, line) in (1..).zip(text.lines()) {
        submission(Submission::of_json(Place::Line(number), line), line);
    }
    submission(Submission::of_yaml(Place::Line(1), &Source::new("fuzz.yaml", text)), text);
}

fn submission(read: Result<Submission, String>, text: &str) {
    match read {
        Ok(submission) => assert!(submission.answers().count() <= text.len()),
        Err(reason) => assert!(!reason.is_empty(), "{text:?}"),
    }
}

fn submissions(text: &str) {
    let Ok(mut table) = Table::read(text.as_bytes()) else { return };
    let columns = Column::all(table.headings());
    let mut last = 1;
    while let Some((line, row)) = table.next_row() {
        assert!(line > last, "{text:?}: line {line} after line {last}");
        last = line;
        match (row.as_ref(), columns.as_ref()) {
            (Ok(row), Ok(columns)) => drop(Submission::of_row(Place::Line(line), columns, row.cells())),
            (Ok(_), Err(reason)) | (Err(reason), _) => assert!(!reason.is_empty(), "{text:?}"),
        }
    }
}

/// A roster, and a table of who has which sheet, is read, or every fault of it is said. Each student has a name and an identity that is
/// no other's.
fn roster(_: u8, text: &str) {
    let faults = |faults: Vec<String>| {
        assert!(!faults.is_empty() && faults.iter().all(|fault| !fault.is_empty()), "{text:?}");
    };
    let read = || Table::read(text.as_bytes());
    let Ok((students, sheets)) = read().and_then(|roster| Ok((Student::all(roster), Listed::read(read()?)))) else {
        return;
    };
    sheets.map_or_else(faults, drop);
    match students {
        Ok(students) => {
            let names: BTreeMap<&str, &str> =
                students.iter().map(|student| (student.id.as_str(), student.name.as_str())).collect();
            assert!(names.len() == students.len() && names.iter().all(|(id, name)| !id.is_empty() && !name.is_empty()));
        }
        Err(unread) => faults(unread),
    }
}

/// The application, and something to run it on.
static SERVER: LazyLock<(Runtime, Router)> = LazyLock::new(|| {
    let runtime = Builder::new_multi_thread().enable_all().build().expect("threads");
    let app = App::new(Settings::default()).expect("the built-in bank and templates are well formed");
    (runtime, router(Arc::new(app)))
});

/// More than any page has.
const LONGEST_PAGE: usize = 16 << 20;

/// A request, whose first line is its address and whose rest is its body, is answered: with a page, or with what the client did wrong.
/// No page holds a script that the request wrote.
fn route(chosen: u8, text: &str) {
    let (address, body) = text.split_once('\n').unwrap_or((text, ""));
    let graphic =
        |byte: u8| if byte.is_ascii_graphic() { char::from(byte).to_string() } else { format!("%{byte:02X}") };
    let address: String = address.bytes().map(graphic).collect();
    let Ok(uri) = format!("/{}", address.trim_start_matches('/')).parse::<Uri>() else { return };
    let (method, kind) = match chosen % 3 {
        0 => ("GET", "text/plain"),
        1 => ("POST", "application/x-www-form-urlencoded"),
        _ => ("POST", "application/json"),
    };
    let request = Request::builder().method(method).uri(uri).header("content-type", kind);
    let request = request.body(Body::from(body.to_owned())).expect("a request");
    let (runtime, router) = &*SERVER;
    let (status, page) = runtime.block_on(async {
        let response = router.clone().oneshot(request).await.expect("the router answers");
        let status = response.status().as_u16();
        (status, to_bytes(response.into_body(), LONGEST_PAGE).await.expect("the page is within its bound"))
    });
    assert!(matches!(status, 200 | 400 | 404 | 405 | 413 | 415 | 422), "{method} {address}: {status}");
    assert!(!String::from_utf8_lossy(&page).contains("<script>alert"), "{method} {address}");
}
