//! Sources of submissions: a table, a file of JSON lines, or a folder of YAML files. One at a time, in order.

use std::io;
use std::io::BufReader;
use std::path::Path;
use std::path::PathBuf;

use crate::bank::files_under;
use crate::cli::failure::Failure;
use crate::cli::table;
use crate::exercise::Column;
use crate::exercise::Line;
use crate::exercise::Lines;
use crate::exercise::Place;
use crate::exercise::Submission;
use crate::exercise::Table;
use crate::fault;
use crate::fault::Input;

use super::register::Next;

/// The longest file of a submission in a folder, in bytes.
const LONGEST: u64 = 1 << 20;

/// Submissions in the order of the input.
pub(super) enum Source {
    Table(Box<Table<BufReader<Input>>>, Vec<Column>),
    Lines(Box<Lines<BufReader<Input>>>, Line),
    Folder(Vec<PathBuf>, usize),
    /// Downloads of another program, and answers to a homework: read as a whole.
    Responses(std::vec::IntoIter<(u64, Next)>),
}

impl Source {
    /// Opens a folder, a file of JSON lines (`.jsonl`, `.ndjson`, `.json`), or else a table.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        if path.is_dir() {
            let files = files_under(path)?;
            if files.is_empty() {
                return Err(Failure::unusable(format!("{} has no submission: no file ends in .yaml", path.display())));
            }
            return Ok(Self::Folder(files, 0));
        }
        if is_json(path) {
            let lines = table::input(path).and_then(Lines::of);
            let lines = lines.map_err(|error| Failure::file(path, "read", &error))?;
            return Ok(Self::Lines(Box::new(lines), Line::default()));
        }
        let table = table::open(path)?;
        let columns = Column::all(table.headings());
        let columns = columns.map_err(|message| Failure::unusable(format!("{}: {message}", path.display())))?;
        Ok(Self::Table(Box::new(table), columns))
    }

    /// The next submission with its number, from which [`Source::place`] tells where it stands.
    pub(super) fn next(&mut self) -> Option<(u64, Next)> {
        match self {
            Self::Table(table, columns) => {
                let (line, row) = table.next_row()?;
                let read = row.and_then(|row| Submission::of_row(Place::Line(line), columns, row.cells()));
                Some((line, read.map_err(|message| (Place::Line(line), message))))
            }
            Self::Lines(lines, line) => next_line(lines, line),
            Self::Responses(all) => all.next(),
            Self::Folder(files, next) => {
                let path = files.get(*next)?;
                *next += 1;
                Some((*next as u64 - 1, file(path).map_err(|message| (Place::File(path.clone()), message))))
            }
        }
    }

    /// The byte at which the submission begins that came last.
    pub(super) fn last_place(&self) -> u64 {
        match self {
            Self::Table(table, _) => table.last_place(),
            Self::Lines(_, line) => line.place,
            Self::Folder(..) | Self::Responses(..) => 0,
        }
    }

    /// Goes to the submission with that number, which begins at that byte.
    pub(super) fn go_to(&mut self, place: u64, number: u64) -> io::Result<()> {
        match self {
            Self::Table(table, _) => table.go_to(place, number),
            Self::Lines(lines, _) => lines.go_to(place, number),
            Self::Responses(..) => Err(io::ErrorKind::Unsupported.into()),
            Self::Folder(_, next) => {
                *next = usize::try_from(number).map_err(io::Error::other)?;
                Ok(())
            }
        }
    }

    /// The place of the submission with that number.
    pub(super) fn place(&self, number: u64) -> Place {
        match self {
            Self::Table(..) | Self::Lines(..) | Self::Responses(..) => Place::Line(number),
            Self::Folder(files, _) => {
                let file = usize::try_from(number).ok().and_then(|number| files.get(number));
                Place::File(file.cloned().unwrap_or_default())
            }
        }
    }
}

/// Whether a path is that of a file with an object on each line.
pub(super) fn is_json(path: &Path) -> bool {
    let ends = |ending: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(ending));
    ["jsonl", "ndjson", "json"].into_iter().any(ends)
}

/// The submission on the next line that is not empty.
fn next_line(lines: &mut Lines<BufReader<Input>>, line: &mut Line) -> Option<(u64, Next)> {
    loop {
        let read = match lines.read(line) {
            Ok(false) => return None,
            Err(error) => Err(error.to_string()),
            Ok(true) if line.bytes.trim_ascii().is_empty() => continue,
            Ok(true) if line.is_cut => Err(format!("the line is longer than {LONGEST} bytes")),
            Ok(true) => {
                let text = std::str::from_utf8(&line.bytes).map_err(|_| "the line is not UTF-8".to_owned());
                text.and_then(|text| Submission::of_json(Place::Line(line.number), text))
            }
        };
        return Some((line.number, read.map_err(|message| (Place::Line(line.number), message))));
    }
}

fn file(path: &Path) -> Result<Submission, String> {
    // Whoever hands in a link chooses what is read.
    if path.is_symlink() {
        return Err("this is a link, and is not followed: a submission is a file of its own".to_owned());
    }
    let text = Input::open(path).and_then(|input| input.text(LONGEST)).map_err(|error| error.to_string())?;
    Submission::of_yaml(Place::File(path.to_owned()), &fault::Source::new(&path.display().to_string(), &text))
}

#[cfg(test)]
mod tests {
    use crate::exercise::Key;

    use super::*;

    fn all(name: &str, text: &str) -> Vec<Result<String, String>> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        let shown = |next: Next| match next {
            Ok(submission) => {
                let answers: Vec<_> = submission.answers().map(|(part, answer)| format!("{part}={answer}")).collect();
                Ok(format!("{} {} {}", submission.place, submission.key(Key::Seed), answers.join(" ")))
            }
            Err((place, message)) => Err(format!("{place}: {message}")),
        };
        let mut source = Source::open(&path).unwrap();
        std::iter::from_fn(|| source.next()).map(|(_, next)| shown(next)).collect()
    }

    #[test]
    fn a_table_and_lines_say_the_same() {
        let table = all("a.csv", "problem,seed,v\r\na/b,7,3 m/s\r\na/b,8,\r\n");
        let lines = all(
            "a.jsonl",
            "{\"problem\":\"a/b\",\"seed\":7,\"answers\":{\"v\":\"3 m/s\"}}\n\n{\"problem\":\"a/b\",\"seed\":\"8\"}\n",
        );
        assert_eq!(table, [Ok("2 7 v=3 m/s".to_owned()), Ok("3 8 ".to_owned())]);
        assert_eq!(lines, [Ok("1 7 v=3 m/s".to_owned()), Ok("3 8 ".to_owned())]);
    }

    #[test]
    fn a_bad_line_does_not_stop_the_rest() {
        let lines =
            all("a.jsonl", "{\n{\"problem\":1,\"seed\":2,\"answers\":{\"v\":[]}}\n{\"problem\":\"a/b\",\"seed\":2}\n");
        assert!(lines[0].as_ref().unwrap_err().starts_with("1: EOF"), "{lines:?}");
        assert_eq!(lines[1], Err("2: `v` is neither a text nor a number".to_owned()));
        assert_eq!(lines[2], Ok("3 2 ".to_owned()));
    }
}
