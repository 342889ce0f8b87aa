//! Submissions of one chunk, marked by all cores, in the order in which they came.

use std::collections::BTreeMap;
use std::sync::Arc;

use rayon::prelude::*;

use crate::cli::open;
use crate::exercise::Drawer;
use crate::grade::DecimalMark;
use crate::grade::Report;
use crate::problem::Problem;

use super::problems::Problems;
use super::source::Next;
use super::submission::{Place, Submission};

/// Submissions that one core marks in one go.
const PORTION: usize = 256;

/// A submission with what was found, or why it cannot be used.
pub(super) enum Marked {
    Report(Submission, Report),
    Unusable(Place, String),
}

/// A submission whose problem and form are known.
struct Ready {
    position: usize,
    submission: Submission,
    problem: Arc<Problem>,
    form: usize,
    seed: u64,
}

/// Marks a chunk. Submissions to the same form are marked together, because what draws a form can be used again.
pub(super) fn marked(chunk: Vec<Next>, problems: &mut Problems, mark: DecimalMark) -> Vec<Marked> {
    let mut results: Vec<Option<Marked>> = Vec::new();
    results.resize_with(chunk.len(), || None);
    let mut groups: BTreeMap<(String, usize), Vec<Ready>> = BTreeMap::new();
    for (position, next) in chunk.into_iter().enumerate() {
        match next.and_then(|submission| ready(position, submission, problems)) {
            Ok(ready) => groups.entry((ready.problem.id().to_owned(), ready.form)).or_default().push(ready),
            Err((place, message)) => results[position] = Some(Marked::Unusable(place, message)),
        }
    }
    let portions: Vec<Vec<Ready>> = groups.into_values().flat_map(portions).collect();
    let done: Vec<(usize, Marked)> =
        portions.into_par_iter().flat_map_iter(|portion| together(portion, mark)).collect();
    for (position, marked) in done {
        results[position] = Some(marked);
    }
    results.into_iter().flatten().collect()
}

/// A group cut into pieces, so that every core has some.
fn portions(mut group: Vec<Ready>) -> Vec<Vec<Ready>> {
    let mut portions = Vec::new();
    while group.len() > PORTION {
        let rest = group.split_off(PORTION);
        portions.push(std::mem::replace(&mut group, rest));
    }
    portions.push(group);
    portions
}

fn ready(position: usize, submission: Submission, problems: &mut Problems) -> Result<Ready, (Place, String)> {
    let found = (|| {
        let problem = problems.open(submission.key("problem"))?;
        let digest = &problem.loaded().digest;
        if !submission.key("digest").is_empty() && submission.key("digest") != digest {
            return Err(format!("the sheet was made from another version of {}: its digest is {digest}", problem.id()));
        }
        let text = submission.key("seed");
        let seed = open::seed(text).map_err(|why| format!("`{text}` is no seed: {why}"))?;
        let form = Some(submission.key("form")).filter(|form| !form.is_empty());
        let form = open::form(&problem, form).map_err(|failure| failure.to_string())?;
        Ok((problem, form, seed))
    })();
    match found {
        Ok((problem, form, seed)) => Ok(Ready { position, submission, problem, form, seed }),
        Err(message) => Err((submission.place, message)),
    }
}

/// Marks submissions to the same form.
fn together(portion: Vec<Ready>, mark: DecimalMark) -> Vec<(usize, Marked)> {
    let Some((problem, form)) = portion.first().map(|first| (Arc::clone(&first.problem), first.form)) else {
        return Vec::new();
    };
    let mut drawer = Drawer::new(&problem, form);
    let mut one = |ready: Ready| {
        let report = match &mut drawer {
            Ok(drawer) => drawer.draw(ready.seed).map_err(|reason| reason.to_string()),
            Err(reason) => Err(reason.to_string()),
        };
        let report = report.and_then(|exercise| {
            let answers = ready.submission.answers().map(|(part, answer)| (part.to_owned(), answer.to_owned()));
            let report = exercise.grade(&answers.collect(), mark);
            match report.not_asked.first() {
                Some(name) => {
                    Err(format!("`{name}` has an answer, and {} does not ask for it in this form", problem.id()))
                }
                None => Ok(report),
            }
        });
        let marked = match report {
            Ok(report) => Marked::Report(ready.submission, report),
            Err(message) => Marked::Unusable(ready.submission.place, message),
        };
        (ready.position, marked)
    };
    portion.into_iter().map(&mut one).collect()
}
