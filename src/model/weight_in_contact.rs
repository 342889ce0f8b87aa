//! The impulse of weight in a contact of known duration: left out, or put into the balance.

use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_quantity::Dimension;
use momentous_scene::Plane;
use momentous_scene::Term;
use momentous_scene::stage::Included;
use momentous_solve::Relation;

use super::Builder;
use super::Reason;
use super::contact_weight::ContactWeight;
use super::frame::Direction;
use super::frame::Frame;
use super::guide::Guided;
use super::guide::dot;

/// A contact that may last as long as is given.
pub(super) struct Lasting<'a> {
    pub index: usize,
    pub duration: Option<&'a Term>,
    /// What is included beside the contact; none where a stage of its kind cannot include anything.
    pub include: Option<&'a [Included]>,
    pub path: &'a Path,
}

impl Builder<'_> {
    /// The weights that act in short contacts, so far.
    #[must_use]
    pub fn weights(&self) -> &[ContactWeight] {
        &self.weights
    }

    /// The terms that a contact which includes weight adds to each component of a velocity; none where it leaves weight out.
    pub(super) fn included_weight(&mut self, contact: &Lasting<'_>, body: &str) -> Option<Vec<Expr>> {
        if contact.include.is_none_or(<[Included]>::is_empty) {
            return None;
        }
        let wrong = if contact.duration.is_none() {
            Some(("the impulse of weight cannot be found without the duration of the contact", "write `duration: dt`"))
        } else if !self.weight_has_a_component() {
            let help = match self.scene.plane {
                Plane::Horizontal => "write `plane: vertical`, or remove `include`",
                Plane::Vertical => "let an axis point up or down, such as `y: upwards`, or remove `include`",
            };
            Some(("weight does not act along the axes of this scene", help))
        } else if self.guided(body).is_some_and(|guide| self.weight_along(&guide).is_zero()) {
            Some(("the weight of a body on a level guide is balanced by the guide", "remove `include`"))
        } else {
            None
        };
        if let Some((message, help)) = wrong {
            let fault = Fault::new(Code::Value, message).help(help);
            self.faults.push(fault.at_path(contact.path.key("include")));
            return None;
        }
        let time = self.contact_time(contact)?;
        let gained = self.gravity() * time;
        let part = |part: Expr| if part.is_zero() { part } else { part * gained.clone() };
        Some(self.straight_down().into_iter().map(part).collect())
    }

    /// The components of a unit vector that points down.
    fn straight_down(&self) -> Vec<Expr> {
        (0..self.axes.len()).map(|position| self.downwards(position).map_or_else(Expr::zero, Expr::integer)).collect()
    }

    /// The share of weight along a guide.
    fn weight_along(&self, guide: &Guided) -> Expr {
        dot(&self.straight_down(), &self.components(&guide.along)).simplify()
    }

    /// The terms that weight adds to a velocity along and across a normal; none where it adds nothing.
    pub(super) fn turned_into(&self, gained: &[Expr], frame: &Frame) -> [Option<Expr>; 2] {
        let part = |part: Expr| Some(part).filter(|part| !part.is_zero());
        if let [only] = gained {
            return [part(only.clone()), None];
        }
        let across = Direction::turned(frame.normal.quarters + 1, frame.normal.turn.clone());
        [&frame.normal, &across].map(|direction| part(dot(gained, &self.components(direction))))
    }

    /// Notes the impulse that an included weight gives a body.
    pub(super) fn weight_acts(&mut self, index: usize, body: &str, gained: &[Expr]) {
        let mass = self.mass(body);
        self.note_impulse(index, body, "weight", gained.iter().map(|gain| gain.clone() * mass.clone()).collect());
    }

    fn contact_time(&mut self, contact: &Lasting<'_>) -> Option<Expr> {
        let meaning = format!("the duration of {}", self.stage_phrase(contact.index));
        let path = contact.path.key("duration");
        Some(self.read_positive(contact.duration?, Dimension::TIME, &meaning, &path))
    }

    /// Compares the impulse of weight with the change of momentum of each body, by its names before and after the contact, and
    /// requires that it is small where it is left out. `hangs` says that weight acts although no axis points up or down.
    pub(super) fn weigh_contact(&mut self, contact: &Lasting<'_>, bodies: &[(&str, &str)], hangs: bool) {
        let acts = hangs || self.weight_has_a_component();
        let Some(time) = acts.then(|| self.contact_time(contact)).flatten() else { return };
        let included = contact.include.is_some_and(|include| !include.is_empty());
        for (before, after) in bodies {
            let along = self.guided(before).map(|guide| self.weight_along(&guide));
            if along.as_ref().is_some_and(Expr::is_zero) {
                continue;
            }
            let [from, to] = [(before, contact.index + 1), (after, contact.index + 2)]
                .map(|(body, instant)| self.velocities(body, instant));
            let change = to.into_iter().zip(from).map(|(to, from)| to - from).collect();
            let fall = [self.gravity(), time.clone()].into_iter().chain(along.filter(|along| !along.is_one()));
            let fall = Expr::product(fall);
            let contact_weight =
                ContactWeight { stage: contact.index, on: (*before).to_owned(), included, fall, change };
            if !included {
                let [weight, change] = contact_weight.squares();
                let phrase = self.stage_phrase(contact.index);
                let reason = Reason::WeightNotNegligible(self.called(before), phrase, contact.include.is_some());
                self.require(weight, Relation::Less, change, reason);
            }
            self.weights.push(contact_weight);
        }
    }
}
