//! The loop: take the next event, strike, predict again for what was struck.

use crate::budget::Budget;
use crate::contact::Contact;
use crate::exact::Clock;
use crate::refusal::Refusal;
use crate::simultaneous::Struck;
use crate::state::{State, Vector};
use crate::trajectory::{Ending, Impact, Motion, Segment, Trajectory};
use crate::world::World;

use super::agenda::{Agenda, Event};
use super::field::{Moving, motion_from};
use super::prediction::predict;

pub(super) struct Run<'a, const D: usize> {
    world: &'a World<D>,
    budget: &'a Budget,
    /// The contacts that each body can have, by their places in the agenda.
    contacts: Vec<Vec<usize>>,
    moving: Vec<Moving<D>>,
    now: Clock,
    agenda: Agenda<D>,
    breakpoints: Vec<f64>,
    /// The contacts that were struck since the time last moved by a digit.
    stalled: Vec<Contact>,
    /// The trajectory to return. Its last state has each body as it was when it was last looked at.
    result: Trajectory<D>,
}

impl<'a, const D: usize> Run<'a, D> {
    pub(super) fn new(
        world: &'a World<D>,
        state: State<D>,
        all: Vec<Contact>,
        budget: &'a Budget,
    ) -> Result<Self, Refusal> {
        let mut contacts = vec![Vec::new(); world.bodies.len()];
        for (place, &contact) in all.iter().enumerate() {
            let (first, second) = world.parties(contact);
            contacts[second].push(place);
            if let Some(first) = first {
                contacts[first].push(place);
            }
        }
        let mut moving = Vec::with_capacity(world.bodies.len());
        for (index, body) in world.bodies.iter().enumerate() {
            let motion = motion_from(world, index, 0.0, body.position, body.velocity)?;
            moving.push(Moving { since: Clock::default(), motion });
        }
        let mut breakpoints = world.breakpoints();
        breakpoints.reverse();
        Ok(Self {
            world,
            budget,
            contacts,
            moving,
            result: Trajectory::begin(state),
            now: Clock::default(),
            agenda: Agenda::new(all),
            breakpoints,
            stalled: Vec::new(),
        })
    }

    pub(super) fn finish(mut self) -> Result<Trajectory<D>, Refusal> {
        self.predict_all();
        loop {
            if self.result.impact_count >= self.budget.impacts {
                return self.end(Ending::Impacts);
            }
            if self.result.steps >= self.budget.steps {
                return self.end(Ending::Exhausted);
            }
            let limit = self.breakpoints.last().copied().unwrap_or(f64::INFINITY).min(self.budget.until);
            match self.agenda.next() {
                Some(event) if event.at.seconds() <= limit => {
                    self.result.steps += 1;
                    if let Some(ending) = self.meet(&event)? {
                        return self.end(ending);
                    }
                }
                _ if limit.is_infinite() => return self.end(Ending::NoMoreImpacts),
                _ if limit >= self.budget.until => {
                    self.now = Clock::at(self.budget.until);
                    return self.end(Ending::Time);
                }
                _ => self.change_forces(limit)?,
            }
        }
    }

    /// Brings a body's entry in the state to now.
    fn look_at(&mut self, body: usize) {
        let moving = &self.moving[body];
        let (position, velocity) = moving.motion.at(self.now.since(moving.since));
        self.result.last.positions[body] = position;
        self.result.last.velocities[body] = velocity;
    }

    fn look_at_parties(&mut self, contact: Contact) {
        let (first, second) = self.world.parties(contact);
        self.look_at(second);
        if let Some(first) = first {
            self.look_at(first);
        }
    }

    /// An event: an impact, or a contact that lasts.
    fn meet(&mut self, event: &Event<D>) -> Result<Option<Ending>, Refusal> {
        let moved = event.at.seconds() > self.now.seconds();
        self.now = event.at;
        self.result.last.time = self.now.seconds();
        if moved {
            self.stalled.clear();
        }
        let contact = event.contact;
        self.look_at_parties(contact);
        let struck = self.struck(event);
        if struck.rate >= 0.0 {
            return self.lasting(contact, self.now.seconds());
        }
        let others = self.others(&struck);
        if others.is_empty() {
            let impact = self.world.strike(contact, &struck.normal, struck.rate, &mut self.result.last.velocities);
            self.note(impact);
            let (first, second) = self.world.parties(contact);
            for body in first.into_iter().chain([second]) {
                self.restart(body)?;
            }
            self.predict_for(second, &[]);
            if let Some(first) = first {
                self.predict_for(first, &[second]);
            }
        } else {
            let before = self.result.impact_count;
            self.strike_group(struck, others)?;
            if self.result.impact_count == before {
                return self.lasting(contact, self.now.seconds());
            }
        }
        self.check_progress(contact)
    }

