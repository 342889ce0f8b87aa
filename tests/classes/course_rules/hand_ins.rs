//! Handing in: what is taken, what it is worth, and what a student may see of it.

use momentous::course::{PolicyForm, Refusal};
use momentous::exercise::Exercise;
use momentous::grade::Entry;
use proptest::prelude::*;
use proptest::sample::select;

use super::class::{Desk, at, form, found, policy, problem, text};

const DAY: &str = "2026-11-25T10:00";

#[test]
fn a_sheet_is_worth_its_verdicts_less_attempts_hints_and_days() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    let first = desk.hand_in(["-0.5 m/s", "9 m/s", ""], DAY).unwrap();
    assert_eq!(found(&first.stored), "2 right, 0 wrong, 0 unanswered");
    desk.show_hint(None, 1, "2026-11-25T11:00");
    desk.show_hint(Some("v_B2"), 1, "2026-11-25T11:00");
    // A hint that is shown later costs nothing here.
    desk.show_hint(None, 2, "2026-12-02T12:00");
    let second = desk.hand_in(["", "4.0 m/s", "33.75 J"], "2026-12-01T18:01").unwrap();
    // By hand: 1 - 1/10 - 1/20 - 1/50 = 83/100 and 1 - 1/20 = 19/20, each with 3/5 for two days.
    assert_eq!(found(&second.stored), "2 right, 249/250 right, 57/100 right");
    assert_eq!(second.stored.late.as_ref().map(|late| late.days), Some(2));
    assert_eq!(second.stored.history.counting(), Some(2));
    assert_eq!(second.stored.parts[0].entry, Entry::Locked);
    assert_eq!(second.stored.parts[0].since, Some(at(DAY)));
}

#[test]
fn what_is_not_taken_says_why() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    let mut refused = |texts, local| desk.hand_in(texts, local).err();
    assert_eq!(refused(["1 m/s", "", ""], "2026-11-23T07:59"), Some(Refusal::NotOpen));
    assert_eq!(refused(["1 m/s", "", ""], "2026-12-02T18:01"), Some(Refusal::Over));
    assert_eq!(refused(["1 m/s", "", ""], "2026-12-03T18:01"), Some(Refusal::Over));
    assert_eq!(refused(["", " ", ""], DAY), Some(Refusal::NothingNew));
    assert_eq!(refused(["-0.5 m/s", "9 m/s", ""], DAY), None);
    assert_eq!(refused(["-0.5 m/s", " 9 m/s", ""], DAY), Some(Refusal::NothingNew));
    assert_eq!(refused(["-0.50 m/s", "", ""], DAY), Some(Refusal::NoAttemptLeft));
    assert_eq!(refused(["", "8 m/s", ""], DAY), None);
    assert_eq!(refused(["", "7 m/s", ""], DAY), None);
    assert_eq!(refused(["", "4.0 m/s", ""], DAY), Some(Refusal::NoAttemptLeft));
    assert_eq!(refused(["", "4.0 m/s", "x"], DAY), None);
}

/// Momentum; then restitution, too.
const MOMENTUM: &str = "m_A v_A1 + m_B v_B1 = m_A v_A2 + m_B v_B2";
const BOTH: &str = "m_A v_A1 + m_B v_B1 = m_A v_A2 + m_B v_B2\nv_B2 - v_A2 = e (v_A1 - v_B1)";

#[test]
fn work_gives_points_where_an_answer_is_missing() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    // Three laws and three answers, of which one law is there: a sixth of two points, two points and one.
    let first = desk.hand_in_with_work(["", "9 m/s", ""], MOMENTUM, DAY).unwrap();
    assert_eq!(found(&first.stored), "1/3 unanswered, 1/3 wrong, 1/6 unanswered");
    // Other work alone is taken, and the same is nothing new.
    assert_eq!(desk.hand_in_with_work(["", "", ""], MOMENTUM, DAY).err(), Some(Refusal::NothingNew));
    let second = desk.hand_in_with_work(["", "", ""], BOTH, DAY).unwrap();
    assert!(second.stored.total > first.stored.total, "{}", second.stored.total);
    // It stands where none is typed; a right answer has its own points.
    let third = desk.hand_in(["-0.5 m/s", "", ""], DAY).unwrap();
    assert!(third.stored.parts[0].verdict.is_right() && third.stored.work == second.stored.work);
    // It has as many attempts as a part.
    desk.hand_in_with_work(["", "", ""], "m_A v_A1 = 0", DAY).unwrap();
    assert_eq!(desk.hand_in_with_work(["", "", ""], BOTH, DAY).err(), Some(Refusal::NoAttemptLeft));
}

