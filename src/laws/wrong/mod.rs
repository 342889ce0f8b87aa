//! The common mistakes, as data: what a student does, what to ask about it, and the equation that comes of it. A law's row
//! names its wrong forms; [`reading`] holds the mistakes that are made before any law is used, and after, and [`data`] those about
//! what is given and asked.

pub mod angular;
pub mod bouncing;
pub mod circle;
pub mod concept;
pub mod cone;
pub mod data;
pub mod energy;
pub mod force;
pub mod friction;
pub mod geometry;
pub mod inertia;
pub mod integral;
pub mod joint;
pub mod kinematics;
pub mod line_slip;
pub mod mass_centre;
pub mod momentum;
pub mod motion;
pub mod orbit;
pub mod reading;
pub mod relation;
pub mod resistance;
pub mod restitution;
mod rewrite;
pub mod separation;
pub mod squares;
pub mod stream;
pub mod variable_mass;
mod wrong_form;

pub use wrong_form::{Misconception, Taught, Wrong, WrongForm};

/// Every mistake by chapter, those of laws first, each once.
#[must_use]
pub fn all() -> Vec<(&'static str, Vec<&'static Misconception>)> {
    let mut seen: Vec<&'static Misconception> = Vec::new();
    let mut once = |of: &mut dyn Iterator<Item = &'static Misconception>| {
        let fresh: Vec<_> = of
            .filter(|kind| {
                if seen.contains(kind) {
                    false
                } else {
                    seen.push(kind);
                    true
                }
            })
            .collect();
        fresh
    };
    let mut rows: Vec<_> = super::CHAPTERS
        .iter()
        .map(|chapter| (chapter.title, once(&mut chapter.laws.iter().flat_map(|law| law.wrong).map(|form| form.of))))
        .collect();
    rows.push(("Reading the question", once(&mut reading::MISREADINGS.iter().map(|row| row.of))));
    rows.push(("Using the data", once(&mut data::ALTERED.iter().map(|row| row.of))));
    rows.push(("Answering another question", once(&mut data::TAKEN.iter().copied().chain([&data::OTHER_ROOT]))));
    rows.push(("Writing the answer", once(&mut reading::SLIPS.iter().map(|row| row.of))));
    rows.push(("Slips in one line", once(&mut line_slip::LINE_SLIPS.iter().map(|slip| slip.of))));
    rows.push(("Judging a scene", once(&mut concept::CONCEPTS.iter().copied())));
    rows.retain(|(_, kinds)| !kinds.is_empty());
    rows
}

/// The mistake of that id.
///
/// ```
/// use momentous_laws::wrong::find;
/// assert_eq!(find("restitution-inverted").map(|kind| kind.does), Some("divides by the coefficient of restitution"));
/// ```
#[must_use]
pub fn find(id: &str) -> Option<&'static Misconception> {
    all().into_iter().flat_map(|(_, kinds)| kinds).find(|kind| kind.id == id)
}
