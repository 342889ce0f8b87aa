//! Impulses that exist because somebody mentions them: that on a body during a stage, its magnitude and direction, and the average force.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::force;
use momentous_laws::geometry;
use momentous_laws::momentum;
use momentous_scene::Axis;
use momentous_scene::Stage;

use super::super::Agent;
use super::super::Because;
use super::super::Builder;
use super::super::ForceKind;
use super::super::Impulse;
use super::super::Name;
use super::super::QuantityKind;
use super::super::VectorKind;
use super::super::builder::LAW_COST;
use super::super::builder::SECOND_COST;
use super::super::name::Meaning;
use super::super::stage::total_impulse;

impl Builder<'_> {
    /// The impulse of the weight of a body during a push, along the axis of that position: what a smooth slope leaves of it, and all of it
    /// where nothing carries the body. Beside friction, what is noted of a push is the impulse of all forces together.
    pub(crate) fn impulse_of_weight(&self, body: &str, stage: usize, position: usize) -> Option<Expr> {
        let force =
            |kind| self.forces.iter().find(|force| force.stage == stage && force.on == body && force.kind == kind);
        if force(ForceKind::Friction).is_some() {
            return None;
        }
        let weight = force(ForceKind::Weight)?;
        let parts = match force(ForceKind::Normal) {
            // A direction on a slope is told by what lies along the slope and across it.
            Some(_) => weight.direction.cosine_and_sine().into_iter().take(1).collect(),
            None => self.components(&weight.direction),
        };
        let part = parts.into_iter().nth(position).map(|part| part.simplify()).filter(|part| !part.is_zero())?;
        let [start, end] = &weight.during;
        Some(part * weight.strength.clone() * (end.clone() - start.clone()))
    }

    /// The symbol of the impulse on a body during a stage.
    fn impulse_during(&mut self, name: &Name, stage: usize) -> Symbol {
        let whose = format!("on {} during {}", self.called(&name.subject), self.stage_phrase(stage));
        self.component(self.canonical(name), Meaning { noun: "the impulse", of: whose })
    }

    /// The magnitude of a vector with these components, under the name without a component.
    pub(crate) fn resultant(&mut self, stage: usize, body: &str, components: &[Expr], meaning: &str) {
        let [magnitude, direction] = [QuantityKind::Impulse, QuantityKind::Direction(VectorKind::Impulse)]
            .map(|kind| self.in_stage(kind, body, stage));
        let magnitude = self.positive(magnitude, format!("the magnitude of {meaning}"));
        if let [x, y] = components {
            let direction = self.symbol(direction, format!("the direction of {meaning}"));
            self.directions.insert(direction, [x.clone(), y.clone()]);
            // From a direction that is given the components follow: the tangent of a right angle would give none.
            let is_given = self.given.contains(&self.symbols.entry(direction).name);
            let [resolved, tangent] = if is_given { [LAW_COST, SECOND_COST] } else { [SECOND_COST, LAW_COST] };
            let because = "the impulse is resolved along the axes";
            for sides in geometry::components(&magnitude.into(), &direction.into(), x, y) {
                self.law_at(resolved, &geometry::COMPONENTS, Some(stage), because, sides);
            }
            let sides = (direction.into(), y.clone().atan2(x.clone()));
            self.law_at(tangent, &geometry::DIRECTION, Some(stage), "the components give the direction", sides);
        }
        self.magnitude_of_impulse(stage, magnitude.into(), components);
    }

    /// The magnitude of an impulse follows from its components.
    pub(crate) fn magnitude_of_impulse(&mut self, stage: usize, magnitude: Expr, components: &[Expr]) {
        let because = "the components of the impulse are perpendicular";
        let squares = Expr::sum(components.iter().map(|component| component.clone().powi(2)));
        self.law(&geometry::MAGNITUDE, Some(stage), because, (magnitude, squares.sqrt()));
    }
}

