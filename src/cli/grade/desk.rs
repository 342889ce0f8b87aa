//! A desk at which one core marks a portion of the submissions: what draws and marks a form is set up there once.

use crate::cli::open;
use crate::exercise::Drawer;
use crate::exercise::Exercise;
use crate::exercise::Marker;
use crate::exercise::Try;
use crate::grade::Report;

use super::problems::{Met, Problems};
use super::submission::{Key, Submission};

/// What marks the submissions of a portion.
pub(super) struct Desk<'p> {
    problems: &'p Problems,
    forms: Vec<Form<'p>>,
    /// The position of the form that was asked for last: submissions to the same one often stand together.
    last: usize,
}

/// One form on the desk, under the names by which it was asked for, with the variant that was drawn last.
struct Form<'p> {
    asked: [String; 2],
    met: &'p Met,
    marker: Marker,
    drawer: Drawer<'p>,
    last: Option<Exercise>,
}

impl<'p> Desk<'p> {
    pub(super) fn new(problems: &'p Problems) -> Self {
        Self { problems, forms: Vec::new(), last: 0 }
    }

    /// Marks the attempts of one student at one question; each gets its report, or is told why it cannot be used.
    pub(super) fn mark(&mut self, attempts: &[Submission]) -> Vec<Result<Report, String>> {
        let opened = attempts.first().map(|first| self.open(first));
        let (id, form) = match opened {
            None => return Vec::new(),
            Some(Ok(opened)) => opened,
            Some(Err(message)) => return attempts.iter().map(|_| Err(message.clone())).collect(),
        };
        let Form { marker, last: Some(exercise), .. } = form else { return Vec::new() };
        let mut results: Vec<Result<Report, String>> = Vec::with_capacity(attempts.len());
        let mut tries: Vec<(usize, Try<'_>)> = Vec::with_capacity(attempts.len());
        for (place, own) in attempts.iter().enumerate() {
            let own = read(own, id, marker);
            results.push(own.as_ref().map(|_| Report::default()).map_err(String::clone));
            tries.extend(own.ok().map(|own| (place, own)));
        }
        tries.sort_by_key(|(place, _)| attempts.get(*place).and_then(Submission::attempt));
        let first = tries.first().and_then(|(place, _)| attempts.get(*place)).and_then(Submission::attempt);
        let (places, tries): (Vec<usize>, Vec<Try<'_>>) = tries.into_iter().unzip();
        let marked = marker.mark_attempts(exercise.worked(), &tries, first.map_or(0, |number| number - 1));
        for (place, attempt) in places.into_iter().zip(marked) {
            if let Some(result) = results.get_mut(place) {
                *result = Ok(attempt.report);
            }
        }
        results
    }

    /// The form that is asked, with the variant of the seed drawn.
    fn open(&mut self, submission: &Submission) -> Result<(&'p str, &mut Form<'p>), String> {
        let seed = submission.key(Key::Seed);
        let seed = open::seed(seed).map_err(|why| format!("`{seed}` is no seed: {why}"))?;
        let form = self.form(submission)?;
        let (id, digest) = (form.met.problem.id(), &form.met.problem.loaded().digest);
        let said = submission.key(Key::Digest);
        if !said.is_empty() && said != digest {
            return Err(format!("the sheet was made from another version of {id}: its digest is {digest}"));
        }
        if form.last.as_ref().is_none_or(|last| last.variant().seed() != Some(seed)) {
            form.last = Some(form.drawer.draw(seed).map_err(|reason| reason.to_string())?);
        }
        Ok((id, form))
    }

    /// The form that is asked; it is set up where it is not on the desk yet.
    fn form(&mut self, submission: &Submission) -> Result<&mut Form<'p>, String> {
        let asked = [Key::Problem, Key::Form].map(|key| submission.key(key));
        let is_asked = |form: &Form<'p>| form.asked.iter().eq(asked);
        if !self.forms.get(self.last).is_some_and(is_asked) {
            self.last = match self.forms.iter().position(is_asked) {
                Some(known) => known,
                None => {
                    self.forms.push(Form::new(self.problems.find(asked[0])?, asked)?);
                    self.forms.len() - 1
                }
            };
        }
        self.forms.get_mut(self.last).ok_or_else(|| "the problem has no such form".to_owned())
    }
}

impl<'p> Form<'p> {
    fn new(met: &'p Met, asked: [&str; 2]) -> Result<Self, String> {
        let name = Some(asked[1]).filter(|form| !form.is_empty());
        let position = open::form(&met.problem, name).map_err(|failure| failure.to_string())?;
        let marker = met.markers.get(position).cloned().ok_or("the problem has no such form")?;
        let drawer = Drawer::new(&met.problem, position).map_err(|reason| reason.to_string())?;
        Ok(Self { asked: asked.map(str::to_owned), met, marker, drawer, last: None })
    }
}

/// The answers of a submission, and the hints that were seen.
fn read<'s>(submission: &'s Submission, id: &str, marker: &Marker) -> Result<Try<'s>, String> {
    let answers: Vec<(&str, &str)> = submission.answers().collect();
    if let Some((name, _)) = answers.iter().find(|(name, _)| !marker.asks(name)) {
        return Err(format!("`{name}` has an answer, and {id} does not ask for it in this form"));
    }
    let hints = match submission.key(Key::Hints) {
        "" => 0,
        text => text.parse().map_err(|_| format!("`{text}` is no number of hints"))?,
    };
    Ok(Try { answers, hints })
}
