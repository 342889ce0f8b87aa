//! Impacts at one instant: which contacts are struck, whether the laws determine the outcome, and the outcome.

use nalgebra::{DMatrix, DVector};

use super::contact::Contact;
use super::refusal::Refusal;
use super::state::{State, Vector};
use super::trajectory::Impact;
use super::world::{Together, World};

/// A contact that takes part in an impact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Struck<const D: usize> {
    pub contact: Contact,
    pub normal: Vector<D>,
    /// How fast its gap grows just before.
    pub rate: f64,
}

/// The number of pairs that may be struck one after another at one instant.
const MOST_PAIRS: usize = 10_000;

impl<const D: usize> World<D> {
    /// The contacts that touch and do not part, or are about to.
    pub(super) fn touching(&self, contacts: &[Contact], state: &State<D>) -> Vec<Struck<D>> {
        let mut struck = Vec::new();
        for &contact in contacts {
            let geometry = self.geometry(contact, state);
            if geometry.gap > self.tolerance(contact, state) {
                continue;
            }
            let rate = self.rate(contact, &geometry.normal, &state.velocities);
            if rate <= self.noise(contact, &state.velocities) {
                struck.push(Struck { contact, normal: geometry.normal, rate });
            }
        }
        struck
    }

    /// The rate below which a gap that opens is nothing but rounding. On a line bodies that stay together have one velocity exactly.
    fn noise(&self, contact: Contact, velocities: &[Vector<D>]) -> f64 {
        if D == 1 {
            return 0.0;
        }
        let (first, second) = self.parties(contact);
        let speed = velocities[second].amax() + first.map_or(0.0, |first| velocities[first].amax());
        4.0 * f64::EPSILON * speed
    }

    /// Solves the impact of contacts that touch: changes the velocities and returns an impact for each that was struck.
    ///
    /// # Errors
    /// The contacts share a body, their normals are not at right angles there, and no law was chosen.
    pub(super) fn collide(
        &self,
        touching: &[Struck<D>],
        velocities: &mut [Vector<D>],
    ) -> Result<Vec<Impact<D>>, Refusal> {
        let approaching = |struck: &Struck<D>| struck.rate < -self.noise(struck.contact, velocities);
        if !touching.iter().any(approaching) {
            return Ok(Vec::new());
        }
        let group = self.reached(touching, approaching);
        let coupled = self.coupled(&group);
        if coupled.is_empty() {
            let mut impacts = Vec::new();
            for struck in group.iter().filter(|struck| struck.rate < 0.0) {
                impacts.push(self.strike(struck.contact, &struck.normal, struck.rate, velocities));
            }
            return Ok(impacts);
        }
        match self.together {
            Together::Refuse => {
                Err(Refusal::LawRequired { contacts: coupled.iter().map(|contact| self.name_of(*contact)).collect() })
            }
            Together::Newton => self.newton_together(&group, velocities),
            Together::OneByOne => self.one_by_one(&group, velocities),
        }
    }

    /// The contacts that an impulse can reach: those that approach, and all that share a body with one that is reached.
    fn reached(&self, touching: &[Struck<D>], approaching: impl Fn(&Struck<D>) -> bool) -> Vec<Struck<D>> {
        let mut inside: Vec<bool> = touching.iter().map(approaching).collect();
        loop {
            let mut grown = false;
            for candidate in 0..touching.len() {
                let near =
                    |other: usize| inside[other] && self.coupling(&touching[candidate], &touching[other]).abs() > 0.0;
                if !inside[candidate] && (0..touching.len()).any(near) {
                    inside[candidate] = true;
                    grown = true;
                }
            }
            if !grown {
                return touching
                    .iter()
                    .zip(&inside)
                    .filter(|(_, inside)| **inside)
                    .map(|(struck, _)| *struck)
                    .collect();
            }
        }
    }

    /// The contacts whose impulses change each other's rates.
    fn coupled(&self, group: &[Struck<D>]) -> Vec<Contact> {
        let coupled = |(place, struck): &(usize, &Struck<D>)| {
            group.iter().enumerate().any(|(other, partner)| {
                // Coplanar normals built from square roots are at right angles up to rounding only.
                let scale = self.coupling(struck, struck).min(self.coupling(partner, partner));
                other != *place && self.coupling(struck, partner).abs() > 1e-14 * scale
            })
        };
        group.iter().enumerate().filter(coupled).map(|(_, struck)| struck.contact).collect()
    }

