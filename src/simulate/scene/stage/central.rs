//! A particle under a force towards a fixed point, integrated in the plane of its orbit.

use momentous_scene::stage::{Central, Orbit};

use crate::exact::repeated_cosine;
use crate::scene::component::Frame;
use crate::scene::course::Goal;
use crate::scene::filming::Motion;
use crate::scene::formula::{CENTRAL, CONIC, Course, SINES};
use crate::scene::integrate::Integrator;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::recorded_motion::{Look, SeenBody};
use crate::scene::stage_run::StageRun;

/// Place, velocity, and the area that the radius has swept.
type State = [f64; 5];

/// The acceleration towards the centre as a function of the distance.
#[derive(Clone, Copy, Debug)]
enum Law {
    /// It falls with the square of the distance.
    Gravity { parameter: f64 },
    /// It grows with how far the distance exceeds a length.
    Spring { rate: f64, slack: f64 },
}

/// A direction whose sine, seen from the nearest point, is at most this is that of an apsis.
const APSIS: f64 = 1e-9;

/// The turning points that a particle passes at most before it comes to its goal for the first time along the way told.
const MOST_TURNS: usize = 2;

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
    /// Whether the motion is taken from its formula, where it has one.
    by_formulas: bool,
}

type Plane = nalgebra::Vector2<f64>;

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

/// The same place with another velocity away from the centre.
fn with_radial(state: &State, radial: f64) -> State {
    let [x, y, _, _, area] = *state;
    let ([cosine, sine], across) = ([x, y].map(|part| part / distance(state)), around(state));
    [x, y, radial * cosine - across * sine, radial * sine + across * cosine, area]
}

impl Pull {
    fn slope(&self, state: &State) -> State {
        let [x, y, u, v, _] = *state;
        let pull = -self.law.inwards(distance(state)) / distance(state);
        [u, v, pull * x, pull * y, (x * v - y * u) / 2.0]
    }

    /// The last turning point before the particle comes to a distance along the way told, outwards (1) or inwards (-1), and along which it
    /// then comes there.
    fn before(
        &self,
        start: (f64, State),
        goal: f64,
        arrives: Option<f64>,
    ) -> Result<((f64, State), f64), NothingToSimulate> {
        let ahead = if goal >= distance(&start.1) { 1.0 } else { -1.0 };
        let radial = outwards(&start.1);
        let (mut from, mut sense) = (start, if radial == 0.0 { ahead } else { radial.signum() });
        for _ in 0..MOST_TURNS {
            let arrives = arrives.unwrap_or(sense);
            if sense * arrives > 0.0 && sense * (goal - distance(&from.1)) > 0.0 {
                break;
            }
            from = self.to(from, &|state| sense * outwards(state))?;
            sense = -sense;
        }
        Ok((from, sense))
    }

    fn to(&self, from: (f64, State), stop: &dyn Fn(&State) -> f64) -> Result<(f64, State), NothingToSimulate> {
        let stop = |_: f64, state: &State| stop(state);
        match self.course(from).known().filter(|_| self.by_formulas) {
            Some(formula) => {
                formula.run(from, f64::INFINITY, self.integrator.longest, &stop).map(|end| (end.time, end.state))
            }
            None => self.integrator.event(from.0, from.1, &|_, state| self.slope(state), &stop),
        }
    }

    /// The course from a state on.
    fn course(&self, (begun, start): (f64, State)) -> Course<5> {
        let [x, y, u, v, area] = start;
        let swept = (x * v - y * u) / 2.0;
        match self.law {
            Law::Gravity { parameter } => {
                let (centre, position, velocity) = (Plane::zeros(), Plane::from([x, y]), Plane::from([u, v]));
                let orbit = crate::exact::Orbit { centre, parameter, position, velocity };
                Course::formula(CONIC, move |now| {
                    let (place, moving) = orbit.at(now - begun);
                    [place.x, place.y, moving.x, moving.y, area + swept * (now - begun)]
                })
            }
            Law::Spring { rate, slack: 0.0 } => Course::formula(SINES, move |now| {
                let [cosine, sine] = [0, 1].map(|order| repeated_cosine(order, now - begun, libm::sqrt(rate)));
                let [[x, u], [y, v]] = [[x, u], [y, v]]
                    .map(|[place, speed]| [place * cosine + speed * sine, speed * cosine - rate * place * sine]);
                [x, y, u, v, area + swept * (now - begun)]
            }),
            Law::Spring { .. } => Course::Equations(CENTRAL),
        }
    }
}

