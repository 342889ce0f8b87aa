//! A numerical method beside the exact motion: where it goes wrong, and what it costs.

use serde::Serialize;

use momentous_simulate::{Budget, Ending, Keep, MethodKind, Moment, Record, Setting, World};

use super::{Amount, Curve, Limits, Refused, RefusedKind};

/// The step where none is said, in s: the usual collision does not happen at the end of one.
pub const USUAL_STEP: f64 = 0.06;

/// The methods that can be compared. The others are formulas for scenes without a way to the impact.
const METHODS: [MethodKind; 7] = [
    MethodKind::EventDriven,
    MethodKind::RungeKutta,
    MethodKind::ExplicitEuler,
    MethodKind::SymplecticEuler,
    MethodKind::MoreauJean,
    MethodKind::Penalty,
    MethodKind::SequentialImpulses,
];

/// A method that can be chosen.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Offered {
    /// How it is typed.
    pub typed: String,
    /// Its name.
    pub name: &'static str,
}

impl Offered {
    /// All of them.
    #[must_use]
    pub fn all() -> Vec<Self> {
        METHODS.iter().map(|kind| Self { typed: kind.typed(), name: kind.name() }).collect()
    }
}

/// A method beside the exact motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Compared {
    /// Its name.
    pub name: &'static str,
    /// Its step or tolerance, in words.
    pub setting: String,
    /// The step in s, where it has one.
    pub step: Option<f64>,
    /// Why it does not treat this scene; nothing else is said then.
    pub refused: Option<String>,
    /// Whether it gave up before the end, in words.
    pub broke_off: Option<String>,
    /// The place of each body.
    pub places: Vec<Curve>,
    /// The drifts of the balances, as shares: of momentum (of the greatest of any body) and of energy (of that at the start).
    pub drifts: Vec<Curve>,
    /// The errors in numbers.
    pub rows: Vec<Row>,
}

/// A number of a method, in a sentence of the table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Its name.
    pub what: String,
    /// How large it is.
    pub amount: Amount,
}

impl Compared {
    /// Runs the method of that name on the scene, until the exact run ends.
    pub(super) fn of(
        world: &World<1>,
        exact: &Record,
        name: &str,
        step: Option<f64>,
        limits: &Limits,
    ) -> Result<Self, Refused> {
        let kind = MethodKind::named(name).map_err(|message| Refused::new(RefusedKind::Unknown, message))?;
        let end = exact.moments.last().map_or(0.0, |moment| moment.time);
        let (step, setting) = setting(kind, step, end, limits.simulator_steps)?;
        let budget = Budget::until(end).steps(limits.simulator_steps).at_most(limits.simulator_impacts);
        let mut compared = Self {
            name: kind.name(),
            setting,
            step,
            refused: None,
            broke_off: None,
            places: Vec::new(),
            drifts: Vec::new(),
            rows: Vec::new(),
        };
        let method = kind.with::<1>(step.or(kind.usual_setting()).unwrap_or(0.0));
        match method.run(world, &budget.keep(Keep::Steps)) {
            Err(reason) => compared.refused = Some(reason.to_string()),
            Ok(run) => {
                if run.ending == Ending::Exhausted {
                    compared.broke_off = Some(format!("it gave up after {} steps", run.steps));
                }
                compared.place(&Record::of(world, &run, 0.0), exact);
                compared.balance(&Record::of_steps(world, &run), exact);
                let taken = Amount::with_text(count(run.steps), &run.steps.to_string());
                compared.rows.push(Row { what: "Steps".into(), amount: taken });
            }
        }
        Ok(compared)
    }

    /// Adds the places of the bodies, and how far they are from where they should be.
    fn place(&mut self, taken: &Record, exact: &Record) {
        for (body, recorded) in taken.bodies.iter().enumerate() {
            let name = format!("{}, {}", recorded.name, self.name);
            let role = ROLES[body.min(1)];
            let wrong = Curve::place(name, role, taken, [body, 0]).dashed();
            let right = Curve::place("", role, exact, [body, 0]);
            let off = wrong.points.iter().filter_map(|[time, up]| Some((up - right.at(*time)?).abs()));
            let size = right.points.iter().map(|[_, up]| up.abs()).fold(0.0, f64::max);
            let amount = Amount::new(off.fold(0.0, f64::max), 1e2 * size, "m");
            self.rows.push(Row { what: format!("Greatest error of the place of {}", recorded.name), amount });
            self.places.push(wrong);
        }
    }

    /// Adds the drift of the balances at the ends of steps.
    fn balance(&mut self, taken: &Record, exact: &Record) {
        let Some(first) = taken.moments.first() else { return };
        let momentum = |moment: &Moment| one(&moment.momentum) - one(&moment.outside);
        // Bodies that move against each other have little momentum together, and a ball at rest has none.
        let greatest = |moment: &Moment| {
            let each = moment.masses.iter().zip(&moment.velocities);
            each.map(|(mass, velocity)| (mass * one(velocity)).abs()).fold(0.0, f64::max)
        };
        let of_momentum = (momentum(first), exact.moments.iter().map(greatest).fold(0.0, f64::max));
        let of_energy = (first.balance(), first.balance());
        self.drift("momentum", "body-3", taken, of_momentum, momentum);
        self.drift("energy", "body-4", taken, of_energy, Moment::balance);
    }

    fn drift(
        &mut self,
        name: &str,
        role: &'static str,
        taken: &Record,
        (start, scale): (f64, f64),
        quantity: impl Fn(&Moment) -> f64,
    ) {
        let percent = |value: f64| {
            let share = if scale > 0.0 { 100.0 * (value - start) / scale } else { 0.0 };
            if share.abs() < ROUNDING { 0.0 } else { share }
        };
        let points = taken.moments.iter().map(|moment| [moment.time, percent(quantity(moment))]);
        let curve = Curve::new(name, role, points);
        let last = curve.points.last().map_or(0.0, |[_, drift]| *drift);
        self.rows.push(Row { what: format!("Drift of {name} at the end"), amount: Amount::new(last, 100.0, "%") });
        self.drifts.push(curve);
    }
}

/// The drift by rounding alone, in percent.
const ROUNDING: f64 = 1e-9;

/// The looks of the places, of the first body and of the second.
const ROLES: [&str; 2] = ["body-0", "body-1"];

/// The step that is taken, and the setting in words.
fn setting(kind: MethodKind, step: Option<f64>, end: f64, most: usize) -> Result<(Option<f64>, String), Refused> {
    match kind.setting() {
        Setting::None => Ok((None, "no step: each impact is located exactly".to_owned())),
        Setting::Tolerance => {
            Ok((None, format!("a step that adapts, tolerance {:e}", kind.usual_setting().unwrap_or(0.0))))
        }
        Setting::Step => {
            let step = step.unwrap_or(USUAL_STEP);
            if !(step > 0.0 && step.is_finite()) {
                return Err(Refused::new(RefusedKind::Values, format!("a step is a positive time, not {step:e} s")));
            }
            if end > step * count(most) {
                let message = format!("a step of {step:e} s would take more than {most} steps");
                return Err(Refused::new(RefusedKind::TooLarge, message).help("take a longer step"));
            }
            Ok((Some(step), format!("steps of {step} s")))
        }
    }
}

fn one(components: &[f64]) -> f64 {
    components.first().copied().unwrap_or(0.0)
}

#[allow(clippy::cast_precision_loss, reason = "counts of steps stay far below 2^53")]
fn count(steps: usize) -> f64 {
    steps as f64
}
