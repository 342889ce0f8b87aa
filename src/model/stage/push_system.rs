//! Forces on several bodies at the same time: what must be told of them, and what they do to the system.

use std::collections::BTreeSet;

use crate::ActingForce;
use crate::Because;
use crate::Builder;
use crate::Name;
use crate::QuantityKind;
use crate::guide::Guided;
use crate::guide::dot;
use crate::name::MASS_CENTRE;
use crate::name::Meaning;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::force;
use momentous_laws::mass_centre;
use momentous_scene::Axis;
use momentous_scene::Force;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::Stage;
use momentous_scene::stage::Push;

/// The misfits of a push before any law is written down.
pub(crate) fn pushing(scene: &Scene, push: &Push, at: &Path) -> Vec<Fault> {
    let bodies: Vec<&str> = push.pushed().collect();
    if bodies.is_empty() {
        let fault = Fault::new(Code::MissingKey, "a push needs a body");
        return vec![fault.help("write `body: A`, or `bodies: [A, B]`").at_path(at.clone())];
    }
    let mut faults = Vec::new();
    let twice = bodies
        .iter()
        .enumerate()
        .find(|(position, body)| bodies.iter().take(*position).any(|earlier| earlier == *body));
    if let Some((_, body)) = twice {
        let fault = Fault::new(Code::Duplicate, format!("{} is pushed twice in one stage", scene.called(body)));
        faults.push(fault.help("name each body once; it may have several forces").at_path(at.key("bodies")));
    }
    for (position, entry) in push.forces.iter().enumerate() {
        let at = at.key("forces").index(position);
        match (entry, entry.on()) {
            (_, Some(on)) if !bodies.contains(&on) => {
                let fault = Fault::new(Code::UnknownName, format!("`{on}` is none of the bodies that are pushed"));
                faults.push(fault.help(format!("the stage pushes: {}", bodies.join(", "))).at_path(at.key("on")));
            }
            (Force::Pull(_), None) if push.is_of_several() => {
                let fault = Fault::new(Code::MissingKey, "each force on several bodies must say on which it acts");
                faults.push(fault.help("add `on: A` to the force").at_path(at));
            }
            (Force::Pull(_) | Force::Friction(_), _) => {}
        }
    }
    if push.is_of_several() {
        faults.extend(of_one_body(scene, push).map(|(what, key)| {
            let message = format!("{what} is possible only where one body is pushed");
            let help = "push one body, or use forces that depend on nothing but the time `t`, for a time: `during: dt`";
            Fault::new(Code::Value, message).help(help).at_path(at.key(key))
        }));
    }
    faults
}

/// The keys that only a push of one body may have, with their places.
fn of_one_body<'a>(scene: &Scene, push: &Push) -> impl Iterator<Item = (&'a str, &'a str)> {
    let rubs = push.forces.iter().any(|force| matches!(force, Force::Friction(_)));
    let axes = scene.axes.rectangular();
    let varies = axes.iter().any(|(axis, _)| push.depends_on_place(axis.letter()));
    let all = [
        (push.over.is_some(), "a distance", "over"),
        (push.until.is_some(), "an end at rest", "until"),
        (push.incline.is_some(), "a slope", "incline"),
        (push.direction.is_some(), "a direction of motion", "direction"),
        (push.mass_change().is_some(), "a mass that changes", if push.gains.is_some() { "gains" } else { "loses" }),
        (push.told.is_some(), "a graph that is printed", "told"),
        (rubs, "friction", "forces"),
        (varies, "a force that depends on the position", "forces"),
    ];
    all.into_iter().filter(|(is_there, ..)| *is_there).map(|(_, what, key)| (what, key))
}

