//! Whether the simulations of many seeds agree with the laws.

use std::collections::BTreeSet;

use momentous_problem::Problem;
use momentous_simulate::scene::NothingToSimulate;
use momentous_simulate::scene::Procedure;
use momentous_witness::Portion;
use momentous_witness::Simulated;

use super::each::each;
use super::promise::Outcome;

/// Seeds that are simulated one after another; portions run beside each other.
const PORTION: usize = 16;

/// Whether simulations of a form agree with its variants, and how that was found.
pub(super) fn agrees(problem: &Problem, form: usize, seeds: u64) -> (Outcome, Simulated) {
    let portions: Vec<u64> = (1..=seeds).step_by(PORTION).collect();
    let portions = each(portions, |first| Portion::of(problem, form, first..=seeds.min(first + PORTION as u64 - 1)));
    let (mut simulated, mut ways, mut reason) = (Simulated::default(), BTreeSet::new(), None);
    for portion in portions {
        simulated.add(portion.simulated);
        ways.extend(portion.ways);
        reason = reason.or(portion.reason);
        if let Some(said) = portion.broken {
            return (Outcome::Broken(said), simulated);
        }
    }
    simulated.ways = ways.into_iter().map(Procedure::called).collect();
    let nothing = reason.unwrap_or(NothingToSimulate::NothingSolved).reason();
    let outcome = match (simulated.witnessed.is_empty(), simulated.unseen.is_empty()) {
        _ if simulated.seeds == 0 => Outcome::NotChecked("nothing was drawn"),
        (true, _) => Outcome::NotChecked(nothing),
        (false, true) => Outcome::Kept,
        (false, false) => Outcome::Noted(format!("no simulation finds {}: {nothing}", simulated.unseen.join(", "))),
    };
    if !simulated.unseen.is_empty() {
        simulated.nothing = Some(nothing);
    }
    (outcome, simulated)
}
