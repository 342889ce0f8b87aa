//! The kinds of quantity that symbols stand for.

use std::borrow::Cow;

use crate::scene::Axis;

/// What kind of quantity a symbol stands for. It is known where the symbol is made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum QuantityKind {
    /// Velocity, of a body or of the centre of mass.
    Velocity,
    /// Velocity relative to the centre of mass.
    RelativeVelocity,
    /// Common velocity of two bodies at the greatest deformation.
    CommonVelocity,
    /// Velocity of what streams.
    StreamVelocity,
    /// Speed.
    Speed,
    /// Greatest speed against a resistance.
    TerminalSpeed,
    /// Ratio of the sum and the difference of a speed and the greatest one.
    SpeedRatio,
    /// Direction of a vector in the plane, counted from the first axis; or the angle of a cord.
    Direction(VectorKind),
    /// The same direction counted from an axis of the author's choice.
    CountedDirection(VectorKind),
    /// Angle of a position in an orbit, from the nearest point.
    TrueAnomaly,
    /// The angle by which an ellipse is described as a stretched circle.
    EccentricAnomaly,
    /// An angle by a letter that is usual for angles.
    OwnAngle(String),
    /// The angle between two vectors or directions, by their names.
    AngleBetween([String; 2]),
    /// The magnitude of a vector, by its name.
    Magnitude(String),
    /// Position along an axis, or distance from a centre.
    Position,
    /// Coordinate along an axis.
    Coordinate(Axis),
    /// Displacement, or the distance travelled.
    Displacement,
    /// Deformation of a spring.
    SpringDeformation,
    /// Height.
    Height,
    /// Depth.
    Depth,
    /// Length of a path.
    PathLength,
    /// Distance between two bounces.
    Range,
    /// Semi-major axis of an orbit.
    SemiMajorAxis,
    /// Eccentricity of an orbit.
    Eccentricity,
    /// Period of an orbit.
    Period,
    /// Time, from the start.
    Time,
    /// The time at which motion begins within a stage.
    StartTime,
    /// Duration.
    Duration,
    /// Acceleration.
    Acceleration,
    /// Acceleration of free fall.
    Gravity,
    /// Mass.
    Mass,
    /// Mass that flows per unit time.
    MassFlow,
    /// Linear momentum.
    Momentum,
    /// Impulse.
    Impulse,
    /// Impulse of deformation.
    DeformationImpulse,
    /// Impulse of restitution.
    RestitutionImpulse,
    /// Impulse of one force, of the net force or of a moment, as an integral over time.
    TimeIntegral,
    /// Impulse of a guide.
    GuideImpulse,
    /// Force.
    Force,
    /// The force that keeps a body at constant velocity.
    HoldingForce,
    /// Average force.
    MeanForce,
    /// Tension.
    Tension,
    /// Normal force.
    NormalForce,
    /// Weight.
    Weight,
    /// Power.
    Power,
    /// Kinetic energy.
    KineticEnergy,
    /// Kinetic energy relative to the centre of mass.
    RelativeEnergy,
    /// Kinetic energy that a stage loses.
    EnergyLost,
    /// Kinetic energy that a stage gains.
    EnergyGained,
    /// Work.
    Work,
    /// Angular momentum.
    AngularMomentum,
    /// Rate of change of angular momentum.
    AngularMomentumRate,
    /// Moment of forces.
    Moment,
    /// Angular velocity.
    AngularVelocity,
    /// Rate at which a radius sweeps out area.
    ArealRate,
    /// A value that the author wrote into a term.
    Value(String),
    /// Anything that the author named, by the beginning of its name.
    Own(String),
}

/// What a direction is the direction of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorKind {
    /// Velocity.
    Velocity,
    /// Impulse.
    Impulse,
    /// Force.
    Force,
}

/// The kinds that an author's names are read as. Where one spelling begins like another, the longer stands first.
const READ: &[QuantityKind] = &[
    QuantityKind::AngularMomentumRate,
    QuantityKind::RelativeEnergy,
    QuantityKind::RelativeVelocity,
    QuantityKind::EnergyLost,
    QuantityKind::EnergyGained,
    QuantityKind::DeformationImpulse,
    QuantityKind::RestitutionImpulse,
    QuantityKind::CommonVelocity,
    QuantityKind::MeanForce,
    QuantityKind::ArealRate,
    QuantityKind::Direction(VectorKind::Impulse),
    QuantityKind::Direction(VectorKind::Force),
    QuantityKind::Velocity,
    QuantityKind::Speed,
    QuantityKind::Direction(VectorKind::Velocity),
    QuantityKind::Position,
    QuantityKind::Coordinate(Axis::X),
    QuantityKind::Coordinate(Axis::Y),
    QuantityKind::Coordinate(Axis::Z),
    QuantityKind::Time,
    QuantityKind::Momentum,
    QuantityKind::Impulse,
    QuantityKind::TimeIntegral,
    QuantityKind::Force,
    QuantityKind::Weight,
    QuantityKind::KineticEnergy,
    QuantityKind::Work,
    QuantityKind::AngularMomentum,
    QuantityKind::Moment,
    QuantityKind::AngularVelocity,
    QuantityKind::Mass,
];

