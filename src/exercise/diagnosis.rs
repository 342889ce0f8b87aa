//! Where a wrong answer comes from, in the words of the problem.

use momentous_expr::Expr;
use momentous_grade as grade;
use momentous_grade::Diagnosis;
use momentous_grade::Verdict;
use momentous_grade::diagnose;
use momentous_laws::wrong::Misconception;
use momentous_problem::Decision;
use momentous_problem::FormulaPart;
use momentous_problem::Mistake;
use momentous_problem::OptionFeedback;
use momentous_problem::PartKind;
use momentous_problem::Simulated;
use momentous_problem::Worked;

use super::marking::Marking;

/// The most values to which slips in one line may lead, for any of them to be named.
const MOST_SLIPS: usize = 26;

impl Marking<'_> {
    /// Says of every wrong answer in a report which usual mistake leads to it, where one does.
    pub(super) fn diagnose(&self, report: &mut grade::Report) {
        let mut changed = false;
        let right: Vec<bool> =
            report.parts.iter().map(|report| report.verdict.is_right() && report.follows.is_none()).collect();
        for (place, report) in report.parts.iter_mut().enumerate() {
            if !diagnose::is_open(report.verdict) || report.follows.is_some() {
                continue;
            }
            let exactly = report.verdict == Verdict::RoundingSlip;
            let known = || {
                let mistakes = self.likely(self.common(), (place, exactly), &right)?;
                self.diagnosis(unexplained(report.verdict, mistakes))
            };
            let slipped = || {
                let slips = self.slips(place, report.verdict)?;
                self.diagnosis(self.likely(slips, (place, true), &right)?)
            };
            let Some(diagnosis) = self.misjudged(place).or_else(known).or_else(slipped) else { continue };
            if exactly {
                // A mistake that gives exactly this value says where it comes from; nothing was rounded.
                (report.verdict, report.message) = (Verdict::Wrong, grade::not_right());
                report.points = self.rubric.points(Verdict::Wrong, report.out_of);
                changed = true;
            }
            let told = diagnosis.hints.iter().take(self.sitting(place).hints.saturating_add(1)).map(String::as_str);
            let told = told.filter(|told| **told != *report.message);
            report.message = std::iter::once(&*report.message).chain(told).collect::<Vec<_>>().join(" ").into();
            report.diagnosis = Some(diagnosis);
        }
        if changed {
            report.recount();
        }
    }

    /// What comes of slips in one line, where the verdict leaves open what is wrong and one that leads to the answer is hardly there by
    /// chance: angles lie too close together, and so do the values of many slips.
    fn slips(&self, place: usize, verdict: Verdict) -> Option<&Simulated<'_>> {
        if !matches!(verdict, Verdict::Wrong | Verdict::FormulaFactor | Verdict::FormulaDimension) {
            return None;
        }
        let number = match self.answered(place)? {
            (PartKind::Number(_), grade::ExpectedKind::Number(right), _) if right.unit.is_plain_angle() => return None,
            (PartKind::Number(number), ..) => Some(number),
            _ => None,
        };
        let slips = self.slips.get_or_init(|| self.worked.slips());
        let answers = |slip: &Mistake| number.map_or(0, |number| slips.answers(slip, number).len());
        let count: usize = slips.mistakes().iter().map(answers).sum();
        (count <= MOST_SLIPS).then_some(slips)
    }

    /// What comes of the usual mistakes.
    fn common(&self) -> &Simulated<'_> {
        self.simulated.get_or_init(|| self.worked.simulated())
    }

    /// Of some mistakes those that lead to the answer there, and may be made beside what is right.
    fn likely<'m>(
        &self,
        among: &'m Simulated<'_>,
        (place, exactly): (usize, bool),
        right: &[bool],
    ) -> Option<Vec<&'m Mistake>> {
        let suspects = self.suspects(among, place, exactly)?;
        let possible = self.possible(among, suspects.clone(), right);
        Some(if possible.is_empty() { self.in_one_part(among, place, suspects) } else { possible })
    }

    /// What is asked, what is right, and what was answered; of several roots the first alone.
    pub(super) fn answered(&self, place: usize) -> Option<(&PartKind, &grade::ExpectedKind, &grade::Answer)> {
        let expected = self.expected.get(place)?;
        let part = self.worked.form.parts.get(*self.parts.get(place)?).filter(|part| part.id == expected.id)?;
        Some((&part.kind, &expected.kind, self.readings.get(place)?.as_ref()?.answer.as_ref().ok()?))
    }

    /// What is said of a wrong choice.
    fn misjudged(&self, place: usize) -> Option<Diagnosis> {
        let (PartKind::Choice(choice), _, grade::Answer::Choice(chosen)) = self.answered(place)? else { return None };
        misjudged(self.worked, &choice.decided(&self.worked), chosen.option)
    }

    /// The mistakes that lead to the answer there, perhaps those alone that lead to it exactly.
    fn suspects<'m>(&self, among: &'m Simulated<'_>, place: usize, exactly: bool) -> Option<Vec<&'m Mistake>> {
        match self.answered(place)? {
            (PartKind::Number(number), grade::ExpectedKind::Number(right), written) => {
                let answer = diagnose::number(right, written)
                    .filter(|mistaken| !diagnose::is_coarse(right, written, *mistaken))?;
                let (mistakes, values) = outcomes(among, |mistake, add| {
                    // Numbers that come of other data may be anywhere: nearness alone says nothing of them.
                    let exactly = exactly || mistake.is_of_data();
                    let is_near = |value: f64| {
                        if exactly {
                            diagnose::is_rounded(right, answer, value)
                        } else {
                            diagnose::is_near(right, answer, value)
                        }
                    };
                    among.each(mistake, number, &is_near, add);
                });
                let further = diagnose::further_figures(right, written);
                Some(picked(&mistakes, diagnose::matching(right, answer, further, &values)))
            }
            (PartKind::Vector(vector), grade::ExpectedKind::Vector(right), answer) => {
                let answer = diagnose::components(right, answer)?;
                let (mistakes, values) =
                    outcomes(among, |mistake, add| among.vectors(mistake, vector).into_iter().for_each(add));
                Some(picked(&mistakes, diagnose::matching_vectors(right, &answer, &values)))
            }
            (PartKind::Formula(formula), grade::ExpectedKind::Formula(right), answer) => {
                Some(self.of_formula(among, formula, right, answer))
            }
            _ => None,
        }
    }

    /// Of some mistakes those that leave the right answers right: who made one of the others has wrong numbers elsewhere, too.
    fn possible<'m>(&self, among: &Simulated<'_>, mut mistakes: Vec<&'m Mistake>, right: &[bool]) -> Vec<&'m Mistake> {
        let places = right.iter().enumerate().filter(|(_, is_right)| **is_right);
        for (place, _) in places {
            let Some((PartKind::Number(number), grade::ExpectedKind::Number(expected), _)) = self.answered(place)
            else {
                continue;
            };
            let keeps = |mistake: &&Mistake| {
                let values = among.answers(mistake, number);
                mistake.is_of_one_answer()
                    || values.is_empty()
                    || values.iter().any(|value| diagnose::is_near(expected, expected.value, *value))
            };
            mistakes.retain(keeps);
        }
        mistakes
    }

    /// Of mistakes that would have made right answers wrong those that agree in every figure: they were made in this part only.
    fn in_one_part<'m>(&self, among: &Simulated<'_>, place: usize, mut mistakes: Vec<&'m Mistake>) -> Vec<&'m Mistake> {
        let Some((PartKind::Number(number), grade::ExpectedKind::Number(right), written)) = self.answered(place) else {
            return Vec::new();
        };
        let Some(answer) = diagnose::number(right, written) else { return Vec::new() };
        mistakes.retain(|mistake| {
            among.answers(mistake, number).iter().any(|value| diagnose::is_rounded(right, answer, *value))
        });
        mistakes
    }

    /// The mistakes that lead to exactly this formula, and to no right one.
    fn of_formula<'m>(
        &self,
        among: &'m Simulated<'_>,
        part: &FormulaPart,
        right: &grade::ExpectedFormula,
        answer: &grade::Answer,
    ) -> Vec<&'m Mistake> {
        let is = |formula: &Expr, answer: &grade::Answer| {
            let dimension = formula.dimension(&right.symbols).unwrap_or(right.dimension);
            let wrong = grade::ExpectedFormula { formula: formula.clone(), dimension, ..right.clone() };
            let kind = grade::ExpectedKind::Formula(wrong);
            grade::judge(&grade::Expected { id: String::new(), points: 0, kind }, answer).verdict.is_right()
        };
        let truth = grade::FormulaAnswer { text: String::new(), formula: right.formula.clone(), shifted: Vec::new() };
        let truth = grade::Answer::Formula(truth);
        let leads = |mistake: &&Mistake| {
            let formulas = self.worked.mistaken_formulas(mistake, part.symbol);
            formulas.iter().any(|formula| is(formula, answer) && !is(formula, &truth))
        };
        among.mistakes().iter().filter(leads).collect()
    }

    /// What is said of the mistakes that lead to an answer; nothing where there are none.
    fn diagnosis(&self, mut mistakes: Vec<&Mistake>) -> Option<Diagnosis> {
        likeliest_first(self.worked, &mut mistakes);
        let first = mistakes.first()?;
        let mut codes: Vec<&'static str> = Vec::new();
        for mistake in &mistakes {
            if !codes.contains(&mistake.of.id) {
                codes.push(mistake.of.id);
            }
        }
        Some(Diagnosis { codes, step: step(self.worked, first), hints: hints_on(self.worked, &mistakes) })
    }
}

