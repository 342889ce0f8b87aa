//! Submissions of one chunk, marked by all cores, in the order in which they came.

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
    let mut desk = Desk::new(problems);
    let mut rows = Rows::new(format);
    let mut done = Portion { rows: Vec::new(), marked: Vec::new(), is_right: true };
    let mut rest = portion.into_iter().peekable();
    while let Some(next) = rest.next() {
        let first = match next {
            Ok(submission) => submission,
            Err((place, message)) => {
                done.marked.push(Marked::Unusable(place, message));
                continue;
            }
        };
        let mut attempts = vec![first];
        while let Some(Ok(more)) = rest.next_if(|next| {
            let last = attempts.last();
            matches!((last, next), (Some(last), Ok(next)) if last.is_beside(next))
        }) {
            attempts.push(more);
        }
        let reports = desk.mark(&attempts);
        for (submission, report) in attempts.into_iter().zip(reports) {
            match report {
                Ok(report) => {
                    for part in &report.parts {
                        done.is_right &= part.verdict.is_right() || !part.counts;
                        rows.part(&submission, part)?;
                    }
                    if keep {
                        done.marked.push(Marked::Report(submission, report));
                    }
                }
                Err(message) => done.marked.push(Marked::Unusable(submission.place, message)),
            }
        }
    }
    done.rows = rows.into_bytes()?;
    Ok(done)
}
