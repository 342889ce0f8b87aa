//! A push against dry friction on a level floor: the normal force, the threshold, and whether the body moves at all.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::force;
use momentous_laws::momentum;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Friction;
use momentous_solve::Equation;
use momentous_solve::Relation;

use super::Builder;
use super::Integral;
use super::Name;
use super::Opposing;
use super::Passage;
use super::QuantityKind;
use super::Reason;
use super::alternative::Alternative;
use super::builder::LAW_COST;
use super::forces::Acts;
use super::incline::Incline;
use super::stage::Pushed;
use super::stage::Sliding;

/// The forces on a body that rests or slides on a floor, along its motion.
struct Contact {
    /// The sum of the pushes and weight along the floor.
    along: Expr,
    /// The normal force.
    normal: Expr,
    /// The coefficient of kinetic friction.
    kinetic: Expr,
    before: Expr,
    after: Expr,
    axis: Axis,
}

impl Contact {
    /// The force left along the motion while the body slides.
    fn net(&self) -> Expr {
        self.along.clone() - self.kinetic.clone() * self.normal.clone()
    }
}

impl Builder<'_> {
    /// A body on a floor, along one axis: slides against kinetic friction once the push exceeds the static threshold.
    pub(super) fn push_against_friction(&mut self, pushed: &Pushed<'_>, friction: &Friction, path: &Path) {
        let (index, body) = (pushed.index, pushed.body);
        let name = self.called(body);
        let [(axis, _)] = self.axes[..] else {
            let fault = Fault::new(Code::Value, "friction needs a scene with one axis, along the floor");
            self.faults.push(fault.help("leave one axis, such as `axes: { x: to the right }`").at_path(path.clone()));
            return;
        };
        self.rubs_on_a_floor(&pushed.incline, path);
        let meaning = "the coefficient of kinetic friction";
        let kinetic = self.read_positive(&friction.kinetic, Dimension::NONE, meaning, &path.key("kinetic"));
        let contact = self.contact(pushed, kinetic, axis);
        // Where static friction may hold the body first, its impulse is that of each way for itself.
        let impulse =
            friction.at_rest.is_none().then(|| contact.net().definite(pushed.clock, &pushed.start, &pushed.end));
        let impulse = impulse.flatten().map(|impulse| (Expr::integer(pushed.sign) * impulse).simplify());
        let called = pushed.acting.first().map_or("friction", |force| &force.name);
        self.note_impulse(index, body, called, impulse.into_iter().collect());
        self.neglect("air resistance", "the problem gives none");
        let begins = friction.at_rest.as_ref().map(|_| self.begins(index, &name));
        let acts = Acts { stage: index, on: body, during: [begins.as_ref().unwrap_or(&pushed.start), &pushed.end] };
        for force in &pushed.acting {
            self.note_pull(acts, &force.name, &force.strength, &force.direction);
        }
        let weight = self.mass(body) * self.gravity();
        let (normal, kinetic) = (contact.normal.clone(), contact.kinetic.clone());
        self.note_floor(acts, &pushed.incline, weight, normal, kinetic, pushed.sign < 0);
        match &friction.at_rest {
            Some(term) => {
                let meaning = "the coefficient of static friction";
                let threshold = self.read_positive(term, Dimension::NONE, meaning, &path.key("static"));
                let weaker = Reason::StaticBelowKinetic(name.clone());
                self.require(threshold.clone(), Relation::AtLeast, contact.kinetic.clone(), weaker);
                let threshold = threshold * contact.normal.clone();
                self.start_from_rest(pushed, &contact, &threshold);
            }
            None => {
                self.sliding(pushed, &contact);
                self.motion_along(pushed, axis, &[Expr::integer(pushed.sign) * contact.net()]);
            }
        }
        if let Some(distance) = &pushed.over {
            let sign = Expr::integer(pushed.sign);
            let forces = vec![sign.clone() * contact.along, -(sign.clone() * contact.kinetic * contact.normal)];
            let ends = [contact.before, contact.after].map(|speed| sign.clone() * speed);
            self.push_over(pushed, forces, distance, ends, Some(Opposing::Friction));
        }
    }

    /// Friction needs something that presses: along a vertical axis weight presses on nothing.
    pub(super) fn rubs_on_a_floor(&mut self, incline: &Incline, path: &Path) {
        if incline.press.is_zero() {
            let fault =
                Fault::new(Code::Value, "along a vertical axis nothing presses on a floor, so there is no friction");
            let help = "remove `friction`; write a force that holds the body back as one of the forces";
            self.faults.push(fault.help(help).at_path(path.clone()));
        }
    }

    /// The friction on a body that slides all the time one way, as a force along the axis.
    pub(super) fn sliding_friction(
        &mut self,
        pushed: &Pushed<'_>,
        friction: &Friction,
        axis: Axis,
        path: &Path,
    ) -> Expr {
        if friction.at_rest.is_some() {
            let fault = Fault::new(
                Code::Value,
                "beside a resistance or a force that depends on the position, a body slides all the way",
            );
            self.faults.push(fault.help("remove `static`").at_path(path.key("static")));
        }
        let kinetic =
            self.read(&friction.kinetic, Dimension::NONE, "the coefficient of kinetic friction", &path.key("kinetic"));
        let Contact { normal, kinetic, .. } = self.contact(pushed, kinetic, axis);
        Expr::integer(-pushed.sign) * kinetic * normal
    }

    /// The forces along and across the floor, the normal force as a quantity of its own where it does not change.
    fn contact(&mut self, pushed: &Pushed<'_>, kinetic: Expr, axis: Axis) -> Contact {
        let (index, body) = (pushed.index, pushed.body);
        let sign = Expr::integer(pushed.sign);
        let part = |position: usize| {
            let parts = pushed
                .acting
                .iter()
                .map(|force| force.strength.clone() * force.direction.cosine_and_sine()[position].clone());
            Expr::sum(parts)
        };
        let weight = self.mass(body) * self.gravity();
        let along = sign.clone() * (part(0) + self.weight_on_slope(body, &pushed.incline));
        let pressed = weight * pushed.incline.press.clone() - part(1);
        let normal = if pressed.contains(pushed.clock) {
            pressed
        } else {
            let meaning = format!("the normal force on {}", self.called(body));
            let symbol = Expr::from(self.positive(self.in_stage(QuantityKind::NormalForce, body, index), meaning));
            let because = "nothing moves at right angles to the surface";
            self.law(&force::NORMAL_FORCE, Some(index), because, (symbol.clone(), pressed));
            symbol
        };
        let [before, after] = [index + 1, index + 2].map(|instant| sign.clone() * self.velocity(body, instant, axis));
        let after = if pushed.stops { Expr::zero() } else { after };
        Contact { along, normal, kinetic, before, after, axis }
    }

    /// A body that slides all the time, one way.
    fn sliding(&mut self, pushed: &Pushed<'_>, contact: &Contact) {
        let name = self.called(pushed.body);
        let mass = self.mass(pushed.body);
        let slides = self.does(pushed.body, ["slides", "slide"]);
        let because = if self.zero_if_so_written(contact.kinetic.clone()).is_zero() {
            format!("{slides} throughout, without friction")
        } else {
            format!("{slides} throughout, and friction acts against the motion")
        };
        let Some(impulse) = self.net_impulse(&contact.net(), pushed.clock, &pushed.start, &pushed.end) else { return };
        let sides = momentum::impulse_momentum(&mass, &contact.before, &[impulse], &contact.after);
        self.law(&momentum::IMPULSE_MOMENTUM, Some(pushed.index), because, sides);
        if !pushed.stops {
            let reason = Reason::StopsEarly(name.clone());
            self.require(contact.after.clone(), Relation::AtLeast, Expr::zero(), reason);
        }
        self.slides_from(pushed, contact, &pushed.start, true);
        let reason = Reason::SlidesBackwards(name);
        self.require(contact.before.clone(), Relation::AtLeast, Expr::zero(), reason);
    }

    /// Refuses a body that slides one way at both ends, where the net force changes in between: it may stop there, or leave its
    /// floor.
    fn slides_from(&mut self, pushed: &Pushed<'_>, contact: &Contact, begins: &Expr, moves: bool) {
        let (name, clock) = (self.called(pushed.body), pushed.clock);
        let ends = [begins.clone(), pushed.end.clone()];
        if contact.normal.contains(clock) {
            let reason = Reason::LeavesFloor(name.clone());
            for end in [&pushed.start, &pushed.end] {
                let normal = contact.normal.substitute(&|symbol| (symbol == clock).then(|| end.clone()));
                self.require(normal, Relation::AtLeast, Expr::zero(), reason.clone());
            }
            self.passages.push(Passage {
                place: clock,
                ends: ends.clone(),
                kinetic: contact.normal.clone(),
                reason,
                way: None,
            });
        }
        let net = contact.net();
        let Some(gained) = net.definite(clock, begins, &clock.into()).filter(|_| net.contains(clock)) else { return };
        let start = if moves { self.mass(pushed.body) * contact.before.clone() } else { Expr::zero() };
        let reason = Reason::StopsEarly(name);
        self.passages.push(Passage { place: clock, ends, kinetic: start + gained, reason, way: None });
    }

    /// Notes that a changing push exceeds the greatest static friction neither ahead nor backwards before a time, where a body is
    /// held until then.
    fn watch_held(&mut self, pushed: &Pushed<'_>, [along, threshold]: [&Expr; 2], until: &Expr, what: &str) {
        let name = self.called(pushed.body);
        let (ahead, backwards) = (Reason::Beyond(name.clone()), Reason::BeyondBackwards(name));
        for (push, reason) in [(along.clone(), ahead), (-along.clone(), backwards)] {
            self.passages.push(Passage {
                place: pushed.clock,
                ends: [pushed.start.clone(), until.clone()],
                kinetic: threshold.clone() - push,
                reason,
                way: Some((self.choices.len(), what.to_owned())),
            });
        }
    }

    /// A body that starts from rest: it slides from the time at which the push reaches the threshold, at once, or not at all. One that
    /// may move already is held by kinetic friction only.
    fn start_from_rest(&mut self, pushed: &Pushed<'_>, contact: &Contact, threshold: &Expr) {
        let (index, start, end, along) = (pushed.index, &pushed.start, &pushed.end, &contact.along);
        let name = self.called(pushed.body);
        let may_move = self.may_move(pushed.body, index);
        if !may_move {
            self.starts_from_rest(index, pushed.body);
        }
        self.accelerated_at_both_ends(pushed, contact.axis);
        let begins = self.begins(index, &name);
        let at = |expr: &Expr, time: &Expr| expr.substitute(&|symbol| (symbol == pushed.clock).then(|| time.clone()));
        let changes = along.contains(pushed.clock) || threshold.contains(pushed.clock);
        let alternative = |what: String| Alternative { what, ..Alternative::default() };
        let backwards = Reason::BeyondBackwards(name.clone());
        let mut ways = Vec::new();

        // A push that does not change reaches the threshold at no time of its own.
        if changes {
            let mut moves = alternative(format!("{name} starts to slide"));
            let because = format!("{name} is at rest until the push reaches the greatest static friction");
            let sides = (at(along, &begins), at(threshold, &begins));
            moves.equations.push(self.stated(LAW_COST, &force::THRESHOLD, Some(index), because, sides, None));
            moves.equations.extend(self.gains(pushed, contact, &begins, "from then on "));
            moves.equations.extend(self.goes_in_this_way(pushed, contact, &Expr::zero(), Some(&begins)));
            let early = Reason::BeyondBeforeStart;
            moves.conditions.push(self.condition(begins.clone(), Relation::AtLeast, start.clone(), early));
            let at_first = Reason::BeyondFromStart;
            moves.conditions.push(self.condition(at(along, start), Relation::AtMost, at(threshold, start), at_first));
            let held = -at(threshold, start);
            moves.conditions.push(self.condition(at(along, start), Relation::AtLeast, held, backwards.clone()));
            self.watch_held(pushed, [along, threshold], &begins, &moves.what);
            let late = Reason::NeverBeyond(name.clone());
            moves.conditions.push(self.condition(begins.clone(), Relation::Less, end.clone(), late));
            ways.push(moves);
        }
        let mut at_once = alternative(format!("{name} starts to slide at once"));
        let because = "the push exceeds the greatest static friction from the beginning";
        let sides = (begins, start.clone());
        at_once.equations.push(self.stated(LAW_COST, &force::THRESHOLD, Some(index), because, sides, None));
        at_once.equations.extend(self.gains(pushed, contact, start, ""));
        at_once.equations.extend(self.goes_in_this_way(pushed, contact, &Expr::zero(), Some(start)));
        let weak = Reason::NotBeyondAtStart;
        at_once.conditions.push(self.condition(at(along, start), Relation::Greater, at(threshold, start), weak));
        ways.push(at_once);
        for way in &mut ways {
            let stops = Reason::StopsEarly(name.clone());
            way.conditions.push(self.condition(contact.after.clone(), Relation::AtLeast, Expr::zero(), stops));
        }

        // Where it stays at rest, it starts at no time, and there is nothing to go through.
        let from = self.begins(index, &name);
        self.slides_from(pushed, contact, &from, may_move);

        let mut stays = alternative(format!("{name} stays at rest"));
        stays.still = Some((index, pushed.body.to_owned()));
        let because = format!("the push stays below the greatest static friction, and {name} does not move");
        let sides = (contact.after.clone(), Expr::zero());
        stays.equations.push(self.stated(LAW_COST, &force::THRESHOLD, Some(index), because, sides, None));
        stays.equations.extend(self.goes_in_this_way(pushed, contact, &Expr::zero(), None));
        for (push, reason) in [(along.clone(), Reason::Beyond(name.clone())), (-along.clone(), backwards)] {
            for time in if changes { vec![start, end] } else { vec![end] } {
                let held = self.condition(at(&push, time), Relation::AtMost, at(threshold, time), reason.clone());
                stays.conditions.push(held);
            }
        }
        if changes {
            self.watch_held(pushed, [along, threshold], end, &stays.what);
        }
        ways.push(stays);
        if may_move {
            for way in &mut ways {
                for relation in [Relation::AtMost, Relation::AtLeast] {
                    let reason = Reason::MovesAlready(name.clone());
                    way.conditions.push(self.condition(contact.before.clone(), relation, Expr::zero(), reason));
                }
            }
            ways.push(self.goes_on_sliding(pushed, contact));
        }
        self.choices.push(ways);
    }

    /// Whether a body may move when a stage begins: something has happened to it, or the problem gives how it moves.
    fn may_move(&self, body: &str, index: usize) -> bool {
        let tells = [QuantityKind::Velocity, QuantityKind::Speed, QuantityKind::Momentum, QuantityKind::KineticEnergy];
        let is_given = |instant: usize| {
            tells.iter().any(|kind| self.given.contains(&Name::of(kind.clone(), body).at(instant).to_string()))
        };
        self.timeline.naming_instant(body, index + 1) > 1 || (1..=index + 1).any(is_given)
    }

    /// A body that moves when the push begins slides from then on.
    fn goes_on_sliding(&mut self, pushed: &Pushed<'_>, contact: &Contact) -> Alternative {
        let (index, name) = (pushed.index, self.called(pushed.body));
        let mut slides =
            Alternative { what: format!("{name} moves already and goes on sliding"), ..Alternative::default() };
        let begins = self.begins(index, &name);
        let because = format!("{name} slides from the beginning");
        let sides = (begins, pushed.start.clone());
        slides.equations.push(self.stated(LAW_COST, &force::THRESHOLD, Some(index), because, sides, None));
        slides.equations.extend(self.gains(pushed, contact, &pushed.start, ""));
        slides.equations.extend(self.goes_in_this_way(pushed, contact, &contact.before, Some(&pushed.start)));
        let reason = Reason::RestsOrSlidesBack(name.clone());
        slides.conditions.push(self.condition(contact.before.clone(), Relation::Greater, Expr::zero(), reason));
        let reason = Reason::StopsEarly(name);
        slides.conditions.push(self.condition(contact.after.clone(), Relation::AtLeast, Expr::zero(), reason));
        slides
    }

    /// The velocity that a body at rest gains from the time on at which it starts to slide.
    fn gains(&mut self, pushed: &Pushed<'_>, contact: &Contact, begins: &Expr, since: &str) -> Vec<Equation> {
        let (index, net) = (pushed.index, contact.net());
        let name = self.called(pushed.body);
        let mass = self.mass(pushed.body);
        let Some(value) = self.net_impulse(&net, pushed.clock, begins, &pushed.end) else { return Vec::new() };
        let meaning = format!("the impulse on {name} while it slides");
        let gained = Expr::from(self.symbol(self.in_stage(QuantityKind::TimeIntegral, "net", index), meaning));
        let integral = net.contains(pushed.clock).then(|| Integral {
            integrand: net.clone(),
            variable: pushed.clock,
            low: begins.clone(),
            high: pushed.end.clone(),
        });
        let because = format!("{since}the impulse is that of the push minus kinetic friction");
        let sides = (gained.clone(), value);
        let impulse = self.stated(LAW_COST, &force::IMPULSE, Some(index), because, sides, integral);
        let (because, start) = if self.may_move(pushed.body, index) {
            (format!("the impulse changes the momentum of {name}"), mass.clone() * contact.before.clone())
        } else {
            (format!("{name} starts from rest"), Expr::zero())
        };
        let sides =
            (Expr::sum([start, gained].into_iter().filter(|part| !part.is_zero())), mass * contact.after.clone());
        let momentum = self.stated(LAW_COST, &momentum::IMPULSE_MOMENTUM, Some(index), because, sides, None);
        vec![impulse, momentum]
    }

    /// The place of the body in the end and the net force at both ends, where it slides from that time on with that speed at first.
    fn goes_in_this_way(
        &mut self,
        pushed: &Pushed<'_>,
        contact: &Contact,
        before: &Expr,
        from: Option<&Expr>,
    ) -> Vec<Equation> {
        let sign = Expr::integer(pushed.sign);
        let ends = [before, &contact.after].map(|speed| (sign.clone() * speed.clone()).simplify());
        let sliding = Sliding { net: (sign * contact.net()).simplify(), ends: ends.each_ref(), from };
        self.moves_in_this_way(pushed, contact.axis, &sliding)
    }

    /// The time at which a body at rest starts to slide.
    fn begins(&mut self, index: usize, name: &str) -> Expr {
        self.symbol(
            self.in_stage(QuantityKind::StartTime, "", index),
            format!("the time at which {name} starts to slide"),
        )
        .into()
    }

    fn net_impulse(&mut self, net: &Expr, clock: Symbol, start: &Expr, end: &Expr) -> Option<Expr> {
        if !net.contains(clock) {
            return Some(net.clone() * (end.clone() - start.clone()));
        }
        let value = net.definite(clock, start, end);
        if value.is_none() {
            self.faults.push(Fault::new(Code::Stuck, "the forces of this stage cannot be integrated over time"));
        }
        value.map(|value| value.simplify())
    }
}
