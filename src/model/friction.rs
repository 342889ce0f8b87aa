//! A push against dry friction on a level floor: the normal force, the threshold, and whether the body moves at all.

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::laws::force;
use crate::laws::momentum;
use crate::quantity::Dimension;
use crate::scene::Friction;
use crate::scene::stage::Push;
use crate::solve::Relation;

use super::Agent;
use super::Builder;
use super::Impulse;
use super::Integral;
use super::Warning;
use super::acting::Acts;
use super::builder::Alternative;
use super::builder::LAW_COST;
use super::stage::Acting;

impl Builder<'_> {
    /// A body on a level floor, along one axis: slides against kinetic friction once the push exceeds the static threshold.
    #[allow(clippy::too_many_arguments, reason = "what a push has read of itself")]
    pub(super) fn push_against_friction(
        &mut self,
        index: usize,
        stage: &Push,
        friction: &Friction,
        path: &Path,
        acting: &[Acting],
        clock: Symbol,
        [start, end]: [&Expr; 2],
    ) {
        let body = stage.body.as_str();
        let name = self.called(body);
        let [(axis, _)] = self.axes[..] else {
            let fault = Fault::new(Code::Value, "friction needs a scene with one axis, along the floor");
            self.faults.push(fault.help("leave one axis, such as `axes: { x: to the right }`").at_path(path.clone()));
            return;
        };
        let kinetic =
            self.read(&friction.kinetic, Dimension::NONE, "the coefficient of kinetic friction", &path.key("kinetic"));
        let gravity = self.gravity();
        let weight = self.mass(body) * gravity;
        let along =
            Expr::sum(acting.iter().map(|force| force.strength.clone() * force.direction.cosine_and_sine()[0].clone()));
        let lift =
            Expr::sum(acting.iter().map(|force| force.strength.clone() * force.direction.cosine_and_sine()[1].clone()));
        let suffix = self.stage_suffix(index);
        let normal = weight.clone() - lift;
        let normal = if normal.contains(clock) {
            normal
        } else {
            let symbol = Expr::from(self.positive(
                format!("N_{body}{suffix}"),
                Dimension::FORCE,
                format!("the normal force on {name}"),
            ));
            self.law(
                &force::NORMAL_FORCE,
                Some(index),
                "the floor carries what presses on it",
                (symbol.clone(), normal),
            );
            symbol
        };
        let net = along.clone() - kinetic.clone() * normal.clone();
        let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        self.impulses.push(Impulse {
            stage: index,
            on: body.to_owned(),
            by: Agent::Outside,
            called: acting.first().map_or_else(|| "friction".into(), |force| force.name.clone()),
            components: Vec::new(),
            impulsive: false,
        });
        self.omit("air resistance", "the problem does not mention any");
        let begins = friction.at_rest.as_ref().map(|_| self.begins(index, &name));
        let acts = Acts { stage: index, on: body, during: [begins.as_ref().unwrap_or(start), end] };
        for force in acting {
            self.note_pull(acts, &force.name, &force.strength, &force.direction);
        }
        self.note_floor(acts, weight, normal.clone(), kinetic);
        match &friction.at_rest {
            Some(term) => {
                let threshold =
                    self.read(term, Dimension::NONE, "the coefficient of static friction", &path.key("static"));
                self.start_from_rest(index, body, [&along, &(threshold * normal)], &net, clock, [start, end], &after);
            }
            None => {
                self.sliding(index, body, &net, clock, [start, end], [&before, &after]);
            }
        }
    }

    /// A body that slides all the time, in the positive direction.
    #[allow(clippy::too_many_arguments, reason = "the state at both ends of the stage")]
    fn sliding(
        &mut self,
        index: usize,
        body: &str,
        net: &Expr,
        clock: Symbol,
        [start, end]: [&Expr; 2],
        [before, after]: [&Expr; 2],
    ) {
        let name = self.called(body);
        let mass = self.mass(body);
        let because = format!("{name} slides all the time, and friction acts against its motion");
        let Some(impulse) = self.net_impulse(net, clock, start, end) else { return };
        let sides = momentum::impulse_momentum(&mass, before, &[impulse], after);
        self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
        let reason = format!("{name} would stop and friction would turn round before the end");
        self.require(Warning::Reverses, after.clone(), Relation::AtLeast, Expr::zero(), reason);
        let reason = format!("{name} would have to slide forwards for friction to act backwards");
        self.require(Warning::Reverses, before.clone(), Relation::AtLeast, Expr::zero(), reason);
    }

    /// A body that starts from rest: it slides at once, from the time at which the push reaches the threshold, or not at all.
    #[allow(clippy::too_many_arguments, reason = "the two forces, and the stage's two ends")]
    fn start_from_rest(
        &mut self,
        index: usize,
        body: &str,
        [along, threshold]: [&Expr; 2],
        net: &Expr,
        clock: Symbol,
        [start, end]: [&Expr; 2],
        after: &Expr,
    ) {
        let name = self.called(body);
        let mass = self.mass(body);
        let suffix = self.stage_suffix(index);
        let begins = self.begins(index, &name);
        let at = |expr: &Expr, time: &Expr| expr.substitute(&|symbol| (symbol == clock).then(|| time.clone()));
        let Some(value) = self.net_impulse(net, clock, &begins, end) else { return };
        let gained = Expr::from(self.symbol(
            format!("I_net{suffix}"),
            Dimension::MOMENTUM,
            format!("the impulse on {name} while it slides"),
        ));
        let integral = Integral { integrand: net.clone(), variable: clock, low: begins.clone(), high: end.clone() };

        let alternative = |what: String| Alternative { what, ..Alternative::default() };
        let mut at_once = alternative(format!("{name} starts to slide at once"));
        let mut moves = alternative(format!("{name} starts to slide"));
        let mut stays = alternative(format!("{name} stays at rest"));

        let because = "the push exceeds the greatest static friction from the beginning";
        let sides = (begins.clone(), start.clone());
        at_once.equations.push(self.stated(LAW_COST, &force::THRESHOLD, Some(index), because.to_owned(), sides, None));
        let because = format!("{name} is at rest until the push reaches the greatest static friction");
        let sides = (at(along, &begins), at(threshold, &begins));
        moves.equations.push(self.stated(LAW_COST, &force::THRESHOLD, Some(index), because, sides, None));
        for (sliding, since) in [(&mut at_once, ""), (&mut moves, "from then on ")] {
            let because = format!("{since}the impulse is that of the push less kinetic friction");
            let sides = (gained.clone(), value.clone());
            let integral = Some(integral.clone());
            sliding.equations.push(self.stated(LAW_COST, &force::IMPULSE, Some(index), because, sides, integral));
            let because = format!("{name} starts from rest");
            let sides = (gained.clone(), mass.clone() * after.clone());
            sliding.equations.push(self.stated(
                LAW_COST,
                &momentum::IMPULSE_MOMENTUM,
                Some(index),
                because,
                sides,
                None,
            ));
        }
        let weak = "the push does not exceed static friction when it begins";
        at_once.conditions.push(self.condition(at(along, start), Relation::Greater, at(threshold, start), weak));
        let early = "the push would exceed static friction before it began";
        moves.conditions.push(self.condition(begins.clone(), Relation::AtLeast, start.clone(), early));
        let at_first = "the push exceeds static friction from the beginning";
        moves.conditions.push(self.condition(at(along, start), Relation::AtMost, at(threshold, start), at_first));
        let late = format!("the push never exceeds static friction, so that {name} stays at rest");
        moves.conditions.push(self.condition(begins, Relation::Less, end.clone(), late));

        let because = format!("the push stays below the greatest static friction, and {name} does not move");
        let sides = (after.clone(), Expr::zero());
        stays.equations.push(self.stated(LAW_COST, &force::THRESHOLD, Some(index), because, sides, None));
        let reason = format!("the push exceeds static friction, so that {name} does not stay at rest");
        stays.conditions.push(self.condition(at(along, end), Relation::AtMost, at(threshold, end), reason));
        let reason = format!("the push exceeds static friction backwards, so that {name} does not stay at rest");
        stays.conditions.push(self.condition(at(along, end), Relation::AtLeast, -at(threshold, end), reason));
        self.choices.push(vec![moves, at_once, stays]);
    }

    /// The time at which a body at rest starts to slide.
    fn begins(&mut self, index: usize, name: &str) -> Expr {
        let symbol = format!("t_start{}", self.stage_suffix(index));
        self.symbol(symbol, Dimension::TIME, format!("the time at which {name} starts to slide")).into()
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
