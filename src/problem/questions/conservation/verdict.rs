//! The tests of conservation: in a sudden stage the terms before and after, in one that lasts the influences from outside all the
//! way.

use momentous_model::Builder;

use super::super::super::language::ask::Conservable;
use super::super::super::reading::load::Loaded;
use super::balance::Balance;
use super::balance::Verdict;
use super::lasting;
use super::sudden;

/// The tests by which a quantity is conserved; `None` where the scene does not tell the quantity.
pub(crate) fn verdict(
    loaded: &Loaded,
    balance: &Balance<'_>,
    quantity: Conservable,
    builder: &mut Builder<'_>,
) -> Option<Verdict> {
    if !balance.ask.of.iter().any(|body| builder.is_changed_in(body, balance.stage)) && balance.is_sudden {
        return Some(Verdict { tests: Vec::new(), because: "no force acts on it".into() });
    }
    match (balance.is_sudden, quantity) {
        (true, Conservable::Momentum) => sudden::momentum(loaded, balance, builder),
        (true, Conservable::Energy) => Some(sudden::energy(loaded, balance, builder)),
        (true, Conservable::AngularMomentum) => sudden::angular(loaded, balance, builder),
        (false, Conservable::Momentum) => Some(lasting::momentum(loaded, balance, builder)),
        (false, Conservable::Energy) => Some(lasting::energy(loaded, balance, builder)),
        (false, Conservable::AngularMomentum) => Some(lasting::angular(loaded, balance, builder)),
    }
}
