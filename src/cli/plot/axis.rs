//! An axis of a plot: where a value stands along it, and what is written beside it.

use crate::figure::Ticks;

/// An axis.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// The measure, with its unit.
    pub label: String,
    scale: Scale,
    /// Values with a line across the plot, and what is written there, as SVG: nothing where it would touch its neighbour.
    pub(super) ticks: Vec<(f64, String)>,
}

#[derive(Clone, Copy, Debug)]
enum Scale {
    Linear {
        low: f64,
        high: f64,
    },
    /// In powers of ten.
    Logarithmic {
        low: f64,
        high: f64,
    },
}

/// The decades of errors: what is smaller counts as exact, what is larger is drawn at the edge.
const EXACT: i32 = -17;
const LARGEST: i32 = 2;

impl Axis {
    /// Round numbers over the range of what is shown.
    pub(crate) fn linear(label: &str, values: impl Iterator<Item = f64>) -> Self {
        let finite = values.filter(|value| value.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            let (low, high): (f64, f64) = (low, high);
            (low.min(value), high.max(value))
        });
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        // What stays the same but for rounding is a level line in the middle, not the noise of its last digits.
        let least = 1e-9 * low.abs().max(high.abs()).max(1e-300);
        let room = if high - low > least { 0.04 * (high - low) } else { 0.5 * low.abs().max(high.abs()).max(1e-9) };
        let (low, high) = (low - room, high + room);
        let ticks = Ticks::between(low, high);
        let label = if ticks.power == 0 {
            super::escaped(label)
        } else {
            format!("{}, in {}", super::escaped(label), power_of_ten(ticks.power))
        };
        let texts = ticks.values.iter().map(|value| (*value, ticks.text(*value).replace('-', "\u{2212}"))).collect();
        Self { label, scale: Scale::Linear { low, high }, ticks: texts }
    }

    /// Errors from exact to a hundred times the value.
    pub(crate) fn errors(label: &str) -> Self {
        let decades = (EXACT..=LARGEST).filter(|decade| decade % 2 == 0 || *decade == EXACT);
        let ticks = decades.map(|decade| {
            let text = match decade {
                EXACT => "exact".to_owned(),
                // It would touch the label beside it.
                _ if decade == EXACT + 1 => String::new(),
                0 => "1".to_owned(),
                _ => power_of_ten(decade),
            };
            (libm::pow(10.0, f64::from(decade)), text)
        });
        let scale = Scale::Logarithmic { low: f64::from(EXACT), high: f64::from(LARGEST) };
        Self { label: super::escaped(label), ticks: ticks.collect(), scale }
    }

    /// Powers of ten from one to another.
    pub(crate) fn decades(label: &str, low: f64, high: f64) -> Self {
        let (low, high) = (libm::round(libm::log10(low)), libm::round(libm::log10(high)));
        let decades = (-300..=300).filter(|decade| (low..=high).contains(&f64::from(*decade)));
        let ticks = decades.map(|decade| (libm::pow(10.0, f64::from(decade)), power_of_ten(decade))).collect();
        Self { label: super::escaped(label), scale: Scale::Logarithmic { low, high }, ticks }
    }

    /// Whole decades, from the shortest time to the longest.
    pub(crate) fn times(label: &str, seconds: impl Iterator<Item = f64>) -> Self {
        Self::whole_decades(label, seconds, time)
    }

    /// Whole decades, from the smallest count to the largest.
    pub(crate) fn counts(label: &str, counts: impl Iterator<Item = f64>) -> Self {
        #[allow(clippy::cast_possible_truncation, reason = "a whole decade")]
        Self::whole_decades(label, counts.filter(|count| *count > 0.0), |decade| power_of_ten(decade as i32))
    }

    fn whole_decades(label: &str, values: impl Iterator<Item = f64>, text: fn(f64) -> String) -> Self {
        let logs = values.map(libm::log10);
        let (low, high) =
            logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), log| (f64::min(low, log), f64::max(high, log)));
        let (low, high) = (libm::floor(low).clamp(-12.0, 12.0), libm::ceil(high).clamp(-12.0, 12.0));
        let high = high.max(low + 1.0);
        let mut ticks = Vec::new();
        let mut decade = low;
        while decade <= high {
            ticks.push((libm::pow(10.0, decade), text(decade)));
            decade += 1.0;
        }
        Self { label: super::escaped(label), scale: Scale::Logarithmic { low, high }, ticks }
    }

    /// The part of an axis at which a value stands, from 0 at the start to 1 at the end; at the edge where it lies beyond.
    pub(super) fn part(&self, value: f64) -> f64 {
        let (value, low, high) = match self.scale {
            Scale::Linear { low, high } => (value, low, high),
            Scale::Logarithmic { low, high } if value > 0.0 => (libm::log10(value), low, high),
            Scale::Logarithmic { low, high } => (low, low, high),
        };
        ((value - low) / (high - low)).clamp(0.0, 1.0)
    }
}

fn power_of_ten(power: i32) -> String {
    format!("10<tspan class=\"small\" dy=\"-5\">{}</tspan>", power.to_string().replace('-', "\u{2212}"))
}

/// A power of ten of seconds as people say it.
fn time(decade: f64) -> String {
    let (base, unit) = match decade {
        decade if decade < -9.0 => (-12.0, "ps"),
        decade if decade < -6.0 => (-9.0, "ns"),
        decade if decade < -3.0 => (-6.0, "µs"),
        decade if decade < 0.0 => (-3.0, "ms"),
        _ => (0.0, "s"),
    };
    format!("{:.0} {unit}", libm::pow(10.0, decade - base))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_line_stands_in_the_middle() {
        let axis = Axis::linear("p", [6.0, 6.0 + 1e-15].into_iter());
        assert!((axis.part(6.0) - 0.5).abs() < 1e-9);
        assert!((Axis::linear("x", [0.0, 0.0].into_iter()).part(0.0) - 0.5).abs() < 1e-9);
    }

    #[test]
    fn decades_are_evenly_spaced_and_edges_hold() {
        let axis = Axis::times("t", [2e-6, 5e-4].into_iter());
        assert!((axis.part(1e-5) - 1.0 / 3.0).abs() < 1e-12);
        let texts: Vec<&str> = axis.ticks.iter().map(|(_, text)| text.as_str()).collect();
        assert_eq!(texts, ["1 µs", "10 µs", "100 µs", "1 ms"]);
        let errors = Axis::errors("error");
        assert_eq!((errors.part(0.0), errors.part(1e9)), (0.0, 1.0));
    }
}