/// Beginnings of authors' names that are angles wherever they are pure numbers.
const ANGLES: &[&str] = &["angle", "alpha", "beta", "theta", "phi", "psi"];

impl QuantityKind {
    /// How names of this kind begin.
    #[must_use]
    pub fn spelling(&self) -> Cow<'_, str> {
        Cow::Borrowed(match self {
            Self::Velocity => "v",
            Self::RelativeVelocity => "v_rel",
            Self::CommonVelocity => "v_common",
            Self::StreamVelocity => "v_stream",
            Self::Speed => "speed",
            Self::TerminalSpeed => "w",
            Self::SpeedRatio => "f",
            Self::Direction(VectorKind::Velocity) => "angle",
            Self::Direction(VectorKind::Impulse) => "angle_J",
            Self::Direction(VectorKind::Force) => "angle_F",
            Self::CountedDirection(VectorKind::Velocity) => "phi",
            Self::CountedDirection(VectorKind::Impulse) => "phi_J",
            Self::CountedDirection(VectorKind::Force) => "phi_F",
            Self::TrueAnomaly => "theta",
            Self::EccentricAnomaly => "E",
            Self::Position => "r",
            Self::Coordinate(axis) => axis.letter(),
            Self::Displacement | Self::SpringDeformation => "s",
            Self::Height => "h",
            Self::Depth => "depth",
            Self::PathLength => "path",
            Self::Range => "range",
            Self::SemiMajorAxis | Self::Acceleration => "a",
            Self::Eccentricity => "ecc",
            Self::Period => "period",
            Self::Time => "t",
            Self::StartTime => "t_start",
            Self::Duration => "dt",
            Self::Gravity => "g",
            Self::Mass => "m",
            Self::MassFlow => "flow",
            Self::Momentum => "p",
            Self::Impulse => "J",
            Self::DeformationImpulse => "J_def",
            Self::RestitutionImpulse => "J_rest",
            Self::TimeIntegral => "I",
            Self::GuideImpulse => "R",
            Self::Force => "F",
            Self::HoldingForce => "F_hold",
            Self::MeanForce => "F_avg",
            Self::Tension => "tension",
            Self::NormalForce => "N",
            Self::Weight => "W",
            Self::Power => "P",
            Self::KineticEnergy => "T",
            Self::RelativeEnergy => "T_rel",
            Self::EnergyLost => "T_lost",
            Self::EnergyGained => "T_gained",
            Self::Work => "work",
            Self::AngularMomentum => "H",
            Self::AngularMomentumRate => "H_rate",
            Self::Moment => "M",
            Self::AngularVelocity => "omega",
            Self::ArealRate => "areal_rate",
            Self::Value(text) | Self::Own(text) | Self::OwnAngle(text) => text,
            Self::AngleBetween([one, other]) => return format!("angle({one}, {other})").into(),
            Self::Magnitude(vector) => return format!("magnitude({vector})").into(),
        })
    }

    /// The kind that the beginning of an author's name says, and the rest of the name.
    pub(super) fn parse(text: &str) -> (Self, &str) {
        let rest = |kind: &Self| {
            let rest = text.strip_prefix(&*kind.spelling())?;
            if rest.is_empty() { Some(rest) } else { rest.strip_prefix('_') }
        };
        if let Some((kind, rest)) = READ.iter().find_map(|kind| Some((kind, rest(kind)?))) {
            // What is left over after further lines belongs to no name.
            return (kind.clone(), rest.trim_start_matches('_'));
        }
        let (base, rest) = text.split_once('_').unwrap_or((text, ""));
        let is_angle = ANGLES.iter().any(|start| base.starts_with(start));
        (if is_angle { Self::OwnAngle(base.to_owned()) } else { Self::Own(base.to_owned()) }, rest)
    }

    /// Whether it is an angle, which is printed in degrees.
    #[must_use]
    pub fn is_angle(&self) -> bool {
        matches!(
            self,
            Self::Direction(_)
                | Self::CountedDirection(_)
                | Self::TrueAnomaly
                | Self::AngleBetween(_)
                | Self::OwnAngle(_)
        )
    }

    /// Whether it is a velocity.
    #[must_use]
    pub fn is_velocity(&self) -> bool {
        matches!(self, Self::Velocity | Self::RelativeVelocity | Self::CommonVelocity | Self::StreamVelocity)
    }

    /// Whether it is an energy.
    #[must_use]
    pub fn is_kinetic_energy(&self) -> bool {
        matches!(self, Self::KineticEnergy | Self::RelativeEnergy | Self::EnergyLost | Self::EnergyGained)
    }
}
