//! A body on a floor or a slope, along one axis: how it slides, and what ends the slide.

use super::bench::Bench;
use super::integrate::Slope as Changes;
use super::nothing::NothingToSimulate;
use super::reel::{Look, Motion, Seen};
use super::values::{OfTime, Values};
use super::vector::{part, times, unit};
use crate::scene::{Axis, Term};

/// A slope against the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slope {
    /// The part of weight along the axis: positive where it pulls the body along it.
    pub along: f64,
    /// The part of weight that presses on the floor.
    pub across: f64,
}

/// A body that slides.
pub(super) struct Slide {
    /// The acceleration along the axis without friction, in the time of the stage.
    pub drive: OfTime,
    /// The greatest deceleration by friction while it slides.
    pub grip: OfTime,
    /// Times at which the drive changes its law.
    pub changes: Vec<f64>,
    pub start: f64,
    pub speed: f64,
    /// What slides, where it is watched.
    pub body: Option<Sliding>,
}

/// A body that slides, with the share of the drive that has a potential.
#[derive(Clone)]
pub(super) struct Sliding {
    pub name: String,
    pub mass: f64,
    pub axis: Axis,
    /// The acceleration by its weight along the axis.
    pub weight: f64,
}

/// What ends a slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Until {
    Rest,
    Time(f64),
    Way(f64),
}

/// How a slide ended: when, how far from where it began, and how fast.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slid {
    pub time: f64,
    pub way: f64,
    pub speed: f64,
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
}

impl Slide {
    /// Runs the slide; `sense` is where it goes if it starts from rest.
    pub(super) fn run(&self, bench: &mut Bench<'_>, sense: f64, until: Until) -> Result<Slid, NothingToSimulate> {
        let sense = if self.speed == 0.0 { sense } else { self.speed.signum() };
        let end = match until {
            Until::Time(time) => time,
            Until::Rest | Until::Way(_) => f64::INFINITY,
        };
        let mut state = [0.0, self.speed];
        let mut time = self.start;
        let change = ((self.drive)(time).abs() + (self.grip)(time)).max(f64::MIN_POSITIVE);
        let typical = match until {
            Until::Way(way) => way / (self.speed.abs() + libm::sqrt(way * change)),
            _ => self.speed.abs() / change,
        };
        let longest = if end.is_finite() { (end - time) / 4.0 } else { typical.clamp(1e-6, 100.0) / 4.0 };
        let integrator = bench.integrator(longest);
        let slope = |time: f64, state: &[f64; 2]| [state[1], (self.drive)(time) - sense * (self.grip)(time)];
        let stop = |_: f64, state: &[f64; 2]| match until {
            Until::Rest => sense * state[1],
            Until::Time(_) => 1.0,
            Until::Way(way) => way - state[0].abs(),
        };
        let stops = self.changes.iter().copied().filter(|change| *change > self.start && *change < end);
        for next in stops.chain([end]) {
            // Just before a change the old law holds.
            let held = |at: f64, state: &[f64; 2]| slope(if at >= next { next.next_down() } else { at }, state);
            let run = integrator.run(time, state, next, &held, &stop)?;
            if let Some(body) = &self.body {
                Self::film(bench, body, (time, state), run.time, &held)?;
            }
            (time, state) = (run.time, run.state);
            if run.stopped {
                break;
            }
        }
        Ok(Slid { time: time - self.start, way: state[0], speed: if until == Until::Rest { 0.0 } else { state[1] } })
    }

    /// A piece of the motion as it is seen.
    fn film(
        bench: &mut Bench<'_>,
        body: &Sliding,
        start: (f64, [f64; 2]),
        end: f64,
        slope: Changes<'_, 2>,
    ) -> Result<(), NothingToSimulate> {
        let (mass, values) = (body.mass, bench.values);
        let split = |value: f64| values.split(times(value, unit(body.axis)));
        let look = |time: f64, state: &[f64; 2]| {
            let (force, held) = (mass * slope(time, state)[1], mass * body.weight);
            Look {
                bodies: vec![Seen { mass, place: split(state[0]), velocity: split(state[1]) }],
                outside: split(force),
                potential: -held * state[0],
                power: (force - held) * state[1],
                ..Look::default()
            }
        };
        let (names, components) = (&[body.name.as_str()], values.components());
        bench.film(&Motion { names, components, start, end, slope, look: &look })
    }
}
