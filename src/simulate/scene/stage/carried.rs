//! A body that rises or sinks on another one, which gives way along the level: both held together by the force between them.

use core::f64::consts::FRAC_PI_3;

use momentous_scene::Axis;
use momentous_scene::Term;
use momentous_scene::stage::{Halt, Place, Slide, Swing, UpOrDown};

use crate::scene::component::Frame;
use crate::scene::course::Until;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Constraint, Particle, Surface, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{Vector, ZERO, cross, less, times, unit};

/// The angle from which a body comes down on a circle of any radius.
const ANY_ANGLE: f64 = 1.0;

/// Places and velocities of both.
type State = [f64; 12];

/// A body and what carries it, across and upwards from the lowest point of the path at the start.
struct Pair<'a> {
    names: [&'a str; 2],
    masses: [f64; 2],
    speeds: [f64; 2],
    gravity: f64,
    /// Which way the body moves across, as seen from what carries it.
    sense: f64,
}

/// Both ends of a motion on a circle, and how strongly the circle holds the body there.
struct Swung {
    ends: [State; 2],
    forces: [f64; 2],
}

impl<'a> Pair<'a> {
    /// How fast the body moves on the other one, along its way.
    fn relative(&self) -> f64 {
        self.sense * (self.speeds[0] - self.speeds[1])
    }

    /// Both at the start, the body on a circle that the other one carries.
    fn on(&self, circle: Surface, place: Vector) -> System<'a, 12> {
        let free = |side: usize| Particle::free(self.names[side], self.masses[side], [self.speeds[side], 0.0, 0.0]);
        let body = Particle { place, falls: [0.0, -self.gravity, 0.0], ..free(0) };
        let carrier = Particle { guide: Some(unit(Axis::X)), ..free(1) };
        let constraint = Some(Constraint::Surface(Surface { carrier: Some(1), ..circle }));
        System { constraint, ..System::new(Frame::plane(true), vec![body, carrier]) }
    }

    /// A tenth of the time in which a body on a circle of that radius swings, more quickly on a light carrier.
    fn soon(&self, radius: f64) -> f64 {
        let [carried, carrier] = self.masses;
        0.1 * libm::sqrt(radius / self.gravity * carrier / (carried + carrier))
    }
}

/// The place of the body, as seen from what carries it.
fn seen(state: &State) -> Vector {
    less(place(state, 0), place(state, 1))
}

