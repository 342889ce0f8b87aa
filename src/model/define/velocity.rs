//! The velocity of a body or of the centre of mass, as its components along the axes or those about a centre.

use momentous_expr::Expr;
use momentous_expr::Symbol;

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
    let axis = builder.axis_of(name)?;
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