#[test]
fn work_that_is_late_has_the_share_of_its_day() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    let late = desk.hand_in_with_work(["", "", ""], MOMENTUM, "2026-12-01T18:01").unwrap();
    // By hand: a sixth of the points of each part, with 3/5 for two days.
    assert_eq!(found(&late.stored), "1/5 unanswered, 1/5 unanswered, 1/10 unanswered");
}

#[test]
fn a_list_of_guesses_is_worth_its_last() {
    let points = |work: &str| {
        let mut desk = Desk::new(&text(), policy(&form()), 1);
        desk.hand_in_with_work(["", "", ""], work, DAY).unwrap().stored.total
    };
    let [right, wrong] = ["v_A2 = -0.5 m/s", "v_A2 = 0.7 m/s"];
    assert_eq!(points(&format!("{right}\n{wrong}")), points(wrong));
    assert_eq!(points(&format!("{wrong}\n{right}")), points(right));
    assert!(points(right) > points(wrong));
}

#[test]
fn further_hints_are_those_of_the_answer_that_stands() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    // By hand: with the sign of one momentum wrong, or another usual mistake, there is something to say.
    desk.hand_in(["", "", "67.5 J"], DAY).unwrap();
    let next = |desk: &Desk| {
        desk.reports.last().unwrap().part("T_lost").unwrap().next_hint(&desk.hints, &desk.window, at(DAY))
    };
    let first = next(&desk).expect("twice the energy lost is a usual mistake");
    assert_eq!(first.number, 1);
    desk.show_hint(Some("T_lost"), first.number, "2026-11-25T11:00");
    let part = desk.reports.last().unwrap().part("T_lost").unwrap();
    assert_eq!(part.hints_shown(&desk.hints).collect::<Vec<_>>(), [first.text.as_str()]);
    if let Some(second) = next(&desk) {
        assert!(second.number == 2 && second.text != first.text);
    }
    // Another answer has hints of its own; their numbers go on.
    desk.hand_in(["", "", "16.875 J"], "2026-11-25T12:00").unwrap();
    let part = desk.reports.last().unwrap().part("T_lost").unwrap();
    assert_eq!(part.hints_shown(&desk.hints).count(), 0);
    assert!(next(&desk).is_none_or(|hint| hint.number == 2));
    let hidden = Desk::new(&text(), policy(&PolicyForm { verdicts: "at_close".into(), ..form() }), 1).window;
    assert_eq!(part.next_hint(&desk.hints, &hidden, at(DAY)), None);
}

/// The same sheet with other right answers: each cart has the mass that the sheet says of the other.
fn other() -> String {
    text()
        .replace("name: cart A, mass: m_A", "name: cart A, mass: MASS")
        .replace("mass: m_B", "mass: m_A")
        .replace("MASS", "m_B")
}

/// Verdicts are shown at close.
fn hidden() -> PolicyForm {
    PolicyForm { verdicts: "at_close".into(), ..form() }
}

#[test]
fn two_variants_have_the_same_sheet_and_other_right_answers() {
    let [one, other] = [text(), other()].map(|text| Exercise::draw(&problem(&text), 0, 1).unwrap());
    assert_eq!(one.student_sheet(), other.student_sheet());
    let right = |exercise: &Exercise| {
        exercise.worked().form.parts.iter().map(|part| exercise.printed(part)).collect::<Vec<_>>()
    };
    let [one, other] = [right(&one), right(&other)];
    assert!(one[..2].iter().zip(&other).all(|(one, other)| one != other), "{one:?} {other:?}");
}

