//! The command line: one file for each subcommand. It reads arguments and files, and prints; it knows no physics.

mod chart;
mod check;
mod completions;
mod diagnose;
mod exit;
mod export;
mod failure;
mod format;
mod gallery;
mod generate;
mod grade;
mod init;
mod list;
mod new;
mod open;
mod output;
mod page;
mod pages;
mod pending;
mod plot;
mod printer;
mod progress;
mod schema;
mod secret;
#[cfg(feature = "serve")]
mod serve;
mod show;
mod simulate;
mod snapshot;
mod solve;
mod style;
mod table;
mod templates;
mod terminal;
mod witnessed;

use std::ffi::OsString;

use clap::CommandFactory;
use clap::Parser;
use clap::Subcommand;

pub use exit::Exit;

use failure::Failure;

/// Writes, solves, explains and marks problems on impulse, momentum and restitution.
#[derive(Debug, Parser)]
#[command(name = "momentous", version, after_help = HELP, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const HELP: &str = "\
A PROBLEM is an identity from `momentous list`, such as impact/two-carts, or the path of a YAML file.
The bank is the folder problem_bank/ here, or above in the same repository; if there is none, the built-in bank.

Examples:
  momentous list                                            the problems of the bank
  momentous generate impact/two-carts --seed 7 --solution   a sheet and its worked solution
  momentous grade --problem impact/two-carts --seed 1 --answer \"v_A2=-0.500 m/s\"
  momentous new impact/my-carts                             a problem of your own to start from
  momentous check my-carts.yaml                             whether it keeps every promise

Exit codes:
  0  fine
  1  a promise is broken, or an answer is not fully right
  2  the input cannot be used: a file that is missing or does not load, an answer that cannot be read
  3  the solver is stuck";

#[derive(Debug, Subcommand)]
enum Command {
    List(list::List),
    Chart(chart::Chart),
    Check(check::Check),
    Diagnose(diagnose::Diagnose),
    Export(export::Export),
    Gallery(gallery::Gallery),
    Generate(generate::Generate),
    Init(init::Init),
    Simulate(simulate::Simulate),
    Solve(solve::Solve),
    Grade(grade::Grade),
    New(new::New),
    Page(page::Page),
    Secret(secret::Secret),
    #[cfg(feature = "serve")]
    Serve(serve::Serve),
    Show(show::Show),
    Snapshot(snapshot::Snapshot),
    Schema(schema::Schema),
    Templates(templates::Templates),
    Completions(completions::Completions),
}

/// Runs the program with these arguments, its own name first; gives the exit code.
///
/// ```
/// use momentous::cli::{Exit, run};
/// assert_eq!(run(["momentous", "schema", "--help"]), Exit::Fine);
/// assert_eq!(run(["momentous", "solve", "no/such-problem"]), Exit::Unusable);
/// ```
pub fn run<I, T>(arguments: I) -> Exit
where
    I: IntoIterator<Item = T>,
    T: Into<OsString> + Clone,
{
    let outcome = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli.command.run(),
        Err(error) => {
            if error.use_stderr() {
                failure::tell(error.render().to_string().trim_end());
                return Exit::Unusable;
            }
            // Where even the terminal is gone there is nobody left to tell.
            let _ = error.print();
            return Exit::Fine;
        }
    };
    outcome.unwrap_or_else(|failure| failure.report())
}

impl Command {
    fn run(&self) -> Result<Exit, Failure> {
        match self {
            Self::List(list) => list.run(),
            Self::Chart(chart) => chart.run(),
            Self::Check(check) => check.run(),
            Self::Diagnose(diagnose) => diagnose.run(),
            Self::Export(export) => export.run(),
            Self::Gallery(gallery) => gallery.run(),
            Self::Generate(generate) => generate.run(),
            Self::Init(init) => init.run(),
            Self::Simulate(simulate) => simulate.run(),
            Self::Solve(solve) => solve.run(),
            Self::Grade(grade) => grade.run(),
            Self::New(new) => new.run(),
            Self::Page(page) => page.run(),
            Self::Secret(secret) => secret.run(),
            #[cfg(feature = "serve")]
            Self::Serve(serve) => serve.run(),
            Self::Show(show) => show.run(),
            Self::Snapshot(snapshot) => snapshot.run(),
            Self::Schema(schema) => schema.run(),
            Self::Templates(templates) => templates.run(),
            Self::Completions(completions) => completions.run(&mut Cli::command()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_hold_together() {
        Cli::command().debug_assert();
    }

    #[test]
    fn every_subcommand_teaches_by_example() {
        for command in Cli::command().get_subcommands() {
            let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(help.contains(&format!("momentous {}", command.get_name())), "{}", command.get_name());
        }
    }
}
