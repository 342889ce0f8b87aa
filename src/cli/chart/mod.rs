//! `momentous chart`

mod certificates;
mod costs;
mod diagram;
mod drift;
mod points;
mod tasks;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use clap::ValueEnum;

use crate::simulate::least::measure_costs;
use crate::simulate::stability::run_all;

use super::exit::Exit;
use super::failure::Failure;
use super::output;
use super::output::Output;
use super::plot::Page;
use super::plot::Theme;
use super::plot::png;

use points::Row;

const HELP: &str = "\
Tasks: bounce, bounce-with-drag, half-sine-force, head-on, chain, ramp-force, oblique, kepler; all of them if none is named.

Each point is one method at one step or tolerance: the median error of the whole state over 32 jittered scenes, with a line from
the tenth to the ninetieth percentile, against the time of one solve and against the evaluations that it takes. Where scenes were
refused or ended without an answer, there is a cross at the upper edge. All tasks take less than a minute; a finer step takes longer.

Examples:
  momentous chart -o chart.svg                              measure and draw all tasks
  momentous chart bounce --finest-step 1e-5 -o bounce.svg   one of them, further down
  momentous chart bounce --format csv -o bounce.csv         measure only
  momentous chart --from bounce.csv -o bounce.svg           draw what was measured
  momentous chart --drift -o drift.svg                      energy and momentum after up to a million bounces and periods
  momentous chart --stability                               where each method is right, refuses or fails
  momentous chart --costs -o src/simulate/least/costs.csv   the table of costs, from which `momentous simulate` chooses";

/// Chart the numerical methods: error against time, and where each is stable
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Chart {
    /// The reference tasks; all if none is named
    #[arg(value_name = "TASK")]
    tasks: Vec<String>,
    /// A drawing or the numbers; for --stability, text or csv
    #[arg(long, value_name = "FORMAT")]
    format: Option<Look>,
    /// The table of the stability suite instead
    #[arg(long, conflicts_with_all = ["tasks", "from"])]
    stability: bool,
    /// The change of energy and momentum over up to so many bounces and periods instead
    #[arg(
        long,
        value_name = "PERIODS",
        num_args = 0..=1,
        default_missing_value = "1000000",
        value_parser = clap::value_parser!(u32).range(1_000..=1_000_000),
        conflicts_with_all = ["tasks", "stability"],
    )]
    drift: Option<u32>,
    /// Measure again the table of costs from which `momentous simulate` chooses
    #[arg(long, conflicts_with_all = ["tasks", "from", "stability", "drift", "format"])]
    costs: bool,
    /// Draw the table of certificates and errors that `cargo test --test solver near` writes
    #[arg(long, value_name = "FILE", conflicts_with_all = ["tasks", "from", "stability", "drift", "costs"])]
    certificates: Option<PathBuf>,
    /// Draw the points of a table that was measured before
    #[arg(long, value_name = "FILE")]
    from: Option<PathBuf>,
    /// The finest step of the methods with a fixed step, in s
    #[arg(long, value_name = "SECONDS", default_value = "1e-3", value_parser = step)]
    finest_step: f64,
    /// Solves per scene, of which the fastest counts; short ones are repeated more often
    #[arg(long, value_name = "COUNT", default_value = "5", value_parser = clap::value_parser!(u16).range(1..))]
    repetitions: u16,
    /// Colours for a dark page: for PNG; SVG has both
    #[arg(long)]
    dark: bool,
    /// Write to this file instead of the terminal
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// The format of a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Look {
    /// A drawing, readable on light and on dark pages.
    Svg,
    /// The same drawing as pixels.
    Png,
    /// Comma-separated values.
    Csv,
    /// For people: the stability table.
    Text,
}

/// Steps below a nanosecond would run for days.
fn step(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(step) if (1e-9..=1.0).contains(&step) => Ok(step),
        _ => Err("a step is a number of seconds from 1e-9 to 1".to_owned()),
    }
}

