//! Mistakes about the data: a given left out or put in the place of another, and the right value of another quantity.

use super::Misconception;
use super::bouncing::HEIGHT_BY_E;
use super::geometry::COMPONENT_FOR_MAGNITUDE;
use super::momentum::GRAVITY_REVERSED;
use super::momentum::OTHER_MASS;

/// The masses of two bodies in each other's place.
pub const MASSES_EXCHANGED: Misconception = Misconception {
    id: "masses-exchanged",
    does: "uses the mass of each body for the other",
    ask: "Which mass belongs to which body? Write each mass next to the velocity of its own body.",
    hint: "Check each term: the mass and the velocity in it must belong to the same body.",
};
/// Velocities where momenta belong.
pub const MASSES_EQUAL: Misconception = Misconception {
    id: "masses-taken-as-equal",
    does: "treats all bodies as if they had the same mass",
    ask: "Do the bodies have the same mass? Which quantity is conserved, or changed by an impulse: velocity, or momentum?",
    hint: "Multiply each velocity by the mass of its own body before you add.",
};
/// A mass that is missing.
pub const MASS_LEFT_OUT: Misconception = Misconception {
    id: "mass-left-out",
    does: "leaves the mass of one body out",
    ask: "Which bodies move together, or act on each other? Is the mass of one of them missing?",
    hint: "List the masses that are given, and find the place of each in your equations.",
};
/// A velocity that is missing.
pub const VELOCITY_LEFT_OUT: Misconception = Misconception {
    id: "velocity-left-out",
    does: "leaves a given velocity out, as if it were zero",
    ask: "Was everything at rest at the start? Which of the given velocities is missing from your calculation?",
    hint: "What you found may be a change only: a velocity afterwards is the velocity before plus its change.",
};
/// A velocity of the wrong sign.
pub const VELOCITY_REVERSED: Misconception = Misconception {
    id: "given-velocity-reversed",
    does: "gives one of the given velocities the opposite sign",
    ask: "In which direction does each given velocity point, and which direction is positive?",
    hint: "Draw the axis and an arrow for each given velocity, and compare their signs with yours.",
};
/// Gravity that is missing.
pub const GRAVITY_LEFT_OUT: Misconception = Misconception {
    id: "gravity-left-out",
    does: "leaves the weight out",
    ask: "Does weight act during this motion? In which of your equations does it stand?",
    hint: "Draw every force in each part of the motion: weight acts in all of them.",
};
/// A mass where a weight belongs.
pub const MASS_AS_WEIGHT: Misconception = Misconception {
    id: "mass-as-weight",
    does: "uses a mass where a weight belongs",
    ask: "Is a mass or a weight needed here? Where does the acceleration of free fall enter?",
    hint: "A weight is the mass times the acceleration of free fall.",
};
/// A weight where a mass belongs.
pub const WEIGHT_FOR_MASS: Misconception = Misconception {
    id: "weight-for-mass",
    does: "uses a weight where a mass belongs",
    ask: "Is a mass or a weight needed in a momentum? Where have you multiplied by the acceleration of free fall?",
    hint: "Momentum is mass times velocity: the weight has no place in it.",
};
/// An angle that is missing.
pub const ANGLE_LEFT_OUT: Misconception = Misconception {
    id: "angle-left-out",
    does: "leaves a given angle out, as if everything lay along one line",
    ask: "Do all the arrows lie along one line? Where does the given angle enter?",
    hint: "Resolve each arrow into components, and add only what lies along the same axis.",
};
/// A duration that is missing.
pub const DURATION_LEFT_OUT: Misconception = Misconception {
    id: "duration-left-out",
    does: "leaves a given time out: an impulse for a force, or a force for an impulse",
    ask: "Is a force asked, or an impulse? Where does the given time enter?",
    hint: "An impulse is an average force times the time for which it acts: check the units of your answer.",
};
/// A force that is missing.
pub const FORCE_LEFT_OUT: Misconception = Misconception {
    id: "force-left-out",
    does: "leaves a given force, moment or impulse out, or its growth",
    ask: "Which forces act all this time, and do they stay the same? Which of those that are given is missing from your sum?",
    hint: "Draw every force, then find the place of each given one in your equations.",
};
/// The coefficients of two impacts in each other's place.
pub const COEFFICIENTS_EXCHANGED: Misconception = Misconception {
    id: "coefficients-exchanged",
    does: "uses the coefficient of restitution of one impact for another",
    ask: "Which coefficient of restitution belongs to which impact?",
    hint: "Name the surfaces in the order in which they are struck, each with its coefficient.",
};
/// The coefficient once too often.
pub const RESTITUTION_SQUARED: Misconception = Misconception {
    id: "restitution-squared",
    does: "squares the coefficient of restitution where speeds are compared",
    ask: "Are speeds compared here, or heights or energies? With which power does the coefficient of restitution enter?",
    hint: "Each impact multiplies the relative speed by the coefficient once; heights and energies get its square.",
};

