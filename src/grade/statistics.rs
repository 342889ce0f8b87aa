//! Statistics of a class's answers to the questions: how easy each part was, how well it tells students apart, and which wrong
//! answers were common. It is gathered answer by answer, in memory that grows with the students and the parts only.

use std::collections::BTreeMap;
use std::collections::BinaryHeap;

use serde::Serialize;

use momentous_laws::wrong::find;

use super::frequent::{Frequent, WrongAnswer};
use super::report::{Entry, PartReport};
use super::rows::RowCounts;
use super::verdict::Verdict;

/// Answers of a part that are kept for its discrimination.
const SAMPLE: usize = 5000;
/// Examples that are kept of each kind of wrong answer.
const EXAMPLES: usize = 3;
/// Bars of a histogram of scores.
const BARS: usize = 10;

/// Which part: of which problem and form.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Item {
    /// The problem's identity.
    pub problem: String,
    /// The form; empty where it has one form without a name.
    pub form: String,
    /// The part.
    pub part: String,
}

/// Gathers marked answers.
#[derive(Clone, Debug, Default)]
pub struct Gathering {
    students: BTreeMap<String, Tally>,
    items: BTreeMap<Item, Gathered>,
}

/// The statistics of everything that was gathered.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Statistics {
    /// The fate of the rows of the file.
    pub rows: RowCounts,
    /// Marked answers.
    pub answers: u64,
    /// Students by name; answers without a student's name belong to one without a name.
    pub students: usize,
    /// The mean of the students' scores, each from 0 to 1.
    pub mean: f64,
    /// How many students have a score from 0 to 0.1, from 0.1 to 0.2, and so on.
    pub histogram: [u64; BARS],
    /// Each part.
    pub items: Vec<ItemStatistics>,
}

/// The statistics of one part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ItemStatistics {
    /// Which part.
    #[serde(flatten)]
    pub item: Item,
    /// Marked answers.
    pub answers: u64,
    /// The share of its points that was reached, from 0 to 1.
    pub facility: f64,
    /// The correlation between the score of this part and the student's score elsewhere, from -1 to 1, from at most 5000 answers. Nothing
    /// where it has no meaning: fewer than three students, or all alike.
    pub discrimination: Option<f64>,
    /// How often each verdict was given, the most frequent first.
    pub verdicts: Vec<VerdictCount>,
    /// The usual mistakes that wrong answers come from, the most frequent first. An answer that comes of several counts for each.
    pub mistakes: Vec<MistakeCount>,
    /// Answers that followed from an earlier wrong one.
    pub followed: u64,
    /// The wrong answers that were given most often.
    pub wrong: Vec<WrongAnswer>,
}

/// How often a usual mistake was diagnosed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MistakeCount {
    /// The stable code of the mistake.
    pub mistake: &'static str,
    /// The mistake as it follows a subject.
    pub does: &'static str,
    /// How often.
    pub count: u64,
    /// The first few answers as they were understood.
    pub examples: Vec<String>,
}

/// How often a verdict was given.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VerdictCount {
    /// The stable code of the verdict.
    pub verdict: String,
    /// Whether it means that the answer is right.
    pub right: bool,
    /// How often.
    pub count: u64,
    /// The first few answers as they were understood.
    pub examples: Vec<String>,
}

/// Points reached of points that could be reached.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    reached: f64,
    out_of: f64,
}

#[derive(Clone, Debug, Default)]
struct Gathered {
    tally: Tally,
    answers: u64,
    /// Answers of attempts that count.
    counted: u64,
    verdicts: BTreeMap<&'static str, (bool, u64, Vec<String>)>,
    mistakes: BTreeMap<&'static str, (u64, Vec<String>)>,
    followed: u64,
    wrong: Frequent,
    sample: BinaryHeap<Sampled>,
}

/// One answer of the sample. The least words are kept, which is a choice that depends on the answer's number alone.
#[derive(Clone, Debug)]
struct Sampled {
    word: u64,
    student: String,
    tally: Tally,
}

impl PartialEq for Sampled {
    fn eq(&self, other: &Self) -> bool {
        self.word == other.word
    }
}

impl Eq for Sampled {}

