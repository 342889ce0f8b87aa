//! What those who teach see of answers, and decide about them.

use momentous::course::{Key, Release};

use super::handed::Handed;
use super::university::{DAY, University};

#[test]
fn a_gradebook_says_what_each_has_and_what_is_missing() {
    let handed = Handed::new();
    let mut ann = handed.university.browser_of("ann");
    let page = ann.get(&handed.assignment("/gradebook")).text(200);
    assert!(page.contains("1 of 2 students have submitted something"), "{page}");
    assert!(page.contains("ada &lt;script&gt;") && !page.contains("ada <script>"));
    assert!(page.contains(">4</a>") && page.contains("<span class=\"aside\">missing</span>"), "{page}");
    let table = ann.get(&handed.assignment("/gradebook.csv"));
    assert!(table.header("content-disposition").unwrap().starts_with("attachment"));
    let lines: Vec<String> = table.text(200).lines().map(str::to_owned).collect();
    let expected =
        ["login,name,section,1 impact/two-carts,total,out_of", "ada,ada <script>,A,4,4,10", "bob,bob <script>,A,,0,10"];
    assert_eq!(lines, expected);
}

/// 4 of 10 points: 40 % once the assignment has closed; with a second one, of which nothing was handed in, 4 of 20, and 40 % again where
/// the weakest is left out.
#[test]
fn the_gradebook_of_a_course_weighs_what_has_closed() {
    let handed = Handed::new();
    let (mut ann, mut ida) = (handed.university.browser_of("ann"), handed.university.browser_of("ida"));
    let page = handed.university.address("/gradebook");
    let grades = |browser: &mut super::university::Browser<'_>| -> Vec<String> {
        let table = browser.get(&handed.university.address("/gradebook.csv")).text(200);
        table.lines().skip(1).map(|line| line.rsplit(',').next().unwrap().to_owned()).collect()
    };
    handed.university.set_clock(DAY / 2);
    assert_eq!(grades(&mut ann), ["", ""], "nothing has closed");
    assert!(!handed.university.browser_of("ada").get(&handed.university.address("")).text(200).contains("Your grade"));
    handed.university.set_clock(10 * DAY);
    assert_eq!(grades(&mut ann), ["40", "0"]);
    let ada_page = handed.university.browser_of("ada").get(&handed.university.address("")).text(200);
    assert!(ada_page.contains("<strong>40.0\u{a0}%</strong>") && ada_page.contains("4 of 10"), "{ada_page}");
    let mut second = handed.whole.clone();
    second.assignment.key = Key::new([79; 16]);
    second.items[0].key = Key::new([80; 16]);
    second.items[0].assignment = second.assignment.key;
    handed.university.wait(async |store| store.save_assignment(&second, &University::entry(91)).await).unwrap();
    assert_eq!(grades(&mut ann), ["20", "0"]);
    let weights = [handed.whole.assignment.key, second.assignment.key].map(|key| format!("weight.{key}"));
    let [first, second] = &weights;
    assert_eq!(ann.post(&page, &[("dropped", "1")]).status, 403, "an assistant decides nothing");
    let wrong = ida.post(&page, &[(first, "much"), (second, ""), ("dropped", "1")]).text(422);
    assert!(wrong.contains("Write a whole number from 0 to 1000") && wrong.contains("value=\"much\""), "{wrong}");
    ida.post(&page, &[(first, "3"), (second, "1"), ("dropped", "0")]).to();
    assert_eq!(grades(&mut ann), ["30", "0"], "three parts of 40 % and one of nothing");
    ida.post(&page, &[(first, ""), (second, ""), ("dropped", "1")]).to();
    assert_eq!(grades(&mut ann), ["40", "0"]);
    let shown = ann.get(&format!("{page}?sort=grade&section=A")).text(200);
    assert!(shown.contains("left out") && shown.find(">ada").unwrap() < shown.find(">bob").unwrap(), "{shown}");
}

