//! Submissions of one chunk, marked by all cores, in the order in which they came.

use std::collections::BTreeMap;
use std::ops::Range;

use rayon::prelude::*;

use crate::cli::failure::Failure;
use crate::grade::Report;

use super::desk::Desk;
use super::problems::Problems;
use super::sink::{MarksFormat, Rows};
use super::source::Next;
use super::submission::{Key, Place, Submission};

/// Submissions that one core marks in one go: few enough to stay in its cache, for they are not marked in their order.
const PORTION: usize = 1024;

/// A submission with what was found, or why it cannot be used.
pub(super) enum Marked {
    Report(Submission, Box<Report>),
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
    chunk: Vec<Next>,
    problems: &mut Problems,
    format: MarksFormat,
    keep: bool,
) -> Result<Vec<Portion>, Failure> {
    for submission in chunk.iter().flatten() {
        problems.meet(submission.key(Key::Problem));
    }
    let problems = &*problems;
    let mut portions: Vec<Vec<Next>> = Vec::new();
    for next in chunk {
        match portions.last_mut() {
            Some(own) if own.len() < PORTION || own.last().is_some_and(|last| are_beside(last, &next)) => {
                own.push(next);
            }
            _ => portions.push(vec![next]),
        }
    }
    let desk = || Desk::new(problems);
    portions.into_par_iter().map_init(desk, |desk, portion| at_one_desk(portion, desk, format, keep)).collect()
}

/// Whether two submissions are attempts of one student at one question.
pub(super) fn are_beside(one: &Next, other: &Next) -> bool {
    matches!((one, other), (Ok(one), Ok(other)) if one.is_beside(other))
}

fn at_one_desk(portion: Vec<Next>, desk: &mut Desk<'_>, format: MarksFormat, keep: bool) -> Result<Portion, Failure> {
    let mut groups: Vec<Option<Group>> = together(portion).into_iter().map(Some).collect();
    let order = by_question(&groups);
    let mut rows = Rows::new(format);
    let mut is_right = true;
    let mut done: Vec<Done> = Vec::with_capacity(groups.len());
    for place in order {
        let Some(group) = groups.get_mut(place).and_then(Option::take) else { continue };
        let start = rows.length()?;
        let mut own = Done { place, rows: start..start, marked: Vec::new() };
        match group {
            Ok(attempts) => is_right &= marked_group(attempts, desk, &mut rows, keep, &mut own.marked)?,
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

/// The places of the groups, those to one form of a problem together and in the order of their seeds: all that a form needs
/// then stays at hand.
fn by_question(groups: &[Option<Group>]) -> Vec<usize> {
    let mut forms: BTreeMap<[&str; 2], usize> = BTreeMap::new();
    let mut asked: Vec<(usize, Option<u64>, usize)> = Vec::with_capacity(groups.len());
    for (place, group) in groups.iter().enumerate() {
        let first = group.as_ref().and_then(|group| group.as_ref().ok()?.first());
        let next = forms.len();
        let form = first.map(|first| [Key::Problem, Key::Form].map(|key| first.key(key)));
        let form = form.map_or(next, |form| *forms.entry(form).or_insert(next));
        // Numbers sort faster than texts; a seed that is none is reported when its turn comes.
        asked.push((form, first.and_then(|first| first.key(Key::Seed).parse().ok()), place));
    }
    asked.sort_unstable();
    asked.into_iter().map(|(.., place)| place).collect()
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
                    marked.push(Marked::Report(submission, Box::new(report)));
                }
            }
            Err(message) => marked.push(Marked::Unusable(submission.place, message)),
        }
    }
    Ok(is_right)
}
