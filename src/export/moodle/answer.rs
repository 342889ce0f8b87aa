//! A number's windows as Moodle's answers: a value, a tolerance, a fraction and a feedback; the first that fits counts.

use momentous_exercise::NumberItem;

use super::super::band::{Band, bands, printed};

/// The fractions that Moodle knows; a file with another one is refused.
const FRACTIONS: [f64; 21] = [
    100.0, 90.0, 83.33333, 80.0, 75.0, 70.0, 66.66667, 60.0, 50.0, 40.0, 33.33333, 30.0, 25.0, 20.0, 16.66667,
    14.28571, 12.5, 11.11111, 10.0, 5.0, 0.0,
];

/// Moodle keeps fourteen digits of a number.
const DIGITS: usize = 14;

/// The share of a number that is more than what is lost by that.
const KEPT: f64 = 1e-13;

/// One answer to a numerical question.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Answer<'i> {
    pub value: String,
    pub tolerance: f64,
    pub fraction: f64,
    pub feedback: &'i [String],
    /// Whether it says no more than that the power of ten is another one.
    pub is_coarse: bool,
}

/// A share of the points in per cent: the nearest that Moodle knows.
pub(super) fn nearest(share: f64) -> f64 {
    let away = |fraction: &f64| (fraction - share * FRACTIONS[0]).abs();
    FRACTIONS
        .into_iter()
        .fold(FRACTIONS[0], |best, fraction| if away(&fraction) < away(&best) { fraction } else { best })
}

/// The number as Moodle keeps it.
fn as_moodle_keeps(number: f64) -> f64 {
    format!("{number:.*e}", DIGITS - 1).parse().unwrap_or(number)
}

/// The answers in the order in which Moodle tries them, the right one as it is printed first.
pub(super) fn answers(item: &NumberItem, out_of: u32) -> Vec<Answer<'_>> {
    let bands = bands(item, out_of);
    let printed = printed(item);
    let parsed: f64 = printed.parse().unwrap_or(item.right);
    let home = bands.iter().find(|band| band.is_full() && (band.low..=band.high).contains(&parsed));
    let reach = |band: &Band<'_>| as_moodle_keeps((parsed - band.low).min(band.high - parsed));
    let first = home.map(|band| Answer { value: printed, tolerance: reach(band), ..answer(band) });
    first.into_iter().chain(bands.iter().map(answer)).collect()
}

fn answer<'i>(band: &Band<'i>) -> Answer<'i> {
    let value = as_moodle_keeps(band.middle());
    let reach = (value - band.low).max(band.high - value);
    Answer {
        value: value.to_string(),
        // Rounded up, so that both ends belong to it.
        tolerance: as_moodle_keeps(reach * (1.0 + KEPT) + KEPT * value.abs()),
        fraction: nearest(band.share),
        feedback: band.feedback,
        is_coarse: band.is_coarse,
    }
}
