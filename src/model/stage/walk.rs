//! A walk along something that floats: the centre of mass stays where it is.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::QuantityKind;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::mass_centre;
use momentous_laws::separation;
use momentous_quantity::Dimension;
use momentous_scene::stage::Walk;

impl Builder<'_> {
    pub(crate) fn walk(&mut self, index: usize, stage: &Walk, path: &Path) {
        for body in [&stage.body, &stage.on] {
            self.starts_from_rest(index, body);
        }
        let bodies = [stage.body.as_str(), stage.on.as_str()];
        let [name, other] = bodies.map(|body| self.called(body));
        for [body, other] in [bodies, [bodies[1], bodies[0]]] {
            let words = "the walker does work to set both in motion and to stop them";
            let step = Influence::outside(index, body, self.called(other)).by(&[other]).works(Effect::Open, words);
            self.acts(step);
        }
        let displacements = bodies.map(|body| {
            let meaning = format!("the displacement of {} over the ground", self.called(body));
            let name = self.in_stage(QuantityKind::Displacement, body, index);
            Expr::from(self.symbol(name, meaning))
        });
        if let [(axis, _)] = self.axes[..] {
            for (body, displacement) in bodies.into_iter().zip(&displacements) {
                let because = format!("this is how far {} over the ground", self.does(body, ["moves", "move"]));
                self.comes_so_far((index, body), axis, displacement.clone(), because);
            }
        }
        let masses = bodies.map(|body| self.mass(body));
        let parts: Vec<(Expr, Expr)> = masses.into_iter().zip(displacements.clone()).collect();
        let because =
            "no external impulse acts along the path, and the centre of mass, initially at rest, stays where it is";
        self.law(&mass_centre::REST, Some(index), because, (momentous_laws::momentum::total(&parts), Expr::zero()));
        let meaning = format!("the displacement of {name} relative to {other}");
        let distance = self.read(&stage.distance, Dimension::LENGTH, &meaning, &path.key("distance"));
        let [of_walker, of_carrier] = &displacements;
        let because = format!("{name} walks along {other}, which moves meanwhile");
        self.law(
            &separation::RELATIVE_WAY,
            Some(index),
            because,
            separation::relative(of_walker, of_carrier, &distance),
        );
        self.not_needed(
            "the speed of the walk, and its changes",
            "the centre of mass stays where it is at every instant",
        );
        self.neglect(format!("the resistance to the motion of {other}"), "the problem gives none");
    }
}
