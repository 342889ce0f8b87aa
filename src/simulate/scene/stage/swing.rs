//! A swing on a cord: a pendulum, integrated.

use core::f64::consts::PI;

use momentous_scene::stage::{Place, Swing, UpOrDown};

use crate::scene::component::Frame;
use crate::scene::course::Until;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Constraint, Particle, Surface, place, velocity};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;
use crate::scene::vector::{cross, less, size, times, unit};

/// The angle at which a swing starts whose cord may have any length.
const ANY_ANGLE: f64 = 1.0;

impl StageRun<'_> {
    pub(super) fn swing(&mut self, stage: &Swing) -> Result<(), NothingToSimulate> {
        if let Some(on) = &stage.on {
            return self.swing_on(stage, on);
        }
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let (body, gravity) = (stage.body.as_str(), self.values.named("g")?);
        let by_name = |base: &str| (self.values.value)(&format!("{base}_{body}{}", self.values.suffix()));
        let height = self.values.known(stage.height.as_ref()).or_else(|| by_name("h"));
        let sense = self.values.sense(stage.direction.as_ref(), axis)?;
        let before = self.values.velocity_before(body, axis);
        let [from, to] = stage.places();
        let told = self.values.known(stage.arm());
        let length = match (told, height, &before) {
            (Some(length), ..) => length,
            // Only heights are used, so that the length may be anything that reaches them.
            (None, Some(height), _) if stage.way == Some(UpOrDown::Down) => height / (1.0 - libm::cos(ANY_ANGLE)),
            (None, _, Ok(speed)) if *speed != 0.0 => speed * speed / gravity,
            _ => return Err(NothingToSimulate::ValueMissing),
        };
        let instant = self.values.index + 1;
        let named = |instant: usize| (self.values.value)(&format!("angle_{body}{instant}"));
        let start = match from {
            Place::Lowest => 0.0,
            Place::Angle(term) => {
                let angle = self.values.known(term).or_else(|| named(instant));
                let fallen = || height.map(|height| libm::acos(1.0 - height / length));
                // It comes down from behind.
                -angle.or_else(fallen).ok_or(NothingToSimulate::ValueMissing)?
            }
        };
        let speed = match from {
            Place::Lowest => sense * before?,
            Place::Angle(_) => {
                (self.values.value)(&format!("speed_{body}{instant}")).or(before.ok()).unwrap_or(0.0).abs()
            }
        };
        let end = match to {
            Place::Lowest => Some(0.0),
            Place::Angle(term) => self.values.known(term).or_else(|| named(instant + 1)),
        };
        let stops = stage.stops();
        // Across and up from the lowest point.
        let (pivot, mass) = ([0.0, length, 0.0], self.values.any_mass(body));
        let bob = Particle {
            place: [sense * length * libm::sin(start), length * (1.0 - libm::cos(start)), 0.0],
            falls: [0.0, -gravity, 0.0],
            ..Particle::free(body, mass, times(speed, [sense * libm::cos(start), libm::sin(start), 0.0]))
        };
        let cord = Constraint::Surface(Surface::circle(pivot));
        let system = System::<6> { constraint: Some(cord), ..System::new(Frame::plane(true), vec![bob]) };
        // Counted on from where it starts, past the top as well.
        let angle = |state: &[f64; 6]| {
            let angle = libm::atan2(sense * state[0], length - state[1]);
            if angle < start - 1.0 {
                angle + 2.0 * PI
            } else if angle > start - 1.0 + 2.0 * PI {
                angle - 2.0 * PI
            } else {
                angle
            }
        };
        let swings = |state: &[f64; 6]| sense * cross(less(place(state, 0), pivot), velocity(state, 0))[2];
        let left = |state: &[f64; 6]| match end {
            Some(end) if !stops => end - angle(state),
            _ => swings(state),
        };
        let integrator = self.integrator(0.1 * libm::sqrt(length / gravity));
        let end = self.go(&system, integrator, &Until::Event(&left))?;
        self.about(vec![0.0, length], true);
        let [before, after] = [system.state(), end.state];
        let reached = size(velocity(&after, 0));
        let rise = (after[1] - before[1]).abs();
        match to {
            Place::Lowest => self.note_velocity(body, times(sense * reached, unit(axis)), 0.0),
            Place::Angle(term) => {
                self.note(&format!("speed_{body}{}", instant + 1), reached, speed);
                if told.is_some() {
                    self.note(&format!("angle_{body}{}", instant + 1), angle(&after), 1.0);
                    self.note_term(term, angle(&after), 1.0);
                }
            }
        }
        self.note_here(&format!("h_{body}"), rise, length);
        self.note_term(stage.height.as_ref(), rise, length);
        if let (Ok(mass), true) = (self.values.mass(body), told.is_some()) {
            for (instant, state) in [(instant, before), (instant + 1, after)] {
                let tension = -length * system.tension(0.0, &state);
                let force = if stage.radius.is_some() { "N" } else { "tension" };
                self.note(&format!("{force}_{body}{instant}"), tension, mass * gravity);
            }
        }
        Ok(())
    }
}
