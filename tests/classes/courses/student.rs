//! What students do: see their sheets, hand in, ask for hints, see what was right when it may be seen.

use std::collections::BTreeMap;
use std::sync::Arc;

use momentous::bank::Bank;
use momentous::course::{SolutionRelease, StoredReport};
use momentous::exercise::Exercise;
use momentous::problem::{compile, load};
use momentous::store::AssignmentWithItems;

use super::university::{Browser, DAY, RELEASED, University};

const CARTS: &str = "impact/two-carts";

/// The address of the first item.
fn first(university: &University, whole: &AssignmentWithItems) -> String {
    university.address(&format!("/items/{}", whole.items[0].key))
}

/// The variant that a student has seen, and its right answers as they are printed.
pub fn right(university: &University, login: &str) -> (Exercise, BTreeMap<String, String>) {
    let sheets = university.wait(async |store| store.sheets_of(University::member(login)).await).unwrap();
    let issued = &sheets.first().expect("the sheet was seen").issued;
    let source = Bank::built_in().find(&issued.problem).unwrap().clone();
    let problem = compile(load(source).unwrap(), Some(university.course.secret.as_bytes())).unwrap();
    let exercise = issued.draw(&Arc::new(problem)).unwrap();
    let answers = exercise.worked().form.parts.iter().map(|part| (part.id.clone(), exercise.printed(part)));
    let answers = answers.collect();
    (exercise, answers)
}

/// The fields of a form: answers, and a request of its own.
pub fn form<'a>(request: &'a str, answers: &'a [(&'a str, &'a str)]) -> Vec<(&'a str, &'a str)> {
    let mut fields = vec![("request", request)];
    fields.extend(answers);
    fields
}

/// What a page says that one has for the item.
pub fn total(page: &str) -> Option<&str> {
    let from = page.split("<p class=\"total\" role=\"status\"><strong>").nth(1)?;
    from.split("</strong>").next()
}

fn stored(university: &University) -> StoredReport {
    let attempts = university.wait(async |store| {
        let sheets = store.sheets_of(University::member("ada")).await.unwrap();
        store.attempts(sheets[0].key).await.unwrap()
    });
    StoredReport::of(attempts.last().unwrap()).unwrap()
}

#[test]
fn everybody_has_a_sheet_of_their_own_and_keeps_it() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let statement = |browser: &mut Browser<'_>| {
        let page = browser.get(&address).text(200);
        page.split("<div class=\"statement\">").nth(1).unwrap().split("</div>").next().unwrap().to_owned()
    };
    let (mut ada, mut bob) = (university.browser_of("ada"), university.browser_of("bob"));
    let adas = statement(&mut ada);
    assert_ne!(adas, statement(&mut bob));
    assert_eq!(adas, statement(&mut university.browser_of("ada")), "in another browser");
    let list = ada.get(&university.address("")).text(200);
    assert!(list.contains("Sheet &lt;b&gt;1&lt;/b&gt;") && list.contains("Tue, 2 Dec 2025, 09:00"), "{list}");
}

#[test]
fn nothing_is_seen_before_it_opens() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |policy| policy.opens = policy.due);
    let mut ada = university.browser_of("ada");
    let address = university.address(&format!("/assignments/{}", whole.assignment.key));
    for address_of_nobody in [first(&university, &whole), address.clone()] {
        assert_eq!(ada.get(&address_of_nobody).status, 404);
    }
    assert!(!ada.get(&university.address("")).text(200).contains("Sheet"));
    university.set_clock(DAY);
    assert!(ada.get(&address).text(200).contains("Two carts"));
}

#[test]
fn right_answers_earn_all_points_of_the_item() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    ada.get(&address).text(200);
    let (_, answers) = right(&university, "ada");
    let named: Vec<(String, &str)> = answers.iter().map(|(id, text)| (format!("answer.{id}"), text.as_str())).collect();
    let fields: Vec<(&str, &str)> = named.iter().map(|(id, text)| (id.as_str(), *text)).collect();
    assert_eq!(ada.post(&address, &form("r1", &fields)).to(), format!("{address}#marks"));
    let page = ada.get(&address).text(200);
    assert_eq!(total(&page), Some("10 of 10"));
    assert!(page.contains("Mon, 1 Dec 2025, 09:00:00, counts") && page.matches(" readonly").count() > 0, "{page}");
    let list = ada.get(&university.address(&format!("/assignments/{}", whole.assignment.key))).text(200);
    assert!(list.contains("10 of 10"));
}

