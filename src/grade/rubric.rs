//! The worth of a partly right answer, and the cost of attempts and hints.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use momentous_quantity::Rational;

use super::marks::Points;
use super::verdict::Verdict;

/// The fraction of a part's points for each kind of partly right answer, and the cost of attempts and hints.
///
/// The defaults are those of an instructor who asks for physics first: a number that is right shows that the
/// method is, so a slip of writing beside it costs half; a direction that is plainly the wrong one is wrong physics.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Rubric {
    fractions: BTreeMap<Verdict, Rational>,
    /// How attempts and hints count.
    pub attempts: Attempts,
}

/// How attempts and hints count.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attempts {
    /// How many attempts at a part count; later ones are not marked. `None` is any number.
    pub most: Option<u32>,
    /// The fraction of the points that each attempt before costs. Default: 0.
    pub penalty: Rational,
    /// The fraction of the points that each hint of the author's costs. Default: 0.
    pub hint: Rational,
    /// The fraction of the points that each further hint on a wrong answer costs. Default: 0.
    pub further_hint: Rational,
    /// Which attempt counts. Default: the best.
    pub keep: Keep,
    /// When students are told what was found. Default: at once.
    pub told: FeedbackTime,
}

/// The hints that a student has seen by the time of an attempt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct HintsSeen {
    /// The author's.
    pub hints: u32,
    /// Further ones, on wrong answers.
    pub further: u32,
}

/// When students are told what was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum FeedbackTime {
    /// With each attempt. A right part is locked.
    #[default]
    AtOnce,
    /// After the last attempt. Nothing is locked, and a text that can be read costs an attempt whatever comes of it: nothing that
    /// happens before tells anything of the right answer.
    Later,
}

/// Which of several attempts counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Keep {
    /// The sheet with the most points.
    #[default]
    Best,
    /// The last sheet.
    Last,
}

impl Default for Attempts {
    fn default() -> Self {
        Self {
            most: None,
            penalty: Rational::ZERO,
            hint: Rational::ZERO,
            further_hint: Rational::ZERO,
            keep: Keep::Best,
            told: FeedbackTime::AtOnce,
        }
    }
}

impl Rubric {
    /// The same rubric with another fraction for a verdict, held between 0 and 1. What is right or wrong stays so.
    #[must_use]
    pub fn with(mut self, verdict: Verdict, fraction: Rational) -> Self {
        if verdict.is_negotiable() {
            self.fractions.insert(verdict, fraction.clamp(Rational::ZERO, Rational::ONE));
        }
        self
    }

    /// The fraction of the points for a verdict, between 0 and 1.
    ///
    /// ```
    /// use momentous_grade::{Rubric, Verdict};
    /// assert_eq!(Rubric::default().fraction(Verdict::UnitMissing).to_string(), "1/2");
    /// ```
    #[must_use]
    pub fn fraction(&self, verdict: Verdict) -> Rational {
        let (above, below) = verdict.usual_fraction();
        let usual = || Rational::from(above) / Rational::from(below);
        self.fractions.get(&verdict).cloned().unwrap_or_else(usual)
    }

    /// The points of an answer with this verdict.
    #[must_use]
    pub fn points(&self, verdict: Verdict, out_of: u32) -> Points {
        // A whole number of points, which most are, takes no fractions.
        match verdict.usual_fraction() {
            (above, 1) if !self.fractions.contains_key(&verdict) => Points(Rational::from(u32::from(above) * out_of)),
            _ => Points(self.fraction(verdict) * Rational::from(out_of)),
        }
    }
}

impl Attempts {
    /// The fraction of the points that is left at an attempt, after so many before it and the hints that were seen.
    #[must_use]
    pub fn left(&self, attempts: u32, seen: HintsSeen) -> Rational {
        if attempts == 0 && seen == HintsSeen::default() {
            return Rational::ONE;
        }
        let cost = &self.penalty * Rational::from(attempts)
            + &self.hint * Rational::from(seen.hints)
            + &self.further_hint * Rational::from(seen.further);
        (Rational::ONE - cost).clamp(Rational::ZERO, Rational::ONE)
    }

    /// Whether an attempt counts, after so many before it.
    #[must_use]
    pub fn counts(&self, attempts: u32) -> bool {
        self.most.is_none_or(|most| attempts < most)
    }
}
