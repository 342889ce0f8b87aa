//! One sheet that is to be made, for one student or for nobody in particular: a problem, or all those of a homework.

use std::sync::Arc;

use serde_json::Value;
use serde_json::json;

use crate::bank::Homework;
use crate::cli::failure::Failure;
use crate::cli::pages::SolutionOptions;
use crate::exercise::Drawer;
use crate::exercise::Exercise;
use crate::exercise::SeedSource;
use crate::problem::Scheme;
use crate::render::Heading;
use crate::render::KeyRow;
use crate::render::Page;
use crate::render::Renderer;
use crate::render::Sheet;
use crate::render::SheetPlace;

use super::asked::Asked;
use super::asked::said;
use super::roster::Sitter;

/// Questions on each sheet.
#[derive(Clone, Debug)]
pub(super) enum Wanted {
    /// One problem: each has sheets of its own.
    Each(Vec<Asked>),
    /// All problems of a homework.
    Together(Arc<Homework>, Vec<Asked>),
}

/// One sheet that is to be made.
#[derive(Clone, Debug)]
pub(super) struct Job {
    /// Its problems, each with its seed.
    questions: Vec<(Asked, u64)>,
    homework: Option<Arc<Homework>>,
    /// The number that stands for the seeds in the name of its files.
    number: u64,
    scheme: Scheme,
    sitter: Option<Sitter>,
}

impl Wanted {
    /// The problems.
    pub(super) fn asked(&self) -> &[Asked] {
        match self {
            Self::Each(asked) | Self::Together(_, asked) => asked,
        }
    }

    /// The number of sheets for each student, or each seed.
    pub(super) fn sheets_each(&self) -> u64 {
        self.sheets().len() as u64
    }

    /// The problems of each sheet.
    fn sheets(&self) -> Vec<&[Asked]> {
        match self {
            Self::Each(asked) => asked.iter().map(std::slice::from_ref).collect(),
            Self::Together(_, asked) => vec![asked],
        }
    }

    fn homework(&self) -> Option<Arc<Homework>> {
        match self {
            Self::Each(_) => None,
            Self::Together(homework, _) => Some(Arc::clone(homework)),
        }
    }

    /// The sheets with the numbers from the first on.
    pub(super) fn for_seeds(
        &self,
        first: u64,
        count: u64,
        scheme: Scheme,
    ) -> Result<Box<dyn Iterator<Item = Job> + '_>, Failure> {
        let last = first.checked_add(count - 1);
        let last = last.ok_or_else(|| Failure::unusable(format!("there are not {count} seeds from {first} on")))?;
        let numbered = move |asked: &'_ [Asked]| {
            let asked = asked.to_vec();
            (first..=last).map(move |number| Job {
                questions: asked.iter().map(|question| (question.clone(), question.numbered_seed(number))).collect(),
                homework: self.homework(),
                number,
                scheme,
                sitter: None,
            })
        };
        Ok(Box::new(self.sheets().into_iter().flat_map(numbered)))
    }

    /// For each student every sheet.
    pub(super) fn for_students<'a>(
        &'a self,
        sitters: &'a [Sitter],
        seeds: SeedSource<'a>,
        scheme: Scheme,
    ) -> Box<dyn Iterator<Item = Job> + 'a> {
        let of_sitter = move |sitter: &'a Sitter| {
            self.sheets().into_iter().map(move |asked| Job {
                questions: asked
                    .iter()
                    .map(|question| (question.clone(), question.seed_of(&sitter.student.id, seeds)))
                    .collect(),
                homework: self.homework(),
                number: 0,
                scheme,
                sitter: Some(sitter.clone()),
            })
        };
        Box::new(sitters.iter().flat_map(of_sitter))
    }
}

impl Job {
    /// The variants, solved.
    pub(super) fn exercises(&self) -> Result<Vec<Exercise>, Failure> {
        let drawn = |(asked, seed): &(Asked, u64)| {
            Drawer::new(&asked.problem, asked.form)
                .and_then(|mut drawer| drawer.draw_by(*seed, self.scheme))
                .map_err(|reason| Failure::no_variant(asked.problem.id(), *seed, &reason))
        };
        self.questions.iter().map(drawn).collect()
    }

    /// The student, as documents show him or her.
    fn shown(&self) -> Option<String> {
        self.sitter.as_ref().map(|sitter| sitter.student.shown())
    }

