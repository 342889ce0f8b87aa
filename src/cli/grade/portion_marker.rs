//! A desk at which one core marks a portion of the submissions: what draws and marks a form is set up there once.

use std::sync::Arc;

use crate::exercise::Drawer;
use crate::exercise::Exercise;
use crate::exercise::HandedOut;
use crate::exercise::Marker;
use crate::exercise::Try;
use crate::grade::HintsSeen;
use crate::grade::Report;

use super::problems::OpenProblem;
use super::register::{Entry, Question};

/// The marker of a portion's submissions.
pub(super) struct PortionMarker<'p> {
    /// The problems, by their positions.
    problems: &'p [Arc<OpenProblem>],
    forms: Vec<Form<'p>>,
    /// The position of the form that was asked for last: submissions to the same one often stand together.
    last: usize,
}

/// One form on the desk, with the variant that was drawn last.
struct Form<'p> {
    /// The positions of the problem and of its form.
    asked: [usize; 2],
    marker: Marker,
    drawer: Drawer<'p>,
    last: Option<(HandedOut, Exercise)>,
}

impl<'p> PortionMarker<'p> {
    pub(super) fn new(problems: &'p [Arc<OpenProblem>]) -> Self {
        Self { problems, forms: Vec::new(), last: 0 }
    }

    /// Marks the attempts of one student at one question; each gets its report. Where its numbers cannot be drawn, that is told.
    pub(super) fn mark(&mut self, attempts: &[Entry]) -> Result<Vec<Report>, String> {
        let Some(first) = attempts.first() else { return Ok(Vec::new()) };
        let form = self.form(first.facts.question)?;
        if first.facts.not_issued.is_some() {
            return Ok(attempts.iter().map(|_| form.marker.not_issued()).collect());
        }
        let (marker, exercise) = form.open(first.facts.question.seed, &first.facts.handed_out)?;
        let mut order: Vec<(usize, &Entry)> = attempts.iter().enumerate().collect();
        order.sort_by_key(|(_, attempt)| attempt.facts.attempt);
        let before = order.first().and_then(|(_, attempt)| attempt.facts.attempt).map_or(0, |number| number - 1);
        let tries: Vec<Try<'_>> = order.iter().map(|(_, attempt)| attempt_of(attempt)).collect();
        let marked = marker.mark_attempts(exercise.worked(), &tries, before);
        let mut reports: Vec<(usize, Report)> =
            order.iter().zip(marked).map(|((place, _), report)| (*place, report)).collect();
        reports.sort_by_key(|(place, _)| *place);
        Ok(reports.into_iter().map(|(_, report)| report).collect())
    }

    /// The form that is asked; it is set up where it is not on the desk yet.
    fn form(&mut self, question: Question) -> Result<&mut Form<'p>, String> {
        let is_asked = |form: &Form<'p>| form.asked == [question.problem, question.form];
        if !self.forms.get(self.last).is_some_and(is_asked) {
            self.last = match self.forms.iter().position(is_asked) {
                Some(known) => known,
                None => {
                    self.forms.push(Form::new(self.problems, question).ok_or("the problem has no such form")?);
                    self.forms.len() - 1
                }
            };
        }
        self.forms.get_mut(self.last).ok_or_else(|| "the problem has no such form".to_owned())
    }
}

impl<'p> Form<'p> {
    fn new(problems: &'p [Arc<OpenProblem>], question: Question) -> Option<Self> {
        let opened = problems.get(question.problem)?;
        let marker = opened.markers.get(question.form)?.clone();
        let drawer = Drawer::new(&opened.problem, question.form).ok()?;
        Some(Self { asked: [question.problem, question.form], marker, drawer, last: None })
    }

    /// The marker with the variant that is asked, which is drawn where it is not the one that was drawn last.
    fn open(&mut self, seed: u64, handed_out: &HandedOut) -> Result<(&mut Marker, &Exercise), String> {
        let last = match self.last.take() {
            Some((kept, exercise)) if exercise.variant().seed() == Some(seed) && kept == *handed_out => {
                (kept, exercise)
            }
            _ => {
                let drawn = match &handed_out.given {
                    Some(given) => self.drawer.issued(seed, handed_out.scheme, given),
                    None => self.drawer.draw_by(seed, handed_out.scheme),
                };
                (handed_out.clone(), drawn.map_err(|reason| reason.to_string())?)
            }
        };
        Ok((&mut self.marker, &self.last.insert(last).1))
    }
}

/// The answers of a submission, and the hints that were seen.
fn attempt_of(entry: &Entry) -> Try<'_> {
    let answers: Vec<(&str, &str)> = entry.submission.answers().collect();
    let HintsSeen { hints, further } = entry.facts.seen;
    let further_hints = match further {
        0 => Vec::new(),
        hints => answers.iter().map(|(part, _)| (*part, hints)).collect(),
    };
    Try { answers, hints, further_hints, ..Try::default() }
}
