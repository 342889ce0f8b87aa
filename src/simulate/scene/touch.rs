//! A contact that lasts: a spring that takes up the approach and gives a part of it back.
//!
//! Pressed, the spring has one stiffness; released, a greater one, so that it is relaxed before it has its old length. With
//! the ratio e² of the two it returns the share e of the relative velocity, whatever the masses (Walton and Braun, 1986).

use super::bench::{Bench, Way};
use super::integrate::Integrator;
use super::nothing::NothingToSimulate;
use super::reel::{Look, Motion, Seen};

/// The longest step beside the time of the contact, which is of the order of a second.
const LONGEST: f64 = 0.1;

/// One of two that touch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Party {
    /// Its mass; none where it is too heavy to be moved.
    pub mass: Option<f64>,
    pub velocity: [f64; 2],
    /// The one direction in which a guide lets it move.
    pub guide: Option<[f64; 2]>,
}

/// Two bodies at the moment in which they meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    pub parties: [Party; 2],
    /// From the first to the second.
    pub normal: [f64; 2],
    pub restitution: f64,
}

/// How they part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parted {
    pub velocities: [[f64; 2]; 2],
    /// The impulse of the contact on each.
    pub impulses: [[f64; 2]; 2],
    /// The impulse of the guide of each.
    pub reactions: [[f64; 2]; 2],
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
    pub(super) fn free(mass: f64, velocity: [f64; 2]) -> Self {
        Self { mass: Some(mass), velocity, guide: None }
    }

    /// What a force does to it: the acceleration, and what its guide adds to the force.
    pub(super) fn yields(&self, force: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let Some(mass) = self.mass else { return ([0.0; 2], [0.0; 2]) };
        let felt = match self.guide {
            Some(along) => along.map(|own| own * dot(along, force)),
            None => force,
        };
        (felt.map(|own| own / mass), [felt[0] - force[0], felt[1] - force[1]])
    }
}

pub(super) fn dot(one: [f64; 2], other: [f64; 2]) -> f64 {
    one[0] * other[0] + one[1] * other[1]
}

/// Overlap, both velocities, and the magnitude of the impulse.
type State = [f64; 6];

impl Touch {
    fn rate(&self, state: &State) -> f64 {
        dot([state[1] - state[3], state[2] - state[4]], self.normal)
    }

    fn slope(&self, state: &State, force: f64) -> State {
        let push = self.normal.map(|own| own * force);
        let (one, _) = self.parties[0].yields(push.map(|own| -own));
        let (other, _) = self.parties[1].yields(push);
        [self.rate(state), one[0], one[1], other[0], other[1], force]
    }

    /// The pressing and, where the bodies do not stay together, the releasing; the states at the end of each.
    fn phases(&self, bench: &mut Bench<'_>) -> Result<(Vec<Phase>, State, State), NothingToSimulate> {
        let [first, second] = self.parties;
        let start = [0.0, first.velocity[0], first.velocity[1], second.velocity[0], second.velocity[1], 0.0];
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
        let mut state = [0.0; 10];
        for (own, party) in self.parties.iter().enumerate() {
            state[1 + 2 * own..3 + 2 * own].copy_from_slice(&party.velocity);
        }
        let mut begun = 0.0;
        for phase in self.phases(bench)?.0 {
            let slope = |_: f64, state: &[f64; 10]| {
                let inner = self.slope(&core::array::from_fn(|place| state[place]), phase.force(state[0]));
                let mut all = [0.0; 10];
                all[..6].copy_from_slice(&inner);
                all[6..].copy_from_slice(&state[1..5]);
                all
            };
            let look = |_: f64, state: &[f64; 10]| {
                let force = phase.force(state[0]);
                let push = self.normal.map(|own| own * force);
                let on = [push.map(|own| -own), push];
                // A guide, or what is too heavy to be moved, acts from outside.
                let outside = [0, 1].map(|own| match self.parties[own].mass {
                    Some(_) => self.parties[own].yields(on[own]).1,
                    None => on[1 - own],
                });
                let moving = movable.iter().map(|own| Seen {
                    mass: self.parties[*own].mass.unwrap_or(0.0),
                    place: values.split([state[6 + 2 * own], state[7 + 2 * own]]),
                    velocity: values.split([state[1 + 2 * own], state[2 + 2 * own]]),
                });
                Look {
                    bodies: moving.collect(),
                    outside: values.split([outside[0][0] + outside[1][0], outside[0][1] + outside[1][1]]),
                    potential: force * (state[0] - phase.relaxed) / 2.0,
                    lost: phase.lost,
                    ..Look::default()
                }
            };
            let components = values.components();
            let motion =
                Motion { names: &names, components, start: (begun, state), end: phase.end, slope: &slope, look: &look };
            bench.film(&motion)?;
            let integrator = Integrator { tolerance: bench.tolerance, longest: LONGEST / bench.shorter };
            state = integrator.until(begun, state, phase.end, &slope)?;
            begun = phase.end;
        }
        bench.remark("How long the contact lasts is not told: it is drawn as seconds. Each place counts from where the bodies meet.");
        Ok(())
    }

    /// Runs the contact to its end.
    pub(super) fn run(&self, bench: &mut Bench<'_>) -> Result<Parted, NothingToSimulate> {
        let [first, second] = self.parties;
        let (_, most, end) = self.phases(bench)?;
        let on = [self.normal.map(|own| -own * end[5]), self.normal.map(|own| own * end[5])];
        Ok(Parted {
            velocities: [[end[1], end[2]], [end[3], end[4]]],
            impulses: on,
            reactions: [first.yields(on[0]).1, second.yields(on[1]).1],
            common: dot([most[1], most[2]], self.normal),
            phases: [most[5], end[5] - most[5]],
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
        let parties = [Party::free(3.0, [3.0, 1.0]), Party::free(2.0, [-2.0, 0.0])];
        let end = parted(&Touch { parties, normal: [1.0, 0.0], restitution: 0.7 });
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
        let wedge = Party { mass: Some(2.0), velocity: [0.0; 2], guide: Some([1.0, 0.0]) };
        let touch = Touch { parties: [Party::free(1.0, [0.0, -4.0]), wedge], normal: [half, -half], restitution: 0.0 };
        let end = parted(&touch);
        assert!((end.velocities[1][0] - 0.8).abs() < 1e-10 && end.velocities[1][1] == 0.0, "{end:?}");
        assert!((end.reactions[1][1] - 1.6).abs() < 1e-10 && end.reactions[1][0].abs() < 1e-12, "{end:?}");
    }
}
