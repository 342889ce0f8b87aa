//! A variant with all that marks it elsewhere: what every export reads, and none computes.

use momentous_explain as explain;
use momentous_explain::Audience;
use momentous_explain::Detail;
use momentous_explain::Outline;
use momentous_expr::Math;
use momentous_grade as grade;
use momentous_grade::ExpectedKind;
use momentous_grade::Message;
use momentous_grade::Points;
use momentous_grade::Rubric;
use momentous_grade::Verdict;
use momentous_grade::VerdictWindow;
use momentous_grade::catalogue::{Catalogue, English};
use momentous_grade::diagnose;
use momentous_problem::Mistake;
use momentous_problem::NumberPart;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::Simulated;
use momentous_quantity::Rational;
use momentous_quantity::Unit;
use momentous_render::Identity;

use super::Exercise;
use super::diagnosis::{hints_on, likeliest_first, misjudged, unexplained};
use super::roots::{each_expected, several};
use super::rules::Rules;
use super::sheet_numbers::SheetNumbers;
use super::student_sheet::{Field, StudentSheet};

/// Ends of windows that are nearer to each other than this share of them are one.
const SAME: f64 = 1e-9;

/// A variant with everything that a program without this engine needs to show, mark and explain it.
#[derive(Clone, Debug)]
pub struct Item {
    /// What makes the same numbers again.
    pub identity: Identity,
    /// The numbers that the sheet tells.
    pub given: SheetNumbers,
    /// The version of the problem.
    pub version: String,
    /// Letters by which the variant is known; nothing can be read from them.
    pub code: String,
    /// What the student sees.
    pub sheet: StudentSheet,
    /// What is asked, with the answers that earn something or have something said of them; in the order of the sheet's fields.
    pub parts: Vec<ItemPart>,
    /// The worked solution.
    pub solution: Outline,
    /// The share of the points that each further try costs.
    pub penalty: Rational,
    /// The share of the points that each hint costs.
    pub hint_penalty: Rational,
}

/// One part of an item.
#[derive(Clone, Debug)]
pub struct ItemPart {
    /// The room for its answer.
    pub field: Field,
    /// The right answer as it is printed.
    pub printed: String,
    /// How answers are told apart.
    pub answers: ItemAnswers,
}

/// How answers to a part are told apart.
#[derive(Clone, Debug)]
pub enum ItemAnswers {
    /// By the number in the unit of the question.
    Number(Box<NumberItem>),
    /// By each of several values, from the smallest.
    Roots(Vec<NumberItem>),
    /// By each component.
    Vector {
        /// The letters of the axes.
        axes: Vec<String>,
        /// The component along each.
        components: Vec<NumberItem>,
    },
    /// By the phrase.
    Choice {
        /// The phrases.
        options: Vec<String>,
        /// The position of the right one.
        right: usize,
        /// Why it is right.
        because: String,
        /// What is said of each that is wrong: a question first, then a hint.
        wrong: Vec<Vec<String>>,
    },
    /// By the formula.
    Formula {
        /// The right one.
        right: FormulaItem,
        /// What usual mistakes lead to, each with what is said of it.
        mistaken: Vec<(FormulaItem, String)>,
    },
    /// By its ends.
    Interval {
        /// The lower end; none where it is open to minus infinity.
        low: Option<Box<NumberItem>>,
        /// The upper end; none where it is open to infinity.
        high: Option<Box<NumberItem>>,
    },
}

/// A formula, as it is typed and as it is printed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FormulaItem {
    /// As it is typed.
    pub text: String,
    /// As it is printed; none where it has no value.
    pub math: Option<Math>,
}

/// A number that is asked.
#[derive(Clone, Debug)]
pub struct NumberItem {
    /// The right value.
    pub right: f64,
    /// The unit of the question.
    pub unit: Unit,
    /// A full turn, of a direction: whole turns more or less do not matter.
    pub turn: Option<f64>,
    /// Whether only whole numbers count.
    pub whole: bool,
    /// The words for a positive and for a negative value, of what has a direction.
    pub senses: Option<[String; 2]>,
    /// The significant figures of the printed answer.
    pub figures: usize,
    /// The points of the right number without its unit.
    pub without_unit: Points,
    /// Which numbers earn something, or have something said of them: disjoint, from low to high.
    pub windows: Vec<Window>,
}

/// Numbers that are marked alike; both ends belong to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The verdict.
    pub verdict: Verdict,
    /// The points that it earns.
    pub points: Points,
    /// The usual mistakes that lead here, by their codes.
    pub mistakes: Vec<&'static str>,
    /// What is said of it: of a mistake a question first, then plainer.
    pub feedback: Vec<String>,
}

impl Window {
    /// Whether two windows differ in their ends only.
    fn is_marked_as(&self, other: &Self) -> bool {
        self.verdict == other.verdict && self.mistakes == other.mistakes && self.feedback == other.feedback
    }
}

