//! Failures for the end of a log, for the page of a change, and for the page of a CI job.

use std::io::Write;
use std::path::Path;

use quick_xml::Writer;
use quick_xml::events::{BytesEnd, BytesStart, BytesText, Event};

use crate::bank::Audit;
use crate::bank::Failing;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::style::Style;
use crate::export::printable;

/// The name of the test suite.
const SUITE: &str = "momentous check";

/// The file of an audit with the place of a failure, as editors open it.
fn place(audit: &Audit, failing: &Failing) -> String {
    let numbers = failing.line.into_iter().chain(failing.column).map(|number| format!(":{number}"));
    format!("{}{}", audit.file, numbers.collect::<String>())
}

fn all(audits: &[Audit]) -> impl Iterator<Item = (&Audit, &Failing)> {
    audits.iter().flat_map(|audit| audit.failing.iter().map(move |failing| (audit, failing)))
}

/// One line for each failure, with its file.
pub(super) fn write_text(output: &mut Output, audits: &[Audit]) -> Result<(), Failure> {
    let style = Style::of_stdout();
    for (audit, failing) in all(audits) {
        writeln!(output, "{} {}: {}", style.bad("failed:"), place(audit, failing), failing.message)?;
    }
    Ok(())
}

/// The failures as commands of GitHub's workflows, which shows them beside the lines of a change.
pub(super) fn write_annotations(output: &mut Output, audits: &[Audit]) -> Result<(), Failure> {
    let data = |text: &str| text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A");
    let property = |text: &str| data(text).replace(':', "%3A").replace(',', "%2C");
    for (audit, failing) in all(audits) {
        let line = failing.line.map(|line| format!(",line={line}")).unwrap_or_default();
        let column = failing.column.map(|column| format!(",col={column}")).unwrap_or_default();
        writeln!(output, "::error file={}{line}{column}::{}", property(&audit.file), data(&failing.message))?;
    }
    Ok(())
}

/// A report in JUnit's form: a case for each file.
pub(super) fn write_junit(path: &Path, audits: &[Audit]) -> Result<(), Failure> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    let failed = audits.iter().filter(|audit| !audit.failing.is_empty()).count();
    let [tests, failures] = [audits.len(), failed].map(|count| count.to_string());
    let counts = [("name", SUITE), ("tests", &tests), ("failures", &failures), ("errors", "0")];
    xml.write_event(Event::Start(BytesStart::new("testsuites").with_attributes(counts)))?;
    xml.write_event(Event::Start(BytesStart::new("testsuite").with_attributes(counts)))?;
    for audit in audits {
        let file = printable(&audit.file);
        let name = audit.problem.as_deref().unwrap_or(&file);
        let case = BytesStart::new("testcase").with_attributes([("classname", SUITE), ("name", name), ("file", &file)]);
        if audit.failing.is_empty() {
            xml.write_event(Event::Empty(case))?;
            continue;
        }
        xml.write_event(Event::Start(case))?;
        for failing in &audit.failing {
            let message = printable(&failing.message);
            let element = BytesStart::new("failure").with_attributes([("message", &*message)]);
            xml.write_event(Event::Start(element))?;
            let text = format!("{}: {message}", place(audit, failing));
            xml.write_event(Event::Text(BytesText::new(&printable(&text))))?;
            xml.write_event(Event::End(BytesEnd::new("failure")))?;
        }
        xml.write_event(Event::End(BytesEnd::new("testcase")))?;
    }
    xml.write_event(Event::End(BytesEnd::new("testsuite")))?;
    xml.write_event(Event::End(BytesEnd::new("testsuites")))?;
    let text = String::from_utf8_lossy(&xml.into_inner()).into_owned();
    Output::whole(Some(path), &format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{text}\n"))
}
