//! A scene and its run as somebody sees them who moves along: bodies that are much faster than they approach each other are run
//! where they are slow, because their places have digits for the gap between them only there.

use super::state::Vector;
use super::trajectory::{Impact, Motion, Segment, Trajectory};
use super::world::World;

impl<const D: usize> World<D> {
    /// The scene from a frame that moves with `velocity` and that agrees with this one about places at the time `agreed`. No force
    /// may act that depends on where a body is, or how fast.
    pub(super) fn seen_from(&self, velocity: Vector<D>, agreed: f64) -> Self {
        let mut world = self.clone();
        for body in &mut world.bodies {
            body.position += velocity * agreed;
            body.velocity -= velocity;
        }
        for wall in &mut world.walls {
            let along = wall.normal.dot(&velocity);
            wall.offset += along * agreed;
            wall.velocity -= along;
        }
        world
    }
}

impl<const D: usize> Trajectory<D> {
    /// The run of a world from such a frame; none of one with an orbit, which is bound to its centre.
    pub(super) fn seen_from(&self, world: &World<D>, velocity: Vector<D>, agreed: f64) -> Option<Self> {
        let shift = |time: f64| velocity * (agreed - time);
        let path = |path: &Vec<Segment<D>>| {
            let segment = |segment: &Segment<D>| {
                let motion = segment.motion.seen_from(velocity, shift(segment.start))?;
                Some(Segment { motion, ..segment.clone() })
            };
            path.iter().map(segment).collect::<Option<Vec<_>>>()
        };
        let mut run = self.clone();
        run.paths = self.paths.iter().map(path).collect::<Option<_>>()?;
        for state in run.states.iter_mut().chain([&mut run.last]) {
            let shift = shift(state.time);
            state.positions.iter_mut().for_each(|position| *position += shift);
            state.velocities.iter_mut().for_each(|relative| *relative -= velocity);
        }
        run.impacts = self.impacts.iter().map(|impact| self.impact_seen_from(world, impact, velocity)).collect();
        Some(run)
    }

    fn impact_seen_from(&self, world: &World<D>, impact: &Impact<D>, velocity: Vector<D>) -> Impact<D> {
        let (first, second) = world.parties(impact.contact);
        let kinetic = |body: usize| {
            let before =
                self.at(body, impact.time).map_or(self.last.velocities[body], |(_, velocity)| velocity) - velocity;
            world.bodies[body].mass * before.norm_squared() / 2.0
        };
        // What comes from outside does other work on bodies that move otherwise.
        let given = if first.is_none() { velocity.dot(&impact.impulse) } else { 0.0 };
        Impact {
            energy_before: kinetic(second) + first.map_or(0.0, kinetic),
            energy_lost: impact.energy_lost + given,
            ..*impact
        }
    }
}

impl<const D: usize> Motion<D> {
    fn seen_from(&self, frame: Vector<D>, shift: Vector<D>) -> Option<Self> {
        match self {
            Self::Uniform { position, velocity, acceleration } => Some(Self::Uniform {
                position: position + shift,
                velocity: velocity - frame,
                acceleration: *acceleration,
            }),
            Self::Polynomial(coefficients) => {
                let mut coefficients = coefficients.clone();
                coefficients.resize(coefficients.len().max(2), Vector::zeros());
                coefficients[0] += shift;
                coefficients[1] -= frame;
                Some(Self::Polynomial(coefficients))
            }
            Self::Orbit(_) => None,
        }
    }
}
