//! Marks as the report of a test run (JUnit XML), for the page of a CI job: a suite for each problem, a case for each answer.
//!
//! The format wants each suite in one piece, with its numbers before it, and the marks come in the order of the class. So cases
//! wait in a file of their own until the numbers are known.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

use quick_xml::Writer;
use quick_xml::events::{BytesEnd, BytesStart, Event};

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::exercise::Key;
use crate::exercise::Place;
use crate::exercise::Submission;
use crate::exercise::VariantRef;
use crate::export::printable;
use crate::grade::PartReport;
use crate::render::SeedWord;

use super::spool::{Spool, WaitingText};

/// The suite of what could not be marked.
const REFUSED: &str = "submissions that cannot be used";

/// The report on its way.
pub(super) struct Junit {
    output: Output,
    spool: Spool,
    suites: BTreeMap<String, Suite>,
}

/// The cases of a problem.
#[derive(Default)]
struct Suite {
    kept: WaitingText,
    counts: Counts,
}

#[derive(Clone, Copy, Default)]
struct Counts {
    tests: u64,
    failures: u64,
    errors: u64,
}

/// A case that is no success: its element, the kind and what is said of it.
struct Trouble<'a> {
    element: &'static str,
    kind: Option<&'static str>,
    message: &'a str,
}

impl Junit {
    pub(super) fn to(path: &Path) -> Result<Self, Failure> {
        let spool = Spool::beside(path).map_err(|error| Failure::file(path, "written", &error))?;
        Ok(Self { output: Output::to(Some(path))?, spool, suites: BTreeMap::new() })
    }

    /// Adds what was found about one part: right is a success, unreadable an error, anything else a failure.
    pub(super) fn part(
        &mut self,
        submission: &Submission,
        variant: VariantRef<'_>,
        part: &PartReport,
    ) -> Result<(), Failure> {
        let element = if part.is_unread() { "error" } else { "failure" };
        let trouble = Trouble { element, kind: Some(part.verdict.code()), message: &part.message };
        let student = submission.key(Key::Student);
        let who = if student.is_empty() { format!("line {}", submission.place) } else { student.to_owned() };
        let name = format!("{who}, seed {}: {}", SeedWord(variant.seed), part.id);
        self.case(variant.problem, &name, (!part.verdict.is_right()).then_some(trouble))
    }

    /// Adds a submission that could not be used.
    pub(super) fn refused(&mut self, place: &Place, message: &str) -> Result<(), Failure> {
        self.case(REFUSED, &format!("line {place}"), Some(Trouble { element: "error", kind: None, message }))
    }

    fn case(&mut self, suite: &str, name: &str, trouble: Option<Trouble<'_>>) -> Result<(), Failure> {
        if !self.suites.contains_key(suite) {
            self.suites.insert(suite.to_owned(), Suite::default());
        }
        let Some(open_suite) = self.suites.get_mut(suite) else { return Ok(()) };
        open_suite.counts.tests += 1;
        let (name, suite) = (printable(name), printable(suite));
        let start = BytesStart::new("testcase").with_attributes([("name", &*name), ("classname", &*suite)]);
        let mut xml = Writer::new(&mut open_suite.kept.waiting);
        match trouble {
            None => xml.write_event(Event::Empty(start))?,
            Some(trouble) => {
                match trouble.element {
                    "error" => open_suite.counts.errors += 1,
                    _ => open_suite.counts.failures += 1,
                }
                let message = printable(trouble.message);
                let inner = BytesStart::new(trouble.element).with_attributes([("message", &*message)]);
                let inner = inner.with_attributes(trouble.kind.map(|kind| ("type", kind)));
                xml.write_event(Event::Start(start))?;
                xml.write_event(Event::Empty(inner))?;
                xml.write_event(Event::End(BytesEnd::new("testcase")))?;
            }
        }
        open_suite.kept.waiting.push(b'\n');
        Ok(self.spool.keep(&mut open_suite.kept)?)
    }

    /// Writes the report.
    pub(super) fn finish(mut self) -> Result<(), Failure> {
        let all = self.suites.values().map(|suite| suite.counts).fold(Counts::default(), Counts::and);
        writeln!(self.output, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
        let mut xml = Writer::new(&mut self.output);
        xml.write_event(Event::Start(all.of("testsuites", "momentous grade")))?;
        for (name, suite) in self.suites {
            xml.write_event(Event::Start(suite.counts.of("testsuite", &name)))?;
            self.spool.write(suite.kept, xml.get_mut())?;
            xml.write_event(Event::End(BytesEnd::new("testsuite")))?;
        }
        xml.write_event(Event::End(BytesEnd::new("testsuites")))?;
        writeln!(self.output)?;
        self.output.finish()
    }
}

impl Counts {
    fn and(self, other: Self) -> Self {
        Self {
            tests: self.tests + other.tests,
            failures: self.failures + other.failures,
            errors: self.errors + other.errors,
        }
    }

    /// The start of an element with that name, and these numbers.
    fn of(self, element: &'static str, name: &str) -> BytesStart<'static> {
        let [tests, failures, errors] = [self.tests, self.failures, self.errors].map(|count| count.to_string());
        let name = printable(name);
        let counts = [("name", &*name), ("tests", &*tests), ("failures", &*failures), ("errors", &*errors)];
        let start = BytesStart::new(element).with_attributes(counts);
        if element == "testsuite" { start.with_attributes([("disabled", "0")]) } else { start }
    }
}
