//! Strengths that follow the clock of a stage: laws one after another, with their integrals where these have a formula.

use std::sync::Arc;

use core::f64::consts::PI;

use crate::exact::shifted;

use super::formula::{Course, INTEGRALS, POLYNOMIAL, STRENGTH};

/// A function of the time.
pub(super) type OfTime = Arc<dyn Fn(f64) -> f64 + Send + Sync>;

/// What a strength adds up to in a time that has gone by, and what that adds up to.
pub(super) type Sums = Box<dyn Fn(f64) -> [f64; 2] + Send + Sync>;

/// A law of the time, as far as it is known.
#[derive(Clone)]
pub(super) struct Law {
    pub at: OfTime,
    pub integrals: Integrals,
}

/// The integrals of a law.
#[derive(Clone)]
pub(super) enum Integrals {
    /// Those of a polynomial with these coefficients of 1, t, t², ...
    Polynomial(Vec<f64>),
    /// An antiderivative, and one of that.
    Formula([OfTime; 2]),
    /// No formula was found.
    Unknown,
}

/// A strength in the time of a stage: each law until its time, and nothing after the last.
#[derive(Clone)]
pub(super) struct InTime {
    pieces: Arc<[(f64, Law)]>,
}

impl InTime {
    /// Laws one after another, each with the time until which it holds.
    pub(super) fn pieces(pieces: Vec<(f64, Law)>) -> Self {
        Self { pieces: pieces.into() }
    }

    /// One law for ever.
    pub(super) fn always(law: Law) -> Self {
        Self::pieces(vec![(f64::INFINITY, law)])
    }

    /// A strength that stays what it is.
    pub(super) fn steady(strength: f64) -> Self {
        Self::always(Law { at: Arc::new(move |_| strength), integrals: Integrals::Polynomial(vec![strength]) })
    }

    /// A sine that is zero at the start and has so many half waves in a time.
    pub(super) fn waves(strength: f64, half_waves: f64, time: f64) -> Self {
        let rate = half_waves * PI / time;
        let once = move |at: f64| -strength * libm::cos(rate * at) / rate;
        let twice = move |at: f64| -strength * libm::sin(rate * at) / (rate * rate);
        Self::always(Law {
            at: Arc::new(move |at| strength * libm::sin(rate * at)),
            integrals: Integrals::Formula([Arc::new(once), Arc::new(twice)]),
        })
    }

    /// So many times each of several strengths, together.
    pub(super) fn sum(parts: &[(f64, Self)]) -> Self {
        let mut ends: Vec<f64> =
            parts.iter().flat_map(|(_, part)| part.pieces.iter().map(|(until, _)| *until)).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let law = |until: f64| {
            let laws: Vec<(f64, Law)> = parts
                .iter()
                .filter_map(|(factor, part)| Some((*factor, part.law(until.next_down())?.clone())))
                .collect();
            (until, Law::sum(&laws))
        };
        Self::pieces(ends.into_iter().map(law).collect())
    }

    /// The strength at a time; where the law changes, that of the next one.
    pub(super) fn at(&self, time: f64) -> f64 {
        self.law(time).map_or(0.0, |law| (law.at)(time))
    }

    /// What it adds up to since a moment, and what that adds up to, from one law to the next.
    pub(super) fn course(&self, start: f64) -> Course<2> {
        let (mut all, mut from, mut polynomial) = (Vec::new(), start, true);
        for (until, law) in self.pieces.iter().filter(|(until, _)| *until > start) {
            let Some(sums) = law.integrals_since(from) else { return Course::Equations(STRENGTH) };
            polynomial &= matches!(law.integrals, Integrals::Polynomial(_));
            all.push((from, *until, sums));
            from = *until;
        }
        Course::formula(if polynomial { POLYNOMIAL } else { INTEGRALS }, move |now| {
            let (mut once, mut twice) = (0.0, 0.0);
            for (from, until, sums) in all.iter().filter(|(from, ..)| *from < now) {
                let gone = until.min(now) - from;
                let [gained, shifted] = sums(gone);
                (once, twice) = (once + gained, twice + once * gone + shifted);
            }
            if from < now {
                twice += once * (now - from);
            }
            [once, twice]
        })
    }

    /// The law at a time; none where nothing acts any more.
    pub(super) fn law(&self, time: f64) -> Option<&Law> {
        self.pieces.iter().find(|(until, _)| time < *until).map(|(_, law)| law)
    }
}

impl Law {
    /// No strength at all.
    pub(super) fn nothing() -> Self {
        Self { at: Arc::new(|_| 0.0), integrals: Integrals::Polynomial(Vec::new()) }
    }

    /// The straight line through two points of a graph: a time, and the strength then.
    pub(super) fn line([from, low]: [f64; 2], [to, high]: [f64; 2]) -> Self {
        let slope = (high - low) / (to - from);
        // Where a graph jumps, two of its points have one time, and no time is between them.
        let slope = if slope.is_finite() { slope } else { 0.0 };
        let integrals = Integrals::Polynomial(vec![low - slope * from, slope]);
        Self { at: Arc::new(move |time| low + slope * (time - from)), integrals }
    }

