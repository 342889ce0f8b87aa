//! A body that slides inside a smooth cone or bowl, integrated in space.

use momentous_scene::stage::{Bowl, UpOrDown};

use crate::scene::component::Frame;
use crate::scene::course::Until;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Constraint, Particle, Surface};
use crate::scene::revolution::{State, around, distance, speed};
use crate::scene::stage_run::StageRun;
use crate::scene::system::System;

impl StageRun<'_> {
    pub(super) fn bowl(&mut self, stage: &Bowl) -> Result<(), NothingToSimulate> {
        let (body, first) = (stage.body.as_str(), self.values.index + 1);
        let named = |base: &str, instant: usize, part: &str| {
            let since = (1..=instant).rev().map(|other| self.values.named(&format!("{base}_{body}{other}{part}")));
            since.into_iter().find(Result::is_ok).unwrap_or(Err(NothingToSimulate::ValueMissing))
        };
        let gravity = self.values.named("g")?;
        let start = named("r", first, "")?;
        let goal = self.values.named(&format!("r_{body}{}", first + 1));
        let height = match &stage.height {
            Some(term) => self.values.term(term),
            None => self.values.named(&format!("h_{body}{}", self.values.suffix())),
        };
        let sense = if stage.way == UpOrDown::Up { 1.0 } else { -1.0 };
        let (surface, level, steep) = match (&stage.cone, &stage.sphere) {
            (Some(term), _) => {
                let angle = self.values.term(term)?;
                let tangent = libm::tan(angle);
                (Surface::cone(tangent), start / tangent, libm::cos(angle))
            }
            (None, Some(term)) => {
                let radius = self.values.term(term)?;
                let depth = libm::sqrt((radius * radius - start * start).max(0.0));
                (Surface::sphere(), -depth, start / radius)
            }
            // Any wall through both levels will do.
            (None, None) => {
                let tangent = sense * (goal? - start) / height?;
                let rises = 1.0 / libm::sqrt(1.0 + tangent * tangent);
                (Surface::cone(tangent), start / tangent, rises)
            }
        };
        let across = named("v", first, ".theta")?;
        let along = if stage.is_horizontal(0) { 0.0 } else { sense * named("v", first, ".s")?.abs() };
        let outwards = along * libm::sqrt((1.0 - steep * steep).max(0.0));
        let mass = self.values.any_mass(body);
        let slides = Particle {
            place: [start, 0.0, level],
            falls: [0.0, 0.0, -gravity],
            ..Particle::free(body, mass, [outwards, across, along * steep])
        };
        let wall = Some(Constraint::Surface(surface));
        // In space, from the middle of the cone or bowl.
        let system = System::<6> { constraint: wall, ..System::new(Frame::upright_space(), vec![slides]) };
        let integrator = self.integrator(0.02 * libm::sqrt(start / gravity));
        // On one level it only goes round.
        let is_level = |height: f64| height.abs() <= f64::EPSILON * start;
        if !stage.is_horizontal(1) && height.or(goal.map(|goal| goal - start)).is_ok_and(is_level) {
            return Err(NothingToSimulate::NothingChanges);
        }
        let ends: Box<dyn Fn(&State) -> f64> = match (stage.is_horizontal(1), height, goal) {
            (true, ..) => Box::new(move |state| sense * state[5]),
            (false, Ok(height), _) => Box::new(move |state| height - sense * (state[2] - level)),
            (false, Err(_), Ok(goal)) => Box::new(move |state| (goal - start).signum() * (goal - distance(state))),
            (false, Err(missing), Err(_)) => return Err(missing),
        };
        let (state, end) = (system.state(), self.go(&system, integrator, &Until::Event(&ends))?.state);
        self.note_level(stage, first, &state);
        self.note_level(stage, first + 1, &end);
        let rise = (end[2] - level).abs();
        self.note_here(&format!("h_{body}"), rise, start);
        self.note_term(stage.height.as_ref(), rise, start);
        self.note(&format!("r_{body}{}", first + 1), distance(&end), start);
        self.note(&format!("v_{body}{}.theta", first + 1), around(&end), across);
        Ok(())
    }

    fn note_level(&mut self, stage: &Bowl, instant: usize, state: &State) {
        let body = stage.body.as_str();
        self.note(&format!("speed_{body}{instant}"), speed(state), 0.0);
        let rises = libm::sqrt((speed(state) * speed(state) - around(state) * around(state)).max(0.0));
        self.note(&format!("angle_{body}{instant}"), libm::atan2(rises, around(state).abs()), 1.0);
        if let Ok(mass) = self.values.mass(body) {
            self.note(&format!("H_{}{instant}", stage.about), mass * around(state) * distance(state), 0.0);
        }
    }
}
