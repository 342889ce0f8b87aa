//! A contact that lasts: a spring that takes up the approach and gives a part of it back.
//!
//! Pressed, the spring has one stiffness; released, a greater one, so that it is relaxed before it has its old length. With
//! the ratio e² of the two it returns the share e of the relative velocity, whatever the masses (Walton and Braun, 1986).

use super::course::Until;
use super::integrate::Integrator;
use super::nothing::NothingToSimulate;
use super::particles::{Force, Particle, velocity};
use super::pushed::Pushed;
use super::stage_run::{Procedure, StageRun};
use super::system::System;
use super::vector::{Vector, dot, less, times};

/// The longest step beside the time of the contact, which is of the order of a second.
const LONGEST: f64 = 0.1;

/// The note that a reader of such a contact needs.
pub const CONTACT_IN_SECONDS: &str = "The duration of the contact is not given: it is drawn as seconds. Each position is measured from where the bodies meet.";

/// Two bodies at the moment in which they meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch<'a> {
    pub parties: [Particle<'a>; 2],
    /// From the first to the second.
    pub normal: Vector,
    pub restitution: f64,
}

/// How they part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parted<'a> {
    pub bodies: [Pushed<'a>; 2],
    /// The velocity of both along the normal when they are nearest.
    pub common: f64,
    /// The magnitude of the impulse until then, and from then on.
    pub phases: [f64; 2],
}

/// Places and velocities of both, and the impulse of the spring.
type State = [f64; 13];

/// The place of the impulse in a state.
const IMPULSE: usize = 12;

impl<'a> Touch<'a> {
    fn closing(&self, state: &State) -> f64 {
        dot(less(velocity(state, 0), velocity(state, 1)), self.normal)
    }

    /// Runs the contact to its end.
    pub(super) fn run(&self, bench: &mut StageRun<'_>) -> Result<Parted<'a>, NothingToSimulate> {
        bench.unwatched(|bench| self.watched(bench))
    }

    /// The same, watched from the approach to the parting.
    pub(super) fn watched(&self, bench: &mut StageRun<'_>) -> Result<Parted<'a>, NothingToSimulate> {
        let mut system = System::new(bench.values.frame(), self.parties.to_vec());
        if self.closing(&system.state()) <= 0.0 {
            return Err(NothingToSimulate::NothingChanges);
        }
        bench.by(Procedure::Contact);
        let lighter = self.parties.iter().filter_map(|party| party.mass).fold(f64::INFINITY, f64::min);
        let stiffness = lighter * bench.shorter * bench.shorter;
        let overlaps = vec![(0, self.normal), (1, times(-1.0, self.normal))];
        let pressed = Force::spring(overlaps.clone(), stiffness, 0.0);
        let integrator = Integrator { tolerance: bench.tolerance, longest: LONGEST / bench.shorter };
        system.forces = vec![pressed];
        let nearest = bench.go(&system, integrator, &Until::Event(&|state| self.closing(state)))?;
        let (e, mut end) = (self.restitution, nearest);
        if e > 0.0 {
            let most = system.forces[0].deformation(&nearest.state).unwrap_or(0.0);
            system.go_on_from(&nearest);
            system.lost = stiffness * most * most * (1.0 - e * e) / 2.0;
            system.forces = vec![Force::spring(overlaps, stiffness / (e * e), -most * (1.0 - e * e))];
            let integrator = Integrator { longest: integrator.longest * e.min(1.0), ..integrator };
            let left = |state: &State| system.forces[0].deformation(state).unwrap_or(0.0);
            end = bench.go(&system, integrator, &Until::Event(&left))?;
        }
        bench.remark(CONTACT_IN_SECONDS);
        let pressing = -nearest.state[IMPULSE];
        let releasing = if e > 0.0 { -end.state[IMPULSE] } else { 0.0 };
        let impulse = times(pressing + releasing, self.normal);
        let [first, second] =
            [0, 1].map(|side| Pushed { after: velocity(&end.state, side), ..Pushed::new(self.parties[side]) });
        Ok(Parted {
            bodies: [Pushed { impulse: times(-1.0, impulse), ..first }, Pushed { impulse, ..second }],
            common: dot(velocity(&nearest.state, 0), self.normal),
            phases: [pressing, releasing],
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::scene::values::Values;
    use crate::scene::vector::ZERO;
    use momentous_scene::Scene;

    fn parted<'a>(touch: &Touch<'a>) -> Parted<'a> {
        let scene: Scene = serde_json::from_str(r#"{ "axes": { "x": "east" }, "bodies": {} }"#).unwrap();
        let values = Values { scene: &scene, value: &|_| None, index: 0 };
        let mut bench = StageRun::new(&values, 1e-12);
        touch.run(&mut bench).unwrap()
    }

    /// 3 kg at 3 m/s meets 2 kg at -2 m/s, e = 0.7: by hand v = 1 m/s in common, impulses 6 and 4.2 N s.
    #[test]
    fn a_spring_that_gives_back_less_returns_the_share_e() {
        let parties = [Particle::free("A", 3.0, [3.0, 1.0, 0.5]), Particle::free("B", 2.0, [-2.0, 0.0, 0.0])];
        let end = parted(&Touch { parties, normal: [1.0, 0.0, 0.0], restitution: 0.7 });
        let found = [end.bodies[0].after[0], end.bodies[1].after[0], end.bodies[0].after[1], end.common];
        for (found, right) in found.into_iter().chain(end.phases).zip([-0.4, 3.1, 1.0, 1.0, 6.0, 4.2]) {
            assert!((found - right).abs() < 1e-10, "{end:?}");
        }
    }

    /// A ball of 1 kg falls at 4 m/s on the face, 45° steep, of a wedge of 2 kg on rails along x: with J the impulse,
    /// J/√2 = 2 V, and no rebound along the face's normal: the wedge has 0.8 m/s, and the floor gave 1.6 N s.
    #[test]
    fn a_guide_carries_what_it_does_not_let_through() {
        let half = core::f64::consts::FRAC_1_SQRT_2;
        let wedge = Particle { guide: Some([1.0, 0.0, 0.0]), ..Particle::free("B", 2.0, ZERO) };
        let touch = Touch {
            parties: [Particle::free("A", 1.0, [0.0, -4.0, 0.0]), wedge],
            normal: [half, -half, 0.0],
            restitution: 0.0,
        };
        let end = parted(&touch);
        assert!((end.bodies[1].after[0] - 0.8).abs() < 1e-10 && end.bodies[1].after[1] == 0.0, "{end:?}");
        let carried = wedge.yields(end.bodies[1].impulse).1;
        assert!((carried[1] - 1.6).abs() < 1e-10 && carried[0].abs() < 1e-12, "{end:?}");
    }
}
