//! Marking a variant: answers are dealt out to what is expected, judged, and looked at again where they are wrong.

use std::cell::OnceCell;
use std::collections::BTreeMap;

use momentous_fault::unknown_name;
use momentous_grade as grade;
use momentous_grade::Expected;
use momentous_grade::Reading;
use momentous_grade::Sitting;
use momentous_problem::Part;
use momentous_problem::Simulated;
use momentous_problem::Worked;
use momentous_quantity::Rational;

use super::Exercise;
use super::marker::Blank;
use super::marker::Marker;
use super::marker::widen;
use super::names::Names;
use super::roots::{joined, several, shared_out};
use super::rules::Rules;
use super::work;

/// In which position a student is at each part.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sittings<'a> {
    /// In the same at all of them.
    All(Sitting),
    /// In one for each part, in their order.
    Each(&'a [Sitting]),
}

/// One set of answers to one variant, on its way to a report.
#[derive(Debug)]
pub(super) struct Marking<'a> {
    pub(super) worked: Worked<'a>,
    pub(super) rubric: &'a grade::Rubric,
    pub(super) expected: Vec<Expected>,
    pub(super) readings: Vec<Option<Reading>>,
    /// The position of the part to which each of what is expected belongs.
    pub(super) parts: Vec<usize>,
    /// In which position the student is at each part.
    pub(super) sittings: Sittings<'a>,
    /// What comes of the usual mistakes, once somebody asks.
    pub(super) simulated: OnceCell<Simulated<'a>>,
    /// What comes of slips in one line, once no usual mistake explains an answer.
    pub(super) slips: OnceCell<Simulated<'a>>,
}

impl Marker {
    /// Marks answers to a variant of this form, by part. Of wrong answers it says what they follow from, or which usual mistake
    /// leads to them.
    #[must_use]
    pub fn mark(&mut self, worked: Worked<'_>, answers: &[(&str, &str)], sitting: Sitting) -> grade::Report {
        let ids: Vec<&str> = worked.form.parts.iter().map(|part| part.id.as_str()).collect();
        let answers = self.usual(&ids, answers);
        self.mark_sheet(worked, &answers, Sittings::All(sitting), &Rational::ONE)
    }

    /// The same for a student who is not in the same position at all parts, which have their names in the file; work among the answers
    /// counts by the factor.
    pub(super) fn mark_sheet(
        &mut self,
        worked: Worked<'_>,
        answers: &[(&str, &str)],
        sittings: Sittings<'_>,
        work_factor: &Rational,
    ) -> grade::Report {
        let Self { blanks, rubric, mark, .. } = self;
        let count = blanks.len();
        let mut marking = Marking {
            worked,
            rubric,
            expected: Vec::with_capacity(count),
            readings: Vec::with_capacity(count),
            parts: Vec::with_capacity(count),
            sittings,
            simulated: OnceCell::new(),
            slips: OnceCell::new(),
        };
        for (position, (part, blank)) in worked.form.parts.iter().zip(blanks.iter_mut()).enumerate() {
            let text = answers.iter().find(|(id, _)| *id == part.id).map_or("", |(_, text)| *text);
            let single = blank.expected(worked);
            let mut take = |expected: Expected, text: &str| {
                marking.readings.push(blank.read(text, &expected.kind, *mark));
                marking.parts.push(position);
                marking.expected.push(expected);
            };
            match several(worked, part) {
                Some(roots) => {
                    for (expected, text) in shared_out(&single, &roots, text, worked, part, *mark) {
                        take(expected, &text);
                    }
                }
                None => take(single, text),
            }
        }
        let Marking { expected, readings, parts, .. } = &mut marking;
        let mut widen = |place: usize, expected: &mut Expected| {
            if let Some(part) = parts.get(place).and_then(|position| worked.form.parts.get(*position)) {
                widen(expected, worked, part);
            }
        };
        let mut report = grade::grade_read(expected, readings, rubric, &mut widen);
        let is_part = |id: &str| worked.form.parts.iter().any(|part| part.id == id);
        let work = work::work_among(worked, answers);
        let not_asked = answers.iter().filter(|(id, text)| !is_part(id) && Some(*text) != work);
        report.not_asked = not_asked.map(|(id, _)| (*id).to_owned()).collect();
        if !report.is_right() {
            marking.follow_through(&mut report);
            marking.diagnose(&mut report);
        }
        // Where a part had several roots, the list is longer than the sheet.
        if marking.expected.len() > count {
            report.parts = joined(report.parts, &marking.parts, worked);
            report.out_of = worked.form.parts.iter().fold(0, |sum: u32, part| sum.saturating_add(part.points));
            report.recount();
        }
        if let Some(work) = work {
            work::credit(&mut report, worked, (work, work_factor), *mark);
        }
        report
    }
}

