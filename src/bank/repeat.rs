//! A few variants taken the whole way: solved again from their sheets, and their keys marked.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous_exercise::Exercise;
use momentous_explain::Detail;
use momentous_explain::lines_out;
use momentous_explain::offered_pictures;
use momentous_grade::DecimalMark;
use momentous_problem::ChoicePart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::Problem;
use momentous_problem::Sampler;
use momentous_problem::Worked;
use momentous_quantity::MOST_TOLERANCES;

use super::answers::noted;
use super::promise::Outcome;

/// Seeds whose variants are solved again from what is printed; each costs a compilation.
const SOLVED_AGAIN: u64 = 8;

/// Seeds whose keys are marked, as they are printed and rounded on the way.
const MARKED: u64 = 64;

/// The variants of the first seeds; those that draw nothing are told elsewhere.
fn exercises(problem: &Arc<Problem>, form: usize, seeds: u64) -> impl Iterator<Item = (u64, Exercise)> {
    (1..=seeds).filter_map(move |seed| Some((seed, Exercise::draw(problem, form, seed).ok()?)))
}

/// The problem solved with nothing but its printed numbers gives every printed answer; with a number that only says what follows from
/// others, and is rounded, it gives right ones.
pub(super) fn from_the_sheet(problem: &Arc<Problem>, form: usize, seeds: u64) -> Outcome {
    let differs = |(seed, first): (u64, Exercise)| {
        let values = sheet_values(&first);
        let is_source = |(name, _): &&(String, String)| !first.variant().follows_from_printed(problem, name);
        let sources: Vec<(String, String)> = values.iter().filter(is_source).cloned().collect();
        // With its text, by which a quantity that has a symbol only stays a letter.
        let again = Exercise::typed(problem, form, seed, &sources, &[]);
        let [ours, theirs] = [meant(&first), again.map(|again| meant(&again)).unwrap_or_default()];
        let other = |id: &String, answers: &[(String, String)]| {
            answers
                .iter()
                .find(|(answer, _)| answer == id)
                .map_or_else(|| "no answer".to_owned(), |(_, other)| other.clone())
        };
        let said = |id: &String, answer: &str, other: String| {
            format!("with seed {seed}, `{id}` is {answer}, but the printed numbers give {other}")
        };
        if let Some((id, answer)) = ours.iter().find(|answer| !theirs.contains(answer)) {
            return Some(said(id, answer, other(id, &theirs)));
        }
        if sources.len() == values.len() {
            return None;
        }
        let rounded = Exercise::typed(problem, form, seed, &values, &[]).map(|again| key(&again)).unwrap_or_default();
        let report = first.grade(&rounded.iter().cloned().collect(), DecimalMark::Point);
        let wrong = report.parts.iter().find(|part| !part.verdict.is_right())?;
        let answer = first.worked().form.parts.iter().find(|part| part.id == wrong.id).map(|part| first.printed(part));
        Some(said(&wrong.id, &answer.unwrap_or_default(), other(&wrong.id, &rounded)))
    };
    first(exercises(problem, form, seeds.min(SOLVED_AGAIN)).filter_map(differs))
}

/// The results that do not come out of what is printed before them, in the short solution or in the full one.
fn all_lines_out(exercise: &Exercise) -> Vec<String> {
    let short = lines_out(exercise.worked(), Detail::Short);
    if short.is_empty() { lines_out(exercise.worked(), Detail::Full) } else { short }
}

/// Checks that the numbers printed on a line of a worked solution give its result.
pub(super) fn reproduces(problem: &Arc<Problem>, form: usize, seeds: u64) -> Outcome {
    let seeds = seeds.min(MARKED);
    let out = exercises(problem, form, seeds).map(|(seed, exercise)| (seed, all_lines_out(&exercise)));
    let out: Vec<(u64, Vec<String>)> = out.filter(|(_, lines)| !lines.is_empty()).collect();
    match out.first() {
        Some((first, lines)) => Outcome::Broken(format!(
            "a line of the worked solution needs more figures than are printed for {} of {seeds} seeds, with seed {first} the line that gives {}: give numbers whose difference is not so small there",
            out.len(),
            lines.join(" and ")
        )),
        None => Outcome::Kept,
    }
}

/// The first thing that is wrong stands for all.
fn first(mut wrong: impl Iterator<Item = String>) -> Outcome {
    wrong.next().map_or(Outcome::Kept, Outcome::Broken)
}

