//! The slope of the floor on which a body moves along the one axis of a scene, or above which it flies.

use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_scene::Plane;
use momentous_scene::Term;
use momentous_solve::Relation;

use super::Builder;
use super::Reason;
use super::acting::Slope;
use super::frame::Direction;
use super::frame::above_or_below;

/// How the way of a body lies in space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Incline {
    /// The angle of the slope as the author named it; zero on the level and along a vertical.
    pub angle: Expr,
    /// Whether the positive axis rises (1) or falls (-1).
    pub sign: i64,
    /// The part of the weight along the slope, for each unit of weight: zero on the level.
    pub along: Expr,
    /// The part of the weight that presses the body into its floor, for each unit of weight.
    pub press: Expr,
}

impl Incline {
    fn level() -> Self {
        Self { angle: Expr::zero(), sign: 1, along: Expr::zero(), press: Expr::one() }
    }

    /// Whether weight has no part along the way.
    pub(super) fn is_level(&self) -> bool {
        self.along.is_zero()
    }

    /// The part of the weight against the positive axis, for each unit of weight.
    pub(super) fn rise(&self) -> Expr {
        Expr::integer(self.sign) * self.along.clone()
    }

    /// The direction of weight as seen along the axis, for a body on a floor.
    pub(super) fn downwards(&self) -> Direction {
        Direction::turned(3, (Expr::integer(-self.sign) * self.angle.clone()).simplify())
    }
}

/// The acceleration by weight along one axis of a body in the air.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Fall {
    /// It draws the body to the floor, along the axis (1) or against it (-1).
    Towards { acceleration: Expr, down: i64 },
    /// It has this part along the floor: zero where the floor is level.
    Along(Expr),
}

impl Builder<'_> {
    /// The slope that a stage states; without one the floor is level, or the axis of a vertical plane is vertical.
    pub(super) fn incline(&mut self, index: usize, term: Option<&Term>, path: &Path) -> Incline {
        let Some(term) = term else {
            return match self.downwards(0).filter(|_| self.axes.len() == 1) {
                Some(down) => Incline { angle: Expr::zero(), sign: -down, along: Expr::one(), press: Expr::zero() },
                None => Incline::level(),
            };
        };
        let path = &path.key("incline");
        if self.axes.len() != 1 {
            let fault = Fault::new(Code::Value, "an incline needs a scene with one axis, along the slope");
            let help = "leave one axis, such as `axes: { x: up the slope }`";
            self.faults.push(fault.help(help).at_path(path.clone()));
            return Incline::level();
        }
        let slope = self.slope(term, path);
        self.slopes.push(Slope { stage: index, angle: slope.angle.clone(), rises: slope.sign > 0 });
        slope
    }

    fn slope(&mut self, term: &Term, path: &Path) -> Incline {
        let (sign, angle) = self.incline_angle(term, path);
        let (along, press) = (angle.clone().sin().simplify(), angle.clone().cos().simplify());
        self.require(press.clone(), Relation::AtLeast, Expr::zero(), Reason::Overhangs);
        Incline { angle, sign, along, press }
    }

    /// The acceleration by weight along each axis of a body in the air: with an incline the first axis runs along the slope and
    /// the second away from it. A fault is noted where weight has no part in the scene.
    pub(super) fn falling(&mut self, index: usize, incline: Option<&Term>, path: &Path) -> Option<Vec<Fall>> {
        let gravity = self.gravity();
        if let Some(term) = incline {
            let path = &path.key("incline");
            if self.axes.len() != 2 {
                let fault = Fault::new(Code::Value, "a body in the air above a slope needs a scene with two axes");
                let help = "write `axes: { x: up the slope, y: away from the slope }`";
                self.faults.push(fault.help(help).at_path(path.clone()));
                return None;
            }
            let slope = self.slope(term, path);
            self.slopes.push(Slope { stage: index, angle: slope.angle.clone(), rises: slope.sign > 0 });
            let along = Fall::Along((-(gravity.clone() * slope.rise())).simplify());
            return Some(vec![along, Fall::Towards { acceleration: -(gravity * slope.press), down: -1 }]);
        }
        if self.scene.plane == Plane::Horizontal {
            let fault = Fault::new(Code::Value, "a body bounces repeatedly only if weight acts");
            self.faults.push(fault.help("write `plane: vertical` under `scene`").at_path(path.clone()));
            return None;
        }
        let falls = (0..self.axes.len()).map(|position| match self.downwards(position) {
            Some(down) => Fall::Towards { acceleration: Expr::integer(down) * gravity.clone(), down },
            None => Fall::Along(Expr::zero()),
        });
        Some(falls.collect())
    }

    /// Whether the positive axis rises or falls, and the angle of the slope.
    fn incline_angle(&mut self, term: &Term, path: &Path) -> (i64, Expr) {
        if let Some((_, above, _)) = above_or_below(&term.0) {
            let direction = self.direction(term, path);
            // What rises towards -x falls towards +x.
            let sign = if direction.quarters == 2 { -above } else { above };
            if let Some((_, senses)) = self.axes.first()
                && senses.climb().is_some_and(|climb| climb != sign)
            {
                let words = if sign > 0 { "rises" } else { "falls" };
                let message = format!("the axis points {}, and `{}` says that it {words}", senses.positive, term.0);
                let help = "give the angle alone: the axis says to which side the slope rises";
                self.faults.push(Fault::new(Code::OverDetermined, message).help(help).at_path(path.clone()));
            }
            return (sign, (Expr::integer(sign) * direction.turn).simplify());
        }
        let sign = self.axes.first().and_then(|(_, senses)| senses.climb());
        if sign.is_none() {
            let fault = Fault::new(Code::Value, "the side to which the floor rises is missing");
            let help = "write `alpha above +x` if it rises towards +x, `alpha below +x` if it falls";
            self.faults.push(fault.help(help).at_path(path.clone()));
        }
        (sign.unwrap_or(1), self.read_angle(&term.0, path))
    }
}
