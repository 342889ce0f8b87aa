//! Particles on an arm: angular impulse and momentum about a fixed point.

use std::collections::BTreeSet;

use crate::Agent;
use crate::Builder;
use crate::Effect;
use crate::Impulse;
use crate::Influence;
use crate::Integral;
use crate::Name;
use crate::QuantityKind;
use crate::Work;
use crate::name::Meaning;
use crate::turned::Turned;
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Path;
use momentous_laws::angular;
use momentous_laws::geometry;
use momentous_quantity::Dimension;
use momentous_scene::Stage;
use momentous_scene::list;
use momentous_scene::stage::Arm;
use momentous_scene::stage::Rotate;

use super::along_path::Along;
use super::described::Description;

impl Builder<'_> {
    pub(crate) fn rotate(&mut self, index: usize, stage: &Rotate, path: &Path) {
        let point = stage.about.as_str();
        let centre = self.point(point);
        let held = stage.held();
        let momenta = [0, 1].map(|side| self.momentum_on_arm(index, side, stage, &held, path));
        let moment = stage.moment.as_ref().map(|strength| {
            let meaning = format!("the moment about {centre}");
            self.strength(strength, Dimension::ENERGY, &meaning, &path.key("moment"))
        });
        let forces = self.along_path(stage, path);
        let total = match (&moment, &forces[..]) {
            (None, []) => None,
            (Some(moment), []) => Some(moment.clone()),
            (moment, forces) => {
                Some(Expr::sum(moment.iter().cloned().chain(forces.iter().map(|force| force.moment.clone()))))
            }
        };
        let mut gained = None;
        if let Some(total) = &total {
            let (start, end) = match &stage.during {
                Some(during) => self.duration(index, during, &path.key("during")),
                None => (Expr::zero(), self.stage_duration(index, None, path)),
            };
            self.lasting[index] = Some(end.clone() - start.clone());
            if let Some(moment) = &moment {
                self.told_throughout("the moment", moment, &end);
            }
            for force in &forces {
                self.told_throughout(&force.name, &force.strength, &end);
            }
            gained = Some(self.angular_impulse(index, (&centre, None), total, &start, &end));
        }
        let lone = held.first().filter(|_| !stage.is_arm());
        let because = match (&gained, lone) {
            (Some(_), _) => {
                let [where_it_acts, there] = match lone {
                    Some(_) => ["towards".to_owned(), format!("about {centre}")],
                    None => ["at".to_owned(), "there".to_owned()],
                };
                let changing = Self::changing(moment.is_some(), &forces, &centre);
                format!(
                    "the force {where_it_acts} {centre} has no moment {there}, and only {changing} the angular momentum"
                )
            }
            (None, Some((body, _))) => {
                let name = self.called(body);
                format!("the only force on {name} in the plane passes through {centre} and has no moment about it")
            }
            (None, None) if stage.rotor.is_some() => {
                format!("the force at {centre} has no moment there, and the other forces act within the system")
            }
            (None, None) => {
                format!("the force at {centre} has no moment there, and the forces along the arm have none")
            }
        };
        let [before, after] = momenta;
        let start = Expr::sum([before].into_iter().chain(gained));
        self.law(&angular::ANGULAR_IMPULSE, Some(index), because, (start, after));
        self.arm_acts(index, stage, &held, moment.as_ref(), path);
        for force in &forces {
            self.along_acts(index, force);
        }
        for body in stage.turning() {
            self.impulses.push(Impulse {
                stage: index,
                on: body.to_owned(),
                by: Agent::Outside,
                called: acting_words(&centre, stage, &forces),
                components: Vec::new(),
                impulsive: false,
            });
            if stage.rotor.is_none() {
                let name = self.called(body);
                self.neglect(format!("the mass of what holds {name}"), "it is light");
            }
        }
    }

    /// The force of the arm, which does work where the distances change; between several bodies it acts like one on another.
    fn arm_acts(&mut self, index: usize, stage: &Rotate, held: &[(&str, &Arm)], moment: Option<&Expr>, path: &Path) {
        let centre = self.point(&stage.about);
        // An arm that turns steadily pushes nothing along its path.
        let changes = |(_, arm): &(&str, &Arm)| matches!(arm, Arm::Changing(_));
        let turns_unevenly = stage.is_driven() || held.iter().any(changes);
        if let Some(rotor) = &stage.rotor {
            self.acts(
                Influence::outside(index, rotor, format!("the force at {centre}")).workless().through(&stage.about),
            );
            self.turned_by(index, rotor, &centre, moment);
            let carried: Vec<&str> = held.iter().map(|(body, _)| *body).collect();
            if !carried.is_empty() && turns_unevenly {
                let names: Vec<String> = carried.iter().map(|body| self.called(body)).collect();
                let reaction = Influence::outside(index, rotor, format!("the force of {}", list(&names)));
                self.acts(Influence { work: Work::OfForce, ..reaction.by(&carried) });
            }
        }
        for (body, arm) in held {
            let others: Vec<&str> = stage.turning().into_iter().filter(|other| other != body).collect();
            // A rotor also pushes what it carries along the path; only what acts towards the centre is noted of it.
            let called = match &stage.rotor {
                Some(_) => format!("the force towards {centre}"),
                None => holding(stage, &centre),
            };
            let influence = Influence::outside(index, body, called).through(&stage.about);
            let influence = match arm {
                Arm::Constant(_) => influence.workless(),
                Arm::Changing([before, after]) => {
                    self.neglect(
                        format!("the motion of {} towards {centre} or away from it at both ends", self.called(body)),
                        "there its distance is taken not to change",
                    );
                    let [before, after] = [before, after].map(|term| self.read(term, Dimension::LENGTH, "", path));
                    influence.works(Effect::Of(before - after), "work is done as the distance changes")
                }
            };
            // A child on a carousel is held by the carousel.
            let held_by: Vec<&str> = stage.rotor.iter().map(String::as_str).collect();
            self.acts(influence.by(&held_by));
            if !others.is_empty() && turns_unevenly {
                let between = Influence::outside(index, body, "the arm").by(&others);
                self.acts(Influence { work: Work::OfForce, ..between });
            }
            if stage.rotor.is_none() {
                self.turned_by(index, body, &centre, moment);
            }
        }
    }

    /// The moment on what turns.
    fn turned_by(&mut self, index: usize, body: &str, centre: &str, moment: Option<&Expr>) {
        let Some(moment) = moment else { return };
        let called = format!("the moment about {centre}");
        let turning = Influence::outside(index, body, called).moment(vec![moment.clone()]);
        self.acts(turning.works(Effect::Of(moment.clone()), "the moment does work as the arm turns"));
    }

    /// The angular momentum of all that is held, at the start (0) or at the end (1).
    fn momentum_on_arm(
        &mut self,
        index: usize,
        side: usize,
        stage: &Rotate,
        held: &[(&str, &Arm)],
        path: &Path,
    ) -> Expr {
        let (centre, instant) = (self.point(&stage.about), index + 1 + side);
        let mut terms = Vec::new();
        for (body, arm) in held {
            let path = if held.len() == 1 { path.key("arm") } else { path.key("bodies").key(*body) };
            let name = self.called(body);
            let meaning = format!("the distance of {name} from {centre} {}", self.when(instant));
            let arm = self.read_positive(arm.ends()[side], Dimension::LENGTH, &meaning, &path);
            let turn = match held {
                [_] if !stage.is_arm() => self.turn_of_body(body, &centre, instant),
                _ => self.turn_of_arm(&centre, instant),
            };
            terms.push(self.on_arm(index, body, instant, &arm, &turn));
            self.towards_the_centre(index, [body, &centre], instant, &arm);
        }
        if stage.rotor.is_some() {
            let turn = self.turn_of_arm(&centre, instant);
            terms.extend(self.momentum_of_rotor(stage.rotor.as_deref(), &turn));
        }
        let meaning = format!("the angular momentum about {centre} {}", self.when(instant));
        let momentum = Expr::from(self.symbol(self.momentum_on_arm_by_name(index, side, &stage.about), meaning));
        let because = match (held, &stage.rotor) {
            ([], Some(rotor)) => format!("{} turns about {centre}", self.called(rotor)),
            (_, Some(rotor)) => format!("all turn together with {}", self.called(rotor)),
            ([(body, _)], None) => format!("{} moves at right angles to the radius", self.called(body)),
            _ => "all move at right angles to the arm".to_owned(),
        };
        self.law(&angular::ANGULAR_MOMENTUM, Some(index), because, (momentum.clone(), Expr::sum(terms)));
        momentum
    }

    /// The name of the angular momentum about a point at the start of a stage (0) or at its end (1). Without a stage in its name it is
    /// that of all bodies: where the stage, or the one beside it, counts others, it has its stage in its name.
    pub(crate) fn momentum_on_arm_by_name(&self, index: usize, side: usize, about: &str) -> Name {
        let turning = |stage: usize| -> Option<BTreeSet<&str>> {
            let entry = self.scene.stages.get(stage)?;
            if !matches!(entry, Stage::Rotate(_) | Stage::Strike(_)) {
                return None;
            }
            let description = Description::of(self.scene, entry);
            (description.about == Some(about)).then(|| description.bodies.iter().map(|(body, _)| *body).collect())
        };
        let beside = if side == 0 { index.checked_sub(1) } else { Some(index + 1) };
        let (bodies, others) = (turning(index), beside.and_then(turning));
        let alive: BTreeSet<&str> = self.timeline.alive(index + 1 + side).into_iter().collect();
        let differs = bodies.is_some_and(|bodies| bodies != alive || others.is_some_and(|others| bodies != others));
        let name = Name::of(QuantityKind::AngularMomentum, about).at(index + 1 + side);
        if differs { name.during(self.stage_label(index)) } else { name }
    }

    /// The angular velocity of a body by itself.
    pub(crate) fn turn_of_body(&mut self, body: &str, centre: &str, instant: usize) -> Expr {
        let meaning = format!("the angular velocity of {} about {centre} {}", self.called(body), self.when(instant));
        self.symbol(Name::of(QuantityKind::AngularVelocity, body).at(instant), meaning).into()
    }

    /// The angular velocity of an arm that carries several bodies.
    pub(crate) fn turn_of_arm(&mut self, centre: &str, instant: usize) -> Expr {
        let meaning = format!("the angular velocity about {centre} {}", self.when(instant));
        self.symbol(Name::of(QuantityKind::AngularVelocity, "").at(instant), meaning).into()
    }

    /// The velocity of a body at right angles to its radius.
    pub(crate) fn transverse(&mut self, body: &str, instant: usize) -> Expr {
        let since = self.timeline.naming_instant(body, instant);
        let meaning = format!("the transverse velocity of {} {}", self.called(body), self.when(since));
        self.symbol(Name::of(QuantityKind::Velocity, body).at(since), meaning).into()
    }

    /// The angular momentum of a body on an arm, whose velocity follows from the turning.
    pub(crate) fn on_arm(&mut self, index: usize, body: &str, instant: usize, arm: &Expr, turn: &Expr) -> Expr {
        let velocity = self.transverse(body, instant);
        let sides = (velocity.clone(), arm.clone() * turn.clone());
        let because = format!("{} moves at right angles to the radius", self.called(body));
        self.law(&geometry::ARC, Some(index), because, sides);
        Expr::product([self.mass(body), arm.clone(), velocity])
    }

    /// The acceleration towards the centre.
    fn towards_the_centre(&mut self, index: usize, [body, centre]: [&str; 2], instant: usize, arm: &Expr) {
        let name = self.called(body);
        let velocity = self.transverse(body, instant);
        let meaning = format!("the acceleration of {name} towards {centre} {}", self.when(instant));
        let turning = self.symbol(Name::of(QuantityKind::Acceleration, body).at(instant).along("n"), meaning);
        let because = format!("{name} moves on a circle at that instant");
        let sides = (turning.into(), velocity.powi(2) / arm.clone());
        self.law(&geometry::TURNING, Some(index), because, sides);
    }

    /// The angular impulse of a moment about a point, along the axis of that letter where there are several.
    pub(crate) fn angular_impulse(
        &mut self,
        index: usize,
        (centre, letter): (&str, Option<&str>),
        moment: &Expr,
        start: &Expr,
        end: &Expr,
    ) -> Expr {
        let clock = self.running_time();
        if !moment.contains(clock) {
            let value = moment.clone() * (end.clone() - start.clone());
            self.turned.push(Turned {
                stage: index,
                of: format!("about {centre}"),
                letter: letter.map(str::to_owned),
                law: &angular::MOMENT_IMPULSE,
                because: "the moment stays the same".to_owned(),
                ends: [Expr::zero(), value.clone()],
            });
            return value;
        }
        let symbol = self.named_angular_impulse(index, (format!("about {centre}"), letter));
        match moment.definite(clock, start, end) {
            Some(value) => {
                let integral =
                    Integral { integrand: moment.clone(), variable: clock, low: start.clone(), high: end.clone() };
                let because = "the moment changes with time";
                self.integral(&angular::MOMENT_IMPULSE, index, because, (symbol.into(), value.simplify()), integral);
            }
            None => self.faults.push(momentous_fault::Fault::new(
                momentous_fault::Code::Stuck,
                "the moment cannot be integrated over time",
            )),
        }
        symbol.into()
    }
    fn named_angular_impulse(&mut self, index: usize, (whose, letter): (String, Option<&str>)) -> Symbol {
        let name = self.in_stage(QuantityKind::AngularImpulse, "", index).along(letter);
        let meaning = Meaning { noun: "the angular impulse", of: whose };
        self.component(name, meaning)
    }
}

