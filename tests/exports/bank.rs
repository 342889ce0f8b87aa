//! Items of the whole bank, and how an answer to them has to be marked wherever they go.

use std::io::Read;
use std::sync::{Arc, OnceLock};

use momentous::bank::Bank;
use momentous::exercise::{Exercise, Item, ItemAnswers, NumberItem, Window};
use momentous::export::{Question, Target};
use momentous::fault::Source;
use momentous::grade::Verdict;
use momentous::problem::{Problem, compile, load};

/// The seed of each form, and more of them for other programs, which are tried by hand.
const SEEDS: [u64; 3] = [1, 8, 9];

fn seeds() -> &'static [u64] {
    if std::env::var_os("EXPORT_CASES").is_some() { &SEEDS } else { &SEEDS[..1] }
}

/// Every form of the bank: its problem, and its place among the forms of that.
pub fn all_forms() -> &'static [(Arc<Problem>, usize)] {
    static FORMS: OnceLock<Vec<(Arc<Problem>, usize)>> = OnceLock::new();
    FORMS.get_or_init(|| {
        let compiled = |source: Source| Arc::new(compile(load(source).unwrap(), None).unwrap());
        let problems: Vec<Arc<Problem>> = Bank::built_in().sources().cloned().map(compiled).collect();
        let forms = |problem: Arc<Problem>| (0..problem.forms().len()).map(move |form| (problem.clone(), form));
        problems.into_iter().flat_map(forms).collect()
    })
}

/// Variants of a form; those that have nothing to ask left out.
pub fn variants(problem: &Arc<Problem>, form: usize, seeds: impl IntoIterator<Item = u64>) -> Vec<Item> {
    let items = seeds.into_iter().map(|seed| Exercise::draw(problem, form, seed).unwrap().item());
    items.filter(|item| !Question::new(item).is_empty()).collect()
}

/// The items of every form, grouped by form.
pub fn forms() -> &'static [Vec<Item>] {
    static FORMS: OnceLock<Vec<Vec<Item>>> = OnceLock::new();
    let items = |(problem, form): &(Arc<Problem>, usize)| variants(problem, *form, seeds().iter().copied());
    FORMS.get_or_init(|| all_forms().iter().map(items).collect())
}

/// An item of two carts.
pub fn carts() -> Item {
    static CARTS: OnceLock<Item> = OnceLock::new();
    let made = || {
        let source = Bank::built_in().find("impact/two-carts").unwrap().clone();
        let problem = Arc::new(compile(load(source).unwrap(), None).unwrap());
        Exercise::draw(&problem, 0, 7).unwrap().item()
    };
    CARTS.get_or_init(made).clone()
}

/// Bytes as text.
pub fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

/// What a target writes of items.
pub fn exported<'i>(target: &str, items: impl IntoIterator<Item = &'i Item>) -> Vec<u8> {
    let target = Target::named(target).unwrap();
    let mut bytes = Vec::new();
    let mut file = target.begin(Box::new(&mut bytes), target.markup[0], "a quiz").unwrap();
    for item in items {
        file.write(&Question::new(item)).unwrap();
    }
    file.finish().unwrap();
    bytes
}

/// The files of a package, in their order.
pub fn unpacked(package: Vec<u8>) -> Vec<(String, String)> {
    let mut zip = zip::ZipArchive::new(std::io::Cursor::new(package)).unwrap();
    let count = zip.len();
    let file = |place| {
        let mut text = String::new();
        let mut file = zip.by_index(place).unwrap();
        file.read_to_string(&mut text).unwrap();
        (file.name().unwrap().into_owned(), text)
    };
    (0..count).map(file).collect()
}

/// The file of that name.
pub fn file<'f>(files: &'f [(String, String)], name: &str) -> &'f str {
    &files.iter().find(|(listed, _)| listed == name).unwrap_or_else(|| panic!("no {name}")).1
}

/// The numbers of a part.
pub fn numbers_of(part: &ItemAnswers) -> Vec<&NumberItem> {
    match part {
        ItemAnswers::Number(number) => vec![number],
        ItemAnswers::Roots(all) | ItemAnswers::Vector { components: all, .. } => all.iter().collect(),
        ItemAnswers::Interval { low, high } => [low, high].into_iter().flatten().map(|bound| &**bound).collect(),
        _ => Vec::new(),
    }
}

