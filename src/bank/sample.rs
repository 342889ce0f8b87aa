//! Many variants of one form, reduced to what an audit looks at.

use std::collections::BTreeSet;
use std::hash::DefaultHasher;
use std::hash::Hash;
use std::hash::Hasher;

use momentous_model::ContactWeight;
use momentous_problem::NoVariant;
use momentous_problem::NumberPart;
use momentous_problem::PartKind;
use momentous_problem::PlannedForm;
use momentous_problem::Problem;
use momentous_problem::Sampler;
use momentous_problem::Variant;
use momentous_problem::Worked;
use momentous_quantity::Printed;
use momentous_solve::Bounded;

use super::each::each;

/// Seeds that one thread draws before it takes others. The outcome does not depend on it.
const CHUNK: u64 = 64;

/// Relative distance at which two doubles that were reached on different ways are the same number.
const SAME: f64 = 1e-9;

/// Samples of many seeds.
#[derive(Debug, Default)]
pub(super) struct Samples {
    /// The samples drawn, in the order of the seeds.
    pub drawn: Vec<Sample>,
    /// The seeds that drew nothing.
    pub failed: Vec<u64>,
    /// Why the first of them drew nothing.
    pub reason: Option<NoVariant>,
    /// The number of attempts that were rejected.
    pub rejected: u64,
}

/// The sample of one seed.
#[derive(Debug)]
pub(super) struct Sample {
    /// The printed givens, as one text.
    pub given: String,
    /// The text of the sheet and the numbers of its graph, as a digest.
    pub sheet: u64,
    /// The omissions that are worth a word, each with its share of what is kept.
    pub neglected: Vec<(String, f64)>,
    /// The answers in the order of the parts that are numbers.
    pub answers: Vec<Answered>,
    /// The seed, and the values that leave a choice open.
    pub unclear: Option<(u64, String)>,
    /// The right phrases in the order of the parts that are choices or formulas.
    pub chosen: Vec<String>,
}

/// A number that answers a part.
#[derive(Debug)]
pub(super) struct Answered {
    /// Its value in the unit of the question.
    pub value: Bounded,
    /// The value as it is printed, without its unit.
    pub printed: String,
    /// Whether a given has the same value and dimension.
    pub is_given: bool,
}

impl Samples {
    /// Draws the seeds 1 to `seeds`.
    pub(super) fn draw(problem: &Problem, form: usize, seeds: u64) -> Result<Self, NoVariant> {
        let starts: Vec<u64> = (0..seeds.div_ceil(CHUNK)).map(|chunk| chunk * CHUNK + 1).collect();
        let chunk = |start: u64| Self::of_range(problem, form, start, (start + CHUNK).min(seeds + 1));
        let chunks: Vec<Self> = each(starts, chunk).into_iter().collect::<Result<_, _>>()?;
        let mut all = Self::default();
        for chunk in chunks {
            all.drawn.extend(chunk.drawn);
            all.failed.extend(chunk.failed);
            all.reason = all.reason.or(chunk.reason);
            all.rejected += chunk.rejected;
        }
        Ok(all)
    }

    fn of_range(problem: &Problem, form: usize, start: u64, end: u64) -> Result<Self, NoVariant> {
        let mut sampler = Sampler::new(problem, form)?;
        let mut samples = Self::default();
        for seed in start..end {
            match sampler.variant(seed) {
                Ok(variant) => samples.drawn.extend(Sample::of(problem, &variant)),
                Err(reason) => {
                    samples.failed.push(seed);
                    samples.reason.get_or_insert(reason);
                }
            }
        }
        samples.rejected = sampler.rejected();
        Ok(samples)
    }

    /// The share of attempts that were not rejected.
    pub(super) fn acceptance(&self) -> f64 {
        let drawn = self.drawn.len();
        #[allow(clippy::cast_precision_loss)] // counts of draws are far below 2^53
        let (drawn, rejected) = (drawn as f64, self.rejected as f64);
        if drawn + rejected > 0.0 { drawn / (drawn + rejected) } else { 0.0 }
    }

    /// The number of different sets of givens that were drawn.
    pub(super) fn variants(&self) -> usize {
        self.drawn.iter().map(|sample| sample.given.as_str()).collect::<BTreeSet<_>>().len()
    }

    /// The number of different texts that the sheets have.
    pub(super) fn sheets(&self) -> usize {
        self.drawn.iter().map(|sample| sample.sheet).collect::<BTreeSet<_>>().len()
    }

    /// Whether every seed has the same answers, as they are printed.
    pub(super) fn have_one_answer(&self) -> bool {
        let key = |sample: &Sample| -> Vec<String> {
            sample.answers.iter().map(|answer| &answer.printed).chain(&sample.chosen).cloned().collect()
        };
        self.drawn.first().map(key).is_some_and(|first| self.drawn.iter().all(|sample| key(sample) == first))
    }
}

/// The omission as the subject of a sentence.
fn called(problem: &Problem, weight: &ContactWeight) -> String {
    let scene = &problem.loaded().draft.scene;
    let phrase = problem.model().phrase(scene, weight.stage);
    format!("of the change of momentum of {} in {phrase}", scene.called(&weight.on))
}

fn digest(text: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    hasher.finish()
}

impl Sample {
    fn of(problem: &Problem, variant: &Variant) -> Option<Self> {
        let worked = Worked::new(problem, variant)?;
        let given: Vec<String> = variant.all_given().iter().map(|(_, value, unit)| format!("{value} {unit}")).collect();
        let unclear = worked.form.parts.iter().find_map(|part| match &part.kind {
            PartKind::Choice(choice) => Some((variant.seed()?, choice.unclear(&worked)?)),
            _ => None,
        });
        let chosen = worked.form.parts.iter().filter_map(|part| match &part.kind {
            PartKind::Choice(choice) => {
                let decision = choice.decided(&worked);
                decision.options.get(decision.right).cloned()
            }
            PartKind::Formula(formula) => worked.formula(formula).map(|formula| formula.text(&problem.model().symbols)),
            PartKind::Number(_) | PartKind::Vector(_) | PartKind::Range(_) => None,
        });
        let chosen = chosen.collect();
        let neglected =
            worked.neglected().into_iter().map(|(weight, share)| (called(problem, weight), share)).collect();
        Some(Self {
            given: given.join("; "),
            sheet: digest(&format!("{}{:?}", variant.text(problem), variant.printed_numbers(problem))),
            neglected,
            answers: answers(&worked, worked.form),
            unclear,
            chosen,
        })
    }
}

fn answers(worked: &Worked<'_>, form: &PlannedForm) -> Vec<Answered> {
    let number = |number: &NumberPart| {
        let value = worked.answer(number);
        let printed = Printed::new(value.value, number.figures).map_or_else(String::new, |printed| printed.plain());
        let si = worked.variant.value(number.symbol).map(|value| value.value);
        let dimension = worked.problem.model().symbols.entry(number.symbol).dimension;
        let is_given = worked.variant.all_given().iter().any(|(_, value, unit)| {
            let given = value.to_f64() * unit.factor().to_f64();
            let same = |si: f64| (si - given).abs() <= SAME * given.abs();
            unit.dimension() == dimension && given != 0.0 && si.is_some_and(same)
        });
        Answered { value, printed, is_given }
    };
    form.parts.iter().flat_map(|part| part.kind.numbers()).map(number).collect()
}
