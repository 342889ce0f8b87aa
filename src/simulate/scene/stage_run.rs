//! Benches on which a stage is simulated: its numbers, how finely, and what has been found.

use core::cell::Cell;

use momentous_scene::Term;
use momentous_scene::stage::Included;

use super::experiment::{Reached, Staged};
use super::formula::Course;
use super::integrate::Integrator;
use super::nothing::NothingToSimulate;
use super::recorded_motion::RecordedMotion;
use super::values::Values;
use super::vector::{Vector, ZERO, add, dot, part, size, times, unit};

/// By which way a stage was simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Procedure {
    /// Exact motion between exactly located impacts.
    EventDriven,
    /// Newton's second law integrated in time.
    Integrated,
    /// A contact that lasts, as a spring that gives back less than it took.
    Contact,
    /// Droplets, one after another.
    Droplets,
    /// The mean of places, and the area that radii sweep, in free motion.
    Measured,
}

impl Procedure {
    /// Its name in a report.
    #[must_use]
    pub fn called(self) -> &'static str {
        match self {
            Self::EventDriven => "event driven",
            Self::Integrated => "integration in time",
            Self::Contact => "a contact as a spring",
            Self::Droplets => "droplets",
            Self::Measured => "free motion measured",
        }
    }
}

/// Results of simulating a stage.
#[derive(Clone, Debug, Default)]
pub struct Observed {
    /// By which ways.
    pub ways: Vec<Procedure>,
    /// Quantities by their names.
    pub found: Vec<Reached>,
    /// The sums that the bodies carry together after a stage, by their names.
    pub sums: Vec<Reached>,
    /// Quantities by terms of the scene, which say them: `d`, `2*r`.
    pub terms: Vec<Reached>,
}

/// A stage while it is simulated.
pub(super) struct StageRun<'a> {
    pub values: &'a Values<'a>,
    /// The tolerance of integrations.
    pub tolerance: f64,
    /// How many times as short contacts last as they would otherwise.
    pub shorter: f64,
    /// The number of crossings of its end that a motion passes before it ends.
    pub crossing: usize,
    /// The greatest speed of a body so far: what a velocity near zero is the rounding of.
    pub fastest: f64,
    pub observed: Observed,
    /// The motions, where somebody watches.
    pub motions: Option<Vec<RecordedMotion>>,
    /// Whether motions that have a formula are taken from it.
    pub by_formulas: bool,
}

impl<'a> StageRun<'a> {
    /// A run that has not begun.
    pub(super) fn new(values: &'a Values<'a>, tolerance: f64) -> Self {
        Self {
            values,
            tolerance,
            shorter: 1.0,
            crossing: 0,
            fastest: 0.0,
            observed: Observed::default(),
            motions: None,
            by_formulas: false,
        }
    }

    /// An integrator whose steps are at most so long.
    pub(super) fn integrator(&mut self, longest: f64) -> Integrator {
        self.by(Procedure::Integrated);
        Integrator { tolerance: self.tolerance, longest }
    }

    /// The course of a motion, where it may be taken from a formula; else it is integrated, whatever formula it has.
    pub(super) fn course<const N: usize>(&self, course: impl FnOnce() -> Course<N>) -> Course<N> {
        if self.by_formulas { course() } else { Course::Equations("what is to be integrated") }
    }

    /// Notes by which way something was found.
    pub(super) fn by(&mut self, way: Procedure) {
        if !self.observed.ways.contains(&way) {
            self.observed.ways.push(way);
        }
    }

    fn reached(&self, name: &str, value: f64, scale: f64) -> Reached {
        Reached { name: name.to_owned(), value, error: self.tolerance * scale.abs().max(value.abs()) }
    }

    /// Notes a quantity; `scale` is the size of what it is a difference of.
    pub(super) fn note(&mut self, name: &str, value: f64, scale: f64) {
        let reached = self.reached(name, value, scale);
        self.observed.found.push(reached);
    }

    /// Notes what the bodies carry together, to be compared with what is measured on them as the problem says they end.
    pub(super) fn note_sum(&mut self, name: &str, value: f64, scale: f64) {
        let reached = self.reached(name, value, scale);
        self.observed.sums.push(reached);
    }

    /// Notes a quantity under its name with the suffix of the stage.
    pub(super) fn note_here(&mut self, base: &str, value: f64, scale: f64) {
        self.note(&format!("{base}{}", self.values.suffix()), value, scale);
    }

