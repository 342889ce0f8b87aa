//! A body that comes apart: some force between its parts, as strong as the energy, the relative velocity or the velocities
//! afterwards say.

use core::f64::consts::PI;
use nalgebra::Matrix3;
use nalgebra::Vector3;

use momentous_scene::stage::{Relative, Separate, When};

use crate::scene::course::Until;
use crate::scene::filming::Motion;
use crate::scene::in_time::InTime;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::{Force, Particle, place, velocity};
use crate::scene::pushed::Pushed;
use crate::scene::stage_run::{StageRun, kinetic};
use crate::scene::system::System;
use crate::scene::vector::{Vector, ZERO, add, dot, less, size, times, unit};

/// The longest step beside the second that a force between parts takes.
const LONGEST: f64 = 0.25;

/// How often parts that are driven off one other take turns.
const MOST_ROUNDS: usize = 200;
/// The share of its velocity by which a part may still change in the last turn.
const SETTLED: f64 = 1e-13;

/// Two parts that push each other.
type Pair<'a> = [Pushed<'a>; 2];

impl StageRun<'_> {
    pub(super) fn separate(&mut self, stage: &Separate) -> Result<(), NothingToSimulate> {
        let first = stage.into.first().ok_or(NothingToSimulate::NoStage)?;
        let whole = self.values.moving(stage.from.as_deref().unwrap_or(first))?;
        let mut pieces = Vec::new();
        for name in &stage.into {
            let guide = self.values.guide(name).transpose()?;
            pieces.push(Pushed::new(Particle { guide, ..Particle::free(name, self.values.mass(name)?, whole) }));
        }
        match (&stage.energy, stage.relatives(), &mut pieces[..]) {
            (Some(energy), _, [one, other]) => {
                let energy = self.values.term(energy)?;
                [*one, *other] = self.sprung(&[*one, *other], energy)?;
            }
            (None, [], pieces) => self.parting(pieces)?,
            (None, relatives, pieces) => self.driven(pieces, relatives)?,
            _ => return Err(NothingToSimulate::NoMethod),
        }
        self.note_parts(stage, &pieces);
        self.film_parts(stage, &pieces)
    }

    /// A spring between the parts, the first behind the second, that holds so much energy.
    fn sprung<'a>(&mut self, pair: &Pair<'a>, energy: f64) -> Result<Pair<'a>, NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::NoMethod) };
        let along = unit(axis);
        let stiffness = pair.iter().filter_map(|body| body.body.mass).fold(f64::INFINITY, f64::min);
        let pressed = libm::sqrt(2.0 * energy / stiffness);
        let spring = Force::spring(vec![(0, along), (1, times(-1.0, along))], stiffness, pressed);
        let left = |state: &[f64; 13]| pressed + dot(along, less(place(state, 0), place(state, 1)));
        self.pushed_apart(pair, spring, along, &Until::Event(&left))
    }

    /// Drives as strongly as each part has to move as seen from the other. What drives one moves the other under the next, so that
    /// several take turns until none is driven any further.
    fn driven(&mut self, pieces: &mut [Pushed<'_>], relatives: &[Relative]) -> Result<(), NothingToSimulate> {
        for _ in 0..MOST_ROUNDS {
            let before: Vec<Vector> = pieces.iter().map(|piece| piece.after).collect();
            for relative in relatives {
                self.driven_off(pieces, relative)?;
            }
            let moved = |(piece, before): (&Pushed<'_>, &Vector)| {
                size(less(piece.after, *before)) > SETTLED * size(piece.after)
            };
            if relatives.len() == 1 || !pieces.iter().zip(&before).any(moved) {
                return Ok(());
            }
        }
        Err(NothingToSimulate::NoMethod)
    }

    /// Drives as strongly as one part has to move as seen from the other.
    fn driven_off(&mut self, pieces: &mut [Pushed<'_>], relative: &Relative) -> Result<(), NothingToSimulate> {
        let place =
            |name: &str| pieces.iter().position(|piece| piece.body.name == name).ok_or(NothingToSimulate::NoStage);
        let [of, to] = [place(&relative.of)?, place(&relative.to)?];
        let direction = self.values.towards(relative.direction.as_ref())?;
        let speed = self.values.term(&relative.velocity)?;
        let relative_velocity = |pair: &Pair<'_>| {
            let from = match relative.when {
                When::After => pair[1].after,
                When::Before => pair[1].body.velocity,
            };
            less(pair[0].after, from)
        };
        let pair = self.searched(&[pieces[of], pieces[to]], times(speed, direction), &relative_velocity)?;
        [pieces[of], pieces[to]] = pair;
        Ok(())
    }

    /// All but one are pushed off that one, each as strongly as it moves afterwards as it is said to.
    fn parting(&mut self, pieces: &mut [Pushed<'_>]) -> Result<(), NothingToSimulate> {
        let mut missing = NothingToSimulate::ValueMissing;
        let mut told = Vec::new();
        for piece in pieces.iter() {
            let after = self.values.axes().into_iter().try_fold(ZERO, |all, axis| {
                let after = self.values.named(&self.values.velocity_after(piece.body.name, axis))?;
                Ok(add(all, times(after, unit(axis))))
            });
            told.push(after.map_err(|reason| missing = reason).ok());
        }
        // Nothing is said of the one that is left, or it is the last.
        let rest = told.iter().position(Option::is_none).or(told.len().checked_sub(1)).ok_or(missing)?;
        let [before @ .., last] = pieces else { return Err(missing) };
        told.swap(rest, before.len());
        if let Some(whole_or_part) = before.get_mut(rest) {
            std::mem::swap(whole_or_part, last);
        }
        for (piece, wanted) in before.iter_mut().zip(told) {
            [*piece, *last] = self.searched(&[*piece, *last], wanted.ok_or(missing)?, &|pair| pair[0].after)?;
        }
        Ok(())
    }

    /// The force between the parts with which something comes out as it is wanted: trials along each axis say how it changes.
    pub(super) fn searched<'a>(
        &mut self,
        pair: &Pair<'a>,
        wanted: Vector,
        outcome: &dyn Fn(&Pair<'_>) -> Vector,
    ) -> Result<Pair<'a>, NothingToSimulate> {
        let rest = outcome(&self.forced(pair, ZERO)?);
        let missing = less(wanted, rest);
        // The force in units that change velocities by about as much as is wanted.
        let size = size(missing) * pair[0].body.mass.ok_or(NothingToSimulate::ValueMissing)?;
        if size == 0.0 {
            return self.forced(pair, ZERO);
        }
        let mut answers = Matrix3::identity();
        for axis in self.values.axes() {
            let end = outcome(&self.forced(pair, times(size, unit(axis)))?);
            answers.set_column(axis as usize, &Vector3::from(times(1.0 / size, less(end, rest))));
        }
        let force = answers.lu().solve(&Vector3::from(missing)).ok_or(NothingToSimulate::NoMethod)?;
        self.forced(pair, force.into())
    }

    /// A force on the first part, and its opposite on the second, that rises and falls within a second.
    fn forced<'a>(&mut self, pair: &Pair<'a>, force: Vector) -> Result<Pair<'a>, NothingToSimulate> {
        let lines = vec![(0, force), (1, times(-1.0, force))];
        let wave = Force::in_time(lines, InTime::waves(1.0, 1.0, 1.0));
        self.pushed_apart(pair, wave, force, &Until::Time(1.0))
    }

    /// Both parts when a force between them, along a vector, has done what it does.
    fn pushed_apart<'a>(
        &mut self,
        pair: &Pair<'a>,
        force: Force,
        along: Vector,
        until: &Until<'_, 13>,
    ) -> Result<Pair<'a>, NothingToSimulate> {
        let particles = pair.iter().map(|body| Particle { velocity: body.after, ..body.body }).collect();
        let system = System { forces: vec![force], ..System::new(self.values.frame(), particles) };
        let integrator = self.integrator(LONGEST);
        let end = self.try_out(&system, integrator, until)?.state;
        let impulse = times(end[12], along);
        let [one, other] = *pair;
        Ok([
            Pushed { after: velocity(&end, 0), impulse: add(one.impulse, impulse), ..one },
            Pushed { after: velocity(&end, 1), impulse: less(other.impulse, impulse), ..other },
        ])
    }

    /// The parts while the force drives them apart; where neither it nor its duration is told, half a wave of one second.
    fn film_parts(&mut self, stage: &Separate, pieces: &[Pushed<'_>]) -> Result<(), NothingToSimulate> {
        let frame = self.values.frame();
        let told = self.values.known(stage.duration.as_ref());
        // The end, and the share of the impulse that comes in each second.
        let (end, rate) = match (told, &stage.force, pieces) {
            (Some(end), Some(force), [piece, ..]) => {
                let ((strength, _), whole) = (self.values.strength(force)?, size(piece.impulse));
                (end, InTime::sum(&[(1.0 / whole, strength)]))
            }
            (Some(end), ..) => (end, half_wave(end)),
            (None, ..) => (1.0, half_wave(1.0)),
        };
        let slope = |time: f64, state: &[f64; 2]| [rate.at(time), state[0]];
        let look = |time: f64, &[gained, gone]: &[f64; 2]| {
            frame.look(pieces.iter().map(|Pushed { body, impulse, .. }| {
                let (change, _) = body.yields(*impulse);
                let place = add(times(time, body.velocity), times(gone, change));
                let velocity = add(body.velocity, times(gained, change));
                let force = times(rate.at(time), *impulse);
                (Particle { place, velocity, ..*body }, body.yields(force).1, dot(force, velocity))
            }))
        };
        let names: Vec<&str> = pieces.iter().map(|piece| piece.body.name).collect();
        let (start, components) = ((0.0, [0.0; 2]), frame.components.clone());
        let course = self.course(|| rate.course(0.0));
        self.film(&Motion { names: &names, components, start, end, slope: &slope, course: &course, look: &look })?;
        if told.is_none() {
            self.remark("How long the parts push each other is not given: one second is assumed.");
        }
        Ok(())
    }

    fn note_parts(&mut self, stage: &Separate, pieces: &[Pushed<'_>]) {
        self.note_velocities(pieces);
        self.note_pushed(pieces, stage.duration.as_ref());
        // Parts that a force drives apart for a time do not stay where they were.
        for name in stage.into.iter().filter(|_| !stage.lasts()) {
            for axis in self.values.axes() {
                if let Ok(place) = self.values.place_before(stage.from.as_deref().unwrap_or(name), axis) {
                    self.note(&self.values.place_name(name, self.values.index + 2, axis), place, 0.0);
                }
            }
        }
        let energy = |velocity_of: fn(&Pushed<'_>) -> Vector| -> f64 {
            pieces.iter().filter_map(|body| Some(kinetic(body.body.mass?, velocity_of(body)))).sum()
        };
        let (start, end) = (energy(|body| body.body.velocity), energy(|body| body.after));
        self.note_term(stage.energy.as_ref(), end - start, start + end);
    }
}

/// A half wave of so many seconds that makes up one in all.
fn half_wave(end: f64) -> InTime {
    InTime::waves(PI / (2.0 * end), 1.0, end)
}
