//! A well-known game engine, Rapier in doubles, as a peer in the charts. It gets the scene as its users would give it: discs and
//! half-planes without friction, its own defaults for everything else, and the step as it is given.

use std::collections::BTreeMap;

use rapier2d_f64::prelude::{
    CoefficientCombineRule, ColliderBuilder, ColliderHandle, PhysicsWorld, RigidBodyBuilder, RigidBodyHandle,
    SharedShape, Vector as Pair,
};

use crate::budget::Budget;
use crate::contact::Contact;
use crate::method::Method;
use crate::refusal::Refusal;
use crate::state::{State, Vector};
use crate::trajectory::{Impact, Trajectory};
use crate::world::World;

use super::marching::{Step, march};

/// The engine with its step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rapier {
    /// The step in s.
    pub step: f64,
}

/// The radius, in m, of the discs that stand for particles, which the engine does not have.
const PARTICLE: f64 = 0.05;

impl<const D: usize> Method<D> for Rapier {
    fn name(&self) -> &'static str {
        "Rapier"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        world.check()?;
        march(world, budget, self.step, &mut Engine::of(world)?)
    }
}

/// The engine with the scene in it.
struct Engine<const D: usize> {
    inner: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    /// How much further along the first axis a body stands in the engine: particles are moved apart by their discs.
    shifts: Vec<f64>,
    colliders: BTreeMap<(u32, u32), Place>,
    accelerations: Vec<Vector<D>>,
    /// The contacts that pushed in the step before.
    pushing: Vec<Contact>,
}

/// The body or surface behind a collider of the engine.
#[derive(Clone, Copy)]
enum Place {
    Body(usize),
    Wall(usize),
}

fn refused(what: &str) -> Refusal {
    Refusal::Invalid { what: format!("Rapier is not used here for {what}") }
}

fn pair<const D: usize>(vector: &Vector<D>) -> Pair {
    let part = |place: usize| vector.iter().nth(place).copied().unwrap_or(0.0);
    Pair::new(part(0), part(1))
}

fn vector<const D: usize>(pair: Pair) -> Vector<D> {
    Vector::from_iterator([pair.x, pair.y].into_iter().chain(std::iter::repeat(0.0)).take(D))
}

impl<const D: usize> Engine<D> {
    fn of(world: &World<D>) -> Result<Self, Refusal> {
        if D > 2 || !world.cords.is_empty() || !world.restitutions.is_empty() {
            return Err(refused("space, cords or several coefficients of restitution"));
        }
        if world.walls.iter().any(|wall| wall.velocity != 0.0 || wall.thickness.is_some()) {
            return Err(refused("walls that move or have a far side"));
        }
        let particles = world.bodies.iter().filter(|body| body.radius == 0.0).count();
        if particles > 0 && (particles < world.bodies.len() || D > 1 && particles > 1) {
            return Err(refused("particles together with other bodies"));
        }
        let mut inner = PhysicsWorld { gravity: Pair::ZERO, ..PhysicsWorld::default() };
        let surface = |builder: ColliderBuilder| {
            let rule = CoefficientCombineRule::Max;
            builder.friction(0.0).restitution(world.restitution).restitution_combine_rule(rule)
        };
        let mut engine = Self {
            bodies: Vec::new(),
            shifts: vec![0.0; world.bodies.len()],
            colliders: BTreeMap::new(),
            accelerations: Vec::new(),
            pushing: Vec::new(),
            inner: PhysicsWorld::default(),
        };
        let disc = if particles > 0 { PARTICLE } else { 0.0 };
        let mut room = 0.0;
        for place in world.order() {
            engine.shifts[place] = room;
            room += 2.0 * disc;
        }
        for (place, body) in world.bodies.iter().enumerate() {
            let start = pair(&body.position) + Pair::new(engine.shifts[place], 0.0);
            let rigid = RigidBodyBuilder::dynamic().translation(start).linvel(pair(&body.velocity));
            let shape = ColliderBuilder::ball(body.radius + disc).mass(body.mass);
            let (handle, collider) = inner.insert(rigid.lock_rotations().can_sleep(false), surface(shape));
            engine.bodies.push(handle);
            engine.name(collider, Place::Body(place));
        }
        for (place, wall) in world.walls.iter().enumerate() {
            let normal = pair(&wall.normal);
            // A wall at the right stands behind all discs, one at the left before them.
            let behind = if D == 1 && normal.x < 0.0 { (room - 2.0 * disc).max(0.0) } else { 0.0 };
            let face = normal * (wall.offset - disc) + Pair::new(behind, 0.0);
            let shape = ColliderBuilder::new(SharedShape::halfspace(normal));
            let (_, collider) = inner.insert(RigidBodyBuilder::fixed().translation(face), surface(shape));
            engine.name(collider, Place::Wall(place));
        }
        engine.inner = inner;
        Ok(engine)
    }

