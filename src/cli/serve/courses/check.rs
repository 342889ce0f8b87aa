//! `momentous serve check`

use std::io::Write;
use std::net::TcpListener;
use std::time::SystemTime;

use clap::Args;

use crate::bank::{Bank, load_in_course};
use crate::course::Moment;
use crate::problem::compile;
use crate::store::{Address, Inspection, StoreFault};
use crate::web::{App, page_faults};

use super::super::super::exit::Exit;
use super::super::super::failure::Failure;
use super::super::super::output::Output;
use super::super::super::style::Style;
use super::super::setup::Setup;
use super::data::runtime;
use super::finding::Finding;
use super::folder;
use super::health;

/// Say what is misconfigured, and the way out; nothing is changed. Give it the options of the server
#[derive(Args, Debug)]
pub(in crate::cli::serve) struct Check {
    #[command(flatten)]
    setup: Setup,
    /// The server runs already: its folder is locked and its address is taken
    #[arg(long)]
    running: bool,
}

/// By how many milliseconds two clocks may differ.
const APART: i64 = 10_000;
/// No clock is right that says an earlier moment: the beginning of 2026.
const EARLIEST: Moment = Moment::from_millis(1_767_225_600_000);

impl Check {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let mut findings = self.pages();
        findings.extend(self.addresses());
        if !self.setup.courses.practice_only {
            findings.extend(self.data()?);
            findings.extend(self.mail()?);
        }
        let (style, mut output) = (Style::of_stdout(), Output::to(None)?);
        for finding in &findings {
            match finding {
                Finding::Fine(what) => writeln!(output, "{}   {what}", style.good("fine"))?,
                Finding::Note(what) => writeln!(output, "{}   {what}", style.note("note"))?,
                Finding::Wrong { what, help } => {
                    writeln!(output, "{}  {}\n       help: {help}", style.bad("wrong"), what.trim_end())?;
                }
            }
        }
        output.finish()?;
        Ok(if findings.iter().any(Finding::is_wrong) { Exit::NotRight } else { Exit::Fine })
    }

    /// Whether every problem loads and every template is filled.
    fn pages(&self) -> Vec<Finding> {
        let bank = self.setup.watch.as_deref().map_or_else(Bank::here, Bank::in_folder);
        let sources: Vec<_> = match &bank {
            Ok(bank) => bank.sources().cloned().collect(),
            Err(faults) => return vec![Finding::wrong(faults.to_string(), "mend the folder of the problems")],
        };
        let count = sources.len();
        let fails = sources.into_iter().filter_map(|source| {
            let faults = load_in_course(source).and_then(|loaded| compile(loaded, None)).err()?;
            let help = format!("`momentous check {}` says more, once it loads", faults.source.name);
            Some(Finding::wrong(faults.to_string(), help))
        });
        let mut findings: Vec<Finding> = fails.collect();
        if findings.is_empty() {
            findings.push(Finding::fine(format!("{count} problems load")));
        }
        let settings = self.setup.settings();
        let faults = App::new(settings).map_or_else(|faults| vec![faults.to_string()], |app| page_faults(&app));
        let help = "mend the template in the folder of --templates, or take it away: the built-in one is used then";
        if faults.is_empty() {
            findings.push(Finding::fine("the templates of the pages are filled"));
        }
        findings.extend(faults.into_iter().map(|what| Finding::wrong(what, help)));
        findings
    }

    /// Whether the addresses are free, and nothing goes readably through a network.
    fn addresses(&self) -> Vec<Finding> {
        let Setup { bind, base_url, trusted_proxy, metrics, courses, .. } = &self.setup;
        let practice_only = courses.practice_only;
        let mut findings = Vec::new();
        if self.running {
            findings.push(health::finding(*bind, &base_url.path));
        } else {
            for (address, option) in [(Some(bind), "--bind"), (metrics.as_ref(), "--metrics")] {
                let Some(address) = address else { continue };
                findings.push(match TcpListener::bind(address) {
                    Ok(_) => Finding::fine(format!("{address} is free")),
                    Err(error) => Finding::wrong(
                        format!("{address} cannot be used: {error}"),
                        format!("choose another with {option}; --running checks a server that runs already"),
                    ),
                });
            }
        }
        let is_reached = !bind.ip().is_loopback() || base_url.host.is_some();
        if is_reached && !base_url.is_secure && !practice_only {
            let help = "put a proxy with TLS before it, let it listen to that alone (--bind 127.0.0.1:8080), and name the address \
                of the pages: --base-url https://physics.example.edu";
            let what = format!("passwords and answers go through the network as anyone can read them, to {bind}");
            findings.push(Finding::wrong(what, help));
        }
        if base_url.host.is_some() && bind.ip().is_loopback() && trusted_proxy.is_empty() && !practice_only {
            let help = "name the proxy: --trusted-proxy 127.0.0.1";
            let what = "every reader seems to come from the proxy, so that whoever tries passwords for a name keeps its owner out";
            findings.push(Finding::wrong(what, help));
        }
        if metrics.is_some_and(|metrics| metrics == *bind && metrics.port() != 0) {
            let what = format!("the pages and what is measured are both to be served on {bind}");
            findings.push(Finding::wrong(what, "choose another port with --metrics"));
        }
        if let Some(metrics) = metrics.filter(|metrics| !metrics.ip().is_loopback()) {
            findings.push(Finding::Note(format!("whoever reaches {metrics} reads how busy the server is")));
        }
        findings
    }

    /// Whether the server of mail answers, and nobody else reads the letters.
    fn mail(&self) -> Result<Vec<Finding>, Failure> {
        let mail = &self.setup.courses.mail;
        let post = match mail.post(&self.setup.settings()) {
            Ok(Some(post)) => post,
            Ok(None) => return Ok(Vec::new()),
            Err(failure) => return Ok(vec![Finding::wrong(failure.to_string(), "docs/serving.md has examples")]),
        };
        let help = "compare --smtp with what whoever runs the server of mail says: its name, port, TLS, and your name and password there";
        let mut findings = vec![match runtime()?.block_on(post.answers()) {
            Ok(()) => Finding::fine("the server of mail answers"),
            Err(reason) => Finding::wrong(format!("the server of mail cannot be used: {reason}"), help),
        }];
        if mail.is_readable() {
            let help = "use smtps://, or add ?tls=required to the address";
            findings
                .push(Finding::wrong("links to sign in may go to the server of mail as anyone can read them", help));
        }
        Ok(findings)
    }

    /// Whether the data can be used, are private, and agree with the clock.
    fn data(&self) -> Result<Vec<Finding>, Failure> {
        let address = &self.setup.courses.data.address;
        let mut findings = match address {
            Address::Folder(path) => folder::findings(path),
            Address::Postgres(_) => Vec::new(),
        };
        if findings.iter().any(Finding::is_wrong) && !is_there(address) {
            return Ok(findings);
        }
        match runtime()?.block_on(Inspection::of(address)) {
            Ok(inspection) => findings.extend(self.inspected(&inspection)),
            Err(fault) => findings.push(Finding::wrong(format!("{address}: {fault}"), help(address, &fault))),
        }
        Ok(findings)
    }

    fn inspected(&self, inspection: &Inspection) -> Vec<Finding> {
        let address = &self.setup.courses.data.address;
        let mut findings = vec![match inspection.version {
            None => Finding::Note(format!("{address} is empty: the first start prints a link for the operator")),
            Some(version) if inspection.is_earlier() => Finding::Note(format!(
                "the data are of version {version}: the next start brings them to this program's; make a backup before"
            )),
            Some(version) => Finding::fine(format!("{address} answers, with data of version {version}")),
        }];
        let is_folder = matches!(address, Address::Folder(_));
        if inspection.is_served && !self.running {
            let help =
                "stop that server, or choose another folder with --data; --running checks a server that runs already";
            findings.push(Finding::wrong(format!("another server works on {address}"), help));
        } else if self.running && is_folder && !inspection.is_served {
            findings.push(Finding::wrong(
                format!("no server works on {address}"),
                "start it, or name its folder with --data",
            ));
        }
        if inspection.lacks_rights {
            let help = "`GRANT CREATE ON SCHEMA public TO` the user, or make it the owner of the database";
            findings.push(Finding::wrong(format!("{address}: the user may not make tables there"), help));
        }
        findings.extend(inspection.unsafe_settings.iter().map(|name| unsafe_setting(address, name)));
        findings.push(clock(now(), inspection));
        findings
    }
}

