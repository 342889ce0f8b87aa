//! A number's windows as every target takes them: those that are marked alike joined, that of the right value first.

use momentous_exercise::NumberItem;
use momentous_exercise::Window;
use momentous_grade::Verdict;
use momentous_quantity::Rational;

/// The places behind the point that a number is written with, at the most.
const MOST_PLACES: usize = 6;

/// Numbers that are marked alike; both ends belong to it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Band<'i> {
    pub low: f64,
    pub high: f64,
    /// Its share of the points, from 0 to 1.
    pub share: f64,
    /// Its feedback.
    pub feedback: &'i [String],
    /// Whether it earns nothing, and nothing is known but that the power of ten is another one.
    pub is_coarse: bool,
}

impl Band<'_> {
    /// Whether it earns everything.
    pub fn is_full(&self) -> bool {
        self.share >= 1.0
    }

    /// How far its ends lie from a value within it, rounded up, so that both belong to what is no further away.
    pub fn reach_from(&self, value: f64) -> f64 {
        (value - self.low).max(self.high - value) + 4.0 * f64::EPSILON * self.low.abs().max(self.high.abs())
    }

    /// Whether another one earns the same, and the same is said of it.
    pub fn is_marked_as(&self, other: &Self) -> bool {
        self.share.total_cmp(&other.share).is_eq()
            && self.feedback == other.feedback
            && self.is_coarse == other.is_coarse
    }

    pub fn middle(&self) -> f64 {
        self.low + (self.high - self.low) / 2.0
    }
}

/// The bands of a number that is asked for so many points, from those that earn most. Whole turns of a direction stand there, too.
pub(super) fn bands(item: &NumberItem, out_of: u32) -> Vec<Band<'_>> {
    let mut joined: Vec<Band<'_>> = Vec::new();
    for window in &item.windows {
        let all_bands = band(window, out_of);
        match joined.last_mut() {
            Some(last) if last.high >= all_bands.low && last.is_marked_as(&all_bands) => last.high = all_bands.high,
            _ => joined.push(all_bands),
        }
    }
    let is_elsewhere = |band: &Band<'_>| !(band.low..=band.high).contains(&item.right);
    joined.sort_by(|left, right| right.share.total_cmp(&left.share).then(is_elsewhere(left).cmp(&is_elsewhere(right))));
    // A direction may be off by whole turns.
    let turns = item.turn.map_or(vec![0.0], |turn| vec![0.0, turn, -turn]);
    let turned = |turn: f64| {
        joined.iter().map(move |band| Band { low: band.low + turn, high: band.high + turn, ..band.clone() })
    };
    turns.into_iter().flat_map(turned).collect()
}

fn band(window: &Window, out_of: u32) -> Band<'_> {
    let share = &window.points.0 / Rational::from(out_of.max(1));
    let share = share.to_f64().value();
    let is_coarse = share <= 0.0 && window.mistakes.is_empty() && window.verdict == Verdict::OrderOfMagnitude;
    Band { low: window.low, high: window.high, share, feedback: &window.feedback, is_coarse }
}

/// The right value to the figures that are asked, with a point.
pub(super) fn printed(item: &NumberItem) -> String {
    if item.whole {
        return format!("{:.0}", item.right);
    }
    let digits = item.figures.max(1) - 1;
    let scientific = format!("{:.digits$e}", item.right);
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    let places = exponent.and_then(|exponent| i32::try_from(digits).ok()?.checked_sub(exponent));
    match places.and_then(|places| usize::try_from(places).ok()).filter(|places| *places <= MOST_PLACES) {
        Some(places) => format!("{:.places$}", item.right),
        None => scientific,
    }
}
