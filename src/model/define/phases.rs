//! The two phases of an impact: the impulse of deformation until the bodies have one velocity, and that of restitution.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::restitution;
use momentous_quantity::Dimension;
use momentous_scene::Stage;
use momentous_scene::stage::Partners;

use super::super::Builder;
use super::super::Name;
use super::super::QuantityKind;

/// Masses, and the velocities before along the line of impact, of the two bodies; the second may be a surface.
struct Deformed {
    masses: [Option<Expr>; 2],
    before: [Expr; 2],
}

pub(super) fn deformation(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let stage = builder.impact_of(name)?;
    let common = common_symbol(builder, stage)?;
    let symbol = impulse(builder, stage, QuantityKind::DeformationImpulse, "deformation");
    let Deformed { masses, before } = builder.deformed(stage)?;
    let is_surface = masses.iter().any(Option::is_none);
    let moves = before[1].clone();
    let (mass, start) = masses.into_iter().zip(before).find_map(|(mass, start)| Some((mass?, start)))?;
    // Along the normal of a surface both are counted from it, whatever the axis.
    let together =
        if is_surface && builder.axes.len() == 1 { moves } else { builder.along_line(stage, common.into())? };
    let slowed = mass * (start - together);
    let Some(Stage::Impact(impact)) = builder.scene.stages.get(stage) else { return None };
    let (Partners::Bodies(slowed_down, _) | Partners::Surface(slowed_down, _)) = impact.partners()?;
    let slows = builder.called(slowed_down);
    let until = if is_surface { "it moves with the surface" } else { "both move together" };
    let because = format!("the impulse of deformation changes the momentum of {slows} until {until}");
    builder.law(&restitution::DEFORMATION, Some(stage), because, (symbol.into(), slowed));
    Some(symbol)
}

pub(super) fn restoring(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let stage = builder.impact_of(name)?;
    let deformation = deformation(builder, name)?;
    let symbol = impulse(builder, stage, QuantityKind::RestitutionImpulse, "restitution");
    let Some(Stage::Impact(impact)) = builder.scene.stages.get(stage) else { return None };
    let path = momentous_fault::Path::root().key("scene").key("stages").index(stage).key("impact").key("restitution");
    let e = match &impact.restitution {
        Some(term) => builder.restitution_coefficient(term, &path),
        None => impact.elastic.then(Expr::one)?,
    };
    let because = "the coefficient of restitution is the ratio of the impulses of the two phases";
    builder.law(&restitution::PHASES, Some(stage), because, (symbol.into(), e * Expr::from(deformation)));
    Some(symbol)
}

pub(super) fn common_velocity(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let stage = builder.impact_of(name)?;
    common_symbol(builder, stage)
}

fn impulse(builder: &mut Builder<'_>, stage: usize, kind: QuantityKind, phase: &str) -> Symbol {
    let meaning = format!("the magnitude of the impulse of {phase} in {}", builder.stage_phrase(stage));
    builder.symbol(builder.in_stage(kind, "", stage), meaning)
}

/// The velocity that both bodies have along the line of impact when they are nearest.
fn common_symbol(builder: &mut Builder<'_>, stage: usize) -> Option<Symbol> {
    let name = builder.in_stage(QuantityKind::CommonVelocity, "", stage);
    let phrase = builder.stage_phrase(stage);
    let meaning = format!("the common velocity along the line of impact at the greatest deformation in {phrase}");
    let symbol = builder.symbol(name, meaning);
    let Deformed { masses: [first, second], before: [a, b] } = builder.deformed(stage)?;
    let common = Expr::from(symbol);
    let (because, sides) = match (first, second) {
        (Some(first), Some(second)) => {
            let start = first.clone() * a + second.clone() * b;
            let common = builder.along_line(stage, common)?;
            ("at the greatest deformation both have the same velocity", (start, (first + second) * common))
        }
        // The velocity of a surface is told along its normal.
        _ => {
            let b = builder.along_line(stage, b)?;
            ("at the greatest deformation the body has the velocity of the surface", (common, b))
        }
    };
    if builder.defined.insert(format!("common {stage}")) {
        builder.law(&restitution::COMMON, Some(stage), because, sides);
    }
    Some(symbol)
}

impl Builder<'_> {
    /// The impact that a name refers to: the one in brackets, or the only one.
    fn impact_of(&self, name: &Name) -> Option<usize> {
        let is_impact = |stage: &usize| matches!(self.scene.stages.get(*stage), Some(Stage::Impact(_)));
        let all: Vec<usize> = (0..self.scene.stages.len()).filter(is_impact).collect();
        let stage = match (&name.stage, &all[..]) {
            (Some(stage), _) => self
                .timeline
                .stage(self.scene, stage)
                .or_else(|| stage.parse::<usize>().ok()?.checked_sub(1))
                .filter(is_impact)?,
            (None, [only]) => *only,
            _ => return None,
        };
        self.frames.get(stage)?.as_ref().map(|_| stage)
    }

    /// A velocity along the line of impact for one along the only axis, and the reverse; in a plane both are the same.
    fn along_line(&self, stage: usize, velocity: Expr) -> Option<Expr> {
        let frame = self.frames.get(stage)?.as_ref()?;
        let normal = self.components(&frame.normal);
        Some(if let [along] = &normal[..] { (along.clone() * velocity).simplify() } else { velocity })
    }

    fn deformed(&mut self, stage: usize) -> Option<Deformed> {
        let scene = self.scene;
        let (Some(Stage::Impact(impact)), Some(frame)) = (scene.stages.get(stage), self.frames.get(stage)?.clone())
        else {
            return None;
        };
        let along = |builder: &mut Self, body: &str| builder.split(body, stage + 1, stage, &frame).along;
        match impact.partners()? {
            Partners::Bodies(first, second) => {
                if [first, second].iter().any(|body| self.guided(body).is_some()) {
                    return None;
                }
                let before = [first, second].map(|body| along(self, body));
                Some(Deformed { masses: [first, second].map(|body| Some(self.mass_at(body, stage + 1))), before })
            }
            // Along the outward normal a body comes with a negative velocity: its impulse is counted from the surface.
            Partners::Surface(body, surface) => {
                let velocity = scene.surfaces.get(surface).and_then(|entry| entry.velocity.clone());
                let path = momentous_fault::Path::root().key("scene").key("surfaces").key(surface).key("velocity");
                let moves = velocity.map_or_else(Expr::zero, |term| self.read(&term, Dimension::VELOCITY, "", &path));
                let before = [along(self, body), moves];
                Some(Deformed { masses: [Some(-self.mass_at(body, stage + 1)), None], before })
            }
        }
    }
}
