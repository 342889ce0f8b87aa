//! The centre of mass: its place, its velocity, and how impulses from outside move it.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::kinematics;
use momentous_laws::mass_centre;
use momentous_laws::momentum;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_scene::stage::Separate;

use super::super::Agent;
use super::super::Builder;
use super::super::Effect;
use super::super::Name;
use super::super::QuantityKind;
use super::super::name::MASS_CENTRE;
use super::super::name::Meaning;
use super::super::stage::Description;

pub(super) fn mass_centre_velocity(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let axis = builder.axis_of(name)?;
    let meaning = Meaning { noun: "the velocity", of: format!("of the centre of mass {}", builder.when(instant)) };
    let symbol = builder.component(builder.canonical(name), meaning);
    let parts = builder.carriers(instant, axis);
    let because = builder.momentum_of_the_whole(instant);
    builder.law(&mass_centre::MASS_CENTRE, None, because, mass_centre::mass_centre(&symbol.into(), &parts));
    builder.mass_centre_motion(instant, axis, symbol);
    Some(symbol)
}

/// The mass of a body that a stage makes of others, or divides.
pub(super) fn total_mass(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    if *name != Name::of(QuantityKind::Mass, &name.subject) || builder.parts_of(&name.subject).is_empty() {
        return None;
    }
    let meaning = format!("the mass of {}", builder.called(&name.subject));
    let symbol = builder.positive(name.clone(), meaning);
    let parts = builder.mass_at(&name.subject, builder.timeline.last());
    builder.law(&mass_centre::TOTAL_MASS, None, "together they are one body", (symbol.into(), parts));
    Some(symbol)
}

impl Builder<'_> {
    /// Why the velocity of the centre of mass is what it is, and whose velocity did not change just before the instant.
    fn momentum_of_the_whole(&self, instant: usize) -> String {
        let alive = self.timeline.alive(instant);
        let kept = alive.iter().filter(|body| self.timeline.since(body, instant).is_some_and(|since| since < instant));
        let kept: Vec<String> = kept.map(|body| self.called(body)).collect();
        let whole = "the momentum of the system is its total mass times the velocity of the centre of mass";
        let stage = instant.checked_sub(2).and_then(|stage| self.scene.stages.get(stage));
        let shortly = if stage.is_some_and(|stage| !stage.takes_time()) { " in so short a time" } else { "" };
        match &kept[..] {
            [] => whole.to_owned(),
            [only] => format!("{whole}, and{shortly} {only} keeps its velocity"),
            several => format!("{whole}, and{shortly} {} keep their velocities", several.join(" and ")),
        }
    }

    /// The velocity of the centre of mass from one instant to the next, by the impulses from outside the system.
    fn mass_centre_motion(&mut self, instant: usize, axis: Axis, after: Symbol) {
        let Some(before_instant) = instant.checked_sub(1).filter(|before| *before >= 1) else { return };
        let before = Name::of(QuantityKind::Velocity, MASS_CENTRE).at(before_instant).along(self.letter(axis));
        let Some(before) = self.quantity(before) else { return };
        let Some(position) = self.axes.iter().position(|(listed, _)| *listed == axis) else { return };
        let alive = self.timeline.alive(instant).len();
        // Mass that joins or leaves carries momentum of its own, and of a fall no time is told.
        let is_apart = self.scene.stages.get(instant - 2).is_some_and(|stage| {
            matches!(stage, Stage::Fall(_)) || matches!(stage, Stage::Push(push) if push.mass_change().is_some())
        });
        if alive < 2 || is_apart || self.downwards(position).is_some() && !self.is_impulsive(instant) {
            return;
        }
        let Some(outside) = self.impulses_from_outside(instant - 2, position) else { return };
        let parts = self.carriers(instant, axis);
        let total = mass_centre::total_mass(&parts);
        let because = if outside.is_empty() {
            "no external impulse acts on the system, and the internal impulses cancel".to_owned()
        } else {
            "the internal impulses cancel, and only external impulses change the velocity of the centre of mass"
                .to_owned()
        };
        let sides = momentum::impulse_momentum(&total, &before.into(), &outside, &after.into());
        self.law(&mass_centre::MOTION, Some(instant - 2), because, sides);
    }

    /// The impulses that act on the bodies of the scene from outside in a stage, along the axis of that position; none where one of them
    /// is not known, as where only the force is told and not for how long it acts.
    fn impulses_from_outside(&self, stage: usize, position: usize) -> Option<Vec<Expr>> {
        let noted =
            || self.impulses.iter().filter(|impulse| impulse.stage == stage && !matches!(impulse.by, Agent::Body(_)));
        let unnoted =
            self.influences.iter().filter(|influence| influence.stage == stage && influence.by.is_empty()).any(
                |influence| {
                    let is_nothing = matches!(influence.along(position), Effect::Of(force) if force.is_zero());
                    !is_nothing && noted().all(|impulse| impulse.on != influence.on)
                },
            );
        // What holds a fixed point pushes on whatever turns about it.
        let stage_itself = self.scene.stages.get(stage)?;
        let is_held = Description::of(self.scene, stage_itself).about.is_some_and(|about| about != MASS_CENTRE);
        if unnoted || is_held {
            return None;
        }
        noted().map(|impulse| impulse.components.get(position).cloned()).collect()
    }

    fn is_impulsive(&self, instant: usize) -> bool {
        self.impulses.iter().any(|impulse| impulse.stage + 2 == instant && impulse.impulsive)
    }
}

