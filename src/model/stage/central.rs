//! Motion under a central force, in polar components.

use crate::expr::Expr;
use crate::fault::Path;
use crate::laws::angular;
use crate::laws::energy;
use crate::model::Agent;
use crate::model::Builder;
use crate::model::Impulse;
use crate::model::Influence;
use crate::quantity::Dimension;
use crate::scene::stage::Central;
use crate::scene::stage::CentralSpring;

impl Builder<'_> {
    pub(in crate::model) fn central(&mut self, index: usize, stage: &Central, path: &Path) {
        let (body, point) = (stage.body.as_str(), stage.about.as_str());
        let centre = self.point(point);
        let name = self.called(body);
        let [(r1, v1), (r2, v2)] = [index + 1, index + 2].map(|instant| self.polar_state(body, point, instant));
        let because =
            format!("the force on {name} always points to {centre} and has no moment about it; the mass cancels");
        let sides = (r1.clone() * v1.clone(), r2 * v2);
        self.law(&angular::CENTRAL, Some(index), because, sides);
        let rate = self.symbol(
            "areal_rate",
            Dimension::new(0, 2, -1),
            format!("the rate at which the radius from {centre} sweeps out area"),
        );
        let sides = (rate.into(), Expr::product([Expr::ratio(1, 2), r1, v1]));
        self.law(&angular::AREAL, Some(index), "in a short time the radius sweeps out a thin triangle", sides);
        let called = format!("the force towards {centre}");
        self.acts(Influence::outside(index, body, called).through(point));
        self.impulses.push(Impulse {
            stage: index,
            on: body.to_owned(),
            by: Agent::Outside,
            called: format!("the force towards {centre}"),
            components: Vec::new(),
            impulsive: false,
        });
        if let Some(spring) = &stage.spring {
            self.central_spring(index, stage, spring, path);
        } else if stage.gravity.is_none() {
            let why = "the force's moment about the centre is zero, whatever its strength";
            self.not_needed("the radial motion in between", why);
        }
        self.orbit(index, stage, path);
    }

    /// Kinetic energy and that of the spring stay the same together.
    fn central_spring(&mut self, index: usize, stage: &Central, spring: &CentralSpring, path: &Path) {
        let (body, name) = (stage.body.as_str(), self.called(&stage.body));
        let path = path.key("spring");
        let stiffness = self.read_positive(
            &spring.stiffness,
            Dimension::new(1, 0, -2),
            "the stiffness of the spring",
            &path.key("stiffness"),
        );
        let natural = spring.unstretched.as_ref().map_or_else(Expr::zero, |term| {
            self.read_positive(
                term,
                Dimension::LENGTH,
                "the unstretched length of the spring",
                &path.key("unstretched"),
            )
        });
        let energies = [index + 1, index + 2].map(|instant| {
            let (radius, _) = self.polar_state(body, &stage.about, instant);
            let moving = self.kinetic_term(body, instant);
            moving + energy::of_spring(&stiffness, &(radius - natural.clone()))
        });
        let [start, end] = energies;
        let because = format!("only the spring does work on {name}");
        self.law(&energy::CONSERVATION, Some(index), because, (start, end));
        self.neglect("the mass of the spring", "it is light");
    }

    /// How a point is called in a sentence.
    pub(in crate::model) fn point(&self, point: &str) -> String {
        self.scene.points.get(point).map_or_else(|| point.to_owned(), |entry| entry.name.clone())
    }

    /// Radius and transverse velocity of a body at an instant.
    pub(in crate::model) fn polar_state(&mut self, body: &str, point: &str, instant: usize) -> (Expr, Expr) {
        let since = self.timeline.since(body, instant).unwrap_or(instant);
        let (name, centre, when) = (self.called(body), self.point(point), self.when(since));
        let radius = self.positive(
            format!("r_{body}{since}"),
            Dimension::LENGTH,
            format!("the distance of {name} from {centre} {when}"),
        );
        let meaning = format!("the transverse velocity of {name} {when}");
        let velocity = self.symbol(format!("v_{body}{since}.theta"), Dimension::VELOCITY, meaning);
        (radius.into(), velocity.into())
    }
}
