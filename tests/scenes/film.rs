//! What a film of a scene shows: whether each of its balances is kept, and how its bodies move at its ends.

use std::collections::BTreeMap;

use momentous::simulate::{Moment, Record};
use momentous::witness::Film;

/// By which share of its size a sum may be off.
const OFF: f64 = 1e-6;

/// How a body moves at an end of the films that show it: its mass, and its velocity along the axes of the scene.
#[derive(Clone, Debug, Default)]
pub struct Moving {
    /// In kg.
    pub mass: f64,
    /// In m/s, by the endings of the names of its components.
    along: BTreeMap<String, f64>,
    /// The kinetic energy where the film has axes of its own, in J.
    energy: Option<f64>,
}

impl Moving {
    /// The kinetic energy in J, where the films show every component of the velocity.
    pub fn energy(&self, endings: &[String]) -> Option<f64> {
        let squares = || endings.iter().map(|ending| Some(self.along.get(ending)?.powi(2))).sum::<Option<f64>>();
        self.energy.or_else(|| Some(self.mass * squares()? / 2.0))
    }

    /// The momentum along an axis in N s.
    pub fn momentum(&self, ending: &str) -> Option<f64> {
        self.along.get(ending).map(|velocity| self.mass * velocity)
    }
}

/// How every body that films of one stage show moves at their start and at their end, in axes with these endings.
pub fn ends<'a>(films: impl Iterator<Item = &'a Film>, endings: &[String]) -> [BTreeMap<String, Moving>; 2] {
    let mut ends = [BTreeMap::<String, Moving>::new(), BTreeMap::new()];
    for film in films {
        let named = film.axes.iter().all(|axis| axis.positive.is_some());
        let ending = |letter: &str| if endings.len() > 1 { format!(".{letter}") } else { String::new() };
        for (end, moment) in ends.iter_mut().zip([film.record.moments.first(), film.record.moments.last()]) {
            let Some(moment) = moment else { continue };
            for (place, body) in film.record.bodies.iter().enumerate() {
                let moving = end.entry(body.name.clone()).or_default();
                let velocity = &moment.velocities[place];
                moving.mass = moment.masses[place];
                if named {
                    let parts = film.axes.iter().zip(velocity);
                    moving.along.extend(parts.map(|(axis, velocity)| (ending(axis.letter), *velocity)));
                } else {
                    moving.energy = Some(moving.mass * size(velocity).powi(2) / 2.0);
                }
            }
        }
    }
    ends
}

/// The largest velocity of a body in a record, in m/s.
pub fn fastest(record: &Record) -> f64 {
    let velocities = record.moments.iter().flat_map(|moment| &moment.velocities);
    velocities.map(|velocity| size(velocity)).fold(0.0, f64::max)
}

fn added(left: &[f64], right: &[f64], share: f64) -> Vec<f64> {
    left.iter().zip(right).map(|(left, right)| left + share * right).collect()
}

