//! Responses of students in other programs: the tables that Moodle and Canvas download, read by the codes in them.

use std::collections::BTreeMap;

use super::coded::Coded;

/// The text where nothing was answered.
const NOTHING: &str = "-";

/// The headings under which students are known, the surest first: those of Moodle, then those of Canvas.
const STUDENTS: [&str; 6] = ["ID number", "Email address", "Username", "sis_id", "id", "name"];

/// The headings under which the number of an attempt stands, as Canvas and Brightspace write them.
const ATTEMPTS: [&str; 3] = ["attempt", "Attempt #", "Attempt number"];

/// A table of responses, known by its headings.
///
/// In Moodle's table the text of a question, in which its code stands, is a cell of the row, and the response to it stands under a
/// heading with the same number. In that of Canvas, the text is the heading, and the response stands under it.
#[derive(Debug)]
pub struct Responses<'c> {
    codes: BTreeMap<&'c str, &'c Coded>,
    headings: Vec<String>,
    student: usize,
}

/// The response of a student to a variant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Response<'c> {
    /// The student who answered.
    pub student: String,
    /// The variant.
    pub coded: &'c Coded,
    /// The typed texts, by the names of fields.
    pub typed: Vec<(String, String)>,
}

impl<'c> Responses<'c> {
    /// A table with these headings. Students are known by the column of that name, or else by the first of the usual ones.
    ///
    /// # Errors
    /// Where there is no such column.
    pub fn new(codes: &'c [Coded], headings: &[String], student: Option<&str>) -> Result<Self, String> {
        let place = |name: &str| headings.iter().position(|heading| heading.trim().eq_ignore_ascii_case(name));
        let known = match student {
            Some(name) => place(name),
            None => STUDENTS.iter().find_map(|name| place(name)),
        };
        let student = known.ok_or_else(|| {
            let wanted = student.map_or_else(|| STUDENTS.join("`, `"), str::to_owned);
            format!("there is no column `{wanted}`\nhelp: name the column by which students are known with --student")
        })?;
        let codes = codes.iter().map(|coded| (coded.code.as_str(), coded)).collect();
        Ok(Self { codes, headings: headings.to_vec(), student })
    }

    /// The heading under which students are known.
    #[must_use]
    pub fn student(&self) -> &str {
        self.headings.get(self.student).map_or("", String::as_str)
    }

    /// Whether the questions stand in the headings, as in Canvas.
    #[must_use]
    pub fn is_of_canvas(&self) -> bool {
        self.headings.iter().any(|heading| self.code_in(heading).is_some())
    }

    /// The number of the attempt, where the table says it.
    #[must_use]
    pub fn attempt(&self, cells: &[&str]) -> Option<u64> {
        let is_number = |heading: &String| ATTEMPTS.iter().any(|name| heading.trim().eq_ignore_ascii_case(name));
        cells.get(self.headings.iter().position(is_number)?)?.trim().parse().ok()
    }

    /// The responses in a row.
    #[must_use]
    pub fn of_row(&self, cells: &[&str]) -> Vec<Response<'c>> {
        let student = cells.get(self.student).copied().unwrap_or_default().trim();
        let mut all: Vec<Response<'c>> = Vec::new();
        if student.is_empty() {
            return all;
        }
        let response = |coded, typed| Response { student: student.to_owned(), coded, typed };
        for (place, (cell, heading)) in cells.iter().zip(&self.headings).enumerate() {
            if let Some((coded, _)) = self.code_in(cell) {
                let text = cells.iter().zip(&self.headings).skip(place + 1);
                let other = text
                    .filter(|(_, cell_text)| number_of(cell_text) == number_of(heading))
                    .map(|(cell, _)| *cell)
                    .next();
                let fields: Vec<&str> = coded.fields().collect();
                all.push(response(coded, split(other.unwrap_or_default(), &fields)));
            } else if let Some((coded, Some(field))) = self.code_in(heading).filter(|_| !cell.trim().is_empty()) {
                let typed = (field, (*cell).to_owned());
                match all.iter_mut().find(|response| response.coded == coded) {
                    Some(response) => response.typed.push(typed),
                    None => all.push(response(coded, vec![typed])),
                }
            }
        }
        all
    }

    /// Whether a row has variants and nobody who answered them.
    #[must_use]
    pub fn answers_for_nobody(&self, cells: &[&str]) -> bool {
        let nobody = cells.get(self.student).is_none_or(|cell| cell.trim().is_empty());
        let answered = |heading: &str, cell: &str| {
            self.code_in(cell).is_some() || self.code_in(heading).is_some() && !cell.trim().is_empty()
        };
        nobody && cells.iter().zip(&self.headings).any(|(cell, heading)| answered(heading, cell))
    }

    /// The variant whose code stands in square brackets, and the field, where that is named behind it.
    fn code_in(&self, text: &str) -> Option<(&'c Coded, Option<String>)> {
        text.split('[').skip(1).find_map(|rest| {
            let (inside, _) = rest.split_once(']')?;
            let (code, field) = inside.split_once('-').map_or((inside, None), |(code, field)| (code, Some(field)));
            Some((*self.codes.get(code)?, field.map(str::to_owned)))
        })
    }
}

