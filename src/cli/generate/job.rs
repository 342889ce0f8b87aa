//! One variant that is to be made, for one student or for nobody in particular.

use serde_json::Value;
use serde_json::json;

use crate::cli::failure::Failure;
use crate::exercise::Drawer;
use crate::exercise::Exercise;
use crate::exercise::SeedSource;
use crate::problem::Scheme;
use crate::render::KeyRow;
use crate::render::Sheet;

use super::asked::Asked;
use super::asked::said;
use super::roster::Sitter;

/// One variant that is to be made.
#[derive(Clone, Debug)]
pub(super) struct Job {
    asked: Asked,
    seed: u64,
    scheme: Scheme,
    sitter: Option<Sitter>,
}

impl Job {
    /// For each problem the seeds from the first.
    pub(super) fn for_seeds(
        asked: &[Asked],
        first: u64,
        count: u64,
        scheme: Scheme,
    ) -> Result<Box<dyn Iterator<Item = Self> + '_>, Failure> {
        let last = first.checked_add(count - 1);
        let last = last.ok_or_else(|| Failure::unusable(format!("there are not {count} seeds from {first} on")))?;
        let of = move |asked: &'_ Asked| {
            let asked = asked.clone();
            (first..=last).map(move |seed| Self { asked: asked.clone(), seed, scheme, sitter: None })
        };
        Ok(Box::new(asked.iter().flat_map(of)))
    }

    /// For each student every problem.
    pub(super) fn for_students<'a>(
        asked: &'a [Asked],
        sitters: &'a [Sitter],
        seeds: SeedSource<'a>,
        scheme: Scheme,
    ) -> Box<dyn Iterator<Item = Self> + 'a> {
        let of = move |sitter: &'a Sitter| {
            asked.iter().map(move |asked| {
                let seed = sitter.variant(asked, seeds).seed;
                Self { asked: asked.clone(), seed, scheme, sitter: Some(sitter.clone()) }
            })
        };
        Box::new(sitters.iter().flat_map(of))
    }

    /// The variant, solved.
    pub(super) fn exercise(&self) -> Result<Exercise, Failure> {
        let Asked { problem, form, .. } = &self.asked;
        Drawer::new(problem, *form)
            .and_then(|mut drawer| drawer.draw_by(self.seed, self.scheme))
            .map_err(|reason| Failure::no_variant(problem.id(), self.seed, &reason))
    }

    /// The student, as documents show him or her.
    fn shown(&self) -> Option<String> {
        self.sitter.as_ref().map(|sitter| sitter.student.shown())
    }

    /// The sheet, with the student's name.
    pub(super) fn sheet(&self, exercise: &Exercise) -> Sheet {
        Sheet { student: self.shown(), ..exercise.sheet() }
    }

    /// The answers, with the student's name.
    pub(super) fn key(&self, exercise: &Exercise) -> Vec<KeyRow> {
        let named = |row: KeyRow| KeyRow { student: self.shown(), ..row };
        exercise.key().into_iter().map(named).collect()
    }

    /// The data, with the student.
    pub(super) fn record(&self, exercise: &Exercise, solution: Option<String>) -> Value {
        let mut record = exercise.record(solution);
        if let (Some(Sitter { student, .. }), Some(object)) = (&self.sitter, record.as_object_mut()) {
            object.insert("student".to_owned(), json!({ "id": student.id, "name": student.name }));
        }
        record
    }

    /// The name of its files without an ending: `impact-two-carts-find-e-seed-7`, or `student-17-impact-two-carts-find-e`.
    pub(super) fn file_stem(&self) -> String {
        match &self.sitter {
            Some(sitter) => sitter.file_stem(&self.asked),
            None => format!("{}-seed-{}", self.asked.stem, self.seed),
        }
    }

    /// What it is, in a message.
    pub(super) fn said(&self) -> String {
        let asked = said(&self.asked.problem, self.asked.form);
        match &self.sitter {
            Some(sitter) => format!("{asked} of {}", sitter.student.id),
            None => asked,
        }
    }
}
