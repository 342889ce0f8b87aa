//! Whether a wrong answer is what follows from earlier ones, for every kind of answer.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_grade as grade;
use momentous_grade::Verdict;
use momentous_problem::Candidate;
use momentous_problem::Consequence;
use momentous_problem::FormulaPart;
use momentous_problem::NumberPart;
use momentous_problem::PartKind;
use momentous_problem::VectorPart;
use momentous_quantity::Dimension;

use super::follow_through::Earlier;
use super::follow_through::FollowedAnswer;
use super::follow_through::names;
use super::marking::Marking;

/// Values that a student rounds on the way move what follows from them by up to this share.
const ROUNDING: f64 = 0.006;
/// How far the double nearest to a value is from it.
const DOUBLE: f64 = 1e-12;
/// At most so many vectors are put together of what follows for their components.
const MOST_VECTORS: usize = 256;

/// A component: the right value, or what follows from earlier answers.
struct Component<'a> {
    value: f64,
    follows: Option<(Vec<&'a Earlier>, Consequence)>,
}

impl Marking<'_> {
    /// The consequence that the answer is, of the fewest earlier answers; one that is possible rather than one that is not.
    pub(super) fn followed(&self, place: usize, earlier: &[Earlier]) -> Option<FollowedAnswer> {
        if earlier.is_empty() {
            return None;
        }
        let expected = self.expected.get(place)?;
        match self.answered(place)? {
            (PartKind::Number(number), grade::ExpectedKind::Number(_), answer) => {
                self.number_followed(number, expected, answer, earlier)
            }
            (PartKind::Formula(formula), grade::ExpectedKind::Formula(right), answer) => {
                self.formula_followed(formula, right, answer, earlier)
            }
            (PartKind::Vector(vector), grade::ExpectedKind::Vector(_), answer) => {
                self.vector_followed(vector, expected, answer, earlier)
            }
            _ => None,
        }
    }

    fn number_followed(
        &self,
        number: &NumberPart,
        expected: &grade::Expected,
        answer: &grade::Answer,
        earlier: &[Earlier],
    ) -> Option<FollowedAnswer> {
        let grade::ExpectedKind::Number(right) = &expected.kind else { return None };
        let written = grade::diagnose::number(right, answer)?;
        let unit = self.worked.unit_of(number);
        let mut target = expected.clone();
        self.best(number.symbol, earlier, &mut |_, candidate| {
            let value = candidate.value / unit;
            if is_far(right, value, written) {
                return None;
            }
            if let grade::ExpectedKind::Number(number) = &mut target.kind {
                aim(number, right, value);
            }
            accepted(grade::judge(&target, answer).verdict)
        })
    }

    /// A formula follows where it is what the equations make of the student's own earlier formulas.
    fn formula_followed(
        &self,
        part: &FormulaPart,
        right: &grade::ExpectedFormula,
        answer: &grade::Answer,
        earlier: &[Earlier],
    ) -> Option<FollowedAnswer> {
        self.best(part.symbol, earlier, &mut |chosen, candidate| {
            let formula_of = |symbol: Symbol| chosen.iter().find(|answer| answer.symbol == symbol)?.formula.clone();
            if !chosen.iter().all(|answer| answer.formula.is_some()) {
                return None;
            }
            let is = |formula: Expr| {
                let kind = grade::ExpectedKind::Formula(grade::ExpectedFormula { formula, ..right.clone() });
                let target = grade::Expected { id: String::new(), points: 0, kind };
                accepted(grade::judge(&target, answer).verdict)
            };
            candidate.formulas().into_iter().find_map(|formula| is(formula.substitute(&formula_of)))
        })
    }

    /// The best of what follows from every choice of earlier answers, by those that `judge` accepts with a verdict.
    fn best(
        &self,
        asked: Symbol,
        earlier: &[Earlier],
        judge: &mut dyn FnMut(&[&Earlier], &Candidate<'_>) -> Option<Verdict>,
    ) -> Option<FollowedAnswer> {
        let mut best: Option<FollowedAnswer> = None;
        for chosen in subsets(earlier) {
            let mut verdicts = Vec::new();
            let mut accept = |candidate: &Candidate<'_>| {
                let judged = judge(&chosen, candidate);
                verdicts.extend(judged);
                judged.is_some()
            };
            let consequences = self.consequences(asked, &chosen, &mut accept);
            for (consequence, judged) in consequences.into_iter().zip(verdicts) {
                if best.as_ref().is_none_or(|best| best.unphysical.is_some() && consequence.unphysical.is_none()) {
                    best = Some(FollowedAnswer {
                        from: names(&chosen),
                        by: consequence.by,
                        unphysical: consequence.unphysical,
                        fraction: self.rubric.fraction(judged),
                    });
                }
            }
        }
        best
    }

    /// Each component is right, or follows; and not all are right.
    fn vector_followed(
        &self,
        vector: &VectorPart,
        expected: &grade::Expected,
        answer: &grade::Answer,
        earlier: &[Earlier],
    ) -> Option<FollowedAnswer> {
        let grade::ExpectedKind::Vector(right) = &expected.kind else { return None };
        let components = vector.components.iter().zip(&right.components);
        let choices: Vec<Vec<Component<'_>>> =
            components.map(|(part, right)| self.component_choices(part, right.value, earlier)).collect();
        let mut target = expected.clone();
        let mut judge = |picked: &[&Component<'_>]| {
            if let grade::ExpectedKind::Vector(aimed) = &mut target.kind {
                let all = aimed.components.iter_mut().zip(&right.components).zip(picked);
                all.for_each(|((blank, right), picked)| aim(blank, right, picked.value));
            }
            let verdict = accepted(grade::judge(&target, answer).verdict)?;
            let follow = || picked.iter().filter_map(|part| part.follows.as_ref());
            let chosen: Vec<&Earlier> = follow().flat_map(|(chosen, _)| chosen.iter().copied()).collect();
            let mut by = Vec::new();
            follow().flat_map(|(_, consequence)| &consequence.by).for_each(|law| {
                if !by.contains(law) {
                    by.push(law);
                }
            });
            Some(FollowedAnswer {
                from: names(&chosen),
                by,
                unphysical: follow().find_map(|(_, consequence)| consequence.unphysical.clone()),
                fraction: self.rubric.fraction(verdict),
            })
        };
        let combined =
            combinations(&choices).into_iter().filter(|picked| picked.iter().any(|part| part.follows.is_some()));
        let mut candidates: Vec<FollowedAnswer> = combined.filter_map(|picked| judge(&picked)).collect();
        candidates.sort_by_key(|followed| (followed.unphysical.is_some(), followed.from.len()));
        candidates.into_iter().next()
    }

    fn component_choices<'e>(&self, part: &NumberPart, right: f64, earlier: &'e [Earlier]) -> Vec<Component<'e>> {
        let unit = self.worked.unit_of(part);
        let mut choices = vec![Component { value: right, follows: None }];
        for chosen in subsets(earlier) {
            let consequences = self.consequences(part.symbol, &chosen, &mut |_| true);
            choices.extend(consequences.into_iter().map(|consequence| Component {
                value: consequence.value / unit,
                follows: Some((chosen.clone(), consequence)),
            }));
        }
        choices
    }

    /// The consequences of earlier answers that are wanted, without those that make the rest trivial.
    pub(super) fn consequences(
        &self,
        asked: Symbol,
        chosen: &[&Earlier],
        accept: &mut dyn FnMut(&Candidate<'_>) -> bool,
    ) -> Vec<Consequence> {
        let values = chosen.iter().map(|answer| (answer.symbol, answer.value)).collect();
        // A sign that is lost in writing an answer down has not been wrong before.
        let reversed = chosen.iter().any(|answer| answer.reversed);
        let mut accept = |candidate: &Candidate<'_>| {
            let follows = !(reversed && candidate.is_backwards());
            follows && self.can_be_built_upon(asked, candidate.value) && accept(candidate)
        };
        self.worked.following(asked, &values, &mut accept)
    }
}