/// The number with which a heading ends, such as `Response 3`.
fn number_of(heading: &str) -> &str {
    let heading = heading.trim();
    &heading[heading.trim_end_matches(|letter: char| letter.is_ascii_digit()).len()..]
}

/// A response by its fields. Of several, Moodle writes `part 1: 9.6; part 2: 3`, in the language of the course.
fn split(response: &str, fields: &[&str]) -> Vec<(String, String)> {
    let response = response.trim();
    if response == NOTHING || response.is_empty() {
        return Vec::new();
    }
    if let [only] = fields {
        return vec![((*only).to_owned(), response.to_owned())];
    }
    let mut typed: Vec<(String, String)> = Vec::new();
    for piece in response.split("; ") {
        let head = piece.split_once(':').and_then(|(head, text)| {
            let number: usize = number_of(head).parse().ok()?;
            Some(((*fields.get(number.checked_sub(1)?)?).to_owned(), text.trim().to_owned()))
        });
        match (head, typed.last_mut()) {
            (Some(next), _) => typed.push(next),
            (None, Some((_, text))) => text.extend(["; ", piece]),
            (None, None) => {}
        }
    }
    typed.retain(|(_, text)| !text.is_empty() && text != NOTHING);
    typed
}

#[cfg(test)]
mod tests {
    use super::super::coded::CodedPart;
    use super::*;

    fn coded(code: &str) -> Coded {
        let part = |id: &str, answer: &str, fields: &[&str]| CodedPart {
            id: id.to_owned(),
            answer: answer.to_owned(),
            fields: fields.iter().map(|field| (*field).to_owned()).collect(),
        };
        let parts =
            vec![part("v", "{} m/s", &["a"]), part("p", "({}, {}) kg m/s", &["b1", "b2"]), part("k", "{}", &["c"])];
        let text = str::to_owned;
        Coded {
            code: text(code),
            problem: text("a/b"),
            digest: None,
            scheme: None,
            given: None,
            form: None,
            seed: text("7"),
            parts,
        }
    }

    /// The student, the code and the answers of a response.
    type Read = (String, String, Vec<(String, String)>);

    fn read(headings: &str, row: &str) -> Vec<Read> {
        let codes = [coded("bcdf"), coded("ghjk")];
        let headings: Vec<String> = headings.split('|').map(str::to_owned).collect();
        let responses = Responses::new(&codes, &headings, None).unwrap();
        let cells: Vec<&str> = row.split('|').collect();
        let row = responses.of_row(&cells).into_iter();
        row.map(|response| (response.student, response.coded.code.clone(), response.coded.answers(&response.typed)))
            .collect()
    }

    fn answers(all: &[(&str, &str)]) -> Vec<(String, String)> {
        all.iter().map(|(id, text)| ((*id).to_owned(), (*text).to_owned())).collect()
    }

    #[test]
    fn responses_of_moodle_are_found_by_the_question_in_the_row() {
        let found = read(
            "Nachname|Email address|Frage 1|Antwort 1|Richtige Antwort 1|Frage 2|Antwort 2",
            "Meier|m@x|Two carts [ghjk] Find|Teil 1: -0,4; Teil 2: 1; Teil 3: 2.5; Teil 4: to the left; slowly|x|[bcdf]|-",
        );
        let first = answers(&[("v", "-0,4 m/s"), ("p", "(1, 2.5) kg m/s"), ("k", "to the left; slowly")]);
        assert_eq!(found[0], ("m@x".to_owned(), "ghjk".to_owned(), first));
        assert_eq!(found[1], ("m@x".to_owned(), "bcdf".to_owned(), Vec::new()));
    }

    #[test]
    fn responses_of_canvas_are_found_by_the_question_in_the_heading() {
        let found =
            read("name|id|11: Carts [bcdf-a] Find v|2.0|12: Carts [ghjk-c] Which|1.0", "M|17|3.5|2|to the left|1");
        let expected = [("bcdf", answers(&[("v", "3.5 m/s")])), ("ghjk", answers(&[("k", "to the left")]))];
        assert_eq!(found, expected.map(|(code, typed)| ("17".to_owned(), code.to_owned(), typed)));
    }

    #[test]
    fn a_table_without_students_is_refused() {
        let message = Responses::new(&[], &["Grade".to_owned()], None).unwrap_err();
        assert!(message.starts_with("there is no column `ID number`, `Email address`"), "{message}");
        assert!(Responses::new(&[], &["Grade".to_owned()], Some("grade")).is_ok());
    }
}
