//! By which principle a solution deals with a stage, so that its figure is that of the principle.

use momentous_laws::Law;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_laws::kinematics;
use momentous_laws::motion;
use momentous_laws::resistance;

use super::super::reach::laws_used;
use super::quantities::Quantities;

/// Laws that speak neither of momentum nor of an impulse.
const OTHERS: [&[&Law]; 3] = [energy::LAWS, motion::LAWS, resistance::LAWS];
/// The same, one by one.
const OTHER: [&Law; 6] = [
    &kinematics::FALL_SPEED,
    &kinematics::DISPLACED,
    &force::NORMAL_FORCE,
    &force::THRESHOLD,
    &force::HOOKE,
    &force::FRICTION,
];

/// Whether a solution deals with a stage without momentum; not where nothing is solved of it.
pub(super) fn is_without_momentum(quantities: &Quantities<'_>, stage: usize) -> bool {
    let mut laws = laws_used(quantities.worked).filter(|law| law.stage == Some(stage)).peekable();
    let is_other = |law: &Law| OTHERS.into_iter().flatten().chain(&OTHER).any(|other| other.id == law.id);
    laws.peek().is_some() && laws.all(|instance| is_other(instance.law))
}
