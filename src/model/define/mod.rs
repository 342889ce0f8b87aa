//! Quantities that exist because somebody mentions them: speeds, momenta, energies, the centre of mass. A table by the
//! kind of the quantity; each row makes the symbol and the equation that defines it.

mod angular;
mod impulse;
mod kinetic;
mod mass_centre;
mod moment_while;
mod phases;
mod relative;
mod speed;
mod spring;
mod vector;
mod velocity;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Path;
use momentous_laws::force;
use momentous_laws::kinematics;
use momentous_laws::momentum;
use momentous_scene::Axis;

use super::Because;
use super::Builder;
use super::Instant;
use super::Name;
use super::QuantityKind;
use super::VectorKind;
use super::VectorName;
use super::name::Meaning;
use super::stage::angular_impulse_by_name;
use super::stage::height_of_a_bounce;
use super::stage::holding_pull;
use super::staged::in_stages;
use angular::angular_momentum;
use angular::moment_of_forces;
use angular::period_of_rotation;
use angular::rate_of_angular_momentum;
use angular::turn_on_a_cone;
use impulse::impulse;
use impulse::mean_force;
use kinetic::energy_gained;
use kinetic::energy_lost;
use kinetic::kinetic_energy;
use kinetic::potential_energy;
use kinetic::work;
use mass_centre::mass_centre_position;
use mass_centre::total_mass;
use phases::common_velocity;
use phases::deformation;
use phases::restoring;
use relative::relative_energy;
use relative::relative_velocity;
use speed::angle;
use speed::speed;
use velocity::velocity;

type Define = for<'b, 's> fn(&'b mut Builder<'s>, &Name) -> Option<Symbol>;

/// The definition of each kind of quantity that exists because it is mentioned.
const DEFINITIONS: &[(QuantityKind, Define)] = &[
    (QuantityKind::Velocity, velocity),
    (QuantityKind::Speed, speed),
    (QuantityKind::Direction(VectorKind::Velocity), angle),
    (QuantityKind::Position, position),
    (QuantityKind::Coordinate(Axis::X), coordinate),
    (QuantityKind::Coordinate(Axis::Y), coordinate),
    (QuantityKind::Coordinate(Axis::Z), coordinate),
    (QuantityKind::Time, clock),
    (QuantityKind::Momentum, linear_momentum),
    (QuantityKind::Impulse, impulse),
    (QuantityKind::MeanForce, mean_force),
    (QuantityKind::KineticEnergy, kinetic_energy),
    (QuantityKind::PotentialEnergy, potential_energy),
    (QuantityKind::EnergyLost, energy_lost),
    (QuantityKind::EnergyGained, energy_gained),
    (QuantityKind::Work, work),
    (QuantityKind::DeformationImpulse, deformation),
    (QuantityKind::RestitutionImpulse, restoring),
    (QuantityKind::CommonVelocity, common_velocity),
    (QuantityKind::RelativeEnergy, relative_energy),
    (QuantityKind::RelativeVelocity, relative_velocity),
    (QuantityKind::AngularMomentum, angular_momentum),
    (QuantityKind::Period, period_of_rotation),
    (QuantityKind::AngularVelocity, turn_on_a_cone),
    (QuantityKind::Moment, moment_of_forces),
    (QuantityKind::AngularMomentumRate, rate_of_angular_momentum),
    (QuantityKind::Tension, holding_pull),
    (QuantityKind::Weight, weight),
    (QuantityKind::Mass, total_mass),
    (QuantityKind::Height, height_of_a_bounce),
    (QuantityKind::AngularImpulse, angular_impulse_by_name),
];