fn is_there(address: &Address) -> bool {
    match address {
        Address::Folder(folder) => folder.is_dir(),
        Address::Postgres(_) => true,
    }
}

fn help(address: &Address, fault: &StoreFault) -> &'static str {
    match (fault, address) {
        (StoreFault::Newer { .. }, _) => {
            "start the program that wrote them, or a later one; a backup of before the upgrade can be restored"
        }
        (StoreFault::Folder(..), _) => {
            "let the user of the server read and write the folder, or choose another with --data"
        }
        (_, Address::Folder(_)) => {
            "let the user of the server read and write the files in it; where they are damaged, restore a backup into another folder"
        }
        (_, Address::Postgres(_)) => {
            "see whether the database runs, and whether --data names its host, user, password and name rightly"
        }
    }
}

/// A setting of a database server by which answers can be lost that students were told are kept.
fn unsafe_setting(address: &Address, name: &str) -> Finding {
    Finding::wrong(
        format!("{address}: `{name}` is off, so that a loss of power can take away what students were told is kept"),
        format!("`ALTER SYSTEM SET {name} = on`, then `SELECT pg_reload_conf()`"),
    )
}

fn now() -> Moment {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    Moment::from_millis(i64::try_from(since.as_millis()).unwrap_or(i64::MAX))
}

/// Whether the clock can be right: what students hand in is timed by it.
fn clock(now: Moment, inspection: &Inspection) -> Finding {
    let help = "set the clock, best by NTP (`timedatectl set-ntp true`): what is in time is decided by it";
    let apart = |other: Moment| now.millis().saturating_sub(other.millis());
    if now < EARLIEST {
        return Finding::wrong(format!("the clock says {now}"), help);
    }
    if let Some(other) = inspection.now.filter(|other| apart(*other).abs() > APART) {
        return Finding::wrong(format!("the clock says {now}, and that of the database {other}"), help);
    }
    if let Some(latest) = inspection.latest.filter(|latest| apart(*latest) < -APART) {
        return Finding::wrong(format!("the clock says {now}, and something was noted at {latest} already"), help);
    }
    Finding::fine(format!("the clock says {now}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_that_cannot_be_right_is_told() {
        let at = |hour: i64| EARLIEST.after(hour * 3_600_000);
        let inspection = |latest, now| Inspection { latest, now, ..Inspection::default() };
        for (now, inspected, is_wrong) in [
            (at(0), inspection(None, None), false),
            (at(-1), inspection(None, None), true),
            (at(1), inspection(Some(at(0)), None), false),
            (at(1), inspection(Some(at(2)), None), true),
            (at(1), inspection(None, Some(at(1))), false),
            (at(1), inspection(None, Some(at(2))), true),
            (at(2), inspection(None, Some(at(1))), true),
        ] {
            assert_eq!(clock(now, &inspected).is_wrong(), is_wrong, "{now}, {inspected:?}");
        }
    }
}
