//! Submissions of one chunk, marked by all cores, in the order in which they came.

use std::ops::Range;
use std::sync::Arc;

use rayon::prelude::*;

use crate::cli::failure::Failure;
use crate::exercise::Key;
use crate::exercise::Place;
use crate::exercise::excerpt;
use crate::grade::Report;
use crate::grade::RowCounts;

use super::legibility::Legibility;
use super::portion_marker::PortionMarker;
use super::problems::OpenProblem;
use super::register::{Entered, Entry, Question};
use super::sink::{MarksFormat, Rows};

/// Submissions that one core marks in one go: few enough to stay in its cache, for they are not marked in their order.
const PORTION: usize = 1024;

/// A submission with its marks, or the reason why it has none.
pub(super) enum Marked {
    /// Its report, for those who want to read it.
    Report(Box<(Entry, Report)>),
    /// It answers a sheet that was not issued, and why that is known.
    NotIssued(Place, String),
    /// It cannot be used, and why.
    Refused(Place, String),
}

/// The result of a portion.
pub(super) struct Portion {
    /// The rows of the result.
    pub rows: Vec<u8>,
    /// The messages, in the order of the submissions.
    pub marked: Vec<Marked>,
    /// Whether everything that counts is right.
    pub is_right: bool,
    /// How many were marked and refused.
    pub counts: RowCounts,
    /// The number of answers that could be read.
    pub legibility: Legibility,
}

/// Marks a chunk. It has all attempts of a student at a question, or none.
pub(super) fn marked(
    chunk: Vec<Entered>,
    problems: &[Arc<OpenProblem>],
    format: MarksFormat,
    keep: bool,
) -> Result<Vec<Portion>, Failure> {
    let mut portions: Vec<Vec<Entered>> = Vec::new();
    for next in chunk {
        match portions.last_mut() {
            Some(portion) if portion.len() < PORTION || !begins(&next) => portion.push(next),
            _ => portions.push(vec![next]),
        }
    }
    let desk = || PortionMarker::new(problems);
    portions.into_par_iter().map_init(desk, |desk, portion| at_one_desk(portion, desk, format, keep)).collect()
}

/// Whether a submission has nothing to do with those before it.
pub(super) fn begins(next: &Entered) -> bool {
    next.as_ref().is_ok_and(|entry| !entry.facts.is_beside)
}

fn at_one_desk(
    portion: Vec<Entered>,
    desk: &mut PortionMarker<'_>,
    format: MarksFormat,
    keep: bool,
) -> Result<Portion, Failure> {
    let mut groups: Vec<Option<Group>> = together(portion).into_iter().map(Some).collect();
    let mut rows = Rows::new(format);
    let mut done: Vec<Done> = Vec::with_capacity(groups.len());
    for place in by_question(&groups) {
        let Some(group) = groups.get_mut(place).and_then(Option::take) else { continue };
        let start = rows.length()?;
        let mut portion_done = Done {
            place,
            rows: start..start,
            marked: Vec::new(),
            is_right: true,
            counts: RowCounts::default(),
            legibility: Legibility::default(),
        };
        match group {
            Ok(attempts) => portion_done.mark(attempts, desk, &mut rows, keep)?,
            Err((place, message)) => portion_done.refuse(place, message),
        }
        portion_done.rows.end = rows.length()?;
        done.push(portion_done);
    }
    done.sort_by_key(|done| done.place);
    let bytes = rows.into_bytes()?;
    let slices: Vec<&[u8]> = done.iter().filter_map(|done| bytes.get(done.rows.clone())).collect();
    let rows = slices.concat();
    let (counts, legibility) = (RowCounts::default(), Legibility::default());
    let mut portion = Portion { rows, marked: Vec::new(), is_right: true, counts, legibility };
    for portion_done in done {
        portion.is_right &= portion_done.is_right;
        portion.counts += portion_done.counts;
        portion.legibility += portion_done.legibility;
        portion.marked.extend(portion_done.marked);
    }
    Ok(portion)
}

/// The result of one group of attempts: its place in the portion, and its rows among those that were written.
struct Done {
    place: usize,
    rows: Range<usize>,
    marked: Vec<Marked>,
    is_right: bool,
    counts: RowCounts,
    legibility: Legibility,
}

/// The attempts of one student at one question, or what is wrong with a row.
type Group = Result<Vec<Entry>, (Place, String)>;

/// Submissions in their order, those of one student to one question together. A row that cannot be used does not part them.
fn together(portion: Vec<Entered>) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::with_capacity(portion.len());
    let mut last = 0;
    for next in portion {
        match (groups.get_mut(last), next) {
            (Some(Ok(attempts)), Ok(more)) if more.facts.is_beside => attempts.push(more),
            (_, next) => {
                if next.is_ok() {
                    last = groups.len();
                }
                groups.push(next.map(|first| vec![first]));
            }
        }
    }
    groups
}

/// The places of the groups, those to one form of a problem together and in the order of their seeds: all that a form needs
/// then stays at hand.
fn by_question(groups: &[Option<Group>]) -> Vec<usize> {
    let question = |group: &Option<Group>| -> Option<Question> {
        group.as_ref()?.as_ref().ok()?.first().map(|first| first.facts.question)
    };
    let mut asked: Vec<(Option<Question>, usize)> =
        groups.iter().enumerate().map(|(place, group)| (question(group), place)).collect();
    asked.sort_unstable();
    asked.into_iter().map(|(_, place)| place).collect()
}

