//! Motion under a central force, in polar components.

use crate::Builder;
use crate::Influence;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::Work;
use crate::stored::Stored;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::angular;
use momentous_laws::energy;
use momentous_quantity::Dimension;
use momentous_scene::stage::Central;
use momentous_scene::stage::CentralSpring;
use momentous_solve::Relation;

impl Builder<'_> {
    pub(crate) fn central(&mut self, index: usize, stage: &Central, path: &Path) {
        let (body, point) = (stage.body.as_str(), stage.about.as_str());
        let centre = self.point(point);
        let name = self.called(body);
        let [(r1, v1), (r2, v2)] = [index + 1, index + 2].map(|instant| self.polar_state(body, point, instant));
        let because =
            format!("the force on {name} always points to {centre} and has no moment about it; the mass cancels");
        let sides = (r1.clone() * v1.clone(), r2.clone() * v2.clone());
        self.law(&angular::CENTRAL, Some(index), because, sides);
        let rate = self.symbol(
            self.in_stage(QuantityKind::ArealRate, "", index),
            format!("the rate at which the radius from {centre} sweeps out area"),
        );
        let sides = (rate.into(), Expr::product([Expr::ratio(1, 2), r1.clone(), v1.clone()]));
        self.law(&angular::AREAL, Some(index), "in a short time the radius sweeps out a thin triangle", sides);
        self.note_impulse(index, body, format!("the force towards {centre}"), Vec::new());
        let mut strength = None;
        if let Some(spring) = &stage.spring {
            strength = Some(self.central_spring(index, stage, spring, path));
        } else if stage.gravity.is_none() {
            let why = "the force's moment about the centre is zero, whatever its strength";
            self.not_needed("the radial motion in between", why);
        }
        if let Some(gravity) = self.orbit(index, stage, path) {
            // Energy leaves this of the radial motion, at distances that the body never comes to less than nothing.
            let radial = Name::of(QuantityKind::Velocity, body).at(index + 1).along("r");
            if let Some(radial) = self.quantity(radial) {
                let start = Expr::sum([Expr::from(radial).powi(2), v1.powi(2)]);
                let gained = Expr::integer(2) * gravity.clone() * (r2.powi(-1) - r1.powi(-1));
                self.require(start + gained, Relation::AtLeast, v2.clone().powi(2), Reason::OutOfReach(name));
            }
            let mass = self.mass(body);
            let pull = mass * gravity / self.polar_state(body, point, index + 1).0.power(Expr::integer(2));
            strength = Some(strength.map_or(pull.clone(), |spring| spring + pull));
        }
        let influence = Influence::outside(index, body, format!("the force towards {centre}")).through(point);
        let work = strength.map_or(influence.work, |strength| self.unless_round(index, stage, strength));
        self.acts(Influence { work, ..influence });
    }

    /// The force does no work where it just holds the body on a circle.
    fn unless_round(&mut self, index: usize, stage: &Central, strength: Expr) -> Work {
        let body = stage.body.as_str();
        let [(start, across), (end, _)] =
            [index + 1, index + 2].map(|instant| self.polar_state(body, &stage.about, instant));
        let radial = self
            .quantity(Name::of(QuantityKind::Velocity, body).at(index + 1).along("r"))
            .map_or_else(Expr::zero, Expr::from);
        let needed = self.mass(body) * across.power(Expr::integer(2)) / start.clone();
        Work::UnlessRound([end - start, radial, (strength - needed).simplify()])
    }

    /// Kinetic energy and that of the spring stay the same together; the force of the spring at the start.
    fn central_spring(&mut self, index: usize, stage: &Central, spring: &CentralSpring, path: &Path) -> Expr {
        let (body, name) = (stage.body.as_str(), self.called(&stage.body));
        let (path, called) = (path.key("spring"), spring.called());
        let stiffness = self.read_positive(
            &spring.stiffness,
            Dimension::new(1, 0, -2),
            &format!("the stiffness of {called}"),
            &path.key("stiffness"),
        );
        let natural = spring.unstretched.as_ref().map_or_else(Expr::zero, |term| {
            self.read_positive(
                term,
                Dimension::LENGTH,
                &format!("the unstretched length of {called}"),
                &path.key("unstretched"),
            )
        });
        let ends = [index + 1, index + 2];
        let deformations = ends.map(|instant| self.polar_state(body, &stage.about, instant).0 - natural.clone());
        let [start, end] = [0, 1].map(|side| {
            let moving = self.kinetic_term(body, ends[side]);
            moving + energy::of_spring(&stiffness, &deformations[side])
        });
        let because = format!("only {called} does work on {name}");
        let across = energy::kinetic(&self.mass(body), &[self.polar_state(body, &stage.about, ends[1]).1]);
        let across = across + energy::of_spring(&stiffness, &deformations[1]);
        self.require(start.clone(), Relation::AtLeast, across, Reason::OutOfReach(name.clone()));
        self.law(&energy::CONSERVATION, Some(index), because, (start, end));
        self.neglect(format!("the mass of {called}"), "it is light");
        if spring.cord {
            for deformation in &deformations {
                self.require(deformation.clone(), Relation::AtLeast, Expr::zero(), Reason::Slack(called.to_owned()));
            }
        }
        self.stored.push(Stored {
            stage: index,
            called: called.to_owned(),
            stiffness: stiffness.clone(),
            deformations,
        });
        stiffness * (self.polar_state(body, &stage.about, index + 1).0 - natural)
    }

    /// The name of a point in a sentence.
    pub(crate) fn point(&self, point: &str) -> String {
        self.scene.point(point).to_owned()
    }

    /// Radius and transverse velocity of a body at an instant.
    pub(crate) fn polar_state(&mut self, body: &str, point: &str, instant: usize) -> (Expr, Expr) {
        let since = self.timeline.naming_instant(body, instant);
        let (name, centre, when) = (self.called(body), self.point(point), self.when(since));
        let place = self.distance_since(body, since);
        let radius = self.positive(
            Name::of(QuantityKind::Position, body).at(place),
            format!("the distance of {name} from {centre} {}", self.when(place)),
        );
        let meaning = format!("the transverse velocity of {name} {when}");
        let velocity = self.symbol(Name::of(QuantityKind::Velocity, body).at(since).along("theta"), meaning);
        (radius.into(), velocity.into())
    }
}