/// Of some mistakes those that are named: what is wrong with the data only where the verdict leaves open what it is, and of a right
/// magnitude without its direction nothing but how it was written.
pub(super) fn unexplained(verdict: Verdict, mut mistakes: Vec<&Mistake>) -> Vec<&Mistake> {
    match verdict {
        Verdict::Wrong | Verdict::RoundingSlip => {}
        Verdict::Sense => mistakes.retain(|mistake| mistake.is_written()),
        _ => mistakes.retain(|mistake| !mistake.yields()),
    }
    mistakes
}

/// A law says more than a slip of the pen, an author's own words more than ours, and one mistake explains more than several.
pub(super) fn likeliest_first(worked: Worked<'_>, mistakes: &mut [&Mistake]) {
    mistakes
        .sort_by_key(|mistake| (feedback_on(worked, mistake.of).is_none(), mistake.instance.is_none(), mistake.places));
}

/// What is said of a wrong choice: what the author says of that option, or of the mistake behind any.
pub(super) fn misjudged(worked: Worked<'_>, decision: &Decision, option: usize) -> Option<Diagnosis> {
    let behind = match decision.feedback.get(option) {
        Some(OptionFeedback::Own(said)) => {
            return Some(Diagnosis { codes: Vec::new(), step: None, hints: vec![said.clone()] });
        }
        Some(OptionFeedback::Mistake(mistake) | OptionFeedback::Confused(mistake)) => mistake,
        Some(OptionFeedback::Nothing) | None => decision.behind?,
    };
    let question = feedback_on(worked, behind).unwrap_or_else(|| behind.ask.to_owned());
    Some(Diagnosis { codes: vec![behind.id], step: None, hints: vec![question, behind.hint.to_owned()] })
}

