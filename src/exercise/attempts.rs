//! Marking several attempts of one student at one variant.

use momentous_grade::DecimalMark;
use momentous_grade::FeedbackTime;
use momentous_grade::HintsSeen;
use momentous_grade::History;
use momentous_grade::Report;
use momentous_grade::Typed;
use momentous_problem::Part;
use momentous_problem::Worked;
use momentous_quantity::Rational;

use super::Exercise;
use super::echo::echo;
use super::marker::Marker;
use super::marking::Sittings;

/// One sheet that a student hands in: what is typed, and what had been seen by then.
#[derive(Clone, Debug)]
pub struct Try<'a> {
    /// The answers, each with its part.
    pub answers: Vec<(&'a str, &'a str)>,
    /// The author's hints that were seen.
    pub hints: u32,
    /// The further hints on wrong answers that were seen, each number with its part.
    pub further_hints: Vec<(&'a str, u32)>,
    /// The share of the points that the time of the attempt leaves to what is new in it.
    pub factor: Rational,
    /// The share of its points that the time of the work leaves to it.
    pub work_factor: Rational,
}

impl Default for Try<'_> {
    fn default() -> Self {
        let one = || Rational::ONE;
        Self { answers: Vec::new(), hints: 0, further_hints: Vec::new(), factor: one(), work_factor: one() }
    }
}

impl Marker {
    /// Marks the next attempt at a variant, after those in its history. The report depends on these, the variant and its rubric,
    /// and on nothing else.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use momentous_bank::Bank;
    /// use momentous_exercise::{Exercise, Marker, Try};
    /// use momentous_grade::{DecimalMark, Entry, History};
    /// use momentous_problem::{compile, load};
    ///
    /// let problem = Arc::new(compile(load(Bank::built_in().find("impact/two-carts")?.clone())?, None)?);
    /// let exercise = Exercise::draw(&problem, 0, 7)?;
    /// let mut marker = Marker::new(&problem, 0, DecimalMark::Point)?;
    /// let mut history = History::default();
    ///
    /// let right = exercise.printed(&exercise.worked().form.parts[0]);
    /// let first = Try { answers: vec![("v_A2", &right)], ..Try::default() };
    /// marker.mark_next(exercise.worked(), &mut history, &first);
    /// let second = Try { answers: vec![("v_B2", "99 m/s")], ..Try::default() };
    /// let report = marker.mark_next(exercise.worked(), &mut history, &second);
    /// assert_eq!(report.parts[0].entry, Entry::Locked);
    /// assert!(report.parts[0].verdict.is_right() && !report.parts[1].verdict.is_right());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mark_next(&mut self, worked: Worked<'_>, history: &mut History, attempt: &Try<'_>) -> Report {
        let rules = self.rubric().attempts.clone();
        let ids: Vec<&str> = worked.form.parts.iter().map(|part| part.id.as_str()).collect();
        let answers = self.usual(&ids, &attempt.answers);
        let further = self.usual(&ids, &attempt.further_hints);
        let of_part = |part: &Part| {
            let text = answers.iter().find(|(id, _)| *id == part.id).map_or("", |(_, text)| *text);
            let further = further.iter().find(|(id, _)| *id == part.id).map_or(0, |(_, count)| *count);
            // Whether a formula can be judged tells something of the right one.
            let by_reading = rules.told == FeedbackTime::Later && !text.trim().is_empty();
            let readable = by_reading.then(|| matches!(echo(worked, part, text, self.mark), Some(Ok(_))));
            Typed { text, seen: HintsSeen { hints: attempt.hints, further }, readable }
        };
        let typed: Vec<Typed<'_>> = worked.form.parts.iter().map(of_part).collect();
        let not_asked: Vec<(&str, &str)> = answers.iter().filter(|(part, _)| !ids.contains(part)).copied().collect();
        history.mark(&typed, &attempt.factor, &rules, &mut |texts, sittings| {
            let mut sheet: Vec<(&str, &str)> = ids.iter().copied().zip(texts.iter().copied()).collect();
            sheet.extend(&not_asked);
            self.mark_sheet(worked, &sheet, Sittings::Each(sittings), &attempt.work_factor)
        })
    }

    /// Marks a student's attempts at a variant, the earliest first; so many more were made at each part `before` the first of them.
    /// The parts of one report have `counts`: those of the attempt that counts.
    #[must_use]
    pub fn mark_attempts(&mut self, worked: Worked<'_>, attempts: &[Try<'_>], before: u32) -> Vec<Report> {
        let mut history = History::after(before, worked.form.parts.len());
        let mut reports: Vec<Report> =
            attempts.iter().map(|attempt| self.mark_next(worked, &mut history, attempt)).collect();
        let counting = history.counting().and_then(|number| usize::try_from(number).ok()?.checked_sub(1));
        if let Some(report) = counting.and_then(|place| reports.get_mut(place)) {
            report.parts.iter_mut().for_each(|part| part.counts = true);
        }
        reports
    }
}

impl Exercise {
    /// A marker for the form of this variant; answers are written with this decimal mark.
    #[must_use]
    pub fn marker(&self, mark: DecimalMark) -> Marker {
        let worked = self.worked();
        Marker::of(worked.problem, worked.form, mark)
    }

    /// Marks the next attempt at this variant, after those in its history; where many are marked, a [`Marker`] does it faster.
    pub fn mark_next(&self, history: &mut History, attempt: &Try<'_>, mark: DecimalMark) -> Report {
        self.marker(mark).mark_next(self.worked(), history, attempt)
    }
}
