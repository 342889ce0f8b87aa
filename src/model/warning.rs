//! What an author may allow.

/// Ways in which a solution is unphysical, by the names that authors write under `allow`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Warning {
    /// The bodies would not meet.
    NoImpact,
    /// A body would pass through another, or through a surface.
    PassesThrough,
    /// Kinetic energy would be created in an impact, or restitution lies outside 0 to 1.
    EnergyCreated,
    /// A body would move the other way than its stage says.
    Reverses,
    /// The cord of a body that swings would go slack, where a rod would push, or it would leave its track.
    GoesSlack,
    /// Weight, which a short contact leaves out, would give a tenth or more of the change of momentum.
    WeightNeglected,
}

impl Warning {
    /// Every warning with its name.
    pub const NAMES: &[(&str, Self)] = &[
        ("no-impact", Self::NoImpact),
        ("passes-through", Self::PassesThrough),
        ("energy-created", Self::EnergyCreated),
        ("reverses", Self::Reverses),
        ("goes-slack", Self::GoesSlack),
        ("weight-neglected", Self::WeightNeglected),
    ];
}
