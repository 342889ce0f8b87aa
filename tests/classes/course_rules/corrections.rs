//! A corrected problem, and another policy, over what was handed in before.

use momentous::course::{Attempt, PolicyForm, Redaction, Remarked, Score, StoredReport, effects, redacted};
use momentous::exercise::WORK;

use super::class::{Desk, form, found, key, policy, problem, text};

const MOMENTUM: &str = "m_A v_A1 + m_B v_B1 = m_A v_A2 + m_B v_B2";
const DAY: &str = "2026-11-25T10:00";

fn desk() -> Desk {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    desk.hand_in(["-0.5 m/s", "9 m/s", ""], DAY).unwrap();
    desk.hand_in(["", "4.0 m/s", "33.75 J"], "2026-12-01T10:00").unwrap();
    desk
}

/// What marking makes of the score by a problem.
fn score(desk: &Desk, text: Option<&str>) -> Option<String> {
    let problem = text.map(problem);
    let all = effects(&[desk.worked()], &desk.policy, problem.as_ref());
    let Remarked::Same(reports) = &all[0].after else { return None };
    Score::of(reports.last().unwrap()).map(|score| format!("{}/{}", score.points, score.out_of))
}

#[test]
fn the_same_problem_marks_all_attempts_as_they_were_marked() {
    let desk = desk();
    let all = effects(&[desk.worked()], &desk.policy, Some(&problem(&text())));
    assert_eq!(all[0].after, Remarked::Same(desk.reports.clone()));
}

#[test]
fn a_corrected_problem_marks_what_it_still_draws_and_the_rest_is_chosen() {
    let desk = desk();
    // By hand: 2 + 2 (9/10)(4/5) + 4/5 = 106/25 of 5.
    assert_eq!(score(&desk, Some(&text())), Some("106/25/5".into()));
    let more = text().replace("v_A2, unit: m/s, points: 2", "v_A2, unit: m/s, points: 3");
    assert_eq!(score(&desk, Some(&more)), Some("131/25/6".into()));
    let other = text().replace("v_A2, unit: m/s, points: 2", "v_A2, unit: km/h, points: 2");
    for text in [Some(other.as_str()), None] {
        assert_eq!(score(&desk, text), None);
    }
}

#[test]
fn another_policy_marks_anew_and_a_late_extension_gives_back_what_it_cost() {
    let mut desk = desk();
    let free = policy(&PolicyForm { attempt_penalty: String::new(), ..form() });
    let Remarked::Same(reports) = desk.worked().remarked(&free, Some(&problem(&text()))) else { panic!() };
    assert_eq!(found(&reports[1]), "2 right, 8/5 right, 4/5 right");
    desk.window.due = desk.window.due.after(86_400_000);
    let Remarked::Same(reports) = desk.worked().remarked(&desk.policy, Some(&problem(&text()))) else { panic!() };
    assert_eq!(found(&reports[1]), "2 right, 9/5 right, 1 right");
    assert!(reports[1].late.is_none());
}

/// The only attempt that a redaction changes.
fn changed(desk: &Desk, order: &Redaction) -> Attempt {
    let [only] = redacted(&desk.attempts, order).unwrap().try_into().unwrap();
    only
}

#[test]
fn a_redacted_answer_that_counted_is_not_marked_again() {
    let mut desk = desk();
    desk.hand_in(["", "", "call 0171 23"], DAY).unwrap_err();
    let order = |number, part: &str| Redaction {
        sheet: desk.sheet.key,
        number,
        part: part.to_owned(),
        reason: "asked by the student".to_owned(),
        by: key(9),
        at: desk.policy.closes,
    };
    let before = StoredReport::of(&desk.attempts[0]).unwrap();
    let without = changed(&desk, &order(1, "v_A2"));
    assert_eq!(without.answers["v_A2"], "[redacted]");
    assert_eq!(StoredReport::of(&without).unwrap(), before);
    assert!(redacted(&desk.attempts, &order(9, "v_A2")).is_err());
    assert!(redacted(&desk.attempts, &order(1, "v_C2")).is_err());
    desk.attempts[0] = without;
    assert_eq!(desk.worked().remarked(&desk.policy, Some(&problem(&text()))), Remarked::Redacted);
}

#[test]
fn nothing_of_a_redacted_text_is_left_where_it_could_not_be_read() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    desk.hand_in(["-0.5 m/s", "ask 555-0199 please", ""], DAY).unwrap();
    let order = Redaction {
        sheet: desk.sheet.key,
        number: 1,
        part: "v_B2".into(),
        reason: "a telephone number".into(),
        by: key(9),
        at: desk.policy.closes,
    };
    let without = changed(&desk, &order);
    let all = serde_json::to_string(&without).unwrap();
    assert!(serde_json::to_string(&desk.attempts[0]).unwrap().contains("0199") && !all.contains("0199"), "{all}");
    // Such a text counted for nothing, so that the rest is marked again.
    desk.attempts[0] = without;
    let Remarked::Same(reports) = desk.worked().remarked(&desk.policy, Some(&problem(&text()))) else { panic!() };
    assert_eq!(reports[0].total, desk.reports[0].total);
}

#[test]
fn redacted_work_leaves_no_copy_in_other_attempts() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    let work = format!("{MOMENTUM}\ncall 555-0199");
    desk.hand_in_with_work(["", "9 m/s", ""], &work, DAY).unwrap();
    // It stands on beside other answers, and under more lines.
    desk.hand_in(["-0.5 m/s", "", ""], DAY).unwrap();
    desk.hand_in_with_work(["", "", ""], &format!("{work}\nv_A2 = -0.5 m/s"), DAY).unwrap();
    desk.hand_in_with_work(["", "", ""], "v_A2 = 0.5 m/s", DAY).unwrap();
    let order = Redaction {
        sheet: desk.sheet.key,
        number: 1,
        part: WORK.into(),
        reason: "a telephone number".into(),
        by: key(9),
        at: desk.policy.closes,
    };
    let changed = redacted(&desk.attempts, &order).unwrap();
    assert_eq!(changed.iter().map(|attempt| attempt.number).collect::<Vec<_>>(), [1, 2, 3]);
    let all = serde_json::to_string(&changed).unwrap();
    assert!(!all.contains("0199") && !all.contains("m_A v_A1"), "{all}");
    assert!(changed[2].answers[WORK].ends_with("\nv_A2 = -0.5 m/s"), "{all}");
    for (attempt, before) in changed.into_iter().zip(&desk.reports) {
        assert_eq!(StoredReport::of(&attempt).unwrap().total, before.total);
        let place = desk.attempts.iter().position(|other| other.number == attempt.number).unwrap();
        desk.attempts[place] = attempt;
    }
    assert_eq!(desk.worked().remarked(&desk.policy, Some(&problem(&text()))), Remarked::Redacted);
}
