//! A particle under a force towards a fixed point, integrated in the plane of its orbit.

use crate::scene::stage::{Central, Orbit};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::component::Frame;
use crate::simulate::scene::integrate::Integrator;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};

/// Place, velocity, and the area that the radius has swept, in units of the distance and the speed at the start.
type State = [f64; 5];

/// The acceleration towards the centre as a function of the distance.
#[derive(Clone, Copy, Debug)]
enum Law {
    /// It falls with the square of the distance.
    Gravity { parameter: f64 },
    /// It grows with how far the distance exceeds a length.
    Spring { rate: f64, slack: f64 },
}

impl Law {
    fn inwards(self, distance: f64) -> f64 {
        match self {
            Self::Gravity { parameter } => parameter / (distance * distance),
            Self::Spring { rate, slack } => rate * (distance - slack),
        }
    }

    /// The energy of a unit of mass at a distance.
    fn potential(self, distance: f64) -> f64 {
        match self {
            Self::Gravity { parameter } => -parameter / distance,
            Self::Spring { rate, slack } => rate * (distance - slack) * (distance - slack) / 2.0,
        }
    }
}

/// The motion under a force towards the centre.
struct Pull {
    law: Law,
    integrator: Integrator,
}

fn distance(state: &State) -> f64 {
    libm::hypot(state[0], state[1])
}

/// How fast the particle goes away from the centre.
fn outwards(state: &State) -> f64 {
    (state[0] * state[2] + state[1] * state[3]) / distance(state)
}

/// How fast it goes round, counter-clockwise positive.
fn around(state: &State) -> f64 {
    (state[0] * state[3] - state[1] * state[2]) / distance(state)
}

impl Pull {
    fn to(&self, from: (f64, State), stop: &dyn Fn(&State) -> f64) -> Result<(f64, State), NothingToSimulate> {
        let slope = |_: f64, state: &State| {
            let [x, y, u, v, _] = *state;
            let pull = -self.law.inwards(distance(state)) / distance(state);
            [u, v, pull * x, pull * y, (x * v - y * u) / 2.0]
        };
        self.integrator.event(from.0, from.1, &slope, &|_, state| stop(state))
    }
}

