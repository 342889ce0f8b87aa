//! A body that something resists beside forces that stay the same.

use crate::Builder;
use crate::Influence;
use crate::Opposing;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_scene::Axis;
use momentous_scene::Friction;
use momentous_scene::stage::Push;
use momentous_scene::stage::Resistance;

use super::push::Pushed;
use super::resisted::Resisted;

impl Builder<'_> {
    /// A push against a resistance: along each axis the velocity as a function of time, and the impulse.
    pub(super) fn push_against_resistance(
        &mut self,
        pushed: &Pushed<'_>,
        resistance: &Resistance,
        stage: &Push,
        friction: Option<(&Friction, Path)>,
        path: &Path,
    ) {
        self.check_resisted(pushed, stage, path);
        self.check_over(pushed, path);
        let at = path.key("resistance");
        let coefficient = match resistance {
            Resistance::Linear(term) => self.linear_resistance(term, &at),
            Resistance::Quadratic(term) => self.quadratic_resistance(term, &at),
        };
        let index = pushed.index;
        let lasts = (pushed.end.clone() - pushed.start.clone()).simplify();
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let mut impulses = Vec::new();
        let rubs = friction.is_some();
        let friction = friction.and_then(|(friction, at)| self.friction_beside(pushed, friction, &at));
        for (position, axis) in axes.into_iter().enumerate() {
            let steady = (self.steady_along(pushed, position) + friction.clone().unwrap_or_else(Expr::zero)).simplify();
            match resistance {
                Resistance::Linear(_) => self.linearly_resisted(pushed, axis, steady, &coefficient),
                Resistance::Quadratic(_) => {
                    self.quadratically_resisted(pushed, axis, &steady, [&coefficient, &lasts], path);
                }
            }
            impulses.push(self.impulse_of_all(index, pushed.body, axis, &lasts));
        }
        if stage.incline.is_some() && !rubs {
            self.neglect("friction", "the slope is smooth");
        } else if !rubs {
            self.leave_out_what_acts_across();
        }
        self.acts(Influence::outside(index, pushed.body, "the net force"));
        self.note_impulse_of_all(index, pushed.body, impulses);
    }

    /// The friction on a body that slides one way all the time, as a force along the axis.
    fn friction_beside(&mut self, pushed: &Pushed<'_>, friction: &Friction, path: &Path) -> Option<Expr> {
        let [(axis, _)] = self.axes[..] else {
            let fault = Fault::new(Code::Value, "friction needs a scene with one axis, along the floor");
            self.faults.push(fault.help("leave one axis, such as `axes: { x: to the right }`").at_path(path.clone()));
            return None;
        };
        self.rubs_on_a_floor(&pushed.incline, path);
        let ends = [pushed.index + 1, pushed.index + 2];
        let [before, after] =
            ends.map(|instant| Expr::integer(pushed.sign) * self.velocity(pushed.body, instant, axis));
        self.moves_along(pushed.index, pushed.body, [&before, &after], Some(Opposing::Friction));
        Some(self.sliding_friction(pushed, friction, axis, path))
    }

    /// The forces along the axis of that position beside the resistance.
    fn steady_along(&mut self, pushed: &Pushed<'_>, position: usize) -> Expr {
        let mut forces = Vec::new();
        for force in &pushed.acting {
            forces.push(force.strength.clone() * self.components(&force.direction).swap_remove(position));
        }
        forces.push(match self.downwards(position) {
            Some(down) => Expr::integer(down) * self.mass(pushed.body) * self.gravity(),
            None => self.weight_on_slope(pushed.body, &pushed.incline),
        });
        Expr::sum(forces).simplify()
    }

    /// Adds the equations of a push against a resistance in proportion to the speed along one axis.
    fn linearly_resisted(&mut self, pushed: &Pushed<'_>, axis: Axis, steady: Expr, resists: &Expr) {
        let (index, body) = (pushed.index, pushed.body);
        let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
        let mut moved = to.clone() - from.clone();
        if let Some(over) = &pushed.over {
            moved = Expr::integer(pushed.sign) * over.clone();
            self.comes_so_far((index, body), axis, moved.clone(), "the forces act over this distance");
            let [before, after] = [&before, &after].map(|velocity| Expr::integer(pushed.sign) * velocity.clone());
            self.moves_along(index, body, [&before, &after], None);
        }
        let nets = [&before, &after].map(|velocity| steady.clone() - resists.clone() * velocity.clone());
        self.rates_along(pushed, axis, nets);
        let after = if pushed.stops { Expr::zero() } else { after };
        let (clock, during) = (pushed.clock, [&pushed.start, &pushed.end]);
        self.resisted(&Resisted { index, body, axis, steady, resists, clock, during, moved, after });
    }

    /// Refuses quantities that have no formula beside a resistance.
    fn check_resisted(&mut self, pushed: &Pushed<'_>, stage: &Push, path: &Path) {
        if stage.is_of_several() {
            let fault = Fault::new(Code::Value, "a `resistance` in a push needs a single body");
            let help = "write `body: A`, and a push of its own for each body";
            self.faults.push(fault.help(help).at_path(path.key("resistance")));
        }
        if pushed.acting.iter().any(|force| force.strength.contains(pushed.clock)) {
            let message =
                "beside a `resistance` forces must not change with time: there is no formula for the motion in general";
            let help = "write forces that stay the same, in several stages where they change in steps";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("forces")));
        }
    }
}
