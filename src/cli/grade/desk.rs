//! A desk at which one core marks a portion of the submissions: what draws and marks a form is set up there once.

use std::collections::BTreeMap;

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
    forms: BTreeMap<(&'p str, usize), Form<'p>>,
}

/// One form on the desk, with the variant that was drawn last: submissions to the same one often stand together.
struct Form<'p> {
    marker: &'p Marker,
    drawer: Drawer<'p>,
    last: Option<Exercise>,
}

impl<'p> Desk<'p> {
    pub(super) fn new(problems: &'p Problems) -> Self {
        Self { problems, forms: BTreeMap::new() }
    }

    /// Marks the attempts of one student at one question; each gets its report, or is told why it cannot be used.
    pub(super) fn mark(&mut self, attempts: &[Submission]) -> Vec<Result<Report, String>> {
        let opened = attempts.first().map(|first| self.open(first));
        let (id, form) = match opened {
            None => return Vec::new(),
            Some(Ok(opened)) => opened,
            Some(Err(message)) => return attempts.iter().map(|_| Err(message.clone())).collect(),
        };
        let Some((marker, exercise)) = form.last.as_ref().map(|exercise| (form.marker, exercise)) else {
            return Vec::new();
        };
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
    fn open(&mut self, submission: &Submission) -> Result<(&'p str, &Form<'p>), String> {
        let met = self.problems.find(submission.key(Key::Problem))?;
        let (problem, id) = (&met.problem, met.problem.id());
        let digest = &problem.loaded().digest;
        let said = submission.key(Key::Digest);
        if !said.is_empty() && said != digest {
            return Err(format!("the sheet was made from another version of {id}: its digest is {digest}"));
        }
        let (form, seed) = asked(met, submission)?;
        let form = match self.forms.entry((id, form)) {
            std::collections::btree_map::Entry::Occupied(found) => found.into_mut(),
            std::collections::btree_map::Entry::Vacant(empty) => {
                let marker = met.markers.get(form).ok_or("the problem has no such form")?;
                let drawer = Drawer::new(problem, form).map_err(|reason| reason.to_string())?;
                empty.insert(Form { marker, drawer, last: None })
            }
        };
        if form.last.as_ref().is_none_or(|last| last.variant().seed() != Some(seed)) {
            form.last = Some(form.drawer.draw(seed).map_err(|reason| reason.to_string())?);
        }
        Ok((id, form))
    }
}

/// The form and the seed of a submission.
fn asked(met: &Met, submission: &Submission) -> Result<(usize, u64), String> {
    let text = submission.key(Key::Seed);
    let seed = open::seed(text).map_err(|why| format!("`{text}` is no seed: {why}"))?;
    let form = Some(submission.key(Key::Form)).filter(|form| !form.is_empty());
    Ok((open::form(&met.problem, form).map_err(|failure| failure.to_string())?, seed))
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
