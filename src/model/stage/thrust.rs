//! Bodies that throw mass away: thrust, the rocket equation, the wait on the ground, resistance.

use crate::Agent;
use crate::Alternative;
use crate::Builder;
use crate::Impulse;
use crate::Influence;
use crate::Opposing;
use crate::QuantityKind;
use crate::Reason;
use crate::builder::LAW_COST;
use crate::forces::Acts;
use crate::frame::Direction;
use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::kinematics;
use momentous_laws::variable_mass;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::Stage;
use momentous_scene::stage::BurningMass;
use momentous_scene::stage::Exhaust;
use momentous_scene::stage::Thrust;
use momentous_solve::Relation;

/// Mass in each unit of time.
pub(crate) const FLOW: Dimension = Dimension::new(1, 0, -1);
/// Resistance by the square of the speed.
const RESISTANCE: Dimension = Dimension::new(1, -1, 0);

/// The terms of a burn, as read.
pub(super) struct Burn {
    pub index: usize,
    pub body: String,
    pub masses: [Expr; 2],
    /// The mean speed of what is thrown away, each jet counted by its flow.
    exhaust: Expr,
    flow: Expr,
    pub thrust: Expr,
    time: Expr,
    pub direction: Direction,
}

impl Builder<'_> {
    pub(crate) fn thrust(&mut self, index: usize, stage: &Thrust, path: &Path) {
        let burn = self.read_burn(index, stage, path);
        let (name, because) = (self.called(&burn.body), "the flow is steady");
        let [start, end] = [&burn.masses[0], &burn.masses[1]];
        self.law(&variable_mass::USED, Some(index), because, variable_mass::used([start, end], &burn.flow, &burn.time));
        let reason = Reason::GainsMass(name.clone());
        self.require(start.clone(), Relation::AtLeast, end.clone(), reason);
        self.lasting[index] = Some(burn.time.clone());
        self.note_burn(&burn, stage.on_ground);
        if let Some(resistance) = &stage.resistance {
            let at = path.key("resistance");
            let meaning = "the resistance divided by the square of the speed";
            let resistance = self.read_positive(resistance, RESISTANCE, meaning, &at);
            self.against_resistance(&burn, &resistance, &at);
        } else if stage.on_ground {
            self.waits_on_the_ground(&burn, matches!(stage.mass, BurningMass::Both(_)), path);
        } else {
            let (masses, time) = (burn.masses.clone(), burn.time.clone());
            let sides = self.burnt(&burn, &masses, &time);
            let because = format!("the exhaust leaves {name} with a steady speed relative to it");
            for side in sides {
                self.law(&variable_mass::ROCKET, Some(index), because.clone(), side);
            }
            if let Some(sides) = self.way(&burn, &masses, &time) {
                self.law(&variable_mass::BURN_HEIGHT, Some(index), "flow and exhaust speed are steady", sides);
            }
        }
        if stage.is_free() {
            self.rates_of_burn(&burn);
        }
        self.leave_out_of_burn(stage);
    }

    fn read_burn(&mut self, index: usize, stage: &Thrust, path: &Path) -> Burn {
        let body = stage.body.clone();
        let (name, phrase) = (self.called(&body), self.stage_phrase(index));
        let start = self.burning_mass(index, &body, 0, stage.mass.at_start());
        self.check_mass_at_start(index, &body, &start, path);
        let masses = [start, self.mass_at(&body, index + 2)];
        let meaning = format!("the duration of {phrase}");
        let time = match &stage.during {
            Some(term) => self.read_positive(term, Dimension::TIME, &meaning, &path.key("during")),
            None => self.positive(self.in_stage(QuantityKind::Duration, "", index), meaning).into(),
        };
        let meaning = format!("the thrust on {name}");
        let thrust = match &stage.force {
            Some(term) => self.read_positive(term, Dimension::FORCE, &meaning, &path.key("force")),
            None => self.positive(self.in_stage(QuantityKind::Force, &body, index), meaning).into(),
        };
        let (exhaust, flow) = self.read_exhaust(index, stage, &thrust, path);
        let direction = match &stage.direction {
            Some(term) => self.direction(term, &path.key("direction")),
            None => self.first_axis(),
        };
        Burn { index, body, masses, exhaust, flow, thrust, time, direction }
    }

    /// A burn begins with the mass that the body has. Between two burns something may be dropped, and nothing is gained.
    fn check_mass_at_start(&mut self, index: usize, body: &str, start: &Expr, path: &Path) {
        let earlier = self.scene.stages.iter().take(index);
        let is_own = |stage: &Stage| matches!(stage, Stage::Thrust(thrust) if thrust.body == body);
        if earlier.into_iter().any(is_own) {
            let left = self.mass_at(body, index + 1);
            self.require(left, Relation::AtLeast, start.clone(), Reason::GainsMass(self.called(body)));
            return;
        }
        if (self.mass(body) - start.clone()).simplify().is_zero() {
            return;
        }
        let message = format!("the mass of {} at the start of the burn is told in two ways", self.called(body));
        let help = "write the mass that the body has before as the first of `mass`; or remove the `mass` of the body, if it has one";
        self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.key("mass")));
    }

    /// The exhaust speed and the whole flow, and the thrust that they give.
    fn read_exhaust(&mut self, index: usize, stage: &Thrust, thrust: &Expr, path: &Path) -> (Expr, Expr) {
        let name = self.called(&stage.body);
        let meaning = format!("the mass that {name} expels per unit time");
        let flow = match &stage.flow {
            Some(term) => self.read_positive(term, FLOW, &meaning, &path.key("flow")),
            None => self.positive(self.in_stage(QuantityKind::MassFlow, &stage.body, index), meaning).into(),
        };
        let at = path.key("exhaust");
        let jets = match &stage.exhaust {
            Exhaust::Speed(term) => {
                let meaning = format!("the speed of the exhaust relative to {name}");
                let speed = self.read_positive(term, Dimension::VELOCITY, &meaning, &at);
                let because = format!("the exhaust that {name} expels gives it an opposite momentum");
                let sides = (thrust.clone(), flow.clone() * speed.clone());
                self.law(&variable_mass::THRUST, Some(index), because, sides);
                return (speed, flow);
            }
            Exhaust::Jets(jets) => jets,
        };
        let mut parts = Vec::new();
        for (position, jet) in jets.iter().enumerate() {
            let at = at.index(position);
            let speed = self.read(&jet.speed, Dimension::VELOCITY, "the speed of a jet", &at.key("speed"));
            parts.push((speed, self.read_positive(&jet.flow, FLOW, "the mass flow of a jet", &at.key("flow"))));
        }
        let whole = Expr::sum(parts.iter().map(|(_, flow)| flow.clone()));
        let pushes = Expr::sum(parts.into_iter().map(|(speed, flow)| flow * speed));
        let because = format!("the mass of {name} decreases by the flow of all jets");
        self.law(&variable_mass::FLOW, Some(index), because, (flow.clone(), whole));
        let because = "each jet adds its own thrust".to_owned();
        self.law(&variable_mass::THRUST, Some(index), because, (thrust.clone(), pushes));
        (thrust.clone() / flow.clone(), flow)
    }

    /// `v_2 = v_1 + u ln(m_1 / m_2) - g dt`, along every axis.
    fn burnt(&mut self, burn: &Burn, masses: &[Expr; 2], time: &Expr) -> Vec<(Expr, Expr)> {
        let parts = self.components(&burn.direction);
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let [start, end] = masses;
        let mut all = Vec::new();
        for ((position, axis), part) in axes.into_iter().enumerate().zip(parts) {
            let [before, after] = [1, 2].map(|side| self.velocity(&burn.body, burn.index + side, axis));
            let gained = part * variable_mass::gained(&burn.exhaust, [start, end]);
            let fallen = self.downwards(position).map(|down| {
                let gravity = self.gravity();
                Expr::product([Expr::integer(down), gravity, time.clone()])
            });
            all.push((after, Expr::sum([before, gained].into_iter().chain(fallen))));
        }
        all
    }

    /// The way along the only axis.
    fn way(&mut self, burn: &Burn, [start, end]: &[Expr; 2], time: &Expr) -> Option<(Expr, Expr)> {
        let [(axis, _)] = self.axes[..] else { return None };
        let part = self.components(&burn.direction).into_iter().next()?;
        let (name, phrase) = (self.called(&burn.body), self.stage_phrase(burn.index));
        let meaning = format!("the displacement of {name} during {phrase}");
        let way = self.symbol(self.in_stage(QuantityKind::Displacement, &burn.body, burn.index), meaning);
        let before = self.velocity(&burn.body, burn.index + 1, axis);
        let driven = part * variable_mass::way(&burn.exhaust, [start, end], time);
        let fallen = self.downwards(0).map(|down| {
            let gravity = self.gravity();
            Expr::product([Expr::ratio(down, 2), gravity, time.clone().powi(2)])
        });
        let [from, to] = [1, 2].map(|side| self.place(&burn.body, burn.index + side, axis));
        let because = format!("the final position of {name} is its initial position plus its displacement");
        self.law(&kinematics::DISPLACED, Some(burn.index), because, (to, from + Expr::from(way)));
        Some((way.into(), Expr::sum([before * time.clone(), driven].into_iter().chain(fallen))))
    }

    /// A rocket on the ground: it lifts off at once, or when it has become light enough, or never.
    fn waits_on_the_ground(&mut self, burn: &Burn, ends: bool, path: &Path) {
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let ([axis], Some(-1)) = (&axes[..], self.downwards(0)) else {
            let fault = Fault::new(Code::Value, "a rocket on the ground needs one axis that points upwards");
            let help = "write `axes: { y: upwards }` and `plane: vertical`, or remove `on_ground`";
            self.faults.push(fault.help(help).at_path(path.key("on_ground")));
            return;
        };
        let (index, name, gravity) = (burn.index, self.called(&burn.body), self.gravity());
        self.starts_from_rest(index, &burn.body);
        let [start, end] = &burn.masses;
        let begins =
            Expr::from(self.symbol(
                self.in_stage(QuantityKind::StartTime, "", index),
                format!("the time at which {name} lifts off"),
            ));
        let after = self.velocity(&burn.body, index + 2, *axis);
        let weight = |mass: &Expr| mass.clone() * gravity.clone();

        let mut at_once = Alternative { what: format!("{name} lifts off at once"), ..Alternative::default() };
        let because = "the thrust exceeds the weight from the start";
        let sides = (begins.clone(), Expr::zero());
        at_once.equations.push(self.stated(LAW_COST, &variable_mass::LIFT_OFF, Some(index), because, sides, None));
        let all = self.burnt(burn, &burn.masses, &burn.time);
        self.rises(&mut at_once, burn, all, &burn.masses, &burn.time);
        let reason = Reason::WaitsOnGround(name.clone());
        at_once.conditions.push(self.condition(burn.thrust.clone(), Relation::AtLeast, weight(start), reason));

        let mut waits = Alternative {
            what: format!("{name} stays on the ground until it has become light enough"),
            ..Alternative::default()
        };
        let left = start.clone() - burn.flow.clone() * begins.clone();
        let because = format!("{name} rises as soon as the ground no longer supports it");
        let sides = (burn.thrust.clone(), weight(&left));
        waits.equations.push(self.stated(LAW_COST, &variable_mass::LIFT_OFF, Some(index), because, sides, None));
        let (masses, time) = ([left, end.clone()], burn.time.clone() - begins);
        let all = self.burnt(burn, &masses, &time);
        self.rises(&mut waits, burn, all, &masses, &time);
        let reason = Reason::LiftsAtOnce(name.clone());
        waits.conditions.push(self.condition(burn.thrust.clone(), Relation::Less, weight(start), reason));
        let mut ways = vec![at_once, waits];
        if ends {
            let reason = Reason::NeverLifts(name.clone());
            let lifts = self.condition(burn.thrust.clone(), Relation::Greater, weight(end), reason);
            ways[1].conditions.push(lifts);
            let mut never = Alternative { what: format!("{name} never lifts off"), ..Alternative::default() };
            let because = "the thrust stays below the weight to the end";
            let sides = (after, Expr::zero());
            never.equations.push(self.stated(LAW_COST, &variable_mass::LIFT_OFF, Some(index), because, sides, None));
            let reason = Reason::LiftsInTime(name.clone());
            never.conditions.push(self.condition(burn.thrust.clone(), Relation::AtMost, weight(end), reason));
            ways.push(never);
        }
        self.choices.push(ways);
    }

    fn rises(&mut self, way: &mut Alternative, burn: &Burn, sides: Vec<(Expr, Expr)>, masses: &[Expr; 2], time: &Expr) {
        let index = Some(burn.index);
        let because = format!("from then on thrust and weight act on {}", self.called(&burn.body));
        for side in sides {
            way.equations.push(self.stated(LAW_COST, &variable_mass::ROCKET, index, because.clone(), side, None));
        }
        if let Some(side) = self.way(burn, masses, time) {
            let because = "flow and exhaust speed are steady";
            way.equations.push(self.stated(LAW_COST, &variable_mass::BURN_HEIGHT, index, because, side, None));
        }
    }

    /// Along a level axis, with a resistance that grows with the square of the speed.
    fn against_resistance(&mut self, burn: &Burn, resistance: &Expr, path: &Path) {
        let (1, Plane::Horizontal, 0 | 2) = (self.axes.len(), self.scene.plane, burn.direction.quarters) else {
            let fault = Fault::new(Code::Value, "resistance needs one level axis, along the thrust");
            self.faults.push(fault.help("use one axis and a horizontal plane").at_path(path.clone()));
            return;
        };
        let (name, axis) = (self.called(&burn.body), self.axes[0].0);
        let sign = if burn.direction.quarters == 0 { 1 } else { -1 };
        let [before, after] =
            [1, 2].map(|side| (Expr::integer(sign) * self.velocity(&burn.body, burn.index + side, axis)).simplify());
        // The resistance is written against a motion with the thrust.
        for velocity in [&before, &after] {
            let reason = Reason::MovesBack(name.clone()).against(Some(Opposing::Resistance));
            self.require(velocity.clone(), Relation::AtLeast, Expr::zero(), reason);
        }
        let [even, ratio] =
            [QuantityKind::TerminalSpeed, QuantityKind::SpeedRatio].map(|kind| self.in_stage(kind, "", burn.index));
        let meaning = "the speed at which the resistance equals the thrust";
        let even = Expr::from(self.positive(even, meaning));
        let because = format!("{name} cannot become faster than that");
        let sides = (resistance.clone() * even.clone().powi(2), burn.thrust.clone());
        self.law(&variable_mass::EVEN_SPEED, Some(burn.index), because, sides);
        let masses = [&burn.masses[0], &burn.masses[1]];
        let value = variable_mass::ratio_against_resistance(&even, resistance, &burn.flow, masses, &before);
        let meaning = "the ratio of w - v to w + v at the end";
        let ratio = Expr::from(self.symbol(ratio, meaning));
        let because = "thrust minus resistance accelerates the remaining mass";
        self.law(&variable_mass::ROCKET_DRAG, Some(burn.index), because, (ratio.clone(), value));
        let sides = (after, variable_mass::against_resistance(&even, &ratio));
        self.law(&variable_mass::ROCKET_DRAG, Some(burn.index), "the ratio f gives the velocity", sides);
    }

    fn note_burn(&mut self, burn: &Burn, on_ground: bool) {
        let zero = Expr::zero();
        let acts = Acts { stage: burn.index, on: &burn.body, during: [&zero, &burn.time] };
        self.note_pull(acts, "the thrust", &burn.thrust, &burn.direction);
        let weight = (self.scene.plane == Plane::Vertical).then_some("weight");
        // Until it lifts off the ground carries what the thrust does not.
        let ground = on_ground.then_some("the push of the ground");
        for called in ["the thrust of its exhaust"].into_iter().chain(weight).chain(ground) {
            self.acts(Influence::outside(burn.index, &burn.body, called));
            self.impulses.push(Impulse {
                stage: burn.index,
                on: burn.body.clone(),
                by: Agent::Outside,
                called: called.into(),
                components: Vec::new(),
                impulsive: false,
            });
        }
    }

    fn leave_out_of_burn(&mut self, stage: &Thrust) {
        match self.scene.plane {
            Plane::Horizontal => self.neglect("gravity", "the problem gives none along the motion"),
            Plane::Vertical => self.neglect("the decrease of g with height", "g is taken to be constant"),
        }
        if stage.resistance.is_none() {
            self.neglect("air resistance", "the problem gives none");
        }
    }
}