impl Done {
    /// Marks the attempts of one student at one question.
    fn mark(
        &mut self,
        attempts: Vec<Entry>,
        desk: &mut PortionMarker<'_>,
        rows: &mut Rows,
        keep: bool,
    ) -> Result<(), Failure> {
        let reports = match desk.mark(&attempts) {
            Ok(reports) => reports,
            Err(message) => {
                for attempt in attempts {
                    self.refuse(attempt.submission.place, message.clone());
                }
                return Ok(());
            }
        };
        for (entry, report) in attempts.into_iter().zip(reports) {
            self.counts.marked += 1;
            self.counts.answers += report.parts.len() as u64;
            for part in &report.parts {
                self.legibility += Legibility::of(part);
                self.is_right &= part.verdict.is_right() || !part.counts;
                rows.part(&entry.submission, part, &entry.facts.earned(part))?;
            }
            if let Some(why) = entry.facts.not_issued {
                self.is_right = false;
                self.counts.not_issued += 1;
                let [student, problem, seed] =
                    [Key::Student, Key::Problem, Key::Seed].map(|key| excerpt(entry.submission.key(key)));
                let message = format!("`{student}` has seed {seed} of {problem}, and {why}");
                self.marked.push(Marked::NotIssued(entry.submission.place.clone(), message));
            }
            if keep {
                self.marked.push(Marked::Report(Box::new((entry, report))));
            }
        }
        Ok(())
    }

    fn refuse(&mut self, place: Place, message: String) {
        self.counts.refused += 1;
        self.marked.push(Marked::Refused(place, message));
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::super::problems::Problems;
    use super::super::reader::Reader;
    use super::super::register::Register;
    use super::super::source::Source;
    use super::*;
    use crate::grade::DecimalMark;
    use crate::problem::Scheme;

    /// The number of tables that are marked; `MOMENTOUS_TABLES=10000` marks a million rows.
    const TABLES: u64 = 250;

    /// The rows of each.
    const ROWS: u64 = 100;

    /// Rows behind their students, in which something may be wrong.
    const KINDS: [&str; 12] = [
        "concepts/who-is-fastest,1,,,A",
        "concepts/who-is-fastest,01,,1,B",
        "concepts/who-is-fastest,1,,2,",
        "concepts/who-is-fastest,2,,,?",
        "concepts/who-is-fastest,2-kmbtrs,,,A",
        "concepts/who-is-fastest,x,,,A",
        "concepts/who-is-fastest,1,backward,,A",
        "concepts/who-is-fastest,1,,0,A",
        "concepts/who-is-fastest,1,,,A,B",
        "concepts/who-is-fast,1,,,A",
        ",,,,",
        "concepts/who-is-fastest,1,,,\"A",
    ];

    /// A table that looks like chance (`SplitMix64`), the same for the same number.
    fn table(number: u64) -> String {
        let mut state = number.wrapping_mul(ROWS);
        let rows = (0..ROWS).map(|_| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut word = state;
            word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            let kind = KINDS[usize::try_from((word >> 32) % KINDS.len() as u64).unwrap()];
            format!("s{},{kind}\n{}", word % 30, if word.is_multiple_of(7) { "\r\n" } else { "" })
        });
        format!("student,problem,seed,form,attempt,fastest\n{}", rows.collect::<String>())
    }

    /// Counts the rows of a file by what becomes of them.
    fn counted(path: &Path, problems: Problems) -> RowCounts {
        let mut reader = Reader::new(Source::open(path).unwrap(), Register::new(problems, None, Scheme::default()));
        let mut counts = RowCounts::default();
        let (mut written, mut refused) = (0, BTreeSet::new());
        loop {
            let chunk = reader.chunk();
            if chunk.is_empty() {
                break;
            }
            for portion in marked(chunk, &reader.problems(), MarksFormat::Csv, false).unwrap() {
                counts += portion.counts;
                written += portion.rows.split(|byte| *byte == b'\n').skip(1).count() as u64;
                refused.extend(portion.marked.into_iter().filter_map(|marked| match marked {
                    Marked::Refused(Place::Line(line), _) => Some(line),
                    _ => None,
                }));
            }
        }
        counts.read = reader.read;
        assert_eq!((written, refused.len() as u64), (counts.answers, counts.refused), "{}", path.display());
        counts
    }

    #[test]
    fn of_many_random_tables_every_row_is_marked_or_refused() {
        let folder = tempfile::tempdir().unwrap();
        let mut problems = Problems::here(&[], None, DecimalMark::Point).unwrap();
        let part = problems.find("concepts/who-is-fastest").unwrap().problem.forms()[0].parts[0].id.clone();
        let tables = std::env::var("MOMENTOUS_TABLES").ok().and_then(|count| count.parse().ok()).unwrap_or(TABLES);
        let all: Vec<RowCounts> = (0..tables)
            .into_par_iter()
            .map_with(problems, |problems, number| {
                let path = folder.path().join(format!("{number}.csv"));
                std::fs::write(&path, table(number).replacen("fastest", &part, 1)).unwrap();
                let counts = counted(&path, problems.clone());
                std::fs::remove_file(&path).unwrap();
                assert!(counts.read == ROWS && counts.is_complete(), "table {number}: {counts}\n{}", table(number));
                counts
            })
            .collect();
        let sum = |count: fn(&RowCounts) -> u64| all.iter().map(count).sum::<u64>();
        assert!(sum(|counts| counts.marked) > tables * 10 && sum(|counts| counts.refused) > tables * 10);
    }
}