    /// The sheet, with the student's name: a page for each problem.
    pub(super) fn sheet(&self, exercises: &[Exercise]) -> Vec<Page> {
        let page = |(exercise, (asked, _)): (&Exercise, &(Asked, u64))| {
            let sheet = exercise.sheet();
            Page::Sheet(match (&self.homework, &asked.slot) {
                (Some(homework), Some((number, slot))) => {
                    let heading = (*number == 1).then(|| Heading {
                        course: homework.course.clone(),
                        title: homework.title.clone(),
                        date: homework.date.clone(),
                        points: homework.points().to_f64().value(),
                    });
                    let student = heading.as_ref().and_then(|_| self.shown());
                    let mut parts = sheet.parts;
                    for (shown, part) in parts.iter_mut().zip(&exercise.worked().form.parts) {
                        shown.points = slot.worth.get(&part.id).map(|worth| worth.to_f64().value());
                    }
                    let (place, room) = (Some(Box::new(SheetPlace { number: *number, heading })), homework.room);
                    Sheet { place, student, parts, room, ..sheet }
                }
                _ => Sheet { student: self.shown(), ..sheet },
            })
        };
        exercises.iter().zip(&self.questions).map(page).collect()
    }

    /// The worked solutions.
    pub(super) fn solutions(&self, exercises: &[Exercise], shown: SolutionOptions) -> Vec<Page> {
        let page = |(exercise, (asked, _)): (&Exercise, &(Asked, u64))| {
            let mut solution = shown.solution(exercise);
            if let Some((number, _)) = &asked.slot {
                solution.outline.title = format!("{number}. {}", solution.outline.title);
            }
            Page::Solution(solution)
        };
        exercises.iter().zip(&self.questions).map(page).collect()
    }

    /// The answers, with the student's name.
    pub(super) fn key(&self, exercises: &[Exercise]) -> Vec<KeyRow> {
        let rows = |(exercise, (asked, _)): (&Exercise, &(Asked, u64))| {
            let number = asked.slot.as_ref().map(|(number, _)| number.to_string()).unwrap_or_default();
            let named = |row: KeyRow| KeyRow { student: self.shown(), part: format!("{number}{}", row.part), ..row };
            exercise.key().into_iter().map(named).collect::<Vec<_>>()
        };
        exercises.iter().zip(&self.questions).flat_map(rows).collect()
    }

    /// The data, with the student; of a homework one object with its problems.
    pub(super) fn record(&self, shown: Option<SolutionOptions>, renderer: &Renderer) -> Result<Value, Failure> {
        let mut records = Vec::new();
        for (exercise, (asked, _)) in self.exercises()?.iter().zip(&self.questions) {
            let solution = shown.map(|shown| shown.markdown(renderer, exercise)).transpose()?;
            let mut record = exercise.record(solution);
            if let (Some((number, slot)), Some(object)) = (&asked.slot, record.as_object_mut()) {
                object.insert("number".to_owned(), json!(number));
                let worth = slot.worth.iter().map(|(part, worth)| (part.clone(), json!(worth.to_f64().value())));
                object.insert("worth".to_owned(), Value::Object(worth.collect()));
            }
            records.push(record);
        }
        let mut record = match &self.homework {
            Some(homework) => json!({ "homework": homework.title, "date": homework.date, "problems": records }),
            None => records.pop().unwrap_or_default(),
        };
        if let (Some(Sitter { student, .. }), Some(object)) = (&self.sitter, record.as_object_mut()) {
            object.insert("student".to_owned(), json!({ "id": student.id, "name": student.name }));
        }
        Ok(record)
    }

    /// The name of its files without an ending: `impact-two-carts-find-e-seed-7`, or `student-17-impact-two-carts-find-e`.
    pub(super) fn file_stem(&self) -> String {
        let stem = self.questions.first().map_or("", |(asked, _)| &asked.stem);
        match &self.sitter {
            Some(sitter) => sitter.file_stem(stem),
            None => format!("{stem}-seed-{}", self.number),
        }
    }

    /// The name in a message.
    pub(super) fn said(&self) -> String {
        let asked = match (&self.homework, self.questions.first()) {
            (Some(homework), _) => homework.title.clone(),
            (None, Some((asked, _))) => said(&asked.problem, asked.form),
            (None, None) => String::new(),
        };
        match &self.sitter {
            Some(sitter) => format!("{asked} of {}", sitter.student.id),
            None => asked,
        }
    }
}
