//! Bodies with a moment of inertia that turn about a fixed axis.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_quantity::Dimension;
use momentous_scene::Term;

use super::Builder;
use super::Instant;
use super::Name;
use super::QuantityKind;
use super::stage::Description;
use super::stage::ROTOR;

impl Builder<'_> {
    /// Makes the moments of inertia that are called as an angular impulse is, `I_M` of a body M, before there is one.
    pub(super) fn inertias_by_name(&mut self) {
        let scene = self.scene;
        let is_taken =
            |term: &Term| Name::parse(term.0.trim()).is_some_and(|name| name.kind == QuantityKind::AngularImpulse);
        for (body, entry) in &scene.bodies {
            if entry.inertia.as_ref().is_some_and(is_taken) {
                self.inertia(body);
            }
        }
    }

    /// The moment of inertia of a body that has one.
    fn inertia(&mut self, body: &str) -> Option<Expr> {
        let term = self.scene.bodies.get(body)?.inertia.clone()?;
        let meaning = format!("the moment of inertia of {}", self.called(body));
        let path = Path::root().key("scene").key("bodies").key(body).key("inertia");
        Some(self.read_positive(&term, Dimension::new(1, 2, 0), &meaning, &path))
    }

    /// The angular momentum of what carries the particles of an arm that turns so.
    pub(super) fn momentum_of_rotor(&mut self, rotor: Option<&str>, turn: &Expr) -> Option<Expr> {
        Some(self.inertia(rotor?)? * turn.clone())
    }

    /// The angular velocity of a body that turns about a fixed axis, and the point where that is.
    fn turn_of_rotor(&mut self, body: &str, instant: usize) -> Option<(String, Expr)> {
        let scene = self.scene;
        let turned = scene.stages.iter().map(|stage| Description::of(scene, stage));
        let about = turned
            .filter(|description| description.bodies.contains(&(body, Some(ROTOR))))
            .find_map(|description| description.about)?;
        let centre = self.point(about);
        Some((about.to_owned(), self.turn_of_arm(&centre, instant)))
    }

    /// The kinetic energy of a body that turns about a fixed axis.
    pub(super) fn kinetic_of_rotor(&mut self, body: &str, instant: usize) -> Option<Expr> {
        let inertia = self.inertia(body)?;
        let (_, turn) = self.turn_of_rotor(body, instant)?;
        Some(energy::kinetic(&inertia, &[turn]))
    }

    /// The angular momentum of a body that turns about a fixed axis at that point.
    pub(super) fn momentum_about(&mut self, body: &str, point: &str, instant: usize) -> Option<Expr> {
        let (about, turn) = self.turn_of_rotor(body, instant)?;
        if about == point { self.momentum_of_rotor(Some(body), &turn) } else { None }
    }

    /// On a circle the angular momentum about its centre is that of all bodies only where each of them turns about it: of any other
    /// nobody tells how it lies to the centre.
    pub(super) fn counts_all_that_turns(&mut self, symbol: Symbol) {
        let name = self.name(symbol).clone();
        let (QuantityKind::AngularMomentum, Some(Instant::Number(instant))) = (&name.kind, &name.instant) else {
            return;
        };
        if self.axes.len() > 1 || name.is_of_mass_centre() {
            return;
        }
        let scene = self.scene;
        let turning: Vec<&str> = (scene.stages.iter())
            .map(|stage| Description::of(scene, stage))
            .filter(|description| description.about == Some(name.subject.as_str()))
            .flat_map(|description| description.bodies)
            .map(|(body, _)| body)
            .collect();
        let alive = self.timeline.alive(*instant);
        let Some(other) = alive.into_iter().find(|body| !turning.contains(body)).map(|body| self.called(body)) else {
            return;
        };
        let centre = self.point(&name.subject);
        let message = format!("`{name}` counts every body, and nothing tells how {other} moves about {centre}");
        let help = "ask for the angular velocity, or leave out the body that does not turn about it";
        let path = Path::root().key("scene").key("points").key(name.subject.as_str());
        let fault = Fault::new(Code::UnderDetermined, message).help(help).at_path(path);
        if !self.faults.contains(&fault) {
            self.faults.push(fault);
        }
    }
}
