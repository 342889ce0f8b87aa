//! `momentous generate`

mod asked;
mod bound;
mod destination;
mod earlier;
mod homework;
mod job;
mod names;
mod roster;
mod stream;

use std::collections::BTreeSet;
use std::path::Path;
use std::path::PathBuf;

use clap::Args;

use crate::exercise::Derivation;
use crate::exercise::Exercise;
use crate::exercise::SeedSource;
use crate::exercise::SheetSeed;
use crate::problem::Scheme;
use crate::render::Figures;
use crate::render::Key;
use crate::render::KeyRow;
use crate::render::Page;

use super::exit::Exit;
use super::failure::Failure;
use super::failure::tell;
use super::format::Paper;
use super::open;
use super::open::Secret;
use super::output;
use super::output::Output;
use super::pages::HtmlOptions;
use super::pages::SolutionOptions;
use super::printer::Printer;

use bound::Bound;
use destination::Destination;
pub(super) use destination::SEEDS;
use earlier::Earlier;
use job::{Job, Wanted};
use roster::Roster;
pub(super) use roster::{NUMBER, students};

const HELP: &str = "\
Examples:
  momentous generate impact/two-carts --seed 7                     a sheet
  momentous generate impact/two-carts --seed 7 --solution          and its worked solution
  momentous generate impact/two-carts --solution --faded 2         its first two steps
  momentous generate impact/two-carts --solution --detailed        every step and check
  momentous generate impact --count 5 --key --format latex -o exam.tex
  momentous generate impact/two-carts --roster class.csv --secret secret.txt --key -o sheets/
  momentous generate impact --roster class.csv --format pdf -o class.pdf    one bound file
  momentous generate impact/two-carts --count 100000 --format json > variants.jsonl
  momentous generate homework/week-3.yaml --roster class.csv --key -o sheets/   one sheet a student with every problem

A roster is a CSV file with a column `id`, or `name`, or both. Each student gets individual numbers, and seeds.csv says who has which seed. The name of a folder after -o ends with a slash, unless the folder exists. The key and seeds.csv are written next to it, into a separate folder for the teacher: sheets-teacher/. With --roster or --secret so do solutions and
JSON, which hold answers, too. The same problem, seed and form give the same numbers on every computer.";

/// The ending by which the name of a solution differs from that of its sheet.
const SOLUTION: &str = "-solution";

/// Make problem sheets, with solutions and a key if wanted
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Generate {
    /// Identities, topics, files or folders; or the file of one homework
    #[arg(required = true, value_name = "PROBLEM|FILE")]
    problems: Vec<String>,
    /// The seed that draws the numbers
    #[arg(long, value_name = "S", default_value = "1", allow_negative_numbers = true, conflicts_with = "roster")]
    seed: SheetSeed,
    /// How many variants: the seed and those after it
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..), conflicts_with = "roster")]
    count: u64,
    /// The form in which problems are asked; the first of each if none is named
    #[arg(long, value_name = "FORM")]
    form: Option<String>,
    /// The format of the documents
    #[arg(long, value_name = "FORMAT", default_value = "markdown")]
    format: Paper,
    /// Add the worked solution of each sheet
    #[arg(long)]
    solution: bool,
    /// Add one key with all answers; JSON always contains them
    #[arg(long)]
    key: bool,
    /// One sheet for each student of this table
    #[arg(long, value_name = "CSV", requires = "output")]
    roster: Option<PathBuf>,
    /// How students' seeds are derived: 2, or 1 to print sheets of an earlier version of the program again
    #[arg(long, value_name = "VERSION", default_value_t, requires = "roster")]
    derivation: Derivation,
    /// How numbers are drawn: 2, or 1 to print sheets of an earlier version of the program again
    #[arg(long, value_name = "VERSION", default_value_t)]
    scheme: Scheme,
    /// Write to this file, or files into this folder, instead of printing
    #[arg(short, long, value_name = "FILE|FOLDER")]
    output: Option<PathBuf>,
    #[command(flatten)]
    shown: SolutionOptions,
    #[command(flatten)]
    held: HtmlOptions,
    #[command(flatten)]
    secret: Secret,
}

/// Whether each student, or each seed, has several sheets.
fn each_has_several(wanted: &Wanted) -> bool {
    wanted.sheets_each() > 1
}