impl Chart {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        output::keep_apart(
            [&self.certificates, &self.from].into_iter().flatten().map(PathBuf::as_path),
            self.output.clone(),
        )?;
        let look = self.format.unwrap_or(if self.stability { Look::Text } else { Look::Svg });
        let mut text = Vec::new();
        if self.costs {
            costs::write(&measure_costs(usize::from(self.repetitions)), &mut text)?;
            return self.put(&text);
        }
        match (self.stability, look) {
            (true, Look::Text) => stability_text(&mut text)?,
            (true, Look::Csv) => stability_csv(&mut text)?,
            (true, Look::Svg | Look::Png) => {
                return Err(Failure::unusable("the stability table is text or csv, not a drawing"));
            }
            (false, Look::Text) => {
                return Err(Failure::unusable("text is for --stability; a chart is svg, png or csv"));
            }
            (false, Look::Csv) if self.certificates.is_some() => {
                return Err(Failure::unusable("the certificates are a table already; a chart is svg or png"));
            }
            (false, Look::Csv) => match self.drift {
                Some(most_periods) => points::write(&self.drifts(most_periods)?, &mut text)?,
                None => points::write(&self.rows()?, &mut text)?,
            },
            (false, Look::Svg) => text.extend(self.page()?.svg(Theme::Either).into_bytes()),
            (false, Look::Png) => text.extend(png(&self.page()?, theme(self.dark))?),
        }
        self.put(&text)
    }

    fn put(&self, bytes: &[u8]) -> Result<Exit, Failure> {
        let mut output = Output::to(self.output.as_deref())?;
        output.write_all(bytes)?;
        output.finish()?;
        Ok(Exit::Fine)
    }

    fn page(&self) -> Result<Page, Failure> {
        Ok(match (&self.certificates, self.drift) {
            (Some(path), _) => certificates::page(&certificates::read(path)?),
            (None, Some(most_periods)) => drift::page(&self.drifts(most_periods)?),
            (None, None) => diagram::page(&self.rows()?),
        })
    }

    /// The drifts that were measured before, or are measured now.
    fn drifts(&self, most_periods: u32) -> Result<Vec<drift::Row>, Failure> {
        match &self.from {
            Some(path) => drift::read(path),
            None => Ok(drift::measure(most_periods)),
        }
    }

    /// The points that were measured before, or are measured now.
    fn rows(&self) -> Result<Vec<Row>, Failure> {
        let Some(path) = &self.from else {
            return tasks::measure(&self.tasks, usize::from(self.repetitions), self.finest_step);
        };
        let rows = points::read(path)?;
        if self.tasks.is_empty() {
            return Ok(rows);
        }
        let chosen = tasks::chosen(&self.tasks)?;
        Ok(rows.into_iter().filter(|row| chosen.contains(&row.task.as_str())).collect())
    }
}

fn theme(dark: bool) -> Theme {
    if dark { Theme::Dark } else { Theme::Light }
}

/// The table as `tests/fixtures/stability.txt` holds it.
fn stability_text(out: &mut Vec<u8>) -> Result<(), Failure> {
    let mut scene = "";
    for row in run_all() {
        if row.scene != scene {
            let gap = if scene.is_empty() { "" } else { "\n" };
            writeln!(out, "{gap}{}", row.scene)?;
            scene = row.scene;
        }
        writeln!(out, "    {:22}{}", row.method, row.verdict)?;
    }
    Ok(())
}

fn stability_csv(out: &mut Vec<u8>) -> Result<(), Failure> {
    let unwritten = |error: csv::Error| Failure::unusable(format!("the table cannot be written: {error}"));
    let mut table = csv::Writer::from_writer(out);
    table.write_record(["scene", "method", "verdict"]).map_err(unwritten)?;
    for row in run_all() {
        table.write_record([row.scene, row.method, &row.verdict.to_string()]).map_err(unwritten)?;
    }
    Ok(table.flush()?)
}
