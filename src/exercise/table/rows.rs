//! Rows of cells. What is no row is a fault on its own line, and the next line is read as if it had not been there.

use std::io;
use std::io::BufRead;

use super::cell::meant;
use super::lines::{LONGEST, Line, Lines};

/// The lines over which one row may go: an answer that somebody typed goes over a few. Beyond them a quotation mark was left open.
const MOST_LINES: usize = 100;

/// Characters without a width, which are copied along from pages.
const INVISIBLE: [char; 5] = ['\u{200b}', '\u{200c}', '\u{200d}', '\u{2060}', '\u{feff}'];

const HELP: &str = "help: close a quoted cell with a quotation mark; inside it, double each quotation mark";

/// The rows of a file.
#[derive(Debug)]
pub struct Rows<R> {
    lines: Lines<R>,
    delimiter: u8,
    /// How many cells a row has, where that is known.
    pub(super) width: Option<usize>,
    /// The row and the line that were read last, in memory that the next ones take over.
    row: Row,
    line: Line,
}

/// The cells of a row.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// The cells, one after the other.
    text: String,
    /// The ends of them.
    ends: Vec<usize>,
}

impl Row {
    /// The number of cells.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there are no cells.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// A cell without the spaces around it; nothing where there is none.
    #[must_use]
    pub fn cell(&self, position: usize) -> &str {
        let start = position.checked_sub(1).and_then(|before| self.ends.get(before)).copied().unwrap_or(0);
        let text = self.ends.get(position).and_then(|end| self.text.get(start..*end));
        text.unwrap_or_default()
    }

    /// All cells, without the spaces around them.
    pub fn cells(&self) -> impl Iterator<Item = &str> {
        (0..self.len()).map(|position| self.cell(position))
    }

    fn clear(&mut self) {
        self.text.clear();
        self.ends.clear();
    }

    fn end_cell(&mut self) {
        let start = self.ends.last().copied().unwrap_or(0);
        // What is meant is what is written, or less of it.
        let shorter = self.text.get(start..).and_then(|written| {
            let meant = meant(written.trim_matches(|edge: char| edge.is_whitespace() || INVISIBLE.contains(&edge)));
            (meant.len() != written.len()).then(|| meant.into_owned())
        });
        if let Some(meant) = shorter {
            self.text.truncate(start);
            self.text.push_str(&meant);
        }
        self.ends.push(self.text.len());
    }
}

impl<R: BufRead> Rows<R> {
    /// The rows of an input. Semicolons separate cells where the first line has some and no comma, and so do tabs where it has neither.
    ///
    /// # Errors
    /// What the input says.
    pub fn read(input: R) -> Result<Self, String> {
        let mut lines = Lines::of(input).map_err(|error| error.to_string())?;
        let mut first = Line::default();
        let mut delimiter = b',';
        if lines.read(&mut first).map_err(|error| error.to_string())? {
            match told_delimiter(&first.bytes) {
                Some(told) => delimiter = told,
                None => {
                    delimiter = delimiter_of(&first.bytes);
                    lines.give_back(std::iter::once(first));
                }
            }
        }
        Ok(Self { lines, delimiter, width: None, row: Row::default(), line: Line::default() })
    }

    /// The next row with the line on which it begins, or what is wrong with it. Lines with nothing on them are no rows.
    pub fn next_row(&mut self) -> Option<(u64, Result<&Row, String>)> {
        loop {
            match self.lines.read(&mut self.line) {
                Ok(false) => return None,
                Err(error) => return Some((self.line.number + 1, Err(error.to_string()))),
                Ok(true) if self.line.bytes.trim_ascii().is_empty() => {}
                Ok(true) => break,
            }
        }
        let number = self.line.number;
        self.row.clear();
        let read = self.read_row();
        Some((number, read.map(|()| &self.row)))
    }

    /// Reads the row that begins on the line that was read last.
    fn read_row(&mut self) -> Result<(), String> {
        let mut quoted = cells(&mut self.row, text(&self.line)?, self.delimiter, false)?;
        let mut more: Vec<Line> = Vec::new();
        while quoted {
            let opened = self.row.len() + 1;
            let mut next = Line::default();
            self.row.text.push_str(more.last().unwrap_or(&self.line).end);
            let fits = more.len() + 1 < MOST_LINES && self.row.text.len() < LONGEST;
            let has_more = fits && self.lines.read(&mut next).map_err(|error| error.to_string())?;
            let read = has_more.then(|| text(&next).and_then(|text| cells(&mut self.row, text, self.delimiter, true)));
            more.extend(has_more.then_some(next));
            // What does not fit on a later line says that the mark was never meant to go that far.
            let fits = |still: &bool| *still || self.width.is_none_or(|width| self.row.len() == width);
            let Some(still) = read.and_then(Result::ok).filter(fits) else {
                self.lines.give_back(more.into_iter());
                return Err(format!("a quotation mark is opened in cell {opened} but not closed\n{HELP}"));
            };
            quoted = still;
        }
        Ok(())
    }

    /// The beginning of the row that was read last, in bytes.
    #[must_use]
    pub fn last_place(&self) -> u64 {
        self.line.place
    }
}

impl<R: BufRead + io::Seek> Rows<R> {
    /// Goes to a row that begins there, on that line.
    ///
    /// # Errors
    /// What the input says.
    pub fn go_to(&mut self, place: u64, line: u64) -> io::Result<()> {
        self.lines.go_to(place, line)
    }
}

