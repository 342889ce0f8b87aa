//! Two bodies in a row: the coupling pulls as hard as it takes for both to accelerate alike.

use crate::scene::stage::{Tow, Towed};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::floor::Slope;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::vector::{times, unit};

/// One of the bodies: its mass, and what acts on it from outside along the axis.
struct Member {
    mass: f64,
    weight: f64,
    other: f64,
}

impl Member {
    fn driven(&self) -> f64 {
        self.weight + self.other
    }
}

impl Bench<'_> {
    pub(super) fn tow(&mut self, stage: &Tow) -> Result<(), NothingToSimulate> {
        let axis = self.values.axes().first().copied().ok_or(NothingToSimulate::Unread)?;
        let slope = match &stage.incline {
            Some(_) => self.values.slope(stage.incline.as_ref())?,
            None => match self.values.gravity(axis)? {
                0.0 => Slope { along: 0.0, across: 1.0 },
                falls => Slope { along: falls.signum(), across: 0.0 },
            },
        };
        let [front, rear] = stage.both().map(|own| self.member(own, &slope));
        let (front, rear) = (front?, rear?);
        let bodies = stage.both().map(|own| own.body.as_str());
        let start = bodies.iter().find_map(|body| self.values.velocity_before(body, axis).ok());
        let start = start.ok_or(NothingToSimulate::ValueMissing)?;
        let accelerations = |pull: f64| [(front.driven() - pull) / front.mass, (rear.driven() + pull) / rear.mass];
        // How far apart the accelerations are, tried with a pull of 0 and of 1 N.
        let apart = |pull: f64| {
            let [one, other] = accelerations(pull);
            one - other
        };
        let pull = apart(0.0) / (apart(0.0) - apart(1.0));
        let told = |term: &Option<_>| term.as_ref().and_then(|term| self.values.term(term).ok());
        let time = told(&stage.duration).or_else(|| self.values.duration().ok());
        let (way, stops) = (told(&stage.distance), stage.until.is_some());
        let slope = |_: f64, state: &[f64; 3]| {
            let [one, other] = accelerations(pull);
            [f64::midpoint(state[1], state[2]), one, other]
        };
        let quick = accelerations(pull)[0].abs().max(f64::MIN_POSITIVE);
        let state = [0.0, start, start];
        let (time, end) = match (stops, time, way) {
            (true, ..) => self.integrator(start / quick / 4.0).event(0.0, state, &slope, &|_, state| state[1])?,
            (false, Some(time), _) => (time, self.integrator(time / 4.0).until(0.0, state, time, &slope)?),
            (false, None, Some(way)) => {
                let typical = way / (start.abs() + libm::sqrt(way * quick));
                self.integrator(typical / 4.0).event(0.0, state, &slope, &|_, state| way - state[0])?
            }
            _ => return Err(NothingToSimulate::ValueMissing),
        };
        let values = self.values;
        let look = |_: f64, &[way, one, other]: &[f64; 3]| Look {
            bodies: [(&front, one), (&rear, other)]
                .map(|(own, speed)| Seen {
                    mass: own.mass,
                    place: values.split(times(way, unit(axis))),
                    velocity: values.split(times(speed, unit(axis))),
                })
                .into(),
            outside: values.split(times(front.driven() + rear.driven(), unit(axis))),
            potential: -(front.weight + rear.weight) * way,
            power: front.other * one + rear.other * other,
            ..Look::default()
        };
        let (names, components) = (&bodies, self.values.components());
        self.film(&Motion { names, components, start: (0.0, state), end: time, slope: &slope, look: &look })?;
        self.remark("Each position is measured from the starting point of its body.");
        for (body, speed) in bodies.into_iter().zip([end[1], end[2]]) {
            self.note_velocity(body, times(speed, unit(axis)), start);
        }
        self.note_here("tension", pull, front.driven().abs() + rear.driven().abs());
        self.note_term(stage.distance.as_ref(), end[0], 0.0);
        self.note_duration(stage.duration.as_ref(), time);
        Ok(())
    }

    fn member(&self, towed: &Towed, slope: &Slope) -> Result<Member, NothingToSimulate> {
        let (mass, gravity) = (self.values.mass(&towed.body)?, self.values.named("g"));
        // Weight need not be known where it has no part in anything.
        let weight = |share: f64| if share == 0.0 { Ok(0.0) } else { Ok(share * mass * gravity?) };
        let told = |term: &Option<_>| term.as_ref().map_or(Ok(0.0), |term| self.values.term(term));
        let (force, friction) = (told(&towed.force)?, told(&towed.friction)?);
        Ok(Member { mass, weight: weight(slope.along)?, other: force - weight(friction * slope.across)? })
    }
}
