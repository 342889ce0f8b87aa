//! A conical pendulum whose cord is drawn in: steady circles before and after, and angular momentum about the vertical.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::VectorKind;
use crate::builder::SECOND_COST;
use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_fault::Path;
use momentous_laws::angular;
use momentous_laws::force;
use momentous_laws::geometry;
use momentous_quantity::Dimension;
use momentous_scene::Term;
use momentous_scene::stage::Conical;
use momentous_solve::Relation;

impl Builder<'_> {
    pub(crate) fn conical(&mut self, index: usize, stage: &Conical, path: &Path) {
        let (name, centre) = (self.called(&stage.body), self.point(&stage.about));
        let ends = stage.length.ends();
        let momenta = [0, 1].map(|side| self.steady_circle(index, side, stage, ends[side], path));
        let lengths = ends.map(|term| self.read(term, Dimension::LENGTH, "", &path.key("length")));
        let [longer, shorter] = lengths;
        let words = "weight and the cord do work as the cord is drawn in or let out";
        let pulls = Influence::outside(index, &stage.body, "the pull of the cord with weight").through(&stage.about);
        self.acts(pulls.works(Effect::Of((longer - shorter).simplify()), words));
        let because = format!("the cord's pull and the weight have no moment about the vertical through {centre}");
        let [before, after] = momenta;
        if stage.length.is_constant() {
            self.same_circle(index, &stage.body);
        } else {
            self.not_needed(
                format!("the motion of {name} while the cord is drawn in"),
                "the question concerns only the steady circles",
            );
        }
        self.law(&angular::CONSERVATION, Some(index), because, (before, after));
        self.note_impulse(index, &stage.body, "weight and the cord", Vec::new());
        self.neglect("the mass of the cord", "it is light");
    }

    /// A cord that keeps its length keeps its circle, which needs no equation to be solved for its angle.
    fn same_circle(&mut self, index: usize, body: &str) {
        let [start, end] = [index + 1, index + 2].map(|instant| self.timeline.naming_instant(body, instant));
        let kinds = [QuantityKind::Direction(VectorKind::Velocity), QuantityKind::Velocity, QuantityKind::Position];
        for kind in kinds {
            let [before, after] = [start, end].map(|instant| self.quantity(Name::of(kind.clone(), body).at(instant)));
            let (Some(before), Some(after)) = (before, after) else { continue };
            let because = "the cord keeps its length, so the circle stays the same";
            self.law(&force::CONICAL, Some(index), because, (after.into(), before.into()));
        }
    }

    /// One of the two circles; the angular momentum on it.
    fn steady_circle(&mut self, index: usize, side: usize, stage: &Conical, length: &Term, path: &Path) -> Expr {
        let (body, instant) = (stage.body.as_str(), index + 1 + side);
        let since = self.timeline.naming_instant(body, instant);
        let (name, centre, when) = (self.called(body), self.point(&stage.about), self.when(since));
        let meaning = format!("the length of the cord {when}");
        let length = self.read_positive(length, Dimension::LENGTH, &meaning, &path.key("length"));
        let meaning = format!("the angle between the cord and the vertical {when}");
        let angle =
            Expr::from(self.positive(Name::of(QuantityKind::Direction(VectorKind::Velocity), body).at(since), meaning));
        let meaning = format!("the velocity of {name} {when}");
        let velocity = Name::of(QuantityKind::Velocity, body).at(since);
        let velocity_name = velocity.to_string();
        let velocity = Expr::from(self.symbol(velocity, meaning));
        let meaning = format!("the radius of the circle of {name} {when}");
        let radius = Expr::from(self.positive(Name::of(QuantityKind::Position, body).at(since), meaning));
        let because = "the cord is straight";
        let sides = (radius.clone(), length.clone() * angle.clone().sin());
        self.law(&geometry::COMPONENTS, Some(index), because, sides);
        let because = format!("{name} moves steadily round a horizontal circle");
        let sides =
            (velocity.clone().powi(2) / radius.clone(), self.gravity() * Expr::apply(Function::Tan, angle.clone()));
        self.law(&force::CONICAL, Some(index), because.clone(), sides);
        if self.given.contains(&velocity_name) {
            // With the radius put in, the angle alone is left: v^2 = g L sin tan.
            let tangent = Expr::apply(Function::Tan, angle.clone());
            let squares = [self.gravity(), length.clone(), angle.clone().sin(), tangent];
            let because = "the radius of the steady circle is substituted";
            let sides = (velocity.clone().powi(2), Expr::product(squares));
            self.law_at(SECOND_COST, &force::CONICAL, Some(index), because, sides);
        }
        let meaning = format!("the tension of the cord {when}");
        let tension = Expr::from(self.positive(Name::of(QuantityKind::Tension, body).at(since), meaning));
        let weight = self.mass(body) * self.gravity();
        let because = format!("{name} moves neither up nor down");
        self.law(&force::BALANCE, Some(index), because, (tension * angle.clone().cos(), weight));
        let reason = Reason::CordUpwards;
        self.require(angle.clone().cos(), Relation::Greater, Expr::zero(), reason);
        let meaning = format!("the angular momentum about the vertical through {centre} {when}");
        let momentum =
            Expr::from(self.symbol(Name::of(QuantityKind::AngularMomentum, &stage.about).at(instant), meaning));
        let mass = self.mass(body);
        let moment = Expr::product([mass.clone(), radius, velocity]);
        let because = "the velocity is at right angles to the radius";
        self.law(&angular::ANGULAR_MOMENTUM, Some(index), because, (momentum.clone(), moment));
        // With the speed put in as well: H^2 = m^2 g L^3 sin^3 tan.
        let tangent = Expr::apply(Function::Tan, angle.clone());
        let squares = [mass.powi(2), self.gravity(), length.powi(3), angle.sin().powi(3), tangent];
        let because =
            "the motion is again a steady circle, and its speed is put into the square of the angular momentum";
        let sides = (momentum.clone().powi(2), Expr::product(squares));
        self.law_at(SECOND_COST, &force::CONICAL, Some(index), because, sides);
        momentum
    }
}
