//! What a sheet draws of a body: the velocities, impulses and forces that are given.

use crate::expr::Expr;
use crate::expr::Math;
use crate::expr::name_math;
use crate::figure::AngleMark;
use crate::figure::LabelledVector;
use crate::figure::Moving;
use crate::figure::MovingBody;
use crate::model::ActingForce;
use crate::model::Direction;
use crate::model::ForceKind;
use crate::model::QuantityKind;
use crate::model::VectorKind;
use crate::scene::Stage;

use super::super::compass::Compass;
use super::super::labels::body_math;
use super::super::quantities::Quantities;
use super::super::vectors::Labelled;

impl Quantities<'_> {
    /// A body with these vectors.
    pub(in super::super) fn body(&self, body: &str, vectors: Vec<Moving>) -> MovingBody {
        MovingBody { name: body_math(body), form: self.form(body), vectors }
    }

    /// The velocity of a body at an instant: as one arrow, or as the components that are given.
    pub(in super::super) fn motion(&self, compass: &Compass, body: &str, instant: usize) -> Vec<Moving> {
        let name = self.velocity_name(body, instant);
        if let Some(value) = self.velocity(body, instant) {
            let vector = Labelled { label: name_math(&name), value: Some(value) };
            let moving = Moving::velocity(vector.placed(compass));
            return vec![match self.stated_angle(body, instant) {
                Some(angle) => moving.at_angle(compass.axis_angle(0), angle),
                None => moving,
            }];
        }
        let component = |position: usize, letter: &str| {
            let component = format!("{name}.{letter}");
            let value = self.named(&component).filter(|value| *value != 0.0)?;
            let along = self.along(position, value);
            Some(Moving::velocity(LabelledVector::known(name_math(&component), compass.place(along))))
        };
        let letters = self.axes.iter().map(|axis| axis.letter()).enumerate();
        letters.filter_map(|(position, letter)| component(position, letter)).collect()
    }

    /// The angle that gives the direction of a velocity, where it is given so.
    fn stated_angle(&self, body: &str, instant: usize) -> Option<Math> {
        let angle = self.since(QuantityKind::Direction(VectorKind::Velocity), body, instant).to_string();
        self.named(&angle)?;
        Some(name_math(&angle))
    }

    /// The impulse of a blow on a body, where it is given.
    pub(in super::super) fn impulses_on(&self, compass: &Compass, body: &str, stage: usize) -> Vec<Moving> {
        if !matches!(self.scene().stages.get(stage), Some(Stage::Blow(_))) {
            return Vec::new();
        }
        let own = self.model().impulses.iter().filter(|impulse| impulse.stage == stage && impulse.on == body);
        let known = own.map(|impulse| self.impulse(impulse)).filter(|impulse| impulse.value.is_some());
        known.map(|impulse| Moving::impulse(impulse.placed(compass))).collect()
    }

    /// The pushes and pulls on a body in a stage that are given.
    pub(in super::super) fn forces_on(&self, compass: &Compass, body: &str, stage: usize) -> Vec<Moving> {
        let own = self.model().forces.iter().filter(|force| force.stage == stage && force.on == body);
        own.filter(|force| force.kind == ForceKind::Pull).filter_map(|force| self.force(compass, force)).collect()
    }

    fn force(&self, compass: &Compass, force: &ActingForce) -> Option<Moving> {
        let clock = self.model().symbols.find("t").filter(|clock| force.strength.contains(*clock));
        let told = force.strength.all_symbols(&|symbol| Some(symbol) == clock || self.value(symbol).is_some());
        let [x, y] = self.direction(&force.direction).filter(|_| told)?;
        // A force that changes has no one length; its arrow shows where it points.
        let (label, size) = match clock {
            Some(_) => (Math::Identifier("F".to_owned()), 1.0),
            None => (self.unsigned(&force.strength), self.evaluate(&force.strength)?),
        };
        let vector = Labelled { label, value: Some([size * x, size * y]) };
        let moving = Moving::force(vector.placed(compass));
        Some(match self.angle_mark(compass, &force.direction) {
            Some(mark) => moving.at_angle(mark.from, mark.label),
            None => moving,
        })
    }

    /// The angle that gives a direction, counted from an axis.
    pub(in super::super) fn angle_mark(&self, compass: &Compass, direction: &Direction) -> Option<AngleMark> {
        let base = Direction { turn: Expr::zero(), ..direction.clone() };
        if direction.turn.is_zero() {
            return None;
        }
        let turn = self.evaluate(&direction.turn)?;
        let label = if turn < 0.0 { -direction.turn.clone() } else { direction.turn.clone() };
        Some(AngleMark { from: compass.angle(self.direction(&base)?), label: self.symbolic(&label) })
    }
}