/// What the author says of a mistake.
pub(super) fn feedback_on(worked: Worked<'_>, kind: &Misconception) -> Option<String> {
    worked.variant.feedback(worked.problem, kind.id)
}

/// The step at which a law is got wrong: `the law of restitution, in the impact`.
fn step(worked: Worked<'_>, mistake: &Mistake) -> Option<String> {
    let model = worked.problem.model();
    let instance = model.instances.get(mistake.instance?)?;
    let scene = &worked.problem.loaded().draft.scene;
    let stage = instance.stage.filter(|_| scene.stages.len() > 1).map(|stage| model.phrase(scene, stage));
    Some(match stage {
        Some(stage) => format!("{}, in {stage}", instance.law.name),
        None => instance.law.name.to_owned(),
    })
}

/// What is said of mistakes that cannot be told apart: a question first, each hint plainer than the one before. None holds the right
/// value. Of laws two are named; an author's own words stand alone.
pub(super) fn hints_on(worked: Worked<'_>, mistakes: &[&Mistake]) -> Vec<String> {
    let Some(mistake) = mistakes.first() else { return Vec::new() };
    let own_words = feedback_on(worked, mistake.of);
    let is_another = |other: &&&Mistake| other.of != mistake.of && other.instance.is_some();
    let alone = own_words.is_some() || mistake.instance.is_none();
    let another = mistakes.iter().find(is_another).filter(|_| !alone).map(|other| other.of);
    let question = own_words.unwrap_or_else(|| mistake.of.ask.to_owned());
    let mut first = match step(worked, mistake) {
        Some(step) => format!("Look at the step with {step}. {question}"),
        None => question,
    };
    let mut hint = mistake.of.hint.to_owned();
    if let Some(other) = another {
        let asked = feedback_on(worked, other).unwrap_or_else(|| other.ask.to_owned());
        first = format!("{first} Another possibility: {asked}");
        hint = format!("{hint} {}", other.hint);
    }
    let law = mistake
        .instance
        .and_then(|instance| worked.problem.model().instances.get(instance))
        .map(|instance| instance.law);
    let statement = law.map(|law| format!("{} {}", law.statement, law.signs));
    [Some(first), Some(hint), statement].into_iter().flatten().collect()
}

/// What every mistake makes of an answer.
fn outcomes<'m, T>(among: &'m Simulated<'_>, each: impl Fn(&Mistake, &mut dyn FnMut(T))) -> (Vec<&'m Mistake>, Vec<T>) {
    let (mut mistakes, mut values) = (Vec::new(), Vec::new());
    for mistake in among.mistakes() {
        each(mistake, &mut |value| {
            mistakes.push(mistake);
            values.push(value);
        });
    }
    (mistakes, values)
}

fn picked<'m>(mistakes: &[&'m Mistake], places: Vec<usize>) -> Vec<&'m Mistake> {
    places.into_iter().filter_map(|place| mistakes.get(place).copied()).collect()
}
