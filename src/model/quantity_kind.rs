//! The kinds of quantity that symbols stand for.

use std::borrow::Cow;

use momentous_quantity::Dimension;
use momentous_scene::Axis;

/// The kind of quantity that a symbol stands for. It is known where the symbol is made.
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
    /// Impulse of one force or of the net force, as an integral over time.
    TimeIntegral,
    /// Angular impulse, as an integral over time.
    AngularImpulse,
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
    /// Potential energy due to weight.
    PotentialEnergy,
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
    /// Rate of change of momentum.
    MomentumRate,
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

/// The vector whose direction a symbol gives.
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
    QuantityKind::MomentumRate,
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
    QuantityKind::Period,
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
    QuantityKind::AngularImpulse,
    QuantityKind::TimeIntegral,
    QuantityKind::Force,
    QuantityKind::Tension,
    QuantityKind::Weight,
    QuantityKind::KineticEnergy,
    QuantityKind::PotentialEnergy,
    QuantityKind::Work,
    QuantityKind::AngularMomentum,
    QuantityKind::Moment,
    QuantityKind::AngularVelocity,
    QuantityKind::Mass,
];

/// Beginnings of authors' names that are angles wherever they are pure numbers.
const ANGLES: &[&str] = &["angle", "alpha", "beta", "theta", "phi", "psi"];

impl QuantityKind {
    /// How names of this kind begin, and its dimension; none of what an author names.
    fn row(&self) -> (Cow<'_, str>, Dimension) {
        let (spelling, dimension) = match self {
            Self::Velocity => ("v", Dimension::VELOCITY),
            Self::RelativeVelocity => ("v_rel", Dimension::VELOCITY),
            Self::CommonVelocity => ("v_common", Dimension::VELOCITY),
            Self::StreamVelocity => ("v_stream", Dimension::VELOCITY),
            Self::Speed => ("speed", Dimension::VELOCITY),
            Self::TerminalSpeed => ("w", Dimension::VELOCITY),
            Self::SpeedRatio => ("f", Dimension::NONE),
            Self::Direction(VectorKind::Velocity) => ("angle", Dimension::NONE),
            Self::Direction(VectorKind::Impulse) => ("angle_J", Dimension::NONE),
            Self::Direction(VectorKind::Force) => ("angle_F", Dimension::NONE),
            Self::CountedDirection(VectorKind::Velocity) => ("phi", Dimension::NONE),
            Self::CountedDirection(VectorKind::Impulse) => ("phi_J", Dimension::NONE),
            Self::CountedDirection(VectorKind::Force) => ("phi_F", Dimension::NONE),
            Self::TrueAnomaly => ("theta", Dimension::NONE),
            Self::EccentricAnomaly => ("E", Dimension::NONE),
            Self::Position => ("r", Dimension::LENGTH),
            Self::Displacement | Self::SpringDeformation => ("s", Dimension::LENGTH),
            Self::Height => ("h", Dimension::LENGTH),
            Self::Depth => ("depth", Dimension::LENGTH),
            Self::PathLength => ("path", Dimension::LENGTH),
            Self::Range => ("range", Dimension::LENGTH),
            Self::SemiMajorAxis => ("a", Dimension::LENGTH),
            Self::Acceleration => ("a", Dimension::ACCELERATION),
            Self::Eccentricity => ("ecc", Dimension::NONE),
            Self::Period => ("period", Dimension::TIME),
            Self::Time => ("t", Dimension::TIME),
            Self::StartTime => ("t_start", Dimension::TIME),
            Self::Duration => ("dt", Dimension::TIME),
            Self::Gravity => ("g", Dimension::ACCELERATION),
            Self::Mass => ("m", Dimension::MASS),
            Self::MassFlow => ("flow", Dimension::new(1, 0, -1)),
            Self::Momentum => ("p", Dimension::MOMENTUM),
            Self::MomentumRate => ("p_rate", Dimension::FORCE),
            Self::Impulse => ("J", Dimension::MOMENTUM),
            Self::DeformationImpulse => ("J_def", Dimension::MOMENTUM),
            Self::RestitutionImpulse => ("J_rest", Dimension::MOMENTUM),
            Self::TimeIntegral => ("I", Dimension::MOMENTUM),
            Self::AngularImpulse => ("I_M", Dimension::ANGULAR_MOMENTUM),
            Self::GuideImpulse => ("R", Dimension::MOMENTUM),
            Self::Force => ("F", Dimension::FORCE),
            Self::HoldingForce => ("F_hold", Dimension::FORCE),
            Self::MeanForce => ("F_avg", Dimension::FORCE),
            Self::Tension => ("tension", Dimension::FORCE),
            Self::NormalForce => ("N", Dimension::FORCE),
            Self::Weight => ("W", Dimension::FORCE),
            Self::Power => ("P", Dimension::new(1, 2, -3)),
            Self::KineticEnergy => ("T", Dimension::ENERGY),
            Self::PotentialEnergy => ("V", Dimension::ENERGY),
            Self::RelativeEnergy => ("T_rel", Dimension::ENERGY),
            Self::EnergyLost => ("T_lost", Dimension::ENERGY),
            Self::EnergyGained => ("T_gained", Dimension::ENERGY),
            Self::Work => ("work", Dimension::ENERGY),
            Self::AngularMomentum => ("H", Dimension::ANGULAR_MOMENTUM),
            Self::AngularMomentumRate => ("H_rate", Dimension::ENERGY),
            Self::Moment => ("M", Dimension::ENERGY),
            Self::AngularVelocity => ("omega", Dimension::new(0, 0, -1)),
            Self::ArealRate => ("areal_rate", Dimension::new(0, 2, -1)),
            Self::Coordinate(axis) => (axis.letter(), Dimension::LENGTH),
            Self::Value(text) | Self::Own(text) | Self::OwnAngle(text) => (text.as_str(), Dimension::NONE),
            Self::AngleBetween([one, other]) => return (format!("angle({one}, {other})").into(), Dimension::NONE),
            Self::Magnitude(vector) => return (format!("magnitude({vector})").into(), Dimension::NONE),
        };
        (spelling.into(), dimension)
    }

    /// How names of this kind begin.
    #[must_use]
    pub fn spelling(&self) -> Cow<'_, str> {
        self.row().0
    }

    /// The dimension of the kinds that a scene makes.
    pub(super) fn dimension(&self) -> Dimension {
        self.row().1
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
        // Only heights with a number are those of bounces; `h_min` is the author's.
        if base == Self::Height.spelling() && !rest.is_empty() && rest.chars().all(|digit| digit.is_ascii_digit()) {
            return (Self::Height, rest);
        }
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