    fn sum(laws: &[(f64, Self)]) -> Self {
        let all: Vec<(f64, OfTime)> = laws.iter().map(|(factor, law)| (*factor, Arc::clone(&law.at))).collect();
        Self { at: added(all), integrals: Integrals::sum(laws) }
    }

    /// The coefficients of 1, t, t², ... in the time since a moment, where it is a polynomial.
    pub(super) fn polynomial_since(&self, start: f64) -> Option<Vec<f64>> {
        match &self.integrals {
            Integrals::Polynomial(coefficients) => Some(shifted(coefficients, start)),
            Integrals::Formula(_) | Integrals::Unknown => None,
        }
    }

    /// What it adds up to since a moment, and what that adds up to, as functions of the time that has gone by; none where that
    /// has no formula.
    pub(super) fn integrals_since(&self, start: f64) -> Option<Sums> {
        match &self.integrals {
            Integrals::Polynomial(coefficients) => {
                let coefficients = shifted(coefficients, start);
                Some(Box::new(move |gone| integrals_of(&coefficients, gone)))
            }
            Integrals::Formula([once, twice]) => {
                let (once, twice) = (Arc::clone(once), Arc::clone(twice));
                let [begun, grown] = [once(start), twice(start)];
                Some(Box::new(move |gone| {
                    let now = start + gone;
                    [once(now) - begun, twice(now) - grown - begun * gone]
                }))
            }
            Integrals::Unknown => None,
        }
    }
}

impl Integrals {
    fn sum(laws: &[(f64, Law)]) -> Self {
        let polynomials: Option<Vec<Vec<f64>>> =
            laws.iter().map(|(factor, law)| law.polynomial_since(0.0).map(|all| scaled(*factor, &all))).collect();
        if let Some(polynomials) = polynomials {
            let length = polynomials.iter().map(Vec::len).max().unwrap_or(0);
            let coefficient = |power: usize| polynomials.iter().filter_map(|all| all.get(power)).sum();
            return Self::Polynomial((0..length).map(coefficient).collect());
        }
        let both: Option<Vec<(f64, [OfTime; 2])>> =
            laws.iter().map(|(factor, law)| Some((*factor, law.integrals.formula()?))).collect();
        both.map_or(Self::Unknown, |both| {
            Self::Formula(
                [0, 1].map(|order| {
                    added(both.iter().map(|(factor, both)| (*factor, Arc::clone(&both[order]))).collect())
                }),
            )
        })
    }

    fn formula(&self) -> Option<[OfTime; 2]> {
        match self {
            Self::Polynomial(coefficients) => Some([0, 1].map(|order| -> OfTime {
                let coefficients = coefficients.clone();
                Arc::new(move |time| integrals_of(&coefficients, time)[order])
            })),
            Self::Formula(both) => Some(both.clone()),
            Self::Unknown => None,
        }
    }
}

fn scaled(factor: f64, coefficients: &[f64]) -> Vec<f64> {
    coefficients.iter().map(|value| factor * value).collect()
}

fn added(parts: Vec<(f64, OfTime)>) -> OfTime {
    Arc::new(move |time| parts.iter().map(|(factor, part)| factor * part(time)).sum())
}

/// The first and the second integral of a polynomial from 0 on.
#[allow(clippy::cast_precision_loss, reason = "powers are small")]
fn integrals_of(coefficients: &[f64], time: f64) -> [f64; 2] {
    let each = coefficients.iter().enumerate().rev().map(|(power, value)| (power as f64 + 1.0, value));
    let [once, twice] = each.fold([0.0; 2], |[once, twice], (next, value)| {
        [once * time + value / next, twice * time + value / (next * (next + 1.0))]
    });
    [once * time, twice * time * time]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2 + 3 t until 1 s and then half a sine of 1 s: what they add up to, by hand.
    #[test]
    fn strengths_add_up_by_their_formulas() {
        let line = Law { at: Arc::new(|time| 2.0 + 3.0 * time), integrals: Integrals::Polynomial(vec![2.0, 3.0]) };
        let first = InTime::pieces(vec![(1.0, line)]);
        let both = InTime::sum(&[(2.0, first), (-1.0, InTime::waves(4.0, 1.0, 1.0))]);
        assert!((both.at(0.5) - (7.0 - 4.0)).abs() < 1e-15 && (both.at(1.5) - 4.0).abs() < 1e-14);
        let since = |time: f64| both.law(time).unwrap().integrals_since(time).unwrap();
        let [once, twice] = since(0.0)(1.0);
        assert!((once - (7.0 - 8.0 / PI)).abs() < 1e-14, "{once}");
        assert!((twice - (3.0 - 4.0 / PI)).abs() < 1e-14, "{twice}");
        assert!((since(1.0)(1.0)[0] - 8.0 / PI).abs() < 1e-14);
    }

    #[test]
    fn a_polynomial_is_one_from_any_moment_on() {
        let square = Law { at: Arc::new(|time| time * time), integrals: Integrals::Polynomial(vec![0.0, 0.0, 1.0]) };
        assert_eq!(square.polynomial_since(2.0), Some(vec![4.0, 4.0, 1.0]));
        let [once, twice] = square.integrals_since(2.0).unwrap()(1.0);
        assert!((once - 19.0 / 3.0).abs() < 1e-14 && (twice - (2.0 + 4.0 / 6.0 + 1.0 / 12.0)).abs() < 1e-14);
    }
}
