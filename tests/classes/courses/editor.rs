//! Assignments as their instructors write them, and their problems withheld elsewhere meanwhile.

use axum::http::Method;
use momentous::store::AssignmentWithItems;

use super::university::{Answer, Browser, DAY, RELEASED, University};

/// An assignment that is open in the first days of the test.
const RIGHT: [(&str, &str); 12] = [
    ("title", "Sheet & <1>"),
    ("opens", "2025-12-01T08:00"),
    ("due", "2025-12-03T18:00"),
    ("closes", "2025-12-04T18:00"),
    ("attempts", "3"),
    ("attempt_penalty", "10 %"),
    ("item.0.problem", "impact/two-carts"),
    ("item.0.form", "find-e"),
    ("item.0.points", "5"),
    ("item.0.order", "2"),
    ("item.1.problem", "impulse/parcel-push"),
    ("item.1.points", "4"),
];

/// The fields with others in their place, and a button.
fn typed<'a>(other: &[(&'a str, &'a str)], button: (&'a str, &'a str)) -> Vec<(&'a str, &'a str)> {
    let mut fields: Vec<(&str, &str)> =
        RIGHT.into_iter().filter(|(name, _)| other.iter().all(|(chosen, _)| chosen != name)).collect();
    fields.extend_from_slice(other);
    fields.push(button);
    fields
}

const SAVE: (&str, &str) = ("do", "save");

/// A call of the engine.
fn call(browser: &mut Browser<'_>, name: &str, request: &str) -> Answer {
    browser.ask(Method::POST, &format!("/api/{name}"), Some(request.to_owned()), None)
}

/// The second problem.
const SECOND: &str = "impulse/parcel-push";

fn only(university: &University) -> AssignmentWithItems {
    university.wait(async |store| {
        let all = store.assignments(university.course.key).await.unwrap();
        assert_eq!(all.len(), 1);
        store.assignment(all[0].key).await.unwrap().unwrap()
    })
}

fn make(university: &University, ida: &mut Browser<'_>) -> AssignmentWithItems {
    let made: Answer = ida.post(&university.address("/assignments/new"), &typed(&[("item.1.order", "1")], SAVE));
    assert!(made.to().ends_with("/edit?saved=yes"), "{}", made.text);
    only(university)
}

#[test]
fn an_assignment_is_written_and_its_problems_stay_once_it_has_opened() {
    let university = University::new();
    university.set_clock(-DAY);
    let mut ida = university.browser_of("ida");
    let whole = make(&university, &mut ida);
    let asked: Vec<&str> = whole.items.iter().map(|item| item.problem.as_str()).collect();
    assert_eq!(asked, [SECOND, "impact/two-carts"], "in the order of the fields");
    assert_eq!((whole.items[1].form.as_deref(), whole.items[1].points), (Some("find-e"), 5));
    assert!(whole.assignment.pinned.is_none() && whole.items.iter().all(|item| item.digest.is_none()));

    let edit = university.address(&format!("/assignments/{}/edit", whole.assignment.key));
    let page = ida.get(&edit).text(200);
    assert!(page.contains("value=\"Sheet &amp; &lt;1&gt;\"") && page.contains("value=\"2025-12-03T18:00\""), "{page}");
    assert!(page.contains("The collision simulator shows this scene"), "{page}");

    university.set_clock(0);
    let page = ida.get(&edit).text(200);
    assert!(page.contains("Pinned since"), "{page}");
    let pinned = only(&university);
    assert!(pinned.assignment.pinned.is_some() && pinned.items.iter().all(|item| item.digest.is_some()));
    let digest = pinned.items[0].digest.clone().unwrap();
    let file =
        university.wait(async |store| store.problem_file(university.course.key, &digest).await.unwrap().unwrap());
    assert_eq!((file.problem.as_str(), file.course), (SECOND, None));

    let keys: Vec<String> = pinned.items.iter().map(|item| item.key.to_string()).collect();
    let revision = pinned.revision.to_string();
    let kept = [
        ("revision", revision.as_str()),
        ("item.0.key", keys[0].as_str()),
        ("item.0.problem", "impact/squash-wall"),
        ("item.0.form", "forward"),
        ("item.0.order", "1"),
        ("item.1.key", keys[1].as_str()),
        ("item.1.order", "2"),
    ];
    ida.post(&edit, &typed(&kept, SAVE)).to();
    let after = only(&university);
    assert_eq!(after.items[0].problem, pinned.items[0].problem, "nothing is exchanged silently");
    assert_eq!(after.items[1].digest, pinned.items[1].digest);
    let revision = after.revision.to_string();
    let fewer: Vec<(&str, &str)> = typed(&kept, SAVE)
        .into_iter()
        .filter(|(name, _)| !name.starts_with("item.1"))
        .map(|(name, value)| if name == "revision" { (name, revision.as_str()) } else { (name, value) })
        .collect();
    let page = ida.post(&edit, &fewer).text(422);
    assert!(page.contains("A problem that students have seen cannot be taken out or exchanged."), "{page}");
    assert_eq!(only(&university).items.len(), 2);
}