impl Marking<'_> {
    /// In which position the student is at the part to which what is expected belongs.
    pub(super) fn sitting(&self, place: usize) -> Sitting {
        let of_part = |sittings: &[Sitting]| self.parts.get(place).and_then(|part| sittings.get(*part)).copied();
        match self.sittings {
            Sittings::All(sitting) => sitting,
            Sittings::Each(sittings) => of_part(sittings).unwrap_or_default(),
        }
    }
}

impl Exercise {
    /// The name in the file of what an answer is for, where the student wrote the course's, `J_A` for `I_A`, or the one that the sheet
    /// prints.
    #[must_use]
    pub fn usual_name<'a>(&'a self, typed: &'a str) -> &'a str {
        let worked = self.worked();
        let ids: Vec<&str> = worked.form.parts.iter().map(|part| part.id.as_str()).collect();
        Names::of(worked.problem, worked.form).meant(&ids, typed)
    }

    /// Answers by the names of their parts in the file, of names as a student or a tool wrote them.
    ///
    /// # Errors
    /// Each name that is no part of the question, or whose part is answered twice.
    pub fn answers_by_part<'a>(
        &self,
        typed: impl IntoIterator<Item = (&'a str, &'a str)>,
    ) -> Result<BTreeMap<String, String>, Vec<String>> {
        let parts: Vec<&str> = self.worked().form.parts.iter().map(|part| part.id.as_str()).collect();
        let (mut answers, mut faults) = (BTreeMap::new(), Vec::new());
        for (name, text) in typed {
            let usual = self.usual_name(name);
            if !parts.contains(&usual) {
                faults.push(unknown_name(name, "part of this question", &parts));
            } else if answers.insert(usual.to_owned(), text.to_owned()).is_some() {
                faults.push(format!("`{name}` is answered twice"));
            }
        }
        if faults.is_empty() { Ok(answers) } else { Err(faults) }
    }

    /// What a right answer to a part is.
    #[must_use]
    pub fn expected(&self, part: &Part) -> Expected {
        let worked = self.worked();
        let rules = Rules { problem: worked.problem, form: worked.form };
        let blank = Blank::new(rules, part);
        let mut expected = blank.expected(worked);
        widen(&mut expected, worked, part);
        expected
    }

    /// The part of that name, in the file's letters or the course's.
    #[must_use]
    pub fn part(&self, name: &str) -> Option<&Part> {
        let usual = self.usual_name(name);
        self.worked().form.parts.iter().find(|part| part.id == usual)
    }

    /// Marks answers to this variant, by part.
    #[must_use]
    pub fn grade(&self, answers: &BTreeMap<String, String>, mark: grade::DecimalMark) -> grade::Report {
        self.mark(answers, mark, Sitting::default())
    }

    /// The same for a student who has asked for hints, or who has no attempts left. Where many answers to one form are marked,
    /// a [`Marker`] does it faster.
    #[must_use]
    pub fn mark(
        &self,
        answers: &BTreeMap<String, String>,
        mark: grade::DecimalMark,
        sitting: Sitting,
    ) -> grade::Report {
        let answers: Vec<(&str, &str)> = answers.iter().map(|(id, text)| (id.as_str(), text.as_str())).collect();
        let worked = self.worked();
        Marker::of(worked.problem, worked.form, mark).mark(worked, &answers, sitting)
    }
}
