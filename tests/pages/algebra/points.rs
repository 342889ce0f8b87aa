//! Points at which an identity is tried: the numbers of the variant, and others.

use std::collections::BTreeSet;

use super::term::{Term, Values};

/// The fewest points at which both sides must have values.
const FEWEST: usize = 3;

/// Points to try.
pub struct Points {
    points: Vec<Values>,
}

impl Points {
    /// Points for the names of these terms: those of the variant, and values near them and far from them.
    pub fn of<'t>(terms: impl Iterator<Item = &'t Term>, actual: &Values) -> Self {
        let names: BTreeSet<String> = terms.flat_map(Term::names).collect();
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut points = vec![actual.clone()];
        for round in 0..24 {
            let mut point = actual.clone();
            for name in &names {
                let value = actual.get(name).copied().unwrap_or(f64::NAN);
                let usual = if value.is_finite() && value != 0.0 { value } else { 1.0 };
                let shifted = match round % 3 {
                    0 => usual * (0.8 + 0.4 * random()),
                    1 => 0.2 + 1.3 * random(),
                    _ => usual.signum() * (0.2 + 1.3 * random()),
                };
                point.insert(name.clone(), shifted);
            }
            points.push(point);
        }
        Self { points }
    }

    /// The numbers of the variant and no others.
    pub fn only(actual: &Values) -> Self {
        Self { points: vec![actual.clone(); FEWEST] }
    }

    /// Whether something holds at every point where it can be said.
    pub fn all(self, holds: &dyn Fn(&Values) -> Option<bool>) -> Result<(), String> {
        let said: Vec<bool> = self.points.iter().filter_map(holds).collect();
        match said.iter().position(|holds| !holds) {
            _ if said.len() < FEWEST => Err(format!("has values at {} points only", said.len())),
            Some(place) => Err(format!("is not true, at point {place} of {}", said.len())),
            None => Ok(()),
        }
    }
}
