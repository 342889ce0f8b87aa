//! `momentous completions`

use clap::Args;
use clap::Command;
use clap_complete::Shell;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;

const HELP: &str = "\
Examples:
  momentous completions bash > ~/.local/share/bash-completion/completions/momentous
  momentous completions fish > ~/.config/fish/completions/momentous.fish
  momentous completions zsh > ~/.zfunc/_momentous";

/// Print what a shell needs to complete commands as you type
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    /// Writes it for these commands.
    pub(super) fn run(&self, commands: &mut Command) -> Result<Exit, Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, commands, "momentous", &mut script);
        Output::whole(None, &script)?;
        Ok(Exit::Fine)
    }
}
