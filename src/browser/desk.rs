//! Requests of the page that runs without a server, and their answers.

use std::collections::BTreeMap;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use momentous_bank::Bank;
use momentous_exercise::calls::{Limits, Refused, RefusedKind};
use momentous_fault::Source;
use momentous_pages::{Beside, Library, Nothing, Pages, View};
use momentous_problem::Course;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

/// Addresses stand behind it in that of the file.
const BASE: &str = "#";

/// A request.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Request {
    /// Opens the desk with these problems; the files to which pages refer.
    Open { problems: Vec<File> },
    /// A page, as a server would answer its address and the fields of a form.
    Page { path: String, fields: Vec<(String, String)> },
    /// The small figure of a problem.
    Figure { problem: String },
    /// A call of the engine.
    Call { name: String, request: Box<RawValue> },
}

/// A problem file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    name: String,
    text: String,
    /// The settings of its course.
    #[serde(default)]
    course: Option<String>,
}

/// An answer.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Answer {
    /// Files to which pages refer, below an address.
    Assets { directory: String, files: Vec<Asset> },
    /// A page, or a picture.
    Text(String),
    /// The value of a call.
    Value(Box<RawValue>),
    /// Why there is no answer.
    Refused(Refused),
}

/// A file to which pages refer.
#[derive(Serialize)]
struct Asset {
    name: &'static str,
    kind: &'static str,
    base64: String,
}

/// The engine and its pages, once they are opened.
///
/// ```
/// use momentous_browser::Desk;
///
/// let mut desk = Desk::default();
/// let text = include_str!("../../problem_bank/impact/two-carts.yaml");
/// let problem = serde_json::json!({ "name": "impact/two-carts.yaml", "text": text });
/// let opened = desk.answer(serde_json::json!({ "open": { "problems": [problem] } }).to_string().as_bytes());
/// assert!(opened.contains("site.css"));
/// let page = desk.answer(br#"{ "page": { "path": "/practice/impact/two-carts", "fields": [["seed", "3"]] } }"#);
/// assert!(page.contains("Two carts"));
/// ```
#[derive(Default)]
pub struct Desk {
    pages: Option<Pages>,
}

impl Desk {
    /// Answers a request: JSON in, JSON out.
    pub fn answer(&mut self, request: &[u8]) -> String {
        let answered =
            serde_json::from_slice(request).map_err(|error| invalid(&error)).and_then(|request| self.answered(request));
        let answer = answered.unwrap_or_else(Answer::Refused);
        serde_json::to_string(&answer)
            .unwrap_or_else(|error| serde_json::json!({ "text": error.to_string() }).to_string())
    }

    fn answered(&mut self, request: Request) -> Result<Answer, Refused> {
        Ok(match request {
            Request::Open { problems } => {
                let pages = self.pages.insert(pages(&problems)?);
                let assets = pages.assets.all();
                let files = assets.map(|(name, kind, bytes)| Asset { name, kind, base64: STANDARD.encode(bytes) });
                Answer::Assets { directory: pages.directory(), files: files.collect() }
            }
            Request::Page { path, fields } => Answer::Text(self.view()?.answer(&path, fields)?),
            Request::Figure { problem } => Answer::Text(self.view()?.figure(&problem)?),
            Request::Call { name, request } => {
                let said = self.view()?.engine().call(&name, request.get().as_bytes())?;
                Answer::Value(RawValue::from_string(said).map_err(|error| invalid(&error))?)
            }
        })
    }

    fn view(&self) -> Result<View<'_>, Refused> {
        let Some(pages) = &self.pages else {
            return Err(Refused::new(RefusedKind::Invalid, "no problems were opened").help("send `open` first"));
        };
        Ok(View::new(pages, Beside::default(), &Nothing))
    }
}

fn pages(problems: &[File]) -> Result<Pages, Refused> {
    let mut courses = BTreeMap::new();
    for File { name, course, .. } in problems {
        if let Some(text) = course {
            let settings = Course::read(&Source::new("course.yaml", text)).map_err(|faults| Refused::fault(&faults))?;
            courses.insert(name.clone(), settings);
        }
    }
    let bank = Bank::of(problems.iter().map(|File { name, text, .. }| Source::new(name, text)).collect());
    let library = Library::of(bank).in_courses(courses);
    Pages::new(library, BASE, Limits::default(), None).map_err(|faults| Refused::fault(&faults))
}

fn invalid(error: &serde_json::Error) -> Refused {
    Refused::new(RefusedKind::Invalid, format!("the request cannot be read: {error}"))
}
