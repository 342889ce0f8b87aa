//! Forces along the path of particles on an arm, and the pull that holds them on their circles.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Instant;
use crate::Name;
use crate::QuantityKind;
use crate::wording;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::force;
use momentous_quantity::Dimension;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Arm;
use momentous_scene::stage::Rotate;

/// A force along the path of a particle, read.
pub(super) struct Along<'a> {
    pub on: &'a str,
    pub name: String,
    pub strength: Expr,
    /// Its moment about the fixed point.
    pub moment: Expr,
}

impl Builder<'_> {
    /// The forces along the path in a stage.
    pub(super) fn along_path<'a>(&mut self, stage: &'a Rotate, path: &Path) -> Vec<Along<'a>> {
        let mut all = Vec::new();
        for (position, (entry, acted_on)) in stage.driving().enumerate() {
            let at = path.key("forces").index(position);
            let Some((on, arm)) = acted_on else {
                self.faults.push(on_no_particle(stage, entry.on.as_deref(), &at));
                continue;
            };
            let Arm::Constant(arm) = arm else {
                let message = "a force along the path needs an arm that keeps its length";
                let help = "write two stages: one in which the arm changes, and one in which the force acts";
                self.faults.push(Fault::new(Code::Value, message).help(help).at_path(at));
                continue;
            };
            let name = match (&entry.name, stage.held().len()) {
                (Some(name), _) => wording::force_of(name).into_owned(),
                (None, 1) => "the force along the path".to_owned(),
                (None, _) => format!("the force on {}", self.called(on)),
            };
            let strength = self.strength(&entry.value, Dimension::FORCE, &name, &at.key("value"));
            let arm = self.read_positive(arm, Dimension::LENGTH, "", path);
            all.push(Along { on, name, moment: arm * strength.clone(), strength });
        }
        all
    }

    /// The forces that have a moment about the fixed point, and their effect on the angular momentum.
    pub(super) fn changing(moment: bool, forces: &[Along<'_>], centre: &str) -> String {
        let names: Vec<&str> = forces.iter().map(|force| force.name.as_str()).collect();
        let of_forces = |these: &str| format!("the moment{these} of {}", names.join(" and "));
        match (moment, forces) {
            (true, []) => "the moment changes".to_owned(),
            (false, [_]) => format!("{} changes", of_forces("")),
            (false, _) => format!("{} change", of_forces("s")),
            (true, [_]) => format!("the moment about {centre} and that of {} change", names.concat()),
            (true, _) => format!("the moment about {centre} and {} change", of_forces("s")),
        }
    }

    /// The effects of such a force at every moment.
    pub(super) fn along_acts(&mut self, index: usize, force: &Along<'_>) {
        let influence = Influence::outside(index, force.on, force.name.as_str()).moment(vec![force.moment.clone()]);
        let words = format!("{} does work along the path", force.name);
        self.acts(influence.works(Effect::Of(force.strength.clone()), &words));
    }
}

fn on_no_particle(stage: &Rotate, on: Option<&str>, at: &Path) -> Fault {
    let held: Vec<&str> = stage.held().into_iter().map(|(body, _)| body).collect();
    let known = format!("the particles on the arm are: {}", held.join(", "));
    match (on, held.first()) {
        (Some(on), Some(_)) => {
            Fault::new(Code::UnknownName, format!("`{on}` is no particle on the arm")).help(known).at_path(at.key("on"))
        }
        (None, Some(first)) => {
            let fault = Fault::new(Code::MissingKey, "of several particles, the force must say on which it acts");
            fault.help(format!("add `on: {first}` to the force")).at_path(at.clone())
        }
        (_, None) => {
            let fault = Fault::new(Code::MissingKey, "a force along the path needs a particle on which it acts");
            fault.help("write `moment: M` for what turns the rotor itself").at_path(at.clone())
        }
    }
}

/// The stage at an end of which that name is the pull on a particle of a horizontal arm: its arm there.
fn holding<'s>(scene: &'s Scene, name: &Name) -> Option<(&'s Rotate, &'s Arm, usize)> {
    let Some(Instant::Number(instant)) = name.instant else { return None };
    let at_end = |index: usize| instant.checked_sub(index + 1).filter(|side| *side < 2);
    scene.stages.iter().enumerate().filter(|_| scene.plane == Plane::Horizontal).find_map(|(index, stage)| {
        let (Stage::Rotate(rotate), Some(side)) = (stage, at_end(index)) else { return None };
        let (_, arm) = rotate.held().into_iter().find(|(body, _)| *body == name.subject)?;
        Some((rotate, arm, side))
    })
}

/// Whether a name is the pull on a particle that an arm or a string holds.
pub(crate) fn is_holding_pull(scene: &Scene, name: &Name) -> bool {
    holding(scene, name).is_some()
}

/// The pull that holds a particle on its circle.
pub(crate) fn holding_pull(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let scene = builder.scene;
    let (stage, arm, side) = holding(scene, name)?;
    let body = name.subject.as_str();
    let (called, centre) = (builder.called(body), builder.point(&stage.about));
    let meaning = format!("the pull on {called} towards {centre} {}", builder.when(instant));
    let symbol = builder.symbol(Name::of(QuantityKind::Tension, body).at(instant), meaning);
    let arm = builder.read_positive(arm.ends()[side], Dimension::LENGTH, "", &Path::root());
    let (mass, velocity) = (builder.mass_at(body, instant), builder.transverse(body, instant));
    let because =
        format!("{called} moves on a level circle at that instant, and nothing else pulls it towards {centre}");
    let sides = (symbol.into(), mass * velocity.powi(2) / arm);
    builder.law(&force::HOLDING, None, because, sides);
    Some(symbol)
}
