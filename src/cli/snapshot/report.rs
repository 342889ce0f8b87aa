//! Changes for the log of a job and as a page.

use std::fmt::Write as _;
use std::io::Write;

use similar::TextDiff;

use crate::cli::exit::Exit;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::style::Style;
use crate::render::base64;

use super::change::{Change, Changed, summary};
use super::kept::Kept;
use super::page::Kind;

/// Equal lines that stand around a change.
const CONTEXT: usize = 3;

/// Says what differs, a summary first.
pub(super) fn tell(changes: &[Change], kept: &Kept, count: usize) -> Result<Exit, Failure> {
    let style = Style::of_stdout();
    let mut output = Output::to(None)?;
    if changes.is_empty() && kept.former.is_empty() {
        writeln!(output, "{count} snapshots, all unchanged")?;
        output.finish()?;
        return Ok(Exit::Fine);
    }
    if !changes.is_empty() {
        writeln!(output, "{}", style.strong(&summary(changes)))?;
    }
    for change in changes {
        writeln!(output, "  {}: {}", change.problem, change.character())?;
    }
    if !kept.former.is_empty() {
        writeln!(output, "  {} files are of an earlier version of the program", kept.former.len())?;
    }
    for change in changes {
        write_change(&mut output, style, change)?;
    }
    writeln!(output, "`momentous snapshot --review` asks about each, `momentous snapshot --accept` accepts them")?;
    output.finish()?;
    Ok(Exit::NotRight)
}

/// The change of a problem: its lines, and of figures their place.
pub(super) fn write_change(output: &mut Output, style: Style, change: &Change) -> Result<(), Failure> {
    writeln!(output, "\n{}", style.strong(&format!("{}: {}", change.problem, change.character())))?;
    for file in &change.files {
        match (&file.before, &file.now) {
            (None, _) => writeln!(output, "{} {}", style.note("new, not accepted yet:"), file.name)?,
            (_, None) => writeln!(output, "{} {}", style.note("no problem produces it any more:"), file.name)?,
            (Some(_), Some(_)) if file.kind == Kind::Figures => {
                let look = "other figures (`--page changes.html` shows them before and now):";
                writeln!(output, "{} {}", style.note(look), file.name)?;
            }
            (Some(before), Some(now)) => {
                for line in diff(file, before, now).lines() {
                    let shown = match line.as_bytes().first() {
                        Some(b'-') => style.bad(line),
                        Some(b'+') => style.good(line),
                        _ => line.to_owned(),
                    };
                    writeln!(output, "{shown}")?;
                }
            }
        }
    }
    Ok(())
}

fn diff(changed: &Changed, before: &str, now: &str) -> String {
    let diff = TextDiff::from_lines(before, now);
    diff.unified_diff().context_radius(CONTEXT).header(&changed.name, &format!("{}, now", changed.name)).to_string()
}

/// All changes as a page that needs no other file.
pub(super) fn page(changes: &[Change]) -> String {
    let plain = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let mut body = String::new();
    for change in changes {
        // Writing to a string cannot fail.
        let _ = writeln!(body, "<h2>{}: {}</h2>", plain(&change.problem), change.character());
        for file in &change.files {
            match (file.kind, &file.before, &file.now) {
                (Kind::Figures, before, now) => {
                    for (label, text) in [("Before", before), ("Now", now)] {
                        let Some(text) = text else { continue };
                        let _ = writeln!(
                            body,
                            "<figure><figcaption>{label}: {}</figcaption><img alt=\"{label}\" src=\"data:image/svg+xml;base64,{}\"></figure>",
                            plain(&file.name),
                            base64(text.as_bytes())
                        );
                    }
                }
                (_, Some(before), Some(now)) => {
                    let _ = writeln!(body, "<pre>{}</pre>", plain(&diff(file, before, now)));
                }
                (_, None, _) => {
                    let _ = writeln!(body, "<p>New: {}</p>", plain(&file.name));
                }
                (_, _, None) => {
                    let _ = writeln!(body, "<p>No problem produces it any more: {}</p>", plain(&file.name));
                }
            }
        }
    }
    let title = if changes.is_empty() { "No snapshot has changed".to_owned() } else { summary(changes) };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\n\
         <style>body{{font-family:sans-serif;margin:2em}}figure{{display:inline-block;vertical-align:top;max-width:45%;margin:0 1em 1em 0}}img{{max-width:100%}}pre{{overflow-x:auto}}</style>\n\
         </head><body><h1>{title}</h1>\n{body}</body></html>\n"
    )
}
