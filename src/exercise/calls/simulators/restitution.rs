//! The restitution simulator: a ball that is dropped and bounces, in a vacuum or in air.

use serde::Serialize;

use momentous_simulate::{
    Body, BounceTrain, Budget, ClosedForm, Force, Method, Record, RungeKutta, Trajectory, Vector, Wall, World,
};

use super::super::{Engine, Limits};
use super::bounces::{Bounce, bounces, envelope, phases};
use super::compared::Compared;
use super::controls::{RESTITUTION, SimulatorRequest, outside, set};
use super::{Amount, Curve, Phase, ProblemOf, Refused, RefusedKind, not_run};

/// The problem whose scene this is.
const PROBLEM: &str = "bouncing/rubber-ball";

/// The acceleration of free fall in m/s², as problems have it.
const GRAVITY: f64 = 9.81;

/// The ball is watched until it rises to less than this share of its height.
const LOW: f64 = 0.0025;

/// Why the times and the paths of all bounces have no sum.
const FOR_EVER_ON: &str =
    "Without a loss every flight is as long as the one before: times and paths add up without a limit.";

/// Why the problem has no solution then.
const NO_LIMIT: &str = "it asks when the ball lies still, and without a loss it never does: the flights are equally long, and the sum \
                        of their times has no limit";

const NO_FORMULA: &str = "In air no formula here gives the time and the path of all bounces.";

/// The bounces that are watched where nothing is lost.
const FOR_EVER: u32 = 8;

/// The tolerance of what is shown in air, and that of the run that it is compared with.
const TOLERANCES: [f64; 2] = [1e-9, 1e-12];

/// The longest run in air, in s of the scene.
const LONGEST: f64 = 300.0;

/// Everything that the page of the bouncing ball shows.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RestitutionResponse {
    /// What happens, in a sentence.
    pub told: String,
    /// What the ball does, one after another.
    pub phases: Vec<Phase>,
    /// The release and the bounces.
    pub bounces: Vec<Bounce>,
    /// The bounce to look at; nothing where the ball lies still before.
    pub looked_at: Option<LookedAt>,
    /// When all bounces are over, and how long the path is; nothing where no formula says so.
    pub sums: Option<Sums>,
    /// Why there are no such sums, in a sentence.
    pub no_sums: Option<&'static str>,
    /// How long the ball is watched, in s.
    pub end: f64,
    /// From where to where it goes, in m.
    pub track: [f64; 2],
    /// Its height, and the line through the peaks.
    pub places: Vec<Curve>,
    /// Its velocity, upwards positive.
    pub velocity: Curve,
    /// How the motion was found, and how far it is right.
    pub how: String,
    /// The scene as a problem, without air.
    pub problem: ProblemOf,
    /// A method beside it.
    pub compared: Option<Compared>,
}

/// A bounce and the one before it, with the two ratios.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LookedAt {
    /// The height before it.
    pub from: Amount,
    /// The bounce.
    pub bounce: Bounce,
    /// The speed after it over the speed before.
    pub speeds: Amount,
    /// The height after it over the height before.
    pub heights: Amount,
}

/// Sums over all bounces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sums {
    /// When the ball lies still.
    pub time: Amount,
    /// How long its path is until then.
    pub path: Amount,
}

impl Engine<'_> {
    /// The bouncing ball with these values.
    ///
    /// # Errors
    /// Where a value makes no scene, lies outside its limits, or the method is unknown or would take too many steps.
    pub fn restitution(&self, request: &SimulatorRequest) -> Result<RestitutionResponse, Refused> {
        let values: [f64; 4] = request.values(RESTITUTION)?;
        let [height, restitution, number, terminal] = values;
        let mut problem = self.problem_of(PROBLEM, set(RESTITUTION, &values))?;
        let mut world = dropped(height, restitution);
        if let Err(reason) = world.check() {
            let refused = not_run(&reason);
            return Err(problem
                .impossible()
                .cloned()
                .map_or(refused, |reason| Refused::new(RefusedKind::Values, reason)));
        }
        if let Some(refused) = outside(RESTITUTION, &values) {
            return Err(refused);
        }
        let number = whole(number, self.limits.bounces)?;
        if restitution >= 1.0 {
            problem.reason = Some(NO_LIMIT.to_owned());
        } else if let Some(reason) = problem.impossible() {
            return Err(Refused::new(RefusedKind::Values, reason.clone()));
        }
        let train = BounceTrain::new(height, GRAVITY, 1.0 - restitution);
        let most = watched(restitution, self.limits.bounces).max(number);
        let (run, how) = if terminal > 0.0 {
            world.forces.push(Force::Drag { body: 0, coefficient: GRAVITY / (terminal * terminal) });
            in_air(&world, most, &self.limits)?
        } else {
            let rests = libm::pow(restitution, 2.0 * f64::from(most)) < LOW;
            let end = if rests { train.end() } else { train.time_of(u64::from(most) + 1) };
            let run = ClosedForm.run(&world, &Budget::until(end)).map_err(|reason| not_run(&reason))?;
            (run, "Exact: a formula for each flight.".to_owned())
        };
        let record = Record::of(&world, &run, 0.0);
        let compared = match &request.method {
            None => None,
            Some(name) => {
                // Step-free methods count the same bounces; the others may bounce more often.
                let impacts = run.impact_count.max(1).min(self.limits.simulator_impacts);
                let limits = Limits { simulator_impacts: impacts, ..self.limits };
                Some(Compared::of(&world, &record, name, request.step, &limits)?)
            }
        };
        let sums = match (terminal > 0.0, restitution < 1.0) {
            (false, true) => Ok(sums(&train, &problem)),
            (false, false) => Err(FOR_EVER_ON),
            (true, _) => Err(NO_FORMULA),
        };
        Ok(shown(&run, &record, (most, number), sums, how, problem, compared))
    }
}

