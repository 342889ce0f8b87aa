//! A cache of units that were read before: people write the same few again and again. Without it, marking takes more than twice
//! as long (`docs/performance.md`).

use std::cell::RefCell;
use std::collections::HashMap;

use momentous_quantity::Unit;
use momentous_quantity::UnitFault;
use momentous_quantity::UnitFaultKind;

/// The number that is remembered before all are forgotten.
const MOST: usize = 256;

thread_local! {
    static CACHE: RefCell<HashMap<String, Result<Unit, UnitFault>>> = RefCell::default();
}

/// The unit that a text says, from memory where it was read before on this thread. What is asked decides between readings.
pub(super) fn parse(text: &str, asked: &Unit) -> Result<Unit, UnitFault> {
    match remembered(text) {
        Err(UnitFault { kind: UnitFaultKind::Ambiguous { .. }, .. }) => Unit::parse_asked(text, asked.dimension()),
        // `kn` is a knot, and beside a force a kilonewton.
        Ok(unit) if unit.dimension() != asked.dimension() => Unit::parse_asked(text, asked.dimension()),
        clear => clear,
    }
}

fn remembered(text: &str) -> Result<Unit, UnitFault> {
    CACHE.with_borrow_mut(|known| {
        if let Some(unit) = known.get(text) {
            return unit.clone();
        }
        if known.len() >= MOST {
            known.clear();
        }
        let unit = Unit::parse(text);
        known.insert(text.to_owned(), unit.clone());
        unit
    })
}
