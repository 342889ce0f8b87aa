//! A motion that is given: walked along as the author wrote it, with what acts on the body read off how its velocity changes.

use std::sync::Arc;

use momentous_scene::Axis;
use momentous_scene::stage::Motion;

use crate::scene::filming::Motion as Watched;
use crate::scene::formula::{BY_PLACE, Course, GIVEN, STRENGTH};
use crate::scene::in_time::{Law, OfTime};
use crate::scene::measure::place;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::rate::{Rate, rate};
use crate::scene::recorded_motion::{Look, SeenBody};
use crate::scene::stage_run::StageRun;
use crate::scene::values::{OfSeveral, Values};
use crate::scene::vector::{Vector, ZERO, add, dot, less, part, size, times, unit, within};

/// The share of the time of the motion over which rates of change are looked at: the steps of a difference of differences have to
/// be wider, or rounding is all that is left.
const SOON: [f64; 2] = [1e-3, 1e-2];

/// The steps in which it is walked along, at least.
const STEPS: f64 = 64.0;

/// The given part of a motion.
struct GivenMotion {
    /// Along each axis, as a function of the clock and the place along the only axis.
    courses: Vec<(Axis, OfSeveral)>,
    /// The same as laws of the time, where no place matters.
    laws: Vec<(Axis, Option<Law>)>,
    /// Whether it is the position that is given, and not the velocity.
    places: bool,
    start: f64,
    end: f64,
}

impl GivenMotion {
    fn read(values: &Values<'_>, stage: &Motion, [start, end]: [f64; 2]) -> Result<Self, NothingToSimulate> {
        let axes = values.axes();
        let told = stage.velocity.as_ref().or(stage.position.as_ref()).ok_or(NothingToSimulate::ValueMissing)?;
        let course = |axis: &Axis| -> Result<(Axis, OfSeveral), NothingToSimulate> {
            let term = told.along(*axis, axes.len()).ok_or(NothingToSimulate::ValueMissing)?;
            // With several axes a letter is no variable.
            let variables = ["t", axis.letter()].map(str::to_owned);
            let known = if axes.len() == 1 { &variables[..] } else { &variables[..1] };
            Ok((*axis, values.of_several(&term.0, known)?))
        };
        let courses = axes.iter().map(course).collect::<Result<_, _>>()?;
        let law = |axis: &Axis| (*axis, told.along(*axis, axes.len()).and_then(|term| values.law(term).ok()));
        let laws = axes.iter().map(law).collect();
        Ok(Self { courses, laws, places: stage.velocity.is_none(), start, end })
    }

    /// The given vector, at a time and a place.
    fn at(&self, time: f64, at: Vector) -> Vector {
        let along = |(axis, course): &(Axis, OfSeveral)| times(course(&[time, part(at, *axis)]), unit(*axis));
        self.courses.iter().map(along).fold(ZERO, add)
    }

    /// The places from a first one on.
    fn course(&self, first: Vector) -> Course<3> {
        let mut along: Vec<(Axis, OfTime)> = Vec::new();
        for (axis, told) in &self.laws {
            let (start, from) = (self.start, part(first, *axis));
            let Some(law) = told else { return Course::Equations(BY_PLACE) };
            if self.places {
                along.push((*axis, Arc::clone(&law.at)));
            } else {
                let Some(sums) = law.integrals_since(start) else { return Course::Equations(STRENGTH) };
                along.push((*axis, Arc::new(move |now| from + sums(now - start)[0])));
            }
        }
        Course::formula(GIVEN, move |now| along.iter().map(|(axis, law)| times(law(now), unit(*axis))).fold(ZERO, add))
    }

    /// Over how much time a rate of change is looked at: never beyond the ends of the motion.
    fn width(&self, time: f64) -> f64 {
        let width = SOON[usize::from(self.places)] * (self.end - self.start);
        if time > f64::midpoint(self.start, self.end) { -width } else { width }
    }

    fn velocity(&self, time: f64, at: Vector) -> Rate {
        if self.places {
            return sure(rate(self.width(time), |later| Ok(self.at(time + later, at))));
        }
        Rate { value: self.at(time, at), off: 0.0 }
    }