    /// The contact of an event as it is struck: at a wall the body stands on its face, with the speed that the root gave.
    fn struck(&mut self, event: &Event<D>) -> Struck<D> {
        let contact = event.contact;
        let geometry = self.world.geometry(contact, &self.result.last);
        let normal = event.predicted.normal.unwrap_or(geometry.normal);
        let mut rate = self.world.rate(contact, &normal, &self.result.last.velocities);
        if let Contact::Wall { body, .. } = contact {
            self.result.last.positions[body] -= normal * geometry.gap;
            if let Some(exact) = event.predicted.rate {
                self.result.last.velocities[body] += normal * (exact - rate);
                rate = exact;
            }
        } else if let Some(exact) = event.predicted.rate.filter(|_| D > 1) {
            rate = exact;
        }
        Struck { contact, normal, rate }
    }

    fn note(&mut self, mut impact: Impact<D>) {
        impact.time = self.now.seconds();
        self.stalled.push(impact.contact);
        self.result.note(impact, self.budget);
    }

    /// An impact that shares a body with others at the same instant.
    fn strike_group(&mut self, struck: Struck<D>, others: Vec<Struck<D>>) -> Result<(), Refusal> {
        let group = self.group(struck, others);
        let again = |other: &Struck<D>| other.contact != struck.contact && self.stalled.contains(&other.contact);
        if group.iter().any(again) {
            return Err(self.collapse());
        }
        let mut touched: Vec<usize> = Vec::new();
        for impact in self.world.collide(&group, &mut self.result.last.velocities)? {
            self.note(impact);
            let (first, second) = self.world.parties(impact.contact);
            touched.extend(first.into_iter().chain([second]));
        }
        touched.sort_unstable();
        touched.dedup();
        for &body in &touched {
            self.restart(body)?;
        }
        for (done, &body) in touched.iter().enumerate() {
            self.predict_for(body, &touched[..done]);
        }
        Ok(())
    }

    /// The other contacts of the bodies at a contact that touch now and do not part.
    fn others(&mut self, struck: &Struck<D>) -> Vec<Struck<D>> {
        let mut contacts = Vec::new();
        let (first, second) = self.world.parties(struck.contact);
        for body in first.into_iter().chain([second]) {
            for place in 0..self.contacts[body].len() {
                let other = self.agenda.contacts()[self.contacts[body][place]];
                if other != struck.contact {
                    self.look_at_others(other, &[*struck]);
                    contacts.extend(self.world.touching(&[other], &self.result.last));
                }
            }
        }
        contacts
    }

    /// The contact that is struck, with every contact that touches it now, directly or through others, and does not part.
    fn group(&mut self, struck: Struck<D>, others: Vec<Struck<D>>) -> Vec<Struck<D>> {
        let mut group = vec![struck];
        group.extend(others);
        let mut done = 1;
        while done < group.len() {
            let (first, second) = self.world.parties(group[done].contact);
            for body in first.into_iter().chain([second]) {
                for place in 0..self.contacts[body].len() {
                    let other = self.agenda.contacts()[self.contacts[body][place]];
                    if group.iter().any(|struck| struck.contact == other) {
                        continue;
                    }
                    self.look_at_others(other, &group);
                    group.extend(self.world.touching(&[other], &self.result.last));
                }
            }
            done += 1;
        }
        group
    }

    /// Brings the parties of a contact to now, except those whose state was made exact for the group.
    fn look_at_others(&mut self, contact: Contact, group: &[Struck<D>]) {
        let (first, second) = self.world.parties(contact);
        for body in first.into_iter().chain([second]) {
            let known = group.iter().any(|struck| {
                let (first, second) = self.world.parties(struck.contact);
                second == body || first == Some(body)
            });
            if !known {
                self.look_at(body);
            }
        }
    }

    /// Begins a new piece of a body's path from its entry in the state.
    fn restart(&mut self, body: usize) -> Result<(), Refusal> {
        let (position, velocity) = (self.result.last.positions[body], self.result.last.velocities[body]);
        if !position.iter().chain(velocity.iter()).all(|value| value.is_finite()) {
            return Err(Refusal::Breakdown { time: self.now.seconds(), what: "a number is not finite".to_owned() });
        }
        let motion = match &self.moving[body].motion {
            Motion::Uniform { acceleration, .. } => Motion::Uniform { position, velocity, acceleration: *acceleration },
            _ => motion_from(self.world, body, self.now.seconds(), position, velocity)?,
        };
        self.close_segment(body);
        self.moving[body] = Moving { since: self.now, motion };
        Ok(())
    }

