//! `momentous solve`

use clap::Args;

use crate::exercise::Exercise;
use crate::exercise::SheetSeed;
use crate::fault::Faults;
use crate::fault::Source;
use crate::render::Page;

use super::exit::Exit;
use super::failure::Failure;
use super::format::Paper;
use super::open;
use super::open::Secret;
use super::output::Output;
use super::pages;
use super::pages::HtmlOptions;
use super::pages::SolutionOptions;
use super::printer::Printer;

const HELP: &str = "\
Examples:
  momentous solve impact/two-carts --seed 7
  momentous solve impact/two-carts --set \"m_A=3 kg\" --set \"m_B=2 kg\" --set \"v_A1=3 m/s\" \\
      --set \"v_B1=-2 m/s\" --set e=0.7 --find v_A2 --find T_lost --format json
  momentous solve my-problem.yaml --form backward --instructor

What --set does not give is drawn from the seed.";

/// Solve a problem, optionally with your own numbers, and show how
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Solve {
    /// The problem's identity, or the path of its file
    problem: String,
    /// The seed that draws the numbers
    #[arg(long, value_name = "S", default_value = "1", allow_negative_numbers = true)]
    seed: SheetSeed,
    /// The form in which the problem is asked; the first if none is named
    #[arg(long, value_name = "FORM")]
    form: Option<String>,
    /// Your own value for a given, with its unit
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment, conflicts_with = "secret")]
    set: Vec<(String, String)>,
    /// What to find, instead of what the form asks
    #[arg(long, value_name = "NAME", conflicts_with = "secret")]
    find: Vec<String>,
    /// The format of the solution
    #[arg(long, value_name = "FORMAT", default_value = "markdown")]
    format: Paper,
    #[command(flatten)]
    shown: SolutionOptions,
    #[command(flatten)]
    held: HtmlOptions,
    #[command(flatten)]
    secret: Secret,
}

impl Solve {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let secret = self.secret.read()?;
        let problem = open::problem(&self.problem, secret.as_deref())?;
        let form = open::form(&problem, self.form.as_deref())?;
        let seed = open::seed(&self.seed, &problem)?;
        let exercise = if self.set.is_empty() && self.find.is_empty() {
            let drawn = Exercise::draw(&problem, form, seed);
            drawn.map_err(|reason| Failure::no_variant(problem.id(), seed, &reason))?
        } else {
            let solved = Exercise::with_values(&problem, form, seed, &self.set, &self.find);
            solved.map_err(|faults| typed(&self.problem, faults))?
        };
        let text = match Printer::new(self.format, self.held)? {
            Some(printer) => printer.print(&[Page::Solution(self.shown.solution(&exercise))])?.bytes,
            None => {
                let solution = self.shown.markdown(&pages::renderer()?, &exercise)?;
                format!("{}\n", exercise.record(Some(solution))).into_bytes()
            }
        };
        Output::whole(None, &text)?;
        Ok(Exit::Fine)
    }
}

/// Faults of what was typed: the file itself is sound, so no place in it is to blame.
fn typed(problem: &str, faults: Faults) -> Faults {
    let mut list = faults.list;
    for fault in &mut list {
        (fault.span, fault.path, fault.within) = (None, None, None);
    }
    Faults { source: Source::new(&format!("{problem} with --set and --find"), ""), list }
}

/// Splits `NAME=TEXT` at the first sign.
pub(super) fn assignment(text: &str) -> Result<(String, String), String> {
    let split = text.split_once('=').map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned()));
    split.filter(|(name, _)| !name.is_empty()).ok_or_else(|| format!("`{text}` is not of the form NAME=VALUE"))
}
