//! An impact at one point with friction between bodies that may turn: Newton's, Poisson's and Stronge's laws of restitution.
//!
//! The three agree when the contact is smooth, when the coupling vanishes (central impact, spheres with spin included), and when the
//! slip neither stops nor reverses. Elsewhere Newton's law can create energy; Stronge's never does.

use super::refusal::Refusal;

/// A contact at one point in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointImpact {
    /// How the tangential velocity answers a unit tangential impulse, in 1/kg.
    pub tangential: f64,
    /// How the normal velocity answers a unit tangential impulse, and the other way round, in 1/kg.
    pub coupling: f64,
    /// How the normal velocity answers a unit normal impulse, in 1/kg.
    pub normal: f64,
    /// The tangential velocity of the contact just before, in m/s.
    pub slip: f64,
    /// The normal velocity just before, in m/s: negative, since the bodies approach.
    pub approach: f64,
    /// The coefficient of friction.
    pub friction: f64,
    /// The coefficient of restitution.
    pub restitution: f64,
}

/// The quantity that restitution compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RestitutionLaw {
    /// The normal velocities after and before.
    Newton,
    /// The normal impulses of restitution and compression.
    Poisson,
    /// The work of the normal impulse in restitution and compression; e² is their ratio.
    Stronge,
}

/// The outcome of a point impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointOutcome {
    /// The law that was used.
    pub law: RestitutionLaw,
    /// The normal impulse in N s.
    pub normal_impulse: f64,
    /// The tangential impulse in N s.
    pub tangential_impulse: f64,
    /// The tangential velocity of the contact just after, in m/s.
    pub slip: f64,
    /// The normal velocity just after, in m/s.
    pub separation: f64,
    /// The kinetic energy lost, in J.
    pub energy_lost: f64,
}

/// How far the impact has gone; the normal impulse is its clock.
#[derive(Clone, Copy)]
struct Progress {
    normal: f64,
    tangential: f64,
    slip: f64,
    rate: f64,
    work: f64,
}

/// How tangential impulse, slip and normal velocity change with the normal impulse.
#[derive(Clone, Copy)]
struct Phase {
    friction: f64,
    slip: f64,
    rate: f64,
}

/// When to stop.
#[derive(Clone, Copy)]
enum Until {
    /// The normal velocity has this value.
    Rate(f64),
    /// The normal impulse has this value.
    Impulse(f64),
    /// The normal impulse has done this work.
    Work(f64),
}

impl PointImpact {
    /// The outcome by the law that the impact needs: Newton's where all agree, Stronge's elsewhere.
    ///
    /// # Errors
    /// Jamming; numbers that make no contact.
    pub fn solve(&self) -> Result<PointOutcome, Refusal> {
        self.solve_by(self.law_needed()?)
    }

    /// Newton's law where the contact is smooth, or central, or slides one way to the end; Stronge's elsewhere.
    ///
    /// # Errors
    /// Jamming; numbers that make no contact.
    pub fn law_needed(&self) -> Result<RestitutionLaw, Refusal> {
        self.check()?;
        if self.friction == 0.0 || self.coupling == 0.0 {
            return Ok(RestitutionLaw::Newton);
        }
        let phase = self.phase(self.slip)?;
        let impulse = -(1.0 + self.restitution) * self.approach / phase.rate;
        let end = self.slip + phase.slip * impulse;
        let one_way = self.slip != 0.0 && end * self.slip > 0.0;
        Ok(if one_way { RestitutionLaw::Newton } else { RestitutionLaw::Stronge })
    }

    /// The outcome by a law of one's choice. Friction follows the slip, stops it, holds it or lets it reverse.
    ///
    /// # Errors
    /// Jamming; a law that would create energy here; numbers that make no contact.
    ///
    /// ```
    /// use momentous_simulate::{PointImpact, RestitutionLaw};
    /// // A rod of mass and length 1 that strikes with its end.
    /// let rod = PointImpact {
    ///     tangential: 2.92, coupling: 1.44, normal: 2.08, slip: -0.2, approach: -1.0, friction: 0.3, restitution: 0.9,
    /// };
    /// assert_eq!(rod.law_needed(), Ok(RestitutionLaw::Stronge));
    /// assert!((rod.solve().unwrap().energy_lost - 0.1344251).abs() < 1e-7);
    /// ```
    pub fn solve_by(&self, law: RestitutionLaw) -> Result<PointOutcome, Refusal> {
        self.check()?;
        let start = Progress { normal: 0.0, tangential: 0.0, slip: self.slip, rate: self.approach, work: 0.0 };
        let pressed = self.advance(start, Until::Rate(0.0))?;
        let e = self.restitution;
        let end = match law {
            RestitutionLaw::Newton => Until::Rate(-e * self.approach),
            RestitutionLaw::Poisson => Until::Impulse((1.0 + e) * pressed.normal),
            RestitutionLaw::Stronge => Until::Work((1.0 - e * e) * pressed.work),
        };
        self.outcome(law, self.advance(pressed, end)?)
    }

