//! Which usual mistake is behind a wrong yes or no about a scene.

use crate::laws::wrong::Misconception;
use crate::laws::wrong::concept;
use crate::model::Agent;
use crate::model::Builder;
use crate::scene::Stage;

use super::ask::Conservable;
use super::ask::Conserved;

/// What leads to the wrong answer on whether a quantity is conserved in a stage.
pub(super) fn conserved(
    ask: &Conserved,
    builder: &Builder<'_>,
    stage: usize,
    holds: bool,
) -> Option<&'static Misconception> {
    let inner = |agent: &Agent| matches!(agent, Agent::Body(other) if ask.of.contains(other));
    let on_it = || builder.impulses().iter().filter(|own| own.stage == stage && ask.of.contains(&own.on));
    match (ask.conserved, holds) {
        (Conservable::Momentum, true) => {
            loses_energy(builder.scene().stages.get(stage)?).then_some(&concept::MOMENTUM_BY_ENERGY)
        }
        (Conservable::Momentum, false) => {
            let by_bodies = on_it().filter(|own| !inner(&own.by)).all(|own| matches!(own.by, Agent::Body(_)));
            Some(if by_bodies { &concept::PART_FOR_SYSTEM } else { &concept::OUTSIDE_OVERLOOKED })
        }
        (Conservable::Energy, false) => {
            let keeps_momentum = on_it().next().is_some() && on_it().all(|own| inner(&own.by));
            keeps_momentum.then_some(&concept::ENERGY_BY_MOMENTUM)
        }
        (Conservable::AngularMomentum, true) => Some(&concept::ANGULAR_BY_LINEAR),
        (Conservable::Energy, true) | (Conservable::AngularMomentum, false) => None,
    }
}

/// What leads to the wrong answer on whether a force is impulsive.
pub(super) fn impulsive(holds: bool) -> &'static Misconception {
    if holds { &concept::IMPULSIVE_AS_ORDINARY } else { &concept::ORDINARY_AS_IMPULSIVE }
}

/// Whether the kinetic energy of the bodies together may change, though momentum does not.
fn loses_energy(stage: &Stage) -> bool {
    match stage {
        Stage::Impact(impact) => !impact.elastic,
        Stage::Interact(own) => !own.elastic,
        Stage::Separate(_) | Stage::Taut(_) | Stage::Walk(_) | Stage::SlideOff(_) => true,
        _ => false,
    }
}
