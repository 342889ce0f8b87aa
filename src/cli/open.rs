//! From what a user names to a compiled problem and one of its forms.

use std::path::Path;
use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;

use crate::bank::Bank;
use crate::bank::Homework;
use crate::bank::load_in_course;
use crate::exercise::SheetSeed;
use crate::fault::Input;
use crate::fault::Source;
use crate::fault::unknown_name;
use crate::problem::Problem;
use crate::problem::compile;
use crate::problem::is_guessable;

use super::failure::Failure;
use super::failure::tell;

/// The number of a seed, where the problem was compiled with the secret whose mark the seed has.
pub(super) fn seed(seed: &SheetSeed, problem: &Problem) -> Result<u64, Failure> {
    seed.of(problem).map_err(|message| Failure::unusable(format!("--seed {seed}: {message}")))
}

/// The longest secret that is read, in bytes.
const LONGEST_SECRET: u64 = 64 * 1024;

/// A secret of the course.
#[derive(Args, Clone, Debug, Default)]
pub(super) struct Secret {
    /// A file with the secret of the course: without it, nobody who has the program can draw the same numbers
    #[arg(long, value_name = "FILE")]
    secret: Option<PathBuf>,
}

impl Secret {
    /// Its path, if it has one.
    pub(super) fn path(&self) -> Option<&Path> {
        self.secret.as_deref()
    }

    /// The secret, without the line end that an editor leaves.
    pub(super) fn read(&self) -> Result<Option<Vec<u8>>, Failure> {
        let Some(path) = &self.secret else { return Ok(None) };
        let bytes = Input::open(path).and_then(|file| file.bytes(LONGEST_SECRET));
        let bytes = bytes.map_err(|error| Failure::file(path, "read", &error))?;
        let secret = bytes.trim_ascii_end();
        if secret.is_empty() {
            return Err(Failure::unusable(format!("{} contains no secret", path.display())));
        }
        if is_guessable(secret) {
            tell(&format!(
                "warning: the secret in {} can be guessed: anyone with one sheet can try secrets until they give its numbers\n\
                 help: `momentous secret` writes one that cannot be guessed; sheets made with the old secret still need the old one",
                path.display()
            ));
        }
        Ok(Some(secret.to_vec()))
    }
}

/// Loads and compiles a problem file.
pub(super) fn compiled(source: Source, secret: Option<&[u8]>) -> Result<Arc<Problem>, Failure> {
    let problem = load_in_course(source).and_then(|loaded| compile(loaded, secret))?;
    Ok(Arc::new(problem))
}

/// The problems that a user names, each compiled; every failure is told.
pub(super) fn problems(names: &[String], secret: Option<&[u8]>) -> Result<Vec<Arc<Problem>>, Failure> {
    let bank = Bank::here()?;
    let mut problems = Vec::new();
    let mut failures = Vec::new();
    for source in bank.select(names)? {
        match compiled(source, secret) {
            Ok(problem) => problems.push(problem),
            Err(failure) => failures.push(failure),
        }
    }
    if failures.is_empty() { Ok(problems) } else { Err(Failure::all(failures)) }
}

/// The homework whose file a user names, with the file; nothing where problems are named. It stands alone.
pub(super) fn homework(names: &[String], secret: Option<&[u8]>) -> Result<Option<(Source, Homework)>, Failure> {
    let bank = Bank::here()?;
    for name in names.iter().filter(|name| Path::new(name).is_file()) {
        let source = bank.open(name)?;
        if !Homework::is(&source) {
            continue;
        }
        if names.len() > 1 {
            return Err(Failure::unusable(format!(
                "{name} is a homework, which makes sheets of its own\nhelp: name it alone, or name problems"
            )));
        }
        let homework = Homework::of(&source, &bank, secret)?;
        return Ok(Some((source, homework)));
    }
    Ok(None)
}

/// The one problem that a user names.
pub(super) fn problem(name: &str, secret: Option<&[u8]>) -> Result<Arc<Problem>, Failure> {
    compiled(Bank::here()?.open(name)?, secret)
}

/// The position of the form that a user names, or of the first.
pub(super) fn form(problem: &Problem, name: Option<&str>) -> Result<usize, Failure> {
    problem.form(name).ok_or_else(|| {
        let names: Vec<&str> = problem.forms().iter().filter_map(|form| form.question.name.as_deref()).collect();
        unknown(name.unwrap_or_default(), &format!("form of {}", problem.id()), &names)
    })
}

/// A name that is none of the known ones, with the nearest.
pub(super) fn unknown(name: &str, what: &str, known: &[&str]) -> Failure {
    Failure::unusable(unknown_name(name, what, known))
}