#[test]
fn faults_stand_beside_what_was_typed() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let new = university.address("/assignments/new");
    for (field, value, said) in [
        ("title", "", "An assignment has a title."),
        ("due", "2025-11-30T18:00", "This is before the assignment opens."),
        ("closes", "2026-03-29T02:30", "This time does not exist: the clocks go forward from 02:00 to 03:00."),
        ("attempt_penalty", "<b>", "A share is written"),
        ("attempts", "none", "Write a number from 1 to 100"),
        ("item.0.problem", "impact/no-such<b>", "There is no problem <code>impact/no-such&lt;b&gt;</code>."),
        ("item.0.form", "sideways", "It has no form <code>sideways</code>."),
        ("item.0.weights", "e 1", "Weights are written <code>v_A2: 2, T_lost: 1</code>"),
        ("item.0.weights", "v_B9: 1", "It does not ask for <code>v_B9</code>."),
        ("item.0.points", "0", "Its points are a whole number from 1 to 1000."),
        ("item.0.order", "first", "Its place is a whole number."),
    ] {
        let page = ida.post(&new, &typed(&[(field, value)], SAVE)).text(422);
        assert!(page.contains(said), "{field}: {page}");
        assert!(value.is_empty() || page.contains(&value.replace('<', "&lt;").replace('>', "&gt;")), "{field} stays");
        assert!(page.contains("value=\"impulse/parcel-push\""), "the other rows stay");
    }
    let all = university.wait(async |store| store.assignments(university.course.key).await.unwrap());
    assert!(all.is_empty(), "nothing is kept");
}

#[test]
fn problems_are_found_added_and_taken_out_without_losing_what_was_typed() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let new = university.address("/assignments/new");
    let found = ida.post(&new, &typed(&[("search", "carts"), ("title", "x<y")], ("do", "search"))).text(200);
    assert!(found.contains("name=\"add\" value=\"impact/two-carts\"") && found.contains("value=\"x&lt;y\""), "{found}");
    assert!(!found.contains("name=\"add\" value=\"impulse/parcel-push\""));
    let added = ida.post(&new, &typed(&[("add", "impact/squash-wall")], ("do", "add"))).text(200);
    assert!(added.contains("name=\"item.2.problem\" value=\"impact/squash-wall\""), "{added}");
    let fewer = ida.post(&new, &typed(&[], ("remove", "0"))).text(200);
    assert!(!fewer.contains("name=\"item.0.problem\" value=\"impact/two-carts\""), "{fewer}");
    let look = ida.get(&university.address("/look?problem=impact/two-carts&form=find-e")).text(200);
    assert_eq!(look.matches("<h2>Seed ").count(), 3);
    assert_eq!(ida.get(&university.address("/look?problem=no/such")).status, 404);
}

#[test]
fn two_who_edit_at_once_are_told() {
    let university = University::new();
    university.set_clock(-DAY);
    let mut ida = university.browser_of("ida");
    let whole = make(&university, &mut ida);
    let edit = university.address(&format!("/assignments/{}/edit", whole.assignment.key));
    let page = ida.post(&edit, &typed(&[("revision", "0"), ("title", "Mine")], SAVE)).text(422);
    assert!(page.contains("This assignment has changed since you opened it.") && page.contains("Mine"), "{page}");
    assert_eq!(only(&university).assignment.title, "Sheet & <1>");
}

