//! Speed and direction of a body, related to whichever components its velocity has.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_laws::geometry;

use super::super::Because;
use super::super::Builder;
use super::super::Name;
use super::super::QuantityKind;
use super::super::VectorKind;
use super::super::builder::SECOND_COST;
use super::super::stage::Description;
use super::velocity::polar_velocity;

pub(super) fn speed(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let (body, instant) = builder.body_at(name)?;
    Some(builder.speed_and_angle(&body, instant).0)
}

pub(super) fn angle(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let (body, instant) = builder.body_at(name)?;
    (builder.axes.len() == 2).then(|| builder.speed_and_angle(&body, instant).1)
}

impl Builder<'_> {
    /// Speed and direction of a body, related to whichever components it has.
    fn speed_and_angle(&mut self, body: &str, instant: usize) -> (Symbol, Symbol) {
        let (owner, when) = (self.called(body), self.when(instant));
        let speed =
            self.positive(Name::of(QuantityKind::Speed, body).at(instant), format!("the speed of {owner} {when}"));
        let meaning = format!("the direction of motion of {owner} {when}");
        let angle = self.symbol(Name::of(QuantityKind::Direction(VectorKind::Velocity), body).at(instant), meaning);
        if !self.defined.insert(format!("speed {body}{instant}")) {
            return (speed, angle);
        }
        let (speed_expr, angle_expr) = (Expr::from(speed), Expr::from(angle));
        let components = match self.axes.len() {
            0 => ["r", "theta"]
                .map(|letter| polar_velocity(self, body, instant, letter))
                .into_iter()
                .flatten()
                .map(Expr::from)
                .collect(),
            _ => self.velocities(body, instant),
        };
        let squares = Expr::sum(components.iter().map(|component| component.clone().powi(2)));
        match &components[..] {
            [only] => {
                let value = Expr::apply(Function::Abs, only.clone());
                let because = if self.turns(body, instant) {
                    Because::Fact(format!("{owner} moves at right angles to the radius"))
                } else {
                    Because::Definition
                };
                self.law(&geometry::SPEED, None, because, (speed_expr, value));
            }
            [] => {}
            several => {
                if let ([x, y], 2) = (several, self.axes.len()) {
                    for sides in geometry::components(&speed_expr, &angle_expr, x, y) {
                        self.law(&geometry::COMPONENTS, None, "the velocity is resolved along the axes", sides);
                    }
                }
                self.law_at(
                    SECOND_COST,
                    &geometry::MAGNITUDE,
                    None,
                    "the components of the velocity are perpendicular",
                    (speed_expr.clone(), squares.sqrt()),
                );
                if let ([x, y], 2) = (several, self.axes.len())
                    && !self.turned_speed(body, instant, &speed_expr, &angle_expr)
                {
                    self.directions.insert(angle, [x.clone(), y.clone()]);
                }
            }
        }
        (speed, angle)
    }

    /// Speed and direction against components along and across a line of impact; whether they follow from those.
    fn turned_speed(&mut self, body: &str, instant: usize, speed: &Expr, angle: &Expr) -> bool {
        let mut follows = false;
        for stage in [instant.checked_sub(1), instant.checked_sub(2)].into_iter().flatten() {
            let Some(Some(frame)) = self.frames.get(stage).cloned() else { continue };
            if frame.normal.turn.is_zero() || !self.takes_part(stage, body) {
                continue;
            }
            let split = self.split(body, instant, stage, &frame);
            let Some(across) = split.across else { continue };
            let line = self.whole_angle(&frame.normal);
            let from_line = angle.clone() - line.clone();
            let because = "the velocity is resolved along and across the line of impact";
            if self.is_given(body, instant) {
                for sides in geometry::components(speed, &from_line, &split.along, &across) {
                    self.law(&geometry::COMPONENTS, Some(stage), because, sides);
                }
                continue;
            }
            let squares = Expr::sum([split.along.clone().powi(2), across.clone().powi(2)]);
            let because = "the components of the velocity are perpendicular";
            self.law(&geometry::MAGNITUDE, Some(stage), because, (speed.clone(), squares.sqrt()));
            let direction = line + across.atan2(split.along);
            let because = "the components give the angle to the line of impact, which is added to that of the line";
            self.law(&geometry::DIRECTION, Some(stage), because, (angle.clone(), direction));
            follows = true;
        }
        follows
    }

    /// Whether a body moves round a point before or after an instant.
    fn turns(&self, body: &str, instant: usize) -> bool {
        let neighbours = [instant.checked_sub(1), instant.checked_sub(2)].into_iter().flatten();
        let stages = neighbours.filter_map(|stage| self.scene.stages.get(stage));
        stages.map(|stage| Description::of(self.scene, stage)).any(|description| {
            description.about.is_some() && description.bodies.iter().any(|(named, _)| *named == body)
        })
    }

    pub(super) fn takes_part(&self, stage: usize, body: &str) -> bool {
        self.impulses.iter().any(|impulse| impulse.stage == stage && impulse.on == body)
    }

    /// Whether the speed or the direction of a body is given, so that components follow from it rather than the reverse.
    fn is_given(&self, body: &str, instant: usize) -> bool {
        let kinds = [QuantityKind::Speed, QuantityKind::Direction(VectorKind::Velocity)];
        kinds.into_iter().any(|kind| self.given.contains(&Name::of(kind, body).at(instant).to_string()))
    }
}
