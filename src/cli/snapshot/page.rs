//! Snapshots of one problem, by what a reviewer looks for: words, numbers, marks and figures.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::sync::Arc;

use crate::cli::failure::Failure;
use crate::cli::pages::SolutionOptions;
use crate::exercise::{Drawer, Exercise};
use crate::grade::DecimalMark;
use crate::problem::Problem;
use crate::render::{BesideFile, Format, Identity, Page, Renderer, Sheet, Solution};

/// The seeds whose sheets are listed with their numbers and answers.
const SEEDS: u64 = 40;

/// The seed whose sheet is kept as a whole, and with whose numbers answers are marked.
const WHOLE: u64 = 1;

/// The beginning of the names of figures, for the renderer of snapshots.
pub(super) const FIGURE: &str = "figure";

/// The content of a file of a snapshot. The order is that in which a change weighs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// The numbers and answers of the first sheets.
    Numbers,
    /// The marks of typical answers.
    Marks,
    /// The sheet and the worked solution.
    Words,
    /// The figures of both.
    Figures,
}

impl Kind {
    /// Every kind with the ending of its files.
    pub(super) const ENDINGS: [(Self, &str); 4] = [
        (Self::Numbers, ".numbers.csv"),
        (Self::Marks, ".marks.csv"),
        (Self::Words, ".words.md"),
        (Self::Figures, ".figures.svg"),
    ];

    /// The content of a file by its name, and its problem; none where it is no snapshot.
    pub(super) fn of(name: &str) -> Option<(Self, &str)> {
        Self::ENDINGS.iter().find_map(|(kind, ending)| Some((*kind, name.strip_suffix(ending)?)))
    }

    fn ending(self) -> &'static str {
        Self::ENDINGS[self as usize].1
    }
}

/// The snapshots of a problem by their names below the folder: `impact/two-carts.words.md`.
pub(super) fn snapshots(problem: &Arc<Problem>, renderer: &Renderer) -> Result<Vec<(String, String)>, Failure> {
    let id = problem.id();
    let (mut words, mut figures) = (format!("# {id}: {}\n", problem.title()), Vec::new());
    let mut numbers = Table::new(&["form", "seed", "given", "answers"])?;
    let mut marks = Table::new(&["form", "part", "what", "typed", "verdict", "points"])?;
    for (position, form) in problem.forms().iter().enumerate() {
        let name = form.question.name.as_deref().unwrap_or_default();
        let refused = |seed, reason| Failure::no_variant(id, seed, &reason);
        let mut drawer = Drawer::new(problem, position).map_err(|reason| refused(WHOLE, reason))?;
        for seed in 1..=SEEDS {
            let exercise = drawer.draw(seed).map_err(|reason| refused(seed, reason))?;
            let parts = &exercise.worked().form.parts;
            let answers: Vec<String> =
                parts.iter().map(|part| format!("{} = {}", part.id, exercise.printed(part))).collect();
            numbers.row(&[name, &seed.to_string(), &exercise.sheet_numbers().to_string(), &answers.join("; ")])?;
            if seed == WHOLE {
                exercise.printable()?;
                let told = marked(&exercise, name, &mut marks)?;
                let title = if name.is_empty() { String::new() } else { format!("\n# Form {name}\n") };
                let (text, beside) = written(&exercise, id, name, renderer)?;
                // Writing to a string cannot fail.
                let _ = write!(words, "{title}\n{}\n{told}", text.trim_end());
                figures.extend(beside);
            }
        }
    }
    let mut texts = vec![(Kind::Words, words), (Kind::Numbers, numbers.text()?), (Kind::Marks, marks.text()?)];
    if !figures.is_empty() {
        texts.push((Kind::Figures, album(&figures)));
    }
    Ok(texts.into_iter().map(|(kind, text)| (format!("{id}{}", kind.ending()), text)).collect())
}

/// Sheet and solution in Markdown, which refer to the figures beside it.
fn written(
    exercise: &Exercise,
    id: &str,
    form: &str,
    renderer: &Renderer,
) -> Result<(String, Vec<BesideFile>), Failure> {
    // A digest says that something has changed, and not what.
    let identity = Identity { digest: None, scheme: None, ..exercise.identity() };
    let sheet = Page::Sheet(Sheet { identity: identity.clone(), ..exercise.sheet() });
    let solution = Page::Solution(Solution { identity, ..SolutionOptions::default().solution(exercise) });
    let name = id.rsplit_once('/').map_or(id, |(_, name)| name);
    let form = if form.is_empty() { FIGURE.to_owned() } else { form.replace(' ', "-") };
    let document = renderer.render(&[sheet, solution], Format::Markdown)?;
    let mut text = document.text;
    let mut figures = Vec::new();
    for BesideFile { name: file, text: drawing } in document.beside {
        let figure = file.replacen(FIGURE, &form, 1);
        let anchor = figure.trim_end_matches(".svg");
        text = text.replace(&format!("({file})"), &format!("({name}{}#{anchor})", Kind::Figures.ending()));
        figures.push(BesideFile { name: anchor.to_owned(), text: drawing });
    }
    Ok((text, figures))
}

