//! Bodies that act on each other only: momentum and angular momentum of all of them.

use crate::Builder;
use crate::Name;
use crate::QuantityKind;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::angular;
use momentous_laws::energy;
use momentous_laws::mass_centre;
use momentous_laws::momentum;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::stage::Interact;

impl Builder<'_> {
    pub(crate) fn interact(&mut self, index: usize, stage: &Interact, path: &Path) {
        if self.scene.plane == Plane::Vertical {
            let fault = Fault::new(Code::Value, "in a vertical plane, weight is an external force on the bodies");
            self.faults.push(fault.help("write `plane: horizontal`").at_path(path.clone()));
        }
        if let Some(friction) = &stage.friction {
            return self.rub(index, stage, friction, path);
        }
        self.nothing_rubs(stage, path);
        let bodies: Vec<&str> = stage.between.iter().map(String::as_str).collect();
        let because = "the forces between the bodies cancel in pairs";
        self.momentum_of_all(index, because, [&bodies, &bodies]);
        self.displacements(index, stage, &bodies, path);
        let scene = self.scene;
        let letters = self.axis_letters();
        let turnings: Vec<Option<&str>> = match &letters[..] {
            [_, _] => vec![None],
            [_, _, _] => letters.iter().map(|letter| Some(*letter)).collect(),
            _ => Vec::new(),
        };
        // What guides a body has a moment of its own, so that nothing is known of angular momentum.
        let points = scene.points.keys().filter(|_| bodies.iter().all(|body| self.guided(body).is_none()));
        let points: Vec<&String> = points.collect();
        for point in points {
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
        if stage.elastic && stage.loss.is_some() {
            let fault = Fault::new(
                Code::OverDetermined,
                "`elastic` says that no kinetic energy is lost, and `loss` that some is",
            );
            self.faults.push(fault.help("remove `elastic` or `loss`").at_path(path.key("loss")));
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
        self.neglect("friction and other resistance from outside", "the problem gives none");
        self.not_needed("the forces between the bodies", "within the system they cancel in pairs");
    }

    /// The places to which the bodies get together: their centre of mass keeps its velocity.
    fn displacements(&mut self, index: usize, stage: &Interact, bodies: &[&str], path: &Path) {
        let meaning = format!("the duration of {}", self.stage_phrase(index));
        let time = stage.during.as_ref().map(|term| {
            let time = self.read_positive(term, Dimension::TIME, &meaning, &path.key("during"));
            self.lasting[index] = Some(time.clone());
            time
        });
        if stage.at_rest {
            for body in bodies {
                self.starts_from_rest(index, body);
            }
        }
        if time.is_none() && !stage.at_rest {
            return;
        }
        if let Some(held) = bodies.iter().find_map(|body| self.guided(body)) {
            let message = format!(
                "impulses of {} act on {} from outside, so the centre of mass is not free",
                held.by,
                self.called(&held.body)
            );
            let key = if stage.at_rest { "at_rest" } else { "during" };
            let help = format!("remove `{key}`, or the `guide`");
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key(key)));
            return;
        }
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for axis in axes {
            let moved: Vec<(Expr, Expr, Expr)> = bodies
                .iter()
                .map(|body| {
                    let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
                    (self.mass(body), from, to)
                })
                .collect();
            let left = mass_centre::displaced(&moved);
            let along = self.along(axis);
            let because = format!("no external impulse acts on the bodies{along}");
            let (law, because, right) = match &time {
                Some(time) if !stage.at_rest => {
                    let parts: Vec<(Expr, Expr)> =
                        bodies.iter().map(|body| (self.mass(body), self.velocity(body, index + 1, axis))).collect();
                    let because = format!("{because}, and their momentum is the same all the time");
                    (&mass_centre::DISPLACEMENTS, because, momentum::total(&parts) * time.clone())
                }
                _ => {
                    let because = format!("{because}, and their centre of mass, initially at rest, stays where it is");
                    (&mass_centre::REST, because, Expr::zero())
                }
            };
            self.law(law, Some(index), because, (left, right));
        }
    }
}
