//! A body whose mass changes while forces act on it: each droplet that joins it makes a small plastic impact.

use momentous_scene::stage::{MassChange, Push, Until};

use crate::scene::changing::Changing;
use crate::scene::filming::Motion;
use crate::scene::formula::{BURNING, Course, LOGARITHMS};
use crate::scene::in_time::InTime;
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::Particle;
use crate::scene::pushed::Pushed;
use crate::scene::recorded_motion::{Look, SeenBody};
use crate::scene::stage_run::{Procedure, StageRun};
use crate::scene::vector::{ZERO, dot, less, part, times, unit};

/// The share of the mass that one droplet brings; it is halved to find what ever smaller droplets would do.
const DROPLET: f64 = 1e-6;

/// How quickly the mass changes, in all, and for how long the motion lasts; none where it lasts until the body is at rest.
struct Span {
    flow: f64,
    time: Option<f64>,
    /// Whether time and flow matter, and are not only an example.
    told: bool,
}

/// Mass, speed, way, impulse and lost energy of a body after a time, as a formula has them.
fn changed(body: Changing, gains: bool, [before, arrives]: [f64; 2], gone: f64) -> [f64; 5] {
    let impulse = body.force * gone;
    if gains {
        let [mass, speed, way, lost] = body.joined(before - arrives, gone);
        return [mass, arrives + speed, arrives * gone + way, impulse, lost];
    }
    let [mass, gained, way] = body.after(gone);
    [mass, before + gained, before * gone + way, impulse, 0.0]
}

