//! Impacts of a body and a surface that does not give way.

use crate::Agent;
use crate::Builder;
use crate::Impulse;
use crate::QuantityKind;
use crate::Reason;
use crate::frame::Frame;
use crate::weight_in_contact::Lasting;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::momentum;
use momentous_laws::restitution;
use momentous_quantity::Dimension;
use momentous_solve::Relation;

use super::impact::Contact;

impl Builder<'_> {
    pub(super) fn surface_impact(&mut self, contact: &Contact<'_>, body: &str, surface: &str) {
        let (index, stage) = (contact.index, contact.stage);
        let Some(entry) = self.scene.surfaces.get(surface) else { return };
        let at = Path::root().key("scene").key("surfaces").key(surface);
        let normal = self.direction(&entry.normal, &at.key("normal"));
        let frame = Frame { normal };
        self.frames[index] = Some(frame.clone());
        let name = self.called(body);
        let wall = entry.name.clone().unwrap_or_else(|| format!("the {surface}"));
        let moves = match &entry.velocity {
            Some(term) => self.read(
                term,
                Dimension::VELOCITY,
                &format!("the velocity of {wall} along its normal"),
                &at.key("velocity"),
            ),
            None => Expr::zero(),
        };
        let start = self.split(body, index + 1, index, &frame);
        let end = self.split(body, index + 2, index, &frame);
        let mass = self.mass(body);
        if let Some(e) = self.coefficient(contact) {
            let stays = if moves.is_zero() { "stays at rest" } else { "keeps its velocity" };
            let because = match start.across {
                _ if e.is_zero() => format!("{} not rebound from {wall}", self.does(body, ["does", "do"])),
                Some(_) => format!("{wall} {stays}, and restitution acts along its normal only"),
                None => format!("{wall} {stays}"),
            };
            let sides = restitution::at_surface(&e, &moves, &start.along, &end.along);
            self.law(&restitution::RESTITUTION_SURFACE, Some(index), because, sides);
        }
        if stage.plastic {
            let because = format!("{name} does not rebound from {wall}");
            self.law(&restitution::PLASTIC, Some(index), because, (end.along.clone(), moves.clone()));
        }
        let lasting =
            Lasting { index, duration: stage.duration.as_ref(), include: Some(&stage.include), path: contact.path };
        let guide = self.guided(body);
        if guide.is_some() && !stage.include.is_empty() {
            let fault = Fault::new(Code::Value, "an impact of a guided body on a surface cannot include weight");
            let help = "remove it; write `allow: [weight-neglected]` if weight is not small";
            self.faults.push(fault.help(help).at_path(contact.path.key("include")));
        }
        let gained = if guide.is_none() { self.included_weight(&lasting, body) } else { None };
        let [fallen, slid] = gained.as_ref().map_or([None, None], |gained| self.turned_into(gained, &frame));
        if let (Some(from), Some(to), None) = (&start.across, &end.across, &guide) {
            if let Some(slid) = slid {
                let because = format!("{wall} is smooth, and only weight exerts an impulse on {name} along it");
                let sides = momentum::impulse_momentum(&mass, from, &[mass.clone() * slid], to);
                self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
            } else {
                let because = format!("{wall} is smooth and exerts no impulse on {name} along it");
                self.law(&momentum::NO_IMPULSE, Some(index), because, (to.clone(), from.clone()));
            }
            self.neglect(format!("friction with {wall}"), format!("{wall} is smooth"));
        }
        let impulse = self.in_stage(QuantityKind::Impulse, body, index);
        let meaning = format!("the impulse on {name} from {wall}");
        let impulse = Expr::from(self.symbol(impulse, meaning));
        let components = self.resolved(&impulse, &frame);
        if let Some(guide) = &guide {
            let because = format!("{wall} gives {name} an impulse along its normal");
            self.momentum_along_guide(guide, index, std::slice::from_ref(&components), &because);
        } else {
            let because = match fallen {
                None if start.across.is_none() => {
                    format!("in the short impact, any impulse on {name} but that of {wall} is negligible")
                }
                None => format!("along the normal, any impulse on {name} but that of {wall} is negligible"),
                Some(_) => format!("along the normal, {wall} and weight exert impulses on {name}"),
            };
            let acting: Vec<Expr> =
                [impulse.clone()].into_iter().chain(fallen.map(|gained| mass.clone() * gained)).collect();
            let [from, to] = [(index + 1, &start), (index + 2, &end)].map(|(at, split)| self.changed(body, at, split));
            let sides = momentum::impulse_momentum(&mass, &from, &acting, &to);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
        }
        self.mean_force(index, body, &impulse, stage.duration.as_ref(), contact.path);
        self.impulses.push(Impulse {
            stage: index,
            on: body.to_owned(),
            by: Agent::Surface(surface.to_owned()),
            called: wall.clone(),
            components,
            impulsive: true,
        });
        if let Some(gained) = &gained {
            self.weight_acts(index, body, gained);
        }
        if stage.restitution.is_none() && !stage.plastic {
            let [approach, separation] = [moves.clone() - start.along.clone(), end.along.clone() - moves.clone()];
            let reason = Reason::LeavesFaster(name.clone(), wall.clone());
            self.require(approach, Relation::AtLeast, separation, reason);
        }
        self.require(start.along, Relation::Less, moves.clone(), Reason::NotReached(name.clone(), wall.clone()));
        self.require(end.along, Relation::AtLeast, moves, Reason::PassesThrough(name, wall.clone()));
        let why = match &entry.velocity {
            Some(_) => format!("the impact does not change the velocity of {wall}"),
            None => format!("{wall} is held by external forces"),
        };
        self.not_needed(format!("the momentum of {wall}"), why);
    }
}
