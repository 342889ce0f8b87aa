//! A push of a body that a guide holds: impulse and momentum along its guide.

use crate::Builder;
use crate::guide::Guided;
use crate::guide::dot;
use momentous_expr::Expr;
use momentous_laws::kinematics;

use super::push::Pushed;
use super::push::times;

impl Builder<'_> {
    /// Impulse and momentum of a guided body, with its place and its acceleration.
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
        let line = self.components(&guide.along);
        let slants = !guide.along.turn.is_zero();
        for (position, (axis, _)) in self.axes.clone().into_iter().enumerate() {
            let Some(share) = line.get(position).filter(|share| !share.is_zero()) else {
                let [from, to] = [1, 2].map(|side| self.place(pushed.body, pushed.index + side, axis));
                let because = format!("{} holds {name}", guide.by);
                self.law(&kinematics::DISPLACED, Some(pushed.index), because, (to, from));
                continue;
            };
            // Of each force only the part along the guide counts: along an axis it is that part's own part, the guide balances the rest.
            let felt = |parts: &[Expr]| {
                if slants { dot(parts, &line) * share.clone() } else { parts[position].clone() }
            };
            let down = |at: usize| self.downwards(at).map_or_else(Expr::zero, Expr::integer);
            let downwards: Vec<Expr> = (0..line.len()).map(down).collect();
            let weight = felt(&downwards);
            let weight = (!weight.is_zero()).then(|| weight * mass.clone() * self.gravity());
            let pulls = pushed.acting.iter().zip(parts).map(|(force, parts)| force.strength.clone() * felt(parts));
            let forces: Vec<Expr> = pulls.chain(weight).collect();
            self.motion_along(pushed, axis, &forces);
        }
    }
}