#[test]
fn what_is_released_at_close_is_shown_to_each_after_the_own_close() {
    let mut desk = Desk::new(&text(), policy(&hidden()), 1);
    let accepted = desk.hand_in(["-0.5 m/s", "9..1 m/s", "x"], DAY).unwrap();
    assert!(accepted.shown.total.is_none() && accepted.shown.parts.iter().all(|part| part.found.is_none()));
    assert_eq!(accepted.shown.parts[0].read.as_deref(), Some("-0.5 metres per second"));
    assert!(accepted.shown.parts[1].unread.is_some());
    // Nothing is locked: what is typed next is marked.
    let next = desk.hand_in(["9 m/s", "", ""], DAY).unwrap();
    assert_eq!(
        (next.stored.parts[0].entry, found(&next.stored).as_str()),
        (Entry::Typed, "0 wrong, 0 unanswered, 0 unanswered")
    );
    assert_eq!(next.stored.history.counting(), Some(1));
    let shown = desk.reports[0].shown(&desk.window, at("2026-12-03T18:01"));
    assert!(shown.total.is_none(), "answers of the last moment may still be on their way");
    let shown = desk.reports[0].shown(&desk.window, at("2026-12-03T18:02"));
    assert_eq!(shown.total.map(|total| total.to_string()).as_deref(), Some("2"));
    assert!(shown.parts[0].found.as_ref().is_some_and(|found| found.right));
}

/// What is right for the one sheet, for the other, for neither, unreadable, or nothing.
const TEXTS: [&[&str]; 3] = [
    &["-0.5 m/s", "0.5", "-1.5 m/s", "-1.50 m/s", "9 m/s", "9..1 m/s", "", "at rest"],
    &["4.0 m/s", "3 m/s", "2.75 m/s", "8 m/s", "4,0,0", "", "4.0"],
    &["33.75 J", "33.8", "67.5 J", "?", "", "33.75 N"],
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn before_release_nothing_depends_on_what_is_right(
        attempts in prop::collection::vec((select(TEXTS[0]), select(TEXTS[1]), select(TEXTS[2])), 1..7),
    ) {
        let policy = policy(&hidden());
        let mut desks = [text(), other()].map(|text| Desk::new(&text, policy.clone(), 1));
        for (one, two, three) in attempts {
            let shown = desks.each_mut().map(|desk| {
                let taken = desk.hand_in([one, two, three], DAY);
                let all = desk.reports.iter().map(|report| report.shown(&desk.window, at(DAY))).collect::<Vec<_>>();
                (taken.map(|hand_in| serde_json::to_string(&hand_in.shown).unwrap()), serde_json::to_string(&all).unwrap())
            });
            prop_assert_eq!(&shown[0], &shown[1]);
        }
        // The test can fail: what is kept differs as soon as something right was typed.
        let right = desks[0].reports.iter().any(|report| report.parts[0].verdict.is_right());
        prop_assert!(!right || desks[0].reports != desks[1].reports);
    }

    #[test]
    fn an_attempt_never_takes_points_away(
        attempts in prop::collection::vec((select(TEXTS[0]), select(TEXTS[1]), select(TEXTS[2]), 0..10_u32), 1..6),
    ) {
        let mut desk = Desk::new(&text(), policy(&form()), 1);
        let (mut most, mut day) = (None, 24);
        for (one, two, three, later) in attempts {
            day += later;
            let local = if day > 30 { format!("2026-12-0{}T10:00", (day - 30).min(2)) } else { format!("2026-11-{day}T10:00") };
            if desk.hand_in([one, two, three], &local).is_ok() {
                let points = desk.reports.last().unwrap().history.points().cloned();
                prop_assert!(points >= most);
                most = points;
            }
        }
    }
}

#[test]
fn a_stored_report_is_read_as_it_was_written_or_not_at_all() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    desk.hand_in(["-0.5 m/s", "", ""], DAY).unwrap();
    let mut attempt = desk.attempts[0].clone();
    for other in ["{}", "null", "{\"parts\":[],\"total\":\"1/0\",\"out_of\":1,\"late\":null,\"history\":{}}"] {
        attempt.report = serde_json::value::RawValue::from_string(other.to_owned()).unwrap();
        assert!(momentous::course::StoredReport::of(&attempt).is_err(), "{other}");
    }
}
