//! What cannot be read or kept is refused, with a reason, before anything is done.

use axum::http::Method;
use momentous::store::AssignmentWithItems;

use super::university::{University, encoded};

/// The address of the first item.
fn first(university: &University, whole: &AssignmentWithItems) -> String {
    university.address(&format!("/items/{}", whole.items[0].key))
}

#[test]
fn what_would_fill_the_disk_or_cannot_be_kept_is_not_handed_in() {
    let university = University::new();
    let whole = university.assignment(&[("impact/two-carts", "forward", 10)], |policy| policy.attempts = None);
    let address = first(&university, &whole);
    let mut ada = university.browser_of("ada");
    let long = "9".repeat(40_000);
    for (fields, status, said) in [
        (
            &[("request", &long[..65]), ("answer.v_A2", "1.00 m/s")][..],
            413,
            "At most 64 bytes make the key of a request",
        ),
        (&[("answer.v_A2", &long), ("answer.v_B2", &long)], 413, "At most 65536 bytes of answers can be sent"),
        (&[("request", "a\0"), ("answer.v_A2", "1.00 m/s")], 400, "nobody can type"),
    ] {
        let page = ada.post(&address, fields).text(status);
        assert!(page.contains(said), "{said}: {page}");
    }
    let draft = [("answer.v_A2", long.as_str()), ("answer.v_B2", long.as_str())];
    ada.post(&format!("{address}/draft"), &draft).text(413);
    ada.get(&format!("{address}%00")).text(400);
    let kept = university.wait(async |store| store.all_attempts(whole.assignment.key).await.unwrap());
    assert!(kept.is_empty(), "{kept:?}");
}

#[test]
fn nobody_is_led_away_after_signing_in() {
    let university = University::new();
    let mut ada = university.browser_of("ada");
    for to in ["//evil.example", "/\\evil.example", "/\t/evil.example", "https://evil.example", "\n//evil.example"] {
        assert_eq!(ada.get(&format!("/sign-in?{}", encoded(&[("to", to)]))).to(), "/courses", "{to:?}");
    }
    assert_eq!(ada.get("/sign-in?to=%2Fcourses%2Fnew").to(), "/courses/new");
}

#[test]
fn a_request_in_the_wrong_form_gets_a_page_with_the_reason() {
    let university = University::new();
    let mut ada = university.browser_of("ada");
    let answer = ada.ask(Method::DELETE, "/courses", None, Some("http://localhost"));
    assert_eq!(answer.header("allow"), Some("GET,HEAD"));
    assert!(answer.text(405).contains("This address does not take such a request. Go back"));
}

#[test]
fn a_page_that_refuses_holds_what_was_typed() {
    let university = University::new();
    let whole = university.assignment(&[("impact/two-carts", "forward", 10)], |policy| policy.attempts = None);
    let address = first(&university, &whole);
    let typed = [("request", "abc"), ("answer.v_A2", "<1 m/s")];
    let holds = |page: &str| {
        assert!(page.contains(&format!("<form method=\"post\" action=\"{address}\"")), "{page}");
        assert!(page.contains("type=\"hidden\" name=\"request\" value=\"abc\""), "{page}");
        assert!(page.contains("name=\"answer.v_A2\" value=\"&lt;1 m"), "{page}");
        assert!(page.contains("Send again"), "{page}");
    };
    let mut ada = university.browser_of("ada");
    holds(&university.browser().post(&address, &typed).text(401));
    let draft = format!("{address}/draft");
    let refused = (0..70).map(|_| ada.post(&draft, &typed)).find(|answer| answer.status == 429).unwrap();
    assert!(refused.text(429).contains("value=\"&lt;1 m"));
    holds(&ada.post(&address, &typed).text(429));
    university.wait(async |store| store.close().await);
    holds(&ada.post(&address, &typed).text(503));
}

#[test]
fn a_roster_that_has_changed_meanwhile_stays_in_the_page() {
    let university = University::new();
    let table = "id,name\nzoe,<Zoe>\n";
    let apply = university.address("/roster/apply");
    let page = university.browser_of("ida").post(&apply, &[("table", table), ("shown", "0")]).text(409);
    assert!(page.contains("name=\"table\" rows=\"12\">\nid,name\nzoe,&lt;Zoe&gt;\n</textarea>"), "{page}");
}
