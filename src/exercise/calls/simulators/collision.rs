//! The collision simulator: two carts on a track, seen from before they meet.

use serde::Serialize;

use momentous_simulate::{Body, Budget, EventDriven, Method, Moment, Record, World};

use super::super::Engine;
use super::balance::{Balance, balance};
use super::bars::{Bars, energies, momenta, velocities};
use super::compared::Compared;
use super::controls::{COLLISION, SimulatorRequest, outside, set};
use super::curve::places;
use super::magnified::{Magnified, magnified};
use super::meeting::{Meeting, phases};
use super::{Amount, Curve, Phase, ProblemOf, Refused, RefusedKind, not_run};

/// The problem whose scene this is.
const PROBLEM: &str = "impact/two-carts";

/// Half the length of a cart of 1 kg, in m; it grows as the radius of a sphere does.
const RADIUS: f64 = 0.3;

/// The heaviest cart that can be set, in kg.
const HEAVIEST: f64 = 20.0;

/// How much longer than up to the impact the carts are watched.
const WATCHED: f64 = 2.25;

/// The limits of watching carts that never meet: until the faster has gone so far (m), at most for so long (s).
const WAY: f64 = 6.0;
const LONGEST: f64 = 6.0;

/// Everything that the page of the collision shows.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CollisionResponse {
    /// The course of events, in a sentence.
    pub told: String,
    /// The phases of the carts' motion, one after another.
    pub phases: Vec<Phase>,
    /// The impact, where there is one.
    pub meeting: Option<Meeting>,
    /// The two carts.
    pub bodies: Vec<CollisionBody>,
    /// Momentum, energy and velocity before and after: of each cart and of both.
    pub momentum: Vec<Balance>,
    /// The same of the kinetic energy.
    pub energy: Vec<Balance>,
    /// The kinetic energy lost.
    pub lost: Amount,
    /// The same as a share.
    pub lost_share: Amount,
    /// The time for which the carts are watched, in s.
    pub end: f64,
    /// From where to where they go, in m.
    pub track: [f64; 2],
    /// The places of the carts and their centre of mass.
    pub places: Vec<Curve>,
    /// Their velocities, in the same order.
    pub velocities: Vec<Curve>,
    /// Their momenta and energies, for the bars beside the scene.
    pub bars: Vec<Bars>,
    /// The same as a table: the time and the three places, at the start, at the impact and at the end.
    pub table: Vec<Vec<Amount>>,
    /// The contact, magnified; nothing without an impact, or where no spring and dashpot do the same.
    pub contact: Option<Magnified>,
    /// The scene as a problem.
    pub problem: ProblemOf,
    /// A method beside it.
    pub compared: Option<Compared>,
}

/// A cart.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CollisionBody {
    /// Its name.
    pub name: &'static str,
    /// Half its length, in m.
    pub radius: f64,
    /// Its velocity before.
    pub before: Amount,
    /// Its velocity after.
    pub after: Amount,
}

impl Engine<'_> {
    /// The collision with these values.
    ///
    /// # Errors
    /// Where a value makes no scene, lies outside its limits, or the method is unknown or would take too many steps.
    pub fn collision(&self, request: &SimulatorRequest) -> Result<CollisionResponse, Refused> {
        let values: [f64; 7] = request.values(COLLISION)?;
        let problem = self.problem_of(PROBLEM, set(COLLISION, &values))?;
        let [mass_a, velocity_a, mass_b, velocity_b, place_a, place_b, restitution] = values;
        let mut world = World::<1>::new(restitution);
        let (radius_a, radius_b) = (radius(mass_a), radius(mass_b));
        world.bodies.push(Body::sphere("A", mass_a, radius_a, [place_a], [velocity_a]));
        world.bodies.push(Body::sphere("B", mass_b, radius_b, [place_b], [velocity_b]));
        if let Err(reason) = world.check() {
            return Err(problem.refused(&reason));
        }
        if let Some(refused) = outside(COLLISION, &values) {
            return Err(refused);
        }
        let (apart, closing) = (place_b - place_a - radius_a - radius_b, velocity_a - velocity_b);
        let fastest = velocity_a.abs().max(velocity_b.abs());
        let end = if closing > 0.0 { WATCHED * apart / closing } else { (WAY / fastest).min(LONGEST) };
        let run = EventDriven.run(&world, &Budget::until(end)).map_err(|reason| not_run(&reason))?;
        let record = Record::of(&world, &run, 0.0);
        if let (Some(reason), false) = (problem.impossible(), record.impacts.is_empty()) {
            return Err(Refused::new(RefusedKind::Values, reason.clone()));
        }
        let compared = match &request.method {
            None => None,
            Some(name) => Some(Compared::of(&world, &record, name, request.step, &self.limits)?),
        };
        Ok(shown(&world, &record, problem, compared))
    }
}

/// Half the length of a cart. One that is heavier than any that can be set is refused for its mass, not for its size.
fn radius(mass: f64) -> f64 {
    RADIUS * libm::cbrt(mass.min(HEAVIEST))
}

