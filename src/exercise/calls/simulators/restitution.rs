//! The restitution simulator: a ball that is dropped and bounces, in a vacuum or in air.

use serde::Serialize;

use momentous_simulate::{BounceTrain, Budget, ClosedForm, Method, Moment, Record, RungeKutta, Trajectory, World};

use super::super::{Engine, Limits};
use super::bars::{Bars, over};
use super::bounces::{Bounce, bounces, envelope, phases};
use super::compared::Compared;
use super::controls::{RESTITUTION, SimulatorRequest, outside, set};
use super::drop::{Drop, GRAVITY, LONGEST, TOLERANCES};
use super::second::{Second, second};
use super::{Amount, Curve, Phase, ProblemOf, Refused, RefusedKind, not_run};

/// The problem whose scene this is.
const PROBLEM: &str = "bouncing/rubber-ball";

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

/// Everything that the page of the bouncing ball shows.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RestitutionResponse {
    /// The course of events, in a sentence.
    pub told: String,
    /// The phases of the ball's motion, one after another.
    pub phases: Vec<Phase>,
    /// The release and the bounces.
    pub bounces: Vec<Bounce>,
    /// The bounce to look at; nothing where the ball lies still before.
    pub looked_at: Option<LookedAt>,
    /// When all bounces are over, and how long the path is; nothing where no formula says so.
    pub sums: Option<Sums>,
    /// Why there are no such sums, in a sentence.
    pub no_sums: Option<&'static str>,
    /// The time for which the ball is watched, in s.
    pub end: f64,
    /// From where to where it goes, in m.
    pub track: [f64; 2],
    /// Its height, and the line through the peaks.
    pub places: Vec<Curve>,
    /// Its velocity, upwards positive.
    pub velocity: Curve,
    /// A second ball beside it, where one is wanted.
    pub second: Option<Second>,
    /// The velocities of the balls, upwards positive.
    pub velocities: Vec<Curve>,
    /// Their momenta and energies as shares, for the bars beside the scene.
    pub bars: Vec<Bars>,
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
        let beside = request.optional("e_2");
        let (mut problem, path) = self.problem_with(PROBLEM, set(RESTITUTION, &values), "path_total")?;
        let drop = Drop { height, restitution, terminal };
        let world = drop.world();
        if let Err(reason) = world.check() {
            return Err(problem.refused(&reason));
        }
        let with_second = values.iter().copied().chain(beside).collect::<Vec<f64>>();
        if let Some(refused) = outside(RESTITUTION, &with_second) {
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
            (false, true) => Ok(sums(&train, &problem, path)),
            (false, false) => Err(FOR_EVER_ON),
            (true, _) => Err(NO_FORMULA),
        };
        let end = record.moments.last().map_or(0.0, |moment| moment.time);
        let second = beside.map(|restitution| second(&Drop { restitution, ..drop }, end, &self.limits)).transpose()?;
        Ok(shown(&run, &record, (most, number), sums, how, problem, compared).with_second(second, &record))
    }
}

/// A number of bounces.
fn whole(number: f64, most: u32) -> Result<u32, Refused> {
    (1..=most).find(|bounces| f64::from(*bounces).total_cmp(&number).is_eq()).ok_or_else(|| {
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

/// The sums as the laws have them, where they say them: by a formula in doubles, a number in the middle between two of those that are
/// printed may fall to the other side.
fn sums(train: &BounceTrain, problem: &ProblemOf, path: Option<Amount>) -> Sums {
    let answers = problem.solved.as_ref().map(|solved| solved.answers.as_slice()).unwrap_or_default();
    let total =
        answers.iter().find(|answer| answer.id == "t_total").and_then(|part| Some((part.value?, &part.printed)));
    let time = match total {
        Some((value, printed)) => Amount::with_text(value, printed),
        None => Amount::new(train.end(), 0.0, "s"),
    };
    Sums { time, path: path.unwrap_or_else(|| Amount::new(train.path(), 0.0, "m")) }
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
        looked_at: looked_at.filter(|looked_at| looked_at.speeds.value.is_finite()),
        no_sums: sums.as_ref().err().copied(),
        sums: sums.ok(),
        end,
        track: [0.0, height],
        places: vec![Curve::place("ball", "body-0", record, [0, 0]), envelope("peaks", &bounces)],
        velocity: Curve::new("velocity", "body-2", velocity),
        second: None,
        velocities: Vec::new(),
        bars: Vec::new(),
        bounces,
        how,
        problem,
        compared,
    }
}

impl RestitutionResponse {
    /// With what is shown of both balls, or of the one.
    fn with_second(mut self, second: Option<Second>, record: &Record) -> Self {
        let balls = [Some(("A", "body-0", record)), second.as_ref().map(|shown| ("B", "body-1", &shown.record))];
        let balls: Vec<(&str, &'static str, &Record)> = balls.into_iter().flatten().collect();
        self.velocities = balls.iter().map(|(name, role, record)| over(record, name, role, velocity)).collect();
        self.bars = energies(&balls).collect();
        self.bars.insert(0, momenta(&self.velocities));
        if let Some(second) = &second {
            // The first lies where it came to rest; one that goes on is not watched any longer.
            let rests = self.sums.as_ref().is_some_and(|sums| sums.time.value <= self.end * (1.0 + 1e-9));
            let later = second.record.moments.last().map_or(0.0, |moment| moment.time);
            if rests {
                self.end = self.end.max(later);
            }
            if let Some(first) = self.places.first_mut() {
                "A".clone_into(&mut first.name);
            }
            let end = self.end;
            let watched = |curve: &Curve| {
                let points = curve.points.iter().copied().filter(|[time, _]| *time <= end).collect();
                Curve { points, ..curve.clone() }
            };
            self.places.extend(second.places.iter().map(watched));
        }
        self.second = second;
        self
    }
}

fn velocity(moment: &Moment) -> Option<f64> {
    moment.velocities.first()?.first().copied()
}

/// The momenta as shares of the greatest: the mass decides nothing that is shown.
fn momenta(velocities: &[Curve]) -> Bars {
    let greatest = Bars::new("", "", velocities.to_vec()).most;
    let share = |curve: &Curve| {
        let points = curve
            .points
            .iter()
            .map(|[time, velocity]| [*time, if greatest > 0.0 { 100.0 * velocity / greatest } else { 0.0 }]);
        Curve { points: points.collect(), ..curve.clone() }
    };
    Bars::new("Momentum", "% of the greatest", velocities.iter().map(share).collect())
}

/// The energies of each ball as shares of that at release.
fn energies<'a>(balls: &'a [(&'a str, &'static str, &'a Record)]) -> impl Iterator<Item = Bars> + 'a {
    balls.iter().filter_map(|(name, _, record)| {
        let whole = record.moments.first()?.balance();
        let share = |name: &str, role, energy: fn(&Moment) -> f64| {
            over(record, name, role, |moment| Some(100.0 * energy(moment) / whole))
        };
        let curves = vec![
            share("kinetic", "kinetic", |moment| moment.kinetic),
            share("potential", "potential", |moment| moment.potential),
            share("lost", "work", |moment| moment.lost - moment.work),
        ];
        let title = if balls.len() > 1 { format!("Energy of {name}") } else { "Energy".to_owned() };
        Some(Bars::new(title, "% of that at the start", curves))
    })
}