#[test]
fn a_request_that_is_repeated_is_one_attempt() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    for _ in 0..3 {
        ada.post(&address, &form("same", &[("answer.v_A2", "99.0 m/s")])).to();
    }
    assert_eq!(stored(&university).history.handed_in(), 1);
    let nothing_new = ada.post(&address, &form("other", &[("answer.v_A2", "99.0 m/s")])).text(422);
    assert!(nothing_new.contains("nothing new") && nothing_new.contains("value=\"99.0 m/s\""));
}

#[test]
fn attempts_cost_and_end_part_by_part() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    for (request, text) in [("1", "97.0 m/s"), ("2", "98.0 m/s"), ("3", "99.0 m/s")] {
        ada.post(&address, &form(request, &[("answer.v_A2", text)])).to();
    }
    let page = ada.post(&address, &form("4", &[("answer.v_A2", "100 m/s")])).text(422);
    assert!(page.contains("no attempt is left") && page.contains("value=\"100 m/s\""), "what was typed stays");
    let (_, answers) = right(&university, "ada");
    ada.post(&address, &form("5", &[("answer.v_B2", &answers["v_B2"])])).to();
    assert!(stored(&university).part("v_B2").unwrap().verdict.is_right(), "another part has attempts of its own");
}

#[test]
fn late_answers_lose_a_share_and_closed_assignments_take_none() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    ada.get(&address).text(200);
    let (_, answers) = right(&university, "ada");
    ada.post(&address, &form("1", &[("answer.v_A2", &answers["v_A2"])])).to();
    let before = stored(&university).total;
    university.set_clock(DAY + 1);
    assert!(ada.get(&address).text(200).contains("It is late: what is new now earns 80 %"));
    ada.post(&address, &form("2", &[("answer.v_B2", &answers["v_B2"])])).to();
    let report = stored(&university);
    assert!(report.total > before, "what was in time keeps its points");
    let [on_time, late] = ["v_A2", "v_B2"].map(|id| report.part(id).unwrap());
    assert_eq!(on_time.points, on_time.out_of.into());
    assert_eq!(late.points.clone() * momentous::quantity::Rational::from(5), (late.out_of * 4).into());
    university.set_clock(3 * DAY + 1);
    let page = ada.post(&address, &form("3", &[("answer.v_B2", "1.00 m/s")])).text(422);
    assert!(page.contains("the time for answers is over"));
    university.set_clock(3 * DAY + RELEASED - 1);
    ada.get(&format!("{address}/solution")).text(403);
    university.set_clock(3 * DAY + RELEASED);
    ada.get(&format!("{address}/solution")).text(200);
}

#[test]
fn solutions_are_shown_when_they_may_be() {
    for (change, after) in [(SolutionRelease::AtClose, 200), (SolutionRelease::Never, 403)] {
        let university = University::new();
        let whole = university.assignment(&[(CARTS, "forward", 10)], |policy| policy.solutions = change);
        let address = format!("{}/solution", first(&university, &whole));
        let mut ada = university.browser_of("ada");
        ada.get(&address).text(403);
        university.set_clock(3 * DAY + RELEASED);
        ada.get(&address).text(after);
    }
}

#[test]
fn a_hint_costs_once_and_keeps_what_was_typed() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    ada.get(&address).text(200);
    ada.post(&format!("{address}/hint"), &form("x", &[("answer.v_A2", "half of it")])).to();
    let page = ada.get(&address).text(200);
    assert!(page.contains("aria-label=\"Hint 1\"") && page.contains("value=\"half of it\""), "{page}");
    let (_, answers) = right(&university, "ada");
    ada.post(&address, &form("1", &[("answer.v_A2", &answers["v_A2"])])).to();
    let report = stored(&university);
    let part = report.part("v_A2").unwrap();
    assert_eq!(part.points.clone() * momentous::quantity::Rational::from(10), (part.out_of * 9).into());
    university.set_clock(3 * DAY + 1);
    assert_eq!(ada.post(&format!("{address}/hint"), &[]).status, 403);
}