fn shown(world: &World<1>, record: &Record, problem: ProblemOf, compared: Option<Compared>) -> CollisionResponse {
    let velocities_at = |moment: Option<&Moment>| -> Vec<f64> {
        moment.map(|moment| moment.velocities.iter().flatten().copied().collect()).unwrap_or_default()
    };
    let (before, after) = (velocities_at(record.moments.first()), velocities_at(record.moments.last()));
    let scale = before.iter().map(|velocity| velocity.abs()).fold(0.0, f64::max);
    let end = record.moments.last().map_or(0.0, |moment| moment.time);
    let meeting = record.impacts.first().map(|impact| Meeting {
        time: Amount::new(impact.time, impact.time, "s"),
        impulse: Amount::new(impact.impulse.first().copied().unwrap_or(0.0), 0.0, "N\u{a0}s"),
    });
    let answers = problem.solved.as_ref().map(|solved| solved.answers.as_slice()).unwrap_or_default();
    let answer = |id: &str| answers.iter().find(|answer| answer.id == id);
    let told =
        |id: &str, value: f64, unit: &str| match answer(id).and_then(|answer| Some((answer.value?, &answer.printed))) {
            Some((value, printed)) => Amount::with_text(value, printed),
            None => Amount::new(value, scale, unit),
        };
    let bodies: Vec<CollisionBody> = ["A", "B"]
        .into_iter()
        .zip(["v_A2", "v_B2"])
        .zip(&world.bodies)
        .zip(before.iter().zip(&after))
        .map(|(((name, id), body), (before, after))| CollisionBody {
            name,
            radius: body.radius,
            before: Amount::new(*before, 0.0, "m/s"),
            after: told(id, *after, "m/s"),
        })
        .collect();
    let each = |quantity: &dyn Fn(f64, f64) -> f64, velocities: &[f64]| -> Vec<f64> {
        world.bodies.iter().zip(velocities).map(|(body, velocity)| quantity(body.mass, *velocity)).collect()
    };
    let balance = |quantity: &dyn Fn(f64, f64) -> f64, unit: &str| {
        balance(&each(quantity, &before), &each(quantity, &after), unit)
    };
    let momentum = balance(&|mass, velocity| mass * velocity, "kg\u{a0}m/s");
    let energy = balance(&|mass, velocity| mass * velocity * velocity / 2.0, "J");
    let total = |moment: Option<&Moment>| moment.map_or(0.0, |moment| moment.kinetic);
    let (whole, left) = (total(record.moments.first()), total(record.moments.last()));
    let lost = record.moments.last().map_or(0.0, |moment| moment.lost);
    let told_lost = match answer("T_lost").and_then(|answer| Some((answer.value?, &answer.printed))) {
        Some((value, printed)) => Amount::with_text(value, printed),
        None => Amount::new(whole - left, whole, "J"),
    };
    let places = places(record, 0);
    let meeting_time = meeting.as_ref().map(|meeting| meeting.time.value);
    CollisionResponse {
        told: sentence(meeting.as_ref(), &problem),
        phases: phases(meeting.as_ref(), end),
        meeting,
        bodies,
        momentum,
        energy,
        lost: told_lost,
        lost_share: Amount::share(lost, whole),
        end,
        table: table(&places, meeting_time, end),
        track: track(world, &places, compared.as_ref()),
        places,
        velocities: velocities(record, 0),
        bars: vec![momenta("Momentum", record, 0), energies(record)],
        contact: record.impacts.first().and_then(|_| magnified(world)),
        problem,
        compared,
    }
}

fn sentence(meeting: Option<&Meeting>, problem: &ProblemOf) -> String {
    match (meeting, problem.impossible()) {
        (Some(Meeting { time, impulse }), _) => {
            format!("They meet after {}; B takes the impulse {} from A.", time.text, impulse.text)
        }
        (None, Some(reason)) => format!("No impact: {reason}."),
        (None, None) => "No impact.".to_owned(),
    }
}

fn table(places: &[Curve], meeting: Option<f64>, end: f64) -> Vec<Vec<Amount>> {
    let row = |time: f64| {
        let at = places.iter().filter_map(|curve| curve.at(time)).map(|place| Amount::new(place, end, "m"));
        [Amount::new(time, end, "s")].into_iter().chain(at).collect()
    };
    [Some(0.0), meeting, Some(end)].into_iter().flatten().map(row).collect()
}

/// The part of the track that must be seen: both bodies at all times, those of a wrong method included.
fn track(world: &World<1>, places: &[Curve], compared: Option<&Compared>) -> [f64; 2] {
    let radius = world.bodies.iter().map(|body| body.radius).fold(0.0, f64::max);
    let wrong = compared.iter().flat_map(|compared| &compared.places);
    let all = places.iter().chain(wrong).flat_map(|curve| &curve.points).map(|[_, place]| *place);
    let (low, high) =
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| (low.min(place), high.max(place)));
    [low - radius, high + radius]
}
