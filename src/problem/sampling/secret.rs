//! Facts about a secret of the course that do not tell it: whether it can be guessed, and a mark by which it is known again.

use hmac::{Hmac, KeyInit, Mac};
use sha2::Sha256;

/// The letters of marks. There are no vowels, so that no word comes of them, and no digits, so that no program takes a
/// seed with its mark for a number or a date.
const LETTERS: &[u8; 16] = b"bcdfghjkmnpqrstv";

/// The number of letters that a mark has.
const LONG: usize = 6;

/// Guesses that one may make, as a power of two, before a secret is safe: a thousand computers make fewer in a year.
const SAFE: f64 = 64.0;

/// The bits that a word adds: there are a few thousand usual ones. A repeated word adds no more.
const WORD: f64 = 11.0;

/// The bytes that are looked at.
const LOOKED_AT: usize = 256;

/// The number of bytes that are no chance where they stood together before.
const REPEATED: usize = 3;

/// The mark of a secret: the same for the same secret, and no help to find it.
///
/// ```
/// use momentous_problem::secret_mark;
/// let mark = secret_mark(b"course 2026");
/// assert_eq!((mark.len(), mark == secret_mark(b"course 2027")), (6, false));
/// ```
#[must_use]
pub fn secret_mark(secret: &[u8]) -> String {
    // HMAC takes a key of any length; the fallback is never used.
    let Ok(mut mac) = Hmac::<Sha256>::new_from_slice(secret) else { return String::new() };
    mac.update(b"momentous secret mark\0");
    let digest = mac.finalize().into_bytes();
    digest.iter().take(LONG).map(|byte| letter(*byte)).collect()
}

/// A letter for a byte.
pub(crate) fn letter(byte: u8) -> char {
    char::from(LETTERS[usize::from(byte % 16)])
}

/// Whether somebody with one sheet may find the secret by trying: it is short, or made of words, simple rows and repetitions. Every
/// secret of less than 13 bytes is.
///
/// ```
/// use momentous_problem::is_guessable;
/// assert!(is_guessable(b"some words that nobody guesses"));
/// assert!(!is_guessable(b"8f14e45fceea167a5a36dedd4bea2543"));
/// ```
#[must_use]
pub fn is_guessable(secret: &[u8]) -> bool {
    guesses(secret) < SAFE
}

/// After how many tries a text is found by somebody who thinks as people do, as a power of two: words, simple rows and repetitions first.
///
/// ```
/// use momentous_problem::guesses;
/// assert!(guesses(b"aaaaaaaaaa") < 10.0);
/// assert!(guesses(b"a few short words") > 30.0);
/// ```
#[must_use]
pub fn guesses(secret: &[u8]) -> f64 {
    let secret = &secret[..secret.len().min(LOOKED_AT)];
    let mut guesses = 0.0;
    let mut place = 0;
    while let Some(rest) = secret.get(place..).filter(|rest| !rest.is_empty()) {
        let run = |is_one: fn(&u8) -> bool| rest.iter().take_while(|byte| is_one(byte)).count();
        let word = run(u8::is_ascii_lowercase).max(run(u8::is_ascii_uppercase));
        // Equal bytes, and those that follow each other as in `12345`, are one.
        let row = 1 + rest.windows(2).take_while(|pair| pair[0].abs_diff(pair[1]) <= 1).count();
        let is_there = |length: &usize| (0..place).any(|start| secret[start..].starts_with(&rest[..*length]));
        let repeated = (REPEATED..=rest.len()).take_while(is_there).last().unwrap_or(0);
        let letters = |count: usize| rest.iter().take(count).map(|byte| bits(*byte)).sum::<f64>();
        let (length, bits_here) = if row >= word.max(repeated) {
            (row, letters(1))
        } else {
            let length = word.max(repeated);
            (length, letters(length).min(WORD))
        };
        guesses += bits_here;
        place += length;
    }
    guesses
}

/// The bits that a byte adds where it is neither of a word nor of a row.
fn bits(byte: u8) -> f64 {
    match byte {
        b'0'..=b'9' => 3.3,
        b'a'..=b'z' | b'A'..=b'Z' => 4.7,
        b' ' | b'-' | b'_' | b'.' | b',' => 1.0,
        _ => 5.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_fixed_for_ever() {
        // By Python: the low half of each of the first six bytes of hmac.new(secret, b"momentous secret mark\0", "sha256").
        assert_eq!(secret_mark(b"course 2026"), "jdrgqf");
    }

    #[test]
    fn what_people_think_of_can_be_guessed_and_random_digits_cannot() {
        let weak = [
            "",
            "course 2026",
            "some words that nobody guesses",
            "Tr0ub4dor&3",
            "correct horse battery staple",
            "12345678901234567890123456789012345678",
            "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa",
            "qwertyuiopasdfghjklzxcvbnm",
            "abcdefghijklmnopqrstuvwxyz0123456789",
            "momentum-and-impulse-2026-11-23",
            "CORRECT HORSE BATTERY STAPLE",
            "7x7x7x7x7x7x7x7x7x7x7x7x7x7x",
            "mary1998!mary1998!mary1998!mary1998!",
            "éèéèéèéèéèéèéèéèéè",
            "~:|^~#@%$!?*",
        ];
        for secret in weak {
            assert!(is_guessable(secret.as_bytes()), "{secret}");
        }
        // By `openssl rand` with -hex 16, -base64 16 and -hex 32.
        let strong = [
            "b289213b44e2929520550277c6eb28ad",
            "2XMRLxiisaleeZyXxBnpnA==",
            "b1b7c9b83c675fc76bd39004dcc005962ce9ae28ce7826786edba7890ed6fab8",
        ];
        for secret in strong {
            assert!(!is_guessable(secret.as_bytes()), "{secret}");
        }
    }
}
