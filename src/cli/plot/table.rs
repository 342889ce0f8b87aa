//! A table on a page of plots.

use std::fmt::Write;

use super::escaped;
use super::panel::WIDTH;

/// The left edge of the table, and the height of a line.
const LEFT: f64 = 76.0;
const LINE: f64 = 20.0;
const TOP: f64 = 56.0;

/// The letters that a line of a note holds.
const LETTERS: usize = 105;

/// A table with notes above it.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    /// The title above it.
    pub title: String,
    /// The headings.
    pub headings: Vec<&'static str>,
    /// The rows.
    pub rows: Vec<Vec<String>>,
    /// Sentences between the title and the table.
    pub notes: Vec<String>,
}

impl Table {
    fn lines(&self) -> Vec<String> {
        self.notes.iter().flat_map(|note| wrapped(note)).collect()
    }

    /// Its height in pixels.
    pub(super) fn height(&self) -> f64 {
        let headings = if self.rows.is_empty() { 0.0 } else { LINE };
        let lines = self.lines().into_iter().map(|_| LINE).chain(self.rows.iter().map(|_| LINE));
        TOP + headings + lines.sum::<f64>()
    }

    /// The table with its upper left corner at the origin.
    pub(super) fn svg(&self) -> String {
        let mut out = format!("<text class=\"name\" x=\"{LEFT}\" y=\"30\">{}</text>\n", escaped(&self.title));
        let mut y = TOP;
        for line in self.lines() {
            let _ = writeln!(out, "<text class=\"small\" x=\"{LEFT}\" y=\"{y}\">{}</text>", escaped(&line));
            y += LINE;
        }
        if self.rows.is_empty() {
            return out;
        }
        let column = (WIDTH - LEFT - 30.0) / self.headings.iter().map(|_| 1.0).sum::<f64>();
        let headings: Vec<String> = self.headings.iter().map(|heading| (*heading).to_owned()).collect();
        for (row, class) in std::iter::once((&headings, "small")).chain(self.rows.iter().map(|row| (row, "cell"))) {
            let mut x = LEFT;
            for cell in row {
                let _ = writeln!(out, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y}\">{}</text>", escaped(cell));
                x += column;
            }
            y += LINE;
        }
        out
    }
}

/// A note in lines that fit.
fn wrapped(note: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in note.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) if line.chars().count() + word.chars().count() < LETTERS => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
