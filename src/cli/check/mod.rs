//! `momentous check`

mod changed;
mod count;
mod failures;
mod homework;

use std::collections::BTreeMap;
use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use rayon::prelude::*;

use crate::bank;
use crate::bank::AnswerSpread;
use crate::bank::Audit;
use crate::bank::Bank;
use crate::bank::FOLDER;
use crate::bank::FormAudit;
use crate::bank::Outcome;
use crate::bank::Seeds;
use crate::bank::audit;
use crate::bank::load_in_course;
use crate::fault::Faults;
use crate::fault::Source;
use crate::problem::compile;
use crate::quantity::Printed;

use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::cli::failure::tell;
use crate::cli::format::Listing;
use crate::cli::output::Output;
use crate::cli::pages;
use crate::cli::progress;
use crate::cli::style::Style;
use crate::cli::witnessed;

use count::count;
use homework::Homeworks;

const HELP: &str = "\
Examples:
  momentous check                               every problem of the bank
  momentous check impact/two-carts --seeds 5000
  momentous check impact --simulated 64         the first seeds only by a simulation as well, to be quick
  momentous check impact                        every problem of a topic
  momentous check my-problem.yaml my-folder/
  momentous check --load my-problem.yaml        whether it loads, at once
  momentous check --format json | jq 'select(.faults)'
  momentous check --quiet --junit check.xml     in the course's CI: what fails, and a report for its page
  momentous check --changed-since origin/main   only what a change may touch

It exits with 1 if a promise is broken, and with 2 if a file does not load. A promise that this version does not check is listed as not checked.";

/// Figures of printed answers.
const FIGURES: usize = 4;

/// Check what problems promise, over many seeds: before a student sees them
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Check {
    /// Identities, topics, files or folders, also of homework; the whole bank if nothing is named
    #[arg(value_name = "PATH|PROBLEM")]
    problems: Vec<String>,
    /// How many seeds to draw for each form
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    seeds: u64,
    /// Only read and compile each file, and draw nothing
    #[arg(long, conflicts_with_all = ["seeds", "simulated", "format"])]
    load: bool,
    /// How many of these to simulate as well, by a method that shares no code with the laws [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    simulated: Option<u64>,
    /// For people, or one JSON object per line
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Listing,
    /// Say nothing of what is well
    #[arg(short, long, conflicts_with_all = ["format", "load"])]
    quiet: bool,
    /// Check only problems that differ from this revision of git, or whose `course.yaml` or templates do
    #[arg(long, value_name = "REVISION")]
    changed_since: Option<String>,
    /// Write a report in the form that CI services show (JUnit XML)
    #[arg(long, value_name = "FILE", conflicts_with = "load")]
    junit: Option<PathBuf>,
    /// Print what fails as annotations of GitHub Actions, too
    #[arg(long, conflicts_with_all = ["format", "load"])]
    annotations: bool,
}

impl Check {
    fn simulated(&self) -> u64 {
        self.simulated.unwrap_or(self.seeds).min(self.seeds)
    }

    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let (bank, mut unusable) = Bank::gathered_here()?;
        if self.problems.is_empty() && bank.is_built_in() {
            tell(&format!(
                "note: there is no folder {FOLDER} with problems here, so the {} that are built in are checked\n\
                 help: name the folder that is meant: momentous check FOLDER",
                bank.ids().count()
            ));
        }
        let (mut sources, named) = bank.selected(&self.problems)?;
        if !self.problems.is_empty() {
            unusable = named;
        }
        let homeworks = Homeworks::among(&mut sources, &self.problems, &bank)?;
        unusable.extend(homeworks.unusable.iter().cloned());
        if let Some(revision) = &self.changed_since {
            sources = changed::since(revision, sources)?;
            if sources.is_empty() {
                tell(&format!("note: no problem has changed since {revision}"));
            }
        }
        if self.load {
            return loaded(&sources, &unusable);
        }
        let renderer = pages::renderer()?;
        let bar = progress::bar(sources.len() as u64, false);
        let look = |source| {
            let audit = audit(source, Seeds { drawn: self.seeds, simulated: self.simulated() }, &renderer);
            bar.inc(1);
            audit
        };
        let mut audits: Vec<Audit> = sources.par_iter().map(look).collect();
        audits.extend(unusable.iter().map(bank::unusable));
        bar.finish_and_clear();
        let mut output = Output::to(None)?;
        match self.format {
            Listing::Text => {
                if !self.quiet {
                    homeworks.write(&mut output)?;
                }
                self.write_text(&mut output, &audits)?;
            }
            Listing::Json => {
                for audit in &audits {
                    serde_json::to_writer(&mut output, audit)?;
                    writeln!(output)?;
                }
            }
        }
        output.finish()?;
        if let Some(path) = &self.junit {
            failures::write_junit(path, &audits)?;
        }
        Ok(if audits.iter().any(|audit| audit.faults.is_some()) {
            Exit::Unusable
        } else if audits.iter().any(Audit::is_broken) {
            Exit::NotRight
        } else {
            Exit::Fine
        })
    }
}

