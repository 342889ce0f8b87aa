//! The laws of the subject, a table by chapter. Each law states itself, its sign convention, when it applies and where it
//! comes from; beside its row stands the function that writes its equation for given terms.

pub mod angular;
pub mod bouncing;
pub mod energy;
pub mod force;
pub mod geometry;
pub mod kinematics;
mod law;
pub mod mass_centre;
pub mod momentum;
pub mod motion;
pub mod orbit;
pub mod resistance;
pub mod restitution;
pub mod separation;
mod sides;
pub mod variable_mass;
pub mod wrong;

pub use law::Law;
pub use sides::Sides;

/// Every chapter's laws, in the order in which a course teaches them.
pub const CHAPTERS: &[(&str, &[&Law])] = &[
    ("Components and magnitudes", geometry::LAWS),
    ("Forces and their impulses", force::LAWS),
    ("Linear impulse and momentum", momentum::LAWS),
    ("Systems of particles", mass_centre::LAWS),
    ("Impact and restitution", restitution::LAWS),
    ("Separation and guided bodies", separation::LAWS),
    ("Energy", energy::LAWS),
    ("Angular impulse and momentum", angular::LAWS),
    ("Central force of gravity", orbit::LAWS),
    ("Motions given as functions", motion::LAWS),
    ("Motion between impacts", kinematics::LAWS),
    ("Motion against resistance", resistance::LAWS),
    ("Bouncing", bouncing::LAWS),
    ("Streams and variable mass", variable_mass::LAWS),
];

/// The law of that id.
///
/// ```
/// assert_eq!(momentous_laws::find("restitution").map(|law| law.name), Some("the law of restitution"));
/// ```
#[must_use]
pub fn find(id: &str) -> Option<&'static Law> {
    CHAPTERS.iter().flat_map(|(_, laws)| laws.iter()).find(|law| law.id == id).copied()
}
