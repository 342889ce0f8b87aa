//! A body that slides on another one which is free to move: friction gives both opposite impulses, and heat.

use crate::Because;
use crate::Builder;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::pair::Pair;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_laws::kinematics;
use momentous_laws::separation;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Term;
use momentous_scene::stage::Interact;
use momentous_solve::Relation;

/// Two bodies that rub on each other, and their velocities before and after.
struct Rubbing<'a> {
    index: usize,
    /// The body on top, and the one on which it slides.
    bodies: [&'a str; 2],
    names: [String; 2],
    /// Whether the body on top slides along the axis (1) or against it (-1).
    sign: i64,
    /// The size of the force of friction.
    friction: Expr,
    time: Expr,
    before: [Expr; 2],
    after: [Expr; 2],
}

impl Builder<'_> {
    /// The first body slides on the second.
    pub(crate) fn rub(&mut self, index: usize, stage: &Interact, friction: &Term, path: &Path) {
        let (Some([upper, lower]), &[(axis, _)]) = (stage.between.first_chunk(), &self.axes[..]) else {
            let fault = Fault::new(Code::Value, "friction acts between two bodies, along the only axis of a scene");
            let help = "name two bodies, the one on top first, and leave one axis";
            self.faults.push(fault.help(help).at_path(path.key("friction")));
            return;
        };
        if let (3.., _) | (_, true) = (stage.between.len(), upper == lower) {
            let fault = Fault::new(Code::Value, "friction acts between two bodies");
            self.faults.push(fault.help("name two, the one on top first").at_path(path.key("between")));
            return;
        }
        let told = [("at_rest", stage.at_rest), ("elastic", stage.elastic), ("loss", stage.loss.is_some())];
        for (key, _) in told.into_iter().filter(|(_, told)| *told) {
            let message = format!("`{key}` cannot be used beside `friction`, which says what is lost");
            let fault = Fault::new(Code::OverDetermined, message).help(format!("remove `{key}`"));
            self.faults.push(fault.at_path(path.key(key)));
        }
        let bodies = [upper.as_str(), lower.as_str()];
        let names = bodies.map(|body| self.called(body));
        let friction = self.friction_between(index, bodies[0], &names, friction, path);
        let meaning = format!("the duration of {}", self.stage_phrase(index));
        let time = match &stage.during {
            Some(term) => self.read_positive(term, Dimension::TIME, &meaning, &path.key("during")),
            None => self.positive(self.in_stage(QuantityKind::Duration, "", index), meaning).into(),
        };
        self.lasting[index] = Some(time.clone());
        let sign = self.sense(stage.direction.as_ref(), path);
        let [before, after] =
            [index + 1, index + 2].map(|instant| bodies.map(|body| self.velocity(body, instant, axis)));
        let rubbing = Rubbing { index, bodies, names, sign, friction, time, before, after };
        self.rubbing_impulses(&rubbing, path);
        let [upper, lower] = &rubbing.names;
        if stage.until.is_some() {
            let because = format!("{upper} slides until both move together");
            let [one, other] = rubbing.after.clone();
            self.law(&kinematics::TOGETHER, Some(index), because, (other, one));
        }
        let ends = [(Relation::Greater, &rubbing.before), (Relation::AtLeast, &rubbing.after)];
        for (relation, [one, other]) in ends.into_iter().take(if stage.until.is_some() { 1 } else { 2 }) {
            let [ahead, behind] = if sign > 0 { [one, other] } else { [other, one] };
            let reason = Reason::SlidesOtherWay(upper.clone(), lower.clone());
            self.require(ahead.clone(), relation, behind.clone(), reason);
        }
        let slid = stage.distance.as_ref().map(|term| {
            let meaning = format!("how far {upper} slides on {lower}");
            self.read_positive(term, Dimension::LENGTH, &meaning, &path.key("distance"))
        });
        self.ways(&rubbing, axis, slid.as_ref());
        if let Some(slid) = slid {
            self.heat(&rubbing, &slid);
        }
        self.neglect(format!("friction on {lower} from below"), "the problem gives none");
        self.neglect("air resistance", "the problem gives none");
    }

    /// Refuses, without friction, keys that only friction can have.
    pub(crate) fn nothing_rubs(&mut self, stage: &Interact, path: &Path) {
        let told = [
            ("direction", stage.direction.is_some()),
            ("distance", stage.distance.is_some()),
            ("until", stage.until.is_some()),
        ];
        for (key, _) in told.into_iter().filter(|(_, told)| *told) {
            let fault = Fault::new(Code::MissingKey, format!("`{key}` belongs to a body that slides on another one"));
            self.faults.push(fault.help("write `friction: mu_k` as well").at_path(path.key(key)));
        }
    }

    /// The size of the friction between a body and the one below it.
    fn friction_between(&mut self, index: usize, upper: &str, names: &[String; 2], term: &Term, path: &Path) -> Expr {
        let meaning = "the coefficient of kinetic friction";
        let friction = self.read_positive(term, Dimension::NONE, meaning, &path.key("friction"));
        let [name, other] = names;
        let weight = self.mass(upper) * self.gravity();
        let meaning = format!("the normal force on {name} from {other}");
        let normal = self.positive(self.in_stage(QuantityKind::NormalForce, upper, index), meaning);
        let because = format!("{other} carries {name} alone");
        self.law(&force::NORMAL_FORCE, Some(index), because, (normal.into(), weight.clone()));
        friction * weight
    }

    fn rubbing_impulses(&mut self, rubbing: &Rubbing<'_>, path: &Path) {
        let Rubbing { index, bodies, before, after, .. } = rubbing;
        let pair = Pair {
            index: *index,
            bodies: *bodies,
            before: before.clone(),
            after: after.clone(),
            link: "friction",
            line: "the axis",
            pulley: None,
        };
        let [on_upper, _] = self.pair(&pair, None, &|_, impulse| vec![impulse.clone()], None, path);
        let [name, other] = &rubbing.names;
        let impulse = Expr::integer(-rubbing.sign) * rubbing.friction.clone() * rubbing.time.clone();
        let because = format!(
            "friction, \u{3bc} times the weight of {name}, acts on {name} against the direction in which {name} slides on {other}"
        );
        self.law(&force::IMPULSE, Some(*index), because, (on_upper, impulse));
    }

    /// How far each of them moves over the ground.
    fn ways(&mut self, rubbing: &Rubbing<'_>, axis: Axis, slid: Option<&Expr>) {
        let index = rubbing.index;
        let [way, other_way] = [0, 1].map(|side| {
            let (body, name) = (rubbing.bodies[side], &rubbing.names[side]);
            let meaning = format!("the displacement of {name} over the ground");
            let way = Expr::from(self.symbol(self.in_stage(QuantityKind::Displacement, body, index), meaning));
            let fact = format!("the friction on {name} does not change");
            let because = Because::Conclusion(fact, "the velocity changes evenly".to_owned());
            let ends = [&rubbing.before[side], &rubbing.after[side]];
            let sides = kinematics::mean_velocity([&Expr::zero(), &way], ends, &rubbing.time);
            self.law(&kinematics::MEAN_VELOCITY, Some(index), because, sides);
            let because = format!("this is how far {} over the ground", self.does(body, ["moves", "move"]));
            self.comes_so_far((index, body), axis, way.clone(), because);
            way
        });
        if let Some(slid) = slid {
            let [name, other] = &rubbing.names;
            let because = format!("{name} slides on {other}, which moves meanwhile");
            let slid = Expr::integer(rubbing.sign) * slid.clone();
            self.law(&separation::RELATIVE_WAY, Some(index), because, separation::relative(&way, &other_way, &slid));
        }
    }

    /// The heat of the friction, which the kinetic energy of both loses.
    fn heat(&mut self, rubbing: &Rubbing<'_>, slid: &Expr) {
        let index = rubbing.index;
        let [name, other] = &rubbing.names;
        let heat = rubbing.friction.clone() * slid.clone();
        let [start, end] = [index + 1, index + 2]
            .map(|instant| Expr::sum(rubbing.bodies.map(|body| self.kinetic_term(body, instant))));
        let because = Because::Conclusion(
            format!("friction, \u{3bc} times the weight of {name}, acts on {name} and {other} in opposite directions"),
            format!("its work on both together is minus the friction times the distance that {name} slides on {other}"),
        );
        self.law(&energy::RUBBING, Some(index), because, energy::work_energy(start, [-heat.clone()], end));
        let lost = self.quantity(Name::of(QuantityKind::EnergyLost, "").during(self.stage_label(index)));
        if let Some(lost) = lost {
            let because =
                format!("friction, \u{3bc} times the weight of {name}, turns the kinetic energy lost into heat");
            self.law(&energy::HEAT, Some(index), because, (lost.into(), heat));
        }
    }
}
