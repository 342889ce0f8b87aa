//! Marks as the report of a test run, for the page of a CI job: a suite for each problem, a case for each answer.

use std::collections::BTreeMap;
use std::path::Path;

use quick_junit::NonSuccessKind;
use quick_junit::Report;
use quick_junit::TestCase;
use quick_junit::TestCaseStatus;
use quick_junit::TestSuite;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::grade::PartReport;
use crate::grade::Verdict;

use super::submission::{Key, Place, Submission};

/// The cases so far, by problem.
#[derive(Default)]
pub(super) struct Junit {
    suites: BTreeMap<String, Vec<TestCase>>,
}

impl Junit {
    /// Adds what was found about one part: right is a success, unreadable an error, anything else a failure.
    pub(super) fn part(&mut self, submission: &Submission, part: &PartReport) {
        let mut status = match part.verdict {
            verdict if verdict.is_right() => TestCaseStatus::success(),
            Verdict::Unreadable => TestCaseStatus::non_success(NonSuccessKind::Error),
            _ => TestCaseStatus::non_success(NonSuccessKind::Failure),
        };
        status.set_type(part.verdict.code());
        status.set_message(&*part.message);
        let student = submission.key(Key::Student);
        let who = if student.is_empty() { format!("line {}", submission.place) } else { student.to_owned() };
        let mut case = TestCase::new(format!("{who}, seed {}: {}", submission.key(Key::Seed), part.id), status);
        case.set_classname(submission.key(Key::Problem));
        self.suites.entry(submission.key(Key::Problem).to_owned()).or_default().push(case);
    }

    /// Adds a submission that could not be used.
    pub(super) fn unusable(&mut self, place: &Place, message: &str) {
        let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
        status.set_message(message);
        let case = TestCase::new(format!("line {place}"), status);
        self.suites.entry("submissions that cannot be used".to_owned()).or_default().push(case);
    }

    /// Writes the report.
    pub(super) fn write(self, path: &Path) -> Result<(), Failure> {
        let mut report = Report::new("momentous grade");
        for (name, cases) in self.suites {
            let mut suite = TestSuite::new(name);
            suite.add_test_cases(cases);
            report.add_test_suite(suite);
        }
        let text = report.to_string().map_err(|error| Failure::unusable(format!("the JUnit report: {error}")))?;
        Output::whole(Some(path), &text)
    }
}
