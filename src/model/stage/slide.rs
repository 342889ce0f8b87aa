//! Sliding against friction and weight: over a distance by work and energy, over a time by impulse and momentum.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Opposing;
use crate::QuantityKind;
use crate::Reason;
use crate::forces::Acts;
use crate::incline::Incline;
use crate::speeds::Speeds;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::force;
use momentous_laws::geometry;
use momentous_laws::momentum;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::stage::Halt;
use momentous_scene::stage::Slide;
use momentous_scene::stage::UpOrDown;
use momentous_solve::Relation;

/// The retardation of a sliding body, for each unit of its mass; negative where weight drives it on.
struct Retardation {
    parts: Vec<Expr>,
    /// Why it is all that acts, as a clause.
    because: String,
}

impl Builder<'_> {
    pub(crate) fn slide(&mut self, index: usize, stage: &Slide, path: &Path) {
        let body = stage.body.as_str();
        if stage.on.is_some() {
            return self.slide_on(index, stage, path);
        }
        self.nothing_carries(stage.until, path);
        let name = self.called(body);
        let phrase = self.stage_phrase(index);
        let stops = stage.until == Some(Halt::Rest);
        let opposing = stage.friction.as_ref().map(|_| Opposing::Friction);
        let way = self.one_way(index, body, stage.direction.as_ref(), stops, opposing, path);
        if stage.height.is_none() {
            self.stays_on_a_level_floor(index, body);
            self.keeps_its_direction(index, body, &way);
        }
        let incline = self.incline(index, stage.incline.as_ref(), path);
        let friction = stage.friction.as_ref().map(|term| {
            self.rubs_on_a_floor(&incline, &path.key("friction"));
            self.read_positive(term, Dimension::NONE, "the coefficient of kinetic friction", &path.key("friction"))
        });
        self.way_fits(stage, &incline, way.sign, path);
        let distance = stage.distance.as_ref().map(|term| {
            let meaning = format!("how far {}", self.does(body, ["slides", "slide"]));
            self.read_positive(term, Dimension::LENGTH, &meaning, &path.key("distance"))
        });
        let duration = self.stage_duration(index, stage.duration.as_ref(), path);
        self.lasting[index] = Some(duration.clone());
        let height = stage.height.as_ref().map(|term| {
            let meaning = format!("the height between the two ends of {phrase}");
            self.read_positive(term, Dimension::LENGTH, &meaning, &path.key("height"))
        });
        if incline.is_level()
            && let Some(height) = &height
        {
            self.ramp(index, stage, &name, height, &way);
        } else {
            let told = distance.clone();
            // On a straight slope, the height tells how far it is.
            let distance = distance.or_else(|| Some(height.clone()? / incline.along.clone()));
            let retardation = self.retardation(&name, friction.as_ref(), &incline, &way);
            self.slowed((index, body), &retardation, distance.as_ref(), &duration, &way);
            if let Some(distance) = &distance {
                self.comes_evenly(index, &name, distance, [&way.before, &way.after], &duration);
            }
            if let Some(axis) = self.only_axis() {
                let along = |amount: &Expr| (Expr::integer(way.sign) * amount.clone()).simplify();
                self.moves_evenly((index, body), axis, [&along(&way.before), &along(&way.after)], &duration);
                if let Some(distance) = &distance {
                    self.comes_so_far((index, body), axis, along(distance), format!("{name} comes so far"));
                }
            }
            if let (Some(height), Some(distance)) = (height, told) {
                let sides = (height, distance * incline.along.clone());
                self.law(&geometry::HEIGHT_OF_SLOPE, Some(index), "the slope is straight", sides);
            }
        }
        self.slide_forces(index, stage, friction.as_ref(), &incline, &way, &duration);
        self.slide_impulse(index, stage, &incline);
        self.acts_as_noted(index);
        if stage.height.is_some() && incline.is_level() {
            let weight = Influence::outside(index, body, "weight");
            self.acts(weight.works(Effect::Open, "weight does work as the height changes"));
        }
        self.neglect("air resistance", "the problem gives none");
        if friction.is_none() {
            let track = if stage.incline.is_none() && stage.height.is_none() { "floor" } else { "slope" };
            self.neglect("friction", format!("the {track} is smooth"));
        }
    }

    /// Friction needs a slope that is told, and a slope tells whether the way leads up or down.
    fn way_fits(&mut self, stage: &Slide, incline: &Incline, sign: i64, path: &Path) {
        if stage.is_ramp() && stage.friction.is_some() {
            let message = "on a ramp of which only the height is told, the work of friction does not follow";
            let help = "write `incline: alpha above +x` with a `distance`, in place of the `height` or beside it; or remove `friction`";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("friction")));
        }
        let leads = if incline.sign * sign > 0 { UpOrDown::Up } else { UpOrDown::Down };
        if stage.way.is_some_and(|way| way != leads) && !incline.is_level() {
            let [one, other] = if leads == UpOrDown::Up { ["up", "down"] } else { ["down", "up"] };
            let message = format!("{} moves {one} this slope, and not {other}", self.called(&stage.body));
            let help = "leave `way` out; the `incline` and the `direction` of the motion tell it";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("way")));
        }
    }

    /// In a plane, a body on a level floor moves neither up nor down.
    fn stays_on_a_level_floor(&mut self, index: usize, body: &str) {
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        for (position, axis) in axes.iter().enumerate().filter(|_| axes.len() > 1) {
            if self.downwards(position).is_some() {
                let velocity = self.velocity(body, index + 1, *axis);
                for relation in [Relation::AtMost, Relation::AtLeast] {
                    let reason = Reason::LeavesItsFloor(self.called(body));
                    self.require(velocity.clone(), relation, Expr::zero(), reason);
                }
            }
        }
    }

    /// The duration of a stage, under the author's name or its own.
    pub(crate) fn stage_duration(&mut self, index: usize, term: Option<&momentous_scene::Term>, path: &Path) -> Expr {
        let meaning = format!("the duration of {}", self.stage_phrase(index));
        match term {
            Some(term) => self.read_positive(term, Dimension::TIME, &meaning, &path.key("duration")),
            None => self.positive(self.in_stage(QuantityKind::Duration, "", index), meaning).into(),
        }
    }

    /// Bodies that are at rest already do not come to rest, and nothing tells what acts between them.
    pub(super) fn takes_time(&mut self, index: usize, duration: &Expr) {
        let reason = Reason::TakesTime(self.stage_phrase(index));
        self.require(duration.clone(), Relation::Greater, Expr::zero(), reason);
    }

    fn retardation(&mut self, name: &str, friction: Option<&Expr>, incline: &Incline, way: &Speeds) -> Retardation {
        let mut parts = Vec::new();
        if let Some(friction) = friction {
            parts.push(Expr::product([friction.clone(), self.gravity(), incline.press.clone()]));
        }
        if !incline.is_level() {
            parts.push(Expr::product([Expr::integer(incline.sign * way.sign), self.gravity(), incline.along.clone()]));
        }
        let because = match (friction, incline.is_level()) {
            (Some(_), true) => format!(
                "friction, \u{3bc} times the weight, is all that acts on {name} along the surface, and the mass cancels"
            ),
            (Some(_), false) => {
                format!("friction and the component of weight along the slope act on {name}, and the mass cancels")
            }
            (None, true) => format!("no force acts on {name} along the smooth surface"),
            (None, false) => format!("the component of weight along the slope acts on {name}, and the mass cancels"),
        };
        Retardation { parts, because }
    }

    /// The speed that a body loses over the distance and over the time.
    fn slowed(
        &mut self,
        (index, body): (usize, &str),
        retardation: &Retardation,
        distance: Option<&Expr>,
        duration: &Expr,
        way: &Speeds,
    ) {
        let times =
            |amount: &Expr| retardation.parts.iter().map(|part| -(part.clone() * amount.clone())).collect::<Vec<_>>();
        if let Some(distance) = distance {
            let [start, end] = way.energies.clone();
            let name = self.called(body);
            self.goes_the_whole_way(&name, start.clone(), times(distance));
            let sides = energy::work_energy(start, times(distance), end);
            self.law(&energy::WORK_ENERGY, Some(index), retardation.because.clone(), sides);
        }
        let sides = momentum::impulse_momentum(&Expr::one(), &way.before, &times(duration), &way.after);
        self.law(&momentum::IMPULSE_MOMENTUM, Some(index), retardation.because.clone(), sides);
    }

    /// A smooth ramp of any shape: only the height between its ends matters.
    fn ramp(&mut self, index: usize, stage: &Slide, name: &str, height: &Expr, way: &Speeds) {
        let raised = self.gravity() * height.clone();
        let [start, end] = way.energies.clone();
        let sides = match stage.way.unwrap_or(UpOrDown::Down) {
            UpOrDown::Down => (start + raised, end),
            UpOrDown::Up => (start, end + raised),
        };
        let because = format!(
            "the push of the smooth ramp is at right angles to the motion of {name} and does no work; the mass cancels"
        );
        self.law(&energy::CONSERVATION, Some(index), because, sides);
    }

    /// The normal force, and what acts in diagrams.
    fn slide_forces(
        &mut self,
        index: usize,
        stage: &Slide,
        friction: Option<&Expr>,
        incline: &Incline,
        way: &Speeds,
        duration: &Expr,
    ) {
        let body = stage.body.as_str();
        let normal = self.in_stage(QuantityKind::NormalForce, body, index);
        let meaning = format!("the normal force on {}", self.called(body));
        let normal = Expr::from(self.positive(normal, meaning));
        let mass = self.mass(body);
        let weight = mass * self.gravity();
        // On a ramp of any shape the normal force changes with its slope and its bends, which nobody tells.
        if !stage.is_ramp() {
            let sides = (normal.clone(), weight.clone() * incline.press.clone());
            self.law(&force::NORMAL_FORCE, Some(index), "nothing moves at right angles to the surface", sides);
        }
        let zero = Expr::zero();
        let acts = Acts { stage: index, on: body, during: [&zero, duration] };
        let kinetic = friction.cloned().unwrap_or_else(Expr::zero);
        self.note_floor(acts, incline, weight, normal, kinetic, way.sign < 0);
    }

    /// The forces that give the body an impulse along its way; without friction nothing does so on a level floor.
    fn slide_impulse(&mut self, index: usize, stage: &Slide, incline: &Incline) {
        let called = match stage.friction {
            Some(_) => "friction",
            None if incline.is_level() && stage.height.is_none() => return,
            None => "weight",
        };
        self.note_impulse(index, &stage.body, called, Vec::new());
    }
}
