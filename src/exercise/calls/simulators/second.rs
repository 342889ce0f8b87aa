//! A second ball beside the first, of another coefficient of restitution, dropped at the same time from the same height.

use serde::Serialize;

use momentous_simulate::{BounceTrain, Budget, ClosedForm, Method, Record, RungeKutta};

use super::super::Limits;
use super::bounces::{Bounce, bounces, envelope};
use super::drop::{Drop, GRAVITY, LONGEST, TOLERANCES};
use super::{Amount, Curve, Refused, not_run};

/// The second ball.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Second {
    /// Its release and its bounces.
    pub bounces: Vec<Bounce>,
    /// When it lies still; nothing where no formula says so.
    pub rests: Option<Amount>,
    /// Its height, and the line through the peaks.
    #[serde(skip)]
    pub(super) places: [Curve; 2],
    /// The whole record.
    #[serde(skip)]
    pub(super) record: Record,
}

/// The second ball, watched until it lies still or, where the first is watched longer, as long as that.
pub(super) fn second(drop: &Drop, first_end: f64, limits: &Limits) -> Result<Second, Refused> {
    let world = drop.world();
    let train = BounceTrain::new(drop.height, GRAVITY, 1.0 - drop.restitution);
    let has_end = drop.restitution < 1.0 && drop.terminal == 0.0;
    let run = if drop.terminal > 0.0 {
        let budget =
            Budget::until(first_end.min(LONGEST)).at_most(limits.simulator_impacts).steps(limits.simulator_steps);
        RungeKutta { tolerance: TOLERANCES[0] }.run(&world, &budget)
    } else {
        ClosedForm.run(&world, &Budget::until(if has_end { train.end() } else { first_end }))
    };
    let run = run.map_err(|reason| not_run(&reason))?;
    let record = Record::of(&world, &run, 0.0);
    let bounces = bounces(&run, drop.height, limits.bounces as usize);
    Ok(Second {
        rests: has_end.then(|| Amount::new(train.end(), 0.0, "s")),
        places: [
            Curve::place("B", "body-1", &record, [0, 0]),
            Curve { role: "body-1", ..envelope("peaks of B", &bounces) },
        ],
        bounces,
        record,
    })
}
