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
        let built_in = Bank::built_in();
        let built_in = built_in.find(&self.problem);
        // The course's own file goes before the built-in one of that name, and its refusal says what else there is.
        let source = match (Bank::here()?.open(&self.problem), built_in) {
            (Ok(source), _) => source,
            (Err(_), Ok(source)) => source.clone(),
            (Err(refused), Err(_)) => return Err(refused.into()),
        };
        Output::whole(None, &*source.text)?;
        Ok(Exit::Fine)
    }
}
