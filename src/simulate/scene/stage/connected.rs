//! Two bodies on a string over a pulley: the tension is the one with which both accelerate alike.

use crate::scene::Term;
use crate::scene::stage::{Connected, Strand};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::component::Component;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::vector::{times, unit};

/// One end of the string: the mass, and what drives it along the string towards the leading body.
struct End {
    mass: f64,
    weight: f64,
    friction: f64,
    /// How far the string runs for each metre that the body moves.
    strands: f64,
}

impl Bench<'_> {
    pub(super) fn connected(&mut self, stage: &Connected) -> Result<(), NothingToSimulate> {
        let axis = self.values.axes().first().copied().ok_or(NothingToSimulate::Unread)?;
        let trailing = self.strand(&stage.trailing, -1.0)?;
        let leading = self.strand(&stage.leading, 1.0)?;
        let bodies = [stage.trailing.body.as_str(), stage.leading.body.as_str()];
        let mut speed = Err(NothingToSimulate::ValueMissing);
        for (body, end) in bodies.into_iter().zip([&trailing, &leading]) {
            speed = speed.or_else(|_| Ok(end.strands * self.values.velocity_before(body, axis)?));
        }
        let speed = speed?;
        let accelerations = |tension: f64| {
            let own = (trailing.strands * tension + trailing.weight - trailing.friction) / trailing.mass;
            let other = (leading.weight - leading.friction - leading.strands * tension) / leading.mass;
            [own, other]
        };
        // How far apart the accelerations are, tried with a tension of 0 and of 1 N.
        let apart = |tension: f64| {
            let [own, other] = accelerations(tension);
            trailing.strands * own - leading.strands * other
        };
        let tension = apart(0.0) / (apart(0.0) - apart(1.0));
        let told = |term: &Option<Term>| term.as_ref().and_then(|term| self.values.term(term).ok());
        let time = told(&stage.duration).or_else(|| self.values.duration().ok());
        let (way, stops) = (told(&stage.distance), stage.until.is_some());
        let slope = |_: f64, state: &[f64; 3]| {
            let run = f64::midpoint(trailing.strands * state[1], leading.strands * state[2]);
            [run / leading.strands, accelerations(tension)[0], accelerations(tension)[1]]
        };
        let quick = accelerations(tension)[0].abs().max(f64::MIN_POSITIVE);
        let start = [0.0, speed / trailing.strands, speed / leading.strands];
        let speed = start[2];
        let (time, end) = match (stops, time, way) {
            (true, ..) => self.integrator(speed / quick / 4.0).event(0.0, start, &slope, &|_, state| state[1])?,
            (false, Some(time), _) => (time, self.integrator(time / 4.0).until(0.0, start, time, &slope)?),
            (false, None, Some(way)) => {
                let typical = way / (speed.abs() + libm::sqrt(way * quick));
                self.integrator(typical / 4.0).event(0.0, start, &slope, &|_, state| way - state[0])?
            }
            _ => return Err(NothingToSimulate::ValueMissing),
        };
        let ways = |way: f64| [way * leading.strands / trailing.strands, way];
        let held = (trailing.strands - leading.strands) * tension;
        let look = |_: f64, &[way, own, other]: &[f64; 3]| Look {
            bodies: [(&trailing, ways(way)[0], own), (&leading, way, other)]
                .map(|(end, way, speed)| Seen { mass: end.mass, place: vec![way], velocity: vec![speed] })
                .into(),
            outside: vec![held + trailing.weight - trailing.friction + leading.weight - leading.friction],
            potential: -trailing.weight * ways(way)[0] - leading.weight * way,
            power: -trailing.friction * own - leading.friction * other,
            ..Look::default()
        };
        let components = vec![Component::only("s")];
        self.film(&Motion { names: &bodies, components, start: (0.0, start), end: time, slope: &slope, look: &look })?;
        self.remark("s is measured along the string, towards the leading body, for both bodies.");
        for (body, velocity) in bodies.into_iter().zip([end[1], end[2]]) {
            self.note_velocity(body, times(velocity, unit(axis)), speed);
        }
        self.note_here("tension", tension, trailing.weight.abs() + leading.weight.abs());
        self.note_term(stage.distance.as_ref(), end[0], 0.0);
        self.note_duration(stage.duration.as_ref(), time);
        Ok(())
    }

    /// Weight along the string is counted towards the leading body: it draws that one on, and the other back.
    fn strand(&self, strand: &Strand, sense: f64) -> Result<End, NothingToSimulate> {
        let (mass, gravity) = (self.values.mass(&strand.body)?, self.values.named("g")?);
        let (steep, pressed) = match strand.on.as_ref().map(|term| term.0.trim()) {
            None | Some("hanging") => (1.0, 0.0),
            Some("level") => (0.0, 1.0),
            Some(angle) => {
                let angle = self.values.number(angle)?;
                (libm::sin(angle), libm::cos(angle))
            }
        };
        let friction = strand.friction.as_ref().map_or(Ok(0.0), |term| self.values.term(term))?;
        Ok(End {
            mass,
            weight: sense * mass * gravity * steep,
            friction: friction * mass * gravity * pressed,
            strands: f64::from(strand.strands()),
        })
    }
}
