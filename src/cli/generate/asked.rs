//! The problems of which sheets are wanted, each in one form.

use std::sync::Arc;

use crate::bank::Homework;
use crate::bank::Slot;
use crate::cli::failure::Failure;
use crate::cli::open;
use crate::exercise::SeedSource;
use crate::problem::Problem;

use super::names;

/// A problem with the form in which it is asked.
#[derive(Clone, Debug)]
pub(super) struct Asked {
    pub problem: Arc<Problem>,
    pub form: usize,
    /// Its part of the names of files: `impact-two-carts-find-e`.
    pub stem: String,
    /// Its place in a homework, from 1, and what it is worth there.
    pub slot: Option<(usize, Arc<Slot>)>,
}

impl Asked {
    /// Each problem in the form of that name, or in its first.
    pub(super) fn all(problems: &[Arc<Problem>], form: Option<&str>) -> Result<Vec<Self>, Failure> {
        let forms = problems.iter().map(|problem| open::form(problem, form)).collect::<Result<Vec<usize>, _>>()?;
        let texts: Vec<String> = problems.iter().zip(&forms).map(|(problem, form)| said(problem, *form)).collect();
        let stems = names::distinct(&texts);
        let asked = problems.iter().zip(forms).zip(stems);
        let asked_alone = |((problem, form), stem)| Self { problem: Arc::clone(problem), form, stem, slot: None };
        Ok(asked.map(asked_alone).collect())
    }

    /// The problems of a homework, whose sheets have that stem in their names.
    pub(super) fn of_homework(homework: &Homework, stem: &str) -> Vec<Self> {
        let asked_in_slot = |(slot, number): (&Slot, usize)| Self {
            problem: Arc::clone(&slot.problem),
            form: slot.form,
            stem: stem.to_owned(),
            slot: Some((number, Arc::new(slot.clone()))),
        };
        homework.slots.iter().zip(1..).map(asked_in_slot).collect()
    }

    /// The name of the form; empty where the problem has one form without a name.
    pub(super) fn form_name(&self) -> &str {
        form_name(&self.problem, self.form)
    }

    /// The seed of a student's sheet; it stays the same when others come or go.
    pub(super) fn seed_of(&self, student: &str, seeds: SeedSource<'_>) -> u64 {
        match &self.slot {
            Some((_, slot)) => slot.seed(student, seeds),
            None => seeds.seed(student, self.problem.drawn_as(), self.form_name()),
        }
    }

    /// The seed on the sheet with that number.
    pub(super) fn numbered_seed(&self, number: u64) -> u64 {
        self.slot.as_ref().map_or(number, |(_, slot)| slot.numbered_seed(number))
    }
}

fn form_name(problem: &Problem, form: usize) -> &str {
    problem.forms().get(form).and_then(|form| form.question.name.as_deref()).unwrap_or_default()
}

/// Problem and form in a line.
pub(super) fn said(problem: &Problem, form: usize) -> String {
    format!("{} {}", problem.id(), form_name(problem, form)).trim_end().to_owned()
}
