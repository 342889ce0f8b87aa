//! Forces that depend on the position of the body they act on: what they do is found over the distance, by work and energy.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Integral;
use crate::Name;
use crate::Opposing;
use crate::Passage;
use crate::QuantityKind;
use crate::Reason;
use crate::builder::SECOND_COST;
use crate::wording;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_scene::Friction;
use momentous_scene::stage::Push;
use momentous_solve::Relation;

use super::push::Acting;
use super::push::Pushed;
use super::works;

impl Builder<'_> {
    /// The position as a variable, where some force of a push along one axis is a term in it.
    pub(super) fn varying_place(&mut self, stage: &Push) -> Option<Symbol> {
        let [(axis, _)] = self.axes[..] else { return None };
        stage
            .depends_on_place(axis.letter())
            .then(|| self.symbol(Name::of(QuantityKind::Coordinate(axis), ""), "the position"))
    }

    /// A push by forces of which some depend on the place: work and energy from one end to the other.
    pub(super) fn push_by_place(
        &mut self,
        pushed: &Pushed<'_>,
        place: Symbol,
        stage: &Push,
        friction: Option<(&Friction, Path)>,
        path: &Path,
    ) {
        self.check_by_place(pushed, place, stage, path);
        let Some((axis, _)) = self.axes.first().cloned() else { return };
        let (index, body, sign) = (pushed.index, pushed.body, Expr::integer(pushed.sign));
        let (name, mass) = (self.called(body), self.mass(body));
        let ends = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
        let moved = ends[1].clone() - ends[0].clone();
        if let Some(over) = &pushed.over {
            let way = sign.clone() * over.clone();
            self.comes_so_far((index, body), axis, way, "the forces act over this distance");
        }
        let way = pushed.over.clone().map(|over| ends[0].clone() + sign.clone() * over);
        let end = way.unwrap_or_else(|| ends[1].clone());
        let mut forces = Vec::new();
        let (mut works, mut integrals) = (Vec::new(), Vec::new());
        for force in &pushed.acting {
            let along = self.components(&force.direction).swap_remove(0);
            let along = force.strength.clone() * along;
            if along.contains(place) {
                works.push(self.work_over(index, force, &along, place, &ends));
                integrals.extend(along.definite(place, &ends[0], &ends[1]));
            } else {
                works.push(along.clone() * moved.clone());
            }
            forces.push(along);
        }
        let weight = match self.downwards(0) {
            Some(down) => Expr::integer(down) * mass.clone() * self.gravity(),
            None => self.weight_on_slope(body, &pushed.incline),
        };
        let weighs = !weight.is_zero();
        if weighs {
            works.push(weight.clone() * moved.clone());
            forces.push(weight);
        }
        let rubs = friction.is_some();
        if let Some((friction, at)) = friction {
            let along = self.sliding_friction(pushed, friction, axis, &at);
            let (normal, clear) = (along.contains(place), stage.incline.is_none() && self.downwards(0).is_some());
            if normal || clear {
                let message =
                    "`friction` beside a force that depends on the position needs a normal force that stays the same";
                let help = "let the force point along a floor, or write the friction as one of the forces";
                self.faults.push(Fault::new(Code::Value, message).help(help).at_path(at));
            }
            works.push(along.clone() * moved.clone());
            forces.push(along);
        }
        let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        let after = if pushed.stops { Expr::zero() } else { after };
        let energies = [&before, &after].map(|velocity| energy::kinetic(&mass, std::slice::from_ref(velocity)));
        let [start, stop] = energies;
        let names = pushed.acting.iter().map(|force| force.name.as_str());
        let because = works::only(names, [weighs, rubs], &name);
        let steady = forces.iter().filter(|force| !force.contains(place));
        let steady: Vec<Expr> = steady.map(|force| force.clone() * moved.clone()).collect();
        // Where steady forces act as well, the place stands in two equations, which together need not have a formula.
        if !integrals.is_empty() && !steady.is_empty() && pushed.over.is_none() {
            let works: Vec<Expr> = integrals.into_iter().chain(steady).collect();
            let sides = energy::work_energy(start.clone(), works, stop.clone());
            self.law_at(SECOND_COST, &energy::WORK_ENERGY, Some(index), because.clone(), sides);
        }
        self.law(&energy::WORK_ENERGY, Some(index), because, energy::work_energy(start.clone(), works, stop));
        let opposing = rubs.then_some(Opposing::Friction);
        self.moves_along(index, body, [&(sign.clone() * before), &(sign.clone() * after)], opposing);
        if pushed.over.is_none() {
            let reason = Reason::MovesBack(name.clone()).against(opposing);
            self.require(sign * (ends[1].clone() - ends[0].clone()), Relation::AtLeast, Expr::zero(), reason);
        }
        let net = Expr::sum(forces).simplify();
        self.passages.extend(passage(&net, place, [&ends[0], &end], &start, Reason::TurnsBack(name.clone())));
        let nets = ends.each_ref().map(|end| net.substitute(&|symbol| (symbol == place).then(|| end.clone())));
        self.rates_along(pushed, axis, nets);
        let lasts = pushed.end.clone() - pushed.start.clone();
        let impulse = self.impulse_of_all(index, body, axis, &lasts);
        let force = Influence::outside(index, body, "the net force").force(vec![net]);
        self.acts(force.works(Effect::Open, "the forces do work along the way"));
        self.note_impulse_of_all(index, body, vec![impulse]);
        if self.downwards(0).is_none() && !rubs {
            self.neglect("other resistance", "the problem gives none");
        }
    }

    /// The work of one force, as a quantity with its integral.
    fn work_over(
        &mut self,
        index: usize,
        force: &Acting,
        along: &Expr,
        place: Symbol,
        [low, high]: &[Expr; 2],
    ) -> Expr {
        let of_force = Name::of(QuantityKind::Work, "F");
        let is_alike = |name: &&Name| name.kind == of_force.kind && name.subject == of_force.subject;
        let count = self.names.iter().filter(is_alike).count();
        let name = if count == 0 { of_force } else { of_force.at(count + 1) };
        let meaning = format!("the work of {}", force.name);
        let symbol = self.symbol(name.during(self.stage_label(index)), meaning);
        let Some(value) = along.definite(place, low, high) else {
            let message = format!("{} cannot be integrated over the position", wording::force_of(&force.name));
            let help = "use polynomials, sines, exponentials and powers of linear terms";
            let path = Path::root().key("scene").key("stages").index(index);
            self.faults.push(Fault::new(Code::Stuck, message).help(help).at_path(path));
            return symbol.into();
        };
        let (low, high) = (low.clone(), high.clone());
        let integral = Integral { integrand: along.clone(), variable: place, low, high };
        let because = format!("{} depends on the position", wording::force_of(&force.name));
        self.integral(&energy::WORK, index, because, (symbol.into(), value.simplify()), integral);
        symbol.into()
    }

    /// The quantities that cannot be known, or are not known yet, where a force depends on the place.
    fn check_by_place(&mut self, pushed: &Pushed<'_>, place: Symbol, stage: &Push, path: &Path) {
        let letter = self.symbols.entry(place).name.clone();
        let mut fault = |message: &str, help: String, path: Path| {
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path));
        };
        if pushed.acting.iter().any(|force| force.strength.contains(pushed.clock)) {
            let message = "a stage cannot have forces that depend on time beside forces that depend on position";
            fault(message, format!("write all of them in `t` or in `{letter}`"), path.key("forces"));
        }
        if stage.during.is_some() {
            let message = "the time does not follow in general where a force depends on the position";
            fault(message, "remove `during`; say how far the body moves: `over: d`".into(), path.key("during"));
        }
        if stage.resistance.is_some() {
            let message = "a `resistance` cannot act beside a force that depends on the position";
            fault(message, "leave one of the two, or divide the motion into stages".into(), path.key("resistance"));
        }
    }
}

/// The way through which a net force acts; none where the force has no integral, which is a fault already.
fn passage(net: &Expr, place: Symbol, [start, end]: [&Expr; 2], kinetic: &Expr, reason: Reason) -> Option<Passage> {
    let work = net.definite(place, start, &place.into())?;
    Some(Passage { place, ends: [start.clone(), end.clone()], kinetic: kinetic.clone() + work, reason, way: None })
}
