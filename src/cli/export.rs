//! `momentous export`

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::path::PathBuf;

use clap::Args;
use clap::ValueEnum;

use crate::exercise::Drawer;
use crate::export::FEATURES;
use crate::export::Feature;
use crate::export::Moodle;
use crate::export::TARGETS;

use super::exit::Exit;
use super::failure::Failure;
use super::failure::tell;
use super::open;
use super::output::Output;
use super::output::keep_apart;
use super::pages;

const HELP: &str = "\
Examples:
  momentous export moodle impact/two-carts --count 50 -o two-carts.xml   a bank of 50 variants
  momentous export moodle impact --form find-e --seed 100 -o impact.xml  a whole topic
  momentous export --targets                                             what goes along to each target

The file contains answers and worked solutions. What did not go along is said on standard error.";

/// Write variants as questions for other programs: answers, usual mistakes with their feedback, worked solutions
#[derive(Args, Debug)]
#[command(after_help = HELP, arg_required_else_help = true)]
pub(super) struct Export {
    /// The program that reads the file
    #[arg(required_unless_present = "targets")]
    target: Option<Target>,
    /// Identities, topics, files or folders
    #[arg(required_unless_present = "targets", value_name = "PROBLEM|FILE")]
    problems: Vec<String>,
    /// The form in which problems are asked; the first of each if none is named
    #[arg(long, value_name = "FORM")]
    form: Option<String>,
    /// The seed that draws the numbers
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// How many variants of each problem: the seed and those after it
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    count: u64,
    /// Write to this file instead of printing
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// List what goes along to each target, and what stands for the rest
    #[arg(long, exclusive = true)]
    targets: bool,
}

/// The program that reads the file.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Target {
    /// Moodle XML, for the question bank
    Moodle,
}

impl Export {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let Some(Target::Moodle) = self.target else {
            Output::whole(None, &targets())?;
            return Ok(Exit::Fine);
        };
        let last = self.seed.checked_add(self.count - 1);
        let last =
            last.ok_or_else(|| Failure::unusable(format!("there are not {} seeds from {} on", self.count, self.seed)))?;
        keep_apart(self.problems.iter().map(Path::new), self.output.clone())?;
        let problems = open::problems(&self.problems, None)?;
        let forms = problems.iter().map(|problem| open::form(problem, self.form.as_deref()));
        let forms = forms.collect::<Result<Vec<usize>, _>>()?;
        let mut lost: BTreeMap<Feature, u64> = BTreeMap::new();
        let mut file = Moodle::new(Output::to(self.output.as_deref())?, pages::renderer()?)?;
        for (problem, form) in problems.iter().zip(forms) {
            let refused = |seed, reason| Failure::no_variant(problem.id(), seed, &reason);
            let mut drawer = Drawer::new(problem, form).map_err(|reason| refused(self.seed, reason))?;
            for seed in self.seed..=last {
                let exercise = drawer.draw(seed).map_err(|reason| refused(seed, reason))?;
                exercise.printable()?;
                for feature in file.write(&exercise.item())? {
                    *lost.entry(feature).or_default() += 1;
                }
            }
        }
        file.finish()?.finish()?;
        tell(&report(&lost));
        Ok(Exit::Fine)
    }
}

/// What did not go along, in how many questions, and what stands in its place.
fn report(lost: &BTreeMap<Feature, u64>) -> String {
    let mut text = String::from("did not go along as it is (questions): what stands in its place");
    for (feature, what, [(instead, _)]) in FEATURES {
        if let Some(count) = lost.get(&feature) {
            let _ = write!(text, "\n  {what} ({count}): {instead}");
        }
    }
    text
}

/// What goes along to each target.
fn targets() -> String {
    let mut text = String::new();
    for (column, target) in TARGETS.iter().enumerate() {
        let _ = writeln!(text, "{target}");
        for (_, what, cells) in FEATURES {
            let Some((instead, whole)) = cells.get(column) else { continue };
            let _ = writeln!(text, "  {} {what}: {instead}", if *whole { "goes along " } else { "is replaced" });
        }
    }
    text
}