#[test]
fn every_attempt_is_shown_with_what_was_typed_and_read() {
    let handed = Handed::new();
    let mut ada = handed.university.browser_of("ada");
    handed.university.set_clock(DAY + 1);
    ada.post(&handed.item(""), &[("request", "2"), ("answer.v_B2", "99.0 m/s")]).to();
    let page = handed.university.browser_of("ann").get(&handed.answers("")).text(200);
    for said in [
        "<code>ask 555-0199 &lt;b&gt;</code>",
        "<td>not read</td>",
        "Mon, 1 Dec 2025, 21:00",
        "late by 1 started day",
        "<code>99.0 m&#x2F;s</code>",
        "Attempt 2",
        "This attempt counts",
    ] {
        assert!(page.contains(said) || page.contains(&said.replace("&#x2F;", "/")), "{said}: {page}");
    }
    assert!(!page.contains("Set points by hand"), "an assistant decides nothing");
    let bob = handed.item(&format!("/students/{}", University::member("bob")));
    assert!(handed.university.browser_of("ida").get(&bob).text(200).contains("has not opened this problem"));
}

#[test]
fn what_is_of_another_course_is_not_there() {
    let handed = Handed::new();
    let mut ida = handed.university.browser_of("ida");
    let cleo = University::member("cleo");
    for path in [format!("/items/{}/students/{cleo}", handed.whole.items[0].key), format!("/members/{cleo}")] {
        assert_eq!(ida.get(&handed.university.address(&path)).status, 404, "{path}");
    }
    let mut other = handed.whole.clone();
    other.assignment.key = Key::new([77; 16]);
    other.assignment.course = handed.university.other.key;
    other.items[0].key = Key::new([78; 16]);
    other.items[0].assignment = other.assignment.key;
    handed.university.wait(async |store| store.save_assignment(&other, &University::entry(90)).await).unwrap();
    for path in ["gradebook", "gradebook.csv", "statistics", "regrade"] {
        let address = handed.university.address(&format!("/assignments/{}/{path}", other.assignment.key));
        assert_eq!(ida.get(&address).status, 404, "{path}");
    }
    let address = format!("/items/{}/students/{}", other.items[0].key, University::member("ada"));
    assert_eq!(ida.get(&handed.university.address(&address)).status, 404);
}

#[test]
fn points_set_by_hand_have_a_reason_and_nothing_before_is_lost() {
    let handed = Handed::new();
    let mut ida = handed.university.browser_of("ida");
    let address = handed.answers("/points");
    let wrong = ida.post(&address, &[("points", "7.5"), ("reason", "")]).text(422);
    assert!(wrong.contains("Say why") && wrong.contains("value=\"7.5\""), "{wrong}");
    let wrong = ida.post(&address, &[("points", "11"), ("reason", "oral \"exam\"")]).text(422);
    assert!(wrong.contains("Write points from 0 to 10") && wrong.contains("oral &quot;exam&quot;"), "{wrong}");
    assert_eq!(handed.row(), "ada,ada <script>,A,4,4,10");
    assert_eq!(ida.post(&address, &[("points", "22/3"), ("reason", "oral exam")]).to(), handed.answers(""));
    assert_eq!(handed.row(), "ada,ada <script>,A,7.333333,7.333333,10");
    let page = ida.get(&handed.assignment("/gradebook")).text(200);
    assert!(page.contains(">7.33</a> <span class=\"count\">by hand</span>"), "{page}");
    ida.post(&address, &[("points", ""), ("reason", "a mistake of mine")]).to();
    assert_eq!(handed.row(), "ada,ada <script>,A,4,4,10");
    let key = handed.whole.assignment.key;
    let kept = handed.university.wait(async |store| store.set_by_hand(key).await).unwrap();
    let points: Vec<_> = kept.iter().map(|row| (row.points.as_deref(), row.reason.as_str())).collect();
    assert_eq!(points, [(Some("22/3"), "oral exam"), (None, "a mistake of mine")]);
}

