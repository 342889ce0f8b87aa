//! A blow on a body whose velocity is resolved along the radius from a centre and across it.

use crate::Agent;
use crate::Builder;
use crate::Impulse;
use crate::Name;
use crate::QuantityKind;
use crate::weight_in_contact::Lasting;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::momentum;
use momentous_scene::stage::Blow;

/// The components, as they stand in names and in words.
const COMPONENTS: [(&str, &str); 2] = [("r", "along the radius"), ("theta", "across the radius")];

impl Builder<'_> {
    pub(super) fn blow_round(&mut self, index: usize, stage: &Blow, path: &Path) {
        let body = stage.body.as_str();
        let (name, mass) = (self.called(body), self.mass(body));
        self.included_weight(
            &Lasting { index, duration: stage.duration.as_ref(), include: Some(&stage.include), path },
            body,
        );
        let mut components = Vec::new();
        for (letter, along) in COMPONENTS {
            let impulse = Name::of(QuantityKind::Impulse, body).along(letter).during(self.stage_label(index));
            let meaning = format!("the impulse on {name} from {} {along}", stage.by);
            let impulse = Expr::from(self.symbol(impulse, meaning));
            components.push(impulse.clone());
            let velocity = |instant| Name::of(QuantityKind::Velocity, body).at(instant).along(letter);
            let ends = [index + 1, index + 2].map(|instant| self.quantity(velocity(instant)));
            let [Some(before), Some(after)] = ends else { return };
            let because = format!("{} gives {name} an impulse {along}", stage.by);
            let sides = momentum::impulse_momentum(&mass, &before.into(), &[impulse], &after.into());
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
        }
        let meaning = format!("the magnitude of the impulse on {name} from {}", stage.by);
        let magnitude = Expr::from(self.positive(self.in_stage(QuantityKind::Impulse, body, index), meaning));
        self.magnitude_of_impulse(index, magnitude.clone(), &components);
        if stage.duration.is_some() {
            self.mean_force(index, body, &magnitude, stage.duration.as_ref(), path);
        }
        self.impulses.push(Impulse {
            stage: index,
            on: body.to_owned(),
            by: Agent::Outside,
            called: stage.by.clone(),
            components: Vec::new(),
            impulsive: true,
        });
    }
}
