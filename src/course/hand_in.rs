//! Handing in a sheet.

use std::collections::BTreeMap;

use momentous_exercise::Exercise;
use momentous_exercise::MOST_ATTEMPTS;
use momentous_exercise::Try;
use momentous_exercise::WORK;
use momentous_grade::DecimalMark;
use momentous_grade::Entry;
use momentous_grade::History;
use momentous_grade::PartHistory;
use momentous_grade::PartReport;
use momentous_problem::Part;
use momentous_problem::part_letter;
use momentous_quantity::Rational;

use super::handed_in::HintShown;
use super::moment::Moment;
use super::policy::Policy;
use super::stored_report::{ShownReport, StoredPart, StoredReport, StoredWork};
use super::window::{Late, Phase, Window};

/// A hand-in of a student, with all that decides whether it is taken and what it is worth.
///
/// ```
/// use std::collections::BTreeMap;
/// use std::sync::Arc;
/// use momentous_bank::Bank;
/// use momentous_course::{HandIn, Moment, Policy, PolicyForm, Refusal, Window};
/// use momentous_exercise::Exercise;
/// use momentous_grade::DecimalMark;
/// use momentous_problem::{compile, load};
///
/// let problem = Arc::new(compile(load(Bank::built_in().find("impact/two-carts")?.clone())?, None)?);
/// let exercise = Exercise::draw(&problem, 0, 7)?;
/// let form = PolicyForm {
///     opens: "2026-11-23T08:00".into(),
///     due: "2026-11-30T18:00".into(),
///     closes: "2026-12-02T18:00".into(),
///     ..PolicyForm::default()
/// };
/// let policy = Policy::read(&form, "UTC").unwrap();
/// let window = Window::of(&policy, None, "UTC");
/// let answers = BTreeMap::from([("v_A2".to_owned(), exercise.printed(&exercise.worked().form.parts[0]))]);
/// let hand_in = HandIn {
///     exercise: &exercise, decimal: DecimalMark::Point, last: None, answers: &answers, hints: &[],
///     policy: &policy, window: &window, at: Moment::local("2026-11-25T10:00", "UTC")?,
/// };
/// let accepted = hand_in.take()?;
/// assert_eq!(accepted.stored.total.to_string(), "2");
/// let again = HandIn { last: Some(&accepted.stored), ..hand_in };
/// assert_eq!(again.take().unwrap_err(), Refusal::NothingNew);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct HandIn<'a> {
    /// The variant that was issued.
    pub exercise: &'a Exercise,
    /// The sign between whole and decimal digits in the answers.
    pub decimal: DecimalMark,
    /// The stored report of the attempt before; `None` before the first.
    pub last: Option<&'a StoredReport>,
    /// The typed answers, by part.
    pub answers: &'a BTreeMap<String, String>,
    /// The hints that were shown on this sheet.
    pub hints: &'a [HintShown],
    /// The policy of the assignment.
    pub policy: &'a Policy,
    /// Its times for this student.
    pub window: &'a Window,
    /// When the server had it.
    pub at: Moment,
}

/// An attempt that was taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Accepted {
    /// The report to be stored.
    pub stored: StoredReport,
    /// The report that the student may see now.
    pub shown: ShownReport,
}

/// Why nothing was taken.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// The assignment has not opened.
    #[error("the assignment is not open yet")]
    NotOpen,
    /// Answers are no longer taken.
    #[error("the time for answers is over")]
    Over,
    /// A new answer stands at parts without attempts left, or that are right.
    #[error("no attempt is left where the answers are new")]
    NoAttemptLeft,
    /// Nothing is typed, or what was handed in before.
    #[error("there is nothing new to submit")]
    NothingNew,
    /// There are as many attempts as are ever kept.
    #[error("there are too many attempts at this sheet")]
    TooMany,
    /// New answers have fewer figures than the sheet asks for: which, and how many it asks for.
    #[error("{0}")]
    TooFewFigures(String),
}