    fn close_segment(&mut self, body: usize) {
        if !self.budget.keep.has_paths() {
            return;
        }
        let moving = &self.moving[body];
        let segment = Segment { start: moving.since.seconds(), end: self.now.seconds(), motion: moving.motion.clone() };
        self.result.extend(body, segment, self.budget);
    }

    /// Predicts the contacts of a body, but for those with bodies that had their turn.
    fn predict_for(&mut self, body: usize, done: &[usize]) {
        for place in 0..self.contacts[body].len() {
            let entry = self.contacts[body][place];
            let contact = self.agenda.contacts()[entry];
            let (first, second) = self.world.parties(contact);
            let partner = if second == body { first } else { Some(second) };
            if let Some(partner) = partner {
                if done.contains(&partner) {
                    continue;
                }
                if self.moving[partner].since != self.now {
                    self.look_at(partner);
                }
            }
            self.predict(entry);
        }
    }

    fn predict_all(&mut self) {
        for body in 0..self.moving.len() {
            self.look_at(body);
        }
        for entry in 0..self.agenda.contacts().len() {
            self.predict(entry);
        }
    }

    /// Enters the next event of a contact whose parties' entries are as of now.
    fn predict(&mut self, entry: usize) {
        let contact = self.agenda.contacts()[entry];
        self.result.evaluations += 1;
        let limit = self.breakpoints.last().copied().unwrap_or(f64::INFINITY).min(self.budget.until);
        let horizon = limit - self.now.seconds();
        let elapsed = |body: usize| self.now.since(self.moving[body].since);
        let predicted = predict(self.world, contact, &self.result.last, &self.moving, elapsed, horizon);
        self.agenda.set(entry, predicted.map_or(self.now, |predicted| self.now.after(predicted.after)), predicted);
    }

    /// A force changes its law: every body begins a new piece.
    fn change_forces(&mut self, time: f64) -> Result<(), Refusal> {
        self.now = Clock::at(time);
        self.result.last.time = time;
        self.breakpoints.pop();
        self.result.steps += 1;
        for body in 0..self.moving.len() {
            self.look_at(body);
            let (position, velocity): (Vector<D>, Vector<D>) =
                (self.result.last.positions[body], self.result.last.velocities[body]);
            self.close_segment(body);
            let motion = motion_from(self.world, body, time, position, velocity)?;
            self.moving[body] = Moving { since: self.now, motion };
        }
        self.predict_all();
        Ok(())
    }

    /// Infinitely many impacts in a finite time do not move the time any more.
    fn check_progress(&self, contact: Contact) -> Result<Option<Ending>, Refusal> {
        let most = 64 + self.moving.len() * self.moving.len();
        if self.stalled.len() <= most {
            return Ok(None);
        }
        if self.stalled.iter().all(|other| *other == contact) {
            return self.lasting(contact, self.now.seconds());
        }
        Err(self.collapse())
    }

    /// Impacts that follow each other although the time does not move on.
    fn collapse(&self) -> Refusal {
        let mut contacts = self.stalled.clone();
        contacts.sort_unstable();
        contacts.dedup();
        let time = self.now.seconds();
        if contacts.iter().all(|contact| self.world.restitution_of(*contact) >= 1.0) {
            let what = "impacts follow each other too quickly to be resolved in time".to_owned();
            return Refusal::Breakdown { time, what };
        }
        let contacts = contacts.into_iter().map(|contact| self.world.name_of(contact)).collect();
        Refusal::Collapse { contacts, time }
    }

    /// A body that presses on a wall has come to rest on it; other contacts that last are no impacts.
    fn lasting(&self, contact: Contact, time: f64) -> Result<Option<Ending>, Refusal> {
        match contact {
            Contact::Wall { .. } => Ok(Some(Ending::Rest { contact, time })),
            _ => Err(Refusal::LastingContact { contact: self.world.name_of(contact), time }),
        }
    }

    fn end(mut self, ending: Ending) -> Result<Trajectory<D>, Refusal> {
        for body in 0..self.moving.len() {
            self.look_at(body);
            self.close_segment(body);
        }
        self.result.last.time = self.now.seconds();
        let finite = |vector: &Vector<D>| vector.iter().all(|value| value.is_finite());
        if !self.result.last.positions.iter().chain(&self.result.last.velocities).all(finite) {
            return Err(Refusal::Breakdown { time: self.result.last.time, what: "a number is not finite".to_owned() });
        }
        self.result.ending = ending;
        Ok(self.result)
    }
}
