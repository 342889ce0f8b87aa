//! A body that slides from rest down another, which gives way along its guide: both held together by the force between them.

use momentous_scene::stage::SlideOff;

use crate::scene::course::Until;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Constraint, Particle, Surface, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{ZERO, across, dot, less, size, times};

impl StageRun<'_> {
    pub(super) fn slide_off(&mut self, stage: &SlideOff) -> Result<(), NothingToSimulate> {
        let weight = self.values.falling()?;
        let gravity = size(weight);
        let height = self.values.term(&stage.height)?;
        let down = times(1.0 / gravity, weight);
        let end = self.values.direction(&stage.direction.0)?;
        let (names, mut particles) = ([&stage.body, &stage.on], Vec::new());
        for name in names {
            particles.push(Particle { falls: weight, ..Particle::free(name, self.values.mass(name)?, ZERO) });
        }
        particles[1].guide = self.values.guide(&stage.on).transpose()?;
        let mut system = System::<12>::new(self.values.frame(), particles);
        // A face that ends level has to start steep: a quarter of a circle. Any other is straight.
        let is_straight = dot(end, down) > f64::EPSILON;
        system.constraint = Some(if is_straight {
            Constraint::Length(vec![(0, across(end)), (1, times(-1.0, across(end)))])
        } else {
            let centre = times(height, end);
            Constraint::Surface(Surface { carrier: Some(1), ..Surface::circle(centre) })
        });
        // What is left to sink; where the face ends level, what is left of the way across.
        let left = |state: &[f64; 12]| {
            let gone = if is_straight { place(state, 0) } else { less(place(state, 0), place(state, 1)) };
            height - dot(gone, if is_straight { down } else { end })
        };
        let integrator = self.integrator(0.1 * libm::sqrt(height / gravity));
        let end = self.go(&system, integrator, &Until::Event(&left))?;
        self.remark("Each position is measured from the starting point of its body.");
        let scale = libm::sqrt(gravity * height);
        for (side, name) in names.into_iter().enumerate() {
            self.note_velocity(name, velocity(&end.state, side), scale);
            for axis in self.values.axes() {
                self.note(&self.values.start_name(name, axis), 0.0, 0.0);
            }
        }
        self.note_duration(None, end.time);
        Ok(())
    }
}
