//! `momentous diagnose`

use std::io::Write;

use clap::Args;
use rayon::prelude::*;
use serde_json::json;

use crate::bank::Bank;
use crate::bank::Diagnosed;
use crate::bank::Tally;
use crate::bank::diagnosed;
use crate::laws::wrong;

use super::exit::Exit;
use super::failure::Failure;
use super::format::Listing;
use super::output::Output;
use super::progress;

const HELP: &str = "\
Examples:
  momentous diagnose                            the whole bank, 1000 seeds for each form
  momentous diagnose impact --seeds 100
  momentous diagnose impact/two-carts --confused
  momentous diagnose --list                     the known mistakes, with their codes
  momentous diagnose --format json

For each form, part and seed, one simulated student makes one common mistake and rounds the result to the required figures; two more do everything right. It exits with 1 if one of those who did everything right loses a mark.";

/// Measure how well common mistakes are distinguished, using simulated students
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Diagnose {
    /// Identities, topics, files or folders; the whole bank if nothing is named
    #[arg(value_name = "PATH|PROBLEM")]
    problems: Vec<String>,
    /// How many seeds to draw for each form
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..=10_000_000))]
    seeds: u64,
    /// Also show which mistakes gave right answers, and which were diagnosed as which others
    #[arg(long)]
    confused: bool,
    /// List the mistakes instead
    #[arg(long, conflicts_with_all = ["seeds", "problems", "confused"])]
    list: bool,
    /// For people, or one JSON object per line
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Listing,
}

impl Diagnose {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let mut output = Output::to(None)?;
        if self.list {
            self.write_list(&mut output)?;
            output.finish()?;
            return Ok(Exit::Fine);
        }
        let sources = Bank::here()?.select(&self.problems)?;
        let bar = progress::bar(sources.len() as u64, false);
        let look = |source| {
            let of_problem = diagnosed(source, self.seeds);
            bar.inc(1);
            of_problem
        };
        let of_problems: Vec<Diagnosed> = sources.par_iter().map(look).collect::<Result<_, _>>()?;
        bar.finish_and_clear();
        let total = of_problems.iter().fold(Tally::default(), |sum, diagnosed| sum.plus(&diagnosed.tally));
        match self.format {
            Listing::Text => self.write_table(&mut output, &of_problems, &total)?,
            Listing::Json => {
                for diagnosed in &of_problems {
                    writeln!(output, "{}", record(diagnosed))?;
                }
            }
        }
        output.finish()?;
        Ok(if total.wronged > 0 { Exit::NotRight } else { Exit::Fine })
    }

    fn write_table(&self, output: &mut Output, of_problems: &[Diagnosed], total: &Tally) -> Result<(), Failure> {
        let width = of_problems.iter().map(|diagnosed| diagnosed.problem.len()).max().unwrap_or(0).max("problem".len());
        writeln!(
            output,
            "{:width$}  mistakes  students    right  shared  another     none  hidden  honest  wronged",
            "problem"
        )?;
        for diagnosed in of_problems {
            writeln!(
                output,
                "{:width$}  {:8}{}",
                diagnosed.problem,
                diagnosed.mistakes.len(),
                cells(&diagnosed.tally)
            )?;
        }
        let kinds: std::collections::BTreeSet<&str> =
            of_problems.iter().flat_map(|diagnosed| diagnosed.mistakes.iter().copied()).collect();
        writeln!(output, "{:width$}  {:8}{}", "in total", kinds.len(), cells(total))?;
        if self.confused {
            let mut hidden: Vec<_> = total.hidden_by.iter().collect();
            hidden.sort_by_key(|(_, count)| std::cmp::Reverse(**count));
            for (code, count) in hidden {
                let made = total.made.get(code).copied().unwrap_or_default();
                writeln!(output, "  {count:6}  {code} -> a right answer, of {made} who made it")?;
            }
            let mut pairs: Vec<_> = total.confused.iter().collect();
            pairs.sort_by_key(|(_, count)| std::cmp::Reverse(**count));
            for ((made, taken), count) in pairs {
                writeln!(output, "  {count:6}  {made} -> {taken}")?;
            }
        }
        Ok(())
    }

    fn write_list(&self, output: &mut Output) -> Result<(), Failure> {
        for (chapter, kinds) in wrong::all() {
            if self.format == Listing::Text {
                writeln!(output, "{chapter}")?;
            }
            for kind in kinds {
                match self.format {
                    Listing::Text => writeln!(output, "  {:42} {}", kind.id, kind.does)?,
                    Listing::Json => {
                        let row = json!({ "code": kind.id, "chapter": chapter, "does": kind.does, "ask": kind.ask, "hint": kind.hint });
                        writeln!(output, "{row}")?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// The counts of a row: shares of the students whose answer was wrong.
fn cells(tally: &Tally) -> String {
    #[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
    let share = |count: u64| 100.0 * count as f64 / (tally.students.max(1) as f64);
    let [right, shared, another, none] = [tally.right, tally.shared, tally.another, tally.none].map(share);
    let Tally { students, hidden, honest, wronged, .. } = tally;
    format!(
        "  {students:8}  {right:5.1} %  {shared:4.1} %  {another:5.1} %  {none:5.1} %  {hidden:6}  {honest:6}  {wronged:7}"
    )
}

fn record(diagnosed: &Diagnosed) -> serde_json::Value {
    let tally = &diagnosed.tally;
    let confused: Vec<_> = tally
        .confused
        .iter()
        .map(|((made, taken), count)| json!({ "made": made, "taken_for": taken, "count": count }))
        .collect();
    json!({
        "problem": diagnosed.problem,
        "mistakes": diagnosed.mistakes,
        "students": tally.students,
        "right": tally.right,
        "shared": tally.shared,
        "another": tally.another,
        "none": tally.none,
        "hidden": tally.hidden,
        "honest": tally.honest,
        "wronged": tally.wronged,
        "confused": confused,
    })
}
