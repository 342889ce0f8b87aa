//! Answers with fewer figures than the sheet asks for: they are asked back before they are marked, where there is somebody to ask.

use std::collections::BTreeMap;

use momentous_grade as grade;
use momentous_grade::DecimalMark;
use momentous_grade::Reading;
use momentous_grade::Report;
use momentous_grade::Sitting;
use momentous_problem::Part;

use super::Exercise;
use super::echo::values;
use super::marker::Blank;
use super::rules::Rules;

impl Exercise {
    /// The number of figures that the sheet asks for, where an answer to a part can be read and has fewer. The right answer is
    /// not looked at.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use momentous_bank::Bank;
    /// use momentous_exercise::Exercise;
    /// use momentous_grade::DecimalMark;
    /// use momentous_problem::{compile, load};
    ///
    /// let problem = Arc::new(compile(load(Bank::built_in().find("impact/two-carts")?.clone())?, None)?);
    /// let exercise = Exercise::draw(&problem, 0, 7)?;
    /// let part = &exercise.worked().form.parts[0];
    /// let wanted = |text| exercise.figures_wanted(part, text, DecimalMark::Point);
    /// assert_eq!(["3.2 m/s", "99 m/s", "3.20 m/s", "0 m/s", "3..2"].map(wanted), [Some(3), Some(3), None, None, None]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn figures_wanted(&self, part: &Part, text: &str, mark: DecimalMark) -> Option<usize> {
        let worked = self.worked();
        let asked = Blank::new(Rules { problem: worked.problem, form: worked.form }, part).expected(worked);
        values(worked, part, text).iter().find_map(|value| {
            let answer = Reading::of(value, &asked.kind, mark)?.answer.ok()?;
            grade::too_few_figures(&asked.kind, &answer)
        })
    }

    /// The same as [`Exercise::mark`] for somebody who can be asked: an answer with fewer figures than the sheet asks for is not marked.
    #[must_use]
    pub fn mark_or_ask(&self, answers: &BTreeMap<String, String>, mark: DecimalMark, sitting: Sitting) -> Report {
        let mut marked = answers.clone();
        let asked_back: Vec<(&str, usize)> = self.asked_back(answers, mark).collect();
        marked.retain(|name, _| asked_back.iter().all(|(id, _)| *id != self.usual_name(name)));
        let mut report = self.mark(&marked, mark, sitting);
        for (id, figures) in asked_back {
            report.parts.iter_mut().filter(|part| part.id == id).for_each(|part| part.ask_back(figures));
        }
        report
    }

    /// The parts whose answers have fewer figures than the sheet asks for, and how many it asks for.
    pub fn asked_back<'a>(
        &'a self,
        answers: &'a BTreeMap<String, String>,
        mark: DecimalMark,
    ) -> impl Iterator<Item = (&'a str, usize)> {
        answers.iter().filter_map(move |(name, text)| {
            let part = self.part(name)?;
            Some((part.id.as_str(), self.figures_wanted(part, text, mark)?))
        })
    }
}