    /// How much the rate of one contact changes for a unit impulse at the other: an entry of the matrix of Delassus.
    fn coupling(&self, one: &Struck<D>, other: &Struck<D>) -> f64 {
        let ends = |struck: &Struck<D>| {
            let (first, second) = self.parties(struck.contact);
            [first.map(|body| (body, -1.0)), Some((second, 1.0))]
        };
        let dot = one.normal.dot(&other.normal);
        let mut sum = 0.0;
        for (body, sign) in ends(one).into_iter().flatten() {
            for (partner, partner_sign) in ends(other).into_iter().flatten() {
                if body == partner {
                    sum += sign * partner_sign * dot / self.bodies[body].mass;
                }
            }
        }
        sum
    }

    /// Newton's law at every contact at once, as one linear system for the impulses.
    fn newton_together(&self, group: &[Struck<D>], velocities: &mut [Vector<D>]) -> Result<Vec<Impact<D>>, Refusal> {
        let size = group.len();
        let matrix = DMatrix::from_fn(size, size, |row, column| self.coupling(&group[row], &group[column]));
        let wanted =
            DVector::from_fn(size, |row, _| -(1.0 + self.restitution_of(group[row].contact)) * group[row].rate);
        let names = || group.iter().map(|struck| self.name_of(struck.contact)).collect();
        let Some(impulses) = matrix.lu().solve(&wanted) else { return Err(Refusal::LawRequired { contacts: names() }) };
        let scale = impulses.amax();
        if !impulses.iter().all(|impulse| *impulse >= -1e-12 * scale) {
            return Err(Refusal::LawRequired { contacts: names() });
        }
        let before = self.kinetic_energy(velocities);
        let mut impacts = Vec::new();
        for (struck, impulse) in group.iter().zip(impulses.iter()) {
            let (first, second) = self.parties(struck.contact);
            let rate = self.rate(struck.contact, &struck.normal, velocities);
            let energy = |velocities: &[Vector<D>]| {
                let energy = |body: usize| self.bodies[body].mass * velocities[body].norm_squared() / 2.0;
                energy(second) + first.map_or(0.0, energy)
            };
            let energy_before = energy(velocities);
            velocities[second] += struck.normal * (impulse / self.bodies[second].mass);
            if let Some(first) = first {
                velocities[first] -= struck.normal * (impulse / self.bodies[first].mass);
            }
            let after = self.rate(struck.contact, &struck.normal, velocities);
            // An impulse J at a contact does the work J times the mean of its rates.
            let energy_lost = -impulse * f64::midpoint(rate, after);
            let impulse = struck.normal * *impulse;
            impacts.push(Impact { time: 0.0, contact: struck.contact, impulse, energy_before, energy_lost });
        }
        let moving = self.walls.iter().any(|wall| wall.velocity != 0.0);
        let gain = self.kinetic_energy(velocities) - before;
        if gain > 1e-12 * before && !moving {
            return Err(Refusal::EnergyGain { rule: "Newton's law at every contact at once".to_owned(), gain });
        }
        Ok(impacts)
    }

    /// One pair after another, the one that approaches fastest first.
    fn one_by_one(&self, group: &[Struck<D>], velocities: &mut [Vector<D>]) -> Result<Vec<Impact<D>>, Refusal> {
        let mut impacts = Vec::new();
        for _ in 0..MOST_PAIRS {
            let rate = |struck: &Struck<D>| self.rate(struck.contact, &struck.normal, velocities);
            let rates = group.iter().map(|struck| (rate(struck), struck));
            let fastest = rates.min_by(|one, other| one.0.total_cmp(&other.0));
            match fastest {
                Some((rate, struck)) if rate < -self.noise(struck.contact, velocities) => {
                    impacts.push(self.strike(struck.contact, &struck.normal, rate, velocities));
                }
                _ => return Ok(impacts),
            }
        }
        let contacts = group.iter().map(|struck| self.name_of(struck.contact)).collect();
        Err(Refusal::Collapse { contacts, time: 0.0 })
    }
}