impl PartialOrd for Sampled {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Sampled {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.word.cmp(&other.word)
    }
}

impl Tally {
    fn add(&mut self, other: Self) {
        self.reached += other.reached;
        self.out_of += other.out_of;
    }

    fn without(self, other: Self) -> Self {
        Self { reached: self.reached - other.reached, out_of: self.out_of - other.out_of }
    }

    /// From 0 to 1; nothing where nothing could be reached.
    fn share(self) -> Option<f64> {
        (self.out_of > 0.0).then(|| self.reached / self.out_of)
    }
}

impl Gathered {
    /// Adds what was typed in an attempt.
    fn add(&mut self, part: &PartReport) {
        self.answers += 1;
        let verdict = if part.is_unread() { Verdict::Unreadable } else { part.verdict };
        let (_, count, examples) =
            self.verdicts.entry(verdict.code()).or_insert_with(|| (verdict.is_right(), 0, Vec::new()));
        *count += 1;
        if verdict != part.verdict {
            return;
        }
        if let Some(understood) = part.understood.as_ref().filter(|_| examples.len() < EXAMPLES) {
            examples.push(understood.clone());
        }
        for code in part.diagnosis.iter().flat_map(|diagnosis| &diagnosis.codes) {
            let (count, examples) = self.mistakes.entry(code).or_default();
            *count += 1;
            examples.extend(part.understood.clone().filter(|_| examples.len() < EXAMPLES));
        }
        self.followed += u64::from(part.follows.is_some());
        if !verdict.is_right() {
            self.wrong.add(part);
        }
    }
}

impl Gathering {
    /// Adds a student's answer to a part. It is counted as an answer in the attempt in which it was typed; points are of those that
    /// count.
    pub fn add(&mut self, student: &str, problem: &str, form: &str, part: &PartReport) {
        let tally = if part.counts {
            Tally { reached: part.points.0.to_f64().value(), out_of: f64::from(part.out_of) }
        } else {
            Tally::default()
        };
        match self.students.get_mut(student) {
            Some(known) => known.add(tally),
            None => {
                self.students.insert(student.to_owned(), tally);
            }
        }
        let item = Item { problem: problem.to_owned(), form: form.to_owned(), part: part.id.clone() };
        let gathered = self.items.entry(item).or_default();
        gathered.tally.add(tally);
        if matches!(part.entry, Entry::Typed | Entry::Unread) {
            gathered.add(part);
        }
        if !part.counts {
            return;
        }
        gathered.counted += 1;
        let word = mixed(gathered.counted);
        if gathered.sample.len() < SAMPLE || gathered.sample.peek().is_some_and(|most| word < most.word) {
            gathered.sample.push(Sampled { word, student: student.to_owned(), tally });
            if gathered.sample.len() > SAMPLE {
                gathered.sample.pop();
            }
        }
    }

    /// The statistics of what was gathered so far, from these rows.
    #[must_use]
    pub fn statistics(&self, rows: RowCounts) -> Statistics {
        let shares: Vec<f64> = self.students.values().filter_map(|tally| tally.share()).collect();
        let mut histogram = [0; BARS];
        for share in &shares {
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a share of ten is from 0 to 10"
            )]
            let bar = ((share * 10.0) as usize).min(BARS - 1);
            histogram[bar] += 1;
        }
        Statistics {
            rows,
            answers: self.items.values().map(|item| item.answers).sum(),
            students: self.students.len(),
            mean: mean(&shares),
            histogram,
            items: self.items.iter().map(|(item, gathered)| self.item(item, gathered)).collect(),
        }
    }

    fn item(&self, item: &Item, gathered: &Gathered) -> ItemStatistics {
        let pairs = gathered.sample.iter().filter_map(|sampled| {
            let all = self.students.get(&sampled.student)?;
            Some((sampled.tally.share()?, all.without(sampled.tally).share()?))
        });
        let mut verdicts: Vec<VerdictCount> = gathered
            .verdicts
            .iter()
            .map(|(verdict, (right, count, examples))| VerdictCount {
                verdict: (*verdict).to_owned(),
                right: *right,
                count: *count,
                examples: examples.clone(),
            })
            .collect();
        verdicts.sort_by_key(|verdict| std::cmp::Reverse(verdict.count));
        let mistake = |(code, (count, examples)): (&&'static str, &(u64, Vec<String>))| MistakeCount {
            mistake: code,
            does: find(code).map_or("", |kind| kind.does),
            count: *count,
            examples: examples.clone(),
        };
        let mut mistakes: Vec<MistakeCount> = gathered.mistakes.iter().map(mistake).collect();
        mistakes.sort_by_key(|mistake| std::cmp::Reverse(mistake.count));
        ItemStatistics {
            item: item.clone(),
            answers: gathered.answers,
            facility: gathered.tally.share().unwrap_or(0.0),
            discrimination: correlation(&pairs.collect::<Vec<_>>()),
            verdicts,
            mistakes,
            followed: gathered.followed,
            wrong: gathered.wrong.most(),
        }
    }
}