impl Generate {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        if self.shown.is_said() && !self.solution {
            return Err(Failure::unusable(
                "--faded, --instructor and --detailed apply only to solutions\nhelp: add --solution",
            ));
        }
        let printer = Printer::new(self.format, self.held)?;
        let secret = self.secret.read()?;
        let roster = self.roster.as_deref().map(Roster::read).transpose()?;
        let destination = Destination::of(self.output.as_deref());
        self.keep_apart(&destination)?;
        let wanted = homework::wanted(&self.problems, self.form.as_deref(), secret.as_deref())?;
        let asked = wanted.asked();
        let seeds = SeedSource { derivation: self.derivation, secret: secret.as_deref() };
        let first = asked.first().map_or(Ok(self.seed.number), |question| open::seed(&self.seed, &question.problem))?;
        let jobs = |count| match &roster {
            Some(roster) => Ok(wanted.for_students(&roster.0, seeds, self.scheme)),
            None => wanted.for_seeds(first, count, self.scheme),
        };
        let earlier = match &roster {
            Some(_) => Some(Earlier::at(&destination.for_teacher()?.join(SEEDS), asked, seeds, self.scheme)?),
            None => None,
        };
        let mut files = BTreeSet::new();
        if let Destination::Folder(_) = &destination {
            // Seeds that follow each other have names that differ.
            files = self.names(jobs(1)?)?;
        }
        let jobs = jobs(self.count)?;
        if roster.is_some() {
            // Where this cannot be, no sheets are made for which nobody knows whose they are.
            destination.make_for_teacher()?;
        }
        let each = roster.as_ref().map_or(self.count, |roster| roster.0.len() as u64);
        match printer {
            None => self.stream(jobs, each.saturating_mul(wanted.sheets_each()), &destination)?,
            Some(printer) => {
                let together = !self.solution && each_has_several(&wanted) && (roster.is_some() || self.count == 1);
                self.documents(jobs, printer, &destination, together)?;
            }
        }
        if let Some(roster) = &roster {
            destination.write_for_teacher(SEEDS, &roster.seeds(asked, seeds, self.scheme)?)?;
            if let Wanted::Together(..) = &wanted {
                homework::write_answers(&destination, &roster.answers(asked)?)?;
            }
            if secret.is_none() {
                tell("note: without --secret, a student who has this program can print his or her own solution");
            }
        }
        if let (Some(earlier), Destination::Folder(folder)) = (earlier, &destination) {
            earlier.tell_what_is_left(&[folder.clone(), destination.for_teacher()?], &files);
        }
        Ok(Exit::Fine)
    }

    /// Whether nothing that is read would be written over.
    fn keep_apart(&self, destination: &Destination) -> Result<(), Failure> {
        let seeds = self.roster.iter().filter_map(|_| Some(destination.for_teacher().ok()?.join(SEEDS)));
        let named = self.problems.iter().map(Path::new).filter(|path| path.is_file());
        let read = self.roster.as_deref().into_iter().chain(self.secret.path()).chain(named);
        output::keep_apart(read, destination.file().map(Path::to_owned).into_iter().chain(seeds))
    }

    /// Whether sheets may be handed out as they lie there, so that what holds answers goes elsewhere.
    fn is_for_students(&self) -> bool {
        self.roster.is_some() || self.secret.path().is_some()
    }

    /// The names of files without their endings; two documents with one name are refused.
    fn names(&self, jobs: impl Iterator<Item = Job>) -> Result<BTreeSet<String>, Failure> {
        let mut files = BTreeSet::new();
        let mut documents = Vec::new();
        for job in jobs {
            let stem = job.file_stem();
            documents.push((stem.clone(), format!("the sheet of {}", job.said())));
            if self.solution && self.format.document().is_some() {
                documents.push((format!("{stem}{SOLUTION}"), format!("the solution of {}", job.said())));
            }
            files.insert(stem);
        }
        names::refuse_twins(documents.into_iter())?;
        Ok(files)
    }

    /// One document of everything, with the problems of a student on one sheet where they belong `together`, or a file for each sheet, each solution and the key.
    fn documents(
        &self,
        jobs: impl Iterator<Item = Job>,
        mut printer: Printer,
        destination: &Destination,
        together: bool,
    ) -> Result<(), Failure> {
        let extension = self.format.extension();
        let mut pages = Vec::new();
        let mut rows: Vec<KeyRow> = Vec::new();
        let mut bound = Bound::default();
        for job in jobs {
            let exercises = job.exercises()?;
            exercises.iter().try_for_each(Exercise::printable)?;
            let sheet = job.sheet(&exercises);
            let solution = if self.solution { job.solutions(&exercises, self.shown) } else { Vec::new() };
            if self.key {
                rows.extend(job.key(&exercises));
            }
            let Destination::Folder(folder) = destination else {
                let sheet = if together { bound.add(sheet) } else { sheet };
                pages.extend(sheet.into_iter().chain(solution));
                continue;
            };
            let documents = [(sheet, "", false), (solution, SOLUTION, self.is_for_students())];
            for (pages, ending, is_apart) in documents.into_iter().filter(|(pages, ..)| !pages.is_empty()) {
                let name = format!("{}{ending}", job.file_stem());
                printer = printer.figures(Figures::Beside(name.clone()));
                let document = printer.print(&pages)?;
                let write = |name: &str, text: &[u8]| {
                    if is_apart {
                        destination.write_for_teacher(name, text)
                    } else {
                        Output::whole(Some(&folder.join(name)), text)
                    }
                };
                document.beside.iter().try_for_each(|beside| write(&beside.name, beside.text.as_bytes()))?;
                write(&format!("{name}.{extension}"), &document.bytes)?;
            }
        }
        let key = Page::Key(Key { title: "Answers".to_owned(), rows });
        match destination {
            Destination::Folder(_) if self.key => {
                destination.write_for_teacher(&format!("key.{extension}"), &printer.print(&[key])?.bytes)
            }
            Destination::Folder(_) => Ok(()),
            Destination::File(_) | Destination::Stdout => {
                pages.extend(bound.finish());
                pages.extend(self.key.then_some(key));
                Output::whole(destination.file(), &printer.print(&pages)?.bytes)
            }
        }
    }

    /// The data of a sheet, with its solutions where they are wanted.
    fn record(&self, job: &Job, renderer: &crate::render::Renderer) -> Result<String, Failure> {
        Ok(job.record(self.solution.then_some(self.shown), renderer)?.to_string())
    }
}
