//! The energy that a spring stores.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::energy;

use super::super::Because;
use super::super::Builder;
use super::super::Instant;
use super::super::Name;
use super::super::stored::Stored;

/// The energy of the spring at an instant; where one spring follows another, the stage says which is meant.
pub(super) fn energy_of_spring(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let here = |spring: &Stored| spring.deformations.get(instant.checked_sub(spring.stage + 1)?).cloned();
    let at_instant: Vec<(&Stored, Expr)> =
        builder.stored.iter().filter_map(|spring| Some((spring, here(spring)?))).collect();
    let meant = |stage: usize| name.stage.is_none() || builder.stage_label(stage) == name.stage;
    let mut all = at_instant.iter().filter(|(spring, _)| meant(spring.stage));
    let (spring, deformation) = all.next()?;
    if all.any(|(other, deformed)| (&other.stiffness, deformed) != (&spring.stiffness, deformation)) {
        return None;
    }
    let value = energy::of_spring(&spring.stiffness, deformation);
    let meaning = format!("the potential energy of {} {}", spring.called, builder.when(instant));
    let label = name.stage.clone().filter(|_| at_instant.len() > 1);
    let kept = Name { instant: Some(Instant::Number(instant)), stage: label, ..name.clone() };
    let symbol = builder.symbol(kept, meaning);
    builder.law(&energy::SPRING, None, Because::Definition, (symbol.into(), value));
    Some(symbol)
}
