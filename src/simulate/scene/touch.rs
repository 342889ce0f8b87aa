//! A contact that lasts: a spring that takes up the approach and gives a part of it back.
//!
//! Pressed, the spring has one stiffness; released, a greater one, so that it is relaxed before it has its old length. With
//! the ratio e² of the two it returns the share e of the relative velocity, whatever the masses (Walton and Braun, 1986).

use super::bench::{Bench, Way};
use super::integrate::Integrator;
use super::nothing::NothingToSimulate;
use super::reel::{Look, Motion, Seen};
use super::vector::{Vector, ZERO, add, dot, less, times, within};

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

/// The spring of a contact while it is pressed, or while it is released.
#[derive(Clone, Copy, Debug)]
struct Phase {
    stiffness: f64,
    /// The overlap at which it does not push.
    relaxed: f64,
    /// When it is over.
    end: f64,
    /// The energy that is lost before it begins.
    lost: f64,
}

impl Phase {
    fn force(&self, overlap: f64) -> f64 {
        self.stiffness * (overlap - self.relaxed)
    }
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

/// Where both places follow, where the contact is watched; and how long such a state is.
const PLACES: usize = 8;
const FILMED: usize = 14;

fn state(overlap: f64, [[a, b, c], [d, e, f]]: [Vector; 2], impulse: f64) -> State {
    [overlap, a, b, c, d, e, f, impulse]
}

/// The velocity of the first (0) or the second (1).
fn velocity(state: &State, party: usize) -> Vector {
    within(state, 1 + 3 * party)
}

impl Touch {
    fn rate(&self, state: &State) -> f64 {
        dot(less(velocity(state, 0), velocity(state, 1)), self.normal)
    }

    fn slope(&self, now: &State, force: f64) -> State {
        let push = times(force, self.normal);
        let (one, _) = self.parties[0].yields(times(-1.0, push));
        let (other, _) = self.parties[1].yields(push);
        state(self.rate(now), [one, other], force)
    }

    /// The pressing and, where the bodies do not stay together, the releasing; the states at the end of each.
    fn phases(&self, bench: &mut Bench<'_>) -> Result<(Vec<Phase>, State, State), NothingToSimulate> {
        let [first, second] = self.parties;
        let start = state(0.0, [first.velocity, second.velocity], 0.0);
        if self.rate(&start) <= 0.0 {
            return Err(NothingToSimulate::NothingChanges);
        }
        bench.by(Way::Contact);
        let lighter = self.parties.iter().filter_map(|party| party.mass).fold(f64::INFINITY, f64::min);
        let stiffness = lighter * bench.shorter * bench.shorter;
        let longest = LONGEST / bench.shorter;
        let mut phase = Phase { stiffness, relaxed: 0.0, end: 0.0, lost: 0.0 };
        let integrator = Integrator { tolerance: bench.tolerance, longest };
        let slope = |_: f64, state: &State| self.slope(state, phase.force(state[0]));
        let (nearest, most) = integrator.event(0.0, start, &slope, &|_, state| self.rate(state))?;
        phase.end = nearest;
        let e = self.restitution;
        if e == 0.0 {
            return Ok((vec![phase], most, most));
        }
        let lost = stiffness * most[0] * most[0] * (1.0 - e * e) / 2.0;
        let mut release = Phase { stiffness: stiffness / (e * e), relaxed: most[0] * (1.0 - e * e), end: 0.0, lost };
        let integrator = Integrator { longest: longest * e.min(1.0), ..integrator };
        let slope = |_: f64, state: &State| self.slope(state, release.force(state[0]));
        let (apart, end) = integrator.event(nearest, most, &slope, &|_, state| state[0] - release.relaxed)?;
        release.end = apart;
        Ok((vec![phase, release], most, end))
    }

    /// The same contact as it is seen, from the approach to the parting.
    pub(super) fn film(&self, bench: &mut Bench<'_>, names: [&str; 2]) -> Result<(), NothingToSimulate> {
        let values = bench.values;
        let movable: Vec<usize> = (0..2).filter(|own| self.parties[*own].mass.is_some()).collect();
        let names: Vec<&str> = movable.iter().map(|own| names[*own]).collect();
        let mut all = [0.0; FILMED];
        all[..PLACES].copy_from_slice(&state(0.0, self.parties.map(|party| party.velocity), 0.0));
        let mut begun = 0.0;
        for phase in self.phases(bench)?.0 {
            let slope = |_: f64, all: &[f64; FILMED]| {
                let inner = self.slope(&core::array::from_fn(|part| all[part]), phase.force(all[0]));
                let mut changes = [0.0; FILMED];
                changes[..PLACES].copy_from_slice(&inner);
                changes[PLACES..].copy_from_slice(&all[1..IMPULSE]);
                changes
            };
            let look = |_: f64, all: &[f64; FILMED]| {
                let force = phase.force(all[0]);
                let push = times(force, self.normal);
                let on = [times(-1.0, push), push];
                // A guide, or what is too heavy to be moved, acts from outside.
                let outside = [0, 1].map(|own| match self.parties[own].mass {
                    Some(_) => self.parties[own].yields(on[own]).1,
                    None => on[1 - own],
                });
                let moving = movable.iter().map(|own| Seen {
                    mass: self.parties[*own].mass.unwrap_or(0.0),
                    place: values.frame().split(within(all, PLACES + 3 * own)),
                    velocity: values.frame().split(within(all, 1 + 3 * own)),
                });
                Look {
                    bodies: moving.collect(),
                    outside: values.frame().split(add(outside[0], outside[1])),
                    potential: force * (all[0] - phase.relaxed) / 2.0,
                    lost: phase.lost,
                    ..Look::default()
                }
            };
            let components = values.frame().components;
            let motion =
                Motion { names: &names, components, start: (begun, all), end: phase.end, slope: &slope, look: &look };
            bench.film(&motion)?;
            let integrator = Integrator { tolerance: bench.tolerance, longest: LONGEST / bench.shorter };
            all = integrator.until(begun, all, phase.end, &slope)?;
            begun = phase.end;
        }
        bench.remark("The duration of the contact is not given: it is drawn as seconds. Each position is measured from where the bodies meet.");
        Ok(())
    }

    /// Runs the contact to its end.
    pub(super) fn run(&self, bench: &mut Bench<'_>) -> Result<Parted, NothingToSimulate> {
        let [first, second] = self.parties;
        let (_, most, end) = self.phases(bench)?;
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
