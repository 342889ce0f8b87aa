//! The collision in the plane: two smooth discs on an air table, whose centres pass each other at a distance, the impact parameter.

use serde::Serialize;

use momentous_simulate::{Body, Budget, EventDriven, Method, Record, Trajectory, Vector, World};

use super::super::Engine;
use super::balance::{Balance, balance};
use super::bars::{Bars, energies, momenta, velocities};
use super::controls::{DISCS, SimulatorRequest, outside, set};
use super::curve::places;
use super::meeting::{Meeting, phases};
use super::{Amount, Curve, Phase, ProblemOf, Refused, not_run};

/// The problem whose scene this is.
const PROBLEM: &str = "impact/hockey-pucks";

/// The radius of either disc, in m.
const RADIUS: f64 = 0.4;

/// How far the centres are apart along the velocities at the start, in m.
const APART: f64 = 4.0;

/// How much longer than up to the impact the discs are watched.
const WATCHED: f64 = 1.8;

/// The limits of watching discs that never meet: until the faster has gone so far (m), at most for so long (s).
const WAY: f64 = 8.0;
const LONGEST: f64 = 6.0;

/// Everything that the page of the two discs shows.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DiscsResponse {
    /// The course of events, in a sentence.
    pub told: String,
    /// The phases of the discs' motion, one after another.
    pub phases: Vec<Phase>,
    /// The impact, where there is one; its impulse is along the line of impact.
    pub meeting: Option<Meeting>,
    /// How far the line of impact points above the first axis; nothing where they miss each other.
    pub line_of_impact: Option<Amount>,
    /// The two discs.
    pub bodies: Vec<Disc>,
    /// The components of momentum before and after.
    pub momentum: [Vec<Balance>; 2],
    /// The same of the kinetic energy.
    pub energy: Vec<Balance>,
    /// The kinetic energy lost.
    pub lost: Amount,
    /// The same as a share.
    pub lost_share: Amount,
    /// The time for which the discs are watched, in s.
    pub end: f64,
    /// From where to where they go along each axis, in m.
    pub table: [[f64; 2]; 2],
    /// The places of the discs and their centre of mass along the first axis.
    pub places: Vec<Curve>,
    /// The same along the second.
    pub heights: Vec<Curve>,
    /// Their velocities along each axis, in the same order.
    pub velocities: [Vec<Curve>; 2],
    /// Their momenta and energies, for the bars beside the scene.
    pub bars: Vec<Bars>,
    /// The scene as a problem.
    pub problem: ProblemOf,
}

/// A disc.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Disc {
    /// Its name.
    pub name: &'static str,
    /// Its radius, in m.
    pub radius: f64,
    /// Its velocity before, along each axis.
    pub before: [Amount; 2],
    /// The same after.
    pub after: [Amount; 2],
    /// Its speed after.
    pub speed: Amount,
    /// The direction of that, counter-clockwise from the first axis; nothing for a disc at rest.
    pub angle: Option<Amount>,
}

impl Engine<'_> {
    /// The collision in the plane with these values.
    ///
    /// # Errors
    /// Where a value makes no scene, or lies outside its limits.
    pub fn discs(&self, request: &SimulatorRequest) -> Result<DiscsResponse, Refused> {
        let values: [f64; 6] = request.values(DISCS)?;
        let [mass_a, velocity_a, mass_b, velocity_b, beside, restitution] = values;
        let line = line_of_impact(beside);
        let problem = self.discs_problem(&values, line)?;
        // The scene has the angle that the problem tells.
        let beside = line.map_or(beside, |degrees| 2.0 * RADIUS * libm::sin(degrees.to_radians()));
        let mut world = World::<2>::new(restitution);
        world.bodies.push(Body::sphere("A", mass_a, RADIUS, [-APART / 2.0, -beside / 2.0], [velocity_a, 0.0]));
        world.bodies.push(Body::sphere("B", mass_b, RADIUS, [APART / 2.0, beside / 2.0], [velocity_b, 0.0]));
        if let Err(reason) = world.check() {
            return Err(problem.refused(&reason));
        }
        if let Some(refused) = outside(DISCS, &values) {
            return Err(refused);
        }
        let closing = velocity_a - velocity_b;
        let apart = APART - line.map_or(0.0, |degrees| 2.0 * RADIUS * libm::cos(degrees.to_radians()));
        let fastest = velocity_a.abs().max(velocity_b.abs());
        let end = if closing > 0.0 { WATCHED * apart / closing } else { (WAY / fastest).min(LONGEST) };
        let run = EventDriven.run(&world, &Budget::until(end)).map_err(|reason| not_run(&reason))?;
        Ok(shown(&world, &run, line, problem))
    }

    /// The problem with these values; without a line of impact there is none.
    fn discs_problem(&self, values: &[f64], line: Option<f64>) -> Result<ProblemOf, Refused> {
        let mut settings = set(DISCS, values);
        let Some(line) = line else {
            let reason = "the discs pass each other without touching".to_owned();
            return Ok(ProblemOf { id: PROBLEM, set: settings, solved: None, reason: Some(reason), hidden: false });
        };
        let level = |name| (name, "0 m/s".to_owned());
        settings.extend([level("v_A1.y"), level("v_B1.y"), ("alpha", format!("{line} deg"))]);
        self.problem_of(PROBLEM, settings)
    }
}

