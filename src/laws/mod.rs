//! The laws of the subject, a table by chapter. Each law states itself, its sign convention, when it applies and where it
//! comes from; beside its row stands the function that writes its equation for given terms.

pub mod angular;
pub mod bouncing;
pub mod energy;
pub mod force;
pub mod geometry;
pub mod kinematics;
pub mod mass_centre;
pub mod momentum;
pub mod motion;
pub mod orbit;
pub mod restitution;
pub mod separation;
pub mod variable_mass;
pub mod wrong;

/// One law, as a row of its chapter's table.
#[derive(Debug)]
pub struct Law {
    /// A stable name for tools and tests: `conservation-of-momentum`.
    pub id: &'static str,
    /// What it is called in a sentence: `conservation of linear momentum`.
    pub name: &'static str,
    /// What it says, in words.
    pub statement: &'static str,
    /// Which directions count as positive.
    pub signs: &'static str,
    /// When it may be used.
    pub when: &'static str,
    /// Where it comes from: the chapter of mechanics, or the law that it follows from.
    pub source: &'static str,
    /// The forms in which it is usually got wrong.
    pub wrong: &'static [wrong::WrongForm],
}

impl PartialEq for Law {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for Law {}

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
    ("Bouncing", bouncing::LAWS),
    ("Streams and variable mass", variable_mass::LAWS),
];

/// The law of that id.
///
/// ```
/// assert_eq!(momentous::laws::find("restitution").map(|law| law.name), Some("the law of restitution"));
/// ```
#[must_use]
pub fn find(id: &str) -> Option<&'static Law> {
    CHAPTERS.iter().flat_map(|(_, laws)| laws.iter()).find(|law| law.id == id).copied()
}

/// The two sides of an equation, as they are taught.
pub type Sides = (crate::expr::Expr, crate::expr::Expr);