/// A particle of 1 kg above a level floor: its mass decides nothing that is shown.
fn dropped(height: f64, restitution: f64) -> World<1> {
    let mut world = World::new(restitution);
    world.gravity = Vector::from([-GRAVITY]);
    world.bodies.push(Body::particle("ball", 1.0, [height], [0.0]));
    world.walls.push(Wall::new("floor", [1.0], 0.0));
    world
}

/// A number of bounces.
fn whole(number: f64, most: u32) -> Result<u32, Refused> {
    (1..=most).find(|own| f64::from(*own).total_cmp(&number).is_eq()).ok_or_else(|| {
        let message = format!("`n` is a number of bounces, 1, 2, 3, ... {most}, and {number} is none");
        Refused::new(RefusedKind::Values, message)
    })
}

/// The bounces that are watched.
fn watched(restitution: f64, most: u32) -> u32 {
    if restitution >= 1.0 {
        return FOR_EVER.min(most);
    }
    let low = |bounces: &u32| libm::pow(restitution, 2.0 * f64::from(*bounces)) < LOW;
    (1..most).find(low).unwrap_or(most)
}

/// The motion in air by the only method that has it accurately, and the difference that a finer tolerance makes.
fn in_air(world: &World<1>, bounces: u32, limits: &Limits) -> Result<(Trajectory<1>, String), Refused> {
    let budget = Budget::until(LONGEST).at_most(bounces as usize + 1).steps(limits.simulator_steps);
    let [run, finer] = TOLERANCES.map(|tolerance| RungeKutta { tolerance }.run(world, &budget));
    let (run, finer) = (run.map_err(|reason| not_run(&reason))?, finer.map_err(|reason| not_run(&reason))?);
    let off = run.impacts.iter().zip(&finer.impacts).map(|(one, other)| (one.time - other.time).abs());
    let off = Amount::new(off.fold(0.0, f64::max), 1e-3, "s");
    let how = format!(
        "In air there is no formula here: Runge\u{2013}Kutta 5(4) with a tolerance of 10\u{207b}\u{2079}. The times of the bounces \
         change by at most {} when the tolerance is a thousand times finer.",
        off.text
    );
    Ok((run, how))
}

fn sums(train: &BounceTrain, problem: &ProblemOf) -> Sums {
    let answers = problem.solved.as_ref().map(|solved| solved.answers.as_slice()).unwrap_or_default();
    let total = answers.iter().find(|answer| answer.id == "t_total").and_then(|own| Some((own.value?, &own.printed)));
    let time = match total {
        Some((value, printed)) => Amount::with_text(value, printed),
        None => Amount::new(train.end(), 0.0, "s"),
    };
    Sums { time, path: Amount::new(train.path(), 0.0, "m") }
}

fn shown(
    run: &Trajectory<1>,
    record: &Record,
    (most, number): (u32, u32),
    sums: Result<Sums, &'static str>,
    how: String,
    problem: ProblemOf,
    compared: Option<Compared>,
) -> RestitutionResponse {
    let height = record.moments.first().and_then(|moment| moment.positions.first()?.first().copied()).unwrap_or(0.0);
    let bounces = bounces(run, height, most as usize);
    let end = record.moments.last().map_or(0.0, |moment| moment.time);
    let looked_at = bounces.windows(2).find_map(|pair| match pair {
        [before, bounce] if bounce.number == number as usize => Some(LookedAt {
            from: before.height.clone(),
            speeds: Amount::new(-bounce.after.value / bounce.before.value, 1.0, ""),
            heights: Amount::new(bounce.height.value / before.height.value, 1.0, ""),
            bounce: bounce.clone(),
        }),
        _ => None,
    });
    let velocity = record.moments.iter().filter_map(|moment| Some([moment.time, *moment.velocities.first()?.first()?]));
    let rests = sums.as_ref().is_ok_and(|sums| sums.time.value <= end * (1.0 + 1e-9));
    let told = match &sums {
        Ok(sums) => format!("It lies still after {}, on a path of {}.", sums.time.text, sums.path.text),
        Err(FOR_EVER_ON) => "Nothing is lost: it bounces for ever.".to_owned(),
        Err(_) => {
            "With air resistance it rises less each time than its coefficient of restitution alone would make it."
                .to_owned()
        }
    };
    RestitutionResponse {
        told,
        phases: phases(&bounces, end, rests),
        looked_at: looked_at.filter(|own| own.speeds.value.is_finite()),
        no_sums: sums.as_ref().err().copied(),
        sums: sums.ok(),
        end,
        track: [0.0, height],
        places: vec![Curve::place("ball", "body-0", record, 0), envelope(&bounces)],
        velocity: Curve::new("velocity", "body-2", velocity),
        bounces,
        how,
        problem,
        compared,
    }
}