    /// Notes an angular impulse, unless the scene calls a moment of inertia by its name.
    pub(super) fn note_angular_impulse(&mut self, letter: &str, value: f64, scale: f64) {
        let (unknown, values, taken) = (format!("I_M{letter}"), self.values, Cell::new(false));
        let read = |name: &str| {
            taken.set(taken.get() || name == unknown);
            (values.value)(name)
        };
        let reading = Values { value: &read, ..*values };
        for inertia in values.scene.bodies.values().filter_map(|body| body.inertia.as_ref()) {
            let _ = reading.term(inertia);
        }
        if !taken.get() {
            self.note_here(&unknown, value, scale);
        }
    }

    /// Notes what a term of the scene says.
    pub(super) fn note_term(&mut self, term: Option<&Term>, value: f64, scale: f64) {
        if let Some(Term(text)) = term {
            let reached = self.reached(text, value, scale);
            self.observed.terms.push(reached);
        }
    }

    /// Notes how long the stage lasted, and the clock at its end.
    pub(super) fn note_duration(&mut self, term: Option<&Term>, time: f64) {
        self.note_here("dt", time, time);
        self.note_term(term, time, time);
        if let Some(before) = self.values.clock_before() {
            self.note(&format!("t_{}", self.values.index + 2), before + time, time);
        }
    }

    /// Notes the velocity of a body after the stage.
    pub(super) fn note_velocity(&mut self, body: &str, velocity: Vector, scale: f64) {
        for axis in self.values.axes() {
            self.note(&self.values.velocity_after(body, axis), part(velocity, axis), scale.max(self.fastest));
        }
    }

    /// Notes a vector that belongs to the stage by components, magnitude and direction: `J_A.x[hit]`, `J_A[hit]`.
    pub(super) fn note_vector(&mut self, name: &str, vector: Vector) {
        self.note_vector_of(name, vector, 0.0);
    }

    /// The same for a vector that is a difference of others of that size.
    pub(super) fn note_vector_of(&mut self, name: &str, vector: Vector, scale: f64) {
        let (whole, scale) = (size(vector), size(vector).max(scale));
        match self.values.axes()[..] {
            [only] => self.note_here(name, part(vector, only), scale),
            _ => {
                for axis in self.values.axes() {
                    self.note_here(&format!("{name}.{}", axis.letter()), part(vector, axis), scale);
                }
                self.note_here(name, whole, scale);
                if self.values.axes().len() == 2 {
                    self.note_here(&format!("angle_{name}"), libm::atan2(vector[1], vector[0]), scale / whole);
                }
            }
        }
    }

    /// Notes the impulse on a body, and the average force where it is given how long it acted.
    pub(super) fn note_impulse(&mut self, body: &str, impulse: Vector, duration: Option<&Term>) {
        self.note_vector(&format!("J_{body}"), impulse);
        if let Some(time) = duration.and_then(|term| self.values.term(term).ok()) {
            self.note_average_force(body, impulse, time);
        }
    }

    /// Notes the average force on a body by the impulse on it in so many seconds.
    pub(super) fn note_average_force(&mut self, body: &str, impulse: Vector, time: f64) {
        self.note_vector(&format!("F_avg_{body}"), times(1.0 / time, impulse));
    }

    /// The impulse of weight on a body while a contact lasts that includes it, integrated; none where it is left out.
    pub(super) fn weight_in_contact(
        &mut self,
        mass: f64,
        include: &[Included],
        duration: Option<&Term>,
    ) -> Result<Vector, NothingToSimulate> {
        let Some(term) = duration.filter(|_| include.contains(&Included::Weight)) else { return Ok(ZERO) };
        let time = self.values.term(term)?;
        let mut impulse = ZERO;
        for axis in self.values.axes() {
            let pull = mass * self.values.gravity(axis)?;
            let [given] = self.integrator(time / 4.0).until(0.0, [0.0], time, &|_, _| [pull])?;
            impulse = add(impulse, times(given, unit(axis)));
        }
        Ok(impulse)
    }

    /// Notes the kinetic energy that is lost from one list of masses and velocities to the other.
    pub(super) fn note_energy(&mut self, before: &[(f64, Vector)], after: &[(f64, Vector)]) {
        let [start, end] =
            [before, after].map(|all| all.iter().map(|(mass, velocity)| kinetic(*mass, *velocity)).sum());
        let (start, end): (f64, f64) = (start, end);
        self.note_here("T_lost", start - end, start + end);
        self.note_here("T_gained", end - start, start + end);
    }

    /// Takes over what a run of worlds found.
    pub(super) fn take(&mut self, staged: &Staged) -> Result<(), NothingToSimulate> {
        let all = staged.run().map_err(|_| NothingToSimulate::NoMethod)?;
        self.by(Procedure::EventDriven);
        for Reached { name, value, error } in all {
            self.note(&name, value, error / self.tolerance);
        }
        Ok(())
    }
}

/// The kinetic energy of a body.
pub(super) fn kinetic(mass: f64, velocity: Vector) -> f64 {
    mass * dot(velocity, velocity) / 2.0
}