/// The impulse on all bodies of a push together: `J[pull]`.
pub(crate) fn total_impulse(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let axis = builder.axis_of(name)?;
    let position = builder.axes.iter().position(|(listed, _)| *listed == axis)?;
    let scene = builder.scene;
    let several = scene.stages.iter().enumerate().filter_map(|(stage, entry)| {
        if let Stage::Push(push) = entry { push.is_of_several().then_some((stage, push)) } else { None }
    });
    let meant = |stage: usize| name.stage.is_none() || builder.stage_label(stage) == name.stage;
    let [(stage, push)] = several.filter(|(stage, _)| meant(*stage)).collect::<Vec<_>>()[..] else { return None };
    let of_forces = builder.impulses.iter().filter(|impulse| impulse.stage == stage);
    let of_forces = of_forces.filter_map(|impulse| impulse.components.get(position).cloned());
    let of_weights = push.pushed().filter_map(|body| builder.impulse_of_weight(body, stage, position));
    let total = Expr::sum(of_forces.chain(of_weights).collect::<Vec<_>>());
    let name = builder.in_stage(QuantityKind::Impulse, "", stage).along(builder.letter(axis));
    let whose = format!("on the system during {}", builder.stage_phrase(stage));
    let symbol = builder.component(name, Meaning { noun: "the impulse", of: whose });
    builder.law(&force::IMPULSE, Some(stage), Because::Definition, (symbol.into(), total));
    Some(symbol)
}

impl Builder<'_> {
    /// How fast the momentum of the system changes at both ends of a push, and the acceleration of its centre of mass.
    pub(super) fn rates_of_system(&mut self, index: usize, push: &Push) {
        let alive: Vec<String> = self.timeline.alive(index + 1).into_iter().map(str::to_owned).collect();
        let is_pushed = |body: &String| push.pushed().any(|pushed| pushed == body);
        // The force that carries another body against its weight is not known.
        if self.scene.plane == Plane::Vertical && !alive.iter().all(is_pushed) {
            return;
        }
        let total = Expr::sum(alive.iter().map(|body| self.mass(body)).collect::<Vec<_>>());
        let forces: Vec<ActingForce> = self.forces.iter().filter(|force| force.stage == index).cloned().collect();
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let guides: Vec<Option<Guided>> = forces.iter().map(|force| self.guided(&force.on)).collect();
        let held: BTreeSet<&str> = guides.iter().flatten().map(|guide| guide.by.as_str()).collect();
        let besides = match held.into_iter().collect::<Vec<_>>()[..] {
            [] => String::new(),
            [guide] => format!(", without what {guide} balances"),
            [..] => ", without what the guides balance".to_owned(),
        };
        let first = usize::from(push.pushed().any(|body| self.scene.follows_a_force(index, body)));
        for (side, instant) in [index + 1, index + 2].into_iter().enumerate().skip(first) {
            let parts: Vec<Vec<Expr>> = (forces.iter().zip(&guides))
                .map(|(force, guide)| {
                    let parts = self.components_at(force, side == 1);
                    guide.as_ref().map_or_else(|| parts.clone(), |guide| self.left_by(guide, &parts))
                })
                .collect();
            for (position, axis) in axes.iter().enumerate() {
                let net = Expr::sum(parts.iter().filter_map(|parts| parts.get(position).cloned()).collect::<Vec<_>>());
                let [whose, of_acceleration] =
                    ["the system", "the centre of mass"].map(|subject| format!("of {subject} {}", self.when(instant)));
                let letter = self.letter(*axis);
                let rate = Name::of(QuantityKind::MomentumRate, "").at(instant).along(letter);
                let rate = self.component(rate, Meaning { noun: "the rate of change of the momentum", of: whose });
                let because = format!("these are all the external forces on the system{}{besides}", self.along(*axis));
                self.law(&mass_centre::RATE, Some(index), because, (rate.into(), net));
                let acceleration = Name::of(QuantityKind::Acceleration, MASS_CENTRE).at(instant).along(letter);
                let acceleration =
                    self.component(acceleration, Meaning { noun: "the acceleration", of: of_acceleration });
                let because = "the forces between the bodies cancel";
                let sides = (total.clone() * Expr::from(acceleration), rate.into());
                self.law(&mass_centre::ACCELERATION, Some(index), because, sides);
            }
        }
    }

    /// The components of a force without the part across a guide, which balances it.
    fn left_by(&self, guide: &Guided, parts: &[Expr]) -> Vec<Expr> {
        let line = self.components(&guide.along);
        let along = dot(parts, &line);
        line.into_iter().map(|share| (share * along.clone()).simplify()).collect()
    }
}
