//! Responses that other programs downloaded, as submissions.

use std::path::Path;

use serde_json::json;

use crate::cli::failure::Failure;
use crate::cli::failure::tell;
use crate::cli::table;
use crate::exercise::Place;
use crate::exercise::Rows;
use crate::exercise::Submission;
use crate::export::Coded;
use crate::export::Response;
use crate::export::Responses;
use crate::fault::Input;
use crate::problem::Scheme;

use super::gradebook::{Numbers, Students};
use super::register::Next;

/// The longest file of codes, in bytes.
const LARGEST: u64 = 1 << 28;

/// Submissions with the lines on which they stand.
pub(super) struct ReadResponses {
    pub submissions: Vec<(u64, Next)>,
    /// How their students are known.
    pub students: Students,
    pub numbers: Numbers,
}

/// The submissions in a table of responses. Those of a student to the same variant stand together.
pub(super) fn read(path: &Path, codes: &Path, student: Option<&str>) -> Result<ReadResponses, Failure> {
    let codes = self::codes(codes)?;
    let failed = |message: String| table::failure(path, &message);
    let input = table::input(path).map_err(|error| Failure::file(path, "read", &error))?;
    let mut rows = Rows::read(input).map_err(failed)?;
    let (_, row) = rows.next_row().ok_or_else(|| failed("it is empty, without even headings".to_owned()))?;
    let headings: Vec<String> = row.map_err(failed)?.cells().map(str::to_owned).collect();
    let responses = Responses::new(&codes, &headings, student).map_err(failed)?;
    let mut read_rows: Vec<(String, &str, u64, Next)> = Vec::new();
    let mut numbers = Numbers::new();
    while let Some((line, row)) = rows.next_row() {
        match row {
            Ok(row) => {
                let cells: Vec<&str> = row.cells().collect();
                numbers.extend(responses.attempt(&cells).map(|number| (line, number)));
                if responses.answers_for_nobody(&cells) {
                    let message = format!(
                        "nothing stands under `{}`, by which students are known\nhelp: fill it in, or name another column with --student",
                        responses.student()
                    );
                    read_rows.push((String::new(), "", line, Err((Place::Line(line), message))));
                }
                for response in responses.of_row(&cells) {
                    let (code, next) = (response.coded.code.as_str(), submission(line, &response));
                    read_rows.push((response.student, code, line, next));
                }
            }
            Err(message) => read_rows.push((String::new(), "", line, Err((Place::Line(line), message)))),
        }
    }
    if read_rows.is_empty() {
        return Err(failed(
            "no code of an exported variant stands in it\n\
             help: let Moodle download the text of the questions, too; Canvas writes it into the headings"
                .to_owned(),
        ));
    }
    tell(&format!("note: students are known by `{}`", responses.student()));
    read_rows.sort_by(|left, right| (&left.0, left.1).cmp(&(&right.0, right.1)));
    let known_by = responses.student().to_owned();
    let students = if responses.is_of_canvas() { Students::Canvas(known_by) } else { Students::Column(known_by) };
    let submissions = read_rows.into_iter().map(|(_, _, line, next)| (line, next)).collect();
    Ok(ReadResponses { submissions, students, numbers })
}

/// Reads the file that `momentous export --codes` wrote.
fn codes(path: &Path) -> Result<Vec<Coded>, Failure> {
    let text = Input::open(path).and_then(|input| input.text(LARGEST));
    let text = text.map_err(|error| Failure::file(path, "read", &error))?;
    let lines = text.lines().zip(1..).filter(|(line, _)| !line.trim().is_empty());
    let coded = |(line, number): (&str, u64)| {
        serde_json::from_str(line).map_err(|error| table::failure(path, &format!("line {number}: {error}")))
    };
    lines.map(coded).collect()
}

fn submission(line: u64, response: &Response<'_>) -> Next {
    let Coded { problem, digest, scheme, given, form, seed, .. } = response.coded;
    let answers: serde_json::Map<String, serde_json::Value> =
        response.coded.answers(&response.typed).into_iter().map(|(part, text)| (part, text.into())).collect();
    let mut object = json!({ "student": response.student, "problem": problem, "seed": seed, "answers": answers });
    // Codes of earlier programs are of the first scheme.
    object["scheme"] = json!(scheme.unwrap_or(Scheme::Solvable.number()));
    for (key, value) in [("digest", digest), ("given", given), ("form", form)] {
        if let Some(value) = value {
            object[key] = json!(value);
        }
    }
    Submission::of_json(Place::Line(line), &object.to_string()).map_err(|message| (Place::Line(line), message))
}
