//! Motions by a formula: what kinds of them there are, and how one is run to an event.

use super::integrate::{End, MOST_STEPS, Stop, located};
use super::nothing::NothingToSimulate;

// Why a motion has a formula, as a clause.
pub(super) const POLYNOMIAL: &str = "no force depends on place or velocity, and the motion is a polynomial in time";
pub(super) const INTEGRALS: &str =
    "no force depends on place or velocity, and the integrals of the forces have a formula";
pub(super) const SINES: &str = "springs alone depend on the places, and the motion is a sum of sines";
pub(super) const EXPONENTIALS: &str =
    "the resistance is in proportion to the speed, and the motion is a sum of exponentials";
pub(super) const SQUARES: &str =
    "the resistance is in proportion to the square of the speed on a line, which has a formula";
pub(super) const CIRCLE: &str = "a circle is run through with one speed";

pub(super) const CONIC: &str = "an orbit about one centre is a conic section";
pub(super) const GIVEN: &str = "the place, or an integral of the velocity, is given as a term in the time";
pub(super) const LOGARITHMS: &str =
    "a mass that changes steadily under a steady force has a speed and a way with logarithms";

// For what there is no formula here, as a noun.
pub(super) const ARM: &str = "an arm that changes its lengths while it turns";
pub(super) const CENTRAL: &str = "a spring to a fixed point that is slack at some distance from it";
pub(super) const BY_PLACE: &str = "a velocity that is given at each place";
pub(super) const BURNING: &str = "a mass that changes under a resistance or a force that changes";
pub(super) const CURVE: &str = "a motion on a cord or a curved surface under a force along it";
pub(super) const STRENGTH: &str = "a force whose integrals have no formula here";
pub(super) const DRIVEN: &str = "springs or a resistance under a force that is no polynomial in time";
pub(super) const MIXED: &str = "springs and resistances together";
pub(super) const COUPLED: &str = "a resistance in proportion to the square of the speed that other forces change";

/// What a motion follows from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Followed {
    /// A formula, and why there is one, as a clause.
    Formula(&'static str),
    /// Its equations of motion, and for what there is no formula here, as a noun.
    Equations(&'static str),
}

impl Followed {
    /// What a motion in two parts follows from.
    pub(super) fn and(self, next: Self) -> Self {
        if let Self::Formula(_) = self { next } else { self }
    }
}

/// The course of a motion from a start on.
pub(super) enum Course<const N: usize> {
    Formula(Formula<N>),
    /// For what there is no formula.
    Equations(&'static str),
}

/// A motion as a function of the time.
pub(super) struct Formula<const N: usize> {
    /// Why there is one.
    pub why: &'static str,
    /// The state at a time.
    pub at: Box<dyn Fn(f64) -> [f64; N]>,
}

impl<const N: usize> Course<N> {
    /// A formula for a reason.
    pub(super) fn formula(why: &'static str, at: impl Fn(f64) -> [f64; N] + 'static) -> Self {
        Self::Formula(Formula { why, at: Box::new(at) })
    }

    /// The course of what follows from it at each time.
    pub(super) fn map<const M: usize>(self, follows: impl Fn(f64, [f64; N]) -> [f64; M] + 'static) -> Course<M> {
        match self {
            Self::Formula(Formula { why, at }) => Course::formula(why, move |now| follows(now, at(now))),
            Self::Equations(what) => Course::Equations(what),
        }
    }

    /// The formula, where there is one.
    pub(super) fn known(&self) -> Option<&Formula<N>> {
        if let Self::Formula(formula) = self { Some(formula) } else { None }
    }

    pub(super) fn followed(&self) -> Followed {
        match self {
            Self::Formula(formula) => Followed::Formula(formula.why),
            Self::Equations(what) => Followed::Equations(what),
        }
    }
}

impl<const N: usize> Formula<N> {
    /// Runs until an event, looked for in steps of a length, or a time if that comes first: as an integrator does.
    pub(super) fn run(
        &self,
        (start, state): (f64, [f64; N]),
        end: f64,
        longest: f64,
        stop: Stop<'_, N>,
    ) -> Result<End<N>, NothingToSimulate> {
        let (mut time, mut before, mut size) = (start, stop(start, &state), state.map(f64::abs));
        for _ in 0..MOST_STEPS {
            let next = if end - time <= longest { end } else { time + longest };
            let reached = (self.at)(next);
            if !reached.iter().all(|value| value.is_finite()) {
                return Err(NothingToSimulate::NoMethod);
            }
            let after = stop(next, &reached);
            if before > 0.0 && after <= 0.0 {
                let crossing = &mut |part| stop(time + part, &(self.at)(time + part));
                let time = time + located(crossing, next - time, [before, after]);
                return Ok(End { time, state: (self.at)(time), stopped: true, largest: size });
            }
            for (size, value) in size.iter_mut().zip(&reached) {
                *size = size.max(value.abs());
            }
            if next >= end {
                return Ok(End { time: end, state: reached, stopped: false, largest: size });
            }
            (time, before) = (next, after);
        }
        Err(NothingToSimulate::NoMethod)
    }
}
