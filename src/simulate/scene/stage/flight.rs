//! Free flights and even motion: every body from its place with its velocity, until a time or an equation in the places.

use std::sync::Arc;

use momentous_scene::stage::{Drift, Flight};
use momentous_scene::{Axis, Stage, Term};

use crate::scene::filming::Motion;
use crate::scene::formula::{Course, POLYNOMIAL};
use crate::scene::nothing::NothingToSimulate;
use crate::scene::particles::Particle;
use crate::scene::rate::rate;
use crate::scene::stage_run::StageRun;
use crate::scene::values::OfSeveral;
use crate::scene::vector::{Vector, ZERO, add, cross, less, part, size, times};

/// The time after which it is looked on which side of its end a motion that starts on it has gone.
pub(super) const SOON: f64 = 1e-6;

/// The share of its time over which it is looked at how fast something changes.
const SOON_AFTER: f64 = 1e-3;

impl Particle<'_> {
    /// The same particle after a time in free fall.
    fn after(&self, time: f64) -> Self {
        let way = times(time, add(self.velocity, times(time / 2.0, self.falls)));
        Self { place: add(self.place, way), velocity: add(self.velocity, times(time, self.falls)), ..*self }
    }

    /// The same particle with nought for what is not known of it.
    pub(super) fn or_nought(&self) -> Self {
        let known = |vector: Vector| vector.map(|part| if part.is_nan() { 0.0 } else { part });
        Self { place: known(self.place), velocity: known(self.velocity), ..*self }
    }
}

