//! Marking one form of a problem: what does not depend on the numbers is prepared once.

use std::borrow::Cow;
use std::sync::Arc;

use momentous_grade as grade;
use momentous_grade::Attempts;
use momentous_grade::Reading;
use momentous_grade::Readings;
use momentous_grade::Rubric;
use momentous_problem as problem;
use momentous_problem::AskedUnit;
use momentous_problem::ChoicePart;
use momentous_problem::End;
use momentous_problem::FormulaPart;
use momentous_problem::NoVariant;
use momentous_problem::NumberPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::PlannedForm;
use momentous_problem::Problem;
use momentous_problem::RangePart;
use momentous_problem::Sign;
use momentous_problem::Worked;
use momentous_quantity::coherent_unit;
use momentous_solve::Bounded;

use super::formula::expected_formula;
use super::names::Names;
use super::rules::Rules;

/// All that marking knows of a form before its numbers are drawn. With them it marks answers, always in the same way; it has
/// a memory of what it read, so each thread takes a clone of its own.
///
/// ```
/// use std::sync::Arc;
/// use momentous_bank::Bank;
/// use momentous_exercise::{Drawer, Marker};
/// use momentous_grade::{DecimalMark, Sitting};
/// use momentous_problem::{compile, load};
///
/// let problem = Arc::new(compile(load(Bank::built_in().find("impact/two-carts")?.clone())?, None)?);
/// let mut marker = Marker::new(&problem, 0, DecimalMark::Point)?;
/// let mut drawer = Drawer::new(&problem, 0)?;
/// for seed in 1..4 {
///     let exercise = drawer.draw(seed)?;
///     let right = exercise.printed(&exercise.worked().form.parts[0]);
///     let report = marker.mark(exercise.worked(), &[("v_A2", &right)], Sitting::default());
///     assert!(report.parts[0].verdict.is_right());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Marker {
    pub(super) blanks: Vec<Blank>,
    pub(super) rubric: Rubric,
    pub(super) mark: grade::DecimalMark,
    /// The names under which answers may be given.
    names: Names,
}

/// One part, with everything but the right answer.
#[derive(Clone, Debug)]
pub(super) struct Blank {
    id: String,
    points: u32,
    kind: BlankKind,
    /// What was read as answers to it.
    readings: Readings,
}

/// How it is answered: what is asked, and of numbers all that is expected but their values.
#[derive(Clone, Debug)]
enum BlankKind {
    Number(Box<(grade::ExpectedNumber, NumberPart)>),
    /// The components, and their axes.
    Vector(Vec<(grade::ExpectedNumber, NumberPart)>, grade::Frame),
    /// The boundary of the interval. The ends are known with the numbers.
    Interval(Box<(grade::ExpectedNumber, RangePart)>),
    Formula(FormulaPart),
    /// The question, and what can be chosen.
    Choice(String, ChoicePart),
}

impl Marker {
    /// A marker for the form at that position; answers are written with this decimal mark.
    ///
    /// # Errors
    /// [`NoVariant::NoForm`] where there is none.
    pub fn new(problem: &Arc<Problem>, form: usize, mark: grade::DecimalMark) -> Result<Self, NoVariant> {
        let planned = problem.forms().get(form).ok_or(NoVariant::NoForm)?;
        Ok(Self::of(problem, planned, mark))
    }

    pub(super) fn of(problem: &Problem, form: &PlannedForm, mark: grade::DecimalMark) -> Self {
        let rules = Rules { problem, form };
        Self {
            blanks: form.parts.iter().map(|part| Blank::new(rules, part)).collect(),
            rubric: rules.rubric(),
            mark,
            names: Names::of(problem, form),
        }
    }

    /// The position of the part that is meant by a name, in the file's letters, the course's, or as the sheet prints it.
    #[must_use]
    pub fn part(&self, name: &str) -> Option<usize> {
        let ids: Vec<&str> = self.blanks.iter().map(|blank| blank.id.as_str()).collect();
        let usual = self.names.meant(&ids, name);
        ids.iter().position(|id| *id == usual)
    }

