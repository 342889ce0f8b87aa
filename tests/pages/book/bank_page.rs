//! The table of the whole bank.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Arc;

use momentous::bank::{Bank, Card};
use momentous::laws::Law;
use momentous::problem::{PartKind, Problem, compile, load};
use momentous::quantity::UnitSystem;
use momentous::scene::Stage;
use rayon::prelude::*;

/// What is told of the bank, read from its compiled problems.
pub struct Survey {
    problems: Vec<(Card, Arc<Problem>)>,
}

/// The topics in the order in which a course meets them, each with its heading.
const TOPICS: [(&str, &str); 12] = [
    ("impulse", "Linear impulse and momentum"),
    ("vectors", "Vectors"),
    ("angular-momentum", "Angular impulse and momentum"),
    ("central-force", "Central force"),
    ("mass-centre", "Systems of particles and the centre of mass"),
    ("conservation", "Conservation of momentum"),
    ("impact", "Impact"),
    ("bouncing", "Bouncing"),
    ("chains", "Chains of stages"),
    ("strings", "Strings"),
    ("streams", "Streams and variable mass"),
    ("concepts", "Questions that are not a number"),
];

impl Survey {
    pub fn of_the_bank() -> Self {
        let bank = Bank::built_in();
        let sources: Vec<_> = bank.sources().cloned().collect();
        let compiled = sources.into_par_iter().map(|source| {
            let loaded = load(source).unwrap_or_else(|faults| panic!("{faults}"));
            let card = Card::of(&loaded);
            let problem = compile(loaded, None).unwrap_or_else(|faults| panic!("{faults}"));
            (card, Arc::new(problem))
        });
        Self { problems: compiled.collect() }
    }

    /// The problems with an answer that needs a law, by identity and title.
    pub fn using(&self, law: &Law) -> Vec<(&str, &str)> {
        let uses = |problem: &Problem| problem.forms().iter().any(|form| problem.laws(form).contains(&law));
        let users = self.problems.iter().filter(|(_, problem)| uses(problem));
        users.map(|(card, _)| (card.id.as_str(), card.title.as_str())).collect()
    }

    pub fn page(&self) -> String {
        let mut page = String::from(
            "# The bank\n\nThese problems are part of the program. `momentous generate ID --seed 1 --solution` prints a problem with its worked solution; \
             `momentous list` prints this list. `UPDATE_DOCS=1 cargo test --test pages book` makes the table from the bank.\n\n",
        );
        page.push_str(&self.counts());
        let mut by_topic: BTreeMap<&str, Vec<&(Card, Arc<Problem>)>> = BTreeMap::new();
        for entry in &self.problems {
            by_topic.entry(&entry.0.topic).or_default().push(entry);
        }
        for (topic, heading) in TOPICS {
            let Some(entries) = by_topic.remove(topic) else { continue };
            write!(page, "\n## {heading}\n\n| problem | | level | stages | forms | units | asked |\n|---|---|---|---|---|---|---|\n").unwrap();
            for (card, problem) in entries {
                writeln!(page, "{}", row(card, problem)).unwrap();
            }
        }
        assert!(by_topic.is_empty(), "topics without a heading: {:?}", by_topic.keys());
        page
    }

    fn counts(&self) -> String {
        let count =
            |wanted: &dyn Fn(&Problem) -> bool| self.problems.iter().filter(|(_, problem)| wanted(problem)).count();
        let levels = ["intro", "core", "challenge"];
        let levels = levels
            .map(|level| format!("{} {level}", self.problems.iter().filter(|(card, _)| card.level == level).count()));
        let rows = [
            ("problems", self.problems.len()),
            ("forms in which they are asked", self.problems.iter().map(|(_, problem)| problem.forms().len()).sum()),
            ("problems with more than one form", count(&|problem| problem.forms().len() > 1)),
            ("problems with two or more stages", count(&|problem| problem.loaded().draft.scene.stages.len() > 1)),
            ("problems in US customary units", count(&|problem| problem.units() == UnitSystem::Us)),
            ("problems with a question that is not a number", count(&has_concept)),
        ];
        let mut table = String::from("| | |\n|---|---|\n");
        for (what, number) in rows {
            writeln!(table, "| {what} | {number} |").unwrap();
        }
        writeln!(table, "| levels | {} |", levels.join(", ")).unwrap();
        table
    }
}

fn has_concept(problem: &Problem) -> bool {
    problem.forms().iter().flat_map(|form| &form.parts).any(|part| matches!(part.kind, PartKind::Choice(_)))
}

fn row(card: &Card, problem: &Problem) -> String {
    let draft = &problem.loaded().draft;
    let stages: Vec<&str> = draft.scene.stages.iter().map(Stage::key).collect();
    let forms: Vec<String> =
        card.forms.iter().filter(|form| !form.is_empty()).map(|form| format!("`{form}`")).collect();
    let mut asked: Vec<String> = Vec::new();
    for part in problem.forms().iter().flat_map(|form| &form.parts) {
        let concept = matches!(part.kind, PartKind::Choice(_));
        let name = if concept { "concept".to_owned() } else { format!("`{}`", part.id) };
        if !asked.contains(&name) {
            asked.push(name);
        }
    }
    let units = if problem.units() == UnitSystem::Us { "US" } else { "SI" };
    let cells = [
        format!("`{}`", card.id),
        card.title.clone(),
        card.level.to_owned(),
        stages.join(", "),
        forms.join(", "),
        units.to_owned(),
        asked.join(", "),
    ];
    format!("| {} |", cells.join(" | "))
}
