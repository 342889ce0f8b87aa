//! The force of a steady stream on a body.

use crate::Because;
use crate::Builder;
use crate::Flowing;
use crate::Influence;
use crate::QuantityKind;
use crate::Reason;
use crate::Shown;
use crate::VectorKind;
use crate::builder::SECOND_COST;
use crate::frame::Direction;
use crate::name::Meaning;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::geometry;
use momentous_laws::kinematics;
use momentous_laws::variable_mass;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_scene::Term;
use momentous_scene::stage::Stream;
use momentous_solve::Relation;

use super::stream_goes_on::Way;
use super::thrust::FLOW;

impl Builder<'_> {
    pub(crate) fn stream(&mut self, index: usize, stage: &Stream, path: &Path) {
        let (body, by) = (stage.body.as_str(), stage.by.as_str());
        let name = self.called(body);
        let direction = match &stage.direction {
            Some(term) => self.direction(term, &path.key("direction")),
            None => self.first_axis(),
        };
        let Some(speed) = self.stream_speed(index, stage, path) else { return };
        let moves = stage.moves.as_ref().map(|term| {
            self.read(term, Dimension::VELOCITY, &format!("the speed of {name} along the stream"), &path.key("moves"))
        });
        let relative = match &moves {
            Some(moves) => speed.clone() - moves.clone(),
            None => speed.clone(),
        };
        let arriving = if stage.series { &speed } else { &relative };
        let Some(flow) = self.stream_flow(index, stage, arriving, path) else { return };
        // Sand that is put down on a belt has no velocity along it, but arrives.
        if stage.flow.is_none() || !stage.stays {
            let reason = Reason::NotReached(by.to_owned(), name.clone());
            self.require(arriving.clone(), Relation::Greater, Expr::zero(), reason);
        }
        let (leaving, back) = self.stream_leaves(stage, &direction, path);
        let normal = self.surface_in_stream(stage, &direction, path);
        let way = match (&leaving, &normal) {
            (Some(leaving), _) => Way::Turned(leaving),
            (None, Some(normal)) => Way::Along(normal, &back),
            (None, None) => Way::Straight(&back),
        };
        let (cause, parts) = (why(stage, &name), self.parts(&direction, &way));
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let left = parts.iter().map(|[_, after, _]| after.clone()).collect();
        let mut forces = Vec::new();
        for (axis, [before, after, change]) in axes.iter().zip(parts) {
            let meaning = Meaning { noun: "the force", of: format!("of {by} on {name}") };
            let force = self.in_stage(QuantityKind::Force, body, index).along(self.letter(*axis));
            let force = Expr::from(self.component(force, meaning));
            let carries = |part: Expr| Expr::product([flow.clone(), relative.clone(), part]);
            let sides = (force.clone(), carries(change));
            self.law(&variable_mass::STREAM, Some(index), cause.clone(), sides);
            self.shows(Shown::Balance([carries(before) - force.clone(), carries(after)]));
            forces.push(force);
        }
        self.stream_follows(index, stage, &forces, moves.as_ref(), &direction);
        let caught = self.caught(stage, &flow, path);
        self.stream_support(index, stage, caught.as_ref(), &forces);
        let rests = speed.is_zero();
        self.flowing.push(Flowing { stage: index, speed, direction, leaving, normal, relative, after: left, caught });
        self.acts(Influence::outside(index, body, by).force(forces.clone()));
        // The body keeps its velocity, so something holds it.
        let held = forces.iter().map(|force| -force.clone()).collect();
        self.acts(Influence::outside(index, body, format!("what holds {name}")).force(held));
        self.note_impulse(index, body, by, Vec::new());
        // Friction may be what carries along a stream that stays.
        if !stage.stays {
            self.neglect("friction between the stream and the body", "the problem gives none");
        }
        // What lies at rest before it is taken along is carried by what it lies on.
        if stage.drop.is_none() && !rests && self.weight_has_a_component() {
            self.neglect(
                format!("the weight of {by} before it arrives"),
                "it is small compared with the forces of the stream",
            );
        }
    }

    /// The speed with which the stream meets the place of the body.
    fn stream_speed(&mut self, index: usize, stage: &Stream, path: &Path) -> Option<Expr> {
        let meaning = format!("the speed of {}", stage.by);
        match (&stage.speed, &stage.drop) {
            (Some(term), None) => {
                let speed = self.read(term, Dimension::VELOCITY, &meaning, &path.key("speed"));
                Some(self.zero_if_so_written(speed))
            }
            (None, Some(term)) => {
                let meaning_of_drop = format!("the height through which {} falls", stage.by);
                let drop = self.read_positive(term, Dimension::LENGTH, &meaning_of_drop, &path.key("drop"));
                let speed = Expr::from(self.positive(self.in_stage(QuantityKind::StreamVelocity, "", index), meaning));
                let gravity = self.gravity();
                let sides = kinematics::fall_speed(&gravity, &drop, &Expr::zero(), &speed);
                let because = format!("{} falls freely from rest", stage.by);
                self.law(&kinematics::FALL_SPEED, Some(index), because, sides);
                Some(speed)
            }
            _ => {
                let fault = Fault::new(Code::MissingKey, "a stream needs either its speed or the height of its fall");
                self.faults.push(fault.help("write `speed: v` or `drop: h`").at_path(path.clone()));
                None
            }
        }
    }

    /// The mass that reaches the body in each unit of time.
    fn stream_flow(&mut self, index: usize, stage: &Stream, arriving: &Expr, path: &Path) -> Option<Expr> {
        let name = self.called(&stage.body);
        let meaning = format!("the mass of {} that reaches {name} per unit time", stage.by);
        let read = |builder: &mut Self, term: &Term, dimension, meaning: &str, key: &str| {
            builder.read_positive(term, dimension, meaning, &path.key(key))
        };
        let by = &stage.by;
        let cross = match (&stage.flow, &stage.density, &stage.area, &stage.per_length) {
            (Some(term), None, None, None) => return Some(read(self, term, FLOW, &meaning, "flow")),
            (None, Some(density), Some(area), None) => {
                let density = read(self, density, Dimension::new(1, -3, 0), &format!("the density of {by}"), "density");
                let area = read(self, area, Dimension::new(0, 2, 0), &format!("the cross-section of {by}"), "area");
                density * area
            }
            (None, None, None, Some(line)) => {
                let meaning = format!("the mass of {by} per unit length");
                read(self, line, Dimension::new(1, -1, 0), &meaning, "per_length")
            }
            _ => {
                let fault =
                    Fault::new(Code::MissingKey, "the mass flow of the stream must be given in exactly one way");
                let help = "write `flow`, or `density` and `area`, or `per_length`";
                self.faults.push(fault.help(help).at_path(path.clone()));
                return None;
            }
        };
        let flow = Expr::from(self.positive(self.in_stage(QuantityKind::MassFlow, &stage.body, index), meaning));
        let because = match (&stage.moves, stage.series) {
            (Some(_), true) => format!("none of {by} passes between them, since they follow each other closely"),
            (Some(_), false) => {
                format!("{by} comes to {name} with the difference of their velocities")
            }
            (None, _) => format!("all of {by} reaches {name}"),
        };
        let sides = (flow.clone(), cross * arriving.clone());
        self.law(&variable_mass::FLOW, Some(index), because, sides);
        Some(flow)
    }

    /// Magnitude and direction, what holds the body against the stream, and its power.
    fn stream_follows(
        &mut self,
        index: usize,
        stage: &Stream,
        forces: &[Expr],
        moves: Option<&Expr>,
        direction: &Direction,
    ) {
        let name = self.called(&stage.body);
        let named = |kind| self.in_stage(kind, &stage.body, index);
        let [size, angle, hold, power] = [
            QuantityKind::Force,
            QuantityKind::Direction(VectorKind::Force),
            QuantityKind::HoldingForce,
            QuantityKind::Power,
        ]
        .map(named);
        if let [x, y] = forces {
            let meaning = format!("the magnitude of the force of {} on {name}", stage.by);
            let size = Expr::from(self.positive(size, meaning));
            let meaning = format!("the direction of the force of {} on {name}", stage.by);
            let angle = Expr::from(self.symbol(angle, meaning));
            for sides in geometry::components(&size, &angle, x, y) {
                let because = "the force is resolved along the axes";
                self.law_at(SECOND_COST, &geometry::COMPONENTS, Some(index), because, sides);
            }
            let squares = Expr::sum([x.clone().powi(2), y.clone().powi(2)]);
            let because = "the components of the force are perpendicular";
            self.law(&geometry::MAGNITUDE, Some(index), because, (size, squares.sqrt()));
            let sides = (angle, y.clone().atan2(x.clone()));
            self.law(&geometry::DIRECTION, Some(index), "the components give the direction", sides);
        }
        if let [force] = forces {
            let meaning = match moves {
                Some(_) => format!("the force that keeps {name} going in spite of {}", stage.by),
                None => format!("the force that holds {name} against {}", stage.by),
            };
            let hold = Expr::from(self.symbol(hold, meaning));
            let fact = match moves {
                Some(_) => format!("{name} moves at constant velocity"),
                None => format!("{} at rest", self.does(&stage.body, ["is", "are"])),
            };
            let because = Because::Conclusion(fact, "the forces on it balance".to_owned());
            self.law(&momentous_laws::force::BALANCE, Some(index), because, (hold, -force.clone()));
        }
        let Some(moves) = moves else { return };
        let along =
            Expr::sum(self.components(direction).into_iter().zip(forces).map(|(part, force)| part * force.clone()));
        let meaning = format!("the power of the force of {} on {name}", stage.by);
        let power = Expr::from(self.symbol(power, meaning));
        let because = match forces.len() {
            1 => format!("{name} moves along the line of the force of {}", stage.by),
            _ => format!("only the part of the force of {} along the motion of {name} does work", stage.by),
        };
        self.law(&variable_mass::POWER, Some(index), because, (power, along * moves.clone()));
    }

    /// The mass that a body has caught of a stream that stays: what flowed in a time, or what is told.
    fn caught(&mut self, stage: &Stream, flow: &Expr, path: &Path) -> Option<Expr> {
        let name = self.called(&stage.body);
        match (&stage.during, &stage.caught) {
            _ if !stage.stays => None,
            (Some(term), None) => {
                let meaning = format!("the time for which {} flowed", stage.by);
                Some(flow.clone() * self.read_positive(term, Dimension::TIME, &meaning, &path.key("during")))
            }
            (None, Some(term)) => {
                let meaning = format!("the mass that {name} has caught");
                let caught = self.read(term, Dimension::MASS, &meaning, &path.key("caught"));
                Some(self.zero_if_so_written(caught))
            }
            _ => None,
        }
    }

    /// The kinetic energy that a body and a stream lose together as the stream comes to rest on it.
    pub(crate) fn lost_in_stream(&mut self, index: usize) -> Option<Symbol> {
        let flowing = self.flowing.iter().find(|flowing| flowing.stage == index).cloned()?;
        let Some(Stage::Stream(stage)) = self.scene.stages.get(index) else { return None };
        let Some(caught) = flowing.caught else {
            let path = Path::root().key("scene").key("stages").index(index).key("stream");
            let message =
                format!("how much of {} has arrived is not told, so that its loss of energy is not known", stage.by);
            let help = "write `stays: true` with `during: T` or `caught: m`; of a stream that goes on, the loss depends on how it leaves";
            self.faults.push(Fault::new(Code::MissingKey, message).help(help).at_path(path));
            return None;
        };
        let meaning = format!("the kinetic energy lost in {}", self.stage_phrase(index));
        let symbol = self.symbol(self.in_stage(QuantityKind::EnergyLost, "", index), meaning);
        let fact = format!("seen from {}, what it catches comes to rest", self.called(&stage.body));
        let sides = (symbol.into(), energy::kinetic(&caught, &[flowing.relative]));
        self.law(&energy::LOSS, Some(index), fact, sides);
        Some(symbol)
    }

    /// The support of a body that catches a stream, where weight acts.
    fn stream_support(&mut self, index: usize, stage: &Stream, caught: Option<&Expr>, forces: &[Expr]) {
        let vertical = (0..self.axes.len()).find_map(|position| Some((position, self.downwards(position)?)));
        let Some((position, down)) = vertical.filter(|_| stage.stays) else { return };
        let (Some(force), name) = (forces.get(position), self.called(&stage.body)) else { return };
        let Some(caught) = caught.cloned() else { return };
        let mass = self.mass(&stage.body);
        let gravity = self.gravity();
        let meaning = format!("the force that supports {name}");
        let support = self.positive(self.in_stage(QuantityKind::NormalForce, &stage.body, index), meaning);
        let carried = (mass + caught) * gravity + Expr::integer(down) * force.clone();
        let because = match &stage.moves {
            Some(_) => format!("{name} moves at constant velocity while the mass of {} joins it", stage.by),
            None => format!("{name} stays at rest while the mass of {} comes to rest on it", stage.by),
        };
        self.law(&variable_mass::SUPPORT, Some(index), because, (support.into(), carried));
    }
}

