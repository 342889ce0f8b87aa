//! A steady stream as droplets, one after another: how many arrive in a time, and what each gives the body.

use crate::scene::Axis;
use crate::scene::stage::Stream;

use crate::simulate::scene::bench::{Bench, Way};
use crate::simulate::scene::component::Frame;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::touch::{Party, Touch};
use crate::simulate::scene::vector::{Vector, ZERO, across, dot, part, times, unit};

/// How many droplets are counted.
const DROPLETS: u32 = 1_000;

/// What is watched of a stream.
const DROPLET: &str = "droplet";
const SEEN: &str = "One droplet of 1 kg is shown, relative to the body that it meets; the duration is not given.";

impl Bench<'_> {
    pub(super) fn stream(&mut self, stage: &Stream) -> Result<(), NothingToSimulate> {
        self.by(Way::Droplets);
        let body = stage.body.as_str();
        let towards = match &stage.direction {
            Some(term) => self.values.direction(&term.0)?,
            None => self.values.axes().first().map_or(unit(Axis::X), |axis| unit(*axis)),
        };
        let speed = match (&stage.speed, &stage.drop) {
            (Some(term), _) => self.values.term(term)?,
            (None, Some(term)) => self.dropped(self.values.term(term)?)?,
            (None, None) => return Err(NothingToSimulate::ValueMissing),
        };
        let moves = stage.moves.as_ref().map_or(Ok(0.0), |term| self.values.term(term))?;
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
        if stage.stays {
            self.carried(stage, flow, force)?;
        }
        Ok(())
    }

    /// The push of what carries a body that stays where it is: against its weight, that of all droplets so far, and their blows.
    fn carried(&mut self, stage: &Stream, flow: f64, force: Vector) -> Result<(), NothingToSimulate> {
        let caught = match (&stage.during, &stage.caught) {
            (Some(term), _) => flow * self.values.term(term)?,
            (None, Some(term)) => self.values.term(term)?,
            (None, None) => return Ok(()),
        };
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
        let gravity = self.values.named("g")?;
        let integrator = self.integrator(0.1 * libm::sqrt(height / gravity));
        let slope = |_: f64, state: &[f64; 2]| [-state[1], gravity];
        let (_, end) = integrator.event(0.0, [height, 0.0], &slope, &|_, state| state[0])?;
        self.note_here("v_stream", end[1], 0.0);
        Ok(end[1])
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
        let restitution = stage.restitution.as_ref().map_or(Ok(0.0), |term| self.values.term(term))?;
        let drop = Party::free(1.0, times(relative, towards));
        let still = Party { mass: None, velocity: ZERO, guide: None };
        let normal = times(relative.signum(), towards);
        let touch = Touch { parties: [drop, still], normal, restitution };
        let parted = touch.run(self)?;
        touch.film(self, [DROPLET, ""])?;
        self.remark(SEEN);
        Ok(parted.impulses[1])
    }

    /// A droplet that a smooth vane leads round an arc: the vane pushes it at right angles to its motion.
    fn along_vane(&mut self, towards: Vector, relative: f64, turn: f64) -> Result<Vector, NothingToSimulate> {
        let start = times(relative, towards);
        let sense = turn.signum();
        // Velocity, the impulse on the vane, and the place; a turn of 1 rad in a second.
        let slope = |_: f64, state: &[f64; 6]| {
            let push = times(sense, across([state[0], state[1], 0.0]));
            [push[0], push[1], -push[0], -push[1], state[0], state[1]]
        };
        let state = [start[0], start[1], 0.0, 0.0, 0.0, 0.0];
        let end = self.integrator(0.1).until(0.0, state, turn.abs(), &slope)?;
        let look = |time: f64, state: &[f64; 6]| {
            let [x, y, ..] = slope(time, state);
            Look {
                bodies: vec![Seen { mass: 1.0, place: vec![state[4], state[5]], velocity: vec![state[0], state[1]] }],
                outside: vec![x, y],
                ..Look::default()
            }
        };
        let (names, components, start) = (&[DROPLET], Frame::plane(false).components, (0.0, state));
        self.film(&Motion { names, components, start, end: turn.abs(), slope: &slope, look: &look })?;
        self.remark(SEEN);
        Ok([end[2], end[3], 0.0])
    }
}
