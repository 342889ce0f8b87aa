//! Adaptive Runge-Kutta 5(4) of Dormand and Prince, with dense output and event location.
//!
//! The pair is written out here because what it must do between steps is particular: the interpolant is a polynomial, so the
//! gaps are polynomials too, and all their roots are found. No impact hides between two samples. The step is then taken
//! again to the impact, until the gap itself is closed there, and a gap that does not close is a breakdown, never a guess.

use crate::budget::Budget;
use crate::contact::Contact;
use crate::exact::first_fall;
use crate::gap::gap_polynomial;
use crate::method::Method;
use crate::ode::FIFTH;
use crate::refusal::Refusal;
use crate::state::{State, Vector};
use crate::trajectory::{Ending, Motion, Segment, Trajectory};
use crate::world::World;

use super::world_step::{Sizes, Trial};

/// The adaptive method, with a tolerance for the error of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RungeKutta {
    /// The error of a step, relative to the longest way and the greatest speed of a body so far.
    pub tolerance: f64,
}

/// The impacts that may follow each other without the time moving on.
const MOST_STALLED: usize = 64;

impl<const D: usize> Method<D> for RungeKutta {
    fn name(&self) -> &'static str {
        "Runge-Kutta 5(4)"
    }

    fn run(&self, world: &World<D>, budget: &Budget) -> Result<Trajectory<D>, Refusal> {
        world.check()?;
        if !(self.tolerance > 0.0 && budget.until.is_finite()) {
            let what = "a tolerance and an end are needed".to_owned();
            return Err(Refusal::Invalid { what });
        }
        let mut run = Run {
            world,
            budget,
            tolerance: self.tolerance,
            contacts: world.contacts(),
            stalled: Vec::new(),
            stalled_at: f64::NEG_INFINITY,
            sizes: Sizes::of(&world.start()),
            trial: Trial::new(&world.start()),
            result: Trajectory::begin(world.start()),
        };
        run.result.ending = run.integrate()?;
        run.result.evaluations = run.trial.evaluations();
        Ok(run.result)
    }
}

struct Run<'a, const D: usize> {
    world: &'a World<D>,
    budget: &'a Budget,
    tolerance: f64,
    contacts: Vec<Contact>,
    stalled: Vec<Contact>,
    stalled_at: f64,
    sizes: Sizes<D>,
    trial: Trial<D>,
    result: Trajectory<D>,
}