impl HandIn<'_> {
    /// Marks what is handed in, or says why it is not taken. The same arguments always give the same result.
    ///
    /// # Errors
    /// A [`Refusal`]. Where verdicts are not shown, it does not depend on what is right.
    pub fn take(&self) -> Result<Accepted, Refusal> {
        self.admitted().map(|late| self.accepted(late))
    }

    /// The same for somebody who can be asked: nothing is marked where a new answer has fewer figures than the sheet asks for.
    ///
    /// # Errors
    /// As for [`HandIn::take`]; [`Refusal::TooFewFigures`] says which answers are to have more.
    pub fn take_or_ask(&self) -> Result<Accepted, Refusal> {
        let late = self.admitted()?;
        match self.asked_back() {
            Some(question) => Err(Refusal::TooFewFigures(question)),
            None => Ok(self.accepted(late)),
        }
    }

    /// Whether anything is taken now, and how late it is.
    fn admitted(&self) -> Result<Option<Late>, Refusal> {
        let late = match self.window.phase(self.at) {
            Phase::NotOpen => return Err(Refusal::NotOpen),
            Phase::Over | Phase::Closed => return Err(Refusal::Over),
            Phase::Open => None,
            Phase::Late(late) => Some(late),
        };
        if self.last.is_some_and(|last| last.history.handed_in() >= MOST_ATTEMPTS) {
            return Err(Refusal::TooMany);
        }
        self.is_new()?;
        Ok(late)
    }

    fn accepted(&self, late: Option<Late>) -> Accepted {
        let stored = self.marked(late);
        Accepted { shown: stored.shown(self.window, self.at), stored }
    }

    /// The question asked back before anything is marked: a new answer has fewer figures than the sheet asks for. It does not
    /// depend on what is right.
    fn asked_back(&self) -> Option<String> {
        let history = self.last.map(|last| last.history.parts()).unwrap_or_default();
        let parts = self.exercise.worked().form.parts.iter().enumerate();
        let asked = |(place, part): (usize, &Part)| {
            let text = self.text(&part.id)?;
            let is_new = history.get(place).is_none_or(|history| history.text() != text);
            let figures = self.exercise.figures_wanted(part, text, self.decimal).filter(|_| is_new)?;
            Some(format!("({}) is to have {figures} significant figures", part_letter(place)))
        };
        let all: Vec<String> = parts.filter_map(asked).collect();
        (!all.is_empty()).then(|| all.join(", "))
    }

    /// Whether something is typed that would be marked.
    fn is_new(&self) -> Result<(), Refusal> {
        let rules = self.policy.rules();
        let nothing = PartHistory::default();
        let history = self.last.map(|last| last.history.parts()).unwrap_or_default();
        let typed = self.exercise.worked().form.parts.iter().enumerate().filter_map(|(place, part)| {
            let text = self.text(&part.id)?;
            let history = history.get(place).unwrap_or(&nothing);
            (text != history.text()).then(|| history.entry(text, &rules))
        });
        let entries: Vec<Entry> = typed.collect();
        match () {
            () if entries.contains(&Entry::Typed) || self.taken_work().is_some() => Ok(()),
            () if entries.is_empty() && self.new_work().is_none() => Err(Refusal::NothingNew),
            () => Err(Refusal::NoAttemptLeft),
        }
    }

    /// The work that is typed, where it differs from the one that was handed in last.
    fn new_work(&self) -> Option<&str> {
        let before = self.work_before().map_or("", |work| work.text.as_str());
        self.text(WORK).filter(|text| self.exercise.takes_work() && *text != before)
    }

    fn work_before(&self) -> Option<&StoredWork> {
        self.last.and_then(|last| last.work.as_ref())
    }

    /// The number of times that work was handed in before.
    fn work_made(&self) -> u32 {
        self.work_before().map_or(0, |work| work.made)
    }

    /// New work, where it is taken: it has as many attempts as a part.
    fn taken_work(&self) -> Option<&str> {
        self.new_work().filter(|_| self.policy.rules().counts(self.work_made()))
    }

    /// The work that stands after this.
    fn work(&self, late: Option<&Late>) -> Option<StoredWork> {
        match self.taken_work() {
            Some(text) => Some(StoredWork {
                text: text.to_owned(),
                made: self.work_made() + 1,
                factor: late.map_or(Rational::ONE, |late| late.factor.clone()),
            }),
            None => self.work_before().cloned(),
        }
    }

    /// The text typed at a part, where there is one.
    fn text(&self, id: &str) -> Option<&str> {
        let answer = self.answers.iter().find(|(typed, _)| self.exercise.usual_name(typed) == id);
        answer.map(|(_, text)| text.trim()).filter(|text| !text.is_empty())
    }

    /// Marks it and returns the report to store. Whether it may be taken is not asked.
    pub(super) fn marked(&self, late: Option<Late>) -> StoredReport {
        let shown = |part: Option<&str>| {
            let shown = self.hints.iter().filter(|hint| hint.part.as_deref() == part && hint.at <= self.at);
            u32::try_from(shown.count()).unwrap_or(u32::MAX)
        };
        let parts = &self.exercise.worked().form.parts;
        let work = self.work(late.as_ref());
        let typed = self.answers.iter().map(|(part, text)| (part.as_str(), text.as_str()));
        let typed = typed.filter(|(part, _)| *part != WORK || !self.exercise.takes_work());
        let attempt = Try {
            answers: typed.chain(work.as_ref().map(|work| (WORK, work.text.as_str()))).collect(),
            work_factor: work.as_ref().map_or(Rational::ONE, |stored_work| stored_work.factor.clone()),
            hints: shown(None),
            further_hints: parts.iter().map(|part| (part.id.as_str(), shown(Some(&part.id)))).collect(),
            factor: late.as_ref().map_or(Rational::ONE, |late| late.factor.clone()),
        };
        let mut history = self.last.map_or_else(History::default, |last| last.history.clone());
        let mut marker = self.exercise.marker(self.decimal).with_attempts(self.policy.rules());
        let report = marker.mark_next(self.exercise.worked(), &mut history, &attempt);
        let stored =
            report.parts.into_iter().zip(history.parts()).map(|(part, part_history)| self.stored(part, part_history));
        StoredReport { parts: stored.collect(), total: report.total.0, out_of: report.out_of, late, history, work }
    }

    /// The stored form of a part's report.
    fn stored(&self, part: PartReport, history: &PartHistory) -> StoredPart {
        let asked = self.exercise.part(&part.id);
        let echo = |text: &str| self.exercise.echo(asked?, text, self.decimal);
        let since = match part.entry {
            Entry::Typed => self.text(&part.id).map(|_| self.at),
            _ => self.last.and_then(|last| last.part(&part.id)?.since),
        };
        let unread = (part.entry == Entry::Unread).then(|| match self.text(&part.id).and_then(echo) {
            Some(Err(why)) => Some(why),
            // A formula can be read and yet not be judged.
            _ => Some(part.message.clone().into_owned()),
        });
        let (mistakes, hints) = part.diagnosis.map(|diagnosis| (diagnosis.codes, diagnosis.hints)).unwrap_or_default();
        StoredPart {
            out_of: part.out_of,
            entry: part.entry,
            since,
            read: echo(history.text()).and_then(Result::ok),
            unread: unread.flatten(),
            made: history.made(),
            verdict: part.verdict,
            points: part.points.0,
            message: part.message.into_owned(),
            mistakes: mistakes.into_iter().map(str::to_owned).collect(),
            hints,
            follows_from: part.follows.map(|follows| follows.from).unwrap_or_default(),
            own_values: part.own_values,
            id: part.id,
        }
    }
}