impl StageRun<'_> {
    pub(super) fn flight(&mut self, stage: &Flight) -> Result<(), NothingToSimulate> {
        let mut falls = ZERO;
        for (axis, fall) in self.values.axes().into_iter().zip(self.values.falls(stage.incline.as_ref())?) {
            falls[axis as usize] = fall;
        }
        let bodies: Vec<_> = stage.flying().map(|body| self.flying(body, falls)).collect();
        if bodies.iter().any(|body| body.velocity.iter().any(|part| part.is_nan())) {
            return Err(NothingToSimulate::ValueMissing);
        }
        if let (Some(resistance), [body]) = (&stage.resistance, &bodies[..]) {
            return self.fly_resisted(body, resistance, stage);
        }
        self.fly(&bodies, stage.until.as_ref(), stage.during.as_ref())
    }

    pub(super) fn drift(&mut self, stage: &Drift) -> Result<(), NothingToSimulate> {
        let scene = self.values.scene;
        let stages = scene.stages.iter();
        let unions =
            stages.filter_map(|stage| if let Stage::Impact(impact) = stage { impact.becomes.as_ref() } else { None });
        let mut bodies: Vec<_> = scene.bodies.keys().chain(unions).map(|body| self.flying(body, ZERO)).collect();
        let axes = self.values.axes();
        bodies.retain(|body| !placed(&axes, &[*body], 0.0).is_empty());
        if bodies.is_empty() {
            return Err(NothingToSimulate::ValueMissing);
        }
        self.fly(&bodies, stage.until.as_ref(), stage.during.as_ref())
    }

    /// A body that flies freely; what is not known of it is not a number.
    fn flying<'s>(&self, name: &'s str, falls: Vector) -> Particle<'s> {
        let mut particle = Particle { falls, ..Particle::free(name, self.values.any_mass(name), ZERO) };
        for axis in self.values.axes() {
            particle.place[axis as usize] = self.values.place_before(name, axis).unwrap_or(f64::NAN);
            particle.velocity[axis as usize] = self.values.velocity_before(name, axis).unwrap_or(f64::NAN);
        }
        particle
    }

    fn fly(
        &mut self,
        bodies: &[Particle<'_>],
        until: Option<&Term>,
        during: Option<&Term>,
    ) -> Result<(), NothingToSimulate> {
        let axes = self.values.axes();
        let time = match until.map(|term| term.0.trim()) {
            None => during.map_or_else(|| self.values.duration(), |term| self.values.term(term))?,
            Some("top") => {
                // Over a slope weight acts along both axes, of which the second points away from it.
                let body = bodies.last().ok_or(NothingToSimulate::NoStage)?;
                let up = axes.iter().rfind(|axis| part(body.falls, **axis) != 0.0);
                let up = *up.ok_or(NothingToSimulate::NothingChanges)?;
                self.crosses(bodies, &|time| part(body.after(time).velocity, up))?
            }
            Some(text) => {
                let apart = self.equation(bodies, text)?;
                let places = |time: f64| placed(&axes, bodies, time).into_iter().map(|(_, _, place)| place);
                self.crosses(bodies, &|time| apart(&places(time).collect::<Vec<_>>()))?
            }
        };
        self.film_flights(bodies, time)?;
        let first = self.values.index + 1;
        for (body, axis) in bodies.iter().flat_map(|body| axes.iter().map(move |axis| (body, *axis))) {
            let [start, speed] = [body.place, body.velocity].map(|vector| part(vector, axis));
            let end = body.after(time);
            if !speed.is_nan() {
                self.note(&self.values.velocity_after(body.name, axis), part(end.velocity, axis), speed);
            }
            if !part(end.place, axis).is_nan() {
                let name = self.values.place_name(body.name, first + 1, axis);
                self.note(&name, part(end.place, axis), start.abs().max((speed * time).abs()));
            }
        }
        self.note_duration(during, time);
        self.note_moments(bodies, first, 0.0, SOON_AFTER * time)?;
        self.note_moments(bodies, first + 1, time, -SOON_AFTER * time)
    }

    /// How fast the angular momentum of all about each point of the scene changes, where they all fly and it is known where.
    fn note_moments(
        &mut self,
        bodies: &[Particle<'_>],
        instant: usize,
        time: f64,
        width: f64,
    ) -> Result<(), NothingToSimulate> {
        for (point, centre) in self.values.fixed_points() {
            let turns = rate(width, |later| {
                let moments = bodies.iter().map(|body| {
                    let Particle { place, velocity, .. } = body.after(time + later);
                    times(self.values.mass(body.name).unwrap_or(f64::NAN), cross(less(place, centre), velocity))
                });
                Ok(moments.fold(ZERO, add))
            })?;
            if size(turns.value).is_finite() {
                self.note_turning(&point, instant, turns);
            }
        }
        Ok(())
    }

    /// All bodies, each from where it is known to start, or else from nought.
    fn film_flights(&mut self, bodies: &[Particle<'_>], end: f64) -> Result<(), NothingToSimulate> {
        let frame = self.values.frame();
        let look =
            |time: f64, _: &[f64; 0]| frame.look(bodies.iter().map(|body| (body.or_nought().after(time), ZERO, 0.0)));
        let names: Vec<&str> = bodies.iter().map(|body| body.name).collect();
        let (start, components) = ((0.0, []), frame.components.clone());
        // All of it is in how it is looked at.
        let course = &self.course(|| Course::formula(POLYNOMIAL, |_| []));
        self.film(&Motion { names: &names, components, start, end, slope: &|_, _| [], course, look: &look })
    }

    /// The two sides of an equation in places as a function of the places that is zero where they are equal.
    pub(super) fn equation(&self, bodies: &[Particle<'_>], text: &str) -> Result<OfSeveral, NothingToSimulate> {
        let (left, right) = text.split_once('=').ok_or(NothingToSimulate::Unread)?;
        let placed = placed(&self.values.axes(), bodies, 0.0);
        let mut names: Vec<String> = placed.iter().map(|(body, axis, _)| format!("{}_{body}", axis.letter())).collect();
        if let [_] = bodies {
            names.extend(placed.iter().map(|(_, axis, _)| axis.letter().to_owned()));
        }
        let [left, right] = [left, right].map(|side| self.values.of_several(side, &names));
        let (left, right) = (left?, right?);
        Ok(Arc::new(move |places| {
            let both = [places, places].concat();
            left(&both) - right(&both)
        }))
    }

    /// When something changes its sign, by marching in time and shortening the last step.
    fn crosses(&mut self, bodies: &[Particle<'_>], signed: &dyn Fn(f64) -> f64) -> Result<f64, NothingToSimulate> {
        let first = if signed(0.0) == 0.0 { signed(SOON) } else { signed(0.0) };
        // How long a place needs for a change of the order of itself.
        let spans = bodies.iter().flat_map(|body| {
            let Particle { place, velocity, falls, .. } = body.or_nought();
            [0, 1, 2].map(|axis| {
                let way = place[axis].abs() + 1.0;
                way / (velocity[axis].abs() + libm::sqrt(way * falls[axis].abs())).max(f64::MIN_POSITIVE)
            })
        });
        let integrator = self.integrator(spans.fold(f64::INFINITY, f64::min).min(1e6) / 8.0);
        let (mut time, mut side) = (0.0, first.signum());
        for _ in 0..=self.crossing {
            (time, _) = integrator.event(time, [time], &|_, _| [1.0], &|time, _| signed(time) * side)?;
            side = -side;
        }
        Ok(time)
    }
}

/// The places along the axes that are known of bodies after a time.
pub(super) fn placed<'s>(axes: &[Axis], bodies: &[Particle<'s>], time: f64) -> Vec<(&'s str, Axis, f64)> {
    let ends = bodies.iter().map(|body| body.after(time));
    let each = ends.flat_map(|body| axes.iter().map(move |axis| (body.name, *axis, part(body.place, *axis))));
    each.filter(|(_, _, place)| !place.is_nan()).collect()
}
