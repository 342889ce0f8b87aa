//! Motion as seen from the centre of mass.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::energy;
use momentous_laws::mass_centre;
use momentous_scene::Axis;

use super::super::Because;
use super::super::Builder;
use super::super::Name;
use super::super::QuantityKind;
use super::super::builder::SECOND_COST;
use super::super::name::MASS_CENTRE;
use super::super::name::Meaning;

pub(super) fn relative_velocity(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let (body, _) = builder.body_at(name)?;
    let instant = builder.number(name)?;
    let axis = builder.axis_of(name)?;
    let symbol = seen_from_the_centre(builder, &body, instant, axis)?;
    if builder.defined.insert(format!("relative {instant} {axis:?}")) {
        let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
        let mut terms = Vec::new();
        for body in bodies {
            let relative = seen_from_the_centre(builder, &body, instant, axis)?;
            terms.push(builder.mass_at(&body, instant) * Expr::from(relative));
        }
        let because = "relative to the centre of mass, the total momentum of the system is zero";
        builder.law_at(SECOND_COST, &mass_centre::NO_MOMENTUM, None, because, (Expr::sum(terms), Expr::zero()));
    }
    Some(symbol)
}

/// The velocity of a body as seen from the centre of mass.
fn seen_from_the_centre(builder: &mut Builder<'_>, body: &str, instant: usize, axis: Axis) -> Option<Symbol> {
    let letter = builder.letter(axis);
    let relative = Name::of(QuantityKind::RelativeVelocity, body).at(instant).along(letter);
    if let Some(symbol) = builder.symbols.find(&relative.to_string()) {
        return Some(symbol);
    }
    let centre = builder.quantity(Name::of(QuantityKind::Velocity, MASS_CENTRE).at(instant).along(letter))?;
    let velocity = builder.velocity(body, instant, axis);
    let owner = builder.called(body);
    let whose = format!("of {owner} relative to the centre of mass {}", builder.when(instant));
    let symbol = builder.component(relative, Meaning { noun: "the velocity", of: whose });
    let sides = (symbol.into(), velocity - Expr::from(centre));
    builder.law(&mass_centre::RELATIVE, None, Because::Definition, sides);
    Some(symbol)
}

pub(super) fn relative_energy(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name).filter(|_| name.subject.is_empty() && !builder.axes.is_empty())?;
    let meaning = format!("the kinetic energy relative to the centre of mass {}", builder.when(instant));
    let symbol = builder.symbol(Name::of(QuantityKind::RelativeEnergy, "").at(instant), meaning);
    let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
    let axes: Vec<Axis> = builder.axes.iter().map(|(axis, _)| *axis).collect();
    let mut terms = Vec::new();
    for body in bodies {
        let components = axes.iter().map(|axis| seen_from_the_centre(builder, &body, instant, *axis).map(Expr::from));
        let components: Vec<Expr> = components.collect::<Option<_>>()?;
        terms.push(energy::kinetic(&builder.mass_at(&body, instant), &components));
    }
    let because = "the velocities are those relative to the centre of mass";
    builder.law(&energy::KINETIC, None, because, (symbol.into(), Expr::sum(terms)));
    let [whole, centre] = ["", MASS_CENTRE]
        .map(|subject| builder.quantity(Name::of(QuantityKind::KineticEnergy, subject).at(instant)).map(Expr::from));
    let because = "the motion consists of that of the centre of mass and that relative to it";
    builder.law(&mass_centre::ENERGY, None, because, (whole?, centre? + Expr::from(symbol)));
    Some(symbol)
}

/// The kinetic energy of the whole mass with the velocity of the centre of mass.
pub(super) fn energy_of_the_centre(builder: &mut Builder<'_>, instant: usize) -> Option<Symbol> {
    let letters: Vec<Option<&str>> = builder.axes.iter().map(|(axis, _)| builder.letter(*axis)).collect();
    if letters.is_empty() {
        return None;
    }
    let name = Name::of(QuantityKind::Velocity, MASS_CENTRE).at(instant);
    let velocity = letters.iter().map(|letter| builder.quantity(name.clone().along(*letter)).map(Expr::from));
    let velocity: Vec<Expr> = velocity.collect::<Option<_>>()?;
    let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
    let mass = Expr::sum(bodies.iter().map(|body| builder.mass_at(body, instant)).collect::<Vec<_>>());
    let meaning =
        format!("the kinetic energy of the total mass moving with the centre of mass {}", builder.when(instant));
    let symbol = builder.symbol(Name::of(QuantityKind::KineticEnergy, MASS_CENTRE).at(instant), meaning);
    let because = "the total mass is taken with the velocity of the centre of mass";
    builder.law(&energy::KINETIC, None, because, (symbol.into(), energy::kinetic(&mass, &velocity)));
    Some(symbol)
}
