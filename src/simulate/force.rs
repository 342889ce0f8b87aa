//! Forces between impacts: constant, varying in time, quadratic drag, central gravity.

use std::fmt;
use std::sync::Arc;

use super::state::Vector;

/// The highest power of time in a force that has an exact motion: with it the square of a distance has the degree 16.
pub(super) const HIGHEST_POWER: usize = 6;

/// A force on one body, by its place in the list.
#[derive(Clone, Debug)]
pub enum Force<const D: usize> {
    /// A constant force, in N.
    Constant {
        /// The body.
        body: usize,
        /// The force in N.
        force: Vector<D>,
    },
    /// A force of constant direction whose strength follows the time.
    Varying {
        /// The body.
        body: usize,
        /// The direction; the strength is multiplied by its length.
        direction: Vector<D>,
        /// The strength in N.
        strength: Strength,
    },
    /// The resistance of a medium at rest, `-k |v| v`.
    Drag {
        /// The body.
        body: usize,
        /// The coefficient `k` in kg/m; `m g / v_t^2` for a terminal speed `v_t`.
        coefficient: f64,
    },
    /// The attraction of a fixed centre, an acceleration `-mu r / |r|^3`.
    Central {
        /// The body.
        body: usize,
        /// The centre.
        centre: Vector<D>,
        /// The gravitational parameter `mu` in m³/s².
        parameter: f64,
    },
}

/// How strong a force is at a time.
#[derive(Clone)]
pub enum Strength {
    /// Polynomials in the time, one after another, with nothing after the last.
    Pieces(Vec<Piece>),
    /// Anything else.
    Function(Arc<dyn Fn(f64) -> f64 + Send + Sync>),
}

/// A polynomial in the time until a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Until when, in s; infinity for ever.
    pub until: f64,
    /// The coefficients of 1, t, t², ..., where t is the time since the start of the run.
    pub coefficients: Vec<f64>,
}

impl fmt::Debug for Strength {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pieces(pieces) => out.debug_tuple("Pieces").field(pieces).finish(),
            Self::Function(_) => out.write_str("Function"),
        }
    }
}

impl Strength {
    /// A polynomial for ever: the coefficients of 1, t, t², ...
    #[must_use]
    pub fn polynomial(coefficients: &[f64]) -> Self {
        Self::Pieces(vec![Piece { until: f64::INFINITY, coefficients: coefficients.to_vec() }])
    }

    /// The strength at a time, in N; at the end of a piece that of the next.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Function(function) => function(time),
            Self::Pieces(pieces) => pieces
                .iter()
                .find(|piece| time < piece.until)
                .map_or(0.0, |piece| piece.coefficients.iter().rev().fold(0.0, |sum, value| sum * time + value)),
        }
    }
}

impl<const D: usize> Force<D> {
    /// The body on which it acts.
    #[must_use]
    pub fn body(&self) -> usize {
        match self {
            Self::Constant { body, .. }
            | Self::Varying { body, .. }
            | Self::Drag { body, .. }
            | Self::Central { body, .. } => *body,
        }
    }

    /// Whether it acts on one of `bodies` bodies and its numbers are finite.
    pub(super) fn is_sound(&self, bodies: usize) -> bool {
        let finite = |vector: &Vector<D>| vector.iter().all(|value| value.is_finite());
        self.body() < bodies
            && match self {
                Self::Constant { force, .. } => finite(force),
                Self::Varying { direction, strength, .. } => {
                    let sound = match strength {
                        Strength::Function(_) => true,
                        Strength::Pieces(pieces) => {
                            pieces.is_sorted_by(|one, next| one.until < next.until)
                                && pieces.iter().all(|piece| piece.coefficients.iter().all(|value| value.is_finite()))
                        }
                    };
                    finite(direction) && sound
                }
                Self::Drag { coefficient, .. } => coefficient.is_finite() && *coefficient >= 0.0,
                Self::Central { centre, parameter, .. } => finite(centre) && parameter.is_finite(),
            }
    }

    /// The acceleration that it gives a body of this mass.
    pub(super) fn acceleration(&self, mass: f64, time: f64, position: &Vector<D>, velocity: &Vector<D>) -> Vector<D> {
        match self {
            Self::Constant { force, .. } => force / mass,
            Self::Varying { direction, strength, .. } => direction * (strength.at(time) / mass),
            Self::Drag { coefficient, .. } => velocity * (-coefficient * velocity.norm() / mass),
            Self::Central { centre, parameter, .. } => {
                let radius = position - centre;
                let distance = radius.norm();
                radius * (-parameter / (distance * distance * distance))
            }
        }
    }
}
