//! Impacts of two bodies.

use crate::Agent;
use crate::Builder;
use crate::Impulse;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::directions::Split;
use crate::frame::Frame;
use crate::weight_in_contact::Lasting;
use crate::wording;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_laws::momentum;
use momentous_laws::restitution;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::Term;
use momentous_scene::stage::Impact;
use momentous_scene::stage::Partners;
use momentous_solve::Relation;

/// The facts that both bodies of an impact share.
pub(super) struct Contact<'a> {
    pub index: usize,
    pub stage: &'a Impact,
    pub path: &'a Path,
}

impl Builder<'_> {
    pub(crate) fn impact(&mut self, index: usize, stage: &Impact, path: &Path) {
        let contact = Contact { index, stage, path };
        if self.scene.plane == Plane::Vertical && stage.include.is_empty() {
            self.neglect(
                "weight during the impact",
                "it is not impulsive: its impulse during the short contact is negligible",
            );
        }
        match stage.partners() {
            Some(Partners::Surface(body, surface)) => self.surface_impact(&contact, body, surface),
            Some(Partners::Bodies(first, second)) => {
                let guided = [first, second].iter().any(|body| self.guided(body).is_some());
                match (stage.plastic, guided) {
                    (true, true) => self.guided_union(&contact, first, second),
                    (true, false) => self.plastic_impact(&contact, first, second),
                    (false, true) => self.guided_impact(&contact, first, second),
                    (false, false) => self.body_impact(&contact, first, second),
                }
            }
            None => {}
        }
        self.told_loss(&contact);
        let includes = matches!(stage.partners(), Some(Partners::Surface(..)));
        let include = includes.then_some(&stage.include[..]);
        let lasting = Lasting { index, duration: stage.duration.as_ref(), include, path };
        let after = |body| (body, stage.becomes.as_deref().unwrap_or(body));
        match stage.partners() {
            Some(Partners::Surface(body, _)) => self.weigh_contact(&lasting, &[after(body)], false),
            Some(Partners::Bodies(first, second)) => {
                if !stage.include.is_empty() {
                    let fault = Fault::new(Code::Value, "an impact of two bodies cannot include weight");
                    let help = "remove it; write `allow: [weight-neglected]` if weight is not small";
                    self.faults.push(fault.help(help).at_path(path.key("include")));
                }
                self.weigh_contact(&lasting, &[after(first), after(second)], false);
            }
            None => {}
        }
    }

    /// The balance of energy, where the loss is given instead of a coefficient of restitution.
    fn told_loss(&mut self, contact: &Contact<'_>) {
        let stage = contact.stage;
        let of_energy = stage.elastic && !self.has_coefficient(contact.index, stage);
        let loss = match &stage.loss {
            Some(term) => self.read(term, Dimension::ENERGY, "the kinetic energy lost", &contact.path.key("loss")),
            None if of_energy => Expr::zero(),
            None => return,
        };
        if stage.loss.is_some() {
            let reason = Reason::NegativeLoss;
            self.require(loss.clone(), Relation::AtLeast, Expr::zero(), reason);
        }
        let bodies: Vec<&str> = match stage.partners() {
            Some(Partners::Bodies(first, second)) => vec![first, second],
            Some(Partners::Surface(body, _)) => vec![body],
            None => return,
        };
        let after: Vec<&str> = stage.becomes.as_deref().map_or_else(|| bodies.clone(), |union| vec![union]);
        let [start, end] = [(bodies, contact.index + 1), (after, contact.index + 2)].map(|(bodies, instant)| {
            Expr::sum(bodies.iter().map(|body| self.kinetic_of(body, instant)).collect::<Vec<_>>())
        });
        let because = if of_energy { "no kinetic energy is lost" } else { "the loss of kinetic energy is given" };
        self.law(&energy::LOSS, Some(contact.index), because, (start - loss, end));
    }

    /// Whether an elastic impact is given by e = 1: along a line of impact, or at a surface.
    fn has_coefficient(&self, index: usize, stage: &Impact) -> bool {
        stage.against.is_some() || self.frames.get(index).is_some_and(Option::is_some)
    }

    /// The coefficient of restitution that the stage tells: its own, or 1.
    pub(super) fn coefficient(&mut self, contact: &Contact<'_>) -> Option<Expr> {
        match &contact.stage.restitution {
            Some(term) => Some(self.restitution_coefficient(term, &contact.path.key("restitution"))),
            None => contact.stage.elastic.then(Expr::one),
        }
    }

    /// Two bodies that separate: momentum along the line of impact, restitution, nothing across it.
    fn body_impact(&mut self, contact: &Contact<'_>, first: &str, second: &str) {
        let index = contact.index;
        let Some(frame) = self.line_of_impact(contact) else {
            self.general_impact(contact, first, second);
            return;
        };
        self.frames[index] = Some(frame.clone());
        let (before, after) = (index + 1, index + 2);
        let [a1, b1] = [first, second].map(|body| self.split(body, before, index, &frame));
        let [a2, b2] = [first, second].map(|body| self.split(body, after, index, &frame));
        let [mass_a, mass_b] = [first, second].map(|body| self.mass(body));
        let (name_a, name_b) = (self.called(first), self.called(second));
        let line = if a1.across.is_some() { " along the line of impact" } else { "" };

        let along = |split: &Split| split.along.clone();
        self.internal_impulse(contact, [first, second], &frame, [&mass_a, &mass_b], [&a1, &b1], [&a2, &b2]);
        let because = wording::only_between([&name_a, &name_b], line);
        let sides = momentum::conservation(
            &[(mass_a.clone(), along(&a1)), (mass_b.clone(), along(&b1))],
            &[(mass_a, along(&a2)), (mass_b, along(&b2))],
        );
        self.law(&momentum::CONSERVATION, Some(index), because, sides);
        if let Some(e) = self.coefficient(contact) {
            let because = match a1.across {
                Some(_) => "restitution acts along the line of impact only".to_owned(),
                None if e.is_zero() => {
                    format!("{name_a} and {name_b} do not separate again, since the coefficient of restitution is zero")
                }
                None => format!("{name_a} and {name_b} collide and separate again"),
            };
            let sides = restitution::restitution(&e, [&a1.along, &b1.along], [&a2.along, &b2.along]);
            self.law(&restitution::RESTITUTION, Some(index), because, sides);
        }
        for (body, start, end) in [(first, &a1, &a2), (second, &b1, &b2)] {
            self.smooth(index, body, start, end);
        }
        let reason = Reason::NoCatchingUp(name_a.clone(), name_b.clone());
        self.require(along(&a1), Relation::Greater, along(&b1), reason);
        self.lies_behind(contact, [first, second]);
        let reason = Reason::PassesThrough(name_a.clone(), name_b.clone());
        self.require(along(&b2), Relation::AtLeast, along(&a2), reason);
        self.parts_no_faster(contact, [&a1.along, &b1.along], [&a2.along, &b2.along]);
        if self.weight_acts_across() {
            self.not_needed(
                "weight and any support of the bodies",
                "they have no component along the motion, and nothing impulsive presses on a support",
            );
        }
    }

    /// The impulse between the two bodies, for whoever asks for it.
    fn internal_impulse(
        &mut self,
        contact: &Contact<'_>,
        bodies: [&str; 2],
        frame: &Frame,
        masses: [&Expr; 2],
        before: [&Split; 2],
        after: [&Split; 2],
    ) {
        let index = contact.index;
        let names = bodies.map(|body| self.called(body));
        let turned = before[0].across.is_some().then_some("n");
        let impulses = [0, 1].map(|side| {
            let meaning = format!("the impulse on {} from {}", names[side], names[1 - side]);
            let name = self.in_stage(QuantityKind::Impulse, bodies[side], index).along(turned);
            Expr::from(self.symbol(name, meaning))
        });
        for side in [0, 1] {
            let because = wording::only_contact(&names[side]);
            let start = self.changed(bodies[side], index + 1, before[side]);
            let end = self.changed(bodies[side], index + 2, after[side]);
            let sides = momentum::impulse_momentum(masses[side], &start, std::slice::from_ref(&impulses[side]), &end);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
            self.impulses.push(Impulse {
                stage: index,
                on: bodies[side].to_owned(),
                by: Agent::Body(bodies[1 - side].to_owned()),
                called: format!("the contact with {}", names[1 - side]),
                components: self.resolved(&impulses[side], frame),
                impulsive: true,
            });
            // Along an oblique line the average force is a magnitude: the contact pushes the first body back along the line.
            let size = if turned.is_some() && side == 0 { -impulses[side].clone() } else { impulses[side].clone() };
            self.mean_force(index, bodies[side], &size, contact.stage.duration.as_ref(), contact.path);
        }
        let [on_first, on_second] = impulses;
        let because = "they are action and reaction";
        self.law(&momentum::THIRD_LAW, Some(index), because, (on_second, -on_first));
    }

    /// No impulse acts across a smooth contact.
    pub(super) fn smooth(&mut self, index: usize, body: &str, before: &Split, after: &Split) {
        let (Some(start), Some(end)) = (&before.across, &after.across) else { return };
        let because =
            format!("the contact is smooth and exerts no impulse on {} across the line of impact", self.called(body));
        self.law(&momentum::NO_IMPULSE, Some(index), because, (end.clone(), start.clone()));
        self.neglect("friction between the bodies", "they are smooth");
    }

    /// An impact in the plane whose line is not stated: momentum along each axis, and what the problem gives besides.
    fn general_impact(&mut self, contact: &Contact<'_>, first: &str, second: &str) {
        let (name_a, name_b) = (self.called(first), self.called(second));
        self.exchange(contact, [first, second], [first, second]);
        self.push_each_other(contact.index, first, second);
        if contact.stage.loss.is_none() && !contact.stage.elastic {
            self.creates_no_energy(contact.index, [first, second]);
        }
        if self.weight_acts_across() {
            self.not_needed("weight and the support of the bodies", "they act across the plane of motion and cancel");
        }
        self.not_needed(
            "the impulse between the bodies",
            format!("within the system it cancels: on {name_a} and on {name_b} it is equal and opposite"),
        );
    }

    /// Requires that two bodies push each other, and against the way on which they meet: not that they go on as if nothing had
    /// happened.
    fn push_each_other(&mut self, index: usize, first: &str, second: &str) {
        let [first_before, second_before, after] =
            [(first, index + 1), (second, index + 1), (second, index + 2)].map(|(body, at)| self.velocities(body, at));
        let parts = first_before.into_iter().zip(second_before).zip(after);
        let pushed = Expr::sum(parts.map(|((first_before, second_before), after)| {
            (first_before - second_before.clone()) * (after - second_before)
        }));
        let reason = Reason::NothingExchanged(self.called(first), self.called(second));
        self.require(Expr::zero(), Relation::Less, pushed, reason);
    }

    /// Requires that two bodies part no faster along the line of impact than they met, where no coefficient of restitution says
    /// so.
    pub(super) fn parts_no_faster(&mut self, contact: &Contact<'_>, before: [&Expr; 2], after: [&Expr; 2]) {
        if contact.stage.restitution.is_none() {
            let lost = (before[0].clone() - before[1].clone()) - (after[1].clone() - after[0].clone());
            let reason = Reason::CreatesEnergy;
            self.require(lost, Relation::AtLeast, Expr::zero(), reason);
        }
    }

    /// Requires that two bodies have no more kinetic energy after an impact than before it.
    pub(super) fn creates_no_energy(&mut self, index: usize, bodies: [&str; 2]) {
        let [start, end] = [index + 1, index + 2]
            .map(|instant| Expr::sum(bodies.iter().map(|body| self.kinetic_of(body, instant)).collect::<Vec<_>>()));
        let reason = Reason::CreatesEnergy;
        self.require(start, Relation::AtLeast, end, reason);
    }

    /// Momentum along every axis, for bodies that exchange impulses of unknown direction, and those impulses.
    fn exchange(&mut self, contact: &Contact<'_>, before: [&str; 2], after: [&str; 2]) {
        let index = contact.index;
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let names = before.map(|body| self.called(body));
        let masses = before.map(|body| self.mass(body));
        let mut components: [Vec<Expr>; 2] = [Vec::new(), Vec::new()];
        for axis in &axes {
            let start = before.map(|body| self.velocity(body, index + 1, *axis));
            let end = after.map(|body| self.velocity(body, index + 2, *axis));
            let along = if axes.len() > 1 { format!(" along {}", axis.letter()) } else { String::new() };
            let because = wording::only_between([&names[0], &names[1]], &along);
            let pair = |values: &[Expr; 2]| [0, 1].map(|index| (masses[index].clone(), values[index].clone()));
            let united = after[0] == after[1];
            let total = if united {
                vec![(masses[0].clone() + masses[1].clone(), end[0].clone())]
            } else {
                pair(&end).to_vec()
            };
            self.law(&momentum::CONSERVATION, Some(index), because, momentum::conservation(&pair(&start), &total));
            let mut impulses = Vec::new();
            for side in [0, 1] {
                let meaning = format!("the impulse on {} from {}{along}", names[side], names[1 - side]);
                let name = Name::of(QuantityKind::Impulse, before[side]).along(self.letter(*axis));
                let impulse = name.during(self.stage_label(index));
                let impulse = Expr::from(self.symbol(impulse, meaning));
                let because = wording::only_contact(&names[side]);
                let sides =
                    momentum::impulse_momentum(&masses[side], &start[side], std::slice::from_ref(&impulse), &end[side]);
                self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
                components[side].push(impulse.clone());
                impulses.push(impulse);
            }
            if let [on_first, on_second] = &impulses[..] {
                let sides = (on_second.clone(), -on_first.clone());
                self.law(&momentum::THIRD_LAW, Some(index), "they are action and reaction", sides);
            }
            if axes.len() == 1 {
                for side in [0, 1] {
                    self.mean_force(
                        index,
                        before[side],
                        &impulses[side].clone(),
                        contact.stage.duration.as_ref(),
                        contact.path,
                    );
                }
            }
        }
        for (side, parts) in components.into_iter().enumerate() {
            self.impulses.push(Impulse {
                stage: index,
                on: before[side].to_owned(),
                by: Agent::Body(before[1 - side].to_owned()),
                called: format!("the contact with {}", names[1 - side]),
                components: parts,
                impulsive: true,
            });
        }
    }

    /// Two bodies that stay together.
    fn plastic_impact(&mut self, contact: &Contact<'_>, first: &str, second: &str) {
        let (index, stage) = (contact.index, contact.stage);
        let (name_a, name_b) = (self.called(first), self.called(second));
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        match &stage.becomes {
            Some(union) => self.exchange(contact, [first, second], [union, union]),
            None => {
                self.exchange(contact, [first, second], [first, second]);
                for axis in &axes {
                    let [a, b] = [first, second].map(|body| self.velocity(body, index + 2, *axis));
                    let because = format!("{name_a} and {name_b} stay together");
                    self.law(&restitution::PLASTIC, Some(index), because, (b, a));
                }
            }
        }
        self.catches_up(contact, [first, second]);
        self.not_needed("the forces between the bodies", "their impulses cancel in pairs within the system");
        self.neglect(
            "friction and other resistance from outside",
            "they are not impulsive: their impulse during the short impact is negligible",
        );
    }

    /// The coefficient of restitution: between 0 and 1.
    pub(crate) fn restitution_coefficient(&mut self, term: &Term, path: &Path) -> Expr {
        let e = self.read(term, Dimension::NONE, "the coefficient of restitution", path);
        self.require(e.clone(), Relation::AtLeast, Expr::zero(), Reason::NegativeRestitution);
        self.require(e.clone(), Relation::AtMost, Expr::one(), Reason::RestitutionAboveOne);
        e
    }

    /// The line of impact: stated, or the only axis.
    pub(super) fn line_of_impact(&mut self, contact: &Contact<'_>) -> Option<Frame> {
        match &contact.stage.line_of_impact {
            Some(term) => Some(Frame { normal: self.direction(term, &contact.path.key("line_of_impact")) }),
            None => (self.axes.len() == 1).then(|| Frame { normal: self.first_axis() }),
        }
    }

    /// The average force of an impulse, where a duration is used.
    pub(crate) fn mean_force(
        &mut self,
        index: usize,
        body: &str,
        impulse: &Expr,
        duration: Option<&Term>,
        path: &Path,
    ) {
        let Some(term) = duration else { return };
        let phrase = self.stage_phrase(index);
        let time =
            self.read_positive(term, Dimension::TIME, &format!("the duration of {phrase}"), &path.key("duration"));
        let meaning = format!("the average force on {} during {phrase}", self.called(body));
        let force = Expr::from(self.symbol(self.in_stage(QuantityKind::MeanForce, body, index), meaning));
        let because = "the average force would give the same impulse in the same time";
        self.law(&force::MEAN_FORCE, Some(index), because, force::mean_force(impulse, &force, &time));
    }

    /// The name of a quantity of a stage.
    pub(crate) fn in_stage(&self, kind: QuantityKind, subject: &str, index: usize) -> Name {
        Name::of(kind, subject).during(self.stage_label(index))
    }

    /// The label by which the names of impulses of several stages are told apart.
    pub(crate) fn stage_label(&self, index: usize) -> Option<String> {
        let stage_name = || self.scene.stages.get(index).and_then(momentous_scene::Stage::name).map(str::to_owned);
        (self.scene.stages.len() > 1).then(|| stage_name().unwrap_or_else(|| (index + 1).to_string()))
    }
}
