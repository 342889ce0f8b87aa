//! A body that comes apart: some force between its parts, as strong as the energy, the relative velocity or the velocities
//! afterwards say.

use core::f64::consts::PI;
use std::sync::Arc;

use nalgebra::Matrix3;
use nalgebra::Vector3;

use crate::scene::stage::{Relative, Separate, When};

use crate::simulate::scene::bench::{Bench, kinetic};
use crate::simulate::scene::course::Until;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::particles::{Force, Particle, System, place, velocity};
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::vector::{Vector, ZERO, across, add, dot, less, size, times, unit};

/// The longest step beside the second that a force between parts takes.
const LONGEST: f64 = 0.25;

/// Velocities of both parts after the separation, and the impulse on the first.
pub(super) struct Apart {
    pub velocities: [Vector; 2],
    pub impulse: Vector,
}

/// A part, before and after.
struct Piece<'a> {
    party: Particle<'a>,
    after: Vector,
    impulse: Vector,
}

impl Bench<'_> {
    pub(super) fn separate(&mut self, stage: &Separate) -> Result<(), NothingToSimulate> {
        let first = stage.into.first().ok_or(NothingToSimulate::NoStage)?;
        let whole = self.values.moving(stage.from.as_deref().unwrap_or(first))?;
        let mut pieces = Vec::new();
        for name in &stage.into {
            let party = Particle {
                guide: self.values.guide(name).transpose()?,
                ..Particle::free(name, self.values.mass(name)?, whole)
            };
            pieces.push(Piece { party, after: whole, impulse: ZERO });
        }
        match (&stage.energy, &stage.relative, &mut pieces[..]) {
            (Some(energy), _, [one, other]) => {
                let energy = self.values.term(energy)?;
                let apart = self.sprung([one.party, other.party], energy)?;
                push_apart(one, other, &apart);
            }
            (None, Some(relative), [one, other]) => {
                let apart = self.driven([one.party, other.party], relative)?;
                push_apart(one, other, &apart);
            }
            (None, None, pieces) => self.parting(pieces)?,
            _ => return Err(NothingToSimulate::NoMethod),
        }
        self.note_parts(stage, &pieces);
        self.film_parts(&pieces)
    }

    /// A spring between the parts, the first behind the second, that holds so much energy.
    fn sprung(&mut self, parties: [Particle<'_>; 2], energy: f64) -> Result<Apart, NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::NoMethod) };
        let along = unit(axis);
        let stiffness = parties.iter().filter_map(|party| party.mass).fold(f64::INFINITY, f64::min);
        let pressed = libm::sqrt(2.0 * energy / stiffness);
        let spring = Force::spring(vec![(0, along), (1, times(-1.0, along))], stiffness, pressed);
        let left = |state: &[f64; 13]| pressed + dot(along, less(place(state, 0), place(state, 1)));
        self.pushed_apart(parties, spring, along, &Until::Event(&left))
    }

    /// As strong as one part has to move as seen from the other.
    fn driven(&mut self, parties: [Particle<'_>; 2], relative: &Relative) -> Result<Apart, NothingToSimulate> {
        let direction = self.values.towards(relative.direction.as_ref())?;
        let speed = self.values.term(&relative.velocity)?;
        let of = usize::from(relative.of == parties[1].name);
        let seen = |apart: &Apart| {
            let from = match relative.when {
                When::After => apart.velocities[1 - of],
                When::Before => parties[1 - of].velocity,
            };
            less(apart.velocities[of], from)
        };
        self.searched(parties, times(speed, direction), &seen)
    }

    /// All but one are pushed off that one, each as strongly as it moves afterwards as it is said to.
    fn parting(&mut self, pieces: &mut [Piece<'_>]) -> Result<(), NothingToSimulate> {
        let mut missing = NothingToSimulate::ValueMissing;
        let mut told = Vec::new();
        for piece in pieces.iter() {
            let after = self.values.axes().into_iter().try_fold(ZERO, |all, axis| {
                let after = self.values.named(&self.values.velocity_after(piece.party.name, axis))?;
                Ok(add(all, times(after, unit(axis))))
            });
            told.push(after.map_err(|reason| missing = reason).ok());
        }
        // Nothing is said of the one that is left, or it is the last.
        let rest = told.iter().position(Option::is_none).or(told.len().checked_sub(1)).ok_or(missing)?;
        let [before @ .., last] = pieces else { return Err(missing) };
        told.swap(rest, before.len());
        if let Some(own) = before.get_mut(rest) {
            std::mem::swap(own, last);
        }
        for (piece, wanted) in before.iter_mut().zip(told) {
            fn now<'a>(piece: &Piece<'a>) -> Particle<'a> {
                Particle { velocity: piece.after, ..piece.party }
            }
            let apart = self.searched([now(piece), now(last)], wanted.ok_or(missing)?, &|apart| apart.velocities[0])?;
            push_apart(piece, last, &apart);
        }
        Ok(())
    }

    /// The force between the parts with which something comes out as it is wanted: trials along each axis say how it changes.
    pub(super) fn searched(
        &mut self,
        parties: [Particle<'_>; 2],
        wanted: Vector,
        seen: &dyn Fn(&Apart) -> Vector,
    ) -> Result<Apart, NothingToSimulate> {
        let rest = seen(&self.forced(parties, ZERO)?);
        let missing = less(wanted, rest);
        // The force in units that change velocities by about as much as is wanted.
        let size = size(missing) * parties[0].mass.unwrap_or(1.0);
        if size == 0.0 {
            return self.forced(parties, ZERO);
        }
        let mut answers = Matrix3::identity();
        for axis in self.values.axes() {
            let end = seen(&self.forced(parties, times(size, unit(axis)))?);
            answers.set_column(axis as usize, &Vector3::from(times(1.0 / size, less(end, rest))));
        }
        let force = answers.lu().solve(&Vector3::from(missing)).ok_or(NothingToSimulate::NoMethod)?;
        self.forced(parties, force.into())
    }

    /// A force on the first part, and its opposite on the second, that rises and falls within a second.
    fn forced(&mut self, parties: [Particle<'_>; 2], force: Vector) -> Result<Apart, NothingToSimulate> {
        let lines = vec![(0, force), (1, times(-1.0, force))];
        let wave = Force::in_time(lines, Arc::new(|time| libm::sin(PI * time)));
        self.pushed_apart(parties, wave, force, &Until::Time(1.0))
    }

    /// Both parts when a force between them, along a vector, has done what it does.
    fn pushed_apart(
        &mut self,
        parties: [Particle<'_>; 2],
        force: Force,
        along: Vector,
        until: &Until<'_, 13>,
    ) -> Result<Apart, NothingToSimulate> {
        let system = System { forces: vec![force], ..System::new(self.values.frame(), parties.to_vec()) };
        let integrator = self.integrator(LONGEST);
        let end = self.try_out(&system, integrator, until)?.state;
        Ok(Apart { velocities: [0, 1].map(|own| velocity(&end, own)), impulse: times(end[12], along) })
    }

    /// The parts while some force with the impulse that was found drives them apart: half a wave of one second.
    fn film_parts(&mut self, pieces: &[Piece<'_>]) -> Result<(), NothingToSimulate> {
        let values = self.values;
        let look = |time: f64, _: &[f64; 0]| {
            let phase = PI * time;
            let (gained, gone) = ((1.0 - libm::cos(phase)) / 2.0, (time - libm::sin(phase) / PI) / 2.0);
            let (mut bodies, mut outside, mut power) = (Vec::new(), ZERO, 0.0);
            for Piece { party, impulse, .. } in pieces {
                let (change, _) = party.yields(*impulse);
                let force = times(libm::sin(phase) * PI / 2.0, *impulse);
                let velocity = add(party.velocity, times(gained, change));
                let place = add(times(time, party.velocity), times(gone, change));
                outside = add(outside, party.yields(force).1);
                power += dot(force, velocity);
                let mass = party.mass.unwrap_or(0.0);
                bodies.push(Seen {
                    mass,
                    place: values.frame().split(place),
                    velocity: values.frame().split(velocity),
                });
            }
            Look { bodies, outside: values.frame().split(outside), power, ..Look::default() }
        };
        let names: Vec<&str> = pieces.iter().map(|piece| piece.party.name).collect();
        let (start, components) = ((0.0, []), values.frame().components);
        self.film(&Motion { names: &names, components, start, end: 1.0, slope: &|_, _| [], look: &look })?;
        self.remark("How long the parts push each other is not given: one second is assumed.");
        Ok(())
    }

    fn note_parts(&mut self, stage: &Separate, pieces: &[Piece<'_>]) {
        let scale = pieces.iter().map(|piece| size(piece.after)).fold(0.0, f64::max);
        for Piece { party, after, impulse } in pieces {
            let name = party.name;
            self.note_velocity(name, *after, scale);
            self.note_impulse(name, *impulse, stage.duration.as_ref());
            if let Some(along) = party.guide {
                self.note_here(&format!("R_{name}"), dot(across(along), party.yields(*impulse).1), 0.0);
            }
            for axis in self.values.axes() {
                if let Ok(place) = self.values.place_before(stage.from.as_deref().unwrap_or(name), axis) {
                    self.note(&self.values.place_name(name, self.values.index + 2, axis), place, 0.0);
                }
            }
        }
        let mass = |piece: &Piece<'_>| piece.party.mass.unwrap_or(0.0);
        let before: Vec<_> = pieces.iter().map(|piece| (mass(piece), piece.party.velocity)).collect();
        let after: Vec<_> = pieces.iter().map(|piece| (mass(piece), piece.after)).collect();
        self.note_energy(&before, &after);
        let [start, end] =
            [before, after].map(|all| all.into_iter().map(|(mass, velocity)| kinetic(mass, velocity)).sum::<f64>());
        self.note_term(stage.energy.as_ref(), end - start, start + end);
    }
}

/// Lets two parts go on as they were pushed.
fn push_apart(one: &mut Piece<'_>, other: &mut Piece<'_>, apart: &Apart) {
    [one.after, other.after] = apart.velocities;
    one.impulse = add(one.impulse, apart.impulse);
    other.impulse = less(other.impulse, apart.impulse);
}
