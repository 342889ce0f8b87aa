//! Random words, each fixed for ever by problem, seed, name and attempt.

use std::fmt;
use std::str::FromStr;

use hmac::{Hmac, KeyInit, Mac};
use rand::rngs::ChaCha8Rng;
use rand::{Rng, SeedableRng};
use sha2::Sha256;

use super::secret::letter;
use super::secret::secret_mark;

/// How the numbers of a seed are drawn. Each version stays as it is, so that sheets that were handed out keep their numbers.
///
/// Every version takes its words from the same streams: a key by HMAC-SHA-256 of the problem, `ChaCha8` with a stream for each name,
/// the seed as the block counter, and a word for each attempt. They differ in which attempts they reject.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Scheme {
    /// Version 1: numbers are rejected only where they have no admissible solution.
    Solvable,
    /// Version 2: numbers are rejected as well where rounding on the way shifts an answer by more than a few tolerances.
    #[default]
    Markable,
}

impl Scheme {
    /// Every version, the oldest first.
    pub const ALL: [Self; 2] = [Self::Solvable, Self::Markable];

    /// The number by which outputs, tables and arguments name it.
    #[must_use]
    pub fn number(self) -> u32 {
        match self {
            Self::Solvable => 1,
            Self::Markable => 2,
        }
    }

    /// The version of that number.
    #[must_use]
    pub fn numbered(number: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|scheme| scheme.number() == number)
    }
}

impl fmt::Display for Scheme {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.number().fmt(out)
    }
}

impl FromStr for Scheme {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let scheme = text.trim().parse().ok().and_then(Self::numbered);
        scheme.ok_or_else(|| format!("the versions are 1 to {}", Self::ALL.len()))
    }
}

/// The number that stands in every key.
const KEY_VERSION: u32 = 1;

/// Words of a block of `ChaCha8`, as 64 bits: those of one seed, one for each of so many attempts.
const BLOCK: usize = 8;

/// The streams of one problem, one for each name. Names do not touch each other's words, so a given may be added or
/// removed and the others stay.
///
/// ```
/// use momentous_problem::Streams;
/// let mut two = Streams::new("impact/two-carts", None, ["m_A", "m_B"]).words();
/// let mut one = Streams::new("impact/two-carts", None, ["m_B"]).words();
/// assert_eq!(two.word(1, 7, 0), one.word(0, 7, 0));
/// ```
#[derive(Clone, Debug)]
pub struct Streams {
    key: [u8; 32],
    ids: Vec<u64>,
    /// The mark of the secret; nothing where there is none.
    pub(crate) mark: Option<String>,
}

/// The letters of a code: among a hundred thousand, two are the same once in fifty thousand courses.
const CODE: usize = 12;

impl Streams {
    /// The streams of a problem, in the order of the names. With a course secret, nobody without it can find the words.
    pub fn new<'a>(problem: &str, secret: Option<&[u8]>, names: impl IntoIterator<Item = &'a str>) -> Self {
        let kind: &[u8] = if secret.is_some() { b"secret" } else { b"open" };
        let version = KEY_VERSION.to_le_bytes();
        let key = digest(secret.unwrap_or_default(), &[b"momentous", &version, kind, problem.as_bytes()]);
        let id = |name: &str| first_word(digest(&key, &[b"stream", name.as_bytes()]));
        Self { key, ids: names.into_iter().map(id).collect(), mark: secret.map(secret_mark) }
    }

    /// Letters by which something of this problem is known, and nothing of it can be read; in a course with a secret, nobody
    /// else finds them.
    pub(crate) fn code(&self, texts: &[&[u8]]) -> String {
        let key = digest(&self.key, &[b"code"]);
        digest(&key, texts).iter().take(CODE).map(|byte| letter(*byte)).collect()
    }

    /// The random word of a seed under a name that nothing given has, for what is not drawn again and again.
    pub(crate) fn word_of(&self, name: &str, seed: u64) -> u64 {
        first_word(digest(&self.key, &[b"order", name.as_bytes(), &seed.to_le_bytes()]))
    }

    /// A maker of words; each thread takes its own.
    #[must_use]
    pub fn words(&self) -> Words {
        let block = |id: &u64| WordBlock {
            id: *id,
            generator: ChaCha8Rng::from_seed(self.key),
            place: None,
            next: None,
            words: [0; BLOCK],
        };
        Words { blocks: self.ids.iter().map(block).collect() }
    }
}

