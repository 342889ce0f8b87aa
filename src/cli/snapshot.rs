//! `momentous snapshot`

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use rayon::prelude::*;
use similar::TextDiff;

use crate::exercise::Exercise;
use crate::fault::Input;
use crate::problem::Problem;
use crate::render::Format;
use crate::render::Page;
use crate::render::Renderer;

use super::exit::Exit;
use super::failure::Failure;
use super::open;
use super::output::Output;
use super::output::file_stem;
use super::pages;
use super::pages::Shown;
use super::style::Style;

const HELP: &str = "\
Examples:
  momentous snapshot --accept                  write snapshots/ for every problem of the bank
  momentous snapshot                           in the course's CI: compare, show what differs, exit with 1
  momentous snapshot homework/ --folder golden

A snapshot holds the sheet, the worked solution and the JSON object of a form at fixed seeds. Commit the folder.";

/// The seeds of snapshots.
const SEEDS: [u64; 3] = [1, 2, 3];

/// Equal lines that stand around a change.
const CONTEXT: usize = 3;

/// The longest snapshot that is read, in bytes.
const LARGEST: u64 = 1 << 24;

/// Keep golden snapshots of problems, so that no change goes unnoticed
#[derive(Args, Debug)]
#[command(after_help = HELP)]
pub(super) struct Snapshot {
    /// Identities, topics, files or folders; the whole bank if nothing is named
    #[arg(value_name = "PATH")]
    problems: Vec<String>,
    /// Compare and show what differs; this is the default
    #[arg(long)]
    check: bool,
    /// Write new and changed snapshots
    #[arg(long, conflicts_with = "check")]
    accept: bool,
    /// The folder of the snapshots
    #[arg(long, value_name = "FOLDER", default_value = "snapshots")]
    folder: PathBuf,
}

impl Snapshot {
    pub(super) fn run(&self) -> Result<Exit, Failure> {
        let problems = open::problems(&self.problems, None)?;
        let renderer = pages::renderer()?;
        let made: Vec<_> =
            problems.par_iter().map(|problem| snapshots(problem, &renderer)).collect::<Result<_, _>>()?;
        let now: BTreeMap<String, String> = made.into_iter().flatten().collect();
        let before = self.kept(&now)?;
        if self.accept { self.write(&before, &now) } else { report(&before, &now) }
    }

    /// What the folder holds: every snapshot where the whole bank is meant, else those of the problems named.
    fn kept(&self, now: &BTreeMap<String, String>) -> Result<BTreeMap<String, String>, Failure> {
        let mut names: Vec<String> = now.keys().cloned().collect();
        if self.problems.is_empty() && self.folder.is_dir() {
            let entries = fs::read_dir(&self.folder).map_err(|error| Failure::file(&self.folder, "read", &error))?;
            let all = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
            names.extend(all.filter(|name| is_snapshot(name)));
        }
        let mut kept = BTreeMap::new();
        for name in names {
            let path = self.folder.join(&name);
            if path.is_file() {
                let text = Input::open(&path)
                    .and_then(|file| file.text(LARGEST))
                    .map_err(|error| Failure::file(&path, "read", &error))?;
                kept.insert(name, text.replace("\r\n", "\n"));
            }
        }
        Ok(kept)
    }

    fn write(&self, before: &BTreeMap<String, String>, now: &BTreeMap<String, String>) -> Result<Exit, Failure> {
        let mut output = Output::to(None)?;
        for (name, text) in now.iter().filter(|(name, text)| before.get(*name) != Some(text)) {
            Output::whole(Some(&self.folder.join(name)), text)?;
            writeln!(output, "{} {name}", if before.contains_key(name) { "changed" } else { "new    " })?;
        }
        for name in before.keys().filter(|name| !now.contains_key(*name)) {
            let path = self.folder.join(name);
            fs::remove_file(&path).map_err(|error| Failure::file(&path, "removed", &error))?;
            writeln!(output, "removed {name}")?;
        }
        writeln!(output, "{} snapshots in {}", now.len(), self.folder.display())?;
        output.finish()?;
        Ok(Exit::Fine)
    }
}

