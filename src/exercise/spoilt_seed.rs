//! Seeds that a spreadsheet has spoilt.

/// Digits at the end of a seed that are zero by chance in one seed of a million.
const ZEROS: usize = 6;
/// Spreadsheets write shorter numbers with all their digits.
const DIGITS: usize = 12;

/// A seed of which a spreadsheet kept the first digits: `9.61366E+13`, or `96136600000000`.
///
/// ```
/// use momentous_exercise::SpoiltSeed;
/// let spoilt = SpoiltSeed::read("9.61366E+13").unwrap();
/// assert!(spoilt.is_of(96_136_557_916_552) && !spoilt.is_of(96_137_557_916_552));
/// assert!(SpoiltSeed::read("96136600000000").is_some() && SpoiltSeed::read("s96136600000000").is_none());
/// assert!(SpoiltSeed::read("7").is_none() && SpoiltSeed::read("96136557916552").is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpoiltSeed {
    /// The number that is left.
    kept: u64,
    /// The place of the last digit that was kept.
    place: u64,
}

impl SpoiltSeed {
    /// A seed as a cell holds it once it was spoilt; none where it was not.
    #[must_use]
    pub fn read(cell: &str) -> Option<Self> {
        let number = cell.split_once('-').map_or(cell, |(number, _)| number).trim();
        match number.split_once(['e', 'E']) {
            Some((digits, power)) => Self::in_powers_of_ten(digits, power.trim_start_matches('+').parse().ok()?),
            None => Self::with_zeros(number),
        }
    }

    fn in_powers_of_ten(digits: &str, power: usize) -> Option<Self> {
        let (whole, decimals) = digits.split_once(['.', ',']).unwrap_or((digits, ""));
        let zeros = u32::try_from(power.checked_sub(decimals.len())?).ok()?;
        let place = 10_u64.checked_pow(zeros)?;
        let kept = format!("{whole}{decimals}").parse::<u64>().ok()?.checked_mul(place)?;
        Some(Self { kept, place })
    }

    fn with_zeros(number: &str) -> Option<Self> {
        let zeros = number.len() - number.trim_end_matches('0').len();
        let kept = number.parse().ok().filter(|_| number.len() >= DIGITS && zeros >= ZEROS)?;
        Some(Self { kept, place: 10_u64.checked_pow(u32::try_from(zeros).ok()?)? })
    }

    /// Whether it is what a spreadsheet leaves of this seed.
    #[must_use]
    pub fn is_of(self, seed: u64) -> bool {
        self.kept.abs_diff(seed) <= self.place / 2
    }
}
