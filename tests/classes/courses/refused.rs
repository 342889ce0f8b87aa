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
        (&[("request", &long[..65]), ("answer.v_A2", "1 m/s")][..], 413, "At most 64 bytes make the key of a request"),
        (&[("answer.v_A2", &long), ("answer.v_B2", &long)], 413, "At most 65536 bytes of answers can be sent"),
        (&[("request", "a\0"), ("answer.v_A2", "1 m/s")], 400, "nobody can type"),
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
