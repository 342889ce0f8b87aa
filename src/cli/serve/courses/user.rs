//! `momentous serve user`

use clap::Args;
use clap::Subcommand;

use crate::course_pages::Clock;
use crate::course_pages::invite;
use crate::store::StoreFault;

use super::super::super::exit::Exit;
use super::super::super::failure::Failure;
use super::super::super::output::Output;
use super::data::Data;

/// Let somebody sign in
#[derive(Args, Debug)]
pub(in crate::cli::serve) struct User {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Add(Add),
    Link(Link),
}

/// Add a person, and print a link with which it signs in
#[derive(Args, Debug)]
struct Add {
    #[command(flatten)]
    data: Data,
    /// The name by which the person signs in
    login: String,
    /// What the person is called
    #[arg(long)]
    name: Option<String>,
    /// The person runs the server: it makes courses and appoints who teaches them
    #[arg(long)]
    operator: bool,
}

/// Print a new link for a person who lost the password
#[derive(Args, Debug)]
struct Link {
    #[command(flatten)]
    data: Data,
    /// The name by which the person signs in
    login: String,
}

impl User {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let link = match &self.command {
            Command::Add(Add { data, login, name, operator }) => {
                let name = name.clone().unwrap_or_else(|| login.clone());
                data.beside(async |store| invite::add(&store, login, &name, *operator, &Clock::default()).await)?
                    .ok_or_else(|| Failure::unusable(format!("somebody signs in as `{login}` already\nhelp: `momentous serve user link {login}` prints a new link")))?
            }
            Command::Link(Link { data, login }) => data
                .beside(async |store| -> Result<_, StoreFault> {
                    invite::link(&store, login, &Clock::default()).await
                })?
                .ok_or_else(|| Failure::unusable(format!("nobody signs in as `{login}`")))?,
        };
        Output::whole(
            None,
            &format!(
                "{link}\nThis is the end of a link: put the address of the server before it. It works once, for two weeks.\n"
            ),
        )?;
        Ok(Exit::Fine)
    }
}
