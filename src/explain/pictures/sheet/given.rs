//! Given vectors of a body on a sheet: velocities, impulses and forces.

use std::sync::Arc;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::AngleMark;
use momentous_figure::LabelledVector;
use momentous_figure::Moving;
use momentous_figure::MovingBody;
use momentous_model::ActingForce;
use momentous_model::Direction;
use momentous_model::ForceKind;
use momentous_model::QuantityKind;
use momentous_model::VectorKind;
use momentous_scene::Force;
use momentous_scene::Pull;
use momentous_scene::Stage;
use momentous_scene::Strength;
use momentous_scene::stage::Resistance;

use super::super::compass::Compass;
use super::super::labels::body_math;
use super::super::labels::factor;
use super::super::labels::product;
use super::super::quantities::Quantities;
use super::super::vectors::Labelled;

impl Quantities<'_> {
    /// A body with these vectors.
    pub(in super::super) fn body(&self, body: &str, vectors: Vec<Moving>) -> MovingBody {
        MovingBody { vectors, ..MovingBody::new(body_math(body)).shaped(self.form(body)) }
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
        let told = letters.filter_map(|(position, letter)| component(position, letter));
        told.chain(self.asked_motion(compass, body, instant)).collect()
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
        let impulses = self.model().impulses.iter().filter(|impulse| impulse.stage == stage && impulse.on == body);
        let known = impulses.map(|impulse| self.impulse(impulse)).filter(|impulse| impulse.value.is_some());
        known.map(|impulse| Moving::impulse(impulse.placed(compass))).collect()
    }

    /// The pushes and pulls on a body in a stage that are given.
    pub(in super::super) fn forces_on(&self, compass: &Compass, body: &str, stage: usize) -> Vec<Moving> {
        let forces = self.model().forces.iter().filter(|force| force.stage == stage && force.on == body);
        let pulls = forces.filter(|force| force.kind == ForceKind::Pull).filter_map(|force| self.force(compass, force));
        let resisted = self.against_resistance(body, stage).into_iter();
        pulls.chain(resisted.map(|force| Moving::force(force.placed(compass)))).collect()
    }

    /// The resistance to the motion of a body when a push begins, against its velocity, and the given ones of the other forces
    /// along a line.
    fn against_resistance(&self, body: &str, stage: usize) -> Vec<Labelled> {
        let Some(Stage::Push(push)) = self.scene().stages.get(stage) else { return Vec::new() };
        let pulls =
            push.forces.iter().filter_map(|force| if let Force::Pull(pull) = force { Some(pull) } else { None });
        let told: Vec<Labelled> = pulls.filter_map(|pull| self.pull_along(pull)).collect();
        let is_whole = told.len() == push.forces.len();
        let resistance = push
            .resistance
            .as_ref()
            .filter(|_| is_whole)
            .and_then(|resistance| self.resisting(resistance, body, stage));
        if resistance.is_some() { told.into_iter().chain(resistance).collect() } else { Vec::new() }
    }

    /// A pull along the only axis, where it is given.
    fn pull_along(&self, pull: &Pull) -> Option<Labelled> {
        let (Strength::Term(term), [_]) = (&pull.value, &self.axes[..]) else { return None };
        let words = pull.direction.as_ref().map_or("", |term| term.0.trim());
        let ahead = self.scene().axes.rectangular().into_iter().any(|(_, senses)| senses.positive == words);
        let back = self.is_backwards(pull.direction.as_ref());
        let sense = (back || ahead || words.is_empty()).then(|| if back { -1.0 } else { 1.0 })?;
        let strength = self.term(term)?;
        let value = self.along(0, sense * self.evaluate(&strength)?);
        Some(Labelled { label: self.unsigned(&strength), value: Some(value) })
    }

    fn resisting(&self, resistance: &Resistance, body: &str, stage: usize) -> Option<Labelled> {
        let speed = name_math(&self.velocity_name(body, stage + 1));
        let [x, y] = self.velocity(body, stage + 1).filter(|velocity| *velocity != [0.0, 0.0])?;
        let (term, power, per_velocity) = match resistance {
            Resistance::Linear(term) => (term, speed, 1.0),
            Resistance::Quadratic(term) => {
                let two = Math::Number("2".to_owned());
                (term, Math::Sup(Arc::new(speed), Arc::new(two)), libm::hypot(x, y))
            }
        };
        let coefficient = self.term(term)?;
        let size = self.evaluate(&coefficient)? * per_velocity;
        let label = product([factor(&coefficient, self.symbolic(&coefficient)), power]);
        Some(Labelled { label, value: Some([-size * x, -size * y]) })
    }

    fn force(&self, compass: &Compass, force: &ActingForce) -> Option<Moving> {
        let clock = self.model().symbols.find("t").filter(|clock| force.strength.contains(*clock));
        let told = force.strength.all_symbols(&|symbol| Some(symbol) == clock || self.value(symbol).is_some());
        let asked = self.asked(&force.strength);
        let is_asked = asked.is_some();
        let [x, y] = self.direction(&force.direction).filter(|_| told || is_asked)?;
        // A force that changes has no one length; its arrow shows where it points.
        let (label, size) = match clock {
            Some(_) => {
                let [start, end] = force.during.each_ref().map(|end| self.evaluate(end));
                // Where nobody may know since when it counts, all its time is looked at.
                let during = if let Some(start) = start { (start, end) } else { (0.0, end) };
                (Math::Identifier("F".to_owned()), self.sense(&force.strength, during)?.signum())
            }
            None => match asked {
                Some(label) => (label, 1.0),
                None => (self.unsigned(&force.strength), self.evaluate(&force.strength)?),
            },
        };
        let vector = Labelled { label, value: Some([size * x, size * y]) };
        let moving = Moving::force(vector.placed(compass));
        let moving = if is_asked { moving.asked() } else { moving };
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
