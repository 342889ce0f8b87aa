//! A body that throws mass away: the thrust of its droplets, and its motion while it becomes lighter.

use momentous_scene::stage::{BurningMass, Exhaust, Thrust};

use crate::scene::changing::Changing;
use crate::scene::filming::Motion;
use crate::scene::formula::{BURNING, Course, LOGARITHMS, POLYNOMIAL};
use crate::scene::integrate::Integrator;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::Particle;
use crate::scene::pushed::Pushed;
use crate::scene::recorded_motion::{Look, SeenBody};
use crate::scene::stage_run::{Procedure, StageRun};
use crate::scene::vector::{ZERO, dot, less, part, times, unit};

/// The share of the mass that one droplet carries away; it is halved to find what ever smaller droplets would do.
const DROPLET: f64 = 1e-6;

/// The mass of a body that nobody weighs, in kg: its thrust does not depend on it.
const ANY_MASS: f64 = 1.0;

/// A burn as numbers.
struct Burn {
    force: f64,
    flow: f64,
    start: f64,
    weight: f64,
    resistance: f64,
    along: f64,
}

impl Burn {
    /// Mass, speed and way from a state on.
    fn course(&self, (begun, [mass, speed, way]): (f64, [f64; 3])) -> Course<3> {
        if self.resistance != 0.0 {
            return Course::Equations(BURNING);
        }
        let (weight, changing) = (self.weight, Changing { mass, grows: -self.flow, force: self.along * self.force });
        Course::formula(LOGARITHMS, move |now| {
            let gone = now - begun;
            let [left, gained, shifted] = changing.after(gone);
            [left, speed + weight * gone + gained, way + speed * gone + weight * gone * gone / 2.0 + shifted]
        })
    }
}

