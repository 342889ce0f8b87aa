//! Angular momentum about a fixed point or the centre of mass, and the moments of the forces of a push, or of weight in flight.

use momentous_expr::Expr;
use momentous_expr::Function;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_fault::Path;
use momentous_laws::angular;
use momentous_laws::force;
use momentous_laws::geometry;
use momentous_laws::mass_centre;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Plane;
use momentous_scene::Stage;
use momentous_scene::stage::Flight;

use super::super::ActingForce;
use super::super::Builder;
use super::super::Direction;
use super::super::ForceKind;
use super::super::Name;
use super::super::QuantityKind;
use super::super::VectorKind;
use super::super::builder::SECOND_COST;
use super::super::name::MASS_CENTRE;
use super::super::name::Meaning;
use super::super::stage::Description;

pub(super) fn angular_momentum(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let (about, centre, when) = (name.subject.as_str(), builder.centre(&name.subject)?, builder.when(instant));
    let meaning = Meaning { noun: "the angular momentum", of: format!("about {centre} {when}") };
    let bodies: Vec<String> = builder.timeline.alive(instant).into_iter().map(str::to_owned).collect();
    let mut terms = Vec::new();
    if builder.axes.is_empty() {
        if name.is_of_mass_centre() || name.component.is_some() {
            return None;
        }
        for body in &bodies {
            let mass = builder.mass_at(body, instant);
            let (radius, velocity) = builder.polar_state(body, about, instant);
            terms.push(Expr::product([mass, radius, velocity]));
        }
    } else {
        let turning = builder.turning(name)?;
        for body in &bodies {
            if builder.scene.rotors().any(|rotor| rotor == body) {
                terms.push(builder.momentum_about(body, about, instant)?);
                continue;
            }
            let mass = builder.mass_at(body, instant);
            let (arm, velocity) = (builder.arm(body, instant, about)?, builder.velocities(body, instant));
            terms.push(mass * angular::moments(&arm, &velocity).into_iter().nth(turning)?);
        }
    }
    let symbol = builder.component(builder.canonical(name), meaning);
    let because = match bodies.len() {
        _ if builder.scene.rotors().next().is_some() => {
            "the angular momentum of what turns about a fixed axis is its moment of inertia times its angular velocity"
        }
        _ if name.is_of_mass_centre() => {
            "arms are counted from the centre of mass, about which what all velocities have in common has no moment"
        }
        1 => "angular momentum is the moment of the momentum",
        _ => "the angular momentum of the system is the sum of the moments of the momenta",
    };
    builder.law(&angular::ANGULAR_MOMENTUM, None, because, (symbol.into(), Expr::sum(terms)));
    if name.is_of_mass_centre() {
        builder.moment_of_the_whole(name, instant, symbol);
    }
    Some(symbol)
}

/// How long a revolution takes at the angular velocity of an instant.
pub(super) fn period_of_rotation(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let on_cone = turn_on_a_cone(builder, &Name { kind: QuantityKind::AngularVelocity, ..name.clone() });
    let rotation = |stage: &Stage| if let Stage::Rotate(rotate) = stage { Some(rotate.about.clone()) } else { None };
    let turning = match on_cone {
        Some(turning) => turning.into(),
        None => {
            let centre = builder.point(&builder.scene.stages.iter().find_map(rotation)?);
            if name.subject.is_empty() {
                builder.turn_of_arm(&centre, instant)
            } else {
                builder.turn_of_body(&name.subject, &centre, instant)
            }
        }
    };
    let meaning = format!("the time of a revolution {}", builder.when(instant));
    let period = builder.positive(builder.canonical(name), meaning);
    // Clockwise, an angular velocity is negative, which a velocity may tell, but a period does not.
    let is_given = |symbol: Symbol| builder.given.contains(&builder.symbols.entry(symbol).name);
    let tells_sense = |(symbol, _): (Symbol, &SymbolEntry)| {
        let kind = &builder.name(symbol).kind;
        let turns =
            matches!(kind, QuantityKind::Velocity | QuantityKind::AngularVelocity | QuantityKind::AngularMomentum);
        turns && is_given(symbol) && !builder.system.positive.contains(&symbol)
    };
    let is_assumed = is_given(period) && !builder.symbols.iter().any(tells_sense);
    let (rate, because) = if is_assumed {
        (turning, "a revolution is an angle of two pi; the period tells no sense, and the positive one is taken")
    } else {
        (Expr::apply(Function::Abs, turning), "a revolution is an angle of two pi")
    };
    let sides = (rate * Expr::from(period), Expr::integer(2) * Expr::Pi);
    builder.law(&angular::REVOLUTION, None, because, sides);
    Some(period)
}

