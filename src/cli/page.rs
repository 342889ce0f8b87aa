//! `momentous page`

use std::path::{Path, PathBuf};

use clap::Args;

use crate::bank::Bank;
use crate::bank::course_file;
use crate::export::{ENGINE_FILE, PAGE_FILE, PageProblem, PracticePage, Reported};
use crate::fault::Source;

use super::exit::Exit;
use super::failure::Failure;
use super::open;
use super::output::Output;
use super::pages;

const HELP: &str = "\
Examples:
  momentous page impact/two-carts bouncing -o practice.html   one file, to be opened from a mail, a disk or a platform
  momentous page impact -o practice/                          a folder for a web space
  momentous page impact --scorm -o practice.zip               a package of SCORM 1.2 for a learning platform

The page draws variants, marks answers, shows worked solutions and the simulators without a server, by the same engine as this
program. Whoever has it can have every solution: it is for practice.";

/// The module for browsers, where the program was built with it.
#[cfg(engine_for_browsers)]
const ENGINE: Option<&[u8]> = Some(include_bytes!(concat!(env!("OUT_DIR"), "/engine.wasm.gz")));
#[cfg(not(engine_for_browsers))]
const ENGINE: Option<&[u8]> = None;

/// Make a page for practice that needs no server: one file, a folder, or a package for a learning platform
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Page {
    /// Identities, topics, files or folders
    #[arg(required = true, value_name = "PROBLEM|FILE")]
    problems: Vec<String>,
    /// The title of the page; that of its only problem if none is given
    #[arg(long, value_name = "TITLE")]
    title: Option<String>,
    /// Write a package of SCORM 1.2, which tells the platform which problems were right
    #[arg(long)]
    scorm: bool,
    /// Tell the platform a score, too; a student who knows how can forge it
    #[arg(long, requires = "scorm")]
    score: bool,
    /// A file, or a folder for a web space
    #[arg(short, long, value_name = "FILE|FOLDER")]
    output: PathBuf,
}

impl Page {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let Some(engine) = ENGINE else {
            return Err(Failure::unusable(
                "this program was built without the engine for browsers\n\
                 help: in the folder of its sources: src/browser/build && MOMENTOUS_ENGINE=target/engine.wasm.gz cargo build --release"
                    .to_owned(),
            ));
        };
        let bank = Bank::here()?;
        let mut problems = Vec::new();
        let mut titles = Vec::new();
        for source in bank.select(&self.problems)? {
            let problem = open::compiled(source.clone(), None)?;
            titles.push(problem.title().to_owned());
            problems.push(page_problem(&source, problem.id())?);
        }
        let title = match (&self.title, &*titles) {
            (Some(title), _) => title.clone(),
            (None, [only]) => only.clone(),
            (None, _) => "Practice".to_owned(),
        };
        let templates = pages::templates();
        let page = PracticePage { title, problems, engine, templates: templates.as_deref() };
        let path = &*self.output;
        if self.scorm {
            let reported = if self.score { Reported::Score } else { Reported::Completion };
            let mut output = Output::to(Some(path))?;
            page.scorm(&mut output, reported)?;
            output.finish()?;
        } else if is_folder(path) {
            Output::whole(Some(&path.join(ENGINE_FILE)), engine)?;
            Output::whole(Some(&path.join(PAGE_FILE)), &page.beside_its_engine()?)?;
        } else {
            Output::whole(Some(path), &page.one_file()?)?;
        }
        Ok(Exit::Fine)
    }
}

/// Whether a path is that of a folder: it is there, or ends as folders do.
fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with(['/', '\\'])
}

fn page_problem(source: &Source, id: &str) -> Result<PageProblem, Failure> {
    let settings = course_file(Path::new(&*source.name))?;
    Ok(PageProblem {
        name: source.name.to_string(),
        text: source.text.to_string(),
        course: settings.map(|settings| settings.text.to_string()),
        id: id.to_owned(),
    })
}
