//! Nobody sees or does what is not theirs: every address, as everybody.

use momentous::course::{Course, Member, Role};
use momentous::course_pages::{Post, Who, addresses};

use super::university::{DAY, RELEASED, University};

/// Everybody, with their role in the first course, and whether they run the server.
const EVERYBODY: [(Option<&str>, Option<Role>, bool); 6] = [
    (None, None, false),
    (Some("bob"), Some(Role::Student), false),
    (Some("cleo"), None, false),
    (Some("ann"), Some(Role::Assistant), false),
    (Some("ida"), Some(Role::Instructor), false),
    (Some("olga"), None, true),
];

#[test]
fn every_address_is_shown_to_those_who_may_see_it() {
    // Nothing listens there.
    let university = University::with_post(Post::new("smtp://127.0.0.1:1", "momentous@example.edu").unwrap());
    let whole = university.assignment(&[("impact/two-carts", "forward", 5)], |_| {});
    for address in addresses() {
        let path = address
            .pattern
            .replace("{course}", &university.course.key.to_string())
            .replace("{assignment}", &whole.assignment.key.to_string())
            .replace("{item}", &whole.items[0].key.to_string())
            .replace("{member}", &University::member("ada").to_string())
            .replace("{token}", "0")
            .replace("{digest}", "0")
            .replace("{code}", "0");
        for (login, role, operator) in EVERYBODY {
            let mut browser = login.map_or_else(|| university.browser(), |login| university.browser_of(login));
            let may = match address.who {
                Who::Anyone => true,
                Who::SignedIn => login.is_some(),
                Who::Member(least) => role.is_some_and(|role| role >= least),
                Who::Operator => operator,
            };
            let answer = if address.changes { browser.post(&path, &[]) } else { browser.get(&path) };
            let to_sign_in = answer.header("location").is_some_and(|to| to.starts_with("/sign-in?to="));
            // Other pages with this status say something of the time, not of who asks.
            let forbidden = answer.status == 403 && answer.text.contains("This page is for those who");
            let refused = answer.status == 401 || forbidden || to_sign_in || (role.is_none() && answer.status == 404);
            assert_eq!(refused, !may, "{path} as {login:?}: {} {}", answer.status, answer.text);
            assert_ne!(answer.status, 500, "{path} as {login:?}: {}", answer.text);
        }
    }
}

#[test]
fn a_form_of_another_site_changes_nothing() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    for address in addresses().filter(|address| address.changes) {
        let path = address.pattern.replace("{course}", &university.course.key.to_string());
        for origin in [Some("https://evil.example"), Some("null"), None] {
            assert_eq!(ida.post_from(origin, &path, &[]).status, 403, "{path} from {origin:?}");
        }
    }
}

#[test]
fn no_page_of_a_course_is_kept_by_a_cache() {
    let university = University::new();
    let mut ada = university.browser_of("ada");
    for address in ["/courses", &university.address("")] {
        assert_eq!(ada.get(address).header("cache-control"), Some("no-store"), "{address}");
    }
}

#[test]
fn who_teaches_one_course_looks_up_no_open_problem_of_another_where_it_learns() {
    let university = University::new();
    university.assignment(&[("impact/two-carts", "forward", 5)], |_| {});
    let teaches = Member {
        key: University::member("ada elsewhere"),
        course: university.other.key,
        person: University::key("ada"),
        role: Role::Instructor,
        section: String::new(),
        left: None,
    };
    university.wait(async |store| store.save_members(&[], &[teaches], &University::entry(60)).await).unwrap();
    let look = |of: &Course, problem: &str| format!("/courses/{}/look?problem={problem}", of.key);
    let mut ada = university.browser_of("ada");
    assert_eq!(ada.get(&look(&university.other, "impact/two-carts")).status, 403, "with its answers");
    assert_eq!(ada.get(&look(&university.other, "impulse/parcel-push")).status, 200);
    assert_eq!(university.browser_of("ida").get(&look(&university.course, "impact/two-carts")).status, 200);
    let there = |path: &str| format!("/courses/{}{path}", university.other.key);
    assert_eq!(ada.get(&there("/problems/new?from=impact/two-carts")).status, 403, "its file");
    let text = include_str!("../../../problem_bank/impact/two-carts.yaml");
    let refused = ada.post(&there("/problems/new"), &[("text", text)]).text(422);
    assert!(
        refused.contains("part of an assignment that is open now") && refused.contains("impact/two-carts"),
        "{refused}"
    );
    let fields = [
        ("title", "Mine"),
        ("opens", "2025-12-01T00:00"),
        ("due", "2025-12-20T00:00"),
        ("closes", "2025-12-20T00:00"),
        ("verdicts", "at_once"),
        ("solutions", "at_close"),
        ("do", "save"),
        ("item.0.problem", "impact/two-carts"),
        ("item.0.points", "5"),
        ("item.0.order", "1"),
    ];
    let mine = ada.post(&there("/assignments/new"), &fields);
    let mine = mine.to().split("/assignments/").nth(1).unwrap()[..32].to_owned();
    assert_eq!(ada.get(&there(&format!("/assignments/{mine}/print/key"))).status, 403, "its key");
    let page = ada.get(&there(&format!("/assignments/{mine}"))).text(200);
    let item = page.split("/items/").nth(1).unwrap()[..32].to_owned();
    ada.get(&there(&format!("/items/{item}"))).text(200);
    assert_eq!(ada.get(&there(&format!("/items/{item}/solution"))).status, 403, "its solution");
    university.set_clock(3 * DAY + RELEASED);
    ada.get(&there(&format!("/items/{item}/solution"))).text(200);
    assert_eq!(ada.get(&look(&university.other, "impact/two-carts")).status, 200, "it has closed");
}
