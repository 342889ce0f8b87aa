//! One attempt is one attempt: those of one student at one sheet stand together, and are known by what they are, not by how they
//! are written.

use std::hash::{DefaultHasher, Hash, Hasher};

use rustc_hash::FxHashMap;

use super::VariantRef;

/// The most attempts of one student at one sheet: they are held in memory together.
pub const MOST_ATTEMPTS: u32 = 1000;

/// The place of an attempt among those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// It is the first of a student at a sheet; so is one that has no student.
    First,
    /// The one before it is of the same student at the same sheet.
    Beside,
    /// There are [`MOST_ATTEMPTS`] before it.
    OneTooMany,
    /// Others stand between it and an earlier one of the same student at the same sheet, which has this number.
    Apart(u64),
}

/// The attempts so far. Of each student and sheet a hash and a number are kept, sixteen bytes.
///
/// ```
/// use momentous_exercise::{Standing, Together, VariantRef};
/// let [one, other] = [1, 2].map(|seed| VariantRef { problem: "impact/two-carts", form: "forward", seed });
/// let mut attempts = Together::default();
/// assert_eq!(attempts.add("s17", one, 2), Standing::First);
/// assert_eq!(attempts.add("s17", one, 3), Standing::Beside);
/// assert_eq!(attempts.add("s17", other, 4), Standing::First);
/// assert_eq!(attempts.add("s17", one, 5), Standing::Apart(2));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Together {
    /// The number of the first attempt of each student at each sheet.
    first: FxHashMap<u64, u64>,
    /// The student and sheet of the attempt before, and how many stand together there.
    last: Option<(u64, u32)>,
}

impl Together {
    /// The key of a student and a sheet, the same for all attempts.
    #[must_use]
    pub fn sheet(student: &str, variant: VariantRef<'_>) -> u64 {
        hash((student, variant))
    }

    /// Lets the next attempt begin anew.
    pub fn part(&mut self) {
        self.last = None;
    }

    /// Adds the next attempt; the number says where it stands.
    pub fn add(&mut self, student: &str, variant: VariantRef<'_>, number: u64) -> Standing {
        if student.is_empty() {
            self.last = None;
            return Standing::First;
        }
        let sheet = Self::sheet(student, variant);
        if let Some((_, count)) = self.last.as_mut().filter(|(last, _)| *last == sheet) {
            *count += 1;
            return if *count > MOST_ATTEMPTS { Standing::OneTooMany } else { Standing::Beside };
        }
        if let Some(first) = self.first.get(&sheet) {
            return Standing::Apart(*first);
        }
        self.first.insert(sheet, number);
        self.last = Some((sheet, 1));
        Standing::First
    }
}

/// A hash that nobody is likely to meet twice in a class: of ten million sheets, two agree once in 300,000 classes.
pub(super) fn hash(value: impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attempts_without_a_student_are_nobodys_second() {
        let variant = VariantRef { problem: "a/b", form: "", seed: 1 };
        let mut attempts = Together::default();
        assert_eq!([attempts.add("", variant, 1), attempts.add("", variant, 2)], [Standing::First; 2]);
    }

    #[test]
    fn there_is_an_end_to_attempts() {
        let variant = VariantRef { problem: "a/b", form: "", seed: 1 };
        let mut attempts = Together::default();
        let standings: Vec<Standing> =
            (0..=u64::from(MOST_ATTEMPTS)).map(|number| attempts.add("s", variant, number)).collect();
        assert_eq!(standings.iter().filter(|standing| **standing == Standing::Beside).count(), 999);
        assert_eq!(standings.last(), Some(&Standing::OneTooMany));
    }
}