fn text(line: &Line) -> Result<&str, String> {
    if line.is_cut {
        return Err(format!("the row is longer than {LONGEST} bytes"));
    }
    std::str::from_utf8(&line.bytes).map_err(|_| "the row is not UTF-8\nhelp: save the table as `CSV UTF-8`".to_owned())
}

/// Adds the cells of a line to a row; whether the line ends within quotation marks, as it begins where it is `quoted`.
fn cells(row: &mut Row, line: &str, delimiter: u8, mut quoted: bool) -> Result<bool, String> {
    let mut rest = line;
    loop {
        if !quoted {
            if let Some(inside) = rest.strip_prefix('"') {
                (quoted, rest) = (true, inside);
            } else {
                let end = rest.bytes().position(|byte| byte == delimiter);
                row.text.push_str(&rest[..end.unwrap_or(rest.len())]);
                row.end_cell();
                match end {
                    Some(end) => rest = &rest[end + 1..],
                    None => return Ok(false),
                }
                continue;
            }
        }
        let Some(mark) = rest.bytes().position(|byte| byte == b'"') else {
            row.text.push_str(rest);
            return Ok(true);
        };
        row.text.push_str(&rest[..mark]);
        rest = &rest[mark + 1..];
        if let Some(more) = rest.strip_prefix('"') {
            row.text.push('"');
            rest = more;
            continue;
        }
        quoted = false;
        row.end_cell();
        let after = rest.trim_start_matches(' ');
        match after.as_bytes().first() {
            None => return Ok(false),
            Some(first) if *first == delimiter => rest = &after[1..],
            Some(_) => {
                let cell = row.len();
                return Err(format!("there is text after the closing quotation mark of cell {cell}\n{HELP}"));
            }
        }
    }
}

/// The separator of cells where the first line says it, as spreadsheets do: `sep=;`.
fn told_delimiter(line: &[u8]) -> Option<u8> {
    let line = str::from_utf8(line).ok()?.trim_matches(|edge: char| edge == ' ' || INVISIBLE.contains(&edge));
    let line = line.strip_prefix('"').and_then(|line| line.strip_suffix('"')).unwrap_or(line);
    match line.strip_prefix("sep=").map(str::as_bytes) {
        Some([told]) => Some(*told),
        _ => None,
    }
}

/// The separator of the cells of a table whose first line this is.
fn delimiter_of(line: &[u8]) -> u8 {
    let mut quoted = false;
    let mut delimiter = b',';
    for byte in line {
        match byte {
            b'"' => quoted = !quoted,
            b',' if !quoted => return b',',
            b';' if !quoted => delimiter = b';',
            b'\t' if !quoted && delimiter == b',' => delimiter = b'\t',
            _ => {}
        }
    }
    delimiter
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &str) -> Vec<(u64, Result<Vec<String>, String>)> {
        let mut rows = Rows::read(text.as_bytes()).unwrap();
        let mut all = Vec::new();
        while let Some((line, row)) = rows.next_row() {
            let first = |message: String| message.lines().next().unwrap_or_default().to_owned();
            all.push((line, row.map(|row| row.cells().map(str::to_owned).collect()).map_err(first)));
        }
        all
    }

    fn row(line: u64, cells: &[&str]) -> (u64, Result<Vec<String>, String>) {
        (line, Ok(cells.iter().map(|cell| (*cell).to_owned()).collect()))
    }

    #[test]
    fn cells_are_read_as_programs_write_them() {
        let text = "a, b ,\"c, \"\"d\"\"\"\r\n\r\n\"two\r\nlines\" ,5\",\n'=1,,";
        let expected = [row(1, &["a", "b", "c, \"d\""]), row(3, &["two\r\nlines", "5\"", ""]), row(5, &["=1", "", ""])];
        assert_eq!(all(text), expected);
        assert_eq!(all("\"x,y\";b\n1,5;2"), [row(1, &["x,y", "b"]), row(2, &["1,5", "2"])]);
    }

    #[test]
    fn an_open_quotation_mark_costs_its_own_row_only() {
        let open = |cell: usize| Err(format!("a quotation mark is opened in cell {cell} but not closed"));
        let after = Err("there is text after the closing quotation mark of cell 2".to_owned());
        assert_eq!(all("a,\"b\nc,d\ne,f"), [(1, open(2)), row(2, &["c", "d"]), row(3, &["e", "f"])]);
        assert_eq!(all("a,\"b\nc,d\ne,\"f"), [(1, open(2)), row(2, &["c", "d"]), (3, open(2))]);
        assert_eq!(all("a,\"b\"c\nd,\"\""), [(1, after), row(2, &["d", ""])]);
        let long = all(&format!("\"a\n{}b\"", "x\n".repeat(MOST_LINES)));
        assert_eq!((long.len(), &long[0]), (MOST_LINES + 2, &(1, open(1))));
    }

    #[test]
    fn what_is_no_text_is_told_and_passed_over() {
        let mut rows = Rows::read(&b"a\n\xff\nb"[..]).unwrap();
        let mut good = Vec::new();
        while let Some((line, row)) = rows.next_row() {
            good.push((line, row.is_ok()));
        }
        assert_eq!(good, [(1, true), (2, false), (3, true)]);
    }
}