/// Another instant.
pub const ANOTHER_INSTANT: Misconception = Misconception {
    id: "value-at-another-instant",
    does: "gives the value at an earlier or a later instant",
    ask: "At which instant is this quantity asked, and at which one does it have your value?",
    hint: "Your value is right at another instant. What happens between the two?",
};
/// Another body.
pub const ANOTHER_BODY: Misconception = Misconception {
    id: "value-of-another-body",
    does: "gives the value of another body",
    ask: "Which body is asked about? Whose value have you written down?",
    hint: "Your value is right for another body.",
};
/// Another quantity of the same dimension.
pub const ANOTHER_QUANTITY: Misconception = Misconception {
    id: "value-of-another-quantity",
    does: "gives the value of another quantity that occurs in the solution",
    ask: "Read the question again: is this the quantity that is asked?",
    hint: "Your value is that of another quantity in this problem. One step is still missing, or one is too many.",
};

/// A root that is not possible.
pub const OTHER_ROOT: Misconception = Misconception {
    id: "other-root",
    does: "takes the root of a quadratic equation that is not possible here",
    ask: "A quadratic equation has two roots. What would have to happen for yours to be true?",
    hint: "Put your value into the story: bodies do not pass through each other, and time does not run backwards.",
};

/// The mass of all for that of one.
pub const TOTAL_MASS: Misconception = Misconception {
    id: "total-mass-for-one",
    does: "uses the mass of all bodies where that of one belongs",
    ask: "Which body does each of your equations speak of, and what is the mass of that body alone?",
    hint: "Only where bodies move together does the sum of their masses stand in an equation.",
};
/// The velocity of another instant in one place.
pub const OTHER_INSTANT: Misconception = Misconception {
    id: "velocity-of-another-instant",
    does: "uses the velocity that a body has at another instant",
    ask: "At which instant is each velocity in your equations taken?",
    hint: "Number the instants, before and after each event, and give every velocity in your equations its number.",
};
/// The velocity of another body in one place.
pub const OTHER_BODY: Misconception = Misconception {
    id: "velocity-of-another-body",
    does: "uses the velocity of another body",
    ask: "Whose velocity is each of those in your equations?",
    hint: "The mass and the velocity in a momentum, or in an energy, belong to the same body.",
};
/// An angle on the other side of the line.
pub const ANGLE_REVERSED: Misconception = Misconception {
    id: "given-angle-reversed",
    does: "turns a given angle to the other side of the line from which it is measured",
    ask: "On which side of the line does each given angle lie?",
    hint: "Draw every arrow with its angle: those on opposite sides of the line have components of opposite signs across it.",
};

/// Which givens a mistake is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Givens {
    /// Masses, and weights in their place.
    Masses,
    /// Masses as they stand in one equation, given or found from weights.
    MassesOfOneEquation,
    /// Velocities, and angular velocities.
    Velocities,
    /// Velocities as they stand in one equation, given or not.
    VelocitiesOfOneEquation,
    /// The acceleration of free fall, where no weight is given.
    Gravity,
    /// Angles.
    Angles,
    /// Durations.
    Durations,
    /// Forces, moments and impulses, and how fast they grow.
    Forces,
    /// Coefficients of restitution.
    Restitutions,
    /// The coefficient of restitution of bounces that are counted.
    RestitutionOfHeights,
}

impl Givens {
    /// Whether they are got wrong in one equation, and right in the others.
    #[must_use]
    pub fn is_of_one_equation(self) -> bool {
        matches!(self, Self::MassesOfOneEquation | Self::VelocitiesOfOneEquation)
    }
}

