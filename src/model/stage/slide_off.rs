//! A body that slides down another which gives way: momentum along the guide, energy, and where it leaves.

use crate::Agent;
use crate::Builder;
use crate::Effect;
use crate::Impulse;
use crate::Influence;
use crate::Reason;
use crate::Work;
use crate::guide::dot;
use crate::guide::projected;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::momentum;
use momentous_laws::separation;
use momentous_quantity::Dimension;
use momentous_scene::stage::SlideOff;
use momentous_solve::Relation;

impl Builder<'_> {
    pub(crate) fn slide_off(&mut self, index: usize, stage: &SlideOff, path: &Path) {
        let (body, on) = (stage.body.as_str(), stage.on.as_str());
        let [name, other] = [body, on].map(|body| self.called(body));
        let Some(guide) = self.guided(on) else {
            let fault = Fault::new(Code::MissingKey, format!("`{on}` needs a guide along which it can move"));
            let help = "write `guide: { along: x, by: the floor }` for the body, in a scene with two axes";
            self.faults.push(fault.help(help).at_path(path.key("on")));
            return;
        };
        let along = self.components(&guide.along);
        let sinks = |(position, part): (usize, &Expr)| !part.is_zero() && self.downwards(position).is_some();
        if along.iter().enumerate().any(sinks) {
            let fault = Fault::new(Code::Value, format!("{other} would sink along {} by its own weight", guide.by));
            let help = "let its guide be level, such as `guide: { along: x, by: the floor }`";
            self.faults.push(fault.help(help).at_path(path.key("on")));
            return;
        }
        let after = index + 2;
        self.hold(&guide, after, None);
        for body in [body, on] {
            self.starts_from_rest(index, body);
        }
        let mut end = self.carrying(&[body, on], after);
        if guide.along.turn.is_zero() {
            // A guide along an axis leaves the one component; the other is zero, and need not be carried along.
            for (velocity, part) in end[1].1.iter_mut().zip(&along).filter(|(_, part)| part.is_zero()) {
                *velocity = part.clone();
            }
        }
        let because = format!(
            "both start from rest, and along the path of {} neither weight nor {} exerts an impulse on them",
            self.called(on),
            guide.by
        );
        let sides = (momentum::total(&projected(&end, &along)), Expr::zero());
        self.law(&momentum::CONSERVATION, Some(index), because, sides);

        let meaning = format!("the height through which {name} sinks");
        let height = self.read_positive(&stage.height, Dimension::LENGTH, &meaning, &path.key("height"));
        let work = Expr::product([self.mass(body), self.gravity(), height]);
        let energies: Vec<Expr> = end.iter().map(|(mass, velocity)| energy::kinetic(mass, velocity)).collect();
        let because = format!("there is no friction, and {} does no work because {other} moves along it", guide.by);
        self.law(&separation::DESCENT, Some(index), because, separation::energy(&work, &[], &energies));

        let leaves = self.direction(&stage.direction, &path.key("direction"));
        let [cos, sin] = leaves.cosine_and_sine();
        let relative: Vec<Expr> = end[0].1.iter().zip(&end[1].1).map(|(one, other)| difference(one, other)).collect();
        let across = dot(&relative, &[-sin.clone(), cos.clone()]);
        let because = format!("relative to {other}, {name} moves along its face at the end");
        self.law(&separation::ALONG_FACE, Some(index), because, (across, Expr::zero()));
        let reason = Reason::SlidesUp(name.clone(), other.clone());
        self.require(dot(&relative, &[cos, sin]), Relation::AtLeast, Expr::zero(), reason);
        let weights = self.weight_and_guide(index, stage, &guide.by, &along);
        for influence in weights {
            self.acts(influence);
        }
        self.act_on_each_other(index, [body, on], [&other, &name]);
        self.neglect(format!("friction between {name} and {other}"), "they are smooth");
        self.not_needed(
            format!("the force between {name} and {other}"),
            "its impulses cancel within the system, and so does its work",
        );
    }
}

impl Builder<'_> {
    /// Two bodies that act on each other, each by what is called so.
    pub(super) fn act_on_each_other(&mut self, index: usize, [body, on]: [&str; 2], called: [&str; 2]) {
        for ((one, another), called) in [(body, on), (on, body)].into_iter().zip(called) {
            let between = Influence::outside(index, one, called).by(&[another]);
            self.acts(Influence { work: Work::OfForce, ..between });
            self.impulses.push(Impulse {
                stage: index,
                on: one.to_owned(),
                by: Agent::Body(another.to_owned()),
                called: called.to_owned(),
                components: Vec::new(),
                impulsive: false,
            });
        }
    }

    /// The influences from outside on a body and on the one that it slides down: weight, and the guide at right angles to its
    /// way.
    fn weight_and_guide(&mut self, index: usize, stage: &SlideOff, by: &str, along: &[Expr]) -> Vec<Influence> {
        let weight = self.weight_on(index, &stage.body);
        let held =
            along.iter().map(|part| if part.is_one() { Effect::Of(Expr::zero()) } else { Effect::Open }).collect();
        let guide = Influence::outside(index, &stage.on, by).workless();
        vec![weight, Influence { force: held, ..guide }]
    }
}

/// One velocity less another, where that is not zero as it is written.
fn difference(one: &Expr, other: &Expr) -> Expr {
    if other.is_zero() { one.clone() } else { one.clone() - other.clone() }
}