/// A mistake with the numbers that it leads to.
struct Mistaken<'m> {
    mistake: &'m Mistake,
    low: f64,
    high: f64,
}

impl Exercise {
    /// This variant as an item. Marking decides in the same way: `tests/marking/items.rs` holds them against each other.
    #[must_use]
    pub fn item(&self) -> Item {
        let sheet = self.student_sheet();
        let worked = self.worked();
        let simulated = worked.simulated();
        let parts = worked.form.parts.iter().zip(&sheet.fields);
        let parts = parts.map(|(part, field)| ItemPart {
            field: field.clone(),
            printed: self.printed(part),
            answers: self.item_answers(part, &simulated),
        });
        let attempts = Rules { problem: worked.problem, form: worked.form }.rubric().attempts;
        Item {
            given: self.sheet_numbers(),
            version: self.problem.loaded().digests.version(),
            identity: self.identity(),
            code: self.code(),
            parts: parts.collect(),
            sheet,
            solution: self.outline(Audience::Everyone, Detail::Short),
            penalty: attempts.penalty,
            hint_penalty: attempts.hint,
        }
    }

    fn item_answers(&self, part: &Part, simulated: &Simulated<'_>) -> ItemAnswers {
        match (self.expected(part).kind, &part.kind) {
            (ExpectedKind::Number(_), _) if several(self.worked(), part).is_some() => {
                ItemAnswers::Roots(self.root_items(part, simulated))
            }
            (ExpectedKind::Number(expected), PartKind::Number(number)) => {
                let mistaken = self.mistaken(number, &expected, simulated);
                ItemAnswers::Number(Box::new(self.number_item(part, &expected, &mistaken)))
            }
            (ExpectedKind::Vector(expected), PartKind::Vector(vector)) => {
                let component = |(blank, number): (&grade::ExpectedNumber, &NumberPart)| {
                    self.number_item(part, blank, &self.mistaken(number, blank, simulated))
                };
                ItemAnswers::Vector {
                    axes: vector.axes.iter().map(|axis| (*axis).to_owned()).collect(),
                    components: expected.components.iter().zip(&vector.components).map(component).collect(),
                }
            }
            (ExpectedKind::Choice { options, right, because, .. }, kind) => {
                let decision = match kind {
                    PartKind::Choice(choice) => Some(choice.decided(&self.worked())),
                    _ => None,
                };
                let hints = |option| Some(misjudged(self.worked(), decision.as_ref()?, option)?.hints);
                let wrong = (0..options.len()).map(|option| hints(option).unwrap_or_default()).collect();
                ItemAnswers::Choice { options, right, because, wrong }
            }
            (_, PartKind::Formula(formula)) => ItemAnswers::Formula {
                right: FormulaItem { text: self.printed(part), math: explain::printed_formula(self.worked(), formula) },
                mistaken: self.mistaken_formulas(part, formula),
            },
            (ExpectedKind::Interval(expected), _) => {
                let end = |end: &Option<grade::ExpectedEnd>| {
                    end.as_ref().map(|end| Box::new(self.number_item(part, &end.number, &[])))
                };
                ItemAnswers::Interval { low: end(&expected.low), high: end(&expected.high) }
            }
            // Marking expects of each kind of part an answer of its own kind.
            _ => ItemAnswers::Formula { right: FormulaItem::default(), mistaken: Vec::new() },
        }
    }

