//! `momentous simulate`

mod listing;
mod plots;
mod request;

use std::io::Write;
use std::path::Path;
use std::path::PathBuf;

use clap::Args;
use clap::ValueEnum;

use crate::exercise::Exercise;
use crate::exercise::SheetSeed;
use crate::simulate::least::Request;
use crate::witness::shoot;

use super::exit::Exit;
use super::failure::Failure;
use super::open;
use super::open::Secret;
use super::output;
use super::output::Output;
use super::plot::Theme;
use super::plot::png;

const HELP: &str = "\
Examples:
  momentous simulate impact/two-carts --seed 7                   the impacts as a table, and which method found them
  momentous simulate bouncing/rubber-ball --format svg -o ball.svg
  momentous simulate impact/two-carts --method penalty
  momentous simulate my-problem.yaml --format json | jq '.stages[0].impacts'

Each stage is run with the simplest suitable model: a formula, else formulas between impacts, else time steps. --accuracy and --budget choose from a table of costs (docs/methods.md). Times are measured from the start of the stage, in an impact from the impact.";

/// Simulate a problem's scene by a numerical method that does not use the laws, and plot it
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Simulate {
    /// The problem's identity, or the path of its file
    problem: String,
    /// The seed that draws the numbers
    #[arg(long, value_name = "S", default_value = "1", allow_negative_numbers = true)]
    seed: SheetSeed,
    /// The form in which the problem is asked; the first if none is named
    #[arg(long, value_name = "FORM")]
    form: Option<String>,
    /// Use this method instead of the cheapest: event-driven, runge-kutta, penalty, ...
    #[arg(long, value_name = "M", value_parser = request::method)]
    method: Option<request::Named>,
    /// The greatest relative error [default: 1e-9]
    #[arg(long, value_name = "A", value_parser = request::accuracy)]
    accuracy: Option<f64>,
    /// The longest time per solve, by the table of costs: 10us, 2ms
    #[arg(long, value_name = "TIME", value_parser = request::budget)]
    budget: Option<f64>,
    /// The table of impacts for people or as csv, plots as svg or png, or everything as json
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Look,
    /// Colours for a dark page: for PNG; SVG has both
    #[arg(long)]
    dark: bool,
    /// Write to this file instead of the terminal
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    secret: Secret,
}

/// The format of a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Look {
    /// The table of impacts, for people.
    Text,
    /// One JSON object with everything.
    Json,
    /// The table of impacts as comma-separated values.
    Csv,
    /// Plots, readable on light and on dark pages.
    Svg,
    /// The same plots as pixels.
    Png,
}

impl Simulate {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let file = Some(Path::new(&self.problem)).filter(|path| path.is_file());
        output::keep_apart(file.into_iter().chain(self.secret.path()), self.output.clone())?;
        let secret = self.secret.read()?;
        let problem = open::problem(&self.problem, secret.as_deref())?;
        let form = open::form(&problem, self.form.as_deref())?;
        let seed = open::seed(&self.seed, &problem)?;
        let drawn = Exercise::draw(&problem, form, seed);
        let exercise = drawn.map_err(|reason| Failure::no_variant(problem.id(), seed, &reason))?;
        let request = Request {
            accuracy: self.accuracy,
            budget: self.budget,
            method: self.method.map(request::Named::kind),
            steps: None,
        };
        let shot = shoot(&problem, exercise.variant(), &request).map_err(|why| Failure::unusable(why.to_string()))?;
        let title = format!("{}, seed {}", problem.id(), self.seed);
        let bytes = match self.format {
            Look::Text => listing::text(&title, &shot).into_bytes(),
            Look::Csv => listing::csv(&shot)?,
            Look::Json => format!("{}\n", shot.record(&problem, exercise.variant())).into_bytes(),
            Look::Svg => plots::page(&title, &shot.films).svg(Theme::Either).into_bytes(),
            Look::Png => png(&plots::page(&title, &shot.films), if self.dark { Theme::Dark } else { Theme::Light })?,
        };
        let mut output = Output::to(self.output.as_deref())?;
        output.write_all(&bytes)?;
        output.finish()?;
        Ok(Exit::Fine)
    }
}
