//! A blow of unknown history: impulse and momentum along every axis.

use crate::Agent;
use crate::Builder;
use crate::Impulse;
use crate::Name;
use crate::QuantityKind;
use crate::weight_in_contact::Lasting;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::momentum;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::stage::Blow;

impl Builder<'_> {
    pub(crate) fn blow(&mut self, index: usize, stage: &Blow, path: &Path) {
        if self.axes.is_empty() {
            return self.blow_round(index, stage, path);
        }
        let body = stage.body.as_str();
        let name = self.called(body);
        let mass = self.mass(body);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let contact = Lasting { index, duration: stage.duration.as_ref(), include: Some(&stage.include), path };
        let gained = self.included_weight(&contact, body);
        let guide = self.guided(body);
        let mut components = Vec::new();
        for (position, axis) in axes.iter().enumerate() {
            let along = self.along(*axis);
            let meaning = format!("the impulse on {name} from {}{along}", stage.by);
            let impulse = Name::of(QuantityKind::Impulse, body).along(self.letter(*axis));
            let impulse = impulse.during(self.stage_label(index));
            let impulse = Expr::from(self.symbol(impulse, meaning));
            components.push(impulse.clone());
            if guide.is_some() {
                continue;
            }
            let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, *axis));
            let weight = gained.as_ref().map(|gained| gained[position].clone()).filter(|gained| !gained.is_zero());
            let because = match weight {
                None => format!("{} gives {name} an impulse{along}", stage.by),
                Some(_) => format!("{} and weight give {name} impulses{along}", stage.by),
            };
            let acting: Vec<Expr> =
                [impulse.clone()].into_iter().chain(weight.map(|gained| mass.clone() * gained)).collect();
            let sides = momentum::impulse_momentum(&mass, &before, &acting, &after);
            self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
            if axes.len() == 1 {
                self.mean_force(index, body, &impulse, stage.duration.as_ref(), path);
            }
        }
        if let Some(guide) = &guide {
            let (because, weight) = match &gained {
                None => (format!("{} gives {name} an impulse", stage.by), None),
                Some(gained) => (
                    format!("{} and weight give {name} impulses", stage.by),
                    Some(gained.iter().map(|gained| mass.clone() * gained.clone()).collect()),
                ),
            };
            let acting: Vec<Vec<Expr>> = [components.clone()].into_iter().chain(weight).collect();
            self.momentum_along_guide(guide, index, &acting, &because);
        }
        if axes.len() > 1 {
            self.resultant(index, body, &components, &format!("the impulse on {name} from {}", stage.by));
            if stage.duration.is_some() {
                let magnitude = Expr::from(self.positive(
                    self.in_stage(QuantityKind::Impulse, body, index),
                    format!("the magnitude of the impulse on {name} from {}", stage.by),
                ));
                self.mean_force(index, body, &magnitude, stage.duration.as_ref(), path);
            }
        }
        self.impulses.push(Impulse {
            stage: index,
            on: body.to_owned(),
            by: Agent::Outside,
            called: stage.by.clone(),
            components,
            impulsive: true,
        });
        if let Some(gained) = &gained {
            self.weight_acts(index, body, gained);
        } else if self.scene.plane == Plane::Vertical {
            self.neglect(
                "weight during the blow",
                "it is not impulsive: its impulse in so short a time is negligible compared with that of the blow",
            );
        }
        self.weigh_contact(&contact, &[(body, body)], false);
    }
}