/// Why the force is what it is.
fn why(stage: &Stream, name: &str) -> String {
    let by = &stage.by;
    format!("{}; the force on {by} is opposite to that on {name}", meets(stage, name))
}

/// The verb for what the body does with the stream.
fn meets(stage: &Stream, name: &str) -> String {
    let by = &stage.by;
    let frame = if stage.moves.is_some() { format!(", relative to {name},") } else { String::new() };
    match (&stage.turned, &stage.restitution, stage.stays) {
        (Some(_), ..) => format!("{name} is smooth and turns {by}{frame} without a change of speed"),
        (_, Some(e), _) if stage.normal.is_some() && !e.is_written_as_zero() => {
            format!("{name} is smooth and throws {by} back from its surface{frame} with the coefficient of restitution")
        }
        (_, Some(e), _) if !e.is_written_as_zero() => {
            format!("{name} throws {by} back{frame} with the speed of arrival times the coefficient of restitution")
        }
        (_, _, true) => format!("{by} comes to rest relative to {name}"),
        _ if stage.normal.is_some() => {
            format!(
                "{name} is smooth and lets {by} spread over it{frame}, so that nothing changes its momentum along the surface"
            )
        }
        _ => format!("{name} lets {by} spread over it and leave{frame} at right angles to the original direction"),
    }
}