    fn name(&mut self, collider: ColliderHandle, place: Place) {
        self.colliders.insert(collider.into_raw_parts(), place);
    }

    /// The contacts that pushed in the last step, each with the impulse on its second party.
    fn pushes(&self) -> Vec<(Contact, Pair)> {
        let mut all = Vec::new();
        for pair in self.inner.narrow_phase.contact_pairs() {
            if pair.total_impulse_magnitude() <= 0.0 {
                continue;
            }
            let place = |collider: ColliderHandle| self.colliders.get(&collider.into_raw_parts()).copied();
            // The engine's impulse acts on the second collider.
            let impulse = pair.total_impulse();
            all.extend(match (place(pair.collider1), place(pair.collider2)) {
                (Some(Place::Body(first)), Some(Place::Body(second))) if first < second => {
                    Some((Contact::Bodies(first, second), impulse))
                }
                (Some(Place::Body(first)), Some(Place::Body(second))) => {
                    Some((Contact::Bodies(second, first), -impulse))
                }
                (Some(Place::Wall(wall)), Some(Place::Body(body))) => Some((Contact::Wall { wall, body }, impulse)),
                (Some(Place::Body(body)), Some(Place::Wall(wall))) => Some((Contact::Wall { wall, body }, -impulse)),
                _ => None,
            });
        }
        all
    }
}

impl<const D: usize> Step<D> for Engine<D> {
    fn advance(&mut self, world: &World<D>, state: &mut State<D>, step: f64) -> Result<Vec<Impact<D>>, Refusal> {
        world.accelerate(state, &mut self.accelerations);
        for ((handle, acceleration), body) in self.bodies.iter().zip(&self.accelerations).zip(&world.bodies) {
            if let Some(rigid) = self.inner.bodies.get_mut(*handle) {
                rigid.reset_forces(true);
                rigid.add_force(pair(&(acceleration * body.mass)), true);
            }
        }
        self.inner.integration_parameters.dt = step;
        let before = state.velocities.clone();
        self.inner.step();
        for (place, handle) in self.bodies.iter().enumerate() {
            if let Some(rigid) = self.inner.bodies.get(*handle) {
                state.positions[place] = vector(rigid.translation() - Pair::new(self.shifts[place], 0.0));
                state.velocities[place] = vector(rigid.linvel());
            }
        }
        let pushes = self.pushes();
        let mut impacts = Vec::new();
        for (contact, impulse) in pushes.iter().filter(|(contact, _)| !self.pushing.contains(contact)) {
            let (first, second) = world.parties(*contact);
            let energy = |velocities: &[Vector<D>]| {
                let energy = |body: usize| world.bodies[body].mass * velocities[body].norm_squared() / 2.0;
                energy(second) + first.map_or(0.0, energy)
            };
            let (energy_before, after) = (energy(&before), energy(&state.velocities));
            let (contact, impulse) = (*contact, vector(*impulse));
            impacts.push(Impact { time: 0.0, contact, impulse, energy_before, energy_lost: energy_before - after });
        }
        self.pushing = pushes.into_iter().map(|(contact, _)| contact).collect();
        Ok(impacts)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;
    use crate::world::{Body, Wall};

    /// The peer is used rightly: what it finds comes near the truth as its step goes down.
    #[test]
    fn it_treats_a_bounce_and_an_impact() {
        let mut dropped = World::<1>::new(0.75);
        dropped.gravity = Vector::from([-9.81]);
        dropped.bodies.push(Body::particle("ball", 1.0, [4.0], [0.0]));
        dropped.walls.push(Wall::new("floor", [1.0], 0.0));
        let run = Rapier { step: 1e-4 }.run(&dropped, &Budget::until(10.0).at_most(1)).unwrap();
        let expected = (8.0_f64 / 9.81).sqrt();
        assert!((run.impacts[0].time - expected).abs() < 1e-2, "{:?}", run.impacts);
        assert!((run.last.velocities[0].x / (9.81 * expected) - 0.75).abs() < 1e-2, "{:?}", run.last);

        let mut meeting = World::<1>::new(0.7);
        meeting.bodies.push(Body::particle("A", 3.0, [0.0], [3.0]));
        meeting.bodies.push(Body::particle("B", 2.0, [1.0], [-2.0]));
        let run = Rapier { step: 1e-4 }.run(&meeting, &Budget::until(1.0)).unwrap();
        assert_eq!(run.impact_count, 1);
        assert!((run.last.velocities[0].x - -0.4).abs() < 1e-2, "{:?}", run.last);
        let oblique = &(crate::task::IN_THE_PLANE[0].jittered)(0.0);
        let run = Rapier { step: 1e-4 }.run(&oblique.world, &oblique.budget).unwrap();
        assert!((run.last.velocities[1].norm() - 2.16).abs() < 0.02, "{:?}", run.last);
    }
}
