//! Impacts in which a body is guided: a ball and a wedge on rails, a ball and a sphere on a cord.

use crate::Agent;
use crate::Builder;
use crate::Impulse;
use crate::QuantityKind;
use crate::Reason;
use momentous_expr::Expr;
use momentous_laws::momentum;
use momentous_laws::restitution;
use momentous_scene::Axis;
use momentous_solve::Relation;

use super::impact::Contact;

impl Builder<'_> {
    /// Two bodies of which one can move along its guide only: momentum along the guide, restitution along the line of
    /// impact, nothing across that for the body that is free.
    pub(super) fn guided_impact(&mut self, contact: &Contact<'_>, first: &str, second: &str) {
        let index = contact.index;
        let frame = self.line_of_impact(contact);
        let (name_a, name_b) = (self.called(first), self.called(second));
        let because = format!("the impulses that {name_a} and {name_b} exert on each other cancel");
        let Some(frame) = frame else {
            self.momentum_of_all(index, &because, [&[first, second], &[first, second]]);
            if contact.stage.loss.is_none() && !contact.stage.elastic {
                self.creates_no_energy(index, [first, second]);
            }
            return;
        };
        self.frames[index] = Some(frame.clone());
        let [[a1, b1], [a2, b2]] =
            [index + 1, index + 2].map(|instant| [first, second].map(|body| self.split(body, instant, index, &frame)));
        let meaning = format!("the impulse on {name_b} from {name_a} along the line of impact");
        let impulse = Expr::from(self.symbol(self.in_stage(QuantityKind::Impulse, second, index).along("n"), meaning));
        let both = [first, second].iter().all(|body| self.guided(body).is_some());
        for (body, other, impulse, [start, end]) in
            [(first, second, -impulse.clone(), [&a1, &a2]), (second, first, impulse.clone(), [&b1, &b2])]
        {
            self.impulses.push(Impulse {
                stage: index,
                on: body.to_owned(),
                by: Agent::Body(other.to_owned()),
                called: format!("the contact with {}", self.called(other)),
                components: self.resolved(&impulse, &frame),
                impulsive: true,
            });
            match self.guided(body) {
                None => {
                    self.smooth(index, body, start, end);
                    let mass = self.mass(body);
                    let because = format!("the only impulse on {} alone is that of the contact", self.called(body));
                    let sides = momentum::impulse_momentum(&mass, &start.along, &[impulse], &end.along);
                    self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
                }
                Some(guide) if both => {
                    let acting = [self.resolved(&impulse, &frame)];
                    let because = format!("{} gives {} an impulse", self.called(other), self.called(body));
                    self.momentum_along_guide(&guide, index, &acting, &because);
                }
                Some(_) => {}
            }
        }
        if !both {
            self.momentum_of_all(index, &because, [&[first, second], &[first, second]]);
        }
        if let Some(e) = self.coefficient(contact) {
            let because = "restitution acts along the line of impact only";
            let sides = restitution::restitution(&e, [&a1.along, &b1.along], [&a2.along, &b2.along]);
            self.law(&restitution::RESTITUTION, Some(index), because, sides);
        }
        self.parts_no_faster(contact, [&a1.along, &b1.along], [&a2.along, &b2.along]);
        let reason = Reason::NoCatchingUp(name_a.clone(), name_b.clone());
        self.require(a1.along, Relation::Greater, b1.along, reason);
        let reason = Reason::PassesThrough(name_a.clone(), name_b.clone());
        self.require(b2.along, Relation::AtLeast, a2.along, reason);
    }

    /// Two bodies that stay together and move along the guide of one of them.
    pub(super) fn guided_union(&mut self, contact: &Contact<'_>, first: &str, second: &str) {
        let index = contact.index;
        let (name_a, name_b) = (self.called(first), self.called(second));
        let because = format!("the impulses that {name_a} and {name_b} exert on each other cancel");
        self.catches_up(contact, [first, second]);
        match &contact.stage.becomes {
            Some(union) => self.momentum_of_all(index, &because, [&[first, second], &[union]]),
            None => {
                self.momentum_of_all(index, &because, [&[first, second], &[first, second]]);
                let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
                for axis in axes {
                    let [a, b] = [first, second].map(|body| self.velocity(body, index + 2, axis));
                    let because = format!("{name_a} and {name_b} stay together");
                    self.law(&restitution::PLASTIC, Some(index), because, (b, a));
                }
            }
        }
        for [body, other] in [[first, second], [second, first]] {
            if self.guided(body).is_none() {
                self.impulse_on_free(contact, body, other);
            }
        }
        self.not_needed("the forces between the bodies", "their impulses cancel in pairs within the system");
    }

    /// The impulse on the body that is free, which changes its momentum along every axis, and the opposite one on the other.
    fn impulse_on_free(&mut self, contact: &Contact<'_>, body: &str, other: &str) {
        let index = contact.index;
        let names = [body, other].map(|body| self.called(body));
        let after = contact.stage.becomes.as_deref().unwrap_or(body);
        let mass = self.mass(body);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let mut components = Vec::new();
        for axis in axes {
            let letter = axis.letter();
            let meaning = format!("the impulse on {} from {} along {letter}", names[0], names[1]);
            let impulse =
                Expr::from(self.symbol(self.in_stage(QuantityKind::Impulse, body, index).along(letter), meaning));
            let ends = [self.velocity(body, index + 1, axis), self.velocity(after, index + 2, axis)];
            let because = format!("the only impulse on {} alone is that of the contact", names[0]);
            let sides = momentum::impulse_momentum(&mass, &ends[0], std::slice::from_ref(&impulse), &ends[1]);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
            components.push(impulse);
        }
        let opposite = components.iter().map(|component| -component.clone()).collect();
        for (on, by, called, components) in [(body, other, &names[1], components), (other, body, &names[0], opposite)] {
            self.impulses.push(Impulse {
                stage: index,
                on: on.to_owned(),
                by: Agent::Body(by.to_owned()),
                called: format!("the contact with {called}"),
                components,
                impulsive: true,
            });
        }
    }
}
