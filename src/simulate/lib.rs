//! Numerical methods on the same scenes, as an independent witness: they share no code with the laws.
//!
//! A [`World`] is a scene as numbers; a [`Method`] runs it within a [`Budget`] and returns a [`Trajectory`], or a [`Refusal`]
//! by name. No method returns a number that it does not stand behind, and none loops for ever.

mod acceleration;
mod apart;
mod budget;
mod contact;
#[cfg(feature = "clock")] // it reads the clock
mod drift;
mod exact;
mod force;
mod frame;
mod gap;
mod geometry;
pub mod least;
mod method;
mod methods;
mod newton;
mod ode;
mod point_impact;
mod record;
mod refusal;
pub mod scene;
mod shown;
mod simultaneous;
pub mod stability;
mod state;
#[cfg(feature = "clock")] // it reads the clock
mod sweep;
mod task;
mod trajectory;
mod truth;
mod world;

pub use budget::{Budget, Keep};
pub use contact::Contact;
#[cfg(feature = "clock")]
pub use drift::{Drift, LASTING_MOTIONS, LastingMotion, drifts, drifts_of};
pub use exact::{
    BounceTrain, Clock, Meeting, Orbit, first_contact, first_fall, grazing_cosine, repeated_cosine, repeated_decay,
};
pub use force::{Force, Piece, Strength};
pub use geometry::Geometry;
pub use method::Method;
#[cfg(feature = "peer")]
pub use methods::Rapier;
pub use methods::{
    ClosedForm, EventDriven, ExplicitEuler, LinearSolve, MethodKind, MoreauJean, Penalty, RungeKutta,
    STEPS_PER_CONTACT, SequentialImpulses, Setting, SymplecticEuler, damping_ratio,
};
pub use newton::direct_impact;
pub use point_impact::{PointImpact, PointOutcome, RestitutionLaw};
pub use record::{Moment, Pivot, Record, Recorded, RecordedImpact, RecordedWall, Tie};
pub use refusal::Refusal;
pub use shown::{End, Shown};
pub use state::{State, Vector};
#[cfg(feature = "clock")]
pub use sweep::{Errors, JITTERED_SCENES, Point, points_of, sweep};
pub use task::{CONTACT, Case, IN_THE_PLANE, ON_A_LINE, Task};
pub use trajectory::{Ending, Impact, Motion, Segment, Trajectory};
pub use truth::Truth;
pub use world::{Anchor, Body, Cord, Together, Wall, World};