    /// What is said of parts, with the parts' names in the file where others were written.
    pub(super) fn usual<'a, T: Copy>(&self, ids: &[&'a str], said: &'a [(&'a str, T)]) -> Cow<'a, [(&'a str, T)]> {
        if said.iter().all(|(part, _)| ids.contains(part)) {
            return Cow::Borrowed(said);
        }
        let usual = |part: &'a str| self.names.meant(ids, part);
        Cow::Owned(said.iter().map(|(part, what)| (usual(part), *what)).collect())
    }

    /// The report on answers to a sheet of this form that the student was not given.
    #[must_use]
    pub fn not_issued(&self) -> grade::Report {
        grade::Report::not_issued(self.blanks.iter().map(|blank| (blank.id.as_str(), blank.points)))
    }

    /// The same with other rules of attempts and hints than those of the problem's file.
    #[must_use]
    pub fn with_attempts(mut self, attempts: Attempts) -> Self {
        self.rubric.attempts = attempts;
        self
    }

    /// What partly right answers are worth, and what attempts and hints cost.
    #[must_use]
    pub fn rubric(&self) -> &Rubric {
        &self.rubric
    }
}

impl Blank {
    pub(super) fn new(rules: Rules<'_>, part: &Part) -> Self {
        let number = |asked: &NumberPart| blank_number(rules, part, asked);
        let kind = match &part.kind {
            PartKind::Number(asked) => BlankKind::Number(Box::new((number(asked), asked.clone()))),
            PartKind::Vector(vector) => {
                let components = part.numbers().map(|(_, asked)| (number(asked), asked.clone())).collect();
                BlankKind::Vector(components, rules.frame(&vector.axes))
            }
            PartKind::Range(range) => BlankKind::Interval(Box::new((number(&range.number), range.clone()))),
            PartKind::Formula(formula) => BlankKind::Formula(formula.clone()),
            PartKind::Choice(choice) => BlankKind::Choice(part.label.clone(), choice.clone()),
        };
        Self { id: part.id.clone(), points: part.points, kind, readings: Readings::default() }
    }

    /// What an answer says.
    pub(super) fn read(
        &mut self,
        text: &str,
        asked: &grade::ExpectedKind,
        mark: grade::DecimalMark,
    ) -> Option<Reading> {
        match asked {
            // What a formula may contain depends on the way in which the scene goes, and phrases and their order on the numbers.
            grade::ExpectedKind::Formula(_) | grade::ExpectedKind::Choice { .. } => Reading::of(text, asked, mark),
            asked => self.readings.read(text, asked, mark),
        }
    }

    /// The part with its right answer for a variant. What [`widen`] puts in is left out.
    pub(super) fn expected(&self, worked: Worked<'_>) -> grade::Expected {
        let kind = match &self.kind {
            BlankKind::Number(pair) => grade::ExpectedKind::Number(filled(&pair.0, worked, &pair.1)),
            BlankKind::Vector(components, frame) => grade::ExpectedKind::Vector(grade::ExpectedVector {
                components: components.iter().map(|(blank, number)| filled(blank, worked, number)).collect(),
                frame: frame.clone(),
            }),
            BlankKind::Interval(pair) => {
                let (boundary, range) = &**pair;
                let unit = range.number.plain_unit();
                let end = |end: End| {
                    let number = if end.is_limit {
                        grade::ExpectedNumber::new(end.value.value, unit.clone())
                    } else {
                        filled(boundary, worked, &range.number)
                    };
                    grade::ExpectedEnd { number, closed: end.closed, is_limit: end.is_limit }
                };
                let ends =
                    worked.interval(range).map(|interval| [interval.low, interval.high].map(|side| side.map(end)));
                let [low, high] = ends.unwrap_or_default();
                let name = self.id.clone();
                grade::ExpectedKind::Interval(Box::new(grade::ExpectedInterval { name, low, high, unit }))
            }
            BlankKind::Formula(formula) => expected_formula(worked, formula),
            BlankKind::Choice(question, choice) => {
                let problem::Decision { options, right, because, .. } = choice.decided(&worked);
                grade::ExpectedKind::Choice { question: question.clone(), options, right, because }
            }
        };
        grade::Expected { id: self.id.clone(), points: self.points, kind }
    }
}

