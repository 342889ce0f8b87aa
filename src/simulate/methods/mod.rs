//! The numerical methods, cheapest first, one file each.

pub(super) mod dormand_prince;
mod event_driven;
mod explicit_euler;
mod linear_solve;
mod marching;
mod moreau_jean;
mod penalty;
mod runge_kutta;
mod sequential_impulses;
mod symplectic_euler;

pub use event_driven::EventDriven;
pub use explicit_euler::ExplicitEuler;
pub use linear_solve::LinearSolve;
pub use moreau_jean::MoreauJean;
pub use penalty::{Penalty, STEPS_PER_CONTACT, damping_ratio};
pub use runge_kutta::RungeKutta;
pub use sequential_impulses::SequentialImpulses;
pub use symplectic_euler::SymplecticEuler;
