//! A swing on a cord: a pendulum, integrated.

use crate::scene::Term;
use crate::scene::stage::{Place, Swing, Way};

use crate::simulate::scene::bench::Bench;
use crate::simulate::scene::component::Frame;
use crate::simulate::scene::nothing::NothingToSimulate;
use crate::simulate::scene::reel::{Look, Motion, Seen};
use crate::simulate::scene::vector::{times, unit};

/// The angle at which a swing starts whose cord may have any length.
const ANY_ANGLE: f64 = 1.0;

impl Bench<'_> {
    pub(super) fn swing(&mut self, stage: &Swing) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let (body, gravity) = (stage.body.as_str(), self.values.named("g")?);
        let told = |term: Option<&Term>| term.and_then(|term| self.values.term(term).ok());
        let own = |base: &str| (self.values.value)(&format!("{base}_{body}{}", self.values.suffix()));
        let height = told(stage.height.as_ref()).or_else(|| own("h"));
        let sense = self.values.sense(stage.direction.as_ref(), axis)?;
        let before = self.values.velocity_before(body, axis);
        let [from, to] = stage.places();
        let length = match (told(stage.length.as_ref()), height, &before) {
            (Some(length), ..) => length,
            // Only heights are used, so that the length may be anything that reaches them.
            (None, Some(height), _) if stage.way == Way::Down => height / (1.0 - libm::cos(ANY_ANGLE)),
            (None, _, Ok(speed)) if *speed != 0.0 => speed * speed / gravity,
            _ => return Err(NothingToSimulate::ValueMissing),
        };
        let instant = self.values.index + 1;
        let named = |instant: usize| (self.values.value)(&format!("angle_{body}{instant}"));
        let start = match from {
            Place::Lowest => 0.0,
            Place::Angle(term) => {
                let angle = told(term).or_else(|| named(instant));
                let fallen = || height.map(|height| libm::acos(1.0 - height / length));
                // It comes down from behind.
                -angle.or_else(fallen).ok_or(NothingToSimulate::ValueMissing)?
            }
        };
        let speed = match from {
            Place::Lowest => sense * before?,
            Place::Angle(_) => {
                (self.values.value)(&format!("speed_{body}{instant}")).or(before.ok()).unwrap_or(0.0).abs()
            }
        };
        let end = match to {
            Place::Lowest => Some(0.0),
            Place::Angle(term) => told(term).or_else(|| named(instant + 1)),
        };
        let stops = stage.stops();
        let slope = |_: f64, state: &[f64; 2]| [state[1], -gravity / length * libm::sin(state[0])];
        let integrator = self.integrator(0.1 * libm::sqrt(length / gravity));
        let stop = |_: f64, state: &[f64; 2]| match end {
            Some(end) if !stops => end - state[0],
            _ => state[1],
        };
        let first = [start, speed / length];
        let (time, [angle, turning]) = integrator.event(0.0, first, &slope, &stop)?;
        let mass = self.values.any_mass(body);
        // Across and up from the lowest point; weight and the cord act.
        let look = |_: f64, &[angle, turning]: &[f64; 2]| {
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            let (height, swept) = (length * (1.0 - cos), length * turning);
            let cord = mass * (swept * turning + gravity * cos);
            let place = vec![sense * length * sin, height];
            let velocity = vec![sense * swept * cos, swept * sin];
            Look {
                bodies: vec![Seen { mass, place, velocity }],
                outside: vec![-sense * cord * sin, cord * cos - mass * gravity],
                potential: mass * gravity * height,
                ..Look::default()
            }
        };
        let (names, start_of) = (&[body], (0.0, first));
        self.film(&Motion {
            names,
            components: Frame::plane(true).components,
            start: start_of,
            end: time,
            slope: &slope,
            look: &look,
        })?;
        self.about(vec![0.0, length], true);
        let reached = if stops { 0.0 } else { length * turning };
        let depth = |angle: f64| -length * libm::cos(angle);
        let rise = (depth(angle) - depth(start)).abs();
        match to {
            Place::Lowest => self.note_velocity(body, times(sense * reached, unit(axis)), 0.0),
            Place::Angle(term) => {
                self.note(&format!("speed_{body}{}", instant + 1), reached.abs(), length * turning);
                if stage.length.is_some() {
                    self.note(&format!("angle_{body}{}", instant + 1), angle, 1.0);
                    self.note_term(term, angle, 1.0);
                }
            }
        }
        self.note_here(&format!("h_{body}"), rise, length);
        self.note_term(stage.height.as_ref(), rise, length);
        if let (Ok(mass), true) = (self.values.mass(body), stage.length.is_some()) {
            for (instant, angle, turning) in [(instant, start, speed / length), (instant + 1, angle, reached / length)]
            {
                // The cord gives what weight does not: the acceleration towards the fixed end, of the motion as it is there.
                let inwards = length * turning * turning + gravity * libm::cos(angle);
                self.note(&format!("tension_{body}{instant}"), mass * inwards, mass * gravity);
            }
        }
        Ok(())
    }
}
