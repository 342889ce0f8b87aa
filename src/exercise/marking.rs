//! Marking a variant: what is expected is read from the solved variant, answers are dealt out to several roots.

use std::collections::BTreeMap;

use crate::grade;
use crate::problem;
use crate::problem::AskedUnit;
use crate::problem::End;
use crate::problem::NumberPart;
use crate::problem::Part;
use crate::problem::PartKind;
use crate::problem::RangePart;
use crate::problem::senses_of;

use super::Exercise;
use super::ROOTS_JOINED;

/// Beginnings of names of signed components, whose direction a student may give in words.
const SIGNED: [&str; 4] = ["v_", "p_", "J_", "F_avg_"];

/// What marking says more of, besides the verdicts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sitting {
    /// How many further hints the student has asked for on wrong answers.
    pub hints: usize,
    /// Whether no attempts are left: what follows from the student's own answers is then shown.
    pub closed: bool,
}

impl Exercise {
    /// What a right answer to a part is.
    #[must_use]
    pub fn expected(&self, part: &Part) -> grade::Expected {
        let kind = match &part.kind {
            PartKind::Choice(choice) => {
                let problem::Decision { options, right, because } = choice.decided(&self.worked());
                grade::ExpectedKind::Choice { options, right, because }
            }
            PartKind::Number(number) => grade::ExpectedKind::Number(self.expected_number(part, &part.id, number)),
            PartKind::Formula(formula) => self.expected_formula(formula),
            PartKind::Range(range) => grade::ExpectedKind::Interval(Box::new(self.expected_interval(part, range))),
            PartKind::Vector(vector) => grade::ExpectedKind::Vector(grade::ExpectedVector {
                components: part.numbers().map(|(name, own)| self.expected_number(part, &name, own)).collect(),
                frame: self.frame(&vector.axes),
            }),
        };
        grade::Expected { id: part.id.clone(), points: part.points, kind }
    }

    fn expected_number(&self, part: &Part, name: &str, number: &NumberPart) -> grade::ExpectedNumber {
        let worked = self.worked();
        let answer = worked.answer(number);
        let unit = number.plain_unit();
        let judged = worked.judged(number);
        let signed = SIGNED.iter().any(|start| name.starts_with(start));
        let senses = senses_of(&self.problem.loaded().draft.scene, name).filter(|_| signed);
        grade::ExpectedNumber {
            value: answer.value,
            error: answer.error,
            exact: None,
            cyclic: unit.factor().pi != 0,
            unit,
            tolerance: match &number.tolerance {
                problem::Tolerance::Relative(fraction) => grade::Tolerance::Relative(fraction.clone()),
                problem::Tolerance::Absolute(distance) => grade::Tolerance::Absolute(distance.clone()),
                problem::Tolerance::ToFigures => grade::Tolerance::ToFigures,
            },
            units: self.units(),
            writing: self.writing(),
            reference: self.reference(part),
            figures: number.figures,
            allowance: judged.allowance,
            scale: judged.scale,
            magnitude: senses.is_none() && answer.value >= 0.0,
            senses: senses.map(|senses| [senses.positive, senses.negative]),
            whole: number.whole,
        }
    }

    fn expected_interval(&self, part: &Part, range: &RangePart) -> grade::ExpectedInterval {
        let unit = range.number.plain_unit();
        let boundary = self.expected_number(part, &part.id, &range.number);
        let end = |end: End| {
            let own = grade::ExpectedNumber::new(end.value.value, unit.clone());
            let number = if end.own { own } else { boundary.clone() };
            grade::ExpectedEnd { number, closed: end.closed, own: end.own }
        };
        let interval = self.worked().interval(range);
        let ends = interval.map(|interval| [interval.low.map(end), interval.high.map(end)]);
        let [low, high] = ends.unwrap_or_default();
        grade::ExpectedInterval { name: part.id.clone(), low, high, unit }
    }

