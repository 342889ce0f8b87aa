//! Attempts that stand apart, brought together: the file is read twice, and its rows are marked in another order.

use crate::cli::failure::Failure;

use super::register::{Next, Register};
use super::source::Source;

/// The rows of a file in the order in which they are marked: those of one student at one sheet where the first of them stands.
pub(super) struct Order(std::vec::IntoIter<Stand>);

/// The position of a row.
struct Stand {
    /// The first row, counted from 0, of the same student at the same sheet.
    first: u64,
    number: u64,
    /// The byte at which it begins.
    place: u64,
}

impl Order {
    /// Reads the file for the first time. Of each row three numbers are kept.
    pub(super) fn of(source: &mut Source, register: &mut Register) -> Result<Self, Failure> {
        let mut firsts = rustc_hash::FxHashMap::default();
        let mut rows: Vec<Stand> = Vec::new();
        while let Some((number, next)) = source.next() {
            let position = rows.len() as u64;
            let sheet = next.ok().and_then(|submission| register.sheet(&submission));
            let first = sheet.map_or(position, |sheet| *firsts.entry(sheet).or_insert(position));
            rows.push(Stand { first, number, place: source.last_place() });
        }
        register.begin_again();
        rows.sort_by_key(|row| row.first);
        let order = Self(rows.into_iter());
        // What cannot be read twice is told before anything is marked.
        if let Some(first) = order.0.as_slice().first() {
            source
                .go_to(first.place, first.number)
                .map_err(|error| Failure::unusable(format!("--any-order reads the submissions twice: {error}")))?;
        }
        Ok(order)
    }

    /// The next row.
    pub(super) fn next(&mut self, source: &mut Source) -> Option<(u64, Next)> {
        let Stand { number, place, .. } = self.0.next()?;
        match source.go_to(place, number) {
            Ok(()) => source.next(),
            Err(error) => Some((number, Err((source.place(number), error.to_string())))),
        }
    }
}
