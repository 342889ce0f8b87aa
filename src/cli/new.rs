//! `momentous new`

use std::fs;
use std::io::Write;
use std::path::Path;
use std::path::PathBuf;

use clap::Args;

use crate::bank::FOLDER;
use crate::exercise::titled;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;

const HELP: &str = "\
Examples:
  momentous new impact/my-carts       in problem_bank/ if it exists here, else my-carts.yaml
  momentous new homework/carts.yaml   at that path

An existing file is not changed.";

/// The problem to start from.
const TEMPLATE: &str = include_str!("new_problem.yaml");

/// Write a commented problem to start from
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct New {
    /// The problem's identity, topic/name in lower-case letters, digits and hyphens; or the path of the file
    name: String,
}

impl New {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let (id, path) = self.place();
        if !is_identity(&id) {
            return Err(Failure::unusable(format!(
                "`{id}` cannot be the identity of a problem\nhelp: write lower-case letters, digits and hyphens, with the topic before a slash: `impact/my-carts`"
            )));
        }
        let written = |error: std::io::Error| Failure::file(&path, "written", &error);
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder).map_err(written)?;
        }
        let mut file = fs::File::create_new(&path).map_err(|error| match error.kind() {
            std::io::ErrorKind::AlreadyExists => {
                Failure::unusable(format!("{} already exists; it was not changed", path.display()))
            }
            _ => written(error),
        })?;
        file.write_all(filled(&id, &path).as_bytes()).map_err(written)?;
        let shown = path.display();
        Output::whole(
            None,
            &format!(
                "{shown} has been written. Next:\n  momentous check {shown}\n  momentous generate {shown} --solution\n"
            ),
        )?;
        Ok(Exit::Fine)
    }

    /// The identity and the path of the new problem.
    fn place(&self) -> (String, PathBuf) {
        let path = Path::new(&self.name);
        if path.extension().is_some_and(|ending| ending == "yaml" || ending == "yml") {
            let word = |part: Option<&std::ffi::OsStr>| part.map(|part| part.to_string_lossy().replace('_', "-"));
            let stem = word(path.file_stem()).unwrap_or_default();
            let topic = word(path.parent().and_then(Path::file_name)).filter(|topic| is_identity(topic));
            return (topic.map_or_else(|| stem.clone(), |topic| format!("{topic}/{stem}")), path.to_owned());
        }
        let file = format!("{}.yaml", self.name);
        let bank = Path::new(FOLDER);
        let alone = || PathBuf::from(file.rsplit('/').next().unwrap_or(&file));
        (self.name.clone(), if bank.is_dir() { bank.join(&file) } else { alone() })
    }
}

/// The rule of identities, which the loader keeps too.
fn is_identity(id: &str) -> bool {
    let plain = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit();
    let word = |word: &str| !word.is_empty() && word.chars().all(plain);
    id.split('/').all(|part| part.split('-').all(word))
}

fn filled(id: &str, path: &Path) -> String {
    let topic = id.split('/').next().unwrap_or(id);
    let title = titled(id.rsplit('/').next().unwrap_or(id));
    let file = path.display().to_string();
    let fields = [("{{id}}", id), ("{{topic}}", topic), ("{{title}}", &title), ("{{file}}", &file)];
    fields.iter().fold(TEMPLATE.to_owned(), |text, (field, value)| text.replace(field, value))
}

#[cfg(test)]
mod tests {
    use crate::fault::Source;
    use crate::problem::{compile, load};

    use super::*;

    #[test]
    fn the_new_problem_is_sound_whatever_its_name() {
        for id in ["impact/my-carts", "2026", "a/b/c-1"] {
            let text = filled(id, Path::new("problem_bank/a.yaml"));
            assert!(!text.contains("{{id}}") && text.lines().all(|line| line.chars().count() <= 120));
            let problem = load(Source::new("a.yaml", &text)).and_then(|loaded| compile(loaded, None));
            assert_eq!(
                problem.map(|problem| problem.id().to_owned()).map_err(|faults| faults.to_string()),
                Ok(id.to_owned())
            );
        }
    }

    #[test]
    fn a_path_names_the_problem_too() {
        let place = |name: &str| New { name: name.into() }.place();
        assert_eq!(place("homework/two_carts.yaml"), ("homework/two-carts".into(), "homework/two_carts.yaml".into()));
        assert_eq!(place("carts.yaml").0, "carts");
        assert!(!is_identity(&place("Carts.yaml").0));
    }
}