/// Puts in how far honest rounding can move the answer, and of one that is nothing the size of what cancels in it.
pub(super) fn widen(expected: &mut grade::Expected, worked: Worked<'_>, part: &Part) {
    let put = |number: &mut grade::ExpectedNumber, asked: &NumberPart| {
        let judged = worked.judged(asked);
        (number.allowance, number.scale) = (judged.allowance, judged.scale);
    };
    match (&mut expected.kind, &part.kind) {
        (grade::ExpectedKind::Number(number), PartKind::Number(asked)) => put(number, asked),
        (grade::ExpectedKind::Vector(expected), PartKind::Vector(vector)) => {
            expected.components.iter_mut().zip(&vector.components).for_each(|(number, asked)| put(number, asked));
        }
        (grade::ExpectedKind::Interval(interval), PartKind::Range(range)) => {
            let ends = [&mut interval.low, &mut interval.high].into_iter().flatten();
            ends.filter(|end| !end.is_limit).for_each(|end| put(&mut end.number, &range.number));
        }
        _ => {}
    }
}

fn blank_number(rules: Rules<'_>, part: &Part, number: &NumberPart) -> grade::ExpectedNumber {
    let symbols = &rules.problem.model().symbols;
    let mut unit = number.plain_unit();
    let sign = rules.problem.sign(number.symbol);
    let multiple_of = match number.unit {
        AskedUnit::InTermsOf(symbol, _) => {
            let product = coherent_unit(symbols.entry(number.symbol).dimension, rules.problem.units());
            let units = (!unit.is_none()).then(|| [std::mem::take(&mut unit), product]);
            Some(grade::Multiple { name: rules.problem.name_of(symbol), units })
        }
        AskedUnit::Unit(_) => None,
    };
    let hanging = rules.problem.hanging(number.symbol);
    let of_place = || rules.problem.turns_with(number.symbol);
    let in_space = hanging.or_else(of_place).map(|senses| [senses.positive, senses.negative]);
    let axis = rules.problem.axis(number.symbol);
    let motion = rules.problem.told_motion(rules.form, number.symbol);
    let called = grade::Called { name: part.id.clone(), axis, in_space, motion, multiple_of };
    let cyclic = is_direction(rules, part, number) && unit.is_plain_angle();
    let is_positive = rules.reference(part).is_none() && rules.problem.model().system.positive.contains(&number.symbol);
    grade::ExpectedNumber {
        cyclic,
        tolerance: number.tolerance.clone(),
        units: rules.units(),
        writing: rules.writing(),
        reference: rules.reference(part),
        figures: number.figures,
        // A direction may be turned either way, but the angle of a cord with the vertical is a size.
        signed: sign != Sign::Nothing || cyclic && !is_positive,
        senses: match sign {
            Sign::Sense(senses) => Some([senses.positive, senses.negative]),
            Sign::Other | Sign::Nothing => None,
        },
        whole: number.whole,
        called: Some(Arc::new(called)),
        ..grade::ExpectedNumber::new(f64::NAN, unit)
    }
}

/// Whether a quantity is a direction, of which a whole turn is as good as none; an angle turned through is not.
fn is_direction(rules: Rules<'_>, part: &Part, number: &NumberPart) -> bool {
    let name = &rules.problem.model().symbols.entry(number.symbol).name;
    rules.reference(part).is_some() || name.starts_with("angle_")
}

fn filled(blank: &grade::ExpectedNumber, worked: Worked<'_>, number: &NumberPart) -> grade::ExpectedNumber {
    let mut answer = worked.answer(number);
    if answer.value.abs() <= answer.error && worked.is_nothing(number.symbol) {
        answer = Bounded { value: 0.0, error: 0.0 };
    }
    grade::ExpectedNumber { value: answer.value, error: answer.error, ..blank.clone() }
}
