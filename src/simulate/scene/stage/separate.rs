//! A body that comes apart: some force between its two parts, as strong as the energy, the relative velocity or the velocity
//! of one part says.

use crate::scene::stage::{Relative, Separate, When};

use crate::simulate::scene::bench::{Bench, kinetic, part};
use crate::simulate::scene::direction::unit;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::state::add;
use crate::simulate::scene::touch::{Party, dot};

/// Velocities of both parts after the separation, and the impulse on the first.
pub(super) struct Apart {
    pub velocities: [[f64; 2]; 2],
    pub impulse: [f64; 2],
}

impl Bench<'_> {
    pub(super) fn separate(&mut self, stage: &Separate) -> Result<(), NothingToSimulate> {
        let [first, second] = &stage.into[..] else { return Err(NothingToSimulate::NoMethod) };
        let names = [first.as_str(), second.as_str()];
        let whole = self.values.moving(stage.from.as_deref().unwrap_or(first))?;
        let mut parties = [Party::free(0.0, whole), Party::free(0.0, whole)];
        for (party, name) in parties.iter_mut().zip(names) {
            party.mass = Some(self.values.mass(name)?);
            party.guide = self.values.guide(name).transpose()?;
        }
        let apart = match (&stage.energy, &stage.relative) {
            (Some(energy), _) => self.sprung(parties, self.values.term(energy)?)?,
            (None, Some(relative)) => self.driven(parties, names, relative)?,
            (None, None) => self.parting(parties, names)?,
        };
        self.note_parts(stage, names, parties, &apart);
        self.film_parts(names, parties, apart.impulse)
    }

    /// A spring between the parts, the first behind the second, that holds so much energy.
    fn sprung(&mut self, parties: [Party; 2], energy: f64) -> Result<Apart, NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::NoMethod) };
        let masses = parties.map(|party| party.mass.unwrap_or(1.0));
        let stiffness = masses[0].min(masses[1]);
        let start = [libm::sqrt(2.0 * energy / stiffness), 0.0, 0.0, 0.0];
        let slope = |_: f64, state: &[f64; 4]| {
            let force = stiffness * state[0];
            [state[1] - state[2], -force / masses[0], force / masses[1], force]
        };
        let (_, end) = self.integrator(0.1).event(0.0, start, &slope, &|_, state| state[0])?;
        let along = |speed: f64| unit(axis).map(|own| own * speed);
        let velocities = [add(parties[0].velocity, along(end[1])), add(parties[1].velocity, along(end[2]))];
        Ok(Apart { velocities, impulse: along(-end[3]) })
    }

    /// As strong as one part has to move as seen from the other.
    fn driven(
        &mut self,
        parties: [Party; 2],
        names: [&str; 2],
        relative: &Relative,
    ) -> Result<Apart, NothingToSimulate> {
        let direction = match &relative.direction {
            Some(term) => self.values.direction(&term.0)?,
            None => self.values.axes().first().map_or([1.0, 0.0], |axis| unit(*axis)),
        };
        let speed = self.values.term(&relative.velocity)?;
        let of = usize::from(relative.of == names[1]);
        let wanted = direction.map(|own| own * speed);
        let seen = |apart: &Apart| {
            let from = match relative.when {
                When::After => apart.velocities[1 - of],
                When::Before => parties[1 - of].velocity,
            };
            let own = apart.velocities[of];
            [own[0] - from[0], own[1] - from[1]]
        };
        self.searched(parties, wanted, &seen)
    }

    /// As strong as one part moves afterwards as it is said to.
    fn parting(&mut self, parties: [Party; 2], names: [&str; 2]) -> Result<Apart, NothingToSimulate> {
        let mut missing = NothingToSimulate::ValueMissing;
        for (own, name) in names.into_iter().enumerate() {
            let mut wanted = [0.0; 2];
            let known = self.values.axes().into_iter().try_for_each(|axis| {
                let after = self.values.named(&self.values.velocity_after(name, axis))?;
                wanted = add(wanted, unit(axis).map(|unit| unit * after));
                Ok(())
            });
            match known {
                Ok(()) => return self.searched(parties, wanted, &|apart| apart.velocities[own]),
                Err(reason) => missing = reason,
            }
        }
        Err(missing)
    }

    /// The force between the parts with which something comes out as it is wanted: trials along each axis say how it changes.
    pub(super) fn searched(
        &mut self,
        parties: [Party; 2],
        wanted: [f64; 2],
        seen: &dyn Fn(&Apart) -> [f64; 2],
    ) -> Result<Apart, NothingToSimulate> {
        let axes = self.values.axes();
        let rest = seen(&self.forced(parties, [0.0; 2])?);
        let missing = [wanted[0] - rest[0], wanted[1] - rest[1]];
        // The force in units that change velocities by about as much as is wanted.
        let size = libm::hypot(missing[0], missing[1]) * parties[0].mass.unwrap_or(1.0);
        let mut columns = Vec::new();
        for axis in &axes {
            let end = seen(&self.forced(parties, unit(*axis).map(|own| own * size))?);
            columns.push([(end[0] - rest[0]) / size, (end[1] - rest[1]) / size]);
        }
        let force = match (&columns[..], &axes[..]) {
            _ if size == 0.0 => [0.0; 2],
            ([only], [axis]) => unit(*axis).map(|own| own * part(missing, *axis) / part(*only, *axis)),
            ([x, y], _) => {
                let whole = x[0] * y[1] - y[0] * x[1];
                [(missing[0] * y[1] - y[0] * missing[1]) / whole, (x[0] * missing[1] - missing[0] * x[1]) / whole]
            }
            _ => return Err(NothingToSimulate::Unread),
        };
        if force.iter().any(|own| !own.is_finite()) {
            return Err(NothingToSimulate::NoMethod);
        }
        self.forced(parties, force)
    }

    /// A force on the first part, and its opposite on the second, that rises and falls within a second.
    fn forced(&mut self, parties: [Party; 2], force: [f64; 2]) -> Result<Apart, NothingToSimulate> {
        let [a, b] = parties.map(|party| party.velocity);
        let start = [a[0], a[1], b[0], b[1], 0.0, 0.0];
        let end = self.integrator(0.25).until(0.0, start, 1.0, &|time, _| {
            let now = history(force, time);
            let (one, _) = parties[0].yields(now);
            let (other, _) = parties[1].yields(now.map(|own| -own));
            [one[0], one[1], other[0], other[1], now[0], now[1]]
        })?;
        Ok(Apart { velocities: [[end[0], end[1]], [end[2], end[3]]], impulse: [end[4], end[5]] })
    }

    /// The parts while some force with the impulse that was found drives them apart.
    fn film_parts(
        &mut self,
        names: [&str; 2],
        parties: [Party; 2],
        impulse: [f64; 2],
    ) -> Result<(), NothingToSimulate> {
        let values = self.values;
        let force = impulse.map(|own| own * core::f64::consts::FRAC_PI_2);
        let yielding = |time: f64| {
            let now = history(force, time);
            (now, [parties[0].yields(now), parties[1].yields(now.map(|own| -own))])
        };
        let slope = |time: f64, state: &[f64; 8]| {
            let [one, other] = yielding(time).1.map(|(gained, _)| gained);
            [state[2], state[3], one[0], one[1], state[6], state[7], other[0], other[1]]
        };
        let look = |time: f64, state: &[f64; 8]| {
            let (now, [(_, held), (_, carried)]) = yielding(time);
            let seen = |body: usize| Seen {
                mass: parties[body].mass.unwrap_or(0.0),
                place: values.split([state[4 * body], state[4 * body + 1]]),
                velocity: values.split([state[4 * body + 2], state[4 * body + 3]]),
            };
            Look {
                bodies: vec![seen(0), seen(1)],
                outside: values.split(add(held, carried)),
                power: dot(now, [state[2] - state[6], state[3] - state[7]]),
                ..Look::default()
            }
        };
        let [a, b] = parties.map(|party| party.velocity);
        let start = (0.0, [0.0, 0.0, a[0], a[1], 0.0, 0.0, b[0], b[1]]);
        let components = values.components();
        self.film(&Motion { names: &names, components, start, end: 1.0, slope: &slope, look: &look })?;
        self.remark("How long the parts push each other is not told: it is drawn as one second.");
        Ok(())
    }

    fn note_parts(&mut self, stage: &Separate, names: [&str; 2], parties: [Party; 2], apart: &Apart) {
        let scale = apart.velocities.iter().map(|own| libm::hypot(own[0], own[1])).fold(0.0, f64::max);
        let whole = stage.from.as_deref().unwrap_or(names[0]);
        for ((name, velocity), (party, sign)) in names.iter().zip(apart.velocities).zip(parties.iter().zip([1.0, -1.0]))
        {
            self.note_velocity(name, velocity, scale);
            let impulse = apart.impulse.map(|own| sign * own);
            self.note_impulse(name, impulse, stage.duration.as_ref());
            if let Some([x, y]) = party.guide {
                self.note_here(&format!("R_{name}"), dot([-y, x], party.yields(impulse).1), 0.0);
            }
            for axis in self.values.axes() {
                if let Ok(place) = self.values.place_before(whole, axis) {
                    self.note(&self.values.place_name(name, self.values.index + 2, axis), place, 0.0);
                }
            }
        }
        let masses = parties.map(|party| party.mass.unwrap_or(0.0));
        let before = [0, 1].map(|own| (masses[own], parties[own].velocity));
        let after = [0, 1].map(|own| (masses[own], apart.velocities[own]));
        self.note_energy(&before, &after);
        let [start, end]: [f64; 2] =
            [before, after].map(|all| all.into_iter().map(|(mass, velocity)| kinetic(mass, velocity)).sum());
        self.note_term(stage.energy.as_ref(), end - start, start + end);
    }
}

/// A force at a time of the second within which it rises and falls.
fn history(most: [f64; 2], time: f64) -> [f64; 2] {
    most.map(|own| own * libm::sin(core::f64::consts::PI * time))
}
