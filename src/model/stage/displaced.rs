//! Where a body is after a stage that takes it along an axis.

use crate::Because;
use crate::Builder;
use crate::builder::LAW_COST;
use momentous_expr::Expr;
use momentous_laws::kinematics;
use momentous_scene::Axis;

impl Builder<'_> {
    /// Its velocity, with these values at both ends, changes evenly all the time: the mean of them tells how far it comes.
    pub(super) fn moves_evenly(
        &mut self,
        (index, body): (usize, &str),
        axis: Axis,
        [before, after]: [&Expr; 2],
        time: &Expr,
    ) {
        let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
        let because = format!("the forces on {} do not change, so the velocity changes evenly", self.called(body));
        let sides = kinematics::mean_velocity([&from, &to], [before, after], time);
        self.law(&kinematics::MEAN_VELOCITY, Some(index), because, sides);
    }

    /// It comes so far along an axis.
    pub(super) fn comes_so_far(
        &mut self,
        (index, body): (usize, &str),
        axis: Axis,
        way: Expr,
        because: impl Into<Because>,
    ) {
        let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
        self.law(&kinematics::DISPLACED, Some(index), because, (to, from + way));
    }

    /// A distance by the mean velocity, where forces that do not change act on a body all the way. Impulse and momentum say the same
    /// of the time, unless the forces balance.
    pub(super) fn comes_evenly(&mut self, index: usize, name: &str, distance: &Expr, ends: [&Expr; 2], time: &Expr) {
        let because = format!("the forces on {name} do not change, so the velocity changes evenly, if at all");
        let sides = kinematics::mean_velocity([&Expr::zero(), distance], ends, time);
        let equation = self.stated(LAW_COST, &kinematics::MEAN_VELOCITY, Some(index), because, sides, None);
        self.distances.push(equation);
    }

    /// The axis of a scene that has one.
    pub(super) fn only_axis(&self) -> Option<Axis> {
        if let [(axis, _)] = self.axes[..] { Some(axis) } else { None }
    }
}