impl StageRun<'_> {
    pub(super) fn central(&mut self, stage: &Central) -> Result<(), NothingToSimulate> {
        let (body, first) = (stage.body.as_str(), self.values.index + 1);
        let named =
            |base: &str, instant: usize, part: &str| self.values.named(&format!("{base}_{body}{instant}{part}"));
        let (length, across) = (named("r", first, "")?, named("v", first, ".theta")?);
        let is_between_apsides = || named("theta", first, "").is_ok_and(|angle| libm::sin(angle).abs() > APSIS);
        let radial = match named("v", first, ".r") {
            Ok(radial) => radial,
            // Between its apsides a body moves inwards or outwards, and nobody says how fast.
            Err(missing) if stage.orbit == Some(Orbit::Ellipse) && is_between_apsides() => return Err(missing),
            Err(missing) if named("speed", first, "").is_ok_and(|speed| speed - across.abs() > APSIS * speed) => {
                return Err(missing);
            }
            Err(_) => 0.0,
        };
        let goal = named("r", first + 1, "");
        let told = stage.gravity.as_ref().map(|term| self.values.term(term)).transpose()?;
        let law = match (&stage.spring, told) {
            (Some(spring), _) => Law::Spring {
                rate: self.values.term(&spring.stiffness)? / self.values.mass(body)?,
                slack: self.values.or_zero(spring.unstretched.as_ref())?,
            },
            (None, Some(parameter)) => Law::Gravity { parameter },
            // Where no force is told, any that brings the particle to its goal will do.
            (None, None) => {
                let part = length / goal?;
                let share = if part < 1.0 { 0.25 } else { 1.0 };
                Law::Gravity { parameter: share * (1.0 + part) * length * across * across }
            }
        };
        let pull =
            Pull { law, integrator: self.integrator(0.1 * length / across.abs()), by_formulas: self.by_formulas };
        let start = (0.0, [length, 0.0, radial, across, 0.0]);
        let mut shown = 0.0;
        self.note_there(body, first, &start.1);
        if let Ok(goal) = goal {
            let is_known = stage.spring.is_some() || told.is_some();
            // Along which way it comes there, where it comes there along one; at an apsis it just turns.
            let arrives =
                named("v", first + 1, ".r").ok().filter(|radial| is_known && radial.abs() > APSIS * across.abs());
            let (from, sense) = pull.before(start, goal, arrives.map(f64::signum))?;
            let left = |state: &State| sense * (goal - distance(state));
            let closing = |state: &State| sense * outwards(state);
            let whole = (goal - distance(&from.1)).abs();
            let reach = Goal { left: &left, closing: &closing, whole, time: length / across.abs() };
            let tried = pull.to(from, &|state| reach.passed(state))?;
            let (time, mut end) = pull.to(from, &reach.end(&tried.1))?;
            // Whatever the force was, it leaves the particle with the radial velocity that is told.
            if let (None, None, Ok(told)) = (&stage.spring, told, named("v", first + 1, ".r")) {
                end = with_radial(&end, told);
            }
            shown = time;
            self.note_there(body, first + 1, &end);
            self.note(&format!("v_{body}{}.theta", first + 1), around(&end), across);
            if let Some(spring) = &stage.spring {
                let (stiffness, slack) =
                    (self.values.term(&spring.stiffness)?, self.values.or_zero(spring.unstretched.as_ref())?);
                self.note_stored([length, distance(&end)].map(|deformation| deformation - slack), |deformation| {
                    stiffness * deformation
                });
            }
            if is_known {
                self.note(&format!("v_{body}{}.r", first + 1), outwards(&end), across);
            }
            self.note_here("areal_rate", end[4] / time, 0.0);
            if arrives.is_some() && reach.is_crossed(&tried.1) {
                self.note_here("dt", time, 0.0);
            }
        }
        if stage.orbit == Some(Orbit::Ellipse) && told.is_some() {
            shown = self.go_round(body, &pull, start)?;
        }
        if stage.orbit == Some(Orbit::Circle) {
            shown = self.go_round_a_circle(&format!("{body}{}", first + 1), body, &pull, start)?;
        }
        self.film_orbit(body, &pull, start, shown)
    }

    /// Once round, quarter by quarter, until it is where it began.
    fn go_round_a_circle(
        &mut self,
        there: &str,
        body: &str,
        pull: &Pull,
        start: (f64, State),
    ) -> Result<f64, NothingToSimulate> {
        let sense = start.1[3].signum();
        let quarter = pull.to(start, &|state| state[0])?;
        let three = pull.to(quarter, &|state| -state[0])?;
        let again = pull.to(three, &|state| -sense * state[1])?;
        self.note(&format!("r_{there}"), distance(&again.1), 0.0);
        self.note(&format!("v_{there}.theta"), around(&again.1), 0.0);
        self.note(&format!("speed_{there}"), libm::hypot(again.1[2], again.1[3]), 0.0);
        self.note_element(&format!("period_{body}"), again.0, 0.0);
        Ok(again.0)
    }

    /// The orbit in its plane, from the start on, for a time.
    fn film_orbit(&mut self, body: &str, pull: &Pull, start: (f64, State), end: f64) -> Result<(), NothingToSimulate> {
        let (mass, slope) = (self.values.any_mass(body), |_: f64, state: &State| pull.slope(state));
        let look = |_: f64, state: &State| {
            let [x, y, u, v, _] = *state;
            let [.., across, up, _] = pull.slope(state);
            Look {
                bodies: vec![SeenBody { mass, place: vec![x, y], velocity: vec![u, v] }],
                outside: vec![mass * across, mass * up],
                potential: mass * pull.law.potential(distance(state)),
                ..Look::default()
            }
        };
        let components = Frame::plane(false).components;
        let (names, course) = (&[body], &self.course(|| pull.course(start)));
        self.film(&Motion { names, components, start, end, slope: &slope, course, look: &look })?;
        self.about(vec![0.0; 2], false);
        Ok(())
    }

    fn note_there(&mut self, body: &str, instant: usize, state: &State) {
        self.note(&format!("speed_{body}{instant}"), libm::hypot(state[2], state[3]), 0.0);
        if let Ok(mass) = self.values.mass(body) {
            for point in self.values.scene.points.keys() {
                self.note(&format!("H_{point}{instant}"), mass * around(state) * distance(state), 0.0);
            }
        }
    }

    /// Notes what belongs to an orbit as a whole; a scene with several orbits names it by the stage.
    fn note_element(&mut self, name: &str, value: f64, scale: f64) {
        self.note(name, value, scale);
        if !self.values.suffix().is_empty() {
            self.note_here(name, value, scale);
        }
    }

    /// Once round: farthest, nearest, farthest again. How long that takes.
    fn go_round(&mut self, body: &str, pull: &Pull, start: (f64, State)) -> Result<f64, NothingToSimulate> {
        let far = pull.to(start, &outwards)?;
        let near = pull.to(far, &|state| -outwards(state))?;
        let again = pull.to(near, &outwards)?;
        let [most, least] = [&far.1, &near.1].map(distance);
        self.note_element(&format!("r_{body}.max"), most, 0.0);
        self.note_element(&format!("r_{body}.min"), least, 0.0);
        self.note_element(&format!("a_{body}"), f64::midpoint(most, least), most);
        self.note_element(&format!("ecc_{body}"), (most - least) / (most + least), 1.0);
        self.note_element(&format!("period_{body}"), again.0 - far.0, 0.0);
        Ok(again.0 - far.0)
    }
}
