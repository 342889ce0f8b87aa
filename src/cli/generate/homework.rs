//! Sheets with all problems of a homework.

use std::sync::Arc;

use crate::cli::failure::Failure;
use crate::cli::failure::tell;
use crate::cli::open;
use crate::cli::output::file_stem;

use super::asked::Asked;
use super::destination::Destination;
use super::job::Wanted;

/// The table into which answers are written.
const ANSWERS: &str = "answers.csv";

/// The questions on each sheet: the problems of the homework where one is named, else one problem, in the form of that name.
pub(super) fn wanted(names: &[String], form: Option<&str>, secret: Option<&[u8]>) -> Result<Wanted, Failure> {
    let Some((source, homework)) = open::homework(names, secret)? else {
        let problems = open::problems(names, secret)?;
        return Ok(Wanted::Each(Asked::all(&problems, form)?));
    };
    if form.is_some() {
        return Err(Failure::unusable("--form is for problems\nhelp: name the forms in the file of the homework"));
    }
    let name = std::path::Path::new(&*source.name).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let asked = Asked::of_homework(&homework, &file_stem(&name));
    Ok(Wanted::Together(Arc::new(homework), asked))
}

/// Writes the empty table of answers, unless one is there: somebody may have filled it in.
pub(super) fn write_answers(destination: &Destination, text: &str) -> Result<(), Failure> {
    let path = destination.for_teacher()?.join(ANSWERS);
    if path.exists() {
        tell(&format!("note: {} exists; it was not changed", path.display()));
        return Ok(());
    }
    destination.write_for_teacher(ANSWERS, text)
}
