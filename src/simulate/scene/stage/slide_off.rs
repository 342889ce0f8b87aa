//! A body that slides from rest down another, which gives way along its guide: both held together by the force between them.

use core::f64::consts::FRAC_PI_2;

use crate::scene::stage::SlideOff;

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::integrate::Slope;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::touch::Party;
use crate::simulate::scene::vector::{Vector, ZERO, across, add, cross, dot, less, size, times, turned};

impl Bench<'_> {
    pub(super) fn slide_off(&mut self, stage: &SlideOff) -> Result<(), NothingToSimulate> {
        let [body, on] = [stage.body.as_str(), stage.on.as_str()];
        let weight = self.values.falling()?;
        let gravity = size(weight);
        let height = self.values.term(&stage.height)?;
        let down = times(1.0 / gravity, weight);
        let end = self.values.direction(&stage.direction.0)?;
        // A face that ends level has to start steep: a quarter of a circle. Any other is straight.
        let bend = if dot(end, down) > f64::EPSILON { 0.0 } else { 1.0 / height };
        let start = if bend == 0.0 { end } else { down };
        let turn = cross(down, end)[2].signum();
        let party = |body: &str, guide| -> Result<Party, NothingToSimulate> {
            Ok(Party { mass: Some(self.values.mass(body)?), velocity: ZERO, guide })
        };
        let slider = party(body, None)?;
        let carrier = party(on, self.values.guide(on).transpose()?)?;
        let [own, other] = [slider.mass.unwrap_or(1.0), carrier.mass.unwrap_or(1.0)];
        let face = |way: f64| turned(start, turn * bend * way);
        // The way along the face and the speed along it, how far the body has sunk, and both velocities.
        let slope = |_: f64, state: &[f64; 7]| {
            let (way, speed) = (state[0], state[1]);
            let along = face(way);
            let out = across(along);
            let curved = turn * bend * speed * speed;
            // How the acceleration across the face, as seen from it, depends on the force between both: tried with 0 and 1 N.
            let pushed = |force: f64| {
                let push = times(force, out);
                let mine = add(weight, times(1.0 / own, push));
                let load = less(times(other, weight), push);
                let (its, _) = carrier.yields(load);
                (mine, its, less(mine, its))
            };
            let [free, tried] = [0.0, 1.0].map(|force| dot(pushed(force).2, out) - curved);
            let (mine, its, seen) = pushed(free / (free - tried));
            [speed, dot(seen, along), dot([state[3], state[4], 0.0], down), mine[0], mine[1], its[0], its[1]]
        };
        let integrator = self.integrator(0.1 * libm::sqrt(height / gravity));
        let (time, end) = integrator.event(0.0, [0.0; 7], &slope, &|_, state| {
            // What is left to sink; where the face ends level, what is left of the quarter of a circle.
            if bend == 0.0 { height - state[2] } else { FRAC_PI_2 / bend - state[0] }
        })?;
        self.film_pair([body, on], [own, other], (time, &slope), &|load| carrier.yields(load).1, weight)?;
        let scale = libm::sqrt(gravity * height);
        self.note_velocity(body, [end[3], end[4], 0.0], scale);
        self.note_velocity(on, [end[5], end[6], 0.0], scale);
        for name in [body, on] {
            for axis in self.values.axes() {
                self.note(&self.values.start_name(name, axis), 0.0, 0.0);
            }
        }
        self.note_duration(None, time);
        Ok(())
    }

    /// Both bodies from where they start; what holds the carrier up on its guide acts from outside.
    fn film_pair(
        &mut self,
        names: [&str; 2],
        masses: [f64; 2],
        (end, slope): (f64, Slope<'_, 7>),
        held: &dyn Fn(Vector) -> Vector,
        weight: Vector,
    ) -> Result<(), NothingToSimulate> {
        let values = self.values;
        let all = |time: f64, state: &[f64; 11]| {
            let inner = slope(time, &core::array::from_fn(|place| state[place]));
            let mut all = [0.0; 11];
            all[..7].copy_from_slice(&inner);
            all[7..].copy_from_slice(&state[3..7]);
            all
        };
        let look = |time: f64, state: &[f64; 11]| {
            let changes = all(time, state);
            let push = times(masses[0], less([changes[3], changes[4], 0.0], weight));
            let reaction = held(less(times(masses[1], weight), push));
            let place = |body: usize| [state[7 + 2 * body], state[8 + 2 * body], 0.0];
            let fallen = [0, 1].map(|body| masses[body] * dot(place(body), weight));
            Look {
                bodies: (0..2)
                    .map(|body| Seen {
                        mass: masses[body],
                        place: values.frame().split(place(body)),
                        velocity: values.frame().split([state[3 + 2 * body], state[4 + 2 * body], 0.0]),
                    })
                    .collect(),
                outside: values.frame().split(add(reaction, times(masses[0] + masses[1], weight))),
                potential: -fallen[0] - fallen[1],
                ..Look::default()
            }
        };
        let (names, components, start) = (&names, values.frame().components, (0.0, [0.0; 11]));
        self.film(&Motion { names, components, start, end, slope: &all, look: &look })?;
        self.remark("Each position is measured from the starting point of its body.");
        Ok(())
    }
}