/// The verdict, where the answer would be right but for its unit.
fn accepted(verdict: Verdict) -> Option<Verdict> {
    (verdict.is_right() || verdict == Verdict::UnitMissing).then_some(verdict)
}

/// Whether an answer is so far from a value, whatever its sign, that it cannot be taken for it. An angle is never far, nor is what
/// may be a fraction of something.
fn is_far(right: &grade::ExpectedNumber, value: f64, answer: f64) -> bool {
    let size = value.abs().max(right.scale);
    let tolerance = right.tolerance.reach(size).unwrap_or(size);
    let reach = 2.0 * (tolerance + right.allowance + ROUNDING * size);
    !right.cyclic && right.unit.dimension() != Dimension::NONE && (answer.abs() - value.abs()).abs() > reach
}

/// Every choice of earlier answers, small ones first.
fn subsets(earlier: &[Earlier]) -> Vec<Vec<&Earlier>> {
    let mut all: Vec<Vec<&Earlier>> = vec![Vec::new()];
    for answer in earlier {
        let with: Vec<Vec<&Earlier>> = all.iter().map(|chosen| [chosen.as_slice(), &[answer]].concat()).collect();
        all.extend(with);
    }
    all.retain(|chosen| !chosen.is_empty());
    all.sort_by_key(Vec::len);
    all
}

/// One choice for each component, in every way; what was listed first comes first.
fn combinations<'c, 'e>(choices: &'c [Vec<Component<'e>>]) -> Vec<Vec<&'c Component<'e>>> {
    let mut all: Vec<Vec<&Component<'_>>> = vec![Vec::new()];
    for choice in choices {
        let longer = all.iter().flat_map(|picked| choice.iter().map(move |next| [picked.as_slice(), &[next]].concat()));
        all = longer.take(MOST_VECTORS).collect();
    }
    all
}

/// Puts what follows from the student's own answers in place of the right value.
fn aim(number: &mut grade::ExpectedNumber, right: &grade::ExpectedNumber, value: f64) {
    number.value = value;
    number.error = DOUBLE * value.abs();
    number.exact = None;
    number.allowance = right.allowance.max(ROUNDING * value.abs());
}
