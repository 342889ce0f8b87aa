//! Rules of the problem file, in the terms of marking.

use momentous_grade as grade;
use momentous_grade::Attempts;
use momentous_grade::Rubric;
use momentous_grade::Verdict;
use momentous_problem as problem;
use momentous_problem::Part;
use momentous_problem::PlannedForm;
use momentous_problem::Problem;
use momentous_quantity::Rational;

/// Verdicts that the key `figures` of a rubric speaks of.
const FIGURES: [Verdict; 3] = [Verdict::FiguresFew, Verdict::FiguresMany, Verdict::FiguresWrong];

/// The file of a problem, as marking asks it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rules<'a> {
    pub(super) problem: &'a Problem,
    pub(super) form: &'a PlannedForm,
}

impl Rules<'_> {
    /// The worth of partly right answers, and the cost of attempts and hints.
    pub(super) fn rubric(self) -> Rubric {
        let written = &self.problem.loaded().draft.rubric;
        let mut rubric = Rubric::default();
        for verdict in Verdict::all().filter(|verdict| verdict.is_negotiable()) {
            let key = if FIGURES.contains(&verdict) { "figures" } else { verdict.code() };
            if let Some(fraction) = written.fraction(key) {
                rubric = rubric.with(verdict, fraction);
            }
        }
        rubric.attempts = Attempts {
            most: written.attempts,
            penalty: written.fraction("attempt_penalty").unwrap_or(Rational::ZERO),
            hint: written.fraction("hint_penalty").unwrap_or(Rational::ZERO),
            further_hint: written.fraction("further_hint_penalty").unwrap_or(Rational::ZERO),
            keep: match written.keep {
                Some(problem::Keep::Last) => grade::Keep::Last,
                Some(problem::Keep::Best) | None => grade::Keep::Best,
            },
            told: grade::FeedbackTime::AtOnce,
        };
        rubric
    }

    /// Which units will do.
    pub(super) fn units(self) -> grade::Units {
        match self.problem.loaded().draft.rubric.other_units {
            Some(problem::OtherUnits::Refuse) => grade::Units::AsAsked,
            Some(problem::OtherUnits::Accept) | None => grade::Units::Any,
        }
    }

    /// The treatment of the figures of a right value.
    pub(super) fn writing(self) -> grade::Writing {
        match self.problem.loaded().draft.rubric.writing {
            Some(problem::Writing::Ignore) => grade::Writing::Ignore,
            Some(problem::Writing::Require) => grade::Writing::Require,
            Some(problem::Writing::Advise) | None => grade::Writing::Advise,
        }
    }

    /// How a direction that is asked is counted, so that it may be answered in words.
    pub(super) fn reference(self, part: &Part) -> Option<grade::Reference> {
        let (from, sense) = self.form.question.ask.iter().find_map(|ask| match ask {
            problem::Ask::Find(find) if find.find == part.id => Some((find.from.clone()?, find.sense?)),
            _ => None,
        })?;
        let axes = self.problem.loaded().draft.scene.axes.rectangular();
        let axes: Vec<grade::FrameAxis> = axes.into_iter().take(2).map(frame_axis).collect();
        let letter = from.trim_start_matches(['+', '-']).trim();
        let axis = axes.iter().position(|axis| letter.chars().eq([axis.letter]))?;
        let quarters = i32::try_from(axis).ok()? + if from.trim().starts_with('-') { 2 } else { 0 };
        let clockwise = sense == problem::Turn::Clockwise;
        Some(grade::Reference { frame: grade::Frame { axes }, quarters, clockwise })
    }

    /// The axes of those letters, with the words for their directions.
    pub(super) fn frame(self, letters: &[&str]) -> grade::Frame {
        let axes = self.problem.loaded().draft.scene.axes.rectangular();
        let asked = axes.into_iter().filter(|(axis, _)| letters.contains(&axis.letter()));
        grade::Frame { axes: asked.map(frame_axis).collect() }
    }
}

fn frame_axis((axis, senses): (momentous_scene::Axis, momentous_scene::Senses)) -> grade::FrameAxis {
    let letter = axis.letter().chars().next().unwrap_or('x');
    grade::FrameAxis { letter, senses: [senses.positive, senses.negative] }
}
