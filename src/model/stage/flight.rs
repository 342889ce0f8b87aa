//! Free flight: velocities and places at the end from those at the start.

use crate::Because;
use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::QuantityKind;
use crate::Reason;
use crate::incline::Fall;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::kinematics;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::Stage;
use momentous_scene::Term;
use momentous_scene::stage::Flight;
use momentous_scene::stage::Resistance;
use momentous_solve::Relation;

use super::resisted::Resisted;

impl Builder<'_> {
    pub(crate) fn flight(&mut self, index: usize, stage: &Flight, path: &Path) {
        let time = self.flight_time(index, stage);
        self.lasting[index] = Some(time.clone());
        let bodies: Vec<&str> = stage.flying().collect();
        let falls = match &stage.incline {
            Some(_) => self.falling(index, stage.incline.as_ref(), path).unwrap_or_default(),
            None => Vec::new(),
        };
        match (&stage.resistance, &bodies[..]) {
            (None, _) => {
                for body in &bodies {
                    self.free_motion(index, body, &time, &falls);
                }
            }
            (Some(Resistance::Linear(term)), [body]) => {
                let resists = self.linear_resistance(term, &path.key("resistance"));
                self.resisted_motion(index, body, &time, &falls, &resists);
            }
            (Some(Resistance::Quadratic(_)), _) => {
                let message = "a flight against a resistance in proportion to the square of the speed has no formula";
                let help = "along a vertical line write the rise and the fall as a `push` each, with `forces: []`; in a plane take a `linear` one";
                self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("resistance")));
            }
            (Some(Resistance::Linear(_)), _) => {
                let fault = Fault::new(Code::Value, "a `resistance` in a flight needs a single body");
                let help = "write `body: A`, and a flight of its own for each body";
                self.faults.push(fault.help(help).at_path(path.key("resistance")));
            }
        }
        if let Some(until) = &stage.until {
            self.end_of_flight(index, &bodies, until, &|_| None, &path.key("until"));
        }
        match self.scene.plane {
            Plane::Vertical if stage.is_free() => self.neglect("air resistance", "the problem gives none"),
            Plane::Horizontal if stage.is_free() => self.neglect("friction", "the problem gives none"),
            Plane::Vertical | Plane::Horizontal => {}
        }
    }

    /// The time for which a flight lasts.
    pub(crate) fn flight_time(&mut self, index: usize, stage: &Flight) -> Expr {
        let meaning = format!("the duration of {}", self.stage_phrase(index));
        let path = Path::root().key("scene").key("stages").index(index).key("flight").key("during");
        match &stage.during {
            Some(term) => self.read_positive(term, Dimension::TIME, &meaning, &path),
            None => self.positive(self.in_stage(QuantityKind::Duration, "", index), meaning).into(),
        }
    }

    /// The acceleration along the axis of that position, where there is one.
    fn accelerates(&mut self, position: usize, falls: &[Fall]) -> Option<Expr> {
        match falls.get(position) {
            Some(Fall::Towards { acceleration, .. } | Fall::Along(acceleration)) => {
                (!acceleration.is_zero()).then(|| acceleration.clone())
            }
            None => Some(Expr::integer(self.downwards(position)?) * self.gravity()),
        }
    }

    /// The weight of a body along each axis.
    fn pulls_along(&mut self, body: &str, falls: &[Fall]) -> Vec<Expr> {
        let accelerations: Vec<Option<Expr>> =
            (0..self.axes.len()).map(|position| self.accelerates(position, falls)).collect();
        let mass = self.mass(body);
        let pull = |acceleration: Option<Expr>| {
            acceleration.map_or_else(Expr::zero, |acceleration| mass.clone() * acceleration)
        };
        accelerations.into_iter().map(pull).collect()
    }

    /// Velocity and place of one body at the end.
    fn free_motion(&mut self, index: usize, body: &str, time: &Expr, falls: &[Fall]) {
        let name = self.called(body);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let mut weight = Vec::new();
        for (position, axis) in axes.iter().enumerate() {
            let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, *axis));
            let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, *axis));
            let along = if axes.len() > 1 { format!(" along {}", axis.letter()) } else { String::new() };
            let Some(gravity) = self.accelerates(position, falls) else {
                let because = format!("no force acts on {name}{along}");
                self.law(&momentous_laws::momentum::NO_IMPULSE, Some(index), because.clone(), (after, before.clone()));
                let sides = kinematics::uniform(&from, &before, time, &to);
                self.law(&kinematics::UNIFORM, Some(index), because, sides);
                weight.push(Expr::zero());
                continue;
            };
            let because = format!("weight is the only force on {name} in {}", self.stage_phrase(index));
            let gained = gravity.clone() * time.clone();
            self.law(
                &kinematics::FALL_TIME,
                Some(index),
                because.clone(),
                (after.clone(), before.clone() + gained.clone()),
            );
            let sides = kinematics::accelerated(&from, &before, &gravity, time, &to);
            self.law(&kinematics::FLIGHT_PLACE, Some(index), because.clone(), sides);
            let sides = kinematics::flight_speed(&gravity, [&from, &to], &before, &after);
            self.law(&kinematics::FLIGHT_SPEED, Some(index), because, sides);
            weight.push(self.mass(body) * gained);
        }
        if self.scene.plane == Plane::Vertical || !falls.is_empty() {
            let pulls = self.pulls_along(body, falls);
            let weight_acts = Influence::outside(index, body, "weight").force(pulls);
            self.acts(weight_acts.works(Effect::Open, "weight does work as the height changes"));
            self.note_impulse(index, body, "weight", weight);
        }
    }

    /// Velocity and place of one body at the end, where something resists its motion in proportion to the speed.
    fn resisted_motion(&mut self, index: usize, body: &str, time: &Expr, falls: &[Fall], resists: &Expr) {
        let (clock, zero) = (self.running_time(), Expr::zero());
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let steady = self.pulls_along(body, falls);
        for (axis, steady) in axes.into_iter().zip(steady) {
            let after = self.velocity(body, index + 2, axis);
            let [from, to] = [index + 1, index + 2].map(|instant| self.place(body, instant, axis));
            let (during, moved) = ([&zero, time], to - from);
            self.resisted(&Resisted { index, body, axis, steady, resists, clock, during, moved, after });
        }
        self.acts(Influence::outside(index, body, "the resistance"));
        self.note_impulse_of_all(index, body, Vec::new());
    }

    /// The conditions at the end: the top of the path, or a place; `moved` says where a body then is, if that is to be put in.
    pub(crate) fn end_of_flight(
        &mut self,
        index: usize,
        bodies: &[&str],
        until: &Term,
        moved: &dyn Fn(Symbol) -> Option<Expr>,
        path: &Path,
    ) {
        let text = until.0.trim();
        if text == "top" {
            let upright = (0..self.axes.len()).find(|position| self.downwards(*position).is_some());
            let axis = upright.and_then(|position| Some(self.axes.get(position)?.0));
            for (body, axis) in bodies.iter().zip(axis) {
                let velocity = self.velocity(body, index + 2, axis);
                self.law(&kinematics::TOP, Some(index), Because::Definition, (velocity, Expr::zero()));
            }
            return;
        }
        let Some((left, right)) = text.split_once('=') else {
            let fault = Fault::new(Code::Syntax, format!("`{text}` does not say when a flight ends"));
            let help = "write `top`, or an equation for the positions at that instant, such as `y = 0 m` or `x_A = d`";
            self.faults.push(fault.help(help).at_path(path.clone()));
            return;
        };
        let [end, start] = [index + 2, index + 1].map(|instant| {
            let [left, right] = [left, right].map(|side| self.places_in(side, instant, bodies));
            (left, right)
        });
        let mut sides = (self.read_any(&end.0, path), self.read_any(&end.1, path));
        sides = (sides.0.substitute(moved), sides.1.substitute(moved));
        let mut because = format!("the problem says where {} ends", self.stage_phrase(index));
        if self.began_there(index, bodies, until) {
            // The way from the line back to it, so that the root at which it has not left yet drops out exactly.
            sides = (sides.0 - self.read_any(&start.0, path), sides.1 - self.read_any(&start.1, path));
            because = format!("{because}, and it began there");
        }
        if let Some(time) = self.lasting.get(index).cloned().flatten() {
            let phrase = self.stage_phrase(index);
            self.require(time.clone(), Relation::AtLeast, Expr::zero(), Reason::EndsEarly(phrase.clone()));
            let reason = Reason::TakesTime(phrase);
            self.require(time, Relation::Greater, Expr::zero(), reason);
        }
        self.law(&kinematics::UNTIL, Some(index), because, sides);
    }

    /// Whether the flight before ended by the same condition, and the bodies are still there.
    fn began_there(&self, index: usize, bodies: &[&str], until: &Term) -> bool {
        bodies.iter().all(|body| {
            let (body, since) = self.place_since(body, index + 1);
            let before = since.checked_sub(2).and_then(|before| self.scene.stages.get(before));
            matches!(before, Some(Stage::Flight(flight))
                if flight.until.as_ref().is_some_and(|end| end.0.trim() == until.0.trim()) && flight.flying().any(|flying| flying == body))
        })
    }

    /// A text with the names `x`, `y_A` of places replaced by the names that they have at an instant.
    fn places_in(&mut self, text: &str, instant: usize, bodies: &[&str]) -> String {
        let is_of_name = |letter: char| letter.is_alphanumeric() || letter == '_';
        let mut written = String::new();
        let mut rest = text;
        while let Some(start) = rest.find(is_of_name) {
            let end = rest[start..].find(|letter| !is_of_name(letter)).map_or(rest.len(), |length| start + length);
            let word = &rest[start..end];
            written.push_str(&rest[..start]);
            written.push_str(&self.place_name(word, instant, bodies).unwrap_or_else(|| word.to_owned()));
            rest = &rest[end..];
        }
        written + rest
    }

    fn place_name(&mut self, word: &str, instant: usize, bodies: &[&str]) -> Option<String> {
        let (letter, body) = word.split_once('_').unwrap_or((word, ""));
        let axis = self.axes.iter().map(|(axis, _)| *axis).find(|axis| axis.letter() == letter)?;
        let body = match bodies {
            [only] if body.is_empty() => only,
            _ => bodies.iter().find(|flying| **flying == body)?,
        };
        let Expr::Symbol(place) = self.place(body, instant, axis) else { return None };
        Some(self.symbols.entry(place).name.clone())
    }
}
