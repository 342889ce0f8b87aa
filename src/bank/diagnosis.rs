//! Checks how well common mistakes are distinguished: simulated students who make exactly one of them are marked, and the diagnosis is
//! compared with what they did.

use std::collections::BTreeMap;
use std::collections::BTreeSet;
use std::sync::Arc;

use momentous_exercise::Exercise;
use momentous_fault::Faults;
use momentous_fault::Source;
use momentous_grade::DecimalMark;
use momentous_problem::Problem;
use momentous_problem::compile;

use super::course::load_in_course;
use super::each::each;

/// Tallies of simulated students.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Students whose answer was wrong.
    pub students: u64,
    /// Diagnosed as the mistake that they made, alone or beside others that give the same answer.
    pub right: u64,
    /// Those of them whose answer comes of other mistakes too with these numbers.
    pub shared: u64,
    /// Diagnosed as something that they did not do.
    pub another: u64,
    /// Not diagnosed.
    pub none: u64,
    /// Students whose mistake gave a right answer with these numbers, so that there is nothing to find.
    pub hidden: u64,
    /// Those of them who made each mistake.
    pub hidden_by: BTreeMap<&'static str, u64>,
    /// All students who made each mistake.
    pub made: BTreeMap<&'static str, u64>,
    /// Students who did everything right, rounding at the end or all the way.
    pub honest: u64,
    /// Those of them who lost a mark or were told of a mistake.
    pub wronged: u64,
    /// The diagnosis of each mistake that was not found: the mistake, the diagnosis, how often.
    pub confused: BTreeMap<(&'static str, String), u64>,
}

/// The result of the students of one problem.
#[derive(Clone, Debug)]
pub struct Diagnosed {
    /// The problem's identity.
    pub problem: String,
    /// The codes of the mistakes that can be made in it.
    pub mistakes: Vec<&'static str>,
    /// The tally.
    pub tally: Tally,
}

impl Tally {
    /// The sum of two.
    #[must_use]
    pub fn plus(mut self, other: &Self) -> Self {
        self.students += other.students;
        self.right += other.right;
        self.shared += other.shared;
        self.another += other.another;
        self.none += other.none;
        self.hidden += other.hidden;
        self.honest += other.honest;
        self.wronged += other.wronged;
        for (sum, counts) in [(&mut self.hidden_by, &other.hidden_by), (&mut self.made, &other.made)] {
            for (code, count) in counts {
                *sum.entry(code).or_default() += count;
            }
        }
        for (key, count) in &other.confused {
            *self.confused.entry(key.clone()).or_default() += count;
        }
        self
    }
}

/// Marks, for each form, part and seed, one student who makes one mistake, and two who make none.
///
/// # Errors
/// The faults of a file that does not load.
pub fn diagnosed(source: &Source, seeds: u64) -> Result<Diagnosed, Faults> {
    let problem = Arc::new(compile(load_in_course(source.clone())?, None)?);
    let forms = 0..problem.forms().len();
    let students: Vec<(usize, u64)> = forms.flat_map(|form| (1..=seeds).map(move |seed| (form, seed))).collect();
    let mut tally = Tally::default();
    let mut mistakes = BTreeSet::new();
    for (tally_of_student, codes) in each(students, |(form, seed)| of_seed(&problem, form, seed)) {
        tally = tally.plus(&tally_of_student);
        mistakes.extend(codes);
    }
    let mistakes = mistakes.into_iter().collect();
    Ok(Diagnosed { problem: problem.id().to_owned(), mistakes, tally })
}

fn of_seed(problem: &Arc<Problem>, form: usize, seed: u64) -> (Tally, Vec<&'static str>) {
    let (mut tally, mut codes) = (Tally::default(), Vec::new());
    let Ok(exercise) = Exercise::draw(problem, form, seed) else { return (tally, codes) };
    let parts = &exercise.worked().form.parts;
    let key = parts.iter().map(|part| (part.id.clone(), exercise.printed(part))).collect();
    for answers in [key, exercise.rounded_answers()] {
        let report = exercise.grade(&answers, DecimalMark::Point);
        tally.honest += 1;
        let told = report.parts.iter().any(|part| part.diagnosis.is_some() || part.follows.is_some());
        tally.wronged += u64::from(told || !report.is_right());
    }
    for (place, part) in parts.iter().enumerate() {
        let answers = exercise.mistaken_answers(part);
        codes.extend(answers.iter().map(|(code, _)| *code));
        let Some((code, text)) = picked(&answers, seed, place) else { continue };
        let report = exercise.grade(&BTreeMap::from([(part.id.clone(), text.clone())]), DecimalMark::Point);
        let Some(marked) = report.parts.iter().find(|marked| marked.id == part.id) else { continue };
        *tally.made.entry(code).or_default() += 1;
        if marked.verdict.is_right() {
            tally.hidden += 1;
            *tally.hidden_by.entry(code).or_default() += 1;
            continue;
        }
        tally.students += 1;
        match &marked.diagnosis {
            Some(diagnosis) if diagnosis.codes.contains(code) => {
                tally.right += 1;
                tally.shared += u64::from(diagnosis.codes.len() > 1);
            }
            Some(diagnosis) => {
                tally.another += 1;
                *tally.confused.entry((code, diagnosis.codes.join(" "))).or_default() += 1;
            }
            None => {
                tally.none += 1;
                *tally.confused.entry((code, marked.verdict.code().to_owned())).or_default() += 1;
            }
        }
    }
    (tally, codes)
}

/// One of the mistakes, each as likely as any other, and one of the answers that come of it.
fn picked<'a>(answers: &'a [(&'static str, String)], seed: u64, part: usize) -> Option<&'a (&'static str, String)> {
    let groups: Vec<&[(&'static str, String)]> = answers.chunk_by(|one, other| one.0 == other.0).collect();
    let mix = |value: u64| {
        let value = (value ^ (value >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let value = (value ^ (value >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        value ^ (value >> 31)
    };
    let word = mix(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ part as u64);
    let choose = |word: u64, count: usize| usize::try_from(word % (count.max(1) as u64)).unwrap_or(0);
    let group = groups.get(choose(word, groups.len()))?;
    group.get(choose(word >> 32, group.len()))
}
