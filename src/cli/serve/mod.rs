//! `momentous serve`

mod base_url;
#[cfg(feature = "courses")]
mod check;
#[cfg(feature = "courses")]
mod copy;
#[cfg(feature = "courses")]
mod data;
#[cfg(feature = "courses")]
mod finding;
#[cfg(feature = "courses")]
mod folder;
#[cfg(feature = "courses")]
mod health;
#[cfg(feature = "courses")]
mod retention;
mod setup;
#[cfg(feature = "courses")]
mod user;
#[cfg(not(feature = "courses"))]
mod without_courses;

use std::net::SocketAddr;

use clap::Args;
use clap::Subcommand;

#[cfg(feature = "courses")]
use crate::course_pages::Clock;
#[cfg(feature = "courses")]
use crate::store::StoreFault;
use crate::web::NotServed;
use crate::web::Settings;

use super::exit::Exit;
use super::failure::Failure;
use super::output::Output;
use setup::Setup;

#[cfg(feature = "courses")]
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

#[cfg(not(feature = "courses"))]
const HELP: &str = "\
Examples:
  momentous serve                                    practice and simulators on http://127.0.0.1:8080
  momentous serve --bind 0.0.0.0:80                  for everybody who reaches this machine
  momentous serve --watch problem_bank               an author's preview: pages follow the files as they are saved

Ctrl-C stops it. Courses are a feature of the program: build it with `--features courses`. docs/serving.md has the rest.";

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

/// Work on the data while the server runs, or before it starts.
#[cfg(feature = "courses")]
#[derive(Debug, Subcommand)]
enum Beside {
    Backup(copy::Backup),
    Check(check::Check),
    Restore(copy::Restore),
    Retention(retention::Retention),
    User(user::User),
}

/// The commands of a program that was built with courses.
#[cfg(not(feature = "courses"))]
#[derive(Debug, Subcommand)]
enum Beside {
    #[command(external_subcommand)]
    OfCourses(Vec<String>),
}

impl Serve {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        match &self.command {
            #[cfg(feature = "courses")]
            Some(Beside::Backup(backup)) => backup.run(),
            #[cfg(feature = "courses")]
            Some(Beside::Check(check)) => check.run(),
            #[cfg(feature = "courses")]
            Some(Beside::Restore(restore)) => restore.run(),
            #[cfg(feature = "courses")]
            Some(Beside::Retention(retention)) => retention.run(),
            #[cfg(feature = "courses")]
            Some(Beside::User(user)) => user.run(),
            #[cfg(not(feature = "courses"))]
            Some(Beside::OfCourses(words)) => Err(without_courses::command(words)),
            None => self.serve(),
        }
    }

    fn serve(&self) -> Result<Exit, Failure> {
        let settings = Settings { log: !self.quiet, ..self.setup.settings() };
        let path = settings.base_path.clone();
        let ready = |address: SocketAddr, first: Option<String>| self.tell(address, &path, first.as_deref());
        self.served(settings, ready)?;
        Ok(Exit::Fine)
    }

    /// Serves with courses, unless they are left out.
    #[cfg(feature = "courses")]
    fn served(&self, settings: Settings, ready: impl FnOnce(SocketAddr, Option<String>)) -> Result<(), Failure> {
        let served = if self.setup.no_courses {
            crate::web::serve(settings, async { Ok(None) }, |address| ready(address, None))
        } else {
            crate::course_pages::serve(settings, &self.setup.data.address, Clock::default(), ready)
        };
        served.map_err(|reason| match reason {
            NotServed::Data(fault) => match fault.downcast::<StoreFault>() {
                Ok(fault) => self.setup.data.failure(&fault),
                Err(other) => Failure::unusable(other.to_string()),
            },
            other => failure(other),
        })
    }

    #[cfg(not(feature = "courses"))]
    fn served(&self, settings: Settings, ready: impl FnOnce(SocketAddr, Option<String>)) -> Result<(), Failure> {
        self.setup.courses.refuse()?;
        crate::web::serve(settings, async { Ok(None) }, |address| ready(address, None)).map_err(failure)
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

/// The reason for which nothing is served, with the way out.
fn failure(reason: NotServed) -> Failure {
    match reason {
        NotServed::Faults(faults) => Failure::from(faults),
        NotServed::Address(..) => {
            Failure::unusable(format!("{reason}\nhelp: choose another with --bind, such as 127.0.0.1:8081"))
        }
        NotServed::Data(_) | NotServed::Broken(_) => Failure::unusable(reason.to_string()),
    }
}
