//! Bodies that act on each other only: momentum and angular momentum of all of them.

use crate::expr::Expr;
use crate::fault::Code;
use crate::fault::Fault;
use crate::fault::Path;
use crate::laws::angular;
use crate::laws::energy;
use crate::model::Builder;
use crate::model::Name;
use crate::model::QuantityKind;
use crate::quantity::Dimension;
use crate::scene::Plane;
use crate::scene::stage::Interact;

impl Builder<'_> {
    pub(in crate::model) fn interact(&mut self, index: usize, stage: &Interact, path: &Path) {
        if self.scene.plane == Plane::Vertical {
            let fault = Fault::new(Code::Value, "in a vertical plane, weight is an external force on the bodies");
            self.faults.push(fault.help("write `plane: horizontal`").at_path(path.clone()));
        }
        let bodies: Vec<&str> = stage.between.iter().map(String::as_str).collect();
        let because = "the forces between the bodies cancel in pairs";
        self.momentum_of_all(index, because, [&bodies, &bodies]);
        let scene = self.scene;
        let letters = self.axis_letters();
        let turnings: Vec<Option<&str>> = match &letters[..] {
            [_, _] => vec![None],
            [_, _, _] => letters.iter().map(|letter| Some(*letter)).collect(),
            _ => Vec::new(),
        };
        for point in scene.points.keys() {
            for letter in &turnings {
                let about = Name::of(QuantityKind::AngularMomentum, point).along(*letter);
                let [before, after] =
                    [index + 1, index + 2].map(|instant| self.quantity(about.clone().at(instant)).map(Expr::from));
                let (Some(before), Some(after)) = (before, after) else { continue };
                let because =
                    "the forces between the bodies are equal and opposite along one line, and their moments cancel";
                self.law(&angular::CONSERVATION, Some(index), because, (before, after));
            }
        }
        let loss = match &stage.loss {
            Some(term) => Some(self.read(term, Dimension::ENERGY, "the kinetic energy lost", &path.key("loss"))),
            None => stage.elastic.then(Expr::zero),
        };
        if let Some(loss) = loss {
            let because =
                if stage.elastic { "no kinetic energy is lost" } else { "the loss of kinetic energy is given" };
            let [start, end] = [index + 1, index + 2].map(|instant| {
                Expr::sum(bodies.iter().map(|body| self.kinetic_term(body, instant)).collect::<Vec<_>>())
            });
            self.law(&energy::LOSS, Some(index), because, (start - loss, end));
        }
        self.not_needed("the forces between the bodies", "within the system they cancel in pairs");
    }
}
