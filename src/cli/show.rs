//! `momentous show`

use clap::Args;

use crate::bank::Bank;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;

const HELP: &str = "\
Examples:
  momentous show impact/two-carts
  momentous show impact/two-carts > problem_bank/impact/my-carts.yaml   then give it an `id` of its own";

/// Print the file of a problem
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Show {
    /// The problem's identity
    #[arg(value_name = "PROBLEM")]
    problem: String,
}

impl Show {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        Output::whole(None, &*Bank::here()?.open(&self.problem)?.text)?;
        Ok(Exit::Fine)
    }
}
