//! Mistakes in judging a scene without numbers: what is conserved, which forces are impulsive, and how graphs look.

use super::Misconception;

/// Energy is lost, so momentum is taken to be lost.
pub const MOMENTUM_BY_ENERGY: Misconception = Misconception {
    id: "momentum-judged-by-energy",
    does: "assumes that momentum is lost because kinetic energy is",
    ask: "Does a change of kinetic energy say anything about momentum? Which external impulses act on the system meanwhile?",
    hint: "The impulses of bodies on each other cancel in pairs, however much energy goes into deforming and heating them.",
};
/// Momentum is conserved, so energy is taken to be conserved.
pub const ENERGY_BY_MOMENTUM: Misconception = Misconception {
    id: "energy-judged-by-momentum",
    does: "assumes that kinetic energy is conserved because momentum is",
    ask: "Momentum is conserved here. What else must hold for kinetic energy to be conserved, too?",
    hint: "In an impact kinetic energy is conserved only if the bodies separate as fast as they approached each other.",
};
/// A body judged as if it were the system.
pub const PART_FOR_SYSTEM: Misconception = Misconception {
    id: "part-for-system",
    does: "assumes that the momentum of one body is conserved because the total momentum is",
    ask: "Which bodies belong to the system in question? Does any other body push on it meanwhile?",
    hint: "Bodies that act on each other exchange momentum: what one of them gains, the others lose.",
};
/// A wall, a rail or weight left out of account.
pub const OUTSIDE_OVERLOOKED: Misconception = Misconception {
    id: "outside-impulse-overlooked",
    does: "overlooks an external impulse on the system",
    ask: "What touches the system from outside, or acts on it from afar, and has a component along this direction?",
    hint: "A floor, a wall or a rail that pushes, and weight if it has time to act, change the momentum of the system.",
};
/// The moment of a force judged by the force.
pub const ANGULAR_BY_LINEAR: Misconception = Misconception {
    id: "angular-judged-by-linear",
    does: "assumes that angular momentum changes because a force acts",
    ask: "Where does the line of action of the force pass? How long is its arm about this point?",
    hint: "A force through the point changes the momentum, but it has no moment about the point.",
};
/// Weight and the like taken for impulsive.
pub const ORDINARY_AS_IMPULSIVE: Misconception = Misconception {
    id: "ordinary-force-as-impulsive",
    does: "mistakes a force of ordinary size for an impulsive one",
    ask: "Would this force grow if the contact were ten times as short?",
    hint: "The impulse of a force of constant size becomes smaller as the contact gets shorter.",
};
/// The force of a contact taken for an ordinary one, or a long push for an impulsive one.
pub const IMPULSIVE_AS_ORDINARY: Misconception = Misconception {
    id: "impulsive-force-as-ordinary",
    does: "mistakes an impulsive force for one of ordinary size",
    ask: "What stops or deflects the body within so short a time?",
    hint: "The shorter the contact, the larger the force that gives the same impulse.",
};

/// What follows is taken for unknown.
pub const ENOUGH_OVERLOOKED: Misconception = Misconception {
    id: "enough-overlooked",
    does: "overlooks a law by which the quantity follows from what is given",
    ask: "Which laws hold here, and which quantities in them are not known?",
    hint: "As many independent equations as there are unknown quantities in them are enough to find these.",
};
/// What does not follow is taken for known.
pub const EQUATIONS_NOT_COUNTED: Misconception = Misconception {
    id: "equations-not-counted",
    does: "assumes that a quantity follows although there are fewer equations than unknown quantities",
    ask: "How many quantities are unknown, and how many independent equations connect them?",
    hint: "One equation finds one unknown quantity. What else would have to be known of this motion?",
};

/// A picture in which an impulse changes nothing.
pub const MOMENTUM_KEPT: Misconception = Misconception {
    id: "momentum-kept",
    does: "leaves the momentum of each body as it was, although an impulse acts on it",
    ask: "What does an impulse do to the momentum of the body on which it acts?",
    hint: "Put the arrow of the impulse to the tip of the momentum before: the momentum after ends where it ends.",
};
/// A picture in which the arrows do not add up.
pub const AFTER_REVERSED: Misconception = Misconception {
    id: "momentum-after-reversed",
    does: "turns the momentum after the wrong way round",
    ask: "Put the arrow of the impulse to the tip of the momentum before. In which direction does the sum point?",
    hint: "Momentum before and impulse, arrow after arrow, add up to the momentum after.",
};

