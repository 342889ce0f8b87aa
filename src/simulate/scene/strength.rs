//! The strength of a force as it is given: at any time, and as polynomials in the time where it is nothing else.

use crate::exact::shifted;
use crate::force::{HIGHEST_POWER, Piece};
use momentous_scene::Strength as Told;

use super::in_time::{InTime, Law};
use super::nothing::NothingToSimulate;
use super::values::Values;

impl Values<'_> {
    /// A strength in the time, and when it changes its law.
    pub(super) fn strength(&self, told: &Told) -> Result<(InTime, Vec<f64>), NothingToSimulate> {
        let mut laws = Vec::new();
        match told {
            // A vector has no one strength.
            Told::Components(_) => return Err(NothingToSimulate::Unread),
            Told::Term(term) => laws.push((f64::INFINITY, self.law(term)?)),
            Told::Pieces(pieces) => {
                for piece in pieces {
                    let until = piece.until.as_ref().map_or(Ok(f64::INFINITY), |term| self.term(term))?;
                    laws.push((until, self.law(&piece.is)?));
                }
            }
            Told::Graph(graph) => {
                let mut before: Option<[f64; 2]> = None;
                for [time, force] in &graph.points {
                    let point = [self.term(time)?, self.term(force)?];
                    laws.push((point[0], before.map_or_else(Law::nothing, |before| Law::line(before, point))));
                    before = Some(point);
                }
            }
        }
        let changes = laws.iter().map(|(until, _)| *until).filter(|until| until.is_finite()).collect();
        Ok((InTime::pieces(laws), changes))
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