pub(super) fn mass_centre_position(builder: &mut Builder<'_>, name: &Name, instant: usize) -> Option<Symbol> {
    let axis = builder.axis_of(name)?;
    let meaning = Meaning { noun: "the position", of: format!("of the centre of mass {}", builder.when(instant)) };
    let symbol = builder.component(builder.canonical(name), meaning);
    let letter = builder.letter(axis);
    let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
    let mut parts = Vec::new();
    for body in bodies {
        let place = builder.quantity(Name::of(QuantityKind::Position, &body).at(instant).along(letter))?;
        parts.push((builder.mass_at(&body, instant), Expr::from(place)));
    }
    let sides = mass_centre::mass_centre(&symbol.into(), &parts);
    builder.law(
        &mass_centre::MASS_CENTRE,
        None,
        "the position of the centre of mass is the average of the positions, weighted by mass",
        sides,
    );
    builder.path_of_mass_centre(instant, axis, symbol);
    Some(symbol)
}

impl Builder<'_> {
    /// Place and velocity of the centre of mass when a stage starts; those of the whole, where that has just come apart.
    fn centre_at_start(&mut self, index: usize, axis: Axis, alive: usize) -> Option<(Expr, Expr)> {
        let scene = self.scene;
        let burst = index.checked_sub(1).and_then(|before| scene.stages.get(before));
        if let Some(Stage::Separate(Separate { from: Some(whole), into, force: None, .. })) = burst
            && into.len() == alive
            && self.guided(whole).is_none()
        {
            return Some((self.place(whole, index, axis), self.velocity(whole, index, axis)));
        }
        let letter = self.letter(axis);
        let [from, velocity] = [QuantityKind::Position, QuantityKind::Velocity]
            .map(|kind| self.quantity(Name::of(kind, MASS_CENTRE).at(index + 1).along(letter)));
        Some((from?.into(), velocity?.into()))
    }

    /// Without external forces but weight, the centre of mass moves as one body of the whole mass would.
    fn path_of_mass_centre(&mut self, instant: usize, axis: Axis, after: Symbol) {
        let Some(index) = instant.checked_sub(2) else { return };
        let alive: Vec<String> = self.timeline.alive(instant).into_iter().map(str::to_owned).collect();
        let Some(position) = self.axes.iter().position(|(listed, _)| *listed == axis) else { return };
        let Some(moves) = self.moves(index, &alive).filter(|_| alive.len() > 1) else { return };
        let Some((from, velocity)) = self.centre_at_start(index, axis, alive.len()) else { return };
        let unpushed = "the internal forces cancel, and no external impulse acts on the system";
        let (law, because, sides) = match (moves, self.downwards(position)) {
            (Moves::Not, _) => (&mass_centre::DISPLACEMENT, "nothing has moved yet", (after.into(), from)),
            (Moves::FromRest, _) => {
                let because = "no external impulse acts on the system, and its centre of mass, initially at rest, stays where it is";
                (&mass_centre::DISPLACEMENT, because, (after.into(), from))
            }
            (Moves::Freely(time), None) => {
                (&mass_centre::DISPLACEMENT, unpushed, kinematics::uniform(&from, &velocity, &time, &after.into()))
            }
            (Moves::Flying(time), down) => {
                let because =
                    "the internal forces cancel, and the centre of mass moves as a single body of the total mass would";
                let sides = match down {
                    Some(down) => {
                        let gravity = Expr::integer(down) * self.gravity();
                        kinematics::accelerated(&from, &velocity, &gravity, &time, &after.into())
                    }
                    None => kinematics::uniform(&from, &velocity, &time, &after.into()),
                };
                (&mass_centre::PATH, because, sides)
            }
            (Moves::Freely(_), Some(_)) => return,
        };
        self.law(law, Some(index), because, sides);
    }

    /// How the centre of mass of these bodies moves in a stage; none where something else than weight acts on them from outside.
    fn moves(&mut self, index: usize, alive: &[String]) -> Option<Moves> {
        let scene = self.scene;
        let stage = scene.stages.get(index)?;
        let among = |bodies: &[&str]| alive.iter().all(|body| bodies.contains(&body.as_str()));
        if !stage.takes_time() {
            return Some(Moves::Not);
        }
        if let Stage::Flight(flight) = stage
            && flight.is_free()
        {
            let all = among(&flight.flying().collect::<Vec<_>>());
            return all.then(|| Moves::Flying(self.flight_time(index, flight)));
        }
        if let Stage::Interact(interact) = stage {
            let bodies: Vec<&str> = interact.between.iter().map(String::as_str).collect();
            if !among(&bodies) || bodies.iter().any(|body| self.guided(body).is_some()) {
                return None;
            }
            if interact.at_rest {
                return Some(Moves::FromRest);
            }
        }
        let acts_alone = matches!(stage, Stage::Interact(_) | Stage::Drift(_) | Stage::Separate(_));
        self.lasting[index].clone().filter(|_| acts_alone).map(Moves::Freely)
    }
}

/// How the centre of mass of a system moves in a stage.
enum Moves {
    /// The stage takes no time.
    Not,
    /// It was at rest, and nothing acts from outside.
    FromRest,
    /// Nothing acts from outside for so long.
    Freely(Expr),
    /// Nothing but weight acts from outside for so long.
    Flying(Expr),
}
