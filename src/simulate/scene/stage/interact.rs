//! Bodies that act on each other only: springs between them, which stand for whatever the forces are.

use crate::scene::stage::Interact;

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::measure::{Asked, centre, place, turning, velocity};
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::vector::{Vector, ZERO, add, cross, dot, less, part, size, times, within};

/// The most bodies.
const MOST: usize = 4;

/// Places and velocities of all bodies.
type State = [f64; 6 * MOST];

/// For how long they are looked at, in units of the time in which they pass each other.
const WATCHED: f64 = 2.0;

fn vector(state: &State, at: usize) -> Vector {
    within(state, 3 * at)
}

fn put(state: &mut State, at: usize, vector: Vector) {
    state[3 * at..3 * at + 3].copy_from_slice(&vector);
}

impl Bench<'_> {
    pub(super) fn interact(&mut self, stage: &Interact) -> Result<(), NothingToSimulate> {
        let bodies: Vec<&str> = stage.between.iter().map(String::as_str).collect();
        if bodies.len() > MOST {
            return Err(NothingToSimulate::NoMethod);
        }
        let (mut masses, mut start, mut fast) = (Vec::new(), [0.0; 6 * MOST], 0.0);
        let placed: Result<Vec<Vector>, _> = bodies.iter().map(|body| place(self.values, body)).collect();
        for (own, body) in bodies.iter().enumerate() {
            masses.push(self.values.mass(body)?);
            // Where no places are used, they stand in a row.
            #[allow(clippy::cast_precision_loss, reason = "a handful of bodies")]
            let at = placed.as_ref().map_or([own as f64, 0.0, 0.0], |placed| placed[own]);
            put(&mut start, own, at);
            let moves = velocity(self.values, body)?;
            fast = size(moves).max(fast);
            put(&mut start, MOST + own, moves);
        }
        let apart = |state: &State, one: usize, other: usize| less(vector(state, other), vector(state, one));
        let wide = (1..bodies.len()).map(|other| size(apart(&start, 0, other))).fold(0.0, f64::max);
        if wide == 0.0 || fast == 0.0 {
            return Err(NothingToSimulate::ValueMissing);
        }
        let stiffness = masses.iter().fold(f64::INFINITY, |least, own| own.min(least)) * (fast / wide) * (fast / wide);
        let slope = |_: f64, state: &State| {
            let mut slope = [0.0; 6 * MOST];
            for (one, mass) in masses.iter().enumerate() {
                put(&mut slope, one, vector(state, MOST + one));
                let pulls = (0..bodies.len()).filter(|other| *other != one);
                let force = pulls.fold(ZERO, |all, other| add(all, times(stiffness, apart(state, one, other))));
                put(&mut slope, MOST + one, times(1.0 / mass, force));
            }
            slope
        };
        let time = WATCHED * wide / fast;
        let end = self.integrator(time / 32.0).until(0.0, start, time, &slope)?;
        let values = self.values;
        let look = |_: f64, state: &State| {
            let seen = masses.iter().enumerate().map(|(own, mass)| Seen {
                mass: *mass,
                place: values.frame().split(vector(state, own)),
                velocity: values.frame().split(vector(state, MOST + own)),
            });
            let pairs = (1..bodies.len()).flat_map(|one| (0..one).map(move |other| (one, other)));
            let stretched = pairs.map(|(one, other)| apart(state, one, other)).map(|own| dot(own, own));
            Look {
                bodies: seen.collect(),
                outside: vec![0.0; values.axes().len()],
                potential: stiffness * stretched.sum::<f64>() / 2.0,
                ..Look::default()
            }
        };
        let (names, components) = (&bodies[..], values.frame().components);
        self.film(&Motion { names, components, start: (0.0, start), end: time, slope: &slope, look: &look })?;
        self.remark("The forces between the bodies are not given: they are replaced by springs between all bodies.");
        let momenta: Vec<Vector> = (0..bodies.len()).map(|own| times(masses[own], vector(&end, MOST + own))).collect();
        let total = momenta.iter().fold(ZERO, |all, own| add(all, *own));
        let scale = momenta.iter().map(|own| size(*own)).fold(0.0, f64::max);
        let instant = self.values.index + 2;
        for axis in self.values.axes() {
            let letter = if self.values.axes().len() > 1 { format!(".{}", axis.letter()) } else { String::new() };
            self.note_sum(&format!("p_{instant}{letter}"), part(total, axis), scale);
        }
        let inside: Vec<&str> = bodies.iter().flat_map(|body| values.scene.members(body)).collect();
        let is_all = values.scene.bodies.keys().all(|body| inside.contains(&body.as_str()));
        if placed.is_err() {
            return Ok(());
        }
        for point in self.values.scene.points.keys() {
            let Some(seen) = centre(self.values, &bodies, point, &|_| None) else { continue };
            let moments =
                momenta.iter().enumerate().map(|(own, momentum)| cross(less(vector(&end, own), seen), *momentum));
            let all = moments.fold(ZERO, add);
            let letters: &[Option<&str>] = match self.values.axes().len() {
                2 => &[None],
                3 => &[Some("x"), Some("y"), Some("z")],
                _ => &[],
            };
            for component in letters {
                let asked = Asked { base: "H", subject: point, instant, component: *component };
                let letter = component.map_or_else(String::new, |letter| format!(".{letter}"));
                if let Some(moment) = turning(self.values, asked, all) {
                    let name = format!("H_{point}{instant}{letter}");
                    if is_all {
                        self.note(&name, moment, wide * scale);
                    }
                    self.note_sum(&name, moment, wide * scale);
                }
            }
        }
        Ok(())
    }
}
