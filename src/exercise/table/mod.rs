//! Tables of comma-separated values as people's programs write them: headings, then rows.

mod cell;
mod lines;
mod rows;

use std::collections::BTreeMap;
use std::io;
use std::io::BufRead;

use super::submission::excerpt;

pub use cell::defused;
pub use lines::{Line, Lines};
pub use rows::{Row, Rows};

/// A table with a line of headings, read row by row. Semicolons separate its cells where the headings have some and no comma.
///
/// ```
/// use momentous_exercise::Table;
/// let mut table = Table::read("id;name\ns1;\"Ada; Countess\"\ns2\n".as_bytes())?;
/// assert_eq!(table.column("NAME"), Ok(Some(1)));
/// assert_eq!(table.next_row().map(|(line, row)| (line, row.map(|row| row.cell(1)))), Some((2, Ok("Ada; Countess"))));
/// let uneven = "the row has 1 cell, and there are 2 headings".to_owned();
/// assert_eq!(table.next_row().map(|(line, row)| (line, row.map(|row| row.cell(0)))), Some((3, Err(uneven))));
/// assert!(table.next_row().is_none());
/// # Ok::<(), String>(())
/// ```
#[derive(Debug)]
pub struct Table<R> {
    headings: Vec<String>,
    rows: Rows<R>,
}

impl<R: BufRead> Table<R> {
    /// Reads the headings.
    ///
    /// # Errors
    /// Where there are none, one stands there twice, or they cannot be read.
    pub fn read(input: R) -> Result<Self, String> {
        let mut rows = Rows::read(input)?;
        let (_, row) = rows.next_row().ok_or("it is empty, without even headings")?;
        let headings: Vec<String> = row?.cells().map(str::to_owned).collect();
        let mut places: BTreeMap<&str, usize> = BTreeMap::new();
        for (index, heading) in headings.iter().enumerate().filter(|(_, heading)| !heading.is_empty()) {
            if let Some(first) = places.insert(heading, index) {
                return Err(twice(heading, first, index));
            }
        }
        rows.width = Some(headings.len());
        Ok(Self { headings, rows })
    }

    /// The headings, in the order of the columns.
    #[must_use]
    pub fn headings(&self) -> &[String] {
        &self.headings
    }

    /// The position of the column with that heading, in small or capital letters.
    ///
    /// # Errors
    /// Where two columns have it.
    pub fn column(&self, heading: &str) -> Result<Option<usize>, String> {
        let mut matching = self.headings.iter().enumerate().filter(|(_, listed)| listed.eq_ignore_ascii_case(heading));
        match (matching.next(), matching.next()) {
            (Some((first, _)), Some((second, _))) => Err(twice(heading, first, second)),
            (first, _) => Ok(first.map(|(position, _)| position)),
        }
    }

    /// The beginning of the row that was read last, in bytes.
    #[must_use]
    pub fn last_place(&self) -> u64 {
        self.rows.last_place()
    }

    /// The next row with the line on which it begins, or what is wrong with it. Lines with nothing on them are no rows.
    pub fn next_row(&mut self) -> Option<(u64, Result<&Row, String>)> {
        let wanted = self.headings.len();
        let (line, row) = self.rows.next_row()?;
        let row = row.and_then(|row| match row.len() {
            cells if cells == wanted => Ok(row),
            1 => Err(format!("the row has 1 cell, and there are {wanted} headings")),
            cells => Err(format!("the row has {cells} cells, and the headings are {wanted}")),
        });
        Some((line, row))
    }
}

impl<R: BufRead + io::Seek> Table<R> {
    /// Goes to a row that begins there, on that line.
    ///
    /// # Errors
    /// What the file says.
    pub fn go_to(&mut self, place: u64, line: u64) -> io::Result<()> {
        self.rows.go_to(place, line)
    }
}

/// Says which columns have the same heading; columns are counted from 1.
pub(super) fn twice(heading: &str, first: usize, second: usize) -> String {
    let (heading, first, second) = (excerpt(heading), first + 1, second + 1);
    format!("two columns have the heading `{heading}`: {first} and {second}\nhelp: rename or remove one of them")
}
