//! Submissions as they come, looked at, in chunks that fit into memory however long they are.

use std::sync::Arc;

use crate::cli::failure::Failure;

use super::marked::begins;
use super::order::Order;
use super::problems::OpenProblem;
use super::register::{Entered, Register};
use super::source::Source;

/// Submissions that are marked at once, while the next ones are read.
const CHUNK: usize = 16384;

/// The memory that they may take, in bytes.
const HEAVIEST: usize = 1 << 24;

/// The most that a chunk grows beyond that, so as not to part attempts of one student: rows between them that cannot be used.
const LONGEST: usize = 2 * CHUNK;

/// Reads submissions.
pub(super) struct Reader {
    source: Source,
    register: Register,
    /// The order in which rows are marked, where it is not that of the file.
    order: Option<Order>,
    /// The first of the next chunk.
    held: Option<Entered>,
    /// The number of rows that were read.
    pub(super) read: u64,
}

impl Reader {
    pub(super) fn new(source: Source, register: Register) -> Self {
        Self { source, register, order: None, held: None, read: 0 }
    }

    /// The same, with attempts brought together that stand apart.
    pub(super) fn in_any_order(mut source: Source, mut register: Register) -> Result<Self, Failure> {
        let order = Order::of(&mut source, &mut register)?;
        Ok(Self { order: Some(order), ..Self::new(source, register) })
    }

    /// Whether the secret is that of most sheets so far.
    pub(super) fn check_secret(&self) -> Result<(), String> {
        self.register.check_secret()
    }

    /// The problems that were met so far, by their positions.
    pub(super) fn problems(&self) -> Vec<Arc<OpenProblem>> {
        self.register.open().to_vec()
    }

    /// The next chunk: attempts of one student at one question are not torn apart. Nothing is in it where nothing is left.
    pub(super) fn chunk(&mut self) -> Vec<Entered> {
        let (mut chunk, mut weight) = (Vec::new(), 0);
        while let Some(next) = self.next() {
            let is_full = chunk.len() >= CHUNK || weight >= HEAVIEST;
            if is_full && begins(&next) {
                self.held = Some(next);
                break;
            }
            weight += next.as_ref().map_or(size_of::<Entered>(), |entry| entry.submission.weight());
            chunk.push(next);
            if chunk.len() >= LONGEST {
                self.register.part();
                break;
            }
        }
        chunk
    }

    fn next(&mut self) -> Option<Entered> {
        if let Some(held) = self.held.take() {
            return Some(held);
        }
        let (number, next) = match &mut self.order {
            Some(order) => order.next(&mut self.source)?,
            None => self.source.next()?,
        };
        self.read += 1;
        let Self { source, register, .. } = self;
        Some(register.enter(next, number, |number| source.place(number)))
    }
}
