//! `momentous serve`

mod base_url;
#[cfg(feature = "courses")]
mod courses;
#[cfg(not(feature = "courses"))]
#[path = "without_courses.rs"]
mod courses;
mod setup;
mod unserved;

use std::net::SocketAddr;

use clap::Args;

use crate::web::Settings;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;
use courses::{Beside, HELP};
use setup::Setup;

/// Serve practice, simulators and, where they are built in, courses as web pages
#[derive(Args, Debug)]
#[command(after_help = HELP, args_conflicts_with_subcommands = true)]
pub(super) struct Serve {
    #[command(subcommand)]
    command: Option<Beside>,
    #[command(flatten)]
    setup: Setup,
    /// Say nothing on standard error of the requests that were answered
    #[arg(long)]
    quiet: bool,
}

impl Serve {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        match &self.command {
            Some(command) => command.run(),
            None => self.serve(),
        }
    }

    fn serve(&self) -> Result<Exit, Failure> {
        let settings = Settings { log: !self.quiet, ..self.setup.settings() };
        let path = settings.base_path.clone();
        let ready = |address: SocketAddr, first: Option<String>| self.tell(address, &path, first.as_deref());
        self.setup.courses.serve(settings, ready)?;
        Ok(Exit::Fine)
    }

    /// Says where the pages are, and how the first operator signs in.
    fn tell(&self, address: SocketAddr, path: &str, first: Option<&str>) {
        let base_url = &self.setup.base_url;
        let page = |path: &str| match &base_url.host {
            Some(host) => format!("{}://{host}{path}", if base_url.is_secure { "https" } else { "http" }),
            None => format!("http://{address}{path}"),
        };
        let first = first.map_or_else(String::new, |link| {
            let link = page(&format!("{path}{link}"));
            format!("Nobody can sign in yet. This link makes you the operator, once: {link}\n")
        });
        let text = format!("momentous serves {}\n{first}Ctrl-C stops it.\n", page(&format!("{path}/")));
        // Where nobody reads standard output there is nobody to tell.
        let _ = Output::whole(None, &text);
    }
}