impl Check {
    fn write_text(&self, output: &mut Output, audits: &[Audit]) -> Result<(), Failure> {
        let style = Style::of_stdout();
        for audit in audits.iter().filter(|audit| !self.quiet || audit.is_broken()) {
            write_audit(output, audit, style)?;
        }
        let broken = audits.iter().filter(|audit| audit.is_broken()).count();
        let forms: usize = audits.iter().map(|audit| audit.forms.len()).sum();
        let counted = format!("{}, {}", count(audits.len(), "problem"), count(forms, "form"));
        match broken {
            0 => writeln!(output, "{counted}: {}", style.good("every promise that was checked holds"))?,
            _ => writeln!(output, "{counted}: {}", style.bad(&format!("{} broken", count(broken, "problem"))))?,
        }
        if !self.quiet {
            witnessed::write_share(output, audits, self.simulated())?;
        }
        if self.annotations {
            failures::write_annotations(output, audits)?;
        }
        failures::write_text(output, audits)
    }
}

/// Says of each file whether it loads.
fn loaded(sources: &[Source], unusable: &[Faults]) -> Result<Exit, Failure> {
    let compiled = |source: &Source| load_in_course(source.clone()).and_then(|loaded| compile(loaded, None));
    let read: Vec<_> = sources.par_iter().map(compiled).collect();
    let mut output = Output::to(None)?;
    for problem in &read {
        match problem {
            Ok(problem) => writeln!(output, "{}  loads", problem.id())?,
            Err(faults) => writeln!(output, "{faults}")?,
        }
    }
    for faults in unusable {
        writeln!(output, "{faults}")?;
    }
    output.finish()?;
    Ok(if unusable.is_empty() && read.iter().all(Result::is_ok) { Exit::Fine } else { Exit::Unusable })
}

fn write_audit(output: &mut Output, audit: &Audit, style: Style) -> Result<(), Failure> {
    let name = audit.problem.as_deref().unwrap_or("does not load");
    writeln!(output, "{}  {}  digest {}", style.strong(name), audit.file, audit.digest)?;
    if let Some(faults) = &audit.faults {
        writeln!(output, "{faults}")?;
    }
    for form in &audit.forms {
        write_form(output, form, style)?;
    }
    writeln!(output)?;
    Ok(())
}

fn write_form(output: &mut Output, form: &FormAudit, style: Style) -> Result<(), Failure> {
    let name = form.form.as_deref().unwrap_or("its one form");
    writeln!(
        output,
        "  {}: {} seeds, {} different variants of {}, {}, {:.1} % of the draws accepted",
        style.strong(name),
        form.seeds,
        form.variants,
        form.combinations,
        count(form.sheets, "different sheet"),
        100.0 * form.acceptance
    )?;
    if !form.laws.is_empty() {
        writeln!(output, "    laws: {}", form.laws.join(", "))?;
    }
    for line in spread_table(&form.answers) {
        writeln!(output, "    {line}")?;
    }
    witnessed::write_form(output, &form.simulation)?;
    let with_outcome = |wanted: &str| -> Vec<&str> {
        let findings = form.promises.iter().filter(|finding| finding.outcome.name() == wanted);
        findings.map(|finding| finding.promise.name()).collect()
    };
    for finding in &form.promises {
        match &finding.outcome {
            Outcome::Broken(remark) => {
                writeln!(output, "    {} {}: {remark}", style.bad("broken:"), finding.promise.sentence())?;
            }
            Outcome::Noted(remark) => writeln!(output, "    {} {remark}", style.note("noted:"))?,
            Outcome::Kept | Outcome::Acknowledged { .. } | Outcome::NotChecked(_) => {}
        }
    }
    let labels = [
        ("kept", style.good("kept:")),
        ("acknowledged", style.good("acknowledged in the file:")),
        ("not checked", style.note("not checked:")),
    ];
    for (outcome, label) in labels {
        let names = with_outcome(outcome);
        if !names.is_empty() {
            writeln!(output, "    {label} {}", names.join(", "))?;
        }
    }
    Ok(())
}

/// The spreads as a table whose columns stand below each other.
fn spread_table(answers: &[AnswerSpread]) -> Vec<String> {
    let mut rows = vec![["answer", "least", "quarter", "median", "3 quarters", "most", "unit"].map(str::to_owned)];
    let mut choices = Vec::new();
    for answer in answers {
        match answer {
            AnswerSpread::Number { id, unit, least, lower_quartile, median, upper_quartile, most, .. } => {
                let [low, quarter, middle, three, high] =
                    [least, lower_quartile, median, upper_quartile, most].map(|value| printed(*value));
                rows.push([id.clone(), low, quarter, middle, three, high, unit.clone()]);
            }
            AnswerSpread::Choice { id, right } => choices.push(format!("{id}: {}", phrases(right))),
        }
    }
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..7).map(width).collect();
    let line = |row: &[String; 7]| {
        let cell = |(index, cell): (usize, &String)| {
            let width = widths[index];
            if index == 0 || index == 6 { format!("{cell:width$}") } else { format!("{cell:>width$}") }
        };
        row.iter().enumerate().map(cell).collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    let table = if rows.len() > 1 { rows.iter().map(line).collect() } else { Vec::new() };
    [table, choices].concat()
}

/// The number of phrases that are listed one by one: every order of four quantities.
const MOST_PHRASES: usize = 24;

/// The right phrases; where they differ from seed to seed, how often each.
fn phrases(right: &BTreeMap<String, usize>) -> String {
    match right.iter().collect::<Vec<_>>()[..] {
        [(only, _)] => only.clone(),
        ref several if several.len() > MOST_PHRASES => format!("{} different phrases", several.len()),
        ref several => {
            several.iter().map(|(phrase, count)| format!("{phrase} ({count})")).collect::<Vec<_>>().join(", ")
        }
    }
}

fn printed(value: f64) -> String {
    Printed::new(value, FIGURES).map_or_else(|| "-".to_owned(), |printed| printed.plain())
}