    fn acceleration(&self, time: f64, at: Vector) -> Rate {
        // How the path bends does not enter the first change of the velocity.
        let moving = self.velocity(time, at).value;
        let soon = |later: f64| self.velocity(time + later, add(at, times(later, moving)));
        let rate = sure(rate(self.width(time), |later| Ok(soon(later).value)));
        Rate { off: rate.off + 8.0 * soon(0.0).off / self.width(time).abs(), ..rate }
    }
}

/// Takes the value of a rate that cannot fail.
fn sure(rate: Result<Rate, core::convert::Infallible>) -> Rate {
    let Ok(rate) = rate;
    rate
}

impl StageRun<'_> {
    pub(super) fn motion(&mut self, stage: &Motion) -> Result<(), NothingToSimulate> {
        let (body, index) = (stage.body.as_str(), self.values.index);
        let [start, end] = self.during(stage.during.as_ref())?;
        let told = GivenMotion::read(self.values, stage, [start, end])?;
        let from = place(self.values, body);
        let first = if told.places { told.at(start, ZERO) } else { from.unwrap_or(ZERO) };
        let integrator = self.integrator((end - start) / STEPS);
        let last = if told.places {
            told.at(end, ZERO)
        } else {
            integrator.until(start, first, end, &|time, at: &Vector| told.at(time, *at))?
        };
        let ends =
            [(start, first), (end, last)].map(|(time, at)| (told.velocity(time, at), told.acceleration(time, at)));
        let [(before, _), (after, _)] = ends;
        if !size(add(last, add(before.value, after.value))).is_finite() {
            return Err(NothingToSimulate::NoMethod);
        }
        for (instant, (velocity, acceleration)) in [index + 1, index + 2].into_iter().zip(ends) {
            self.note_rate(&format!("v_{body}{instant}"), velocity, 1.0);
            if instant == index + 1 && self.values.scene.follows_a_push(index, body) {
                continue;
            }
            self.note_rate(&format!("a_{body}{instant}"), acceleration, 1.0);
            if let Ok(mass) = self.values.mass(body) {
                self.note_rate(&format!("F_{body}{instant}"), acceleration, mass);
            }
        }
        if told.places {
            self.note_rate(&format!("r_{body}{}", index + 1), Rate { value: first, off: 0.0 }, 1.0);
        }
        if told.places || from.is_ok() {
            self.note_rate(&format!("r_{body}{}", index + 2), Rate { value: last, off: 0.0 }, 1.0);
        }
        if let Ok(mass) = self.values.mass(body) {
            let impulse = times(mass, less(after.value, before.value));
            let scale = mass * (before.off + after.off) / self.tolerance;
            self.note_vector_of(&format!("J_{body}"), impulse, scale);
            let mean = times(1.0 / (end - start), impulse);
            self.note_vector_of(&format!("F_avg_{body}"), mean, scale / (end - start));
        }
        self.note_duration(None, end - start);
        self.film_motion(body, &told, first)
    }

    /// Notes a vector by its components, none of which may be further off than it says.
    fn note_rate(&mut self, name: &str, Rate { value, off }: Rate, factor: f64) {
        for axis in self.values.axes() {
            let letter = self.values.letter(axis);
            let scale = factor * (size(value) + off / self.tolerance);
            self.note(&format!("{name}{letter}"), factor * part(value, axis), scale);
        }
    }

    fn film_motion(&mut self, body: &str, told: &GivenMotion, first: Vector) -> Result<(), NothingToSimulate> {
        let (values, mass) = (self.values, self.values.any_mass(body));
        let slope = |time: f64, at: &[f64; 3]| told.velocity(time, *at).value;
        let look = |time: f64, state: &[f64; 3]| {
            let at = within(state, 0);
            let (moving, force) = (told.velocity(time, at).value, times(mass, told.acceleration(time, at).value));
            Look {
                bodies: vec![SeenBody {
                    mass,
                    place: values.frame().split(at),
                    velocity: values.frame().split(moving),
                }],
                outside: values.frame().split(force),
                power: dot(force, moving),
                ..Look::default()
            }
        };
        let (names, components, start) = (&[body], values.frame().components, (told.start, first));
        let course = &self.course(|| told.course(first));
        self.film(&Watched { names, components, start, end: told.end, slope: &slope, course, look: &look })
    }
}
