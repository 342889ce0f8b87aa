//! Motions given as functions: what the velocity is at both ends, how far the body moves, and what acts on it.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Integral;
use crate::Name;
use crate::QuantityKind;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::force;
use momentous_laws::momentum;
use momentous_laws::motion;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::stage::Motion;

/// One component of a motion.
struct Course {
    axis: Axis,
    /// The velocity as a function of `variable`.
    velocity: Expr,
    /// The place as a function of the time, where that is given.
    place: Option<Expr>,
    variable: Symbol,
    /// Whether the variable is the place.
    by_place: bool,
}

impl Builder<'_> {
    pub(crate) fn motion(&mut self, index: usize, stage: &Motion, path: &Path) {
        let clock = self.running_time();
        let times = match &stage.during {
            Some(during) => self.duration(index, during, &path.key("during")).into(),
            None => [Expr::zero(), self.stage_duration(index, None, path)],
        };
        let lasts = (times[1].clone() - times[0].clone()).simplify();
        self.lasting[index] = Some(lasts.clone());
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let (mut components, mut acting, mut net, mut power) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for axis in axes.iter().copied() {
            let Some(course) = self.course(stage, axis, clock, path) else { return };
            let ends = if course.by_place {
                [index + 1, index + 2].map(|instant| self.place(&stage.body, instant, axis))
            } else {
                times.clone()
            };
            self.velocities_told(index, stage, &course, &ends);
            self.way_told(index, stage, &course, &ends, &lasts);
            let rate = course.velocity.differentiate(course.variable);
            let rate = if course.by_place { rate * course.velocity.clone() } else { rate }.simplify();
            let force = self.mass(&stage.body) * rate;
            power.push(force.clone() * course.velocity.clone());
            net.push(force.simplify());
            let impulse = self.impulse_of_all(index, &stage.body, axis, &lasts);
            // Along an axis along which the velocity stays the same, the forces have no impulse together.
            acting.push(if course.velocity.contains(course.variable) { impulse.clone() } else { Expr::zero() });
            components.push(impulse);
        }
        if axes.len() > 1 {
            let meaning = format!("the impulse on {}", self.called(&stage.body));
            self.resultant(index, &stage.body, &components, &meaning);
        }
        let force = Influence::outside(index, &stage.body, "the net force").force(net);
        self.acts(force.works(Effect::Of(Expr::sum(power).simplify()), ""));
        self.note_impulse_of_all(index, &stage.body, acting);
    }

    /// Reads the course that is given along an axis.
    fn course(&mut self, stage: &Motion, axis: Axis, clock: Symbol, path: &Path) -> Option<Course> {
        let letter = axis.letter();
        let along = if self.axes.len() > 1 { format!(" along {letter}") } else { String::new() };
        let number = self.axes.len();
        let [velocity, place] = [&stage.velocity, &stage.position]
            .map(|course| course.as_ref().and_then(|course| course.along(axis, number)));
        match (velocity, place) {
            (Some(term), None) => {
                let by_place = number == 1 && term.mentions(letter);
                let coordinate = Name::of(QuantityKind::Coordinate(axis), "");
                let variable = if by_place { self.symbol(coordinate, "the position") } else { clock };
                let meaning = format!("the velocity{along}");
                let velocity = self.read(term, Dimension::VELOCITY, &meaning, &path.key("velocity"));
                if by_place && velocity.contains(clock) {
                    let fault = Fault::new(Code::Value, "a velocity cannot be a function of both time and position");
                    let help = format!("write it in `t` or in `{letter}`");
                    self.faults.push(fault.help(help).at_path(path.key("velocity")));
                    return None;
                }
                Some(Course { axis, velocity, place: None, variable, by_place })
            }
            (None, Some(term)) => {
                let meaning = format!("the position{along}");
                let place = self.read(term, Dimension::LENGTH, &meaning, &path.key("position"));
                let velocity = place.differentiate(clock).simplify();
                Some(Course { axis, velocity, place: Some(place), variable: clock, by_place: false })
            }
            (told, _) => {
                let message = match told {
                    Some(_) => format!("the motion{along} is given twice, by its velocity and by its position"),
                    None => format!("the motion{along} is not given"),
                };
                let help = match number {
                    1 => "write `velocity` or `position`: `velocity: b*t`",
                    _ => "write one of them with every axis: `velocity: { x: b*t, y: v_0 }`",
                };
                self.faults.push(Fault::new(Code::MissingKey, message).help(help).at_path(path.clone()));
                None
            }
        }
    }

    /// Velocity, acceleration and net force at both ends.
    fn velocities_told(&mut self, index: usize, stage: &Motion, course: &Course, ends: &[Expr; 2]) {
        let (name, body) = (self.called(&stage.body), stage.body.as_str());
        let mass = self.mass(body);
        let along = self.along(course.axis);
        let whose = |kind, instant| Name::of(kind, body).at(instant).along(self.letter(course.axis));
        let names = [index + 1, index + 2]
            .map(|instant| [QuantityKind::Acceleration, QuantityKind::Force].map(|kind| whose(kind, instant)));
        let rate = course.velocity.differentiate(course.variable);
        let rate = if course.by_place { rate * course.velocity.clone() } else { rate }.simplify();
        let at = |term: &Expr, end: &Expr| {
            let value = term.substitute(&|symbol| (symbol == course.variable).then(|| end.clone()));
            if end.is_zero() { value.simplify() } else { value }
        };
        let follows = self.scene.follows_a_push(index, body);
        let variable = if course.by_place { "position" } else { "time" };
        for ((instant, end), [acceleration, force]) in [index + 1, index + 2].into_iter().zip(ends).zip(names) {
            let when = self.when(instant);
            if let Some(place) = &course.place {
                let end_place = self.place(body, instant, course.axis);
                let because = format!("the problem gives the position of {name} as a function of time");
                self.law(&motion::PLACE, Some(index), because, (end_place, at(place, end)));
            }
            let because = match &course.place {
                Some(_) => format!("the velocity of {name} is the rate of change of the position"),
                None => format!("the problem gives the velocity of {name} as a function of {variable}"),
            };
            let velocity = self.velocity(body, instant, course.axis);
            self.law(&motion::VELOCITY, Some(index), because, (velocity, at(&course.velocity, end)));
            if follows && instant == index + 1 {
                continue;
            }
            let meaning = format!("the acceleration of {name}{along} {when}");
            let acceleration = Expr::from(self.symbol(acceleration, meaning));
            let with = if course.by_place { "the position" } else { "the time" };
            let because = format!("the velocity of {name} depends on {with}");
            self.law(&motion::ACCELERATION, Some(index), because, (acceleration.clone(), at(&rate, end)));
            let meaning = format!("the net force on {name}{along} {when}");
            let force = self.symbol(force, meaning);
            let because = format!("the net force on {name} accelerates it");
            self.law(&motion::NET_FORCE, Some(index), because, motion::net_force(&mass, &acceleration, &force.into()));
        }
    }

    /// How far the body moves, or how long its way takes, where the rules of integration find it.
    fn way_told(&mut self, index: usize, stage: &Motion, course: &Course, [low, high]: &[Expr; 2], lasts: &Expr) {
        let name = self.called(&stage.body);
        if course.place.is_some() {
            return;
        }
        let integrand =
            if course.by_place { course.velocity.clone().powi(-1).simplify() } else { course.velocity.clone() };
        let Some(value) = integrand.definite(course.variable, low, high) else { return };
        let (low, high) = (low.clone(), high.clone());
        let integral = Integral { integrand, variable: course.variable, low, high };
        if course.by_place {
            let because = format!("the velocity of {name} is given as a function of position");
            self.integral(&motion::TIME_OF_WAY, index, because, (lasts.clone(), value.simplify()), integral);
        } else {
            let ends = [index + 1, index + 2].map(|instant| self.place(&stage.body, instant, course.axis));
            let [from, to] = ends;
            let because = format!("the velocity of {name} is given as a function of time");
            self.integral(&motion::DISPLACEMENT, index, because, (to - from, value.simplify()), integral);
        }
    }

    /// The impulse of all forces along an axis, and its mean.
    pub(super) fn impulse_of_all(&mut self, index: usize, body: &str, axis: Axis, lasts: &Expr) -> Expr {
        let name = self.called(body);
        let (mass, along, phrase) = (self.mass(body), self.along(axis), self.stage_phrase(index));
        let [impulse, mean] = [QuantityKind::Impulse, QuantityKind::MeanForce]
            .map(|kind| self.in_stage(kind, body, index).along(self.letter(axis)));
        let [before, after] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        let meaning = format!("the impulse on {name}{along} during {phrase}");
        let impulse = Expr::from(self.symbol(impulse, meaning));
        let because = format!("the impulse of all forces on {name} is the change of momentum{along}");
        let sides = momentum::impulse_momentum(&mass, &before, std::slice::from_ref(&impulse), &after);
        self.law(&momentum::IMPULSE_MOMENTUM, Some(index), because, sides);
        let meaning = format!("the average net force on {name}{along} during {phrase}");
        let mean = Expr::from(self.symbol(mean, meaning));
        let because = "the average force would give the same impulse in the same time";
        self.law(&force::MEAN_FORCE, Some(index), because, force::mean_force(&impulse, &mean, lasts));
        impulse
    }
}
