//! Several attempts at one sheet: what is carried forward, locked, judged again and charged, and which attempt counts.

use std::sync::{Arc, OnceLock};

use momentous::bank::Bank;
use momentous::exercise::{Exercise, Marker, Try};
use momentous::fault::Source;
use momentous::grade::{DecimalMark, Entry, History, PartHistory, PartReport, Report};
use momentous::problem::{Problem, compile, load};
use momentous::quantity::Rational;
use proptest::prelude::*;
use proptest::sample::select;

/// Three attempts, each before costs a quarter, a hint of the author's a tenth and a further one a twentieth.
const RUBRIC: &str = "rubric: { attempts: 3, attempt_penalty: 1/4, hint_penalty: 10 %, further_hint_penalty: 5 % }\n";

fn problem(rubric: &str) -> Arc<Problem> {
    let bank = Bank::built_in();
    let source = bank.find("impact/two-carts").expect("the problem is in the bank");
    let source = Source::new("two-carts.yaml", &format!("{rubric}{}", source.text));
    Arc::new(compile(load(source).expect("it loads"), None).expect("it compiles"))
}

/// Seed 1: 2.5 kg at 5.5 m/s meets 2 kg at -3.5 m/s, e = 0.5. By hand: the centre of mass moves at 1.5 m/s and 9 m/s become 4.5 m/s, so
/// `v_A2` is 1.5 - 2 = -0.5 m/s, `v_B2` is 1.5 + 2.5 = 4.0 m/s, and 45 J (1 - 1/4) = 33.75 J are lost. With 0.5 m/s for `v_A2` momentum
/// leaves (6.75 - 1.25)/2 = 2.75 m/s for B, with 1 m/s 2.125 m/s.
fn exercise(problem: &Arc<Problem>) -> Exercise {
    Exercise::draw(problem, 0, 1).expect("the seed has numbers")
}

const PARTS: [&str; 3] = ["v_A2", "v_B2", "T_lost"];

/// Texts of the three parts.
fn sheet(texts: [&str; 3]) -> Try<'_> {
    Try { answers: PARTS.into_iter().zip(texts).collect(), ..Try::default() }
}