/// What a student puts in the place of givens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alteration {
    /// Two of them stand in each other's place.
    Exchanged,
    /// All of them have the value of the first.
    Equal,
    /// One of them has the value of another.
    Copied,
    /// One of them has the value of the same quantity at another instant.
    AtAnotherInstant,
    /// One of them has the value of the same quantity of another body.
    OfAnotherBody,
    /// One of them has the value of all together.
    Together,
    /// One of them is zero.
    Missing,
    /// One of them is zero; or all of them, or all but one.
    Zero,
    /// One of them is zero, and what is found from it has the opposite sign: a change without its direction.
    OnlyChange,
    /// All of them are multiplied by the acceleration of free fall.
    Weighed,
    /// One of them has the opposite sign.
    Reversed,
    /// One of them is one unit of its dimension, which leaves no trace in a product.
    One,
    /// One of them is squared.
    Squared,
    /// The square root of one of them.
    Rooted,
}

/// A mistake about what is given.
#[derive(Debug)]
pub struct Altered {
    /// The mistake.
    pub of: &'static Misconception,
    /// The givens that it is about.
    pub givens: Givens,
    /// What becomes of them.
    pub how: Alteration,
}

/// Every mistake about what is given.
pub const ALTERED: &[Altered] = &[
    Altered { of: &MASSES_EXCHANGED, givens: Givens::Masses, how: Alteration::Exchanged },
    Altered { of: &MASSES_EQUAL, givens: Givens::Masses, how: Alteration::Equal },
    Altered { of: &MASS_LEFT_OUT, givens: Givens::Masses, how: Alteration::Zero },
    Altered { of: &MASS_LEFT_OUT, givens: Givens::MassesOfOneEquation, how: Alteration::Missing },
    Altered { of: &OTHER_MASS, givens: Givens::MassesOfOneEquation, how: Alteration::Copied },
    Altered { of: &TOTAL_MASS, givens: Givens::MassesOfOneEquation, how: Alteration::Together },
    Altered { of: &VELOCITY_LEFT_OUT, givens: Givens::Velocities, how: Alteration::Zero },
    Altered { of: &VELOCITY_LEFT_OUT, givens: Givens::Velocities, how: Alteration::OnlyChange },
    Altered { of: &OTHER_INSTANT, givens: Givens::VelocitiesOfOneEquation, how: Alteration::AtAnotherInstant },
    Altered { of: &OTHER_BODY, givens: Givens::VelocitiesOfOneEquation, how: Alteration::OfAnotherBody },
    Altered { of: &WEIGHT_FOR_MASS, givens: Givens::Masses, how: Alteration::Weighed },
    Altered { of: &VELOCITY_REVERSED, givens: Givens::Velocities, how: Alteration::Reversed },
    Altered { of: &GRAVITY_LEFT_OUT, givens: Givens::Gravity, how: Alteration::Zero },
    Altered { of: &MASS_AS_WEIGHT, givens: Givens::Gravity, how: Alteration::One },
    Altered { of: &GRAVITY_REVERSED, givens: Givens::Gravity, how: Alteration::Reversed },
    Altered { of: &ANGLE_LEFT_OUT, givens: Givens::Angles, how: Alteration::Zero },
    Altered { of: &ANGLE_REVERSED, givens: Givens::Angles, how: Alteration::Reversed },
    Altered { of: &FORCE_LEFT_OUT, givens: Givens::Forces, how: Alteration::Zero },
    Altered { of: &DURATION_LEFT_OUT, givens: Givens::Durations, how: Alteration::One },
    Altered { of: &COEFFICIENTS_EXCHANGED, givens: Givens::Restitutions, how: Alteration::Exchanged },
    Altered { of: &RESTITUTION_SQUARED, givens: Givens::Restitutions, how: Alteration::Squared },
    Altered { of: &HEIGHT_BY_E, givens: Givens::RestitutionOfHeights, how: Alteration::Rooted },
];

/// The mistakes of writing down the value of another quantity.
pub const TAKEN: &[&Misconception] = &[&ANOTHER_INSTANT, &ANOTHER_BODY, &COMPONENT_FOR_MAGNITUDE, &ANOTHER_QUANTITY];
