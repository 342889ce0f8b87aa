//! The report on a set of answers: marks, and the reason for each.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};

use momentous_quantity::Rational;

use super::catalogue::{Catalogue, English};
use super::diagnose::Diagnosis;
use super::expected::Expected;
use super::follow::Follows;
use super::judge::judge;
use super::marks::Points;
use super::messages::Message;
use super::read::DecimalMark;
use super::reading::Reading;
use super::rubric::Rubric;
use super::swapped;
use super::verdict::Verdict;

/// The reports on every part, in the order of the question.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Report {
    /// The parts.
    pub parts: Vec<PartReport>,
    /// The points reached.
    pub total: Points,
    /// The points that can be reached.
    pub out_of: u32,
    /// Names in the answers that the question does not ask for: most likely a slip of the pen.
    pub not_asked: Vec<String>,
}

/// The report on one part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PartReport {
    /// How the part is called in answers.
    pub id: String,
    /// The verdict.
    pub verdict: Verdict,
    /// The points reached.
    pub points: Points,
    /// The points that can be reached.
    pub out_of: u32,
    /// The reading of the answer, where it could be read.
    pub understood: Option<String>,
    /// The place and the reason where the answer cannot be read.
    pub fault: Option<InputFault>,
    /// The message to the student; it never holds the right value.
    pub message: Cow<'static, str>,
    /// Which usual mistake leads to a wrong answer, where one does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diagnosis: Option<Diagnosis>,
    /// From which earlier answers of the student's own a wrong answer follows, where it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub follows: Option<Follows>,
    /// The values that would have followed from the student's own earlier answers; said only once the question is closed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub own_values: Option<String>,
    /// How the answer came into this attempt.
    #[serde(skip_serializing_if = "Entry::is_typed")]
    pub entry: Entry,
    /// Whether it is this attempt of the student's that counts.
    #[serde(skip)]
    pub counts: bool,
}

/// How the answer to a part came into an attempt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Entry {
    /// It was typed; or there was never any.
    #[default]
    Typed,
    /// Nothing new was typed: it is that of an earlier attempt.
    Carried,
    /// The typed text cannot be read: the report is that of an earlier attempt, where there is one.
    Unread,
    /// It was right in an earlier attempt, so that what was typed is not looked at.
    Locked,
    /// No attempt was left: it is that of an earlier attempt, where there is one.
    NoneLeft,
}

impl Entry {
    /// Whether it is what was typed in this attempt.
    #[must_use]
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "as serde asks")]
    pub fn is_typed(&self) -> bool {
        *self == Self::Typed
    }
}

/// The place and the reason where an answer cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct InputFault {
    /// The character of the answer, counted from 1.
    pub character: usize,
    /// The stable code of the fault.
    pub code: &'static str,
}

/// Reads, judges and reports the answers to a question. The same arguments always give the same report.
///
/// ```
/// use std::collections::BTreeMap;
/// use momentous_grade::{DecimalMark, Expected, ExpectedKind, Rubric, grade};
///
/// let options = vec!["conserved".to_owned(), "not conserved".to_owned()];
/// let because = "no external force acts along x".to_owned();
/// let expected = Expected { id: "a".to_owned(), points: 2, kind: ExpectedKind::Choice { question: String::new(), options, right: 0, because } };
/// let answers = BTreeMap::from([("a".to_owned(), "Conserved".to_owned())]);
/// let report = grade(&[expected], &answers, DecimalMark::Point, &Rubric::default());
/// assert_eq!((report.total.to_string().as_str(), report.out_of), ("2", 2));
/// ```
#[must_use]
pub fn grade(expected: &[Expected], answers: &BTreeMap<String, String>, mark: DecimalMark, rubric: &Rubric) -> Report {
    let text = |part: &Expected| answers.get(&part.id).map_or("", String::as_str);
    let mut readings: Vec<_> = expected.iter().map(|part| Reading::of(text(part), &part.kind, mark)).collect();
    let mut report = grade_read(&mut expected.to_vec(), &mut readings, rubric, &mut |_, _| {});
    let is_asked = |name: &&String| expected.iter().any(|part| part.id == **name);
    report.not_asked = answers.keys().filter(|name| !is_asked(name)).cloned().collect();
    report
}

/// Judges and reports answers that were read, one for each part or none. What is told of each moves into the report.
///
/// How far honest rounding leads, and how large such quantities are, costs more to know than all the rest, and can only turn
/// a judgement in the student's favour. So `widen` puts them in, at its position, where an answer is not plainly right.
pub fn grade_read(
    expected: &mut [Expected],
    readings: &mut [Option<Reading>],
    rubric: &Rubric,
    widen: &mut dyn FnMut(usize, &mut Expected),
) -> Report {
    let mut parts = Vec::with_capacity(expected.len());
    for (position, (part, reading)) in expected.iter_mut().zip(readings.iter_mut()).enumerate() {
        parts.push(grade_part(part, reading.as_mut(), rubric, &mut |part| widen(position, part)));
    }
    if parts.iter().filter(|part| !part.verdict.is_right()).count() > 1 {
        let not_right = parts.iter().zip(readings).enumerate().filter_map(|(position, (part, reading))| {
            let answer = reading.as_ref()?.answer.as_ref().ok()?;
            // What is right but for its sign has a sign that is wrong.
            let is_signed = matches!(part.verdict, Verdict::Sense | Verdict::SenseReversed);
            (!part.verdict.is_right() && !is_signed).then_some((position, answer))
        });
        for (position, exchanged) in swapped::find(expected, &not_right.collect::<Vec<_>>()) {
            if let Some(part) = parts.get_mut(position) {
                part.verdict = exchanged.verdict();
                part.points = rubric.points(part.verdict, part.out_of);
                part.message = English.message(&exchanged.message());
            }
        }
    }
    let out_of = expected.iter().fold(0, |sum: u32, part| sum.saturating_add(part.points));
    let mut report = Report { parts, total: Points::default(), out_of, not_asked: Vec::new() };
    report.recount();
    report
}

