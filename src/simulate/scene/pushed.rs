//! Effects of a short push on bodies.

use momentous_scene::Term;

use super::particles::Particle;
use super::stage_run::StageRun;
use super::vector::{Vector, ZERO, across, dot, size};

/// A body that was pushed for a short time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pushed<'a> {
    /// The body as it was before.
    pub body: Particle<'a>,
    /// Its velocity afterwards.
    pub after: Vector,
    /// The impulse on it, without that of its guide.
    pub impulse: Vector,
}

impl<'a> Pushed<'a> {
    /// A body that has not been pushed yet.
    pub(super) fn new(body: Particle<'a>) -> Self {
        Self { body, after: body.velocity, impulse: ZERO }
    }
}

impl StageRun<'_> {
    /// Notes the velocities afterwards.
    pub(super) fn note_velocities(&mut self, pushed: &[Pushed<'_>]) {
        let scale = pushed.iter().map(|pushed| size(pushed.body.velocity).max(size(pushed.after))).fold(0.0, f64::max);
        for each in pushed {
            self.note_velocity(each.body.name, each.after, scale);
        }
    }

    /// Notes the impulses, those of guides too, and the energy that was lost or gained.
    pub(super) fn note_pushed(&mut self, pushed: &[Pushed<'_>], duration: Option<&Term>) {
        for Pushed { body, impulse, .. } in pushed {
            self.note_impulse(body.name, *impulse, duration);
            if let Some(along) = body.guide {
                self.note_here(&format!("R_{}", body.name), dot(across(along), body.yields(*impulse).1), 0.0);
            }
        }
        let moving = |velocity_of: fn(&Pushed<'_>) -> Vector| -> Vec<(f64, Vector)> {
            pushed.iter().filter_map(|pushed| Some((pushed.body.mass?, velocity_of(pushed)))).collect()
        };
        self.note_energy(&moving(|pushed| pushed.body.velocity), &moving(|pushed| pushed.after));
    }
}
