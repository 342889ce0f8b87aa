//! Whose sheet is whose: the seed of each student's sheet, made of who the student is and what is asked.

use std::fmt;
use std::str::FromStr;

use hmac::{Hmac, KeyInit, Mac};
use sha2::Sha256;

/// Seeds stay below 2^48, so that every program that reads JSON numbers as doubles reads them exactly.
const SEED_BITS: u32 = 48;

/// One variant as it was drawn: which problem, in which form, from which seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct VariantRef<'a> {
    /// The problem's identity.
    pub problem: &'a str,
    /// The form's name; empty where the problem has one form without a name.
    pub form: &'a str,
    /// The seed.
    pub seed: u64,
}

/// How the seed of a student's sheet is made. Each version stays as it is, so that sheets that were handed out stay valid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Derivation {
    /// Version 1, of the student alone: one seed for all sheets of a student.
    Student,
    /// Version 2, of student, problem and form: whoever learns one seed knows nothing of the others.
    #[default]
    Question,
}

impl Derivation {
    /// Every version, the oldest first.
    pub const ALL: [Self; 2] = [Self::Student, Self::Question];

    /// The number by which tables and arguments name it.
    #[must_use]
    pub fn number(self) -> usize {
        Self::ALL.iter().take_while(|derivation| **derivation != self).count() + 1
    }
}

impl fmt::Display for Derivation {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.number().fmt(out)
    }
}

impl FromStr for Derivation {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let derivation = Self::ALL.into_iter().find(|derivation| derivation.to_string() == text.trim());
        derivation.ok_or_else(|| format!("the versions are 1 to {}", Self::ALL.len()))
    }
}

/// Seeds of a class: the version of their derivation, and the secret of the course where it has one.
///
/// ```
/// use momentous_exercise::SeedSource;
/// let seeds = SeedSource { secret: Some(b"course 2026"), ..SeedSource::default() };
/// assert_eq!(seeds.seed("s17", "impact/two-carts", "forward"), 197_135_158_964_129);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct SeedSource<'a> {
    /// The version.
    pub derivation: Derivation,
    /// The secret of the course.
    pub secret: Option<&'a [u8]>,
}

impl SeedSource<'_> {
    /// The seed of a student's sheet: the first bits of HMAC-SHA-256, keyed by the secret.
    #[must_use]
    pub fn seed(&self, student: &str, problem: &str, form: &str) -> u64 {
        // HMAC takes a key of any length; the fallback is never used.
        let Ok(mut mac) = Hmac::<Sha256>::new_from_slice(self.secret.unwrap_or_default()) else { return 0 };
        match self.derivation {
            Derivation::Student => {
                mac.update(b"momentous student\0");
                mac.update(student.as_bytes());
            }
            Derivation::Question => {
                mac.update(b"momentous sheet 2\0");
                for text in [student, problem, form] {
                    // The lengths keep `ab`, `c` apart from `a`, `bc`.
                    mac.update(&(text.len() as u64).to_be_bytes());
                    mac.update(text.as_bytes());
                }
            }
        }
        let digest = mac.finalize().into_bytes();
        let word = digest.iter().take(8).fold(0_u64, |word, byte| word << 8 | u64::from(*byte));
        word >> (u64::BITS - SEED_BITS)
    }

    /// The variant that a student gets.
    #[must_use]
    pub fn variant<'a>(&self, student: &str, problem: &'a str, form: &'a str) -> VariantRef<'a> {
        VariantRef { problem, form, seed: self.seed(student, problem, form) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_are_fixed_for_ever() {
        let seed = |derivation, secret, form| SeedSource { derivation, secret }.seed("s17", "impact/two-carts", form);
        // By Python: hmac.new(secret, b"momentous student\0" + id, "sha256"), the first 48 bits.
        assert_eq!(seed(Derivation::Student, None, "forward"), 3_788_136_342_373);
        assert_eq!(seed(Derivation::Student, Some(b"course 2026"), "find-e"), 258_417_333_666_985);
        // The same with b"momentous sheet 2\0" and, of student, problem and form, eight bytes of length and the text.
        assert_eq!(seed(Derivation::Question, None, "forward"), OPEN);
        assert_eq!(seed(Derivation::Question, Some(b"course 2026"), "forward"), SECRET);
        assert_eq!(seed(Derivation::Question, Some(b"course 2026"), "find-e"), OTHER_FORM);
    }

    const OPEN: u64 = 96_136_557_916_552;
    const SECRET: u64 = 197_135_158_964_129;
    const OTHER_FORM: u64 = 82_294_770_471_065;

    #[test]
    fn versions_are_known_by_their_numbers() {
        for version in Derivation::ALL {
            assert_eq!(version.to_string().parse(), Ok(version));
        }
        assert_eq!("3".parse::<Derivation>(), Err("the versions are 1 to 2".to_owned()));
    }
}
