//! Motion as seen from the centre of mass.

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::laws::energy;
use crate::laws::mass_centre;
use crate::quantity::Dimension;

use super::super::Builder;
use super::super::Name;
use super::super::builder::SECOND_COST;

pub(super) fn relative_velocity(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let (body, _) = builder.body_at(name)?;
    let instant = builder.number(name)?;
    let axis = builder.axis_of(name)?;
    let letter = if builder.axes.len() > 1 { format!(".{}", axis.letter()) } else { String::new() };
    let centre = builder.resolve(&format!("v_G{instant}{letter}"))?;
    let own = builder.velocity(&body, instant, axis);
    let owner = builder.called(&body);
    let meaning = format!(
        "{}the velocity of {owner} relative to the centre of mass {}",
        Builder::component_phrase(name),
        builder.when(instant)
    );
    let symbol = builder.symbol(format!("v_rel_{body}{instant}{letter}"), Dimension::VELOCITY, meaning);
    let sides = (symbol.into(), own - Expr::from(centre));
    builder.law(
        &mass_centre::RELATIVE,
        None,
        format!("the velocity of {owner} is taken relative to the centre of mass"),
        sides,
    );
    if builder.defined.insert(format!("relative {instant}{letter}")) {
        let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
        let mut terms = Vec::new();
        for body in bodies {
            let relative = builder.resolve(&format!("v_rel_{body}{instant}{letter}"))?;
            terms.push(builder.mass(&body) * Expr::from(relative));
        }
        let because = "relative to the centre of mass, the total momentum of the system is zero";
        builder.law_at(SECOND_COST, &mass_centre::NO_MOMENTUM, None, because, (Expr::sum(terms), Expr::zero()));
    }
    Some(symbol)
}

pub(super) fn relative_energy(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name).filter(|_| name.subject.is_empty() && !builder.axes.is_empty())?;
    let meaning = format!("the kinetic energy relative to the centre of mass {}", builder.when(instant));
    let symbol = builder.symbol(format!("T_rel_{instant}"), Dimension::ENERGY, meaning);
    let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
    let letters: Vec<String> = match &builder.axis_letters()[..] {
        [_] => vec![String::new()],
        several => several.iter().map(|letter| format!(".{letter}")).collect(),
    };
    let mut terms = Vec::new();
    for body in bodies {
        let name = format!("v_rel_{body}{instant}");
        let components = letters.iter().map(|letter| builder.resolve(&format!("{name}{letter}")).map(Expr::from));
        let components: Vec<Expr> = components.collect::<Option<_>>()?;
        terms.push(energy::kinetic(&builder.mass(&body), &components));
    }
    let because = "the velocities are those relative to the centre of mass";
    builder.law(&energy::KINETIC, None, because, (symbol.into(), Expr::sum(terms)));
    let [whole, centre] = ["T_", "T_G"].map(|base| builder.resolve(&format!("{base}{instant}")).map(Expr::from));
    let because = "the motion consists of that of the centre of mass and that relative to it";
    builder.law(&mass_centre::ENERGY, None, because, (whole?, centre? + Expr::from(symbol)));
    Some(symbol)
}

/// The kinetic energy of the whole mass with the velocity of the centre of mass.
pub(super) fn energy_of_the_centre(builder: &mut Builder<'_>, instant: usize) -> Option<Symbol> {
    let letters: Vec<String> = match &builder.axis_letters()[..] {
        [] => return None,
        [_] => vec![String::new()],
        several => several.iter().map(|letter| format!(".{letter}")).collect(),
    };
    let velocity = letters.iter().map(|letter| builder.resolve(&format!("v_G{instant}{letter}")).map(Expr::from));
    let velocity: Vec<Expr> = velocity.collect::<Option<_>>()?;
    let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
    let mass = Expr::sum(bodies.iter().map(|body| builder.mass(body)).collect::<Vec<_>>());
    let meaning =
        format!("the kinetic energy of the total mass moving with the centre of mass {}", builder.when(instant));
    let symbol = builder.symbol(format!("T_G{instant}"), Dimension::ENERGY, meaning);
    let because = "the total mass is taken with the velocity of the centre of mass";
    builder.law(&energy::KINETIC, None, because, (symbol.into(), energy::kinetic(&mass, &velocity)));
    Some(symbol)
}
