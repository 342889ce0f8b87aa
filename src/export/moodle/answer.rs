//! A number's windows as Moodle's answers: a value, a tolerance, a fraction and a feedback; the first that fits counts.

use crate::exercise::NumberItem;
use crate::grade::Points;
use crate::quantity::Rational;
use crate::quantity::Unit;

/// The fractions that Moodle knows; a file with another one is refused.
const FRACTIONS: [f64; 21] = [
    100.0, 90.0, 83.33333, 80.0, 75.0, 70.0, 66.66667, 60.0, 50.0, 40.0, 33.33333, 30.0, 25.0, 20.0, 16.66667,
    14.28571, 12.5, 11.11111, 10.0, 5.0, 0.0,
];

/// All of the points, in per cent.
const ALL: f64 = 100.0;

/// What is left of a difference of fractions after rounding.
const ROUNDED: f64 = 0.001;

/// Units in which students answer, beside the one that is asked; those that measure the same go along.
const USUAL_UNITS: [&str; 38] = [
    "m",
    "cm",
    "mm",
    "km",
    "s",
    "ms",
    "min",
    "h",
    "kg",
    "g",
    "t",
    "m/s",
    "km/h",
    "cm/s",
    "m/s^2",
    "N",
    "kN",
    "kg m/s^2",
    "N s",
    "kN s",
    "kg m/s",
    "J",
    "kJ",
    "N m",
    "kg m^2/s^2",
    "W",
    "kW",
    "J/s",
    "rad/s",
    "1/s",
    "kg m^2/s",
    "N m s",
    "N/m",
    "kN/m",
    "kg/s",
    "deg",
    "rad",
    "%",
];

/// One answer to a numerical question.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Answer<'i> {
    pub value: String,
    pub tolerance: f64,
    pub fraction: f64,
    pub feedback: &'i [String],
}

/// The share of the points in per cent: the nearest that Moodle knows, and whether it is another one.
pub(super) fn fraction(points: &Points, out_of: u32) -> (f64, bool) {
    let share = &points.0 * Rational::from(100) / Rational::from(out_of.max(1));
    let share = share.to_f64().value();
    let nearest = FRACTIONS.into_iter().min_by(|left, right| (left - share).abs().total_cmp(&(right - share).abs()));
    let nearest = nearest.unwrap_or(0.0);
    (nearest, (nearest - share).abs() > ROUNDED)
}

/// The answers in the order in which Moodle tries them, the right one as it is printed first; and whether a fraction was changed.
pub(super) fn answers(item: &NumberItem, out_of: u32) -> (Vec<Answer<'_>>, bool) {
    let mut joined: Vec<([f64; 2], f64, &[String])> = Vec::new();
    let mut changed = false;
    for window in &item.windows {
        let (share, snapped) = fraction(&window.points, out_of);
        changed |= snapped;
        match joined.last_mut() {
            Some(([_, high], own, said))
                if *high >= window.low && own.total_cmp(&share).is_eq() && *said == window.feedback =>
            {
                *high = window.high;
            }
            _ => joined.push(([window.low, window.high], share, &window.feedback)),
        }
    }
    joined.sort_by(|(_, left, _), (_, right, _)| right.total_cmp(left));
    let printed = printed(item);
    let parsed: f64 = printed.parse().unwrap_or(item.right);
    let home = joined.iter().find(|(ends, share, _)| *share >= ALL && (ends[0]..=ends[1]).contains(&parsed));
    let first = home.map(|([low, high], share, feedback)| {
        let tolerance = (parsed - low).min(high - parsed);
        Answer { value: printed, tolerance, fraction: *share, feedback }
    });
    // A direction may be off by whole turns.
    let turns = item.turn.map_or(vec![0.0], |turn| vec![0.0, turn, -turn]);
    let others = turns.into_iter().flat_map(|turn| {
        joined.iter().map(move |(ends, fraction, feedback)| {
            let [low, high] = ends.map(|end| end + turn);
            let value = low + (high - low) / 2.0;
            let rounding = 4.0 * f64::EPSILON * low.abs().max(high.abs());
            let tolerance = (high - low) / 2.0 + rounding;
            Answer { value: value.to_string(), tolerance, fraction: *fraction, feedback }
        })
    });
    (first.into_iter().chain(others).collect(), changed)
}

/// The right value to the figures that are asked, with a point.
fn printed(item: &NumberItem) -> String {
    if item.whole { format!("{:.0}", item.right) } else { format!("{:.*e}", item.figures.max(1) - 1, item.right) }
}

/// Each spelling of the unit and of usual others, with how many of it make one of the unit asked. Moodle takes spaces out of what
/// is typed, and not out of these. None where there is no unit, or it begins with a digit, which Moodle would read as one of the number.
pub(super) fn units(asked: &Unit) -> Vec<(String, f64)> {
    let mut all: Vec<(String, f64)> = Vec::new();
    let is_typed = |unit: &Unit| !unit.to_string().starts_with(|first: char| first.is_ascii_digit());
    if asked.is_none() || !is_typed(asked) {
        return all;
    }
    let usual = USUAL_UNITS.iter().filter_map(|text| Unit::parse(text).ok());
    let same = usual.filter(|unit| unit.dimension() == asked.dimension() && is_typed(unit));
    for unit in std::iter::once(asked.clone()).chain(same) {
        let multiplier = if unit == *asked { 1.0 } else { asked.in_terms_of(&unit).to_f64() };
        let plain = unit.to_string();
        let raised = unit.unicode();
        for name in
            [plain.replace(' ', ""), plain.replace(' ', "*"), plain.replace(' ', "·"), raised.replace('·', "⋅"), raised]
        {
            if !name.is_empty() && !all.iter().any(|(own, _)| *own == name) {
                all.push((name, multiplier));
            }
        }
    }
    all
}
