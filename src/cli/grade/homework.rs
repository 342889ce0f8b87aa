//! Answers to a homework: a row for each attempt of a student, a column for each part of each problem.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use crate::bank::{Homework, Slot};
use crate::cli::failure::Failure;
use crate::cli::generate::NUMBER;
use crate::cli::table;
use crate::exercise::{Column, HandedOut, Key, Listed, Place, SeedSource, Submission, VariantRef, excerpt};
use crate::problem::{Scheme, part_letter};
use crate::render::SeedWord;

use super::register::Next;
use super::worth::Worths;

/// The columns of answers that say no answer.
const STUDENT: &str = "student";
const NAME: &str = "name";
const ATTEMPT: &str = "attempt";

/// Which problem of which student was drawn from which seed: by student and number.
pub(super) type Drawn = BTreeMap<(String, usize), Variant>;

/// A variant as a table of seeds says it.
#[derive(Clone, Debug)]
pub(super) struct Variant {
    problem: String,
    form: String,
    seed: String,
}

/// Answers to a homework, as submissions to its problems.
pub(super) struct Answers {
    pub(super) submissions: Vec<(u64, Next)>,
    pub(super) worths: Worths,
    /// The title of the homework.
    pub(super) title: String,
}

/// The sheets of a homework in a table of seeds.
pub(super) fn drawn(path: &Path, homework: &Homework) -> Result<Drawn, Failure> {
    let mut seeds = table::whole(path)?;
    let failed = |message: String| table::failure(path, &message);
    let needed = |column: Result<Option<usize>, String>, heading: &str| {
        let help = "give the seeds.csv that `momentous generate` wrote for this homework";
        column.and_then(|column| column.ok_or_else(|| format!("there is no column `{heading}`\nhelp: {help}")))
    };
    let [student, problem, form, seed, number] = [STUDENT, "problem", "form", "seed", NUMBER]
        .map(|heading| needed(seeds.column(heading), heading).map_err(&failed));
    let (student, problem, form, seed, number) = (student?, problem?, form?, seed?, number?);
    let mut drawn = Drawn::new();
    while let Some((line, row)) = seeds.next_row() {
        let row = row.map_err(&failed)?;
        let cell = |column: usize| row.cell(column).to_owned();
        let number: usize = row.cell(number).parse().unwrap_or(0);
        let variant = Variant { problem: cell(problem), form: cell(form), seed: cell(seed) };
        let is_same = |slot: &Slot| {
            [slot.problem.id(), slot.problem.drawn_as()].contains(&variant.problem.as_str())
                && slot.form_name() == variant.form
        };
        let slot = number.checked_sub(1).and_then(|place: usize| homework.slots.get(place));
        if !slot.is_some_and(is_same) {
            return Err(failed(format!(
                "line {line}: problem {} of the sheet is {} {}, and in the homework it is another\n\
                 help: mark these sheets by the homework as it was when they were made; to add a problem, append it",
                row_number(number),
                excerpt(&variant.problem),
                excerpt(&variant.form)
            )));
        }
        drawn.insert((cell(student), number), variant);
    }
    Ok(drawn)
}

fn row_number(number: usize) -> String {
    if number == 0 { "without a number".to_owned() } else { number.to_string() }
}

/// The sheets of a homework that were made for these students.
pub(super) fn derived(
    students: &[String],
    homework: &Homework,
    seeds: SeedSource<'_>,
    scheme: Scheme,
) -> (Drawn, Listed) {
    let (mut drawn, mut listed) = (Drawn::new(), Listed::default());
    for student in students {
        for (slot, number) in homework.slots.iter().zip(1..) {
            let seed = slot.seed(student, seeds);
            let variant = VariantRef { problem: slot.problem.id(), form: slot.form_name(), seed };
            listed.add(student, variant, HandedOut { scheme, given: None });
            let (problem, form) = (variant.problem.to_owned(), variant.form.to_owned());
            drawn.insert((student.clone(), number), Variant { problem, form, seed: SeedWord(seed).to_string() });
        }
    }
    (drawn, listed)
}

