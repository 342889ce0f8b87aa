//! A blow: some force for some short time, whose history nobody knows. Any history with the impulse does the same.

use core::f64::consts::PI;

use crate::scene::Axis;
use crate::scene::stage::Blow;

use crate::simulate::scene::bench::{Bench, part};
use crate::simulate::scene::direction::unit;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::state::add;
use crate::simulate::scene::touch::dot;

impl Bench<'_> {
    pub(super) fn blow(&mut self, stage: &Blow) -> Result<(), NothingToSimulate> {
        let body = stage.body.as_str();
        let mass = self.values.mass(body)?;
        let before = self.values.moving(body)?;
        let (mut after, mut impulse, mut force) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        for axis in self.values.axes() {
            let start = part(before, axis);
            let strength = self.strength(body, axis, mass, start)?;
            let [velocity, given] = self.struck(mass, start, strength)?;
            after = add(after, unit(axis).map(|own| own * velocity));
            impulse = add(impulse, unit(axis).map(|own| own * given));
            force = add(force, unit(axis).map(|own| own * strength));
        }
        self.film_blow(body, mass, before, force)?;
        self.note_velocity(body, after, before[0].abs() + before[1].abs());
        self.note_impulse(body, impulse, stage.duration.as_ref());
        Ok(())
    }

    fn film_blow(&mut self, body: &str, mass: f64, [u, v]: [f64; 2], force: [f64; 2]) -> Result<(), NothingToSimulate> {
        let (values, end) = (self.values, 1.0 / self.shorter);
        let now = |time: f64| force.map(|own| own * libm::sin(PI * time / end));
        let slope = |time: f64, state: &[f64; 4]| {
            let now = now(time);
            [state[2], state[3], now[0] / mass, now[1] / mass]
        };
        let look = |time: f64, &[x, y, u, v]: &[f64; 4]| Look {
            bodies: vec![Seen { mass, place: values.split([x, y]), velocity: values.split([u, v]) }],
            outside: values.split(now(time)),
            power: dot(now(time), [u, v]),
            ..Look::default()
        };
        let (names, components, start) = (&[body], values.components(), (0.0, [0.0, 0.0, u, v]));
        self.film(&Motion { names, components, start, end, slope: &slope, look: &look })?;
        self.remark("How the force goes on is not told: it is drawn as half a wave of one second.");
        Ok(())
    }

    /// How strong the blow has to be along an axis for the velocity or the impulse that is told; a blow of 1 N says how much
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