fn size(vector: &[f64]) -> f64 {
    vector.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// The momentum of all by their masses and velocities.
fn momentum(moment: &Moment) -> Vec<f64> {
    let zero = vec![0.0; moment.momentum.len()];
    let moving = moment.masses.iter().zip(&moment.velocities);
    moving.fold(zero, |sum, (mass, velocity)| added(&sum, velocity, *mass))
}

/// The size of all momenta, whatever their directions.
fn momenta(moment: &Moment) -> f64 {
    moment.masses.iter().zip(&moment.velocities).map(|(mass, velocity)| mass * size(velocity)).sum()
}

/// The angular momentum of all about the origin, in the plane of two components.
fn turning(moment: &Moment) -> f64 {
    let moving = moment.masses.iter().zip(&moment.positions).zip(&moment.velocities);
    moving.map(|((mass, place), velocity)| mass * (place[0] * velocity[1] - place[1] * velocity[0])).sum()
}

/// The balances that a film does not keep, in words.
pub fn broken(film: &Film) -> Vec<String> {
    let record = &film.record;
    let mut broken = Vec::new();
    let Some(first) = record.moments.first() else { return broken };
    let of_all = |value: &dyn Fn(&Moment) -> f64| record.moments.iter().map(value).fold(0.0, f64::max);
    let pushed = of_all(&momenta) + of_all(&|moment| size(&moment.outside));
    let stored = of_all(&|moment| moment.kinetic + moment.potential.abs() + moment.lost + moment.work.abs());
    let mut say = |what: &str, off: f64, size: f64, time: f64| {
        if off > OFF * size + 1e-12 && broken.iter().all(|fault: &String| !fault.starts_with(what)) {
            broken.push(format!("{what}: off by {off:e} of {size:e} at {time} s"));
        }
    };
    for moment in &record.moments {
        let gained = added(&moment.momentum, &first.momentum, -1.0);
        let given = added(&moment.outside, &first.outside, -1.0);
        let time = moment.time;
        say(
            "the momentum is that of its bodies",
            size(&added(&moment.momentum, &momentum(moment), -1.0)),
            pushed,
            time,
        );
        say("p_2 - p_1 is the impulse from outside", size(&added(&gained, &given, -1.0)), pushed, time);
        say("T_2 - T_1 is the work", (moment.balance() - first.balance()).abs(), stored, time);
        let squares = |(mass, velocity): (&f64, &Vec<f64>)| mass * size(velocity).powi(2) / 2.0;
        let energy: f64 = moment.masses.iter().zip(&moment.velocities).map(squares).sum();
        say("the energy is that of its bodies", (energy - moment.kinetic).abs(), stored, time);
    }
    for moments in record.moments.windows(3) {
        let [one, two, three] = moments else { continue };
        let whole: f64 = one.masses.iter().sum();
        let (step, other) = (two.time - one.time, three.time - two.time);
        if step <= 0.0 || (step - other).abs() > 1e-9 * step || one.masses != three.masses {
            continue;
        }
        // Simpson's rule: exact but for the fourth derivative, and off by a kink at most where there is one.
        let [start, middle, end] =
            [one, two, three].map(|moment| moment.momentum.iter().map(|part| part / whole).collect::<Vec<_>>());
        let bend = size(&added(&added(&start, &middle, -2.0), &end, 1.0));
        let gone = added(&three.centre, &one.centre, -1.0);
        let mean = added(&added(&start, &middle, 4.0), &end, 1.0);
        let off = size(&added(&gone, &mean, -step / 3.0));
        let far = size(&one.centre) + step * size(&start);
        say("the mass centre moves as p / m", (off - step * bend).max(0.0), far, one.time);
        if let ([_], [_, _]) = (&record.bodies[..], &one.momentum[..]) {
            let pushes = [(one, two), (two, three)].map(|(from, to)| {
                let push = added(&to.outside, &from.outside, -1.0);
                let place = added(&from.positions[0], &to.positions[0], 1.0);
                ((place[0] * push[1] - place[1] * push[0]) / 2.0, size(&push))
            });
            let off = turning(three) - turning(one) - pushes[0].0 - pushes[1].0;
            let gone = size(&gone) + step * bend;
            let kink = gone * (pushes[0].1 + pushes[1].1);
            let far = (size(&one.centre) + gone) * pushed;
            say("H_2 - H_1 is the angular impulse", (off.abs() - kink).max(0.0), far, one.time);
        }
    }
    // Where a contact is drawn as seconds, what touches slides along meanwhile.
    let is_as_it_is = film.notes.is_empty();
    let is_alone = record.moments.iter().all(|moment| size(&moment.outside) <= OFF * pushed);
    if is_as_it_is && is_alone && first.momentum.len() == 2 && record.bodies.len() > 1 {
        let arm = of_all(&|moment| moment.positions.iter().map(|place| size(place)).sum());
        for moment in &record.moments {
            let off = (turning(moment) - turning(first)).abs();
            say("H stays where nothing acts from outside", off, arm * pushed, moment.time);
        }
    }
    broken
}