impl StageRun<'_> {
    pub(super) fn slide_on(&mut self, stage: &Slide, on: &str) -> Result<(), NothingToSimulate> {
        let rises = stage.way == Some(UpOrDown::Up);
        let pair = self.both([&stage.body, on], stage.direction.as_ref(), false)?;
        let relative = pair.relative();
        let end = if stage.until == Some(Halt::Together) {
            let end = self.on_circle(&pair, relative * relative / pair.gravity, 0.0)?.ends[1];
            self.note_term(stage.height.as_ref(), seen(&end)[1], 0.0);
            end
        } else {
            let height = self.values.known(stage.height.as_ref()).ok_or(NothingToSimulate::ValueMissing)?;
            if relative == 0.0 && !rises {
                self.on_circle(&pair, height / (1.0 - libm::cos(ANY_ANGLE)), -ANY_ANGLE)?.ends[1]
            } else {
                self.on_two_arcs(&pair, if rises { height } else { -height })?
            }
        };
        self.note_both(&pair, &end)
    }

    pub(super) fn swing_on(&mut self, stage: &Swing, on: &str) -> Result<(), NothingToSimulate> {
        let (body, instant) = (stage.body.as_str(), self.values.index + 1);
        let [from, to] = stage.places();
        let rises = from == Place::Lowest;
        let pair = self.both([body, on], stage.direction.as_ref(), !rises)?;
        let height_name = format!("h_{body}{}", self.values.suffix());
        let height = self.values.known(stage.height.as_ref()).or_else(|| (self.values.value)(&height_name));
        let radius = match (self.values.known(stage.arm()), height) {
            (Some(length), _) => length,
            // Only heights are used, so that the length may be anything that reaches them.
            (None, _) if rises => pair.relative() * pair.relative() / pair.gravity,
            (None, Some(height)) => height / (1.0 - libm::cos(ANY_ANGLE)),
            (None, None) => return Err(NothingToSimulate::ValueMissing),
        };
        let start = match from {
            Place::Lowest => 0.0,
            Place::Angle(term) => {
                let named = || (self.values.value)(&format!("angle_{body}{instant}"));
                let fallen = || height.map(|height| libm::acos(1.0 - height / radius));
                // It comes down from behind.
                -self.values.known(term).or_else(named).or_else(fallen).ok_or(NothingToSimulate::ValueMissing)?
            }
        };
        let Swung { ends, forces } = self.on_circle(&pair, radius, start)?;
        let [low, high] = if rises { [0, 1] } else { [1, 0] };
        let rise = seen(&ends[high])[1] - seen(&ends[low])[1];
        self.note(&height_name, rise, radius);
        self.note_term(stage.height.as_ref(), rise, radius);
        if stage.arm().is_some() {
            if let Place::Angle(term) = to {
                let angle = libm::acos(1.0 - rise / radius);
                self.note(&format!("angle_{body}{}", instant + 1), angle, 1.0);
                self.note_term(term, angle, 1.0);
            }
            let force = if stage.radius.is_some() { "N" } else { "tension" };
            self.note(&format!("{force}_{body}{}", instant + low), forces[low], pair.masses[0] * pair.gravity);
        }
        self.note_both(&pair, &ends[1])
    }

    /// Both before the stage; where they move together, one velocity tells the other.
    fn both<'a>(
        &mut self,
        names: [&'a str; 2],
        direction: Option<&Term>,
        together: bool,
    ) -> Result<Pair<'a>, NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let [carried, carrier] = names.map(|name| self.values.velocity_before(name, axis));
        let speeds = if together { [carried.or(carrier)?, carrier.or(carried)?] } else { [carried?, carrier?] };
        for (name, speed) in names.into_iter().zip(speeds).filter(|_| together) {
            self.note(&self.values.start_name(name, axis), speed, 0.0);
        }
        let masses = [self.values.mass(names[0])?, self.values.mass(names[1])?];
        let (gravity, sense) = (self.values.named("g")?, self.values.sense(direction, axis)?);
        Ok(Pair { names, masses, speeds, gravity, sense })
    }

    /// From an angle behind the lowest point down to it, or from there up to where both move together.
    fn on_circle(&mut self, pair: &Pair<'_>, radius: f64, start: f64) -> Result<Swung, NothingToSimulate> {
        let centre = [0.0, radius, 0.0];
        let behind = [pair.sense * radius * libm::sin(start), radius * (1.0 - libm::cos(start)), 0.0];
        let system = pair.on(Surface::circle(centre), behind);
        let left = |state: &State| {
            if start < 0.0 {
                -pair.sense * seen(state)[0]
            } else {
                pair.sense * cross(less(seen(state), centre), less(velocity(state, 0), velocity(state, 1)))[2]
            }
        };
        let integrator = self.integrator(pair.soon(radius));
        let end = self.go(&system, integrator, &Until::Event(&left))?;
        let ends = [system.state(), end.state];
        Ok(Swung { ends, forces: ends.map(|state| -radius * system.tension(0.0, &state)) })
    }

    /// Up or down along an arc, and along another one that bends back: level at both ends.
    fn on_two_arcs(&mut self, pair: &Pair<'_>, height: f64) -> Result<State, NothingToSimulate> {
        let radius = height.abs();
        let centres = [[0.0, height, 0.0], [2.0 * pair.sense * radius * libm::sin(FRAC_PI_3), 0.0, 0.0]];
        let mut system = pair.on(Surface::circle(centres[0]), ZERO);
        let integrator = self.integrator(pair.soon(radius));
        let half = |state: &State| (height / 2.0 - seen(state)[1]) * height.signum();
        let end = self.go(&system, integrator, &Until::Event(&half))?;
        system.go_on_from(&end);
        system.constraint = Some(Constraint::Surface(Surface { carrier: Some(1), ..Surface::circle(centres[1]) }));
        let across = |state: &State| pair.sense * (centres[1][0] - seen(state)[0]);
        Ok(self.go(&system, integrator, &Until::Event(&across))?.state)
    }

    /// Notes the velocities at the end, level as they are.
    fn note_both(&mut self, pair: &Pair<'_>, end: &State) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let scale = libm::sqrt(pair.gravity * place(end, 0)[1].abs()) + pair.speeds[0].abs() + pair.speeds[1].abs();
        for (side, name) in pair.names.into_iter().enumerate() {
            self.note_velocity(name, times(velocity(end, side)[0], unit(axis)), scale);
        }
        Ok(())
    }
}
