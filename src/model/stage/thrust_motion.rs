//! The acceleration of a body that throws mass away, and the net force on what is left of it.

use crate::Builder;
use momentous_expr::Expr;
use momentous_laws::motion;
use momentous_laws::variable_mass;
use momentous_scene::Axis;

use super::thrust::Burn;

impl Builder<'_> {
    /// Net force and acceleration at both ends, along every axis; at an end that another burn or a push shares, those of the earlier
    /// one.
    pub(super) fn rates_of_burn(&mut self, burn: &Burn) {
        let (index, name) = (burn.index, self.called(&burn.body));
        let follows = self.scene.follows_a_force(index, &burn.body);
        let parts = self.components(&burn.direction);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for ((position, axis), part) in axes.into_iter().enumerate().zip(parts) {
            for (side, mass) in burn.masses.iter().enumerate().skip(usize::from(follows)) {
                let instant = index + 1 + side;
                let [force, acceleration] = self.net_force_and_acceleration(&burn.body, instant, axis);
                let weight = self
                    .downwards(position)
                    .map(|down| Expr::product([Expr::integer(down), mass.clone(), self.gravity()]));
                let all = Expr::sum([burn.thrust.clone() * part.clone()].into_iter().chain(weight)).simplify();
                let because = format!("these are all the forces on what {name} consists of at that instant");
                self.law(&motion::ALL_FORCES, Some(index), because, (force.clone(), all));
                let because = "the thrust takes into account what the exhaust carries away";
                let sides = motion::net_force(mass, &acceleration, &force);
                self.law(&variable_mass::ACCELERATION, Some(index), because, sides);
            }
        }
    }
}