#[test]
fn points_set_by_hand_reach_the_student_with_reason_and_comment_once_verdicts_do() {
    for (verdicts, shown) in [(Release::AtOnce, [true, true]), (Release::AtClose, [false, true])] {
        let handed = Handed::with(|policy| policy.verdicts = verdicts);
        let mut ida = handed.university.browser_of("ida");
        let fields = [("points", "22/3"), ("reason", "an oral <exam>"), ("comment", "Well said.\nMind the units.")];
        ida.post(&handed.answers("/points"), &fields).to();
        let mut ada = handed.university.browser_of("ada");
        for (when, shown) in [DAY / 2, 4 * DAY].into_iter().zip(shown) {
            handed.university.set_clock(when);
            let sheet = ada.get(&handed.item("")).text(200);
            for said in ["7.33 of 10</strong> points, by hand", "an oral &lt;exam&gt;", "Mind the units."] {
                assert_eq!(sheet.contains(said), shown, "{said}: {sheet}");
            }
            let list = ada.get(&handed.assignment("")).text(200);
            assert_eq!(list.contains("7.33 of 10"), shown, "{list}");
        }
        assert!(ida.get(&handed.answers("")).text(200).contains("To the student: Well said."));
    }
}

#[test]
fn a_student_who_has_opened_nothing_can_have_points_and_finds_the_same_sheet() {
    let handed = Handed::new();
    let mut ida = handed.university.browser_of("ida");
    let address = |login: &str, path: &str| handed.item(&format!("/students/{}{path}", University::member(login)));
    assert!(ida.get(&address("bob", "")).text(200).contains("has not opened this problem"));
    ida.post(&address("bob", "/points"), &[("points", "6"), ("reason", "did it on paper")]).to();
    let page = ida.get(&handed.assignment("/gradebook")).text(200);
    assert!(page.contains(">6</a> <span class=\"count\">by hand</span>"), "{page}");
    let sheets = || handed.university.wait(async |store| store.sheets_of(University::member("bob")).await).unwrap();
    let given = sheets();
    assert_eq!(given.len(), 1);
    handed.university.browser_of("bob").get(&handed.item("")).text(200);
    assert_eq!(sheets(), given, "the page draws no other sheet");
    let refused = ida.post(&address("ann", "/points"), &[("points", "6"), ("reason", "she helps")]);
    assert!(refused.text(409).contains("nly students of the course have points"));
    assert!(!ida.get(&address("ann", "")).text(200).contains("Set points by hand"));
}

#[test]
fn a_redacted_answer_is_gone_and_its_points_stay() {
    let handed = Handed::new();
    let mut ida = handed.university.browser_of("ida");
    let address = handed.answers("/redact");
    let fault = ida.post(&address, &[("attempt", "1"), ("part", "v_B2"), ("reason", "")]).text(422);
    assert!(fault.contains("Say why") && fault.contains("0199"), "{fault}");
    for (attempt, part) in [("2", "v_B2"), ("x", "v_B2")] {
        assert_eq!(ida.post(&address, &[("attempt", attempt), ("part", part), ("reason", "r")]).status, 404);
    }
    ida.post(&address, &[("attempt", "1"), ("part", "v_B2"), ("reason", "a telephone number")]).to();
    let page = ida.get(&handed.answers("")).text(200);
    assert!(!page.contains("0199") && page.contains("[redacted]"), "{page}");
    assert_eq!(handed.row(), "ada,ada <script>,A,4,4,10");
    let trail = ida.get(&handed.university.address("/trail")).text(200);
    assert!(
        trail.contains("answer redacted")
            && trail.contains("a telephone number")
            && trail.contains("ida &lt;script&gt;")
    );
    assert!(!trail.contains("0199"), "{trail}");
    assert!(
        trail.contains(
            "member ada &lt;script&gt;, Two carts on a straight track, attempt 1, part v_B2: a telephone number"
        ),
        "{trail}"
    );
}