/// Marks typical answers; what is told about them goes with the words.
fn marked(exercise: &Exercise, form: &str, marks: &mut Table) -> Result<String, Failure> {
    let mut told = String::from("\n## What is told about answers\n\n");
    let worked = exercise.worked();
    for part in &worked.form.parts {
        let mut said: BTreeSet<String> = BTreeSet::new();
        for (what, typed) in exercise.tried_answers(part) {
            let report = exercise.grade(&BTreeMap::from([(part.id.clone(), typed.clone())]), DecimalMark::Point);
            let Some(read_part) = report.parts.iter().find(|read_part| read_part.id == part.id) else { continue };
            let points = format!("{}/{}", read_part.points, read_part.out_of);
            marks.row(&[form, &part.id, &what, &typed, read_part.verdict.code(), &points])?;
            if said.insert(read_part.message.to_string()) {
                let _ = writeln!(told, "- `{}`: {typed} ({what}): {}", part.id, read_part.message);
            }
        }
    }
    Ok(told)
}

/// Figures one below the other, in one file, each with its name as an anchor.
fn album(figures: &[BesideFile]) -> String {
    const MARGIN: f64 = 12.0;
    let (mut body, mut views) = (String::new(), String::new());
    let (mut width, mut height): (f64, f64) = (0.0, 0.0);
    let mut rules: Vec<&str> = Vec::new();
    for BesideFile { name, text } in figures {
        let sizes = ["width=\"", "height=\""].map(|key| measure(text, key));
        let [Some(own_width), Some(own_height)] = sizes else { continue };
        let (drawing, style) = unstyled(text);
        rules.extend(style.lines().filter(|rule| !rule.is_empty() && !rule.contains("height:auto")));
        let top = height;
        let _ = writeln!(views, "<view id=\"{name}\" viewBox=\"0 {top:.2} {own_width:.2} {own_height:.2}\"/>");
        let placed = drawing.replacen("<svg ", &format!("<svg y=\"{top:.2}\" "), 1);
        body.push_str(&placed.replace("pt\"", "\""));
        width = width.max(own_width);
        height += own_height + MARGIN;
    }
    let mut kept = BTreeSet::new();
    rules.retain(|rule| kept.insert(*rule));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.2}\" height=\"{height:.2}\" viewBox=\"0 0 {width:.2} {height:.2}\">\n\
         <style>\n{}\n</style>\n{views}{body}</svg>\n",
        rules.join("\n")
    )
}

/// A figure without its style, and the style.
fn unstyled(text: &str) -> (String, &str) {
    let split = text.split_once("<style>").and_then(|(before, rest)| {
        let (style, after) = rest.split_once("</style>\n")?;
        Some((format!("{before}{after}"), style))
    });
    split.unwrap_or_else(|| (text.to_owned(), ""))
}

/// The number of points under a key of the first element.
fn measure(text: &str, key: &str) -> Option<f64> {
    text.split_once(key)?.1.split_once("pt\"")?.0.parse().ok()
}

/// A table of comma-separated values in memory.
struct Table(csv::Writer<Vec<u8>>);

impl Table {
    fn new(headings: &[&str]) -> Result<Self, Failure> {
        let mut table = Self(csv::Writer::from_writer(Vec::new()));
        table.row(headings)?;
        Ok(table)
    }

    fn row(&mut self, cells: &[&str]) -> Result<(), Failure> {
        self.0
            .write_record(cells)
            .map_err(|error| Failure::unusable(format!("the snapshot cannot be written: {error}")))
    }

    fn text(self) -> Result<String, Failure> {
        let bytes = self.0.into_inner().map_err(|error| Failure::from(error.into_error()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapshots_are_known_by_their_endings() {
        assert_eq!(Kind::of("impact/two-carts.words.md"), Some((Kind::Words, "impact/two-carts")));
        assert!(["notes.md", "impact/two-carts.md", "a.csv", "words.md"].iter().all(|name| Kind::of(name).is_none()));
        assert!(Kind::ENDINGS.iter().all(|(kind, ending)| kind.ending() == *ending));
    }
}
