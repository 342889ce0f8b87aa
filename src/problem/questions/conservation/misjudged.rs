//! Which common mistake is behind a wrong yes or no about a scene.

use momentous_laws::wrong::concept;
use momentous_model::Agent;
use momentous_model::Builder;

use super::super::super::language::ask::Conservable;
use super::super::super::reading::load::Loaded;
use super::super::choices::judgement::Behind;
use super::balance::Balance;
use super::verdict::verdict;

/// The positions of yes and no.
const YES: usize = 0;
const NO: usize = 1;

/// The mistakes that lead to the wrong answer on whether a quantity is conserved in a stage.
pub(crate) fn conserved(loaded: &Loaded, balance: &Balance<'_>, builder: &mut Builder<'_>) -> Option<Behind> {
    let bodies = &balance.ask.of;
    let inner = |agent: &Agent| matches!(agent, Agent::Body(other) if bodies.contains(other));
    let on_it: Vec<Agent> = (builder.impulses().iter())
        .filter(|impulse| impulse.stage == balance.stage && bodies.contains(&impulse.on))
        .map(|impulse| impulse.by.clone())
        .collect();
    let from_outside: Vec<&Agent> = on_it.iter().filter(|agent| !inner(agent)).collect();
    let behind = |mistake, right, unless| Some(Behind { mistake, right, unless });
    match balance.ask.conserved {
        Conservable::Momentum if from_outside.is_empty() => {
            let energy = verdict(loaded, balance, Conservable::Energy, builder)?;
            let loses = !energy.tests.is_empty();
            loses.then_some(())?;
            behind(&concept::MOMENTUM_BY_ENERGY, YES, energy.tests)
        }
        Conservable::Momentum => {
            let by_bodies = from_outside.iter().all(|agent| matches!(agent, Agent::Body(_)));
            let mistake = if by_bodies { &concept::PART_FOR_SYSTEM } else { &concept::OUTSIDE_OVERLOOKED };
            behind(mistake, NO, Vec::new())
        }
        Conservable::Energy if !on_it.is_empty() && from_outside.is_empty() => {
            behind(&concept::ENERGY_BY_MOMENTUM, NO, Vec::new())
        }
        Conservable::Energy => None,
        Conservable::AngularMomentum => behind(&concept::ANGULAR_BY_LINEAR, YES, Vec::new()),
    }
}