impl Builder<'_> {
    /// The symbol that a name stands for: one that exists, under any of its spellings, or one that the name itself defines.
    pub(crate) fn resolve(&mut self, name: &str) -> Option<Symbol> {
        if let Some(symbol) = self.symbols.find(name) {
            self.counts_turns_of(&self.name(symbol).clone());
            return Some(symbol);
        }
        match VectorName::parse(name) {
            Some(VectorName::AngleBetween(names)) => self.angle_between(names),
            Some(VectorName::Magnitude(vector)) => self.magnitude_of(vector),
            None => self.quantity(Name::parse(name)?),
        }
    }

    /// The symbol of a name, taken apart.
    pub(crate) fn quantity(&mut self, mut name: Name) -> Option<Symbol> {
        if let Some(symbol) = self.symbols.find(&name.to_string()) {
            return Some(symbol);
        }
        if let Some(Instant::Named(instant)) = &name.instant {
            name.instant = Some(Instant::Number(self.timeline.instant(instant)?));
        }
        if let Some(Instant::Number(number)) = name.instant
            && !matches!(name.kind, QuantityKind::Height | QuantityKind::Impulse | QuantityKind::EnergyLost)
            && number > self.timeline.last()
        {
            return None;
        }
        if let Some(stage) = name.stage.take() {
            let index =
                self.timeline.stage(self.scene, &stage).or_else(|| stage.parse::<usize>().ok()?.checked_sub(1))?;
            name.stage = self.stage_label(index);
        }
        self.counts_turns_of(&name);
        // With one axis there is one component, and `r_A1.x` is `r_A1`.
        if let [(only, _)] = self.axes[..]
            && name.component.as_deref() == Some(only.letter())
        {
            name.component = None;
        }
        if let (Some(Instant::Number(instant)), false) = (&name.instant, name.kind == QuantityKind::Mass) {
            self.has_not_fallen(&name.subject.clone(), *instant);
        }
        let kept = self.canonical(&name);
        if let Some(symbol) = self.symbols.find(&kept.to_string()) {
            return Some(symbol);
        }
        let define = DEFINITIONS.iter().find(|(kind, _)| *kind == name.kind).map(|row| row.1);
        define.and_then(|define| define(self, &name)).or_else(|| self.only_stage(&kept))
    }

    /// Angles and moments are counted counter-clockwise, which some axes refuse.
    fn counts_turns_of(&mut self, name: &Name) {
        let turns = matches!(
            name.kind,
            QuantityKind::Direction(_)
                | QuantityKind::AngularMomentum
                | QuantityKind::AngularImpulse
                | QuantityKind::Moment
                | QuantityKind::AngularMomentumRate
        );
        if turns {
            self.counts_turns(&format!("`{name}`"), &Path::root().key("scene").key("axes"));
        }
    }

    /// The one name under which a quantity is kept.
    pub(super) fn canonical(&self, name: &Name) -> Name {
        let Some(Instant::Number(number)) = name.instant else { return name.clone() };
        // A part begins where the whole was. Relative to the centre of mass, a body moves otherwise as soon as another does.
        let (subject, since) = match name.kind {
            QuantityKind::RelativeVelocity => (name.subject.clone(), number),
            QuantityKind::Position if !name.is_of_mass_centre() => self.place_since(&name.subject, number),
            _ => (name.subject.clone(), self.timeline.naming_instant(&name.subject, number)),
        };
        Name { subject, ..name.clone() }.at(since)
    }

    /// A name without a stage, where only one could be meant. An angular momentum without a stage is that of all bodies.
    fn only_stage(&self, name: &Name) -> Option<Symbol> {
        if name.kind == QuantityKind::AngularMomentum {
            return None;
        }
        if let [only] = in_stages(&self.symbols, &self.names, name)[..] { Some(only) } else { None }
    }

    pub(super) fn number(&self, name: &Name) -> Option<usize> {
        match name.instant {
            Some(Instant::Number(number)) if (1..=self.timeline.last()).contains(&number) => Some(number),
            _ => None,
        }
    }

    fn body_at(&self, name: &Name) -> Option<(String, usize)> {
        let number = self.number(name)?;
        Some((name.subject.clone(), self.timeline.since(&name.subject, number)?))
    }

    fn axis(&self, letter: &str) -> Option<Axis> {
        self.axes.iter().map(|(axis, _)| *axis).find(|axis| axis.letter() == letter)
    }

    /// The axes that a name refers to: the one of its component, or the only one.
    pub(super) fn axis_of(&self, name: &Name) -> Option<Axis> {
        match (&name.component, &self.axes[..]) {
            (Some(letter), _) => self.axis(letter),
            (None, [(only, _)]) => Some(*only),
            (None, _) => None,
        }
    }

    /// The time from the start to an instant.
    pub(super) fn clock(&mut self, instant: usize) -> Option<Symbol> {
        let time = self.time_until(instant)?;
        let meaning = format!("the time {}, measured from the start", self.when(instant));
        let symbol = self.symbol(Name::of(QuantityKind::Time, "").at(instant), meaning);
        let because = "all times are measured from the start";
        self.law(&kinematics::CLOCK, None, because, (symbol.into(), time));
        Some(symbol)
    }

    /// Mass and velocity component of every body alive at an instant.
    fn carriers(&mut self, instant: usize, axis: Axis) -> Vec<(Expr, Expr)> {
        let bodies: Vec<String> = self.timeline.alive(instant).into_iter().map(str::to_owned).collect();
        bodies.iter().map(|body| (self.mass_at(body, instant), self.velocity(body, instant, axis))).collect()
    }
}

fn position(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let when = builder.when(instant);
    if name.is_of_mass_centre() {
        return mass_centre_position(builder, name, instant);
    }
    let (body, _) = builder.body_at(name)?;
    let owner = builder.called(&body);
    if builder.axes.is_empty() {
        let meaning = format!("the distance of {owner} from the centre {when}");
        return Some(builder.positive(builder.canonical(name), meaning));
    }
    let axis = builder.axis_of(name)?;
    match builder.place(&body, instant, axis) {
        Expr::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}

/// `x_A1` is another spelling of the place of A along x.
fn coordinate(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let QuantityKind::Coordinate(axis) = name.kind else { return None };
    let axis = builder.axis(axis.letter())?;
    let (body, _) = builder.body_at(name)?;
    match builder.place(&body, builder.number(name)?, axis) {
        Expr::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}

/// `t_3`: the time from the start to an instant, where the durations of all stages before it are used.
fn clock(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name).filter(|_| name.subject.is_empty())?;
    builder.clock(instant)
}

fn linear_momentum(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    let instant = builder.number(name)?;
    let axis = builder.axis_of(name)?;
    let when = builder.when(instant);
    let (whose, parts) = if name.subject.is_empty() {
        ("the system".to_owned(), builder.carriers(instant, axis))
    } else {
        let (body, since) = builder.body_at(name)?;
        (builder.called(&body), vec![(builder.mass_at(&body, instant), builder.velocity(&body, since, axis))])
    };
    let meaning = Meaning { noun: "the momentum", of: format!("of {whose} {when}") };
    let symbol = builder.component(builder.canonical(name), meaning);
    builder.law(&momentum::MOMENTUM, None, Because::Definition, (symbol.into(), momentum::total(&parts)));
    Some(symbol)
}

fn weight(builder: &mut Builder<'_>, name: &Name) -> Option<Symbol> {
    if !builder.scene.bodies.contains_key(&name.subject) {
        return None;
    }
    let meaning = format!("the weight of {}", builder.called(&name.subject));
    let symbol = builder.positive(builder.canonical(name), meaning);
    let (mass, gravity) = (builder.mass_at(&name.subject, 1), builder.gravity());
    builder.law(&force::WEIGHT, None, Because::Definition, (symbol.into(), mass * gravity));
    Some(symbol)
}
