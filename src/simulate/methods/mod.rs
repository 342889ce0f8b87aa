//! The numerical methods, cheapest first, one file each.

mod closed_form;
mod event_driven;
mod explicit_euler;
mod kind;
mod linear_solve;
mod marching;
mod moreau_jean;
mod penalty;
#[cfg(feature = "peer")]
mod rapier;
mod runge_kutta;
mod sequential_impulses;
mod symplectic_euler;
mod world_step;

pub use closed_form::ClosedForm;
pub use event_driven::EventDriven;
pub use explicit_euler::ExplicitEuler;
pub use kind::{MethodKind, Setting};
pub use linear_solve::LinearSolve;
pub use moreau_jean::MoreauJean;
pub use penalty::{Penalty, STEPS_PER_CONTACT, damping_ratio};
#[cfg(feature = "peer")]
pub use rapier::Rapier;
pub use runge_kutta::RungeKutta;
pub use sequential_impulses::SequentialImpulses;
pub use symplectic_euler::SymplecticEuler;
