//! A contact that lasts: a spring that takes up the approach and gives a part of it back.
//!
//! Pressed, the spring has one stiffness; released, a greater one, so that it is relaxed before it has its old length. With
//! the ratio e² of the two it returns the share e of the relative velocity, whatever the masses (Walton and Braun, 1986).

use super::bench::{Bench, Way};
use super::integrate::Integrator;
use super::nothing::NothingToSimulate;
use super::vector::{Vector, ZERO, dot, less, times};

/// The longest step beside the time of the contact, which is of the order of a second.
const LONGEST: f64 = 0.1;

/// One of two that touch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Party {
    /// Its mass; none where it is too heavy to be moved.
    pub mass: Option<f64>,
    pub velocity: Vector,
    /// The one direction in which a guide lets it move.
    pub guide: Option<Vector>,
}

/// Two bodies at the moment in which they meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    pub parties: [Party; 2],
    /// From the first to the second.
    pub normal: Vector,
    pub restitution: f64,
}

/// How they part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parted {
    pub velocities: [Vector; 2],
    /// The impulse of the contact on each.
    pub impulses: [Vector; 2],
    /// The impulse of the guide of each.
    pub reactions: [Vector; 2],
    /// The velocity of both along the normal when they are nearest.
    pub common: f64,
    /// The magnitude of the impulse until then, and from then on.
    pub phases: [f64; 2],
}

impl Party {
    /// A body that nothing guides.
    pub(super) fn free(mass: f64, velocity: Vector) -> Self {
        Self { mass: Some(mass), velocity, guide: None }
    }

    /// What a force does to it: the acceleration, and what its guide adds to the force.
    pub(super) fn yields(&self, force: Vector) -> (Vector, Vector) {
        let Some(mass) = self.mass else { return (ZERO, ZERO) };
        let felt = match self.guide {
            Some(along) => times(dot(along, force), along),
            None => force,
        };
        (times(1.0 / mass, felt), less(felt, force))
    }
}

/// Overlap, both velocities, and the magnitude of the impulse.
type State = [f64; 8];

/// Where the impulse stands in a state.
const IMPULSE: usize = 7;

fn state(overlap: f64, [[a, b, c], [d, e, f]]: [Vector; 2], impulse: f64) -> State {
    [overlap, a, b, c, d, e, f, impulse]
}

/// The velocity of the first (0) or the second (1).
fn velocity(state: &State, party: usize) -> Vector {
    let [_, a, b, c, d, e, f, _] = *state;
    if party == 0 { [a, b, c] } else { [d, e, f] }
}

impl Touch {
    /// Runs the contact to its end.
    pub(super) fn run(&self, bench: &mut Bench<'_>) -> Result<Parted, NothingToSimulate> {
        let [first, second] = self.parties;
        let rate = |state: &State| dot(less(velocity(state, 0), velocity(state, 1)), self.normal);
        let start = state(0.0, [first.velocity, second.velocity], 0.0);
        if rate(&start) <= 0.0 {
            return Err(NothingToSimulate::NothingChanges);
        }
        bench.by(Way::Contact);
        let lighter = self.parties.iter().filter_map(|party| party.mass).fold(f64::INFINITY, f64::min);
        let stiffness = lighter * bench.shorter * bench.shorter;
        let longest = LONGEST / bench.shorter;
        let slope = |now: &State, force: f64| {
            let push = times(force, self.normal);
            let (one, _) = first.yields(times(-1.0, push));
            let (other, _) = second.yields(push);
            state(rate(now), [one, other], force)
        };
        let pressing = Integrator { tolerance: bench.tolerance, longest };
        let (nearest, most) =
            pressing.event(0.0, start, &|_, state| slope(state, stiffness * state[0]), &|_, state| rate(state))?;
        let e = self.restitution;
        let (_, end) = if e > 0.0 {
            let relaxed = most[0] * (1.0 - e * e);
            let releasing = Integrator { longest: longest * e.min(1.0), ..pressing };
            let back = stiffness / (e * e);
            let force = |state: &State| back * (state[0] - relaxed);
            releasing.event(nearest, most, &|_, state| slope(state, force(state)), &|_, state| state[0] - relaxed)?
        } else {
            (nearest, most)
        };
        let on = [times(-end[IMPULSE], self.normal), times(end[IMPULSE], self.normal)];
        Ok(Parted {
            velocities: [velocity(&end, 0), velocity(&end, 1)],
            impulses: on,
            reactions: [first.yields(on[0]).1, second.yields(on[1]).1],
            common: dot(velocity(&most, 0), self.normal),
            phases: [most[IMPULSE], end[IMPULSE] - most[IMPULSE]],
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::simulate::scene::values::Values;

    fn parted(touch: &Touch) -> Parted {
        let scene: Scene = serde_json::from_str(r#"{ "axes": { "x": "east" }, "bodies": {} }"#).unwrap();
        let values = Values { scene: &scene, value: &|_| None, index: 0 };
        let mut bench = Bench::new(&values, 1e-12);
        touch.run(&mut bench).unwrap()
    }

    /// 3 kg at 3 m/s meets 2 kg at -2 m/s, e = 0.7: by hand v = 1 m/s in common, impulses 6 and 4.2 N s.
    #[test]
    fn a_spring_that_gives_back_less_returns_the_share_e() {
        let parties = [Party::free(3.0, [3.0, 1.0, 0.5]), Party::free(2.0, [-2.0, 0.0, 0.0])];
        let end = parted(&Touch { parties, normal: [1.0, 0.0, 0.0], restitution: 0.7 });
        let found = [end.velocities[0][0], end.velocities[1][0], end.velocities[0][1], end.common];
        for (found, right) in found.into_iter().chain(end.phases).zip([-0.4, 3.1, 1.0, 1.0, 6.0, 4.2]) {
            assert!((found - right).abs() < 1e-10, "{end:?}");
        }
    }

    /// A ball of 1 kg falls at 4 m/s on the face, 45° steep, of a wedge of 2 kg on rails along x: with J the impulse,
    /// J/√2 = 2 V, and no rebound along the face's normal: the wedge has 0.8 m/s, and the floor gave 1.6 N s.
    #[test]
    fn a_guide_carries_what_it_does_not_let_through() {
        let half = core::f64::consts::FRAC_1_SQRT_2;
        let wedge = Party { mass: Some(2.0), velocity: ZERO, guide: Some([1.0, 0.0, 0.0]) };
        let touch = Touch {
            parties: [Party::free(1.0, [0.0, -4.0, 0.0]), wedge],
            normal: [half, -half, 0.0],
            restitution: 0.0,
        };
        let end = parted(&touch);
        assert!((end.velocities[1][0] - 0.8).abs() < 1e-10 && end.velocities[1][1] == 0.0, "{end:?}");
        assert!((end.reactions[1][1] - 1.6).abs() < 1e-10 && end.reactions[1][0].abs() < 1e-12, "{end:?}");
    }
}
