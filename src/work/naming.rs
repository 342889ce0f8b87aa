//! The laws that only give a name to something: using them is no step of a solution.

use momentous_laws::Law;

/// The laws that name a quantity, take a vector apart or say again what the text says.
const NAMING: [&str; 30] = [
    "angle-between",
    "boundary-of-a-condition",
    "components",
    "count",
    "counted-direction",
    "direction",
    "end-of-the-motion",
    "expression-asked",
    "kinetic-energy",
    "magnitude",
    "mass-of-the-parts",
    "momentum",
    "place-after-a-displacement",
    "place-as-told",
    "potential-energy",
    "rate-of-momentum",
    "relative-displacement",
    "relative-velocity",
    "rest",
    "same-velocity",
    "speed",
    "speed-ratio",
    "start-from-rest",
    "stated-relation",
    "times-add-up",
    "together-before",
    "total-mass",
    "turned-axes",
    "velocity-as-told",
    "weight",
];

/// Whether a law only names something.
pub(crate) fn is_naming(law: &Law) -> bool {
    NAMING.contains(&law.id)
}
