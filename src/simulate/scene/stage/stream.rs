//! A steady stream as droplets, one after another: how many arrive in a time, and what each gives the body.

use momentous_scene::Axis;
use momentous_scene::stage::Stream;

use crate::scene::component::Frame;
use crate::scene::course::Until;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Constraint, Particle, Surface, velocity};
use crate::scene::stage_run::{Procedure, StageRun};
use crate::scene::system::System;
use crate::scene::touch::Touch;
use crate::scene::vector::{Vector, ZERO, across, dot, less, part, size, times, unit};

/// The number of droplets that are counted.
const DROPLETS: u32 = 1_000;

/// The name of the droplet by which a stream is watched.
const DROPLET: &str = "droplet";
const SEEN: &str = "One droplet of 1 kg is shown, relative to the body that it meets; the duration is not given.";

impl StageRun<'_> {
    pub(super) fn stream(&mut self, stage: &Stream) -> Result<(), NothingToSimulate> {
        self.by(Procedure::Droplets);
        let body = stage.body.as_str();
        let towards = self.values.towards(stage.direction.as_ref())?;
        let speed = match (&stage.speed, &stage.drop) {
            (Some(term), _) => self.values.term(term)?,
            (None, Some(term)) => self.dropped(self.values.term(term)?)?,
            (None, None) => return Err(NothingToSimulate::ValueMissing),
        };
        let moves = self.values.or_zero(stage.moves.as_ref())?;
        let flow = self.flow(stage, speed, moves)?;
        let each = self.given(stage, towards, speed - moves)?;
        // Droplets of a kilogram: as many come in a second as the flow has kilograms.
        let force = times(flow, each);
        self.note_vector(&format!("F_{body}"), force);
        if let [axis] = self.values.axes()[..] {
            self.note_here(&format!("F_hold_{body}"), -part(force, axis), 0.0);
        }
        if stage.moves.is_some() {
            self.note_here(&format!("P_{body}"), dot(force, towards) * moves, 0.0);
        }
        if let Some(caught) = self.stays(stage, flow)? {
            self.carried(stage, caught, force)?;
            // A droplet of a kilogram that stays has lost what it brought, as the body sees it.
            let brought = times(speed - moves, towards);
            let kept = less(brought, each);
            self.note_here("T_lost", caught * (dot(brought, brought) - dot(kept, kept)) / 2.0, 0.0);
        }
        Ok(())
    }

    /// The mass of all droplets so far, where they stay and it is told how many there are.
    fn stays(&self, stage: &Stream, flow: f64) -> Result<Option<f64>, NothingToSimulate> {
        match (&stage.during, &stage.caught) {
            (Some(term), _) if stage.stays => self.values.term(term).map(|time| Some(flow * time)),
            (None, Some(term)) if stage.stays => self.values.term(term).map(Some),
            _ => Ok(None),
        }
    }

    /// The push of what carries a body that stays where it is: against its weight, that of all droplets so far, and their blows.
    fn carried(&mut self, stage: &Stream, caught: f64, force: Vector) -> Result<(), NothingToSimulate> {
        if self.values.axes().into_iter().all(|axis| self.values.gravity(axis) == Ok(0.0)) {
            return Ok(());
        }
        let mass = self.values.mass(&stage.body)? + caught;
        for axis in self.values.axes() {
            let gravity = self.values.gravity(axis)?;
            if gravity != 0.0 {
                let push = gravity.signum() * (mass * gravity + part(force, axis));
                self.note_here(&format!("N_{}", stage.body), push, 0.0);
            }
        }
        Ok(())
    }

    fn dropped(&mut self, height: f64) -> Result<f64, NothingToSimulate> {
        let falls = times(self.values.named("g")?, unit(Axis::X));
        let droplet = Particle { falls, ..Particle::free(DROPLET, 1.0, ZERO) };
        let end = self.unwatched(|bench| bench.fall_through(droplet, height))?;
        let speed = size(velocity(&end.state, 0));
        self.note_here("v_stream", speed, 0.0);
        Ok(speed)
    }

    /// The mass that reaches the body in a unit of time: droplets in a row, equally far apart, counted as they catch up with it.
    fn flow(&mut self, stage: &Stream, speed: f64, moves: f64) -> Result<f64, NothingToSimulate> {
        let line = match (&stage.flow, &stage.density, &stage.area, &stage.per_length) {
            (Some(term), ..) => return self.values.term(term),
            (None, Some(density), Some(area), _) => self.values.term(density)? * self.values.term(area)?,
            (None, _, _, Some(term)) => self.values.term(term)?,
            _ => return Err(NothingToSimulate::ValueMissing),
        };
        // Of many bodies that follow each other, there is always one at the same place.
        let away = if stage.series { 0.0 } else { moves };
        let apart = 1.0 / f64::from(DROPLETS);
        let arrives = |droplet: u32| {
            let behind = apart * f64::from(droplet);
            behind / (speed - away)
        };
        if speed <= away {
            return Err(NothingToSimulate::NothingChanges);
        }
        let flow = f64::from(DROPLETS) * apart * line / (arrives(DROPLETS) - arrives(0));
        self.note_here(&format!("flow_{}", stage.body), flow, 0.0);
        Ok(flow)
    }

    /// The impulse that a droplet of a kilogram gives the body, which it meets with a relative speed.
    fn given(&mut self, stage: &Stream, towards: Vector, relative: f64) -> Result<Vector, NothingToSimulate> {
        if let Some(term) = &stage.turned {
            return self.along_vane(towards, relative, self.values.term(term)?);
        }
        let restitution = self.values.or_zero(stage.restitution.as_ref())?;
        let drop = Particle::free(DROPLET, 1.0, times(relative, towards));
        let still = Particle { mass: None, ..Particle::free("", 0.0, ZERO) };
        let normal = match &stage.normal {
            Some(_) => {
                let normal = self.values.towards(stage.normal.as_ref())?;
                times((relative * dot(normal, towards)).signum(), normal)
            }
            None => times(relative.signum(), towards),
        };
        let parted = Touch { parties: [drop, still], normal, restitution }.watched(self)?;
        self.remark(SEEN);
        Ok(parted.bodies[1].impulse)
    }

    /// A droplet that a smooth vane leads round an arc, by a turn of 1 rad in a second.
    fn along_vane(&mut self, towards: Vector, relative: f64, turn: f64) -> Result<Vector, NothingToSimulate> {
        let start = times(relative, towards);
        let droplet = Particle::free(DROPLET, 1.0, start);
        let vane = Surface::circle(times(turn.signum(), across(start)));
        let mut system = System::<6>::new(Frame::plane(false), vec![droplet]);
        system.constraint = Some(Constraint::Surface(vane));
        let integrator = self.integrator(0.1);
        let end = self.go(&system, integrator, &Until::Time(turn.abs()))?;
        self.remark(SEEN);
        Ok(less(start, velocity(&end.state, 0)))
    }
}
