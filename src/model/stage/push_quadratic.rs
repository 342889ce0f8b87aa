//! A body that something resists in proportion to the square of its speed, along a line, beside forces that stay the same.

use crate::Alternative;
use crate::Because;
use crate::Builder;
use crate::Opposing;
use crate::QuantityKind;
use crate::Reason;
use crate::builder::LAW_COST;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::resistance;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Term;
use momentous_solve::Equation;
use momentous_solve::Relation;

use super::push::Pushed;

/// Resistance by the square of the speed.
const QUADRATIC: Dimension = Dimension::new(1, -1, 0);

/// A motion along a line, with what is counted in its direction.
struct Counted<'a> {
    index: usize,
    name: String,
    mass: Expr,
    resists: &'a Expr,
    lasts: &'a Expr,
    /// The forces besides the resistance.
    others: Expr,
    speeds: [Expr; 2],
}

impl Builder<'_> {
    /// Reads a resistance divided by the square of the speed.
    pub(super) fn quadratic_resistance(&mut self, term: &Term, path: &Path) -> Expr {
        let path = path.key("quadratic");
        if self.axes.len() != 1 {
            let message = "a resistance in proportion to the square of the speed needs one axis";
            let help = "there is no formula for its motion in a plane: leave one axis, or take a `linear` resistance";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.clone()));
        }
        self.read_positive(term, QUADRATIC, "the resistance divided by the square of the speed", &path)
    }

    /// Adds the equations of a push against such a resistance along the one axis.
    pub(super) fn quadratically_resisted(
        &mut self,
        pushed: &Pushed<'_>,
        axis: Axis,
        steady: &Expr,
        [resists, lasts]: [&Expr; 2],
        path: &Path,
    ) {
        let (index, body, sign) = (pushed.index, pushed.body, Expr::integer(pushed.sign));
        let (name, mass) = (self.called(body), self.mass(body));
        let velocities = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
        let drag = |velocity: &Expr| sign.clone() * resists.clone() * velocity.clone().powi(2);
        self.rates_along(pushed, axis, velocities.each_ref().map(|velocity| steady.clone() - drag(velocity)));
        let [before, after] = velocities.map(|velocity| sign.clone() * velocity);
        let after = if pushed.stops { Expr::zero() } else { after };
        let others = (sign.clone() * steady.clone()).simplify();
        if pushed.stops && others.is_zero() {
            let message =
                format!("{name} does not come to rest where nothing acts but a resistance that fades with the speed");
            let help = "say what the speed is at the end, or how long or how far the motion is followed";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("until")));
            return;
        }
        self.moves_along(index, body, [&before, &after], Some(Opposing::Resistance));
        let way = if let Some(over) = &pushed.over {
            self.comes_so_far((index, body), axis, sign * over.clone(), "the forces act over this distance");
            over.clone()
        } else {
            let way = sign * (to - from);
            let reason = Reason::MovesBack(name.clone()).against(Some(Opposing::Resistance));
            self.require(way.clone(), Relation::AtLeast, Expr::zero(), reason);
            way
        };
        let because = format!("the resistance grows with the square of the speed of {name}");
        let sides = resistance::quadratic_way(&others, [&mass, resists, &way], [&before, &after]);
        self.law(&resistance::QUADRATIC_WAY, Some(index), because, sides);
        let drag = |speed: &Expr| resists.clone() * speed.clone().powi(2);
        self.shows_separated(way, [&before, &after], &|speed| {
            mass.clone() * speed.clone() / (others.clone() - drag(speed))
        });
        let counted = Counted { index, name, mass, resists, lasts, others, speeds: [before, after] };
        self.quadratic_times(&counted);
    }

    /// How the speed changes with time, by what the other forces do.
    fn quadratic_times(&mut self, motion: &Counted<'_>) {
        let because = format!("nothing acts on {} along its motion but the resistance", motion.name);
        if motion.others.is_zero() {
            let [before, after] = &motion.speeds;
            let sides = resistance::quadratic_alone([&motion.mass, motion.resists, motion.lasts], [before, after]);
            self.law(&resistance::QUADRATIC_TIME, Some(motion.index), because, sides);
            return self.shows_time(motion);
        }
        let (driven, held) = (self.driven(motion), self.held_back(motion));
        match self.sign_of(&motion.others) {
            Some(sign) => {
                let way = if sign > 0 { driven } else { held };
                self.system.equations.extend(way.equations);
                self.system.conditions.extend(way.conditions);
            }
            None => self.choices.push(vec![driven, held]),
        }
    }

    /// Shows the time as the integral of m dv/(F - k v^2).
    fn shows_time(&mut self, motion: &Counted<'_>) {
        let [before, after] = &motion.speeds;
        let net = |speed: &Expr| motion.others.clone() - motion.resists.clone() * speed.clone().powi(2);
        self.shows_separated(motion.lasts.clone(), [before, after], &|speed| motion.mass.clone() / net(speed));
    }

    /// The other forces drive the body on.
    fn driven(&mut self, motion: &Counted<'_>) -> Alternative {
        let (even, balance) = self.even(motion, motion.others.clone());
        let meaning = "the ratio of w - v to w + v at the end";
        let ratio = Expr::from(self.symbol(self.in_stage(QuantityKind::SpeedRatio, "", motion.index), meaning));
        let [before, after] = &motion.speeds;
        let values = [&motion.mass, motion.resists, motion.lasts];
        let [shrunk, gives] = resistance::quadratic_driven(&even, &ratio, values, [before, after]);
        let because = format!("the other forces drive {} on", motion.name);
        let index = Some(motion.index);
        let shrunk = self.stated(LAW_COST, &resistance::QUADRATIC_TIME, index, because, shrunk, None);
        self.shows_time(motion);
        let gives = self.stated(LAW_COST, &resistance::SPEED_RATIO, index, Because::Definition, gives, None);
        let reason = Reason::HeldBack(motion.name.clone());
        Alternative {
            what: format!("the forces drive {} on", motion.name),
            equations: vec![balance, shrunk, gives],
            conditions: vec![self.condition(motion.others.clone(), Relation::Greater, Expr::zero(), reason)],
            still: None,
        }
    }

    /// The other forces hold the body back.
    fn held_back(&mut self, motion: &Counted<'_>) -> Alternative {
        let (even, balance) = self.even(motion, (-motion.others.clone()).simplify());
        let [before, after] = &motion.speeds;
        let angle = |speed: &Expr| if speed.is_zero() { Expr::zero() } else { speed.clone().atan2(even.clone()) };
        let turned = resistance::turned(&even, [&motion.mass, motion.resists, motion.lasts]);
        let because = format!("the other forces hold {} back", motion.name);
        let sides = (angle(after), angle(before) - turned.clone());
        let slows = self.stated(LAW_COST, &resistance::QUADRATIC_TIME, Some(motion.index), because, sides, None);
        self.shows_time(motion);
        let reason = Reason::DrivenOn(motion.name.clone());
        let held = self.condition(motion.others.clone(), Relation::Less, Expr::zero(), reason);
        // Past rest the tangent would begin anew.
        let reason = Reason::MovesBack(motion.name.clone()).against(Some(Opposing::Resistance));
        let moves = self.condition(angle(before), Relation::AtLeast, turned, reason);
        let mut conditions = vec![held];
        conditions.extend((!after.is_zero()).then_some(moves));
        Alternative {
            what: format!("the forces hold {} back", motion.name),
            equations: vec![balance, slows],
            conditions,
            still: None,
        }
    }

    /// The speed at which the resistance is as large as the other forces.
    fn even(&mut self, motion: &Counted<'_>, size: Expr) -> (Expr, Equation) {
        let meaning = "the speed at which the resistance is as large as the other forces";
        let even = Expr::from(self.positive(self.in_stage(QuantityKind::TerminalSpeed, "", motion.index), meaning));
        let because = format!("at the speed w the resistance is as large as the other forces on {}", motion.name);
        let sides = (motion.resists.clone() * even.clone().powi(2), size);
        (even, self.stated(LAW_COST, &resistance::EVEN, Some(motion.index), because, sides, None))
    }

    /// Whether a sum of products of positive quantities is positive (1) or negative (-1); none where that depends on the values.
    pub(crate) fn sign_of(&self, sum: &Expr) -> Option<i64> {
        let terms = if let Expr::Sum(terms) = sum { terms.to_vec() } else { vec![sum.clone()] };
        let sign = |term: &Expr| {
            let sure = term.all_symbols(&|symbol| self.system.positive.contains(&symbol)) && is_product(term);
            sure.then(|| if term.begins_with_minus() { -1 } else { 1 })
        };
        let first = sign(terms.first()?)?;
        terms.iter().all(|term| sign(term) == Some(first)).then_some(first)
    }
}

/// Whether a term is a product of numbers and powers of symbols.
fn is_product(term: &Expr) -> bool {
    match term {
        Expr::Number(_) | Expr::Pi | Expr::Symbol(_) => true,
        Expr::Product(factors) => factors.iter().all(is_product),
        Expr::Power(pair) => matches!(pair.0, Expr::Symbol(_)) && matches!(pair.1, Expr::Number(_)),
        Expr::Sum(_) | Expr::Apply(..) | Expr::Piecewise(_) => false,
    }
}
