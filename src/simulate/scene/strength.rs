//! The strength of a force as it is given: at any time, and as polynomials in the time where it is nothing else.

use std::sync::Arc;

use crate::exact::shifted;
use crate::force::{HIGHEST_POWER, Piece};
use momentous_scene::Strength as Told;

use super::nothing::NothingToSimulate;
use super::values::{OfTime, Values};

impl Values<'_> {
    /// A strength in the time, and when it changes its law.
    pub(super) fn strength(&self, told: &Told) -> Result<(OfTime, Vec<f64>), NothingToSimulate> {
        match told {
            // A vector has no one strength.
            Told::Components(_) => Err(NothingToSimulate::Unread),
            Told::Term(term) => Ok((self.of_time(term)?, Vec::new())),
            Told::Pieces(pieces) => {
                let mut laws = Vec::new();
                for piece in pieces {
                    let until = piece.until.as_ref().map_or(Ok(f64::INFINITY), |term| self.term(term))?;
                    laws.push((until, self.of_time(&piece.is)?));
                }
                let changes = laws.iter().map(|(until, _)| *until).filter(|until| until.is_finite()).collect();
                let at =
                    move |time: f64| laws.iter().find(|(until, _)| time < *until).map_or(0.0, |(_, law)| law(time));
                Ok((Arc::new(at), changes))
            }
            Told::Graph(graph) => {
                let mut points = Vec::new();
                for [time, force] in &graph.points {
                    points.push((self.term(time)?, self.term(force)?));
                }
                let changes = points.iter().map(|(time, _)| *time).collect();
                let at = move |time: f64| {
                    let line = points.windows(2).find(|ends| ends[0].0 <= time && time < ends[1].0);
                    line.map_or(0.0, |ends| {
                        let share = (time - ends[0].0) / (ends[1].0 - ends[0].0);
                        ends[0].1 + share * (ends[1].1 - ends[0].1)
                    })
                };
                Ok((Arc::new(at), changes))
            }
        }
    }

    /// The same as polynomials in the time since `start`; none where it is anything else.
    pub(super) fn polynomials(&self, told: &Told, start: f64) -> Option<Vec<Piece>> {
        let mut pieces: Vec<Piece> = Vec::new();
        let mut add = |until: f64, coefficients: &[f64]| {
            // Where a graph jumps, two of its points have one time.
            if pieces.last().is_none_or(|last| last.until < until - start) {
                pieces.push(Piece { until: until - start, coefficients: shifted(coefficients, start) });
            }
        };
        match told {
            Told::Components(_) => return None,
            Told::Term(term) => add(f64::INFINITY, &self.polynomial(term, HIGHEST_POWER)?),
            Told::Pieces(all) => {
                for piece in all {
                    let until = piece.until.as_ref().map_or(Ok(f64::INFINITY), |term| self.term(term)).ok()?;
                    add(until, &self.polynomial(&piece.is, HIGHEST_POWER)?);
                }
            }
            Told::Graph(graph) => {
                let point = |[time, force]: &[_; 2]| Some([self.term(time).ok()?, self.term(force).ok()?]);
                let points = graph.points.iter().map(point).collect::<Option<Vec<_>>>()?;
                add(points.first()?[0], &[]);
                for ends in points.windows(2) {
                    let [[from, low], [to, high]] = [ends[0], ends[1]];
                    let slope = (high - low) / (to - from);
                    if slope.is_finite() {
                        add(to, &[low - slope * from, slope]);
                    }
                }
            }
        }
        Some(pieces)
    }
}