/// A graph of the velocity that has the shape of the force.
pub const STATE_AS_FORCE: Misconception = Misconception {
    id: "velocity-drawn-as-force",
    does: "takes the shape of the force for that of the velocity",
    ask: "The force is not zero: does the velocity then stay as it is, or does it change?",
    hint: "The force says how steep the graph of the velocity is, not how high it is.",
};
/// A graph of the force that has the shape of the velocity.
pub const FORCE_AS_STATE: Misconception = Misconception {
    id: "force-drawn-as-velocity",
    does: "draws the force as if it grew with the momentum that it has given",
    ask: "Does a body that moves faster need a larger force, or does a force make it move faster?",
    hint: "The force says how fast the momentum changes, not how large the momentum is.",
};
/// A force that changes taken for its mean.
pub const FORCE_AS_CONSTANT: Misconception = Misconception {
    id: "force-taken-as-constant",
    does: "replaces a force that changes by a constant one",
    ask: "Is the force the same at the start, half-way and at the end?",
    hint: "A constant force with the same impulse leads to the same end, by another way.",
};
/// A constant force that dies away.
pub const FORCE_FADES: Misconception = Misconception {
    id: "force-used-up",
    does: "lets the force die away as the body moves",
    ask: "What exerts the force, and does that become weaker with time?",
    hint: "Motion does not use a force up: it acts as long as the body that exerts it does.",
};
/// A body that goes on through what throws it back.
pub const REBOUND_OVERLOOKED: Misconception = Misconception {
    id: "rebound-overlooked",
    does: "lets the body go on in the direction in which it came",
    ask: "In which direction does the body move just after the impact? What does that do to the sign of its velocity?",
    hint: "A body that is thrown back moves against its former direction: the graph jumps to the other side of the time axis.",
};
/// A graph of the place in place of the velocity.
pub const PLACE_DRAWN: Misconception = Misconception {
    id: "position-drawn-as-velocity",
    does: "takes the shape of the position for that of the velocity",
    ask: "What does the graph show at the moment at which the body turns round: the top of a curve, or zero?",
    hint: "The velocity is the slope of the graph of the position.",
};
/// Every rebound taken for an elastic one.
pub const ELASTIC_BY_SEPARATION: Misconception = Misconception {
    id: "elastic-because-they-separate",
    does: "takes an impact for elastic because the bodies separate again",
    ask: "Do the bodies separate as fast as they approached each other? What does that say of the kinetic energy?",
    hint: "An impact is elastic only if no kinetic energy is lost: the coefficient of restitution is then one.",
};
/// Every loss taken for a plastic impact.
pub const PLASTIC_BY_LOSS: Misconception = Misconception {
    id: "plastic-because-energy-is-lost",
    does: "takes an impact for perfectly plastic because kinetic energy is lost",
    ask: "Do the bodies stay together after the impact, or do they separate?",
    hint: "Energy is lost in every impact that is not elastic; a perfectly plastic one is that after which the bodies stay together.",
};

/// Every one of them.
pub const CONCEPTS: &[&Misconception] = &[
    &MOMENTUM_BY_ENERGY,
    &ENERGY_BY_MOMENTUM,
    &PART_FOR_SYSTEM,
    &OUTSIDE_OVERLOOKED,
    &ANGULAR_BY_LINEAR,
    &ORDINARY_AS_IMPULSIVE,
    &IMPULSIVE_AS_ORDINARY,
    &ENOUGH_OVERLOOKED,
    &EQUATIONS_NOT_COUNTED,
    &MOMENTUM_KEPT,
    &AFTER_REVERSED,
    &STATE_AS_FORCE,
    &FORCE_AS_STATE,
    &FORCE_AS_CONSTANT,
    &FORCE_FADES,
    &REBOUND_OVERLOOKED,
    &PLACE_DRAWN,
    &ELASTIC_BY_SEPARATION,
    &PLASTIC_BY_LOSS,
];
