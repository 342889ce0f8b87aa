//! Motions along a line: the slope that it has, and what ends them.

use super::course::{Goal, Until};
use super::integrate::End;
use super::nothing::NothingToSimulate;
use super::particles::{place, velocity};
use super::stage_run::StageRun;
use super::system::System;
use super::values::Values;
use super::vector::{Vector, dot, part};
use momentous_scene::{Axis, Term};

/// A slope against the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slope {
    /// The part of weight along the axis: positive where it pulls the body along it.
    pub along: f64,
    /// The part of weight that presses on the floor.
    pub across: f64,
}

/// The end of a motion along a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Finish {
    Rest,
    Time(f64),
    Procedure(f64),
}

impl Values<'_> {
    /// The slope that a term says: `alpha above +x`, or an angle alone where the axis points up or down the slope.
    pub(super) fn slope(&self, term: Option<&Term>) -> Result<Slope, NothingToSimulate> {
        let Some(Term(text)) = term else { return Ok(Slope { along: 0.0, across: 1.0 }) };
        let joint = [(" above ", -1.0), (" below ", 1.0)];
        let joined = joint.into_iter().find_map(|(joint, sign)| Some((text.split_once(joint)?, sign)));
        let (angle, sign) = match joined {
            Some(((angle, base), sign)) => (angle, if base.trim().starts_with('-') { -sign } else { sign }),
            None => {
                let axes = self.scene.axes.rectangular();
                let senses = axes.first().map_or("", |(_, senses)| senses.positive.as_str());
                (text.as_str(), if senses.contains("down") { 1.0 } else { -1.0 })
            }
        };
        let angle = self.number(angle)?;
        Ok(Slope { along: sign * libm::sin(angle), across: libm::cos(angle) })
    }

    /// The acceleration of free fall along each axis. Over a slope the first axis runs along it, the second away from it.
    pub(super) fn falls(&self, incline: Option<&Term>) -> Result<Vec<f64>, NothingToSimulate> {
        if incline.is_none() {
            return self.axes().into_iter().map(|axis| self.gravity(axis)).collect();
        }
        let (slope, gravity) = (self.slope(incline)?, self.named("g")?);
        match self.axes()[..] {
            [_, _] => Ok(vec![gravity * slope.along, -gravity * slope.across]),
            _ => Err(NothingToSimulate::Unread),
        }
    }

    /// The sense of a motion along an axis: where a term points, or else along the axis.
    pub(super) fn sense(&self, direction: Option<&Term>, axis: Axis) -> Result<f64, NothingToSimulate> {
        let Some(Term(text)) = direction else { return Ok(1.0) };
        Ok(part(self.direction(text)?, axis).signum())
    }

    /// Finishes a motion along a line that may end at rest, after a way, or after a time.
    pub(super) fn finish(
        &self,
        at_rest: bool,
        way: Option<f64>,
        duration: Option<&Term>,
    ) -> Result<Finish, NothingToSimulate> {
        match (at_rest, way) {
            (true, _) => Ok(Finish::Rest),
            (false, Some(way)) => Ok(Finish::Procedure(way)),
            (false, None) => self.known(duration).map_or_else(|| self.duration(), Ok).map(Finish::Time),
        }
    }
}

impl StageRun<'_> {
    /// Lets particles go, of which one leads along a line, until they have finished.
    pub(super) fn go_along<const N: usize>(
        &mut self,
        system: &System<'_, N>,
        (leads, line): (usize, Vector),
        finish: Finish,
    ) -> Result<End<N>, NothingToSimulate> {
        let state = system.state();
        let speed = dot(line, velocity(&state, leads)).abs();
        let quick = dot(line, velocity(&system.slope(system.start, &state), leads)).abs().max(f64::MIN_POSITIVE);
        let closing = |state: &[f64; N]| dot(line, place(state, leads)).signum() * dot(line, velocity(state, leads));
        let (time, way) = match finish {
            Finish::Time(end) => (end - system.start, None),
            Finish::Rest => (speed / quick, None),
            Finish::Procedure(way) => (way / (speed + libm::sqrt(way * quick)), Some(way)),
        };
        let longest = if let Finish::Time(_) = finish { time } else { time.clamp(1e-6, 100.0) };
        let integrator = self.integrator(longest / 4.0);
        match (finish, way) {
            (_, Some(whole)) => {
                let left = |state: &[f64; N]| whole - dot(line, place(state, leads)).abs();
                self.go_to(system, integrator, &Goal { left: &left, closing: &closing, whole, time })
            }
            (Finish::Time(end), None) => self.go(system, integrator, &Until::Time(end)),
            (Finish::Rest | Finish::Procedure(_), None) => {
                self.go(system, integrator, &Until::Event(&|state| dot(line, velocity(state, leads))))
            }
        }
    }
}
