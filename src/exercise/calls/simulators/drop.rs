//! A ball that is dropped on a level floor, in a vacuum or in air.

use momentous_simulate::{Body, Force, Vector, Wall, World};

/// The acceleration of free fall in m/s², as problems have it.
pub(super) const GRAVITY: f64 = 9.81;

/// The tolerance of what is shown in air, and that of the run that it is compared with.
pub(super) const TOLERANCES: [f64; 2] = [1e-9, 1e-12];

/// The longest run in air, in s of the scene.
pub(super) const LONGEST: f64 = 300.0;

/// A ball that is dropped.
pub(super) struct Drop {
    pub(super) height: f64,
    pub(super) restitution: f64,
    /// The terminal speed in air; 0 in a vacuum.
    pub(super) terminal: f64,
}

impl Drop {
    /// A particle of 1 kg above a level floor: its mass decides nothing that is shown.
    pub(super) fn world(&self) -> World<1> {
        let mut world = World::new(self.restitution);
        world.gravity = Vector::from([-GRAVITY]);
        world.bodies.push(Body::particle("ball", 1.0, [self.height], [0.0]));
        world.walls.push(Wall::new("floor", [1.0], 0.0));
        if self.terminal > 0.0 {
            world.forces.push(Force::Drag { body: 0, coefficient: GRAVITY / (self.terminal * self.terminal) });
        }
        world
    }
}