/// How fast a body moves round on its cord at an instant.
pub(super) fn turn_on_a_cone(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let (index, stage) = builder.scene.stages.iter().enumerate().find_map(|(index, stage)| {
        let Stage::Conical(conical) = stage else { return None };
        let is_its_own = conical.body == name.subject && (index + 1..=index + 2).contains(&instant);
        is_its_own.then_some((index, conical))
    })?;
    let kept = builder.canonical(name);
    let on = |kind| Name { kind, ..kept.clone() };
    let [velocity, radius, angle] =
        [QuantityKind::Velocity, QuantityKind::Position, QuantityKind::Direction(VectorKind::Velocity)]
            .map(|kind| builder.quantity(on(kind)).map(Expr::from));
    let (name_of_body, when) = (builder.called(&stage.body), builder.when(instant));
    let meaning = format!("the angular velocity of {name_of_body} about the vertical {when}");
    let turning = Expr::from(builder.symbol(kept.clone(), meaning));
    let because = format!("{name_of_body} moves at right angles to the radius of its circle");
    let sides = (velocity?, radius? * turning.clone());
    builder.law(&geometry::ARC, Some(index), because, sides);
    // With radius and speed put in: omega^2 L cos = g.
    let length = stage.length.ends()[instant - index - 1];
    let path = Path::root().key("scene").key("stages").index(index).key("conical").key("length");
    let length = builder.read_positive(length, Dimension::LENGTH, "", &path);
    let squares = Expr::product([turning.powi(2), length, angle?.cos()]);
    let because = "the radius and the speed of the steady circle are substituted";
    let sides = (squares, builder.gravity());
    builder.law_at(SECOND_COST, &force::CONICAL, Some(index), because, sides);
    builder.symbols.find(&kept.to_string())
}

pub(super) fn moment_of_forces(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let centre = builder.centre(&name.subject)?;
    let turning = builder.turning(name)?;
    let acting = builder.acting_at(instant)?;
    let mut terms = Vec::new();
    for (force, at_end) in acting {
        let parts = builder.components_at(&force, at_end);
        let arm = builder.arm(&force.on, instant, &name.subject)?;
        terms.push(angular::moments(&arm, &parts).into_iter().nth(turning)?.simplify());
    }
    let whose = format!("about {centre} {}", builder.when(instant));
    let meaning = Meaning { noun: "the moment of the forces", of: whose };
    let symbol = builder.component(builder.canonical(name), meaning);
    let because = match builder.axes.len() {
        3 => "the moment of a force is the vector product of its position and the force",
        _ => "each force is multiplied by its arm",
    };
    builder.law(&angular::MOMENT, None, because, (symbol.into(), Expr::sum(terms)));
    Some(symbol)
}

pub(super) fn rate_of_angular_momentum(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let centre = builder.centre(&name.subject)?;
    let moment = moment_of_forces(builder, &Name { kind: QuantityKind::Moment, ..name.clone() })?;
    let whose = format!("about {centre} {}", builder.when(instant));
    let meaning = Meaning { noun: "the rate of change of the angular momentum", of: whose };
    let symbol = builder.component(builder.canonical(name), meaning);
    let because = format!("{centre} {}", if name.is_of_mass_centre() { "is the centre of mass" } else { "is fixed" });
    builder.law(&angular::RATE, None, because, (symbol.into(), moment.into()));
    Some(symbol)
}

