//! How the points of assignments make the grade of a course.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use momentous_quantity::Rational;

/// How much the assignments of a course count, and how many a student may miss.
#[derive(Clone, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
pub struct Grading {
    /// How much an assignment counts beside the others, by the text of its key; one that is not named counts as much as it has points.
    #[serde(default)]
    pub weights: BTreeMap<String, u32>,
    /// The number of a student's weakest assignments that are left out.
    #[serde(default)]
    pub dropped: u32,
}

/// The points that a student has reached in an assignment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reached {
    /// The text of the assignment's key.
    pub assignment: String,
    /// The points.
    pub points: Rational,
    /// The points that can be reached.
    pub out_of: u32,
    /// Whether it has closed for the student.
    pub is_over: bool,
}

/// Whether an assignment is part of a student's grade.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// It counts.
    Counts,
    /// Not yet: the student may still hand in.
    Open,
    /// It is one of the weakest, which are left out.
    LeftOut,
    /// Never: it has no weight, or nothing in it has points.
    Weightless,
}

/// The grade of a student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CourseGrade {
    /// The part of each assignment in it.
    pub parts: Vec<Part>,
    /// The share of what could be reached; nothing as long as nothing counts.
    pub share: Option<Rational>,
}

impl Grading {
    /// How much an assignment counts.
    #[must_use]
    pub fn weight(&self, assignment: &str, out_of: u32) -> u32 {
        self.weights.get(assignment).copied().unwrap_or(out_of)
    }

    /// The grade of a student who has reached that: the mean of the shares of points, each with its weight, without the weakest. One
    /// assignment always stays.
    #[must_use]
    pub fn grade(&self, reached: &[Reached]) -> CourseGrade {
        let share = |reached: &Reached| &reached.points / Rational::from(reached.out_of);
        let part = |reached: &Reached| match self.weight(&reached.assignment, reached.out_of) {
            0 => Part::Weightless,
            _ if reached.out_of == 0 => Part::Weightless,
            _ if !reached.is_over => Part::Open,
            _ => Part::Counts,
        };
        let mut parts: Vec<Part> = reached.iter().map(part).collect();
        let counting = |parts: &[Part]| -> Vec<usize> {
            (0..parts.len()).filter(|place| parts.get(*place) == Some(&Part::Counts)).collect()
        };
        let mut weakest = counting(&parts);
        weakest.sort_by_key(|place| reached.get(*place).map(share));
        let most = weakest.len().saturating_sub(1).min(usize::try_from(self.dropped).unwrap_or(usize::MAX));
        for place in weakest.into_iter().take(most) {
            if let Some(part) = parts.get_mut(place) {
                *part = Part::LeftOut;
            }
        }
        let counted: Vec<&Reached> = counting(&parts).into_iter().filter_map(|place| reached.get(place)).collect();
        let weight = |reached: &Reached| Rational::from(self.weight(&reached.assignment, reached.out_of));
        let whole = counted.iter().fold(Rational::ZERO, |sum, reached| sum + weight(reached));
        let sum = counted.iter().fold(Rational::ZERO, |sum, reached| sum + weight(reached) * share(reached));
        CourseGrade { share: (!counted.is_empty()).then(|| sum / whole), parts }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reached(number: u8, points: u32, out_of: u32, is_over: bool) -> Reached {
        Reached { assignment: number.to_string(), points: Rational::from(points), out_of, is_over }
    }

    /// By hand: 8 of 10 and 5 of 20 are 13 of 30 by points; with equal weights (0.8 + 0.25) / 2 = 21/40; without the weaker 4/5.
    #[test]
    fn points_weights_and_the_weakest() {
        let all = [reached(1, 8, 10, true), reached(2, 5, 20, true), reached(3, 0, 10, false), reached(4, 0, 0, true)];
        let fraction = |above: u32, below: u32| Some(Rational::from(above) / Rational::from(below));
        let by_points = Grading::default().grade(&all);
        assert_eq!(by_points.share, fraction(13, 30));
        assert_eq!(by_points.parts, [Part::Counts, Part::Counts, Part::Open, Part::Weightless]);
        let weights: BTreeMap<_, _> = all.iter().take(2).map(|reached| (reached.assignment.clone(), 1)).collect();
        assert_eq!(Grading { weights: weights.clone(), dropped: 0 }.grade(&all).share, fraction(21, 40));
        let without = Grading { weights, dropped: 1 }.grade(&all);
        assert_eq!((without.share, without.parts[1]), (fraction(4, 5), Part::LeftOut));
        let one_stays = Grading { dropped: 9, ..Grading::default() }.grade(&all);
        assert_eq!(one_stays.share, fraction(4, 5));
        assert_eq!(Grading::default().grade(&all[2..]).share, None);
    }
}
