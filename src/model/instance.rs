//! A law as it is used in one scene.

use crate::expr::Expr;
use crate::expr::Symbol;
use crate::laws::Law;

/// One use of a law: which, in which stage, and why it may be used there.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The law.
    pub law: &'static Law,
    /// Why it applies here, as a sentence without a full stop.
    pub because: String,
    /// The stage in which it is used, counted from 0; none for a relation at one instant.
    pub stage: Option<usize>,
    /// The integral that the equation's right side is the value of, where the law defines one.
    pub integral: Option<Integral>,
}

/// A definite integral, to be shown before its value.
#[derive(Clone, Debug)]
pub struct Integral {
    /// What is integrated.
    pub integrand: Expr,
    /// Over what.
    pub variable: Symbol,
    /// From where.
    pub low: Expr,
    /// To where.
    pub high: Expr,
}

/// In which sense something is left out of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Omitted {
    /// It is small, or idealised away: air resistance, the mass of a string.
    Neglected,
    /// It acts, but across the motion, within the system or on the support: its equation is not needed.
    NotNeeded,
}

/// Something that is left out of the model on purpose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// Whether it is neglected, or has no part in what is asked.
    pub kind: Omitted,
    /// What is left out: `weight`.
    pub what: String,
    /// Why that is right: `it is not impulsive: during the short contact its impulse is negligible`.
    pub why: String,
}

/// An impulse in a stage, for diagrams and for questions about which momentum is conserved.
#[derive(Clone, Debug)]
pub struct Impulse {
    /// The stage, counted from 0.
    pub stage: usize,
    /// The short name of the body on which it acts.
    pub on: String,
    /// What gives it.
    pub by: Agent,
    /// What it is called: `the contact with cart B`, `the thrust`, `weight`.
    pub called: String,
    /// Its components along the scene's axes, in their order; none where it is only one magnitude along `line`.
    pub components: Vec<Expr>,
    /// Whether it belongs to a short impact, in which ordinary forces have no time to act.
    pub impulsive: bool,
}

/// What gives an impulse.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Agent {
    /// Another body of the scene.
    Body(String),
    /// A surface of the scene.
    Surface(String),
    /// What guides a body, at right angles to the way in which it lets it move.
    Guide,
    /// Something outside the scene: a hand, an engine, the earth.
    Outside,
}

/// What a root or a regime must satisfy, and what to say where it does not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reason {
    /// What to say of a root that breaks it, as a clause: `the bodies would pass through each other`.
    pub text: String,
    /// What an author may allow by name; none where it only tells one way of a scene from another.
    pub warning: Option<Warning>,
}

/// What is unphysical about a solution, by the names that authors write under `allow`.
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
    /// A cord or a string would go slack.
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