/// The impulse on a body during a stage, or on the system.
pub(super) fn impulse(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    if let Some(symbol) = builder.impulse_of_a_bounce(name) {
        return Some(symbol);
    }
    if name.subject.is_empty() {
        return total_impulse(builder, name);
    }
    // The impulse on a body during a push: the sum of those of its forces. That of a sudden stage leaves out the weight beside it.
    let axis = builder.axis_of(name)?;
    let position = builder.axes.iter().position(|(listed, _)| *listed == axis)?;
    let in_stage = |stage: usize| match &name.stage {
        Some(_) => builder.stage_label(stage) == name.stage,
        None => true,
    };
    let is_sudden = |stage: usize| {
        builder.impulses.iter().any(|impulse| impulse.stage == stage && impulse.impulsive && impulse.by != Agent::Guide)
    };
    let acting: Vec<(usize, Expr)> = builder
        .impulses
        .iter()
        .filter(|impulse| impulse.on == name.subject && in_stage(impulse.stage))
        .filter(|impulse| impulse.impulsive || !is_sudden(impulse.stage))
        // That of a guide has a name of its own: `R_A`.
        .filter(|impulse| impulse.by != Agent::Guide)
        .filter_map(|impulse| Some((impulse.stage, impulse.components.get(position)?.clone())))
        .collect();
    let Some(stage) = acting.first().map(|first| first.0) else { return impulse_by_momentum(builder, name, axis) };
    if acting.iter().any(|(other, _)| *other != stage) {
        return None;
    }
    let symbol = builder.impulse_during(name, stage);
    let weight = builder.impulse_of_weight(&name.subject, stage, position);
    let total = Expr::sum(acting.into_iter().map(|(_, impulse)| impulse).chain(weight));
    builder.law(&force::IMPULSE, Some(stage), Because::Definition, (symbol.into(), total));
    Some(symbol)
}

/// The impulse of all forces of a push whose own impulses are not told for themselves, as where static friction may hold the body first.
fn impulse_by_momentum(builder: &mut Builder<'_>, name: &Name, axis: Axis) -> Option<Symbol> {
    let in_stage = |stage: usize| name.stage.is_none() || builder.stage_label(stage) == name.stage;
    let untold =
        |impulse: &&Impulse| impulse.on == name.subject && impulse.components.is_empty() && in_stage(impulse.stage);
    let [stage] = builder.impulses.iter().filter(untold).map(|impulse| impulse.stage).collect::<Vec<_>>()[..] else {
        return None;
    };
    if !matches!(builder.scene.stages.get(stage)?, Stage::Push(push) if push.mass_change().is_none()) {
        return None;
    }
    let symbol = builder.impulse_during(name, stage);
    let mass = builder.mass(&name.subject);
    let [before, after] = [1, 2].map(|side| builder.velocity(&name.subject, stage + side, axis));
    let because = format!("the impulse of all forces changes the momentum of {}", builder.called(&name.subject));
    let sides = momentum::impulse_momentum(&mass, &before, &[symbol.into()], &after);
    builder.law(&momentum::IMPULSE_MOMENTUM, Some(stage), because, sides);
    Some(symbol)
}

/// The average force over a push: that which would give the same impulse in the same time.
pub(super) fn mean_force(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let in_stage = |stage: usize| match &name.stage {
        Some(_) => builder.stage_label(stage) == name.stage,
        None => true,
    };
    let acts =
        |stage: &usize| builder.impulses.iter().any(|impulse| impulse.stage == *stage && impulse.on == name.subject);
    let is_push = |stage: &usize| matches!(builder.scene.stages.get(*stage), Some(Stage::Push(_)));
    let stages = (0..builder.scene.stages.len()).filter(|stage| is_push(stage) && acts(stage) && in_stage(*stage));
    let [stage] = stages.collect::<Vec<_>>()[..] else { return None };
    let lasts = builder.lasting.get(stage)?.clone()?;
    let total = Name { kind: QuantityKind::Impulse, ..name.clone() };
    let total = Expr::from(builder.quantity(total)?);
    let (body, phrase) = (builder.called(&name.subject), builder.stage_phrase(stage));
    let meaning = Meaning { noun: "the average force", of: format!("on {body} during {phrase}") };
    let symbol = builder.component(builder.canonical(name), meaning);
    let because = "the average force would give the same impulse in the same time";
    let sides = force::mean_force(&total, &symbol.into(), &lasts);
    builder.law(&force::MEAN_FORCE, Some(stage), because, sides);
    Some(symbol)
}