    fn root_items(&self, part: &Part, simulated: &Simulated<'_>) -> Vec<NumberItem> {
        let roots = several(self.worked(), part).unwrap_or_default();
        let expected = each_expected(&self.expected(part), &roots, self.worked(), part);
        let expected: Vec<grade::ExpectedNumber> = expected.into_iter().filter_map(number_expected).collect();
        let item = |expected_number: &grade::ExpectedNumber| {
            let PartKind::Number(number) = &part.kind else { return self.number_item(part, expected_number, &[]) };
            // What is right for another root is no mistake, but in the wrong place.
            let is_other = |mistaken: &Mistaken<'_>| {
                expected.iter().any(|root| (mistaken.low..=mistaken.high).contains(&root.value))
            };
            let mut mistaken = self.mistaken(number, expected_number, simulated);
            mistaken.retain(|mistaken| !is_other(mistaken));
            self.number_item(part, expected_number, &mistaken)
        };
        let mut items: Vec<NumberItem> = expected.iter().map(item).collect();
        items.sort_by(|left, right| left.right.total_cmp(&right.right));
        items
    }

    fn number_item(&self, part: &Part, expected: &grade::ExpectedNumber, mistaken: &[Mistaken<'_>]) -> NumberItem {
        let worked = self.worked();
        let rubric = Rules { problem: worked.problem, form: worked.form }.rubric();
        let mut windows = self.windows(&grade::windows(expected), mistaken, part.points, &rubric);
        for window in windows.iter_mut().filter(|window| window.feedback.is_empty()) {
            window.feedback.extend(slip(window.verdict, expected));
        }
        NumberItem {
            right: expected.value,
            unit: expected.unit.clone(),
            turn: turn(expected),
            whole: expected.whole,
            senses: expected.senses.clone(),
            figures: expected.figures,
            without_unit: rubric.points(Verdict::UnitMissing, part.points),
            windows,
        }
    }

    /// What usual mistakes make of a number, rounded as students round.
    fn mistaken(
        &self,
        number: &NumberPart,
        expected: &grade::ExpectedNumber,
        simulated: &Simulated<'_>,
    ) -> Vec<Mistaken<'_>> {
        let mut all = Vec::new();
        for mistake in self.worked().mistakes() {
            for value in simulated.answers(mistake, number) {
                let window = diagnose::window(expected, value);
                let near = match (window, turn(expected)) {
                    (Some(window), Some(turn)) => grade::brought_near(window, expected.value, turn),
                    (window, _) => window.into_iter().collect(),
                };
                all.extend(near.into_iter().map(|[low, high]| Mistaken { mistake, low, high }));
            }
        }
        all
    }

    /// The windows of the judge and those of mistakes, cut where any of them begins or ends.
    fn windows(
        &self,
        judged: &[VerdictWindow],
        mistaken: &[Mistaken<'_>],
        out_of: u32,
        rubric: &Rubric,
    ) -> Vec<Window> {
        let ends = judged.iter().flat_map(|window| [window.low, window.high]);
        let mut cuts: Vec<f64> = ends.chain(mistaken.iter().flat_map(|window| [window.low, window.high])).collect();
        cuts.sort_by(f64::total_cmp);
        // Ends that differ by rounding are one.
        cuts.dedup_by(|next, kept| *next - *kept <= SAME * kept.abs().max(next.abs()));
        let mut all: Vec<Window> = Vec::new();
        for pair in cuts.windows(2) {
            let [low, high] = [pair[0], pair[1]];
            let middle = low + (high - low) / 2.0;
            let verdict =
                judged.iter().find(|window| window.contains(middle)).map_or(Verdict::Wrong, |window| window.verdict);
            let behind = mistaken.iter().filter(|window| (window.low..=window.high).contains(&middle));
            let behind: Vec<&Mistake> =
                behind.map(|window| window.mistake).filter(|_| diagnose::is_open(verdict)).collect();
            if verdict == Verdict::Wrong && behind.is_empty() {
                continue;
            }
            let (mistakes, feedback) = self.said(unexplained(verdict, behind));
            let points = rubric.points(verdict, out_of);
            let window = Window { low, high, verdict, points, mistakes, feedback };
            match all.last_mut().filter(|last| last.high >= low && last.is_marked_as(&window)) {
                Some(last) => last.high = high,
                None => all.push(window),
            }
        }
        all
    }

    /// The codes of mistakes, and what is said of the likeliest.
    fn said(&self, mut behind: Vec<&Mistake>) -> (Vec<&'static str>, Vec<String>) {
        let worked = self.worked();
        likeliest_first(worked, &mut behind);
        let feedback = hints_on(worked, &behind);
        let mut codes: Vec<&'static str> = Vec::new();
        for mistake in behind {
            if !codes.contains(&mistake.of.id) {
                codes.push(mistake.of.id);
            }
        }
        (codes, feedback)
    }
}

fn number_expected(expected: grade::Expected) -> Option<grade::ExpectedNumber> {
    match expected.kind {
        ExpectedKind::Number(number) => Some(number),
        _ => None,
    }
}

/// What is said of a slip where a number is all that can be typed: no words are advised.
fn slip(verdict: Verdict, expected: &grade::ExpectedNumber) -> Option<String> {
    let message = match verdict {
        Verdict::UnitPrefix => Message::UnitPrefix,
        Verdict::OrderOfMagnitude => Message::OrderOfMagnitude,
        Verdict::Sense => Message::Sense(None),
        Verdict::SenseReversed => Message::reversed(expected.senses.as_ref()),
        Verdict::RightWithNote => Message::NegativeMagnitude,
        Verdict::AngleReversed
        | Verdict::AngleOtherSense
        | Verdict::AngleSupplement
        | Verdict::AngleComplement
        | Verdict::AngleOtherAxis => Message::Slip(verdict),
        _ => return None,
    };
    Some(English.message(&message).into_owned())
}

/// A full turn in the unit of a direction.
fn turn(expected: &grade::ExpectedNumber) -> Option<f64> {
    expected.cyclic.then(|| std::f64::consts::TAU / expected.size)
}