/// How far the line from A to B points above the first axis when they touch, in degrees to two decimals; nothing where they miss.
fn line_of_impact(beside: f64) -> Option<f64> {
    let sine = beside / (2.0 * RADIUS);
    (sine.abs() < 1.0).then(|| (100.0 * libm::asin(sine).to_degrees()).round() / 100.0 + 0.0)
}

fn shown(world: &World<2>, run: &Trajectory<2>, line: Option<f64>, problem: ProblemOf) -> DiscsResponse {
    let record = &Record::of(world, run, 0.0);
    let end = run.last.time;
    let before: Vec<Vector<2>> = world.bodies.iter().map(|body| body.velocity).collect();
    let after = run.last.velocities.as_slice();
    let each = |quantity: &dyn Fn(f64, &Vector<2>) -> f64, velocities: &[Vector<2>]| -> Vec<f64> {
        world.bodies.iter().zip(velocities).map(|(body, velocity)| quantity(body.mass, velocity)).collect()
    };
    let balance = |quantity: &dyn Fn(f64, &Vector<2>) -> f64, unit| {
        balance(&each(quantity, &before), &each(quantity, after), unit)
    };
    let momentum = [0, 1].map(|axis| balance(&|mass, velocity| mass * velocity[axis], "kg\u{a0}m/s"));
    let energy = balance(&|mass, velocity| mass * velocity.norm_squared() / 2.0, "J");
    let whole = record.moments.first().map_or(0.0, |moment| moment.kinetic);
    let lost = record.moments.last().map_or(0.0, |moment| moment.lost);
    let meeting = record.impacts.first().map(|impact| Meeting {
        time: Amount::new(impact.time, impact.time, "s"),
        impulse: Amount::new(length(&impact.impulse), 0.0, "N\u{a0}s"),
    });
    let [places, heights] = [0, 1].map(|axis| places(record, axis));
    DiscsResponse {
        told: sentence(meeting.as_ref(), line, &problem),
        phases: phases(meeting.as_ref(), end),
        line_of_impact: line.map(angle),
        bodies: discs(&before, after, &problem),
        momentum,
        energy,
        lost: Amount::new(lost, whole, "J"),
        lost_share: Amount::share(lost, whole),
        end,
        table: [reach(&places), reach(&heights)],
        places,
        heights,
        velocities: [velocities(record, 0), velocities(record, 1)],
        bars: vec![momenta("Momentum along x", record, 0), momenta("Momentum along y", record, 1), energies(record)],
        meeting,
        problem,
    }
}

fn discs(before: &[Vector<2>], after: &[Vector<2>], problem: &ProblemOf) -> Vec<Disc> {
    let scale = before.iter().map(Vector::norm).fold(0.0, f64::max);
    let answers = problem.solved.as_ref().map(|solved| solved.answers.as_slice()).unwrap_or_default();
    let answer = |id: &str| {
        let answer = answers.iter().find(|answer| answer.id == id)?;
        Some(Amount::with_text(answer.value?, &answer.printed))
    };
    let asked = [("A", "speed_A2", "angle_A2"), ("B", "speed_B2", "angle_B2")];
    let both = asked.into_iter().zip(before.iter().zip(after));
    both.map(|((name, speed, direction), (old, new))| {
        let size = new.norm();
        let degrees = libm::atan2(new.y, new.x).to_degrees().rem_euclid(360.0);
        let components = |velocity: &Vector<2>| [0, 1].map(|axis| Amount::new(velocity[axis], scale, "m/s"));
        Disc {
            name,
            radius: RADIUS,
            before: components(old),
            after: components(new),
            speed: answer(speed).unwrap_or_else(|| Amount::new(size, scale, "m/s")),
            angle: answer(direction).or_else(|| (size > 1e-9 * scale).then(|| angle(degrees))),
        }
    })
    .collect()
}

fn sentence(meeting: Option<&Meeting>, line: Option<f64>, problem: &ProblemOf) -> String {
    match (meeting, line, problem.impossible()) {
        (Some(Meeting { time, impulse }), Some(line), _) => {
            let (time, line, impulse) = (&time.text, angle(line).text, &impulse.text);
            format!(
                "They meet after {time}, the line from A to B {line} above the x-axis; along it B takes the impulse {impulse} \
                 from A."
            )
        }
        (_, _, Some(reason)) => format!("No impact: {reason}."),
        _ => "No impact.".to_owned(),
    }
}

/// The extent that must be seen: both discs at all times.
fn reach(curves: &[Curve]) -> [f64; 2] {
    let all = curves.iter().flat_map(|curve| &curve.points).map(|[_, place]| *place);
    let (low, high) =
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| (low.min(place), high.max(place)));
    [low - RADIUS, high + RADIUS]
}

/// An angle in degrees, whose sign stands at the number.
fn angle(degrees: f64) -> Amount {
    let number = Amount::new(degrees, 360.0, "");
    Amount { text: format!("{}°", number.text), ..number }
}

fn length(vector: &[f64]) -> f64 {
    libm::sqrt(vector.iter().map(|part| part * part).sum())
}
