//! Circles round an upright axis that are run through with one speed.

use super::particles::{Constraint, place, velocity};
use super::system::System;
use super::vector::{add, dot, less, size, times};

/// The share of the acceleration that may be missing from that of a steady circle: rounding.
const ROUNDING: f64 = 1e-12;

/// The state of one particle at a time whose circle round the axis of a fixed surface neither rises nor sinks, nor gets faster:
/// round the axis everything is alike, so that it goes on so.
pub(super) fn steady_circle<const N: usize>(
    system: &System<'_, N>,
    begun: f64,
    start: &[f64; N],
) -> Option<impl Fn(f64) -> [f64; N] + use<N>> {
    let (Some(Constraint::Surface(surface)), [particle], true) =
        (&system.constraint, &system.particles[..], system.forces.is_empty())
    else {
        return None;
    };
    let [across, round, _] = surface.squares;
    let is_round = surface.carrier.is_none() && surface.changes == 0.0 && across.total_cmp(&round).is_eq();
    let upright = particle.falls[0] == 0.0 && particle.falls[1] == 0.0 && particle.guide.is_none();
    let (centre, moving) = (surface.centre, velocity(start, 0));
    let out = less(place(start, 0), centre);
    let out = [out[0], out[1], 0.0];
    let ahead = [-out[1], out[0], 0.0];
    let rate = dot(ahead, moving) / dot(out, out);
    let towards = times(-rate * rate, out);
    let acceleration = velocity(&system.slope(begun, start), 0);
    let off = size(less(acceleration, towards)) + rate.abs() * size(less(moving, times(rate, ahead)));
    if !(is_round && upright && off <= ROUNDING * size(towards)) {
        return None;
    }
    let (start, axis) = (*start, [centre[0], centre[1], start[2]]);
    Some(move |now: f64| {
        let angle = rate * (now - begun);
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        let turned = add(times(cosine, out), times(sine, ahead));
        let mut state = start;
        state[..3].copy_from_slice(&add(axis, turned));
        state[3..6].copy_from_slice(&times(rate, [-turned[1], turned[0], 0.0]));
        state
    })
}
