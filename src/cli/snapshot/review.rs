//! Changes one by one, each to accept or to reject.

use std::io::{BufRead, Write};

use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::style::Style;

use super::change::{Change, summary};
use super::kept::Kept;
use super::report::write_change;

/// The decision about a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Decision {
    /// The snapshots are written as they are now.
    Accept,
    /// The snapshots stay, and the problem is to be changed back.
    Reject,
    /// It is left for another time.
    Skip,
    /// Leave this and all others.
    Quit,
}

impl Decision {
    fn of(answer: &str) -> Option<Self> {
        match answer.trim().to_lowercase().as_str() {
            "a" | "accept" => Some(Self::Accept),
            "r" | "reject" => Some(Self::Reject),
            "s" | "skip" => Some(Self::Skip),
            "q" | "quit" => Some(Self::Quit),
            _ => None,
        }
    }
}

/// Asks about each change; whoever is asked answers in lines. The exit code is 0 if everything was accepted.
pub(super) fn review(changes: &[Change], kept: &Kept, answers: &mut impl BufRead) -> Result<Exit, Failure> {
    let style = Style::of_stdout();
    let mut output = Output::to(None)?;
    let (mut accepted, mut rejected) = (0, Vec::new());
    if changes.is_empty() {
        writeln!(output, "no snapshot has changed")?;
    } else {
        writeln!(output, "{}", style.strong(&summary(changes)))?;
    }
    for (change, place) in changes.iter().zip(1..) {
        write_change(&mut output, style, change)?;
        match decide(&mut output, &format!("{place} of {}", changes.len()), answers)? {
            Decision::Accept => {
                kept.accept(change)?;
                accepted += 1;
            }
            Decision::Reject => rejected.push(change.problem.as_str()),
            Decision::Skip => {}
            Decision::Quit => break,
        }
    }
    if !changes.is_empty() {
        let left = changes.len() - accepted - rejected.len();
        writeln!(output, "\n{accepted} accepted, {} rejected, {left} left", rejected.len())?;
    }
    for problem in &rejected {
        writeln!(output, "rejected: {problem}; its snapshots stay, so change its file back")?;
    }
    output.finish()?;
    Ok(if accepted == changes.len() { Exit::Fine } else { Exit::NotRight })
}

/// Asks until there is an answer; where nobody answers any more, everything is left.
fn decide(output: &mut Output, place: &str, answers: &mut impl BufRead) -> Result<Decision, Failure> {
    loop {
        write!(output, "\n{place}: accept (a), reject (r), skip (s) or quit (q)? ")?;
        output.flush()?;
        let mut line = String::new();
        if answers.read_line(&mut line)? == 0 {
            return Ok(Decision::Quit);
        }
        if let Some(decision) = Decision::of(&line) {
            return Ok(decision);
        }
    }
}