/// A word that depends on nothing but the number, and looks like chance: the finaliser of `SplitMix64`.
fn mixed(number: u64) -> u64 {
    let mut word = number.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}

#[allow(clippy::cast_precision_loss, reason = "counts of people")]
fn mean(values: &[f64]) -> f64 {
    if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / values.len() as f64 }
}

/// Pearson's coefficient of correlation.
fn correlation(pairs: &[(f64, f64)]) -> Option<f64> {
    if pairs.len() < 3 {
        return None;
    }
    let (x, y): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
    let (x_mean, y_mean) = (mean(&x), mean(&y));
    let sum = |term: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|(x, y)| term(x - x_mean, y - y_mean)).sum::<f64>();
    let (xx, yy, xy) = (sum(&|x, _| x * x), sum(&|_, y| y * y), sum(&|x, y| x * y));
    (xx > 0.0 && yy > 0.0).then(|| xy / libm::sqrt(xx * yy))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Points, Verdict};
    use momentous_quantity::Rational;

    fn part(id: &str, right: bool) -> PartReport {
        PartReport {
            id: id.to_owned(),
            verdict: if right { Verdict::Right } else { Verdict::Wrong },
            points: Points(Rational::from(i64::from(right))),
            out_of: 1,
            understood: Some(format!("{id} {right}")),
            fault: None,
            message: std::borrow::Cow::Borrowed(""),
            diagnosis: None,
            follows: None,
            own_values: None,
            entry: Entry::Typed,
            counts: true,
        }
    }

    /// Four students; by hand: the first part goes with the rest of the score, the second against it.
    #[test]
    fn a_part_tells_students_apart() {
        let mut gathering = Gathering::default();
        let class = [
            ("a", [true, false, true]),
            ("b", [true, false, true]),
            ("c", [false, true, false]),
            ("d", [false, false, false]),
        ];
        for (student, right) in class {
            for (id, right) in ["p", "q", "r"].into_iter().zip(right) {
                gathering.add(student, "x/y", "", &part(id, right));
            }
        }
        let statistics = gathering.statistics(RowCounts::default());
        assert_eq!((statistics.answers, statistics.students), (12, 4));
        assert_eq!(statistics.histogram, [1, 0, 0, 1, 0, 0, 2, 0, 0, 0]);
        let [p, q, _] = &statistics.items[..] else { panic!("{statistics:?}") };
        assert!((p.facility - 0.5).abs() < 1e-12 && (q.facility - 0.25).abs() < 1e-12);
        // Scores elsewhere: of p 1/2 1/2 1/2 0; of q 1 1 0 0.
        assert!((p.discrimination.unwrap() - 1.0 / 3.0_f64.sqrt()).abs() < 1e-12, "{p:?}");
        assert!((q.discrimination.unwrap() + 1.0 / 3.0_f64.sqrt()).abs() < 1e-12, "{q:?}");
        assert_eq!(p.verdicts[0].examples, ["p true", "p true"]);
    }

    #[test]
    fn the_memory_of_a_part_is_bounded() {
        let mut gathering = Gathering::default();
        for number in 0..20_000 {
            gathering.add("s", "x/y", "", &part("p", number % 2 == 0));
        }
        assert!(gathering.items.values().all(|item| item.sample.len() == SAMPLE));
        assert!((gathering.statistics(RowCounts::default()).items[0].facility - 0.5).abs() < 1e-12);
    }
}