#[test]
fn a_draft_is_there_again_and_is_never_handed_in() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    let saved = ada.post(&format!("{address}/draft"), &[("answer.v_A2", "<3 m/s"), ("do", "script")]).text(200);
    assert_eq!(saved, "{\"saved\":\"Mon, 1 Dec 2025, 09:00\"}");
    let page = ada.get(&address).text(200);
    assert!(page.contains("value=\"&lt;3 m") && page.contains("Saved, not submitted"), "{page}");
    university.set_clock(3 * DAY + RELEASED);
    let sheets = university.wait(async |store| store.sheets_of(University::member("ada")).await).unwrap();
    assert!(university.wait(async |store| store.attempts(sheets[0].key).await).unwrap().is_empty());
}

#[test]
fn reading_says_what_was_read_and_nothing_of_what_is_right() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = format!("{}/read", first(&university, &whole));
    let mut ada = university.browser_of("ada");
    let read = ada.post(&address, &[("part", "v_A2"), ("text", "0.500 m/s to the left")]).text(200);
    assert!(read.contains("0.500 metres per second to the left"), "{read}");
    assert!(ada.post(&address, &[("part", "v_A2"), ("text", "3..2")]).text(200).contains("unreadable"));
    assert_eq!(ada.post(&address, &[("part", "nothing"), ("text", "1")]).status, 404);
}

/// A page costs a few statements, however much there is in the database.
#[test]
fn pages_ask_the_database_a_counted_number_of_times() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    ada.get(&address).text(200);
    let mut counted = |work: &mut dyn FnMut(&mut Browser<'_>)| {
        let before = university.store.reads();
        work(&mut ada);
        let after = university.store.reads();
        (after.0 - before.0, after.1 - before.1)
    };
    assert_eq!(counted(&mut |ada| drop(ada.get(&address).text(200))), SHEET, "a sheet: statements, rows");
    let hand_in =
        counted(&mut |ada| drop(ada.post(&address, &form("1", &[("answer.v_A2", "9.00 m/s")])).to().to_owned()));
    assert_eq!(hand_in, HAND_IN, "handing in: statements, rows");
    assert_eq!(
        counted(&mut |ada| drop(ada.get(&university.address("")).text(200))),
        COURSE,
        "a course: statements, rows"
    );
}

/// Session, membership, item, assignment with its items, extension, sheet, attempts, hints, draft; for the points corrections, sheets, and
/// what was set by hand.
const SHEET: (u64, u64) = (13, 7);
/// The same without the draft and the points.
const HAND_IN: (u64, u64) = (9, 6);
/// Session, membership, assignments, extension.
const COURSE: (u64, u64) = (4, 3);

#[test]
fn work_is_judged_with_the_answers_and_its_numbers_are_not_told_before() {
    let university = University::new();
    let whole = university.assignment(&[(CARTS, "forward", 10)], |_| {});
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    assert!(ada.get(&address).text(200).contains("name=\"answer.work\""));
    // What is typed and not handed in is kept.
    ada.post(&format!("{address}/draft"), &form("0", &[("answer.work", "e = 1")])).to();
    assert!(ada.get(&address).text(200).contains("e = 1</textarea>"));
    let (_, answers) = right(&university, "ada");
    let value = answers["v_A2"].clone();
    let work = format!("m_A v_A1 + m_B v_B1 = m_A v_A2 + m_B v_B2\nv_A2 = {value}\nv_A2 = 77 m/s");
    ada.post(&address, &form("1", &[("answer.work", &work)])).to();
    let page = ada.get(&address).text(200);
    assert!(page.contains("Follows, by conservation of linear momentum."));
    assert_eq!(page.matches("Its numbers are judged with the answers.").count(), 2);
    assert!(!page.contains("it is right"), "a number was told");
}