    /// The outcome by Newton's law with friction that keeps the direction of the first slip, as a naive program has it.
    ///
    /// # Errors
    /// Jamming; an outcome that would create energy, which this rule is apt to.
    pub fn solve_with_first_slip(&self) -> Result<PointOutcome, Refusal> {
        self.check()?;
        let phase = self.phase(self.slip)?;
        let normal = -(1.0 + self.restitution) * self.approach / phase.rate;
        let end = Progress {
            normal,
            tangential: phase.friction * normal,
            slip: self.slip + phase.slip * normal,
            rate: -self.restitution * self.approach,
            work: 0.0,
        };
        self.outcome(RestitutionLaw::Newton, end)
    }

    fn check(&self) -> Result<(), Refusal> {
        let numbers = [self.tangential, self.coupling, self.normal, self.slip, self.approach, self.friction];
        let sound = numbers.iter().all(|value| value.is_finite())
            && self.tangential > 0.0
            && self.normal > 0.0
            && self.coupling * self.coupling < self.tangential * self.normal
            && self.approach < 0.0
            && self.friction >= 0.0
            && (0.0..=1.0).contains(&self.restitution);
        if sound {
            return Ok(());
        }
        Err(Refusal::Invalid {
            what: "the terms of inverse mass, the approach or the coefficients do not define a contact".to_owned(),
        })
    }

    /// The phase of friction at a slip: it opposes the slip, or holds a contact that does not slip if it can.
    fn phase(&self, slip: f64) -> Result<Phase, Refusal> {
        let holding = -self.coupling / self.tangential;
        let sticks = slip == 0.0 && holding.abs() <= self.friction;
        let friction = if sticks {
            holding
        } else {
            let direction = if slip == 0.0 { self.coupling } else { slip };
            -self.friction.copysign(direction)
        };
        let rate = self.normal + self.coupling * friction;
        if rate <= 0.0 {
            return Err(Refusal::Jamming);
        }
        let slip = if sticks { 0.0 } else { self.coupling + self.tangential * friction };
        Ok(Phase { friction, slip, rate })
    }

    /// Goes on, phase by phase: slip, then stick or reversed slip.
    fn advance(&self, mut now: Progress, until: Until) -> Result<Progress, Refusal> {
        for _ in 0..3 {
            let phase = self.phase(now.slip)?;
            let left = match until {
                Until::Rate(rate) => (rate - now.rate) / phase.rate,
                Until::Impulse(impulse) => impulse - now.normal,
                Until::Work(work) => {
                    let more = (work - now.work).max(0.0);
                    let root = (now.rate * now.rate + 2.0 * phase.rate * more).sqrt();
                    if more == 0.0 { 0.0 } else { 2.0 * more / (now.rate + root) }
                }
            };
            let left = left.max(0.0);
            let stop = if now.slip * phase.slip < 0.0 { -now.slip / phase.slip } else { f64::INFINITY };
            let step = left.min(stop);
            now.work += (now.rate + phase.rate * step / 2.0) * step;
            now.normal += step;
            now.tangential += phase.friction * step;
            now.rate += phase.rate * step;
            now.slip = if stop <= left { 0.0 } else { now.slip + phase.slip * step };
            if left <= stop {
                if let Until::Rate(rate) = until {
                    now.rate = rate;
                }
                return Ok(now);
            }
        }
        Err(Refusal::Breakdown { time: 0.0, what: "the slip changes its phase more than twice".to_owned() })
    }

    /// The outcome, if it loses energy or keeps it.
    fn outcome(&self, law: RestitutionLaw, end: Progress) -> Result<PointOutcome, Refusal> {
        // An impulse does the work of its mean velocity.
        let normal = -end.normal * f64::midpoint(self.approach, end.rate);
        let tangential = -end.tangential * f64::midpoint(self.slip, end.slip);
        let energy_lost = normal + tangential;
        if energy_lost < -1e-14 * (normal.abs() + tangential.abs()) {
            return Err(Refusal::EnergyGain { rule: format!("{law:?}'s law"), gain: -energy_lost });
        }
        Ok(PointOutcome {
            law,
            normal_impulse: end.normal,
            tangential_impulse: end.tangential,
            slip: end.slip,
            separation: end.rate,
            energy_lost,
        })
    }
}