impl StageRun<'_> {
    pub(super) fn push_changing(
        &mut self,
        stage: &Push,
        change: &MassChange<'_>,
        body: &str,
    ) -> Result<(), NothingToSimulate> {
        let [axis] = self.values.axes()[..] else { return Err(NothingToSimulate::Unread) };
        let (first, before) = (self.values.mass(body)?, self.values.velocity_before(body, axis)?);
        let (pulls, changes) = self.pulls(stage, body)?;
        let along: Vec<_> = pulls.into_iter().map(|(towards, strength)| (part(towards, axis), strength)).collect();
        let all = InTime::sum(&along);
        let force = |time: f64| all.at(time);
        let begun = self.during(stage.during.as_ref()).map_or(0.0, |[start, _]| start);
        let Span { flow, time, told } = self.span(stage, change, body, first)?;
        let (grows, drags) = if change.gains { (flow, self.dragged(flow, first)?) } else { (-flow, 0.0) };
        let arrives = self.values.or_zero(change.velocity)?;
        let slope = |time: f64, &[mass, speed, _, _, _]: &[f64; 5]| {
            let (pulled, relative) = (force(time), arrives - speed);
            [grows, (pulled + drags * relative) / mass, speed, pulled, drags * relative * relative / 2.0]
        };
        let start = [first, before, 0.0, 0.0, 0.0];
        let (end, last) = match time {
            Some(time) => {
                let end = begun + time;
                (end, self.integrator(time / 64.0).until(begun, start, end, &slope)?)
            }
            None => {
                let longest = first / flow / 64.0;
                let sense = before.signum();
                self.integrator(longest).event(begun, start, &slope, &|_, state| sense * state[1])?
            }
        };
        let [mass, speed, way, impulse, _] = last;
        let look = |time: f64, &[mass, speed, way, _, lost]: &[f64; 5]| {
            // What arrives brings momentum and energy with it, and what leaves takes what it had.
            let carried = if change.gains { arrives } else { speed };
            Look {
                bodies: vec![SeenBody { mass, place: vec![way], velocity: vec![speed] }],
                outside: vec![force(time) + grows * carried],
                power: force(time) * speed + grows * carried * carried / 2.0,
                lost,
                ..Look::default()
            }
        };
        let (names, components, from) = (&[body], self.values.frame().components, (begun, start));
        let gains = change.gains;
        let steady = all.law(begun).and_then(|law| law.polynomial_since(begun)).filter(|_| changes.is_empty());
        let course = &self.course(|| {
            let force = match steady.as_deref() {
                Some([]) => 0.0,
                Some([force]) => *force,
                _ => return Course::Equations(BURNING),
            };
            let changing = Changing { mass: first, grows, force };
            Course::formula(LOGARITHMS, move |now| changed(changing, gains, [before, arrives], now - begun))
        });
        self.film(&Motion { names, components, start: from, end, slope: &slope, course, look: &look })?;
        self.remark(
            "Momentum and energy are those of the body with its load; what joins or leaves counts as external.",
        );
        let index = self.values.index;
        let largest =
            [begun, f64::midpoint(begun, end), end].map(|time| force(time).abs()).into_iter().fold(0.0, f64::max);
        if told {
            let scene = self.values.scene;
            let skipped = usize::from(scene.follows_a_force(index, body));
            for (instant, (time, state)) in (index + 1..).zip([(begun, start), (end.next_down(), last)]).skip(skipped) {
                let scale = largest.max(drags * state[1].abs());
                self.note(&format!("a_{body}{instant}"), slope(time, &state)[1], scale / state[0]);
                self.note(&format!("F_{body}{instant}"), force(time), largest);
            }
            self.note_here(&format!("flow_{body}"), flow, 0.0);
            self.note_term(change.flow, flow, 0.0);
            self.note_duration(stage.duration(), end - begun);
            self.note_place(body, times(way, unit(axis)));
            self.note_average_force(body, times(impulse / (end - begun), unit(axis)), 1.0);
        }
        self.note_impulse(body, times(impulse, unit(axis)), None);
        self.note_velocity(body, times(speed, unit(axis)), before);
        self.note(&format!("m_{body}{}", index + 2), mass, first);
        self.note_term(change.mass, (mass - first).abs(), first);
        Ok(())
    }

    fn span(&self, stage: &Push, change: &MassChange<'_>, body: &str, first: f64) -> Result<Span, NothingToSimulate> {
        let index = self.values.index;
        let last = || Some((self.values.named(&format!("m_{body}{}", index + 2)).ok()? - first).abs());
        let whole = self.values.known(change.mass).or_else(last);
        let named = || self.values.named(&format!("flow_{body}{}", self.values.suffix())).ok();
        let flow = self.values.known(change.flow).or_else(named);
        let time = self.during(stage.during.as_ref()).ok().map(|[start, end]| end - start);
        Ok(match (flow, time, whole) {
            (Some(flow), _, _) if stage.until == Some(Until::Rest) => Span { flow, time: None, told: true },
            (Some(flow), Some(time), _) => Span { flow, time: Some(time), told: true },
            (None, Some(time), Some(whole)) => Span { flow: whole / time, time: Some(time), told: true },
            (Some(flow), None, Some(whole)) => Span { flow, time: Some(whole / flow), told: true },
            // Without a force it does not matter how quickly the mass changes.
            (None, None, Some(whole)) if stage.forces.is_empty() => Span { flow: whole, time: Some(1.0), told: false },
            _ => return Err(NothingToSimulate::ValueMissing),
        })
    }

    /// The force on a body at rest of droplets that fly by with a unit of velocity and are caught.
    fn dragged(&mut self, flow: f64, mass: f64) -> Result<f64, NothingToSimulate> {
        self.by(Procedure::Droplets);
        let whole = self.caught(flow, mass, DROPLET)?;
        Ok(2.0 * self.caught(flow, mass, DROPLET / 2.0)? - whole)
    }

    fn caught(&mut self, flow: f64, mass: f64, share: f64) -> Result<f64, NothingToSimulate> {
        let (droplet, axis) = (share * mass, self.values.towards(None)?);
        let parts =
            [(mass, ZERO), (droplet, axis)].map(|(mass, velocity)| Pushed::new(Particle::free("", mass, velocity)));
        let [caught, _] = self.searched(&parts, ZERO, &|[one, other]| less(one.after, other.after))?;
        Ok(mass * dot(caught.after, axis) / (droplet / flow))
    }
}