impl Builder<'_> {
    /// The name of a fixed point, or the centre of mass, in a sentence.
    pub(crate) fn centre(&self, about: &str) -> Option<String> {
        match about {
            MASS_CENTRE => Some("the centre of mass".to_owned()),
            point => self.scene.points.get(point).map(|entry| entry.name.clone()),
        }
    }

    /// Which moment a name refers to: the only one of a plane, or that of its component.
    fn turning(&self, name: &Name) -> Option<usize> {
        match (self.axes.len(), &name.component) {
            (2, None) => Some(0),
            (3, Some(letter)) => self.axes.iter().position(|(axis, _)| axis.letter() == letter),
            _ => None,
        }
    }

    /// The place of a body, seen from a fixed point or the centre of mass.
    pub(crate) fn arm(&mut self, body: &str, instant: usize, about: &str) -> Option<Vec<Expr>> {
        let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
        let from = |builder: &mut Self, axis: &Axis| match about {
            MASS_CENTRE => {
                let centre = Name::of(QuantityKind::Position, MASS_CENTRE).at(instant).along(axis.letter());
                builder.quantity(centre).map(Expr::from)
            }
            point => Some(builder.coordinate_of(point, *axis)),
        };
        axes.iter().map(|axis| Some(self.place(body, instant, *axis) - from(self, axis)?)).collect()
    }

    /// A coordinate of a fixed point.
    fn coordinate_of(&mut self, point: &str, axis: Axis) -> Expr {
        let scene = self.scene;
        let Some(term) = scene.points.get(point).and_then(|entry| entry.at.get(axis)) else { return Expr::zero() };
        let letter = axis.letter();
        let meaning = format!("the {letter}-coordinate of {}", self.point(point));
        let path = Path::root().key("scene").key("points").key(point).key("at").key(letter);
        let value = self.read(term, Dimension::LENGTH, &meaning, &path);
        self.zero_if_so_written(value)
    }

    /// Koenig's theorem: the angular momentum about each fixed point by that about the centre of mass.
    fn moment_of_the_whole(&mut self, name: &Name, instant: usize, about_centre: Symbol) {
        let bodies: Vec<String> = self.timeline.alive(instant).into_iter().map(str::to_owned).collect();
        let scene = self.scene;
        let Some(turning) = self.turning(name).filter(|_| bodies.len() > 1) else { return };
        let mass = Expr::sum(bodies.iter().map(|body| self.mass_at(body, instant)).collect::<Vec<_>>());
        let letters = self.axis_letters();
        let of_centre = |kind, letter: &str| Name::of(kind, MASS_CENTRE).at(instant).along(letter);
        let velocity = letters.iter().map(|letter| self.quantity(of_centre(QuantityKind::Velocity, letter)));
        let velocity: Option<Vec<Expr>> = velocity.map(|component| component.map(Expr::from)).collect();
        for point in scene.points.keys() {
            let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
            let arm: Option<Vec<Expr>> = axes
                .iter()
                .map(|axis| {
                    let centre = self.quantity(of_centre(QuantityKind::Position, axis.letter()))?;
                    Some(Expr::from(centre) - self.coordinate_of(point, *axis))
                })
                .collect();
            let (Some(arm), Some(velocity), Some(whole)) =
                (arm, &velocity, self.quantity(Name { subject: point.clone(), ..name.clone() }))
            else {
                return;
            };
            let Some(moment) = angular::moments(&arm, velocity).into_iter().nth(turning) else { return };
            let because = "the motion consists of that of the centre of mass and that about it";
            let sides = (whole.into(), mass.clone() * moment + Expr::from(about_centre));
            self.law_at(SECOND_COST, &mass_centre::ANGULAR, None, because, sides);
        }
    }

    /// The forces of the stage that begins at an instant, or of the one that ends there; `None` where not all are known.
    fn acting_at(&mut self, instant: usize) -> Option<Vec<(ActingForce, bool)>> {
        let stages = [(instant.checked_sub(1), false), (instant.checked_sub(2), true)];
        let stages = || stages.into_iter().filter_map(|(stage, at_end)| Some((stage?, at_end)));
        let of_stage = |stage: usize| self.forces.iter().filter(move |force| force.stage == stage);
        let Some((stage, at_end)) = stages().find(|(stage, _)| of_stage(*stage).next().is_some()) else {
            return stages().find_map(|(stage, at_end)| self.weights_in_flight(stage, instant, at_end));
        };
        let forces: Vec<(ActingForce, bool)> = of_stage(stage).map(|force| (force.clone(), at_end)).collect();
        let heavy = self.scene.plane == Plane::Vertical;
        let is_pushed = |body: &&str| forces.iter().any(|(force, _)| force.on == *body);
        let told = !heavy || self.timeline.alive(instant).iter().all(is_pushed);
        told.then_some(forces)
    }

    /// The weights of the bodies, where nothing else acts on any of them.
    fn weights_in_flight(&mut self, stage: usize, instant: usize, at_end: bool) -> Option<Vec<(ActingForce, bool)>> {
        let alive: Vec<String> = self.timeline.alive(instant).into_iter().map(str::to_owned).collect();
        let entry = self.scene.stages.get(stage)?;
        if !matches!(entry, Stage::Fall(_) | Stage::Flight(Flight { incline: None, resistance: None, .. })) {
            return None;
        }
        let flying = Description::of(self.scene, entry).changed();
        if !alive.iter().all(|body| flying.contains(&body.as_str())) {
            return None;
        }
        let (position, down) = (0..self.axes.len()).find_map(|position| Some((position, self.downwards(position)?)))?;
        let gravity = self.gravity();
        let weight = |builder: &mut Self, on: String| ActingForce {
            stage,
            strength: builder.mass_at(&on, instant) * gravity.clone(),
            on,
            kind: ForceKind::Weight,
            called: "weight".to_owned(),
            direction: Direction::axis(builder.axis_place(position), down < 0),
            during: [Expr::zero(), Expr::zero()],
        };
        Some(alive.into_iter().map(|body| (weight(self, body), at_end)).collect())
    }
}