/// The numbers on a sheet that say what a given or revealed quantity is, each as it is printed.
fn sheet_values(exercise: &Exercise) -> Vec<(String, String)> {
    let problem = exercise.problem();
    let revealed = |name: &String| exercise.worked().form.reveal.iter().any(|reveal| reveal.name == *name);
    let is_given = |name: &String| problem.loaded().given.get(name).is_some() || revealed(name);
    let mut printed = exercise.variant().printed_numbers(problem);
    printed.retain(|(name, _)| is_given(name));
    printed
}

fn key(exercise: &Exercise) -> Vec<(String, String)> {
    exercise.worked().form.parts.iter().map(|part| (part.id.clone(), exercise.printed(part))).collect()
}

/// The key with each picture described in place of its name, which depends on the seed.
fn meant(exercise: &Exercise) -> Vec<(String, String)> {
    let worked = exercise.worked();
    let described = |part: &Part| match &part.kind {
        PartKind::Choice(choice @ ChoicePart::Pictured(pictured)) => {
            let right = choice.decided(&worked).right;
            offered_pictures(worked, pictured).into_iter().nth(right).map(|drawing| drawing.description)
        }
        _ => None,
    };
    let parts = worked.form.parts.iter();
    parts.map(|part| (part.id.clone(), described(part).unwrap_or_else(|| exercise.printed(part)))).collect()
}

/// A student who types in what the key prints gets every point.
pub(super) fn key_marks(problem: &Arc<Problem>, form: usize, seeds: u64) -> Outcome {
    full_marks(problem, form, seeds, |exercise| key(exercise).into_iter().collect())
}

/// Checks the same for one who rounds every value on the way to the figures that are asked.
pub(super) fn rounding(problem: &Arc<Problem>, form: usize, seeds: u64) -> Outcome {
    full_marks(problem, form, seeds, |exercise| {
        let worked = exercise.worked();
        let mut answers = exercise.rounded_answers();
        // With ill-chosen numbers that the author fixed, which is noted, rounding on the way may lead anywhere.
        let blurred = |part: &&Part| worked.is_ill_chosen(part);
        answers.extend(worked.form.parts.iter().filter(blurred).map(|part| (part.id.clone(), exercise.printed(part))));
        answers
    })
}

/// Whether a student who answers in one way is right with every seed.
fn full_marks(
    problem: &Arc<Problem>,
    form: usize,
    seeds: u64,
    answers: impl Fn(&Exercise) -> BTreeMap<String, String>,
) -> Outcome {
    let wrong = |(seed, exercise): (u64, Exercise)| {
        let answers = answers(&exercise);
        let report = exercise.grade(&answers, DecimalMark::Point);
        let part = report.parts.iter().find(|part| !part.verdict.is_right())?;
        let typed = answers.get(&part.id).map(String::as_str).unwrap_or_default();
        Some(format!("with seed {seed}, `{}` = {typed} is marked {}: {}", part.id, part.verdict, part.message))
    };
    first(exercises(problem, form, seeds.min(MARKED)).filter_map(wrong))
}

/// How often rounding on the way shifts an answer too far: of drawn numbers, how often they are rejected for it.
pub(super) fn sharp(problem: &Arc<Problem>, form: usize, seeds: u64) -> Outcome {
    let Ok(mut sampler) = Sampler::new(problem, form) else { return Outcome::NotChecked("there is no such form") };
    let mut ill_chosen: BTreeMap<String, u64> = BTreeMap::new();
    let mut drawn: u64 = 0;
    for variant in (1..=seeds.min(MARKED)).filter_map(|seed| sampler.variant(seed).ok()) {
        drawn += 1;
        let Some(worked) = Worked::new(problem, &variant) else { continue };
        for part in worked.form.parts.iter().filter(|part| worked.is_ill_chosen(part)) {
            *ill_chosen.entry(part.id.clone()).or_insert(0) += 1;
        }
    }
    let shifts =
        |id: &str| format!("rounding intermediate results shifts `{id}` by more than {MOST_TOLERANCES} tolerances");
    let attempts = drawn + sampler.rejected();
    let rejected = sampler.rejected_as_ill_chosen().iter();
    let rejected =
        rejected.map(|(id, times)| format!("{} in {times} of {attempts} draws, which are drawn again", shifts(id)));
    let fixed = ill_chosen.keys().map(|id| {
        format!("{}; ask for more figures (`figures: 4`), widen its `tolerance`, or choose other numbers", shifts(id))
    });
    noted(&rejected.chain(fixed).collect::<Vec<_>>())
}
