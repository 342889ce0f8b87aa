//! The velocity of a body or of the centre of mass, as its components along the axes or those about a centre.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::geometry;

use super::super::Because;
use super::super::Builder;
use super::super::Name;
use super::super::QuantityKind;
use super::mass_centre::mass_centre_velocity;

pub(super) fn velocity(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    if name.is_of_mass_centre() {
        return mass_centre_velocity(builder, name);
    }
    let (body, instant) = builder.body_at(name)?;
    if builder.axes.is_empty() {
        return polar_velocity(builder, &body, instant, name.component.as_deref()?);
    }
    let Some(axis) = builder.axis_of(name) else { return along_an_axis(builder, name) };
    match builder.velocity(&body, instant, axis) {
        Expr::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}

pub(super) fn polar_velocity(builder: &mut Builder<'_>, body: &str, instant: usize, component: &str) -> Option<Symbol> {
    let words = match component {
        "r" => "radial",
        "theta" => "transverse",
        _ => return None,
    };
    let meaning = format!("the {words} velocity of {} {}", builder.called(body), builder.when(instant));
    let name = Name::of(QuantityKind::Velocity, body).at(instant).along(component);
    Some(builder.symbol(name, meaning))
}

/// The component along n or t of an impact whose line is an axis: one along the axes, or its opposite.
fn along_an_axis(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let across = match (name.component.as_deref()?, builder.axes.len()) {
        ("n", 2) => false,
        ("t", 2) => true,
        _ => return None,
    };
    let instant = builder.number(name)?;
    let frame = |stage: usize| {
        let is_meant = name.stage.is_none() || builder.stage_label(stage) == name.stage;
        let frame = builder.frames.get(stage)?.clone()?;
        (is_meant && frame.normal.turn.is_zero() && builder.takes_part(stage, &name.subject)).then_some((stage, frame))
    };
    let frames: Vec<_> =
        [instant.checked_sub(2), instant.checked_sub(1)].into_iter().flatten().filter_map(frame).collect();
    let [(stage, frame)] = &frames[..] else { return None };
    let split = builder.split(&name.subject, instant, *stage, frame);
    let value = if across { split.across? } else { split.along };
    let kept = builder.canonical(name);
    let symbol = builder.velocity_named(kept, &name.subject, instant);
    builder.law(&geometry::ROTATION, Some(*stage), Because::Definition, (symbol.into(), value.simplify()));
    Some(symbol)
}
