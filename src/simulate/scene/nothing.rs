//! Why a stage has nothing to simulate.

/// Why there is nothing to simulate in a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NothingToSimulate {
    /// The scene is a single instant, or has no such stage.
    NoStage,
    /// Stages can be simulated, but the form solves nothing that they find.
    NothingSolved,
    /// Velocities stay what they are.
    NothingChanges,
    /// Only the impulse is used.
    UnknownHistory,
    /// The line of impact, which a smooth contact needs in a plane, is not given.
    NoLineOfImpact,
    /// Neither a coefficient of restitution nor staying together is given.
    NoRestitution,
    /// A quantity that the simulation needs is neither given nor solved in this form.
    ValueMissing,
    /// The stage is no motion of bodies that could be watched.
    NotShown,
    /// The motion is one that no method here integrates.
    NoMethod,
    /// A term, a direction or the axes are of a form that the simulation does not read.
    Unread,
}

impl NothingToSimulate {
    /// The reason, as a sentence without a full stop.
    #[must_use]
    pub fn reason(self) -> &'static str {
        match self {
            Self::NoStage => "nothing to simulate: the problem is about a single instant",
            Self::NothingSolved => {
                "nothing to simulate: the quantities that a simulation gives are not solved in this form"
            }
            Self::NothingChanges => "nothing to simulate: no velocity changes",
            Self::UnknownHistory => "nothing to simulate: the force of a blow is not known, only its impulse",
            Self::NoLineOfImpact => "nothing to simulate: the line of impact is not given",
            Self::NoRestitution => "nothing to simulate: no coefficient of restitution is given",
            Self::ValueMissing => "nothing to simulate: a quantity that it needs is neither given nor solved",
            Self::NotShown => "not shown: it is simulated, but not as a motion of bodies that could be watched",
            Self::NoMethod => "nothing to simulate: no method of this version integrates such a motion",
            Self::Unread => "nothing to simulate: a term or direction of this kind is not supported",
        }
    }
}
