//! What the laws say of a system and of each of its bodies at every instant, whatever the scene asks.

use std::sync::Arc;

use momentous::exercise::Exercise;
use momentous::fault::Source;
use momentous::problem::{compile, load};

use super::draw::Drawn;
use super::table::Table;

/// Each quantity of a scene with its unit.
pub type Questions = Vec<(String, String)>;

/// Momenta, energies and the velocity of the centre of mass: of all bodies together and of each, at every instant.
pub fn totals(table: &Table, scene: &Drawn) -> Questions {
    let mut names = Vec::new();
    for at in 1..=scene.stages.len() + 1 {
        names.push(format!("T_{at}"));
        names.extend(scene.bodies.iter().map(|body| format!("T_{body}{at}")));
        for component in scene.components() {
            names.extend([format!("p_{at}{component}"), format!("v_G{at}{component}")]);
            for body in &scene.bodies {
                names.extend([format!("p_{body}{at}{component}"), format!("v_{body}{at}{component}")]);
            }
        }
    }
    names.into_iter().map(|name| (name.clone(), table.unit(&name).to_owned())).collect()
}

/// Impulses, losses, works and times of every stage.
pub fn exchanged(table: &Table, scene: &Drawn) -> Questions {
    let mut names = Vec::new();
    for at in 1..=scene.stages.len() {
        let bracket = if scene.stages.len() > 1 { format!("[{at}]") } else { String::new() };
        names.extend(["T_lost", "T_gained", "dt", "work", "tension"].map(|base| format!("{base}{bracket}")));
        for body in &scene.bodies {
            let axes = scene.components().iter().map(|component| format!("J_{body}{component}{bracket}"));
            names.extend(axes);
        }
    }
    names.into_iter().map(|name| (name.clone(), table.unit(&name).to_owned())).collect()
}

/// A scene of which everything is asked that it knows.
pub struct Solved {
    /// The problem file.
    pub file: String,
    /// The problem with its numbers.
    pub exercise: Exercise,
    /// The quantities that are asked.
    pub asked: Vec<String>,
}

impl Solved {
    /// What the laws say of a quantity.
    pub fn value(&self, name: &str) -> Option<f64> {
        said(&self.exercise, name)
    }

    /// The largest of the values whose names begin so.
    pub fn largest(&self, beginning: &str) -> f64 {
        let alike = self.asked.iter().filter(|name| name.starts_with(beginning));
        alike.filter_map(|name| self.value(name)).map(f64::abs).fold(0.0, f64::max)
    }
}

/// What the laws say of a quantity.
pub fn said(exercise: &Exercise, name: &str) -> Option<f64> {
    let symbol = exercise.problem().model().symbol_of(name)?;
    exercise.variant().value(symbol).map(|number| number.value)
}

/// A problem file with its numbers, or the refusal.
pub fn solved(file: &str) -> Result<Exercise, String> {
    let loaded = load(Source::new("scene.yaml", file)).map_err(|faults| faults.to_string())?;
    let problem = Arc::new(compile(loaded, None).map_err(|faults| faults.to_string())?);
    Exercise::draw(&problem, 0, 1).map_err(|reason| reason.to_string())
}

/// The scene with all questions that it knows; none where it is refused. `changed` makes of its file another.
pub fn asked_all(scene: &Drawn, questions: &Questions, changed: &dyn Fn(String) -> String) -> Result<Solved, String> {
    let mut questions: Questions =
        questions.iter().filter(|(name, _)| scene.given.iter().all(|(given, _)| given != name)).cloned().collect();
    loop {
        let file = changed(scene.asking(&questions));
        let faults = match solved(&file) {
            Ok(exercise) => {
                let asked = questions.into_iter().map(|(name, _)| name).collect();
                return Ok(Solved { file, exercise, asked });
            }
            Err(faults) => faults,
        };
        // Each refusal names what it is about; what is left out is asked of no other scene.
        let before = questions.len();
        questions.retain(|(name, _)| !faults.contains(&format!("`{name}`")));
        if questions.len() == before {
            return Err(format!("{faults}\n{file}"));
        }
    }
}