/// The numbers of an item with the points of their parts, in the order of the fields.
pub fn numbers(item: &Item) -> Vec<(u32, &NumberItem)> {
    let parts = item.parts.iter();
    parts.flat_map(|part| numbers_of(&part.answers).into_iter().map(|number| (part.field.points, number))).collect()
}

/// The phrases among which the parts of an item ask for a choice, with the place of the right one; of a formula the letters and digits,
/// which stand there as mathematics.
pub fn choices(item: &Item) -> Vec<(Vec<Offered>, usize)> {
    let choice = |part: &momentous::exercise::ItemPart| match &part.answers {
        ItemAnswers::Choice { options, right, .. } => {
            Some((options.iter().cloned().map(Offered::Phrase).collect(), *right))
        }
        ItemAnswers::Formula { right, mistaken } if !mistaken.is_empty() => {
            let mut all: Vec<&str> = mistaken.iter().map(|(formula, _)| formula.text.as_str()).collect();
            all.push(&right.text);
            all.sort_unstable();
            let place = all.iter().position(|text| *text == right.text).unwrap();
            Some((vec![Offered::Formula; all.len()], place))
        }
        _ => None,
    };
    item.parts.iter().filter_map(choice).collect()
}

/// What can be chosen.
#[derive(Clone, Debug)]
pub enum Offered {
    Phrase(String),
    Formula,
}

impl Offered {
    /// Whether this is what is shown: a phrase as it is, a formula as mathematics.
    pub fn is_shown_as(&self, text: &str) -> bool {
        match self {
            Self::Phrase(phrase) => phrase == text,
            Self::Formula => !text.contains(['*', '_']),
        }
    }
}

/// How faithfully a target marks.
#[derive(Clone, Copy)]
pub struct Faith {
    /// How far credit may be off.
    pub credit: f64,
    /// Whether feedback goes along, and also that of a power of ten that earns nothing.
    pub feedback: bool,
    pub coarse: bool,
}

/// All of it.
pub const WHOLE: Faith = Faith { credit: 1e-9, feedback: true, coarse: true };

/// Marks every window of a number: the right value, both ends, what is outside; gives how many mistakes were met.
pub fn check(
    number: &NumberItem,
    points: u32,
    faith: Faith,
    about: &str,
    mark: impl Fn(f64) -> (f64, String),
) -> usize {
    let mut mistakes = 0;
    let printed: f64 = format!("{:.*e}", number.figures - 1, number.right).parse().unwrap();
    if !number.whole {
        assert_eq!(mark(printed).0, 1.0, "{about}: {printed} {number:?}");
    }
    for window in &number.windows {
        let worth = window.points.0.to_f64().value() / f64::from(points);
        let middle = window.low + (window.high - window.low) / 2.0;
        let (share, said) = mark(middle);
        assert!((share - worth).abs() <= faith.credit, "{about}: {middle} earns {share}, {window:?}");
        let is_coarse = worth == 0.0 && window.mistakes.is_empty() && window.verdict == Verdict::OrderOfMagnitude;
        if faith.feedback && (faith.coarse || !is_coarse) {
            assert!(
                window.feedback.iter().all(|said_part| said.contains(said_part.as_str())),
                "{about}: {said:?} {window:?}"
            );
        }
        mistakes += window.mistakes.len();
        if worth == 1.0 {
            assert_eq!([window.low, window.high].map(|end| mark(end).0), [1.0, 1.0], "{about}: {window:?}");
        }
        // Moodle keeps fifteen digits, so a narrow window is a little wider there.
        let beside = (1e-7 * (window.high - window.low)).max(1e-12 * window.low.abs().max(window.high.abs()));
        for outside in [window.low - beside, window.high + beside] {
            if !is_in_a_window(number, outside, beside / 2.0) {
                assert_eq!(mark(outside), (0.0, String::new()), "{about}: {outside} {number:?}");
            }
        }
    }
    mistakes
}

fn is_in_a_window(number: &NumberItem, value: f64, beside: f64) -> bool {
    let turns = number.turn.map_or(vec![0.0], |turn| vec![0.0, turn, -turn]);
    let is_within = |window: &Window| {
        turns.iter().any(|turn| (window.low - beside..=window.high + beside).contains(&(value + turn)))
    };
    number.windows.iter().any(is_within)
}
