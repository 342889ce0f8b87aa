//! `momentous init`

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;

use crate::bank::Bank;
use crate::bank::COURSE_FILE;
use crate::bank::FOLDER;
use crate::problem::{homework_schema, json_schema};

use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::cli::output::Output;

const HELP: &str = "\
Examples:
  momentous init                in the current folder
  momentous init physics-1      in a new folder

It writes two problems and a homework to start from, the settings of the course, the schema for editors, and jobs for GitHub and GitLab that check
every change. A file that exists is not changed.";

/// The problems to start from.
const PROBLEMS: [&str; 2] = ["impact/two-carts", "impulse/softball-hit"];

/// The files of a new repository besides its problems.
const FILES: [(&str, &str); 6] = [
    ("problem_bank/course.yaml", include_str!("course.yaml")),
    ("homework/week-1.yaml", include_str!("homework.yaml")),
    (".github/workflows/problems.yml", include_str!("github.yml")),
    (".gitlab-ci.yml", include_str!("gitlab.yml")),
    (".vscode/settings.json", include_str!("vscode.json")),
    ("README.md", include_str!("README.md")),
];

/// The schema of problem files, where editors find it.
const SCHEMA: &str = "momentous.schema.json";

/// The same for homework.
const HOMEWORK_SCHEMA: &str = "homework.schema.json";

/// Make a course repository: problems to start from, settings, and jobs that check every change
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Init {
    /// The folder of the repository
    #[arg(value_name = "FOLDER", default_value = ".")]
    folder: PathBuf,
}

impl Init {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let mut files: Vec<(PathBuf, String)> = Vec::new();
        let bank = Bank::built_in();
        for id in PROBLEMS {
            files.push((Path::new(FOLDER).join(format!("{id}.yaml")), bank.find(id)?.text.to_string()));
        }
        files.push((PathBuf::from(SCHEMA), format!("{:#}\n", json_schema())));
        files.push((PathBuf::from(HOMEWORK_SCHEMA), format!("{:#}\n", homework_schema())));
        files.extend(FILES.map(|(path, text)| (PathBuf::from(path), text.replace("{{course}}", COURSE_FILE))));
        let mut output = Output::to(None)?;
        for (path, text) in files {
            let path = if self.folder == Path::new(".") { path } else { self.folder.join(path) };
            if path.exists() {
                writeln!(output, "{} exists; it was not changed", path.display())?;
            } else {
                Output::whole(Some(&path), &text)?;
                writeln!(output, "{} has been written", path.display())?;
            }
        }
        let to =
            if self.folder == Path::new(".") { String::new() } else { format!("  cd {}\n", self.folder.display()) };
        write!(output, "Next:\n{to}  momentous check\n  momentous new impact/my-carts\n")?;
        output.finish()?;
        Ok(Exit::Fine)
    }
}
