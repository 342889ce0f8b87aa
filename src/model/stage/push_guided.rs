//! A push of a body that a guide holds: impulse and momentum along its guide.

use crate::Builder;
use crate::guide::Guided;
use momentous_expr::Expr;
use momentous_laws::kinematics;

use super::push::Pushed;
use super::push::times;

impl Builder<'_> {
    /// Impulse and momentum of a guided body, with the acceleration where the guide lies along an axis.
    pub(super) fn push_along_guide(
        &mut self,
        pushed: &Pushed<'_>,
        guide: &Guided,
        impulses: &[Expr],
        parts: &[Vec<Expr>],
    ) {
        let (mass, name) = (self.mass(pushed.body), self.called(pushed.body));
        let along = impulses.iter().zip(parts).map(|(impulse, parts)| times(impulse, parts));
        let mut acting: Vec<Vec<Expr>> = along.collect();
        let weight = (0..self.axes.len()).map(|position| {
            self.weight_impulse(&mass, position, &pushed.start, &pushed.end).unwrap_or_else(Expr::zero)
        });
        acting.push(weight.collect());
        self.momentum_along_guide(guide, pushed.index, &acting, &format!("the forces on {name} give it impulses"));
        let held = self.axes.clone().into_iter().enumerate().map(|(position, (axis, _))| (position, axis));
        if !guide.along.turn.is_zero() {
            return;
        }
        let line = self.components(&guide.along);
        for (position, axis) in held {
            if line.get(position).is_none_or(Expr::is_zero) {
                let [from, to] = [1, 2].map(|side| self.place(pushed.body, pushed.index + side, axis));
                let because = format!("{} holds {name}", guide.by);
                self.law(&kinematics::DISPLACED, Some(pushed.index), because, (to, from));
                continue;
            }
            let pulls = pushed.acting.iter().zip(parts);
            let pulls = pulls.map(|(force, part)| force.strength.clone() * part[position].clone());
            let weight = self.downwards(position).map(|down| Expr::integer(down) * mass.clone() * self.gravity());
            let forces: Vec<Expr> = pulls.chain(weight).collect();
            self.motion_along(pushed, axis, &forces);
        }
    }
}