/// The message where some of several values are right, and not all of them, or where there are too many.
#[must_use]
pub fn some_values() -> (Verdict, Cow<'static, str>) {
    (Verdict::SomeValues, English.message(&Message::SomeValues))
}

/// The message about a wrong answer where nothing more is known of it.
#[must_use]
pub fn not_right() -> Cow<'static, str> {
    English.message(&Message::Wrong)
}

/// The report on a part.
fn grade_part(
    expected: &mut Expected,
    reading: Option<&mut Reading>,
    rubric: &Rubric,
    widen: &mut dyn FnMut(&mut Expected),
) -> PartReport {
    let mut report = PartReport::without_points(&expected.id, expected.points, Verdict::Unanswered);
    match reading.map(|reading| (&reading.answer, std::mem::take(&mut reading.told))) {
        None => report.message = English.message(&Message::Unanswered),
        Some((Err(fault), told)) => {
            report.verdict = Verdict::Unreadable;
            report.fault = Some(InputFault { character: fault.at + 1, code: fault.kind.code() });
            report.message = told.into();
        }
        Some((Ok(answer), told)) => {
            let mut judgement = judge(expected, answer);
            if !judgement.is_settled() {
                widen(expected);
                judgement = judge(expected, answer);
            }
            report.verdict = judgement.verdict;
            report.points = rubric.points(judgement.verdict, expected.points);
            if let Some(also) = judgement.also {
                report.points.0 *= rubric.fraction(also);
            }
            report.understood = Some(told);
            report.message = judgement.feedback();
        }
    }
    report
}

impl PartReport {
    fn without_points(id: &str, out_of: u32, verdict: Verdict) -> Self {
        Self {
            id: id.to_owned(),
            verdict,
            points: Points::default(),
            out_of,
            understood: None,
            fault: None,
            message: Cow::Borrowed(""),
            diagnosis: None,
            follows: None,
            own_values: None,
            entry: Entry::Typed,
            counts: true,
        }
    }

    /// The part with an answer that is asked back for more figures, so many: it is not marked.
    pub fn ask_back(&mut self, figures: usize) {
        self.verdict = Verdict::Unreadable;
        self.fault = Some(InputFault { character: 1, code: "figures_wanted" });
        self.message = English.message(&Message::FiguresWanted(figures));
    }

    /// Whether what was typed cannot be read.
    #[must_use]
    pub fn is_unread(&self) -> bool {
        self.verdict == Verdict::Unreadable || self.entry == Entry::Unread
    }

    /// Leaves this share of the points; the message says how many per cent that costs.
    pub(super) fn cut(&mut self, left: &Rational, message: impl FnOnce(u32) -> Message) {
        if *left == Rational::ONE || self.points.0 == Rational::ZERO {
            return;
        }
        self.points.0 *= left;
        let percent = (Rational::from(100) * (Rational::ONE - left)).to_f64().value();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 100")]
        self.say(&message(libm::round(percent) as u32));
    }

    /// Tells the student this, too.
    pub(super) fn say(&mut self, message: &Message) {
        self.message = format!("{} {message}", self.message).into();
    }
}

impl Report {
    /// A report on answers on a sheet that the student was not given: these parts, with no points, and none of them counts.
    pub fn not_issued<'a>(parts: impl Iterator<Item = (&'a str, u32)>) -> Self {
        let message = English.message(&Message::NotIssued);
        let part = |(id, out_of)| {
            let part = PartReport::without_points(id, out_of, Verdict::NotIssued);
            PartReport { message: message.clone(), counts: false, ..part }
        };
        let parts: Vec<PartReport> = parts.map(part).collect();
        let out_of = parts.iter().fold(0, |sum: u32, part| sum.saturating_add(part.out_of));
        Self { parts, out_of, ..Self::default() }
    }

    /// Whether every part is fully right.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.parts.iter().all(|part| part.verdict.is_right())
    }

    /// Adds the points up again, where the points of a part were changed.
    pub fn recount(&mut self) {
        // Most points are whole, and whole numbers add up without common denominators.
        let whole =
            |part: &PartReport| part.points.0.is_int().then(|| i64::try_from(part.points.0.numerator()).ok())?;
        self.total = Points(match self.parts.iter().map(whole).sum::<Option<i64>>() {
            Some(sum) => Rational::from(sum),
            None => self.parts.iter().fold(Rational::ZERO, |sum, part| sum + &part.points.0),
        });
    }

    /// Whether a part has an answer that cannot be read, so that it was not marked.
    #[must_use]
    pub fn is_unreadable(&self) -> bool {
        self.parts.iter().any(PartReport::is_unread)
    }
}

/// Prints the report, a part a paragraph, the total last.
impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for part in &self.parts {
            writeln!(out, "{}: {}/{} [{}] {}", part.id, part.points, part.out_of, part.verdict, part.message)?;
            if let Some(understood) = &part.understood {
                writeln!(out, "    read as: {understood}")?;
            }
            if let Some(values) = &part.own_values {
                writeln!(out, "    {values}")?;
            }
        }
        for name in &self.not_asked {
            writeln!(out, "{name}: not asked for")?;
        }
        writeln!(out, "total: {}/{}", self.total, self.out_of)
    }
}