impl Bench<'_> {
    pub(super) fn central(&mut self, stage: &Central) -> Result<(), NothingToSimulate> {
        let (body, first) = (stage.body.as_str(), self.values.index + 1);
        let named =
            |base: &str, instant: usize, part: &str| self.values.named(&format!("{base}_{body}{instant}{part}"));
        let (length, across) = (named("r", first, "")?, named("v", first, ".theta")?);
        let speed = across.abs();
        let radial = named("v", first, ".r").unwrap_or(0.0) / speed;
        let goal = named("r", first + 1, "").map(|goal| goal / length);
        let told = stage.gravity.as_ref().map(|term| self.values.term(term)).transpose()?;
        // Where no force is told, any that brings the particle to its goal will do.
        let law = match (&stage.spring, told, &goal) {
            (Some(spring), ..) => {
                let slack = spring.unstretched.as_ref().map_or(Ok(0.0), |term| self.values.term(term))? / length;
                let rate = self.values.term(&spring.stiffness)? / self.values.mass(body)?;
                Law::Spring { rate: rate * length * length / (speed * speed), slack }
            }
            (None, Some(told), _) => Law::Gravity { parameter: told / (length * speed * speed) },
            (None, None, Ok(goal)) if *goal > 1.0 => Law::Gravity { parameter: (1.0 + 1.0 / goal) / 4.0 },
            (None, None, Ok(goal)) => Law::Gravity { parameter: 1.0 + 1.0 / goal },
            (None, None, Err(missing)) => return Err(*missing),
        };
        let pull = Pull { law, integrator: self.integrator(0.1) };
        let start = (0.0, [1.0, 0.0, radial, across.signum(), 0.0]);
        let mut shown = 0.0;
        self.note_there(body, first, &start.1, [length, speed]);
        if let Ok(goal) = goal {
            let sense = if goal >= 1.0 { 1.0 } else { -1.0 };
            let (time, end) = pull.to(start, &|state| sense * (goal - distance(state)))?;
            shown = time;
            self.note_there(body, first + 1, &end, [length, speed]);
            self.note(&format!("v_{body}{}.theta", first + 1), speed * around(&end), speed);
            if stage.spring.is_some() || told.is_some() {
                // It comes back to the same distance with the opposite radial part.
                let turned = named("v", first + 1, ".r").is_ok_and(|told| told * outwards(&end) < 0.0);
                let radial = if turned { -outwards(&end) } else { outwards(&end) };
                self.note(&format!("v_{body}{}.r", first + 1), speed * radial, speed);
            }
            self.note("areal_rate", end[4] / time * length * speed, 0.0);
            if radial == 0.0 {
                self.note_here("dt", time * length / speed, 0.0);
            }
        }
        if stage.orbit == Some(Orbit::Ellipse) && told.is_some() {
            shown = self.go_round(body, &pull, start, [length, speed])?;
        }
        self.film_orbit(body, &pull, (start.1, shown), [length, speed])
    }

    /// The orbit in its plane, from the start on, for a time in its own unit.
    fn film_orbit(
        &mut self,
        body: &str,
        pull: &Pull,
        (start, time): (State, f64),
        [length, speed]: [f64; 2],
    ) -> Result<(), NothingToSimulate> {
        let mass = self.values.any_mass(body);
        let slope = |_: f64, &[x, y, u, v]: &[f64; 4]| {
            let away = libm::hypot(x, y);
            let pull = -pull.law.inwards(away / length) * speed * speed / (length * away);
            [u, v, pull * x, pull * y]
        };
        let look = |at: f64, state: &[f64; 4]| {
            let [x, y, u, v] = *state;
            let [.., across, up] = slope(at, state);
            Look {
                bodies: vec![Seen { mass, place: vec![x, y], velocity: vec![u, v] }],
                outside: vec![mass * across, mass * up],
                potential: mass * speed * speed * pull.law.potential(libm::hypot(x, y) / length),
                ..Look::default()
            }
        };
        let first = [start[0] * length, start[1] * length, start[2] * speed, start[3] * speed];
        let (names, start, end) = (&[body], (0.0, first), time * length / speed);
        self.film(&Motion {
            names,
            components: Frame::plane(false).components,
            start,
            end,
            slope: &slope,
            look: &look,
        })?;
        self.about(vec![0.0; 2], false);
        Ok(())
    }

    fn note_there(&mut self, body: &str, instant: usize, state: &State, [length, speed]: [f64; 2]) {
        self.note(&format!("speed_{body}{instant}"), speed * libm::hypot(state[2], state[3]), 0.0);
        if let Ok(mass) = self.values.mass(body) {
            let about = mass * around(state) * distance(state) * length * speed;
            let points: Vec<String> = self.values.scene.points.keys().cloned().collect();
            for point in points {
                self.note(&format!("H_{point}{instant}"), about, 0.0);
            }
        }
    }

    /// Once round: farthest, nearest, farthest again. How long that takes, in the unit of the motion.
    fn go_round(
        &mut self,
        body: &str,
        pull: &Pull,
        start: (f64, State),
        [length, speed]: [f64; 2],
    ) -> Result<f64, NothingToSimulate> {
        let far = pull.to(start, &outwards)?;
        let near = pull.to(far, &|state| -outwards(state))?;
        let again = pull.to(near, &outwards)?;
        let [most, least] = [&far.1, &near.1].map(|state| distance(state) * length);
        self.note(&format!("r_{body}.max"), most, 0.0);
        self.note(&format!("r_{body}.min"), least, 0.0);
        self.note(&format!("a_{body}"), f64::midpoint(most, least), most);
        self.note(&format!("ecc_{body}"), (most - least) / (most + least), 1.0);
        self.note(&format!("period_{body}"), (again.0 - far.0) * length / speed, 0.0);
        Ok(again.0 - far.0)
    }
}