fn marked(rubric: &str, attempts: &[Try<'_>]) -> (Vec<Report>, History) {
    let exercise = exercise(&problem(rubric));
    let mut history = History::default();
    let reports = attempts.iter().map(|own| exercise.mark_next(&mut history, own, DecimalMark::Point)).collect();
    (reports, history)
}

/// The points of each part, and the verdicts.
fn found(report: &Report) -> String {
    let part = |part: &PartReport| format!("{} {}", part.points, part.verdict);
    report.parts.iter().map(part).collect::<Vec<_>>().join(", ")
}

#[test]
fn two_submissions_earn_no_more_than_one_sheet_that_is_consistent() {
    let attempts = [sheet(["1 m/s", "2.125 m/s", ""]), sheet(["-0.5 m/s", "", ""]), sheet(["", "4.0 m/s", "33.75 J"])];
    let (reports, history) = marked("", &attempts[..2]);
    assert_eq!(found(&reports[0]), "0 wrong, 2 follow_through, 0 unanswered");
    // The velocity of B followed from the wrong one of A, which is gone.
    assert_eq!(found(&reports[1]), "2 right, 0 wrong, 0 unanswered");
    assert_eq!(reports[1].parts[1].entry, Entry::Carried);
    assert_eq!((history.handed_in(), history.counting()), (2, Some(1)));
    let (reports, history) = marked("", &attempts);
    assert_eq!(found(&reports[2]), "2 right, 2 right, 1 right");
    assert_eq!(history.counting(), Some(3));
}

#[test]
fn each_part_is_charged_for_its_own_attempts_and_hints() {
    let mut second = sheet(["-0.5 m/s", "9 m/s", ""]);
    second.hints = 1;
    let mut third = sheet(["7 m/s", "4.0 m/s", "33.75 J"]);
    (third.hints, third.further_hints) = (1, vec![("v_B2", 2)]);
    let (reports, history) = marked(RUBRIC, &[sheet(["9 m/s", "", ""]), second, third]);
    // By hand: one attempt and one hint before v_A2 leave 13/20; the same and two further hints before v_B2 leave 11/20.
    assert_eq!(found(&reports[1]), "1.3 right, 0 wrong, 0 unanswered");
    assert_eq!(found(&reports[2]), "1.3 right, 1.1 right, 0.9 right");
    assert_eq!(reports[2].parts[0].entry, Entry::Locked);
    assert!(reports[2].parts[0].message.ends_with("This part was right before: the new answer is not marked."));
    assert_eq!(history.parts().iter().map(PartHistory::made).collect::<Vec<_>>(), [2, 2, 1]);
}

#[test]
fn what_cannot_be_read_leaves_the_answer_from_before() {
    let (reports, history) = marked(RUBRIC, &[sheet(["9 m/s", "4.0 m/s", ""]), sheet(["9..1 m/s", "", "3..1 J"])]);
    let part = &reports[1].parts[0];
    assert_eq!((part.entry, part.understood.as_deref()), (Entry::Unread, Some("9 metres per second")));
    assert!(
        part.fault.is_some() && part.message.contains("Your earlier answer stands. Not right."),
        "{}",
        part.message
    );
    assert_eq!(found(&reports[1]), "0 wrong, 2 right, 0 unreadable");
    assert_eq!(history.parts().iter().map(PartHistory::made).collect::<Vec<_>>(), [1, 1, 0]);
}

#[test]
fn a_part_without_attempts_left_is_closed_and_the_others_are_not() {
    let own = |text: &'static str| sheet(["0.5 m/s", text, ""]);
    let (reports, history) = marked(RUBRIC, &[own("7 m/s"), own("8 m/s"), own("9 m/s"), own("4.0 m/s")]);
    // What would have followed is said with the last attempt, and not before.
    assert!(reports[1].parts[1].own_values.is_none());
    assert!(reports[2].parts[1].own_values.as_ref().is_some_and(|said| said.contains("2.75 m/s")));
    let part = &reports[3].parts[1];
    assert_eq!((part.entry, part.understood.as_deref()), (Entry::NoneLeft, Some("9 metres per second")));
    let rules = problem(RUBRIC);
    let marker = Marker::new(&rules, 0, DecimalMark::Point).expect("there is a form");
    let open: Vec<bool> = history.parts().iter().map(|part| part.is_open(&marker.rubric().attempts)).collect();
    assert_eq!(open, [true, false, true]);
}

#[test]
fn being_late_costs_what_was_entered_then() {
    let mut late = sheet(["", "4.0 m/s", ""]);
    late.factor = Rational::from(9) / Rational::from(10);
    let (reports, _) = marked("", &[sheet(["-0.5 m/s", "9 m/s", ""]), late, sheet(["", "", "33.75 J"])]);
    assert_eq!(found(&reports[2]), "2 right, 1.8 right, 1 right");
    assert!(reports[1].parts[1].message.ends_with("It was handed in late, which costs 10 % of the points."));
}

#[test]
fn with_keep_last_the_last_sheet_counts_and_nothing_right_is_lost() {
    let rubric = "rubric: { keep: last }\n";
    let (reports, history) = marked(rubric, &[sheet(["-0.5 m/s", "4.0", ""]), sheet(["7 m/s", "8 m/s", ""])]);
    assert_eq!((found(&reports[1]).as_str(), history.counting()), ("2 right, 0 wrong, 0 unanswered", Some(2)));
}

#[test]
fn attempts_of_which_only_the_number_is_known_are_charged() {
    let problem = problem(RUBRIC);
    let mut marker = Marker::new(&problem, 0, DecimalMark::Point).expect("there is a form");
    let exercise = exercise(&problem);
    let found_after = |marker: &mut Marker, before| {
        let reports = marker.mark_attempts(exercise.worked(), &[sheet(["-0.5 m/s", "", ""])], before);
        (found(&reports[0]), reports[0].parts[0].counts)
    };
    assert_eq!(found_after(&mut marker, 2), ("1 right, 0 unanswered, 0 unanswered".to_owned(), true));
    assert_eq!(found_after(&mut marker, 3), ("0 unanswered, 0 unanswered, 0 unanswered".to_owned(), true));
}

/// What students type at the three parts: right, wrong, following from wrong, without a unit, unreadable, nothing.
const TEXTS: [&[&str]; 3] = [
    &["-0.5 m/s", "0.5 m/s", "9 m/s", "-0.5", "9..1 m/s", "", "  "],
    &["4.0 m/s", "2.75 m/s", "5.0 m/s", "8 m/s", "4.0", "4,0,0", ""],
    &["33.75 J", "67.5 J", "33.8", "?", ""],
];

fn any_try() -> impl Strategy<Value = Try<'static>> {
    let texts = (select(TEXTS[0]), select(TEXTS[1]), select(TEXTS[2]));
    (texts, 0..3_u32, 0..2_u32, 5..11_u32).prop_map(|((one, two, three), hints, further, tenths)| Try {
        hints,
        further_hints: vec![("v_B2", further)],
        factor: Rational::from(tenths) / Rational::from(10),
        ..sheet([one, two, three])
    })
}