/// Says what differs.
fn report(before: &BTreeMap<String, String>, now: &BTreeMap<String, String>) -> Result<Exit, Failure> {
    let style = Style::of_stdout();
    let mut output = Output::to(None)?;
    let mut differing = 0;
    let names: std::collections::BTreeSet<&String> = before.keys().chain(now.keys()).collect();
    for name in names {
        match (before.get(name), now.get(name)) {
            (Some(before), Some(now)) if before == now => continue,
            (Some(before), Some(now)) => write_diff(&mut output, style, name, before, now)?,
            (None, _) => writeln!(output, "{} {name}", style.note("new, not accepted yet:"))?,
            (_, None) => writeln!(output, "{} {name}", style.note("no problem produces it any more:"))?,
        }
        differing += 1;
    }
    match differing {
        0 => writeln!(output, "{} snapshots, all unchanged", now.len())?,
        _ => {
            writeln!(
                output,
                "{differing} of {} snapshots differ; `momentous snapshot --accept` accepts them",
                now.len()
            )?;
        }
    }
    output.finish()?;
    Ok(if differing == 0 { Exit::Fine } else { Exit::NotRight })
}

fn write_diff(output: &mut Output, style: Style, name: &str, before: &str, now: &str) -> Result<(), Failure> {
    let diff = TextDiff::from_lines(before, now);
    let text = diff.unified_diff().context_radius(CONTEXT).header(name, &format!("{name}, now")).to_string();
    for line in text.lines() {
        let shown = match line.as_bytes().first() {
            Some(b'-') => style.bad(line),
            Some(b'+') => style.good(line),
            _ => line.to_owned(),
        };
        writeln!(output, "{shown}")?;
    }
    Ok(())
}

/// The snapshots of a problem: for each form and seed the documents, and the data.
fn snapshots(problem: &Arc<Problem>, renderer: &Renderer) -> Result<Vec<(String, String)>, Failure> {
    let mut made = Vec::new();
    for (position, form) in problem.forms().iter().enumerate() {
        for seed in SEEDS {
            let exercise = Exercise::draw(problem, position, seed);
            let exercise = exercise.map_err(|reason| Failure::no_variant(problem.id(), seed, &reason))?;
            exercise.printable()?;
            let name = file_name(problem.id(), form.question.name.as_deref(), seed);
            let pages = [Page::Sheet(exercise.sheet()), Page::Solution(Shown::default().solution(&exercise))];
            let document = renderer.render(&pages, Format::Markdown)?;
            made.push((format!("{name}.md"), document.text));
            made.push((format!("{name}.json"), format!("{:#}\n", exercise.record(None))));
        }
    }
    Ok(made)
}

/// The name of a snapshot without its ending: `impact.two-carts.find-e.seed-1`.
fn file_name(id: &str, form: Option<&str>, seed: u64) -> String {
    let form = form.map(|form| format!(".{}", file_stem(form))).unwrap_or_default();
    format!("{}{form}.seed-{seed}", id.replace('/', "."))
}

/// Whether a file has the name of a snapshot; what else lies in the folder is not ours.
fn is_snapshot(name: &str) -> bool {
    let stem = name.strip_suffix(".md").or_else(|| name.strip_suffix(".json"));
    let seed = stem.and_then(|stem| stem.rsplit_once(".seed-"));
    seed.is_some_and(|(_, seed)| SEEDS.iter().any(|own| own.to_string() == seed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapshots_are_known_by_their_names() {
        let name = file_name("impact/two-carts", Some("find-e"), 2);
        assert_eq!(name, "impact.two-carts.find-e.seed-2");
        assert!(is_snapshot(&format!("{name}.md")) && is_snapshot(&format!("{name}.json")));
        assert!(["notes.md", "seed-1.md", "a.seed-x.md", "a.seed-1.txt"].iter().all(|name| !is_snapshot(name)));
    }
}
