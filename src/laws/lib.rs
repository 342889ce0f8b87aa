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

/// A chapter of a course: the laws that are taught together.
#[derive(Debug)]
pub struct Chapter {
    /// A stable name for tools and rubrics: `momentum`.
    pub id: &'static str,
    /// Its title: `Linear impulse and momentum`.
    pub title: &'static str,
    /// Its laws.
    pub laws: &'static [&'static Law],
}

/// Every chapter, in the order in which a course teaches them.
pub const CHAPTERS: &[Chapter] = &[
    Chapter { id: "components", title: "Components and magnitudes", laws: geometry::LAWS },
    Chapter { id: "force", title: "Forces and their impulses", laws: force::LAWS },
    Chapter { id: "momentum", title: "Linear impulse and momentum", laws: momentum::LAWS },
    Chapter { id: "mass-centre", title: "Systems of particles", laws: mass_centre::LAWS },
    Chapter { id: "restitution", title: "Impact and restitution", laws: restitution::LAWS },
    Chapter { id: "separation", title: "Separation and guided bodies", laws: separation::LAWS },
    Chapter { id: "energy", title: "Energy", laws: energy::LAWS },
    Chapter { id: "angular-momentum", title: "Angular impulse and momentum", laws: angular::LAWS },
    Chapter { id: "orbit", title: "Central force of gravity", laws: orbit::LAWS },
    Chapter { id: "motion", title: "Motions given as functions", laws: motion::LAWS },
    Chapter { id: "kinematics", title: "Motion between impacts", laws: kinematics::LAWS },
    Chapter { id: "resistance", title: "Motion against resistance", laws: resistance::LAWS },
    Chapter { id: "bouncing", title: "Bouncing", laws: bouncing::LAWS },
    Chapter { id: "variable-mass", title: "Streams and variable mass", laws: variable_mass::LAWS },
];

/// The law of that id.
///
/// ```
/// assert_eq!(momentous_laws::find("restitution").map(|law| law.name), Some("the law of restitution"));
/// ```
#[must_use]
pub fn find(id: &str) -> Option<&'static Law> {
    CHAPTERS.iter().flat_map(|chapter| chapter.laws).find(|law| law.id == id).copied()
}

/// The chapter of a law.
///
/// ```
/// use momentous_laws::{chapter_of, momentum};
/// assert_eq!(chapter_of(&momentum::CONSERVATION).map(|chapter| chapter.id), Some("momentum"));
/// ```
#[must_use]
pub fn chapter_of(law: &Law) -> Option<&'static Chapter> {
    CHAPTERS.iter().find(|chapter| chapter.laws.contains(&law))
}
