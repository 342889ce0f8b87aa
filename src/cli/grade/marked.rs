//! Submissions of one chunk, marked by all cores, in the order in which they came.

use std::ops::Range;

use rayon::prelude::*;

use crate::cli::failure::Failure;
use crate::grade::Report;

use super::desk::Desk;
use super::problems::Problems;
use super::sink::{MarksFormat, Rows};
use super::source::Next;
use super::submission::{Key, Place, Submission};

/// Submissions that one core marks in one go.
const PORTION: usize = 4096;

/// A submission with what was found, or why it cannot be used.
pub(super) enum Marked {
    Report(Submission, Report),
    Unusable(Place, String),
}

/// What became of a portion.
pub(super) struct Portion {
    /// The rows of the result.
    pub rows: Vec<u8>,
    /// The submissions in their order; only those that cannot be used where the others are not wanted.
    pub marked: Vec<Marked>,
    /// Whether everything that counts is right.
    pub is_right: bool,
}

/// Marks a chunk. It has all attempts of a student at a question, or none.
pub(super) fn marked(
    mut chunk: Vec<Next>,
    problems: &mut Problems,
    format: MarksFormat,
    keep: bool,
) -> Result<Vec<Portion>, Failure> {
    for submission in chunk.iter().flatten() {
        problems.meet(submission.key(Key::Problem));
    }
    let problems = &*problems;
    let mut portions: Vec<Vec<Next>> = Vec::new();
    while !chunk.is_empty() {
        let mut end = PORTION.min(chunk.len());
        while end < chunk.len() && are_beside(&chunk[end - 1], &chunk[end]) {
            end += 1;
        }
        let rest = chunk.split_off(end);
        portions.push(std::mem::replace(&mut chunk, rest));
    }
    portions.into_par_iter().map(|portion| at_one_desk(portion, problems, format, keep)).collect()
}

/// Whether two submissions are attempts of one student at one question.
pub(super) fn are_beside(one: &Next, other: &Next) -> bool {
    matches!((one, other), (Ok(one), Ok(other)) if one.is_beside(other))
}

fn at_one_desk(portion: Vec<Next>, problems: &Problems, format: MarksFormat, keep: bool) -> Result<Portion, Failure> {
    let mut groups: Vec<Option<Group>> = together(portion).into_iter().map(Some).collect();
    let order = by_question(&groups);
    let mut desk = Desk::new(problems);
    let mut rows = Rows::new(format);
    let mut is_right = true;
    let mut done: Vec<Done> = Vec::with_capacity(groups.len());
    for place in order {
        let Some(group) = groups.get_mut(place).and_then(Option::take) else { continue };
        let start = rows.length()?;
        let mut own = Done { place, rows: start..start, marked: Vec::new() };
        match group {
            Ok(attempts) => is_right &= marked_group(attempts, &mut desk, &mut rows, keep, &mut own.marked)?,
            Err((place, message)) => own.marked.push(Marked::Unusable(place, message)),
        }
        own.rows.end = rows.length()?;
        done.push(own);
    }
    done.sort_by_key(|own| own.place);
    let bytes = rows.into_bytes()?;
    let slices: Vec<&[u8]> = done.iter().filter_map(|own| bytes.get(own.rows.clone())).collect();
    let rows = slices.concat();
    Ok(Portion { rows, marked: done.into_iter().flat_map(|own| own.marked).collect(), is_right })
}

/// What became of one group of attempts: its place in the portion, and its rows among those that were written.
struct Done {
    place: usize,
    rows: Range<usize>,
    marked: Vec<Marked>,
}

/// The attempts of one student at one question, or what is wrong with a row.
type Group = Result<Vec<Submission>, (Place, String)>;

/// Submissions in their order, those of one student to one question together.
fn together(portion: Vec<Next>) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::with_capacity(portion.len());
    for next in portion {
        match (groups.last_mut(), next) {
            (Some(Ok(attempts)), Ok(more)) if attempts.last().is_some_and(|last| last.is_beside(&more)) => {
                attempts.push(more);
            }
            (_, next) => groups.push(next.map(|first| vec![first])),
        }
    }
    groups
}

/// The places of the groups, those to one problem together: all that a problem needs then stays at hand.
fn by_question(groups: &[Option<Group>]) -> Vec<usize> {
    let mut asked: Vec<_> = groups.iter().map(|group| group.as_ref().and_then(question)).zip(0..).collect();
    asked.sort_unstable();
    asked.into_iter().map(|(_, place)| place).collect()
}

/// What is asked: problem, form and seed, as they are written.
fn question(group: &Group) -> Option<[&str; 3]> {
    let first = group.as_ref().ok()?.first()?;
    Some([Key::Problem, Key::Form, Key::Seed].map(|key| first.key(key)))
}

/// Marks the attempts of one student at one question; whether everything that counts is right.
fn marked_group(
    attempts: Vec<Submission>,
    desk: &mut Desk<'_>,
    rows: &mut Rows,
    keep: bool,
    marked: &mut Vec<Marked>,
) -> Result<bool, Failure> {
    let mut is_right = true;
    let reports = desk.mark(&attempts);
    for (submission, report) in attempts.into_iter().zip(reports) {
        match report {
            Ok(report) => {
                for part in &report.parts {
                    is_right &= part.verdict.is_right() || !part.counts;
                    rows.part(&submission, part)?;
                }
                if keep {
                    marked.push(Marked::Report(submission, report));
                }
            }
            Err(message) => marked.push(Marked::Unusable(submission.place, message)),
        }
    }
    Ok(is_right)
}
