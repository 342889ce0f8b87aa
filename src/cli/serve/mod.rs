//! `momentous serve`

mod base_url;
mod check;
mod copy;
mod data;
mod finding;
mod folder;
mod health;
mod retention;
mod setup;
mod user;

use clap::Args;
use clap::Subcommand;

use crate::web::Clock;
use crate::web::NotServed;
use crate::web::Settings;
use crate::web::serve;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;
use setup::Setup;

const HELP: &str = "\
Examples:
  momentous serve                                    practice, simulators and courses on http://127.0.0.1:8080
  momentous serve --bind 0.0.0.0:80                  for everybody who reaches this machine
  momentous serve --base-url https://physics.example.edu/momentous
  momentous serve --data postgres://momentous:password@db/courses
  momentous serve --watch problem_bank               an author's preview: pages follow the files as they are saved
  momentous serve user add ada --operator            a link with which Ada signs in and runs the server
  momentous serve check                              what is misconfigured, with the way out
  momentous serve backup 2026-11-30.sqlite           a copy of everything, while the server works

Ctrl-C stops it. docs/serving.md has the rest: proxy, service, backup, upgrade.";

/// Serve practice, simulators and courses as web pages
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

/// What is done to the data while the server works, or before it starts.
#[derive(Debug, Subcommand)]
enum Beside {
    Backup(copy::Backup),
    Check(check::Check),
    Restore(copy::Restore),
    Retention(retention::Retention),
    User(user::User),
}

impl Serve {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        match &self.command {
            Some(Beside::Backup(backup)) => backup.run(),
            Some(Beside::Check(check)) => check.run(),
            Some(Beside::Restore(restore)) => restore.run(),
            Some(Beside::Retention(retention)) => retention.run(),
            Some(Beside::User(user)) => user.run(),
            None => self.serve(),
        }
    }

    fn serve(&self) -> Result<Exit, Failure> {
        let settings = Settings { log: !self.quiet, ..self.setup.settings() };
        let (base_url, path) = (&self.setup.base_url, settings.base_path.clone());
        let told = serve(settings, Clock::default(), |address, first| {
            let page = |path: &str| match &base_url.host {
                Some(host) => format!("{}://{host}{path}", if base_url.is_secure { "https" } else { "http" }),
                None => format!("http://{address}{path}"),
            };
            let first = first.map_or_else(String::new, |link| {
                format!(
                    "Nobody can sign in yet. This link makes you the operator, once: {}\n",
                    page(&format!("{path}{link}"))
                )
            });
            // Where nobody reads standard output there is nobody to tell.
            let _ = Output::whole(
                None,
                &format!("momentous serves {}\n{first}Ctrl-C stops it.\n", page(&format!("{path}/"))),
            );
        });
        told.map_err(|reason| match reason {
            NotServed::Faults(faults) => Failure::from(faults),
            NotServed::Address(..) => {
                Failure::unusable(format!("{reason}\nhelp: choose another with --bind, such as 127.0.0.1:8081"))
            }
            NotServed::Data(fault) => self.setup.data.failure(&fault),
            NotServed::Broken(_) => Failure::unusable(reason.to_string()),
        })?;
        Ok(Exit::Fine)
    }
}