    /// Marks answers to this variant, by part. Of wrong answers it says what they follow from, or which usual mistake leads
    /// to them.
    #[must_use]
    pub fn grade(&self, answers: &BTreeMap<String, String>, mark: grade::DecimalMark) -> grade::Report {
        self.mark(answers, mark, Sitting::default())
    }

    /// The same for a student who has asked for hints, or who has no attempts left.
    #[must_use]
    pub fn mark(
        &self,
        answers: &BTreeMap<String, String>,
        mark: grade::DecimalMark,
        sitting: Sitting,
    ) -> grade::Report {
        let mut expected = Vec::new();
        let mut answers = answers.clone();
        for part in &self.worked().form.parts {
            self.drop_unit_quantity(part, &mut answers);
            let roots = self.expected_roots(part);
            if roots.len() > 1 {
                share_out(part, &roots, &mut answers, mark);
            }
            expected.extend(roots);
        }
        let rubric = self.rubric();
        let mut report = grade::grade(&expected, &answers, mark, &rubric);
        if !report.is_right() {
            self.follow_through(&mut report, &expected, &answers, mark, &rubric, sitting.closed);
            self.diagnose(&mut report, &expected, &answers, mark, sitting.hints);
        }
        report
    }

    /// An answer in terms of a quantity is read as the number before it: `0.75 v_A1` as 0.75.
    fn drop_unit_quantity(&self, part: &Part, answers: &mut BTreeMap<String, String>) {
        let PartKind::Number(NumberPart { unit: AskedUnit::InTermsOf(symbol), .. }) = &part.kind else { return };
        let Some(answer) = answers.get_mut(&part.id) else { return };
        let name = &self.problem.model().symbols.entry(*symbol).name;
        let typed = answer.trim_end();
        let number = typed.strip_suffix(name.as_str()).or_else(|| typed.strip_suffix(&name.replace('_', "")));
        if let Some(number) = number {
            *answer = number.trim_end().trim_end_matches(['*', '·', '×']).trim_end().to_owned();
        }
    }

    /// What right answers to a part are: one, or one for each root where all are asked for, sharing its points.
    fn expected_roots(&self, part: &Part) -> Vec<grade::Expected> {
        let single = self.expected(part);
        let PartKind::Number(number) = &part.kind else { return vec![single] };
        let answers = self.worked().answers(number);
        let count = u32::try_from(answers.len()).unwrap_or(1).max(1);
        let roots = answers.iter().enumerate().map(|(index, answer)| {
            let mut root = single.clone();
            if index > 0 {
                root.id = format!("{} ({})", part.id, index + 1);
            }
            let spare = u32::from(u32::try_from(index).unwrap_or(0) < part.points % count);
            root.points = part.points / count + spare;
            if let grade::ExpectedKind::Number(own) = &mut root.kind {
                (own.value, own.error) = (answer.value, answer.error);
            }
            root
        });
        roots.collect()
    }
}

/// Deals the values of one answer out to the roots: each root gets the first value that is right for it, whatever the
/// order in which they were typed; what is left goes to the roots that are left.
fn share_out(part: &Part, roots: &[grade::Expected], answers: &mut BTreeMap<String, String>, mark: grade::DecimalMark) {
    let Some(text) = answers.remove(&part.id) else { return };
    let pieces = text.replace(" and ", ROOTS_JOINED).replace(';', ROOTS_JOINED);
    let mut values: Vec<String> = pieces.split(ROOTS_JOINED).map(|value| value.trim().to_owned()).collect();
    let mut open = Vec::new();
    for root in roots {
        let right = values.iter().position(|value| {
            let read = grade::read(value, &root.kind, mark);
            read.is_ok_and(|answer| grade::judge(root, &answer).verdict.is_right())
        });
        match right {
            Some(position) => {
                answers.insert(root.id.clone(), values.remove(position));
            }
            None => open.push(&root.id),
        }
    }
    for (id, value) in open.into_iter().zip(values) {
        answers.insert(id.clone(), value);
    }
}
