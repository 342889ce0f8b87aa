//! A seed as it stands on a sheet: the number, and a mark of the secret with which it was drawn.

use std::fmt;
use std::str::FromStr;

use momentous_problem::Problem;
use momentous_render::SeedWord;

/// A seed as it stands on a sheet: `7`, or `7-kmbtrs` where a secret was used, and `s96136557916552` where it is large.
///
/// ```
/// use momentous_exercise::SheetSeed;
/// let seed: SheetSeed = "7-kmbtrs".parse()?;
/// assert_eq!((seed.number, seed.mark.as_deref(), seed.to_string()), (7, Some("kmbtrs"), "7-kmbtrs".to_owned()));
/// assert_eq!("s96136557916552".parse::<SheetSeed>()?, "96136557916552".parse()?);
/// assert!("7-".parse::<SheetSeed>().is_err() && "-7".parse::<SheetSeed>().is_err());
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SheetSeed {
    /// The seed itself.
    pub number: u64,
    /// The mark of the secret; nothing where it is not said, or there is none.
    pub mark: Option<String>,
}

impl SheetSeed {
    /// The seed, where the problem was compiled with the secret whose mark it has. A seed without a mark is taken as it is.
    ///
    /// # Errors
    /// Where it was drawn with a secret, and the problem has none or another.
    pub fn of(&self, problem: &Problem) -> Result<u64, String> {
        match (&self.mark, problem.secret_mark()) {
            (None, _) => Ok(self.number),
            (Some(mark_of_sheet), Some(given)) if mark_of_sheet == given => Ok(self.number),
            (Some(mark_of_sheet), Some(given)) => Err(format!(
                "the sheet was drawn with another secret: its mark is `{mark_of_sheet}`, but the mark of the secret given is `{given}`"
            )),
            (Some(mark_of_sheet), None) => Err(format!(
                "the sheet was drawn with a secret, whose mark is `{mark_of_sheet}`; give it with --secret"
            )),
        }
    }
}

impl SheetSeed {
    /// The seed as it was copied from a sheet: one of a sheet that was drawn with a secret has its mark.
    ///
    /// # Errors
    /// As [`SheetSeed::of`]; and where the mark is missing, so that nobody knows whether it is a sheet of this secret.
    pub fn of_a_sheet(&self, problem: &Problem) -> Result<u64, String> {
        match (&self.mark, problem.secret_mark()) {
            (None, Some(given)) => Err(format!(
                "the seed {self} has no mark; on sheets drawn with the secret given it is {self}-{given}\n\
                 help: write it as on the sheet; for sheets without a mark, omit --secret"
            )),
            _ => self.of(problem),
        }
    }
}

impl fmt::Display for SheetSeed {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}", SeedWord(self.number))?;
        self.mark.as_ref().map_or(Ok(()), |mark| write!(out, "-{mark}"))
    }
}

impl FromStr for SheetSeed {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (number, mark) = match text.trim().split_once('-') {
            Some((number, mark)) => (number, Some(mark.to_lowercase())),
            None => (text.trim(), None),
        };
        let number = number.strip_prefix([SeedWord::LETTER, SeedWord::LETTER.to_ascii_uppercase()]).unwrap_or(number);
        let is_mark = |mark: &String| !mark.is_empty() && mark.bytes().all(|letter| letter.is_ascii_lowercase());
        let number = number.parse().ok().filter(|_| mark.as_ref().is_none_or(is_mark));
        number.map(|number| Self { number, mark }).ok_or_else(|| {
            let largest = u64::MAX;
            format!("a seed is a whole number from 0 to {largest}, as on the sheet: 7, 7-kmbtrs or s96136557916552")
        })
    }
}