#[test]
fn one_student_gets_more_time() {
    let university = University::new();
    let whole = university.assignment(&[("impact/two-carts", "forward", 5)], |_| {});
    let mut ida = university.browser_of("ida");
    let more = university.address(&format!("/assignments/{}/extensions", whole.assignment.key));
    let ada = University::member("ada").to_string();
    let fields =
        [("member", ada.as_str()), ("due", "2025-12-08T18:00"), ("closes", "2025-12-09T18:00"), ("reason", "<ill>")];
    for (field, value, said) in [
        ("member", "0", "Choose a student or a section of the list."),
        ("due", "2025-11-01T18:00", "This is before the assignment opens."),
        ("reason", " ", "Say why: it is kept with the marks."),
    ] {
        let wrong: Vec<(&str, &str)> =
            fields.map(|(name, usual)| (name, if name == field { value } else { usual })).into();
        let page = ida.post(&more, &wrong).text(422);
        assert!(page.contains(said) && page.contains("2025-12-09T18:00"), "{page}");
    }
    let to = ida.post(&more, &fields).to().to_owned();
    assert!(ida.get(&to).text(200).contains("&lt;ill&gt;"));
    let other = format!("/courses/{}/assignments/{}/extensions", university.other.key, whole.assignment.key);
    assert_eq!(ida.get(&other).status, 404);
    // The dates of the assignment stand in the fields, and a section is chosen as a whole.
    let empty = ida.get(&more).text(200);
    let closes = whole.assignment.policy.form("Europe/Berlin").closes;
    assert!(empty.contains(&format!("name=\"closes\" value=\"{closes}\"")), "{empty}");
    ida.post(&more, &[("member", "section A"), fields[1], fields[2], ("reason", "snow")]).to();
    let extensions = university.wait(async |store| store.extensions(whole.assignment.key).await).unwrap();
    let students = [University::member("ada"), University::member("bob")];
    assert!(students.iter().all(|student| extensions.iter().any(|had| had.member == *student && had.reason == "snow")));
}

#[test]
fn problems_of_an_open_assignment_are_shown_to_its_staff_only() {
    let university = University::new();
    let whole = university.assignment(&[("impact/two-carts", "find-e", 5)], |_| {});
    let calls = [
        ("sheet", ""),
        ("mark", r#", "answers": {}"#),
        ("solve", ""),
        ("hint", r#", "number": 1"#),
        ("givens", ""),
        ("simulate", ""),
        ("read", r#", "part": "v_A2", "text": "1.00 m/s""#),
    ];
    let pages = ["practice", "solution", "solve", "play"].map(|page| format!("/{page}/impact/two-carts?form=forward"));
    for (login, status) in
        [(None, 403), (Some("ada"), 403), (Some("cleo"), 403), (Some("ann"), 200), (Some("ida"), 200)]
    {
        let mut browser = login.map_or_else(|| university.browser(), |login| university.browser_of(login));
        for page in &pages {
            assert_eq!(browser.get(page).status, status, "{page} as {login:?}");
            assert_eq!(browser.post(page, &[("seed", "1")]).status, status, "{page} as {login:?}");
        }
        for (name, more) in calls {
            // What follows the object is not read, and lets nobody past.
            let request = format!(r#"{{"problem": "impact/two-carts", "form": "forward", "seed": 1{more}}} x"#);
            let answer = call(&mut browser, name, &request);
            assert!(answer.status != 400, "{name}: {}", answer.text);
            assert_eq!(answer.status == 403, status == 403, "{name} as {login:?}: {}", answer.text);
        }
        browser.get("/practice/impulse/parcel-push").text(200);
        browser.get("/simulators/collision").text(200);
        assert_eq!(call(&mut browser, "collision", "{}").status, 200);
        let gallery = browser.get("/?search=two+carts").text(200);
        assert_eq!(gallery.contains("in an assignment now"), status == 403, "as {login:?}");
        assert_eq!(browser.get("/figure/impact/two-carts").status, status, "as {login:?}");
    }
    let mut nobody = university.browser();
    assert!(nobody.get(&pages[0]).text(403).contains("part of an assignment that is open now"));
    university.set_clock(3 * DAY + RELEASED - 1);
    assert_eq!(nobody.get(&pages[0]).status, 403, "answers of the last millisecond may still be on their way");
    university.set_clock(3 * DAY + RELEASED);
    nobody.get(&pages[0]).text(200);
    let mut ida = university.browser_of("ida");
    let ada = University::member("ada").to_string();
    let more =
        [("member", ada.as_str()), ("due", "2025-12-08T18:00"), ("closes", "2025-12-09T18:00"), ("reason", "ill")];
    let extensions = university.address(&format!("/assignments/{}/extensions", whole.assignment.key));
    ida.post(&extensions, &more).to();
    assert_eq!(nobody.get(&pages[0]).status, 403, "somebody still works on it");
}
