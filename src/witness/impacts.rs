//! The table of impacts, for people.

use momentous_quantity::with_minus_signs;
use momentous_simulate::RecordedImpact;

use super::film::Film;

/// The headings of the table of impacts.
pub const IMPACTS: [&str; 5] = ["time in s", "between", "impulse in N s", "energy before in J", "energy after in J"];

/// The share of the length of a film below which a time is rounding.
const ROUNDING: f64 = 1e-12;

/// The share of the energy of the strongest impact below which one after the other says nothing new.
const WEAK: f64 = 1e-6;

/// Figures in tables for people.
const FIGURES: usize = 4;

impl Film {
    /// The rows of the table of impacts, without the last ones where they are [`Self::weak_impacts`].
    #[must_use]
    pub fn impacts(&self) -> Vec<Vec<String>> {
        self.strong_impacts().iter().map(|impact| row(impact, self.time(impact))).collect()
    }

    /// How it goes on after the rows of the table, with impacts of hardly any energy; none where the table has all.
    #[must_use]
    pub fn weak_impacts(&self) -> Option<String> {
        let weak = self.record.impacts.get(self.strong_impacts().len()..)?;
        let until = figures(self.time(weak.last()?));
        let count = weak.len();
        Some(format!(
            "And so on: {count} more, each with less than a millionth of the energy of the strongest, until {until} s."
        ))
    }

    /// The impacts up to the last that is not weak.
    fn strong_impacts(&self) -> &[RecordedImpact] {
        let all = &self.record.impacts;
        // Between the same bodies energies go as the squares of impulses.
        let squared = |impact: &RecordedImpact| impact.impulse.iter().map(|part| part * part).sum::<f64>();
        let strongest = all.iter().map(squared).fold(0.0, f64::max);
        let strong = all.iter().rposition(|impact| squared(impact) > WEAK * strongest).map_or(0, |last| last + 1);
        // A single one says itself what a sentence would.
        if all.len() - strong < 2 { all } else { &all[..strong] }
    }

    /// The time of an impact; one that is nothing but rounding is the origin.
    fn time(&self, impact: &RecordedImpact) -> f64 {
        let moments = &self.record.moments;
        let length = moments.first().zip(moments.last()).map_or(0.0, |(first, last)| last.time - first.time);
        if impact.time.abs() <= ROUNDING * length { 0.0 } else { impact.time }
    }
}

fn row(impact: &RecordedImpact, time: f64) -> Vec<String> {
    let impulse = match impact.impulse.as_slice() {
        [only] => figures(*only),
        more => format!("({})", more.iter().map(|part| figures(*part)).collect::<Vec<_>>().join(", ")),
    };
    let [before, after] = [impact.energy_before, impact.energy_after].map(figures);
    vec![figures(time), impact.contact.clone(), impulse, before, after]
}

/// A number with four figures, as short as it can be written.
fn figures(value: f64) -> String {
    let rounded: f64 = format!("{value:.*e}", FIGURES - 1).parse().unwrap_or(value);
    let size = rounded.abs();
    let text = if size == 0.0 {
        "0".to_owned()
    } else if (1e-4..1e7).contains(&size) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    };
    with_minus_signs(&text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_short() {
        let cases = [(0.0, "0"), (-2.5, "\u{2212}2.5"), (1.0 / 3.0, "0.3333"), (6e24, "6e24"), (1e-5, "1e\u{2212}5")];
        for (value, text) in cases {
            assert_eq!(figures(value), text);
        }
    }
}