#[test]
fn statistics_say_how_easy_a_part_was() {
    let handed = Handed::new();
    let page = handed.university.browser_of("ann").get(&handed.assignment("/statistics")).text(200);
    assert!(page.contains("1 student has points; the mean is 40 %") && page.contains("4 of 10"), "{page}");
    assert!(
        page.contains("3 answers were marked")
            && page.contains("Two carts on a straight track: (a) the velocity of ")
            && page.contains("100 %"),
        "{page}"
    );
    let places = ["(a) the velocity of", "(b) the velocity of", "(c) the kinetic energy"].map(|part| page.find(part));
    assert!(places.iter().flatten().is_sorted() && places.iter().flatten().count() > 1, "{places:?} {page}");
}

/// The key of the class.

#[test]
fn students_take_their_own_data_and_nobody_elses() {
    let handed = Handed::new();
    let address = handed.university.address(&format!("/members/{}/data", University::member("ada")));
    let json = handed.university.browser_of("ada").get(&address).text(200);
    let data: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(data["login"], "ada");
    let attempt = &data["sheets"][0]["attempts"][0];
    assert_eq!(attempt["answers"]["v_B2"], "ask 555-0199 <b>");
    assert!(attempt["report"]["total"].is_string() || attempt["report"]["total"].is_number(), "{json}");
    assert!(!json.contains("\"seed\"") && !json.contains(&handed.university.course.secret), "{json}");
    assert_eq!(handed.university.browser_of("ida").get(&address).text(200), json);
    assert_eq!(handed.university.browser_of("bob").get(&address).status, 404);
    assert_eq!(handed.university.browser_of("ann").get(&address).status, 404);
}

#[test]
fn an_erased_name_is_gone_and_its_marks_stay() {
    let handed = Handed::new();
    let mut ada = handed.university.browser_of("ada");
    let mut ida = handed.university.browser_of("ida");
    let page = handed.university.address(&format!("/members/{}", University::member("ada")));
    let address = format!("{page}/erase");
    assert!(ida.post(&address, &[("login", "ad")]).text(422).contains("Type the name"));
    ada.get("/courses").text(200);
    ida.post(&address, &[("login", "ada")]).to();
    assert_eq!(ada.get("/courses").status, 303, "nobody signs in as nobody");
    let table = ida.get(&handed.assignment("/gradebook.csv")).text(200);
    assert!(table.contains(",(erased),A,4,4,10") && !table.contains("ada"), "{table}");
    let trail = ida.get(&handed.university.address("/trail")).text(200);
    assert!(trail.contains("name erased") && !trail.contains("ada"), "{trail}");
    assert!(ida.post(&address, &[("login", "")]).text(422).contains("erased already"));
    let form = handed.university.address(&format!("/members/{}/erase", University::member("ida")));
    assert!(ida.post(&form, &[("login", "ida")]).text(422).contains("own name"));
}

#[test]
fn answers_are_deleted_when_they_were_kept_long_enough_and_not_before() {
    let mut handed = Handed::new();
    handed.university.course.retention_days = Some(30);
    let course = handed.university.course.clone();
    handed.university.wait(async |store| store.save_course(&course, &University::entry(91)).await).unwrap();
    let mut ida = handed.university.browser_of("ida");
    let address = handed.university.address("/retention");
    let page = ida.get(&address).text(200);
    assert!(page.contains("1 sheet with 1 attempt,") && page.contains("Sat, 3 Jan 2026, 09:00"), "{page}");
    // The assignment closes after three days.
    handed.university.set_clock(33 * DAY);
    let mut ida = handed.university.browser_of("ida");
    ida.post(&address, &[("sure", "yes")]).text(422);
    assert_eq!(handed.row(), "ada,ada <script>,A,4,4,10");
    handed.university.set_clock(33 * DAY + 1);
    ida.post(&address, &[]).text(422);
    ida.post(&address, &[("sure", "yes")]).to();
    assert_eq!(handed.row(), "ada,ada <script>,A,,0,10");
    assert!(ida.get(&address).text(200).contains("0 sheets with 0 attempts"));
}
