//! The mass centre: its place, its velocity, and how impulses from outside move it.

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::laws::mass_centre;
use crate::laws::momentum;
use crate::quantity::Dimension;
use crate::scene::Axis;
use crate::scene::Stage;

use super::super::Agent;
use super::super::Builder;
use super::super::Name;

pub(super) fn mass_centre_velocity(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let axis = builder.axis_of(name)?;
    let spelling = builder.spelling(name);
    let when = builder.when(instant);
    let meaning = format!("{}the velocity of the mass centre {when}", Builder::component_phrase(name));
    let symbol = builder.symbol(spelling, Dimension::VELOCITY, meaning);
    let parts = builder.carriers(instant, axis);
    let because = builder.momentum_of_the_whole(instant);
    builder.law(&mass_centre::MASS_CENTRE, None, because, mass_centre::mass_centre(&symbol.into(), &parts));
    builder.mass_centre_motion(instant, axis, symbol);
    Some(symbol)
}

impl Builder<'_> {
    /// Why the mass centre's velocity is what it is, and whose velocity did not change just before the instant.
    fn momentum_of_the_whole(&self, instant: usize) -> String {
        let alive = self.timeline.alive(instant);
        let kept = alive.iter().filter(|body| self.timeline.since(body, instant).is_some_and(|since| since < instant));
        let kept: Vec<String> = kept.map(|body| self.called(body)).collect();
        let whole = "the mass centre carries the momentum of the whole system";
        match &kept[..] {
            [] => whole.to_owned(),
            [only] => format!("{whole}, and {only} keeps its velocity"),
            several => format!("{whole}, and {} keep their velocities", several.join(" and ")),
        }
    }

    /// The mass centre's velocity from one instant to the next, by the impulses from outside the system.
    fn mass_centre_motion(&mut self, instant: usize, axis: Axis, after: Symbol) {
        let Some(before_instant) = instant.checked_sub(1).filter(|before| *before >= 1) else { return };
        let letter = if self.axes.len() > 1 { format!(".{}", axis.letter()) } else { String::new() };
        let Some(before) = self.resolve(&format!("v_G{before_instant}{letter}")) else { return };
        let position = self.axes.iter().position(|(own, _)| *own == axis).unwrap_or(0);
        let alive = self.timeline.alive(instant).len();
        let outside: Vec<Expr> = self
            .impulses
            .iter()
            .filter(|impulse| impulse.stage + 2 == instant && !matches!(impulse.by, Agent::Body(_)))
            .filter_map(|impulse| impulse.components.get(position).cloned())
            .collect();
        let pushed = self.scene.stages.get(instant - 2).is_some_and(|stage| matches!(stage, Stage::Fall(_)));
        if alive < 2 || pushed || self.downwards(position).is_some() && !self.is_impulsive(instant) {
            return;
        }
        let parts = self.carriers(instant, axis);
        let total = mass_centre::total_mass(&parts);
        let because = if outside.is_empty() {
            "no impulse from outside acts on the system, and the inner ones cancel".to_owned()
        } else {
            "the impulses within the system cancel, and only those from outside change the motion of its mass centre"
                .to_owned()
        };
        let sides = momentum::impulse_momentum(&total, &before.into(), &outside, &after.into());
        self.law(&mass_centre::MOTION, Some(instant - 2), because, sides);
    }

    fn is_impulsive(&self, instant: usize) -> bool {
        self.impulses.iter().any(|impulse| impulse.stage + 2 == instant && impulse.impulsive)
    }
}

pub(super) fn mass_centre_position(builder: &mut Builder<'_>, name: &Name, instant: usize) -> Option<Symbol> {
    let axis = builder.axis_of(name)?;
    let spelling = builder.spelling(name);
    let meaning =
        format!("{}the position of the mass centre {}", Builder::component_phrase(name), builder.when(instant));
    let symbol = builder.symbol(spelling, Dimension::LENGTH, meaning);
    let letter = if builder.axes.len() > 1 { format!(".{}", axis.letter()) } else { String::new() };
    let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
    let mut parts = Vec::new();
    for body in bodies {
        let place = builder.resolve(&format!("r_{body}{instant}{letter}"))?;
        parts.push((builder.mass(&body), Expr::from(place)));
    }
    let sides = mass_centre::mass_centre(&symbol.into(), &parts);
    builder.law(
        &mass_centre::MASS_CENTRE,
        None,
        "the mass centre is the mean position, each body counted by its mass",
        sides,
    );
    Some(symbol)
}