/// Reads a table of answers. All problems of a homework are marked, those without an answer, too.
pub(super) fn answers(path: &Path, homework: &Homework, drawn: &Drawn) -> Result<Answers, Failure> {
    let mut table = table::whole(path)?;
    let failed = |message: String| table::failure(path, &message);
    let columns = columns(table.headings(), homework).map_err(failed)?;
    let mut firsts: BTreeMap<String, u64> = BTreeMap::new();
    let mut rows: Vec<((u64, usize, u64), Next)> = Vec::new();
    let mut worths = Worths::new();
    while let Some((line, row)) = table.next_row() {
        let cells: Vec<String> = match row {
            Ok(row) => (0..columns.len()).map(|column| row.cell(column).to_owned()).collect(),
            Err(message) => {
                rows.push(((line, 0, line), Err((Place::Line(line), message))));
                continue;
            }
        };
        let said = |wanted: &Heading| {
            let place = columns.iter().position(|column| column == wanted);
            place.and_then(|place| cells.get(place)).map_or("", String::as_str)
        };
        let student = said(&Heading::Student);
        let first = *firsts.entry(student.to_owned()).or_insert(line);
        if !drawn.keys().any(|(sitter, _)| sitter == student) {
            let message = format!("no sheet of this homework was made for `{}`", excerpt(student));
            rows.push(((first, 0, line), Err((Place::Line(line), message))));
            continue;
        }
        for (slot, number) in homework.slots.iter().zip(1..) {
            let Some(variant) = drawn.get(&(student.to_owned(), number)) else { continue };
            let keys = [student, &variant.problem, &variant.form, &variant.seed];
            worths.insert(keys.map(str::to_owned), Arc::new(slot.worth.clone()));
            let mut named: Vec<Column> =
                [Key::Student, Key::Problem, Key::Form, Key::Seed, Key::Attempt].map(Column::Key).to_vec();
            let mut texts: Vec<&str> = keys.into_iter().chain([said(&Heading::Attempt)]).collect();
            for (heading, cell) in columns.iter().zip(&cells) {
                if let Heading::Part(of_sheet, part) = heading
                    && *of_sheet == number
                {
                    named.push(Column::Part(part.clone()));
                    texts.push(cell);
                }
            }
            let next = Submission::of_row(Place::Line(line), &named, texts.into_iter());
            rows.push(((first, number, line), next.map_err(|message| (Place::Line(line), message))));
        }
    }
    // Attempts at one problem stand together.
    rows.sort_by_key(|(place, _)| *place);
    let submissions = rows.into_iter().map(|((.., line), next)| (line, next)).collect();
    Ok(Answers { submissions, worths, title: homework.title.clone() })
}

/// Headings of tables, and what stands under each.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Heading {
    Student,
    Attempt,
    /// A column for people.
    Nothing,
    /// The number of the problem, and the name of its part.
    Part(usize, String),
}

/// Reads the headings: `2.v_A2` is the part `v_A2` of problem 2, and `2a` its first part, as the sheet letters them.
fn columns(headings: &[String], homework: &Homework) -> Result<Vec<Heading>, String> {
    let columns = headings.iter().map(|heading| match heading.trim() {
        STUDENT => Ok(Heading::Student),
        ATTEMPT => Ok(Heading::Attempt),
        NAME | "" => Ok(Heading::Nothing),
        other => part(other, homework).ok_or_else(|| {
            format!(
                "`{}` is no part of this homework\nhelp: write the number of the problem and the part: {}",
                excerpt(other),
                examples(homework)
            )
        }),
    });
    let columns = columns.collect::<Result<Vec<Heading>, String>>()?;
    if !columns.contains(&Heading::Student) {
        return Err(format!("there is no column `{STUDENT}`"));
    }
    let twice = columns
        .iter()
        .enumerate()
        .find(|(place, column)| **column != Heading::Nothing && columns[..*place].contains(column));
    twice.map_or(Ok(()), |(place, _)| {
        Err(format!("the column `{}` is there twice\nhelp: remove one of them", headings[place].trim()))
    })?;
    Ok(columns)
}

fn part(heading: &str, homework: &Homework) -> Option<Heading> {
    let digits = heading.bytes().take_while(u8::is_ascii_digit).count();
    let (number, name) = heading.split_at(digits);
    let number: usize = number.parse().ok()?;
    let parts = &homework.slots.get(number.checked_sub(1)?)?.asked()?.parts;
    let part = match name.strip_prefix('.') {
        Some(id) => parts.iter().find(|part| part.id == id.trim())?,
        None => parts.iter().enumerate().find(|(place, _)| name.eq_ignore_ascii_case(&part_letter(*place)))?.1,
    };
    Some(Heading::Part(number, part.id.clone()))
}

fn examples(homework: &Homework) -> String {
    let parts = homework.slots.iter().zip(1..).filter_map(|(slot, number)| {
        let first = slot.asked()?.parts.first()?;
        Some(format!("`{number}.{}` or `{number}a`", first.id))
    });
    parts.take(2).collect::<Vec<_>>().join(", ")
}