impl<const D: usize> Run<'_, D> {
    fn integrate(&mut self) -> Result<Ending, Refusal> {
        let mut stops = self.world.breakpoints();
        stops.retain(|stop| *stop < self.budget.until);
        stops.push(self.budget.until);
        let mut step = self.budget.until / 100.0;
        for stop in stops {
            self.trial.begin_anew();
            while self.result.last.time < stop {
                if self.result.impact_count >= self.budget.impacts {
                    return Ok(Ending::Impacts);
                }
                if self.result.steps >= self.budget.steps {
                    return Ok(Ending::Exhausted);
                }
                self.result.steps += 1;
                let left = stop - self.result.last.time;
                let last_step = step >= left;
                let length = step.min(left);
                // Just before a force changes its law, stages must not look beyond.
                self.try_step(length, stop);
                let error = self.trial.error;
                if error > 1.0 {
                    step = FIFTH.next(length, error);
                    if step <= 1e-14 * self.result.last.time.max(1e-300) {
                        let (time, what) = (self.result.last.time, "the step became too small".to_owned());
                        return Err(Refusal::Breakdown { time, what });
                    }
                    continue;
                }
                let grown = FIFTH.next(length, error);
                match self.first_event(length) {
                    None => {
                        self.accept(length);
                        if last_step {
                            self.result.last.time = stop;
                        }
                        step = grown;
                    }
                    Some((contact, part)) => {
                        if let Some(ending) = self.meet(contact, part * length, stop)? {
                            return Ok(ending);
                        }
                        step = grown.max(step);
                    }
                }
            }
        }
        Ok(Ending::Time)
    }

    fn try_step(&mut self, length: f64, stop: f64) {
        self.trial.step(self.world, &self.result.last, length, (self.tolerance, &self.sizes), stop);
    }

    /// The contact that closes first within a step, and the part of the step until then.
    fn first_event(&self, length: f64) -> Option<(Contact, f64)> {
        let mut earliest_contact: Option<(Contact, f64)> = None;
        for &contact in &self.contacts {
            let (first, second) = self.world.parties(contact);
            if D > 1 && matches!(contact, Contact::Bodies(..)) && self.world.reach(contact) == 0.0 {
                continue;
            }
            let mut relative = self.trial.dense[second];
            if let Some(first) = first {
                for (coefficient, other) in relative.iter_mut().zip(&self.trial.dense[first]) {
                    *coefficient -= other;
                }
            }
            let gap = gap_polynomial(self.world, contact, &self.result.last, &relative, length);
            if let Some(part) = first_fall(&gap, 1.0)
                && earliest_contact.is_none_or(|(_, earliest)| part < earliest)
            {
                earliest_contact = Some((contact, part));
            }
        }
        earliest_contact
    }

    fn accept(&mut self, length: f64) {
        let start = self.result.last.time;
        let kept = if self.budget.keep.has_paths() { &self.trial.dense[..] } else { &[] };
        for (body, dense) in kept.iter().enumerate() {
            let mut scale = 1.0;
            let mut coefficients = Vec::with_capacity(dense.len());
            for term in dense {
                coefficients.push(term * scale);
                scale /= length;
            }
            let motion = Motion::Polynomial(coefficients);
            self.result.extend(body, Segment { start, end: start + length, motion }, self.budget);
        }
        self.sizes.see(&self.trial.state);
        self.result.last.clone_from(&self.trial.state);
        self.trial.accepted();
    }

    /// Steps to the impact, closes the gap there, and strikes.
    fn meet(&mut self, contact: Contact, guess: f64, stop: f64) -> Result<Option<Ending>, Refusal> {
        let mut length = guess;
        if length > 0.0 {
            self.try_step(length, stop);
            for _ in 0..20 {
                let state = &self.trial.state;
                let geometry = self.world.geometry(contact, state);
                let rate = self.world.rate(contact, &geometry.normal, &state.velocities);
                if geometry.gap.abs() <= self.world.tolerance(contact, state) || rate >= 0.0 {
                    break;
                }
                let next = (length - geometry.gap / rate).max(length / 2.0);
                if (next - length).abs() <= f64::EPSILON * length * 0.25 {
                    break;
                }
                length = next;
                self.try_step(length, stop);
            }
            let state = &self.trial.state;
            let geometry = self.world.geometry(contact, state);
            let rate = self.world.rate(contact, &geometry.normal, &state.velocities);
            let time = state.time;
            // The residual of the event: what is left of the gap must be rounding, of the place or of the time.
            let rounding = 1e3 * self.world.tolerance(contact, state) + 1e-14 * time * rate.abs();
            if geometry.gap.abs() > rounding || geometry.gap.is_nan() {
                let what = format!("the impact {} was not located", self.world.name_of(contact));
                return Err(Refusal::Breakdown { time, what });
            }
            self.accept(length);
        }
        self.strike(contact)
    }

    fn strike(&mut self, contact: Contact) -> Result<Option<Ending>, Refusal> {
        let state: &mut State<D> = &mut self.result.last;
        let time = state.time;
        let geometry = self.world.geometry(contact, state);
        if let Contact::Wall { body, .. } = contact {
            let normal: Vector<D> = geometry.normal;
            state.positions[body] -= normal * geometry.gap;
        }
        let rate = self.world.rate(contact, &geometry.normal, &state.velocities);
        if rate >= 0.0 {
            return self.lasting(contact, time);
        }
        let mut group = self.world.touching(&self.contacts, state);
        if group.iter().all(|struck| struck.contact != contact) {
            group.push(crate::simultaneous::Struck { contact, normal: geometry.normal, rate });
        }
        self.trial.begin_anew();
        for mut impact in self.world.collide(&group, &mut state.velocities)? {
            impact.time = time;
            self.result.note(impact, self.budget);
        }
        if time - self.stalled_at > 1e-14 * time {
            self.stalled.clear();
            self.stalled_at = time;
        }
        self.stalled.push(contact);
        if self.stalled.len() <= MOST_STALLED {
            return Ok(None);
        }
        let mut contacts = self.stalled.clone();
        contacts.sort_unstable();
        contacts.dedup();
        if contacts == [contact] {
            return self.lasting(contact, time);
        }
        let contacts = contacts.into_iter().map(|contact| self.world.name_of(contact)).collect();
        Err(Refusal::Collapse { contacts, time })
    }

    /// A body that presses on a wall has come to rest on it; other contacts that last are no impacts.
    fn lasting(&self, contact: Contact, time: f64) -> Result<Option<Ending>, Refusal> {
        match contact {
            Contact::Wall { .. } => Ok(Some(Ending::Rest { contact, time })),
            _ => Err(Refusal::LastingContact { contact: self.world.name_of(contact), time }),
        }
    }
}
