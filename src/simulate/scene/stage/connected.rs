//! Two bodies on a string over a pulley, each along the string, towards the leading body.

use momentous_scene::Axis;
use momentous_scene::stage::{Connected, Strand};

use crate::scene::component::Frame;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Constraint, Force, Particle, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{dot, times, unit};

impl StageRun<'_> {
    pub(super) fn connected(&mut self, stage: &Connected) -> Result<(), NothingToSimulate> {
        let axis = self.values.axes().first().copied().ok_or(NothingToSimulate::Unread)?;
        let strands = [&stage.trailing, &stage.leading];
        // How fast the string runs.
        let running =
            |strand: &Strand| Ok(f64::from(strand.strands()) * self.values.velocity_before(&strand.body, axis)?);
        let speed = running(strands[0]).or_else(|_| running(strands[1]))?;
        let (ahead, gravity) = (unit(Axis::X), self.values.named("g")?);
        let mut system = System::<12>::new(Frame::line("s"), Vec::new());
        let (mut held, mut scale) = (Vec::new(), 0.0);
        // Weight draws the leading body on, and the trailing one back.
        for (side, (strand, sense)) in strands.into_iter().zip([-1.0, 1.0]).enumerate() {
            let mass = self.values.mass(&strand.body)?;
            let (steep, pressed) = self.inclination(strand)?;
            let friction = self.values.or_zero(strand.friction.as_ref())? * mass * gravity * pressed;
            let (count, falls) = (f64::from(strand.strands()), times(sense * gravity * steep, ahead));
            let moves = times(speed / count, ahead);
            system.particles.push(Particle { falls, ..Particle::free(&strand.body, mass, moves) });
            system.forces.push(Force::steady(side, times(-friction, ahead)));
            held.push((side, times(-sense * count, ahead)));
            scale += mass * gravity * steep.abs() + friction;
        }
        system.constraint = Some(Constraint::Length(held));
        let distance = self.values.known(stage.distance.as_ref());
        let finish = self.values.finish(stage.until.is_some(), distance, stage.duration.as_ref())?;
        let end = self.go_along(&system, (1, ahead), finish)?;
        self.remark("s is measured along the string, towards the leading body, for both bodies.");
        for (side, strand) in strands.into_iter().enumerate() {
            let velocity = dot(velocity(&end.state, side), ahead);
            self.note_velocity(&strand.body, times(velocity, unit(axis)), speed);
            self.note_place(&strand.body, times(dot(place(&end.state, side), ahead), unit(axis)));
        }
        self.note_here("tension", system.tension(end.time, &end.state), scale);
        self.note_term(stage.distance.as_ref(), dot(place(&end.state, 1), ahead), 0.0);
        self.note_duration(stage.duration.as_ref(), end.time);
        Ok(())
    }

    /// The shares of weight along the string and onto what carries the body.
    fn inclination(&self, strand: &Strand) -> Result<(f64, f64), NothingToSimulate> {
        match strand.on.as_ref().map(|term| term.0.trim()) {
            None | Some("hanging") => Ok((1.0, 0.0)),
            Some("level") => Ok((0.0, 1.0)),
            Some(angle) => {
                let angle = self.values.number(angle)?;
                Ok((libm::sin(angle), libm::cos(angle)))
            }
        }
    }
}