fn of_the_class() -> &'static (Arc<Problem>, Exercise) {
    static OWN: OnceLock<(Arc<Problem>, Exercise)> = OnceLock::new();
    OWN.get_or_init(|| {
        let problem = problem(RUBRIC);
        let exercise = exercise(&problem);
        (problem, exercise)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn attempts_are_marked_from_the_stored_state_as_from_the_beginning(attempts in prop::collection::vec(any_try(), 1..8)) {
        let (problem, exercise) = of_the_class();
        let mut marker = Marker::new(problem, 0, DecimalMark::Point).expect("there is a form");
        let anew = marker.mark_attempts(exercise.worked(), &attempts, 0);
        let mut stored = serde_json::to_string(&History::default()).expect("it is written");
        let mut best: Option<(usize, Rational)> = None;
        for (place, own) in attempts.iter().enumerate() {
            let mut history: History = serde_json::from_str(&stored).expect("it is read");
            let before = history.clone();
            let mut report = exercise.mark_next(&mut history, own, DecimalMark::Point);
            stored = serde_json::to_string(&history).expect("it is written");
            // What is locked stays as it is; nobody makes more attempts than there are.
            for (then, now) in before.parts().iter().zip(history.parts()) {
                prop_assert!(!then.is_locked() || then == now);
                prop_assert!(now.made() <= 3);
            }
            // The sheet that counts has the most points of all so far.
            if best.as_ref().is_none_or(|(_, most)| report.total.0 > *most) {
                best = Some((place, report.total.0.clone()));
            }
            let counting = usize::try_from(history.counting().expect("one was handed in")).expect("it is small") - 1;
            prop_assert_eq!(&anew[counting].total.0, &best.as_ref().expect("one was handed in").1);
            // Handed in again, the same sheet changes nothing.
            let mut again = history.clone();
            let same = exercise.mark_next(&mut again, own, DecimalMark::Point);
            prop_assert_eq!(&same.total, &report.total);
            prop_assert_eq!(again.parts(), history.parts());
            prop_assert_eq!(again.counting(), history.counting());
            let counts = anew[place].parts[0].counts;
            report.parts.iter_mut().for_each(|part| part.counts = counts);
            prop_assert_eq!(&report, &anew[place]);
        }
        prop_assert_eq!(anew.iter().filter(|report| report.parts.iter().any(|part| part.counts)).count(), 1);
    }
}
