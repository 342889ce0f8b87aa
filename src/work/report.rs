//! The report on a student's work: each line with its verdict, what is established and what is still missing.

use std::fmt;

use momentous_expr::Math;
use serde::Serialize;

use super::verdict::Verdict;

/// A line, judged.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct JudgedLine {
    /// Its place among the lines that are not empty, counted from 1.
    pub line: usize,
    /// The line as it was written.
    pub text: String,
    /// Its verdict.
    pub verdict: Verdict,
    /// The laws that it is made of, by their ids.
    pub laws: Vec<&'static str>,
    /// The mistakes that it may come from, by their codes.
    pub mistakes: Vec<&'static str>,
    /// The message to the student.
    pub message: String,
    /// Whether it is written in letters and the constants of formulas, with no number that was worked out or put in.
    #[serde(skip)]
    pub is_in_letters: bool,
}

/// A law that the answers need.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LawNeeded {
    /// Its id.
    pub law: &'static str,
    /// Its name.
    pub name: &'static str,
    /// The stage in which it is used, as a noun phrase; none for what holds at one instant.
    pub stage: Option<String>,
    /// Whether the lines hold it.
    pub established: bool,
    /// The points for it.
    pub points: u32,
}

/// An answer that is asked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct AnswerNeeded {
    /// Its name: `v_A2`.
    pub id: String,
    /// Whether a line gives it.
    pub established: bool,
    /// The points for it.
    pub points: u32,
}

/// A student's work, judged.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct WorkReport {
    /// The lines.
    pub lines: Vec<JudgedLine>,
    /// The laws that the answers need, in the order of the solution.
    pub laws: Vec<LawNeeded>,
    /// The answers.
    pub answers: Vec<AnswerNeeded>,
    /// The points for laws and answers that the lines hold.
    pub points: u32,
    /// All points for laws and answers.
    pub out_of: u32,
}

/// A hint for the next line, plainer the stronger it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NextStep {
    /// Which principle to use, and where.
    pub principle: String,
    /// The equation in symbols; none where nothing but numbers is left to be found.
    pub equation: String,
    /// The equation with the numbers of the sheet.
    pub numbers: String,
    /// The equation in symbols as mathematics; nothing where `equation` is empty.
    #[serde(skip)]
    pub math: Option<Math>,
}

impl WorkReport {
    /// Whether the lines hold all answers and none is wrong.
    #[must_use]
    pub fn is_right(&self) -> bool {
        let has_answers = !self.answers.is_empty() && self.answers.iter().all(|answer| answer.established);
        has_answers && !self.lines.iter().any(|line| line.verdict.is_wrong())
    }
}

impl NextStep {
    /// The hint, plainer with each further one that is asked for: the principle, the equation, the equation with numbers.
    #[must_use]
    pub fn strength(&self, hints: usize) -> String {
        let mut further = [&self.equation, &self.numbers].into_iter().take(hints.saturating_sub(1));
        let further = further.rfind(|text| !text.is_empty());
        further.map_or_else(|| self.principle.clone(), |text| format!("{} {text}", self.principle))
    }
}

/// For people: each line with what is said of it, then what is shown and what is missing.
impl fmt::Display for WorkReport {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in &self.lines {
            writeln!(out, "{:>3}  {}\n     {}", line.line, line.text, line.message)?;
        }
        writeln!(out)?;
        for law in &self.laws {
            let stage = law.stage.as_ref().map_or_else(String::new, |stage| format!(" ({stage})"));
            writeln!(out, "{} {}{stage}", sign(law.established), law.name)?;
        }
        for answer in &self.answers {
            writeln!(out, "{} {}", sign(answer.established), answer.id)?;
        }
        writeln!(out, "Method: {} of {} points", self.points, self.out_of)
    }
}

fn sign(is_established: bool) -> &'static str {
    if is_established { "[x]" } else { "[ ]" }
}