/// Makes the words of a problem's streams. A word is found by seed and attempt alone, in any order; running through seeds in
/// order is cheapest.
#[derive(Debug)]
pub struct Words {
    blocks: Vec<WordBlock>,
}

/// The words of one stream that were made last.
#[derive(Debug)]
struct WordBlock {
    id: u64,
    generator: ChaCha8Rng,
    /// The words that are there.
    place: Option<Place>,
    /// The words that the generator makes next, if it goes on.
    next: Option<Place>,
    words: [u64; BLOCK],
}

/// The place of words in a stream: by the block of attempts, and by the seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Place {
    attempts: u64,
    seed: u64,
}

impl WordBlock {
    fn go_to(&mut self, place: Place) {
        if self.next != Some(place) {
            self.generator.set_stream(self.id.wrapping_add(place.attempts));
            self.generator.set_block_pos(place.seed);
        }
        self.words = std::array::from_fn(|_| self.generator.next_u64());
        self.place = Some(place);
        self.next = place.seed.checked_add(1).map(|seed| Place { seed, ..place });
    }
}

impl Words {
    /// The random word of the `index`-th name for a seed and an attempt, both from 0; nought where there is no such name.
    pub fn word(&mut self, index: usize, seed: u64, attempt: u64) -> u64 {
        let Some(block) = self.blocks.get_mut(index) else { return 0 };
        let place = Place { attempts: attempt / BLOCK as u64, seed };
        if block.place != Some(place) {
            block.go_to(place);
        }
        // The remainder is small, so the word is within the block.
        let word = attempt % BLOCK as u64;
        usize::try_from(word).ok().and_then(|word| block.words.get(word)).copied().unwrap_or_default()
    }
}

fn first_word(bytes: [u8; 32]) -> u64 {
    bytes.iter().take(8).rev().fold(0, |word, byte| word << 8 | u64::from(*byte))
}

/// HMAC-SHA-256 of parts, each with its length before it, so that no two lists of parts have one message.
fn digest(key: &[u8], parts: &[&[u8]]) -> [u8; 32] {
    // HMAC takes a key of any length; the fallback is never used.
    let Ok(mut mac) = Hmac::<Sha256>::new_from_slice(key) else { return [0; 32] };
    for part in parts {
        mac.update(&(part.len() as u64).to_le_bytes());
        mac.update(part);
    }
    mac.finalize().into_bytes().into()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn streams(problem: &str, secret: Option<&[u8]>) -> Words {
        Streams::new(problem, secret, ["m_A", "m_B", "v_A1"]).words()
    }

    #[test]
    fn words_do_not_depend_on_the_order_in_which_they_are_taken() {
        let asked = [(0, 5, 0), (2, u64::MAX, 17), (0, 5, 9), (1, 0, 0), (0, 6, 0), (0, 5, 0)];
        let mut kept = streams("a", None);
        for (index, seed, attempt) in asked {
            assert_eq!(kept.word(index, seed, attempt), streams("a", None).word(index, seed, attempt));
        }
    }

    #[test]
    fn every_part_of_the_identity_changes_the_word() {
        let base = streams("a", None).word(0, 1, 0);
        let empty: &[u8] = b"";
        let others = [
            streams("b", None).word(0, 1, 0),
            streams("a", Some(empty)).word(0, 1, 0),
            streams("a", Some(b"s")).word(0, 1, 0),
            streams("a", None).word(1, 1, 0),
            streams("a", None).word(0, 2, 0),
            streams("a", None).word(0, 1, 1),
            streams("a", None).word(0, 1, 8),
        ];
        for (index, other) in others.iter().enumerate() {
            assert!(*other != base && !others[..index].contains(other), "{index}");
        }
    }
}
