//! Two bodies in a row: impulse and momentum, work and energy of both together and of each alone.

use crate::Agent;
use crate::Because;
use crate::Builder;
use crate::Direction;
use crate::ForceKind;
use crate::Impulse;
use crate::Influence;
use crate::Opposing;
use crate::QuantityKind;
use crate::Reason;
use crate::forces::Acts;
use crate::incline::Incline;
use crate::name::is_bare_name;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_laws::kinematics;
use momentous_laws::momentum;
use momentous_quantity::Dimension;
use momentous_scene::Term;
use momentous_scene::stage::Tow;
use momentous_scene::stage::Towed;
use momentous_scene::stage::Until;
use momentous_solve::Relation;

/// One of the two bodies.
struct Member {
    name: String,
    mass: Expr,
    /// Everything from outside that acts along the axis.
    drive: Expr,
    before: Expr,
    after: Expr,
}

impl Builder<'_> {
    pub(crate) fn tow(&mut self, index: usize, stage: &Tow, path: &Path) {
        if stage.by.is_some() && stage.string.is_some() {
            let fault = Fault::new(Code::Value, "two bodies in a row are joined by one thing");
            let help = "write `string` for what can only pull, or `by` for what can push as well";
            self.faults.push(fault.help(help).at_path(path.key("by")));
        }
        let joint = stage.joint();
        let incline = self.incline(index, stage.incline.as_ref(), path);
        let duration = self.stage_duration(index, stage.duration.as_ref(), path);
        self.lasting[index] = Some(duration.clone());
        let stops = stage.until == Some(Until::Rest);
        if stops {
            self.takes_time(index, &duration);
        }
        let front = self.member(index, &stage.front, &incline, &duration, stops, &path.key("front"));
        let rear = self.member(index, &stage.rear, &incline, &duration, stops, &path.key("rear"));
        let because = format!("{joint} keeps {} and {} together", front.name, rear.name);
        for (one, other) in [(&front.before, &rear.before), (&front.after, &rear.after)] {
            if !other.is_zero() {
                self.law(&kinematics::TOGETHER, Some(index), because.clone(), (one.clone(), other.clone()));
            }
        }
        let tension = self.pull_of_joint(index, stage, &duration);
        let both = [&front, &rear];
        let driven = Expr::sum(both.map(|member| member.drive.clone()));
        let masses = |velocity: &dyn Fn(&Member) -> Expr| {
            momentum::total(&both.map(|member| (member.mass.clone(), velocity(member))))
        };
        let because = format!("{joint} acts on both with equal and opposite impulses, which cancel in the sum");
        let start = Expr::sum([masses(&|member| member.before.clone()), driven * duration.clone()]);
        self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, (start, masses(&|member| member.after.clone())));
        for (member, sign) in [(&front, -1), (&rear, 1)] {
            let because = format!("{joint} and the external forces change the momentum of {}", member.name);
            let acting = Expr::sum([Expr::integer(sign) * tension.clone(), member.drive.clone()]);
            let sides =
                momentum::impulse_momentum(&member.mass, &member.before, &[acting * duration.clone()], &member.after);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
        }
        if let Some(axis) = self.only_axis() {
            for (member, towed) in [(&front, &stage.front), (&rear, &stage.rear)] {
                self.moves_evenly((index, &towed.body), axis, [&member.before, &member.after], &duration);
            }
        }
        if let Some(term) = &stage.distance {
            let meaning = format!("how far {} and {} move", front.name, rear.name);
            let distance = self.read_positive(term, Dimension::LENGTH, &meaning, &path.key("distance"));
            let kinetic = |velocity: &dyn Fn(&Member) -> Expr| {
                Expr::sum(both.map(|member| energy::kinetic(&member.mass, &[velocity(member)])))
            };
            self.comes_evenly(index, &front.name, &distance, [&front.before, &front.after], &duration);
            let works = both.map(|member| (member.drive.clone() * distance.clone()).simplify());
            let fact = format!("{joint} does equal and opposite work on the two bodies");
            let because = Because::Conclusion(fact, "its total work is zero".to_owned());
            let (start, end) = (kinetic(&|member| member.before.clone()), kinetic(&|member| member.after.clone()));
            self.goes_the_whole_way(&front.name, kinetic(&|_| front.before.clone()), works.clone());
            self.law(&energy::WORK_ENERGY, Some(index), because, energy::work_energy(start, works, end));
        }
        let opposing = stage.both().iter().any(|towed| towed.friction.is_some()).then_some(Opposing::Friction);
        for speed in [&front.before, &front.after].into_iter().filter(|speed| !speed.is_zero()) {
            let reason = Reason::MovesBack(front.name.clone()).against(opposing);
            self.require(speed.clone(), Relation::AtLeast, Expr::zero(), reason);
        }
        if stage.pulls_only() || self.is_string_taut(index, stage.both().map(|towed| towed.body.as_str())) {
            self.require(tension, Relation::AtLeast, Expr::zero(), Reason::Slack(joint.to_owned()));
        }
        self.neglect(format!("the mass of {joint}"), "it is light compared with the bodies that it joins");
        self.neglect("air resistance", "the problem gives none");
    }

    /// The pull of what joins the bodies, and its part in diagrams.
    fn pull_of_joint(&mut self, index: usize, stage: &Tow, duration: &Expr) -> Expr {
        let joint = stage.joint();
        let meaning = format!("the pull of {joint} during {} (negative where it pushes)", self.stage_phrase(index));
        let symbol = self.symbol(self.in_stage(QuantityKind::Tension, "", index), meaning);
        let names = stage.both().map(|towed| towed.body.clone());
        for (side, other, reversed) in [(0, 1, true), (1, 0, false)] {
            let acts = Acts { stage: index, on: &names[side], during: [&Expr::zero(), duration] };
            let towards = Direction::axis(self.axis_place(0), reversed);
            self.forces.push(acts.force(ForceKind::Pull, joint, symbol.into(), towards));
            let pull = if reversed { -Expr::from(symbol) } else { symbol.into() };
            self.acts(Influence::outside(index, &names[side], joint).by(&[&names[other]]).force(vec![pull]));
            self.impulses.push(Impulse {
                stage: index,
                on: names[side].clone(),
                by: Agent::Body(names[other].clone()),
                called: joint.to_owned(),
                components: Vec::new(),
                impulsive: false,
            });
        }
        symbol.into()
    }

    /// A force on a body: a name with a minus sign before it is the size of one that acts backwards.
    fn steady_force(&mut self, name: &str, term: &Term, path: &Path) -> Expr {
        let size = term.0.trim().strip_prefix('-').map(str::trim).filter(|size| is_bare_name(size));
        match size {
            Some(size) => {
                let meaning = format!("the backward force on {name}");
                -self.read(&Term(size.to_owned()), Dimension::FORCE, &meaning, path)
            }
            None => self.read(term, Dimension::FORCE, &format!("the force on {name}"), path),
        }
    }

    /// A body, with all that acts on it from outside.
    fn member(
        &mut self,
        index: usize,
        towed: &Towed,
        incline: &Incline,
        duration: &Expr,
        stops: bool,
        path: &Path,
    ) -> Member {
        let body = towed.body.as_str();
        let name = self.called(body);
        let mass = self.mass(body);
        let weight = mass.clone() * self.gravity();
        let acts = Acts { stage: index, on: body, during: [&Expr::zero(), duration] };
        let mut acting = Vec::new();
        if let Some(term) = &towed.force {
            let force = self.steady_force(&name, term, &path.key("force"));
            let ahead = self.first_axis();
            self.forces.push(acts.force(ForceKind::Pull, "the force", force.clone(), ahead));
            acting.push(force);
        }
        let friction = towed.friction.as_ref().map(|term| {
            let meaning = format!("the coefficient of kinetic friction of {name}");
            self.read_positive(term, Dimension::NONE, &meaning, &path.key("friction"))
        });
        if let Some(friction) = &friction {
            self.rubs_on_a_floor(incline, &path.key("friction"));
            acting.push(-Expr::product([friction.clone(), weight.clone(), incline.press.clone()]));
        }
        if !incline.is_level() {
            acting.push(-(weight.clone() * incline.rise()));
        }
        if incline.press.is_zero() {
            let down = Direction::axis(self.axis_place(0), incline.sign > 0);
            self.forces.push(acts.force(ForceKind::Weight, "weight", weight, down));
        } else {
            let meaning = format!("the normal force on {name}");
            let normal = Expr::from(self.positive(self.in_stage(QuantityKind::NormalForce, body, index), meaning));
            let sides = (normal.clone(), weight.clone() * incline.press.clone());
            self.law(&force::NORMAL_FORCE, Some(index), "nothing moves at right angles to the surface", sides);
            self.note_floor(acts, incline, weight, normal, friction.unwrap_or_else(Expr::zero), false);
        }
        if !acting.is_empty() {
            let drive = Expr::sum(acting.clone());
            self.acts(Influence::outside(index, body, "the external forces").force(vec![drive]));
            self.note_impulse(index, body, "the external forces", Vec::new());
        }
        if stops {
            self.comes_to_rest(index, body);
        }
        let ends = [index + 1, index + 2].map(|instant| self.velocities(body, instant));
        let [before, after] = ends.map(|mut components| components.pop().unwrap_or_else(Expr::zero));
        let after = if stops { Expr::zero() } else { after };
        Member { name, mass, drive: Expr::sum(acting), before, after }
    }
}
