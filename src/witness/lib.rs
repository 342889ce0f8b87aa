//! Variants simulated stage by stage, by methods that share no code with the laws: whatever is asked has to come out.
//!
//! What is given and what is answered is put in together, and every quantity that both the laws and the simulation know is
//! compared ([`Portion`]). The same simulations are watched as films ([`shoot`]).

mod brief;
mod case;
mod choices;
mod conserved;
mod crossing;
mod exchanged;
mod film;
mod graphs;
mod impacts;
mod integrated;
mod magnitude;
mod parts;
mod pictures;
mod record;
mod shoot;
mod simulation;
mod staging;
mod together;
mod trial;
mod turning;
mod worlds;

pub use film::{AT_ITS_TIME, Film, NotFilmed};
pub use impacts::IMPACTS;
pub use shoot::{Shot, shoot};
pub use staging::{followed, followed_least, staged};
pub use trial::{Portion, Simulated};

/// The tolerances of the two runs whose difference says how far the finer one may be off.
const TOLERANCES: [f64; 2] = [1e-11, 1e-9];