/// The force with which the point holds what turns about it.
fn holding(stage: &Rotate, centre: &str) -> String {
    let changes = stage.held().iter().any(|(_, arm)| matches!(arm, Arm::Changing(_)));
    match &stage.rotor {
        Some(_) => format!("the force at {centre}"),
        None if changes || !stage.is_arm() => format!("the force towards {centre}"),
        None => "the force of the arm".to_owned(),
    }
}

/// The words for the influences on bodies that turn.
fn acting_words(centre: &str, stage: &Rotate, forces: &[Along<'_>]) -> String {
    let moment = stage.moment.iter().map(|_| format!("the moment about {centre}"));
    let others = forces.iter().map(|force| force.name.clone()).chain(moment);
    list(&[holding(stage, centre)].into_iter().chain(others).collect::<Vec<_>>())
}

/// The angular impulse of a moment that stays the same, or of a body that strikes, where somebody asks for it.
pub(crate) fn angular_impulse_by_name(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let meant = |index: usize| name.stage.is_none() || builder.stage_label(index) == name.stage;
    let mut all = builder.turned.iter().filter(|turned| meant(turned.stage) && turned.letter == name.component);
    let turned = all.next().cloned()?;
    if all.next().is_some() || !name.subject.is_empty() {
        return None;
    }
    let symbol = builder.named_angular_impulse(turned.stage, (turned.of, turned.letter.as_deref()));
    let [before, after] = turned.ends;
    builder.law(turned.law, Some(turned.stage), turned.because, (Expr::sum([before, symbol.into()]), after));
    Some(symbol)
}
