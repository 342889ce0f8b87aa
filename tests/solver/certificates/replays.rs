//! Which replay decided makes no difference: the same numbers are drawn and the same roots taken where every replay is exact.

use momentous::problem::{NoVariant, Problem, Sampler, Variant};
use momentous::solve::{Bounded, Cause, Precision};

use crate::variants::{bank, form_name, seeds};

/// What is decided of a variant.
#[derive(Debug, PartialEq)]
struct Decided {
    given: Vec<String>,
    regime: usize,
    roots: Vec<usize>,
    dead: Vec<(Option<usize>, Cause)>,
    has_others: bool,
}

impl Decided {
    fn of(variant: &Variant) -> Self {
        Self {
            given: variant.all_given().iter().map(|(_, value, unit)| format!("{value} {unit}")).collect(),
            regime: variant.leaf(),
            roots: variant.roots().to_vec(),
            dead: variant.dead().iter().map(|dead| (dead.step, dead.cause)).collect(),
            has_others: variant.has_others(),
        }
    }
}

/// Whether both may be bounds of the same value.
fn overlap(one: Option<Bounded>, other: Option<Bounded>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => (one.value - other.value).abs() <= one.error + other.error,
        (one, other) => one.is_none() && other.is_none(),
    }
}

fn differences(problem: &Problem, form: usize) -> Vec<String> {
    let sampler = |precision| Sampler::with_precision(problem, form, precision).unwrap();
    let (mut usual, mut exact) = (sampler(Precision::OnDemand), sampler(Precision::Exact));
    let mut found = Vec::new();
    for seed in 0..seeds(20) {
        let name = format!("{} {} seed {seed}", problem.loaded().draft.id, form_name(problem, form));
        match (usual.variant(seed), exact.variant(seed)) {
            (Ok(usual), Ok(exact)) => {
                let (decided, expected) = (Decided::of(&usual), Decided::of(&exact));
                if decided != expected {
                    found.push(format!("{name}: {decided:?}, exactly {expected:?}"));
                }
                for (symbol, entry) in problem.model().symbols.iter() {
                    let (usual, exact) = (usual.value(symbol), exact.value(symbol));
                    if !overlap(usual, exact) {
                        found.push(format!("{name}: {}: {usual:?}, exactly {exact:?}", entry.name));
                    }
                }
            }
            (Err(NoVariant::Exhausted(_)), Err(NoVariant::Exhausted(_))) => {}
            (usual, exact) => found.push(format!("{name}: drawn {}, exactly {}", usual.is_ok(), exact.is_ok())),
        }
    }
    if usual.rejected() != exact.rejected() {
        found.push(format!(
            "{}: {} rejected, exactly {}",
            problem.loaded().draft.id,
            usual.rejected(),
            exact.rejected()
        ));
    }
    found
}

#[test]
fn what_is_drawn_and_decided_does_not_depend_on_the_replay() {
    let found: Vec<String> = bank()
        .iter()
        .flat_map(|problem| (0..problem.forms().len()).flat_map(|form| differences(problem, form)).collect::<Vec<_>>())
        .collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}