impl StageRun<'_> {
    pub(super) fn thrust(&mut self, stage: &Thrust) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::NoMethod) };
        let body = stage.body.as_str();
        let (start, end) = match &stage.mass {
            BurningMass::Both([start, end]) => (self.values.term(start)?, self.values.known(Some(end))),
            BurningMass::Start(start) => (self.values.term(start).unwrap_or(ANY_MASS), None),
        };
        let is_weighed = self.values.term(stage.mass.at_start()).is_ok();
        let time = self.values.known(stage.during.as_ref()).or_else(|| self.values.duration().ok());
        let (force, flow) = self.jets(stage, start, end, time)?;
        self.note_here(&format!("F_{body}"), force, 0.0);
        self.note_here(&format!("flow_{body}"), flow, 0.0);
        self.note_term(stage.flow.as_ref(), flow, 0.0);
        self.note_term(stage.force.as_ref(), force, 0.0);
        if !is_weighed {
            return Ok(());
        }
        let along = part(self.values.towards(stage.direction.as_ref())?, axis);
        let resistance = self.values.or_zero(stage.resistance.as_ref())?;
        let burn = Burn { force, flow, start, weight: self.values.gravity(axis)?, resistance, along };
        let time = match (time, end) {
            (Some(time), _) => time,
            (None, Some(end)) => self.burnt(&burn, end)?,
            // A thrust of which nobody tells how long it lasts: nothing but the force can be spoken of.
            (None, None) => return Ok(()),
        };
        self.note_burn(stage, &burn, self.values.velocity_before(body, axis)?, time)
    }

    /// The time until only so much mass is left.
    fn burnt(&mut self, burn: &Burn, end: f64) -> Result<f64, NothingToSimulate> {
        let integrator = self.integrator((burn.start - end) / burn.flow / 8.0);
        Ok(integrator.event(0.0, [burn.start], &|_, _| [-burn.flow], &|_, state| state[0] - end)?.0)
    }

    /// The force on a body by droplets of a share of its mass that it throws away.
    fn droplets(&mut self, speed: f64, flow: f64, mass: f64, share: f64) -> Result<f64, NothingToSimulate> {
        let (droplet, left) = (share * mass, (1.0 - share) * mass);
        let parts = [left, droplet].map(|mass| Pushed::new(Particle::free("", mass, ZERO)));
        let axis = self.values.towards(None)?;
        let [pushed, _] = self.searched(&parts, times(speed, axis), &|[one, other]| less(one.after, other.after))?;
        Ok(left * dot(pushed.after, axis) / (droplet / flow))
    }

    /// The thrust of one jet.
    fn pushed(&mut self, speed: f64, flow: f64, mass: f64) -> Result<f64, NothingToSimulate> {
        self.by(Procedure::Droplets);
        let whole = self.droplets(speed, flow, mass, DROPLET)?;
        Ok(2.0 * self.droplets(speed, flow, mass, DROPLET / 2.0)? - whole)
    }

    /// Thrust and flow of all jets together.
    fn jets(
        &mut self,
        stage: &Thrust,
        start: f64,
        end: Option<f64>,
        time: Option<f64>,
    ) -> Result<(f64, f64), NothingToSimulate> {
        match &stage.exhaust {
            Exhaust::Speed(term) => {
                let speed = self.values.term(term)?;
                let flow = match (&stage.flow, end, time) {
                    (Some(term), ..) => self.values.term(term)?,
                    (None, Some(end), Some(time)) => (start - end) / time,
                    // Without weight it does not matter how quickly it burns.
                    (None, Some(end), None) => start - end,
                    _ => return Err(NothingToSimulate::ValueMissing),
                };
                Ok((self.pushed(speed, flow, start)?, flow))
            }
            Exhaust::Jets(jets) => {
                let mut all = (0.0, 0.0);
                for jet in jets {
                    let (speed, flow) = (self.values.term(&jet.speed)?, self.values.term(&jet.flow)?);
                    all = (all.0 + self.pushed(speed, flow, start)?, all.1 + flow);
                }
                Ok(all)
            }
        }
    }

    fn note_burn(&mut self, stage: &Thrust, burn: &Burn, before: f64, time: f64) -> Result<(), NothingToSimulate> {
        let body = stage.body.as_str();
        let axis = self.values.axes()[0];
        let driven = |mass: f64| burn.along * burn.force / mass + burn.weight;
        let integrator = self.integrator(time / 64.0);
        let mut state = [burn.start, before, 0.0];
        let mut begun = 0.0;
        if stage.on_ground && driven(burn.start) <= 0.0 {
            let burning = |_: f64, _: &[f64; 1]| [-burn.flow];
            let held = integrator.run(0.0, [burn.start], time, &burning, &|_, mass| -driven(mass[0]))?;
            let still = |_: f64, &[mass]: &[f64; 1]| Look {
                bodies: vec![SeenBody { mass, place: vec![0.0], velocity: vec![0.0] }],
                outside: vec![0.0],
                ..Look::default()
            };
            let (names, components, start) = (&[body], self.values.frame().components, (0.0, [burn.start]));
            let (full, flow) = (burn.start, burn.flow);
            let course = &self.course(|| Course::formula(POLYNOMIAL, move |now| [full - flow * now]));
            self.film(&Motion { names, components, start, end: held.time, slope: &burning, course, look: &still })?;
            (begun, state[0]) = (held.time, held.state[0]);
        }
        if stage.on_ground {
            self.note_here("t_start", begun, 0.0);
        }
        let slope = |_: f64, &[mass, speed, _]: &[f64; 3]| {
            let drag = burn.resistance * speed * speed.abs() / mass;
            [-burn.flow, driven(mass) - drag, speed]
        };
        let integrator = Integrator { longest: (time - begun).max(f64::MIN_POSITIVE) / 64.0, ..integrator };
        let [mass, speed, way] = integrator.until(begun, state, time, &slope)?;
        let look = |_: f64, &[mass, speed, way]: &[f64; 3]| {
            let pushed = burn.along * burn.force - burn.resistance * speed * speed.abs();
            Look {
                bodies: vec![SeenBody { mass, place: vec![way], velocity: vec![speed] }],
                // What leaves takes the momentum and the energy with it that it had before.
                outside: vec![pushed + mass * burn.weight - burn.flow * speed],
                power: (pushed + mass * burn.weight) * speed - burn.flow * speed * speed / 2.0,
                ..Look::default()
            }
        };
        let (names, components, start) = (&[body], self.values.frame().components, (begun, state));
        let course = &self.course(|| burn.course(start));
        self.film(&Motion { names, components, start, end: time, slope: &slope, course, look: &look })?;
        self.remark(
            "Momentum and energy are those of the remaining mass; what the exhaust carries away counts as external.",
        );
        if stage.is_free() {
            // What is left of the mass is what the forces on it accelerate.
            let first = usize::from(self.values.scene.follows_a_force(self.values.index, body));
            let ends = [(state, slope(begun, &state)), ([mass, speed, way], slope(time, &[mass, speed, way]))];
            for (side, ([mass, ..], [_, gain, _])) in ends.into_iter().enumerate().skip(first) {
                let instant = self.values.index + 1 + side;
                self.note(&format!("a_{body}{instant}"), gain, burn.force / mass);
                self.note(&format!("F_{body}{instant}"), mass * gain, burn.force);
            }
        }
        self.note_velocity(body, times(speed, unit(axis)), before);
        self.note_here(&format!("s_{body}"), way, 0.0);
        match &stage.mass {
            BurningMass::Both([_, end]) => self.note_term(Some(end), mass, burn.start),
            BurningMass::Start(_) => self.note(&format!("m_{body}{}", self.values.index + 2), mass, burn.start),
        }
        self.note_duration(stage.during.as_ref(), time);
        Ok(())
    }
}
