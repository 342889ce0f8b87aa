//! A blow: some force for some short time, whose history nobody knows. Any history with the impulse does the same.

use core::f64::consts::PI;

use crate::scene::Axis;
use crate::scene::stage::Blow;

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::vector::{Vector, ZERO, add, dot, part, size, times, unit, within};

impl Bench<'_> {
    pub(super) fn blow(&mut self, stage: &Blow) -> Result<(), NothingToSimulate> {
        let body = stage.body.as_str();
        let mass = self.values.mass(body)?;
        let before = self.values.moving(body)?;
        let weight = self.weight_in_contact(mass, &stage.include, stage.duration.as_ref())?;
        let (mut after, mut impulse, mut force) = (ZERO, ZERO, ZERO);
        for axis in self.values.axes() {
            let start = part(before, axis) + part(weight, axis) / mass;
            let strength = self.strength(body, axis, mass, start)?;
            let [velocity, given] = self.struck(mass, start, strength)?;
            after = add(after, times(velocity, unit(axis)));
            impulse = add(impulse, times(given, unit(axis)));
            force = add(force, times(strength, unit(axis)));
        }
        self.film_blow(body, mass, before, force)?;
        self.note_velocity(body, after, size(before));
        self.note_impulse(body, impulse, stage.duration.as_ref());
        Ok(())
    }

    fn film_blow(&mut self, body: &str, mass: f64, before: Vector, force: Vector) -> Result<(), NothingToSimulate> {
        let (values, end) = (self.values, 1.0 / self.shorter);
        let now = |time: f64| times(libm::sin(PI * time / end), force);
        let slope = |time: f64, &[_, _, _, u, v, w]: &[f64; 6]| {
            let [x, y, z] = times(1.0 / mass, now(time));
            [u, v, w, x, y, z]
        };
        let look = |time: f64, state: &[f64; 6]| Look {
            bodies: vec![Seen {
                mass,
                place: values.frame().split(within(state, 0)),
                velocity: values.frame().split(within(state, 3)),
            }],
            outside: values.frame().split(now(time)),
            power: dot(now(time), within(state, 3)),
            ..Look::default()
        };
        let [u, v, w] = before;
        let (names, components, start) = (&[body], values.frame().components, (0.0, [0.0, 0.0, 0.0, u, v, w]));
        self.film(&Motion { names, components, start, end, slope: &slope, look: &look })?;
        self.remark("How the force varies is not given: it is drawn as half a sine wave of one second.");
        Ok(())
    }

    /// How strong the blow has to be along an axis for the velocity or the impulse that is given; a blow of 1 N says how much
    /// comes of it.
    fn strength(&mut self, body: &str, axis: Axis, mass: f64, start: f64) -> Result<f64, NothingToSimulate> {
        let [gained, given] = self.struck(mass, 0.0, 1.0)?;
        let letter = if self.values.axes().len() > 1 { format!(".{}", axis.letter()) } else { String::new() };
        let told = self.values.named(&format!("J_{body}{letter}{}", self.values.suffix()));
        match (told, self.values.named(&self.values.velocity_after(body, axis))) {
            (_, Ok(after)) => Ok((after - start) / gained),
            (Ok(impulse), Err(_)) => Ok(impulse / given),
            (Err(missing), Err(_)) => Err(missing),
        }
    }

    /// Velocity and impulse after half a wave of force, for a second if nothing says that it is shorter.
    fn struck(&mut self, mass: f64, start: f64, strength: f64) -> Result<[f64; 2], NothingToSimulate> {
        let end = 1.0 / self.shorter;
        let integrator = self.integrator(end / 4.0);
        integrator.until(0.0, [start, 0.0], end, &|time, _| {
            let force = strength * libm::sin(PI * time / end);
            [force / mass, force]
        })
    }
}
