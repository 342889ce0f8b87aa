//! Where a body that static friction may hold is in the end, and the net force on it at both ends, for each way in which it can go.

use crate::Builder;
use crate::builder::LAW_COST;
use momentous_expr::Expr;
use momentous_laws::kinematics;
use momentous_laws::motion;
use momentous_scene::Axis;
use momentous_solve::Equation;

use super::push::Pushed;

/// How a body moves on its floor while a push acts: all counted along its axis.
pub(crate) struct Sliding<'a> {
    /// The net force while it slides.
    pub net: Expr,
    /// Its velocities at both ends.
    pub ends: [&'a Expr; 2],
    /// The time from which on it slides; none where it stays at rest.
    pub from: Option<&'a Expr>,
}

impl Builder<'_> {
    /// The place in the end, and the net force at both ends, in one way.
    pub(crate) fn moves_in_this_way(
        &mut self,
        pushed: &Pushed<'_>,
        axis: Axis,
        sliding: &Sliding<'_>,
    ) -> Vec<Equation> {
        let at = |time: &Expr| sliding.net.substitute(&|symbol| (symbol == pushed.clock).then(|| time.clone()));
        let [first, last] = match sliding.from {
            None => [Expr::zero(), Expr::zero()],
            Some(from) if *from == pushed.start => [at(&pushed.start), at(&pushed.end)],
            Some(_) => [Expr::zero(), at(&pushed.end)],
        };
        let mut equations = self.net_forces_in_this_way(pushed, axis, [first, last]);
        equations.extend(self.displaced_in_this_way(pushed, axis, sliding));
        equations
    }

    /// The net force at both ends, which is zero while static friction balances the push.
    fn net_forces_in_this_way(&mut self, pushed: &Pushed<'_>, axis: Axis, forces: [Expr; 2]) -> Vec<Equation> {
        let (index, body) = (pushed.index, pushed.body);
        let name = self.called(body);
        let first = usize::from(self.scene.follows_a_force(index, body));
        let mut equations = Vec::new();
        for (instant, there) in (index + 1..).zip(forces).skip(first) {
            let [force, _] = self.net_force_and_acceleration(body, instant, axis);
            let because = if there.is_zero() {
                format!("static friction balances the other forces on {name}")
            } else {
                format!("these are all the forces on {name} while it slides")
            };
            equations.push(self.stated(LAW_COST, &motion::ALL_FORCES, Some(index), because, (force, there), None));
        }
        equations
    }

    fn displaced_in_this_way(&mut self, pushed: &Pushed<'_>, axis: Axis, sliding: &Sliding<'_>) -> Option<Equation> {
        let (index, body) = (pushed.index, pushed.body);
        let name = self.called(body);
        let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
        let Some(begins) = sliding.from else {
            let because = format!("{name} stays at rest");
            return Some(self.stated(LAW_COST, &kinematics::DISPLACED, Some(index), because, (to, from), None));
        };
        let [before, after] = sliding.ends;
        if !sliding.net.contains(pushed.clock) {
            let because = format!("the forces on {name} do not change while it slides, so the velocity changes evenly");
            let time = pushed.end.clone() - begins.clone();
            let sides = kinematics::mean_velocity([&from, &to], [before, after], &time);
            return Some(self.stated(LAW_COST, &kinematics::MEAN_VELOCITY, Some(index), because, sides, None));
        }
        let gained = sliding.net.definite(pushed.clock, begins, &pushed.clock.into())?;
        let velocity = before.clone() + gained.simplify() / self.mass(body);
        let (because, gone, integral) = self.displaced_by(pushed, velocity, begins)?;
        Some(self.stated(LAW_COST, &motion::DISPLACEMENT, Some(index), because, (to - from, gone), Some(integral)))
    }

    /// Newton's second law at both ends, which holds in every way.
    pub(crate) fn accelerated_at_both_ends(&mut self, pushed: &Pushed<'_>, axis: Axis) {
        let mass = self.mass(pushed.body);
        let first = usize::from(self.scene.follows_a_force(pushed.index, pushed.body));
        for instant in [pushed.index + 1, pushed.index + 2].into_iter().skip(first) {
            let [force, acceleration] = self.net_force_and_acceleration(pushed.body, instant, axis);
            self.net_force_accelerates(pushed, &mass, [&force, &acceleration]);
        }
    }
}
