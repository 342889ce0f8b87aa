//! `momentous serve user`

use clap::Args;
use clap::Subcommand;

use crate::course::MailAddress;
use crate::course_pages::Clock;
use crate::course_pages::invite;
use crate::store::{Store, StoreFault};

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
    Mail(Mail),
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

/// Set the e-mail address of a person, to which links to sign in are sent
#[derive(Args, Debug)]
struct Mail {
    #[command(flatten)]
    data: Data,
    /// The name by which the person signs in
    login: String,
    /// The address
    #[arg(id = "mail_address", value_name = "ADDRESS", required_unless_present = "remove")]
    address: Option<String>,
    /// Remove the address that is saved
    #[arg(long, conflicts_with = "mail_address")]
    remove: bool,
}

impl Mail {
    fn run(&self) -> Result<Exit, Failure> {
        let address = self.address.as_deref().map(MailAddress::read).transpose();
        let address = address.map_err(|fault| Failure::unusable(fault.to_string()))?;
        let set =
            async |store: Store| invite::set_address(&store, &self.login, address.as_ref(), &Clock::default()).await;
        if !self.data.beside(set)? {
            return Err(nobody(&self.login));
        }
        Output::whole(None, "The address is saved.\n")?;
        Ok(Exit::Fine)
    }
}

fn nobody(login: &str) -> Failure {
    Failure::unusable(format!("nobody signs in as `{login}`"))
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
                .ok_or_else(|| nobody(login))?,
            Command::Mail(mail) => return mail.run(),
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
