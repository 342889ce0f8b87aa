//! How a seed is printed.

use std::fmt;

/// Spreadsheets write whole numbers from here on in powers of ten, and lose their last digits.
const AS_WORD: u64 = 1_000_000_000;

/// A seed as it is printed: a small one as it is, a large one as a word, with a letter before it, which spreadsheets leave alone.
///
/// ```
/// use momentous_render::SeedWord;
/// assert_eq!(SeedWord(7).to_string(), "7");
/// assert_eq!(SeedWord(96_136_557_916_552).to_string(), "s96136557916552");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SeedWord(pub u64);

impl SeedWord {
    /// The letter before a large seed.
    pub const LETTER: char = 's';
}

impl fmt::Display for SeedWord {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 < AS_WORD { write!(out, "{}", self.0) } else { write!(out, "{}{}", Self::LETTER, self.0) }
    }
}
