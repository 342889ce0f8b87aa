//! Where submissions come from: a table, a file of JSON lines, or a folder of YAML files. One at a time, in order.

use std::io::BufRead;
use std::io::BufReader;
use std::path::Path;
use std::path::PathBuf;

use serde::Deserialize;
use serde_json::Map;
use serde_json::Value;

use crate::bank::files_under;
use crate::cli::failure::Failure;
use crate::cli::table::Table;
use crate::fault::Input;

use super::submission::{Column, KEYS, Key, Place, Submission};

/// The longest submission: a line of JSON or a file that is longer is none of ours.
const LONGEST: u64 = 1 << 20;

/// A submission, or what is wrong where one should be.
pub(super) type Next = Result<Submission, (Place, String)>;

/// Submissions in the order of the input.
pub(super) enum Source {
    Table(Box<Table>, Vec<Column>),
    Lines(BufReader<Input>, u64),
    Folder(std::vec::IntoIter<PathBuf>),
}

impl Source {
    /// Opens a folder, a file of JSON lines (`.jsonl`, `.ndjson`, `.json`), or else a table.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        if path.is_dir() {
            let files = files_under(path)?;
            if files.is_empty() {
                return Err(Failure::unusable(format!("{} has no submission: no file ends in .yaml", path.display())));
            }
            return Ok(Self::Folder(files.into_iter()));
        }
        if is_json(path) {
            let file = Input::open(path).map_err(|error| Failure::file(path, "read", &error))?;
            return Ok(Self::Lines(BufReader::new(file), 0));
        }
        let table = Table::as_it_stands(path)?;
        let columns: Vec<Column> = table.headings.iter().map(|heading| Column::of(heading)).collect();
        for (needed, heading) in [(Key::Problem, "problem"), (Key::Seed, "seed")] {
            if !columns.contains(&Column::Key(needed)) {
                return Err(Failure::unusable(format!("{} has no column `{heading}`", path.display())));
            }
        }
        Ok(Self::Table(Box::new(table), columns))
    }
}

/// Whether a path is that of a file with an object on each line.
pub(super) fn is_json(path: &Path) -> bool {
    let ends = |ending: &str| path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending));
    ["jsonl", "ndjson", "json"].into_iter().any(ends)
}

impl Iterator for Source {
    type Item = Next;

    fn next(&mut self) -> Option<Next> {
        match self {
            Self::Table(table, columns) => {
                let (line, row) = table.next_row()?;
                let place = Place::Line(line);
                Some(match row {
                    Ok(row) => Ok(Submission::of_row(place, columns, row.iter())),
                    Err(message) => Err((place, message)),
                })
            }
            Self::Lines(file, line) => next_line(file, line),
            Self::Folder(files) => {
                let path = files.next()?;
                let text = Input::open(&path).and_then(|file| file.text(LONGEST)).map_err(|error| error.to_string());
                let value =
                    text.and_then(|text| serde_yaml::from_str::<Value>(&text).map_err(|error| error.to_string()));
                Some(read(Place::File(path), value))
            }
        }
    }
}

/// The next line that is not empty.
fn next_line(file: &mut BufReader<Input>, line: &mut u64) -> Option<Next> {
    loop {
        let mut text = Vec::new();
        *line += 1;
        let place = Place::Line(*line);
        match std::io::Read::take(&mut *file, LONGEST).read_until(b'\n', &mut text) {
            Ok(0) => return None,
            Ok(_) if text.trim_ascii().is_empty() => {}
            Ok(_) => {
                if text.last() != Some(&b'\n') && text.len() as u64 == LONGEST {
                    // Nobody wants the rest of it.
                    let _ = file.skip_until(b'\n');
                    return Some(Err((place, "the line is longer than a submission can be".to_owned())));
                }
                let value = serde_json::from_slice::<Value>(text.trim_ascii()).map_err(|error| error.to_string());
                return Some(read(place, value));
            }
            Err(error) => return Some(Err((place, error.to_string()))),
        }
    }
}

/// A submission as an object: the keys beside `answers`, which holds the parts.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    #[serde(default)]
    student: Value,
    problem: Value,
    #[serde(default)]
    digest: Value,
    seed: Value,
    #[serde(default)]
    form: Value,
    #[serde(default)]
    attempt: Value,
    #[serde(default)]
    hints: Value,
    #[serde(default)]
    answers: Map<String, Value>,
}

/// The submission that an object says.
fn read(place: Place, value: Result<Value, String>) -> Next {
    match value.and_then(|value| Written::deserialize(&value).map_err(|error| error.to_string())) {
        Ok(written) => {
            let mut submission = Submission::new(place);
            match written.put_into(&mut submission) {
                Ok(()) => Ok(submission),
                Err(message) => Err((submission.place, message)),
            }
        }
        Err(message) => Err((place, message)),
    }
}

impl Written {
    fn put_into(&self, submission: &mut Submission) -> Result<(), String> {
        let said =
            |name: &str, value: &Value| text(value).ok_or_else(|| format!("`{name}` is neither a text nor a number"));
        for (key, name) in KEYS {
            let value = match key {
                Key::Student => &self.student,
                Key::Problem => &self.problem,
                Key::Digest => &self.digest,
                Key::Seed => &self.seed,
                Key::Form => &self.form,
                Key::Attempt => &self.attempt,
                Key::Hints => &self.hints,
            };
            submission.put_key(key, &said(name, value)?);
        }
        for (part, answer) in &self.answers {
            submission.put_answer(part, &said(part, answer)?);
        }
        Ok(())
    }
}

fn text(value: &Value) -> Option<String> {
    match value {
        Value::Null => Some(String::new()),
        Value::String(text) => Some(text.trim().to_owned()),
        Value::Number(number) => Some(number.to_string()),
        Value::Bool(true) => Some("yes".to_owned()),
        Value::Bool(false) => Some("no".to_owned()),
        Value::Array(_) | Value::Object(_) => None,
    }
}

#[cfg(test)]
mod tests {
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
        Source::open(&path).unwrap().map(shown).collect()
    }

    #[test]
    fn a_table_and_lines_say_the_same() {
        let table = all("a.csv", "problem,seed,v\na/b,7,3 m/s\na/b,8,\n");
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
