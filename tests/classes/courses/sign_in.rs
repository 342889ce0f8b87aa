//! Who is let in.

use momentous::web::Settings;

use super::university::{DAY, University};

#[test]
fn a_link_works_once_and_is_not_used_up_by_looking() {
    let university = University::new();
    let link = university.link("ada");
    let mut scanner = university.browser();
    for _ in 0..3 {
        assert!(scanner.get(&link).text(200).contains("Sign in as ada &lt;script&gt;"));
    }
    let mut ada = university.browser();
    let signed_in = ada.post(&link, &[]);
    assert_eq!(signed_in.to(), "/courses");
    let cookie = signed_in.header("set-cookie").unwrap();
    assert!(cookie.contains("HttpOnly") && cookie.contains("SameSite=Lax") && !cookie.contains("Secure"), "{cookie}");
    assert!(ada.get("/courses").text(200).contains("Mechanics &lt;1&gt;"));
    assert!(university.browser().post(&link, &[]).text(200).contains("used already"));
}

#[test]
fn behind_tls_a_cookie_goes_no_other_way() {
    let host = Some("physics.example.edu".to_owned());
    let university = University::with(Settings { host, is_secure: true, ..Settings::default() });
    let link = university.link("ada");
    let mut ada = university.browser();
    assert_eq!(ada.post(&link, &[]).status, 403, "the form has to come from the public address");
    let cookie = ada.post_from(Some("https://physics.example.edu"), &link, &[]);
    assert!(cookie.header("set-cookie").unwrap().ends_with("; Secure"));
    assert_eq!(ada.get("/courses").header("strict-transport-security"), Some("max-age=63072000"));
    assert_eq!(ada.post_from(Some("http://physics.example.edu"), &link, &[]).status, 403, "not by TLS");
}

#[test]
fn a_password_lets_in_and_a_new_one_ends_other_sessions() {
    let university = University::new();
    let mut first = university.browser_of("ada");
    let new = [("new", "a few short words"), ("again", "a few short words")];
    assert_eq!(first.post("/account/password", &new).to(), "/courses?password=changed");
    let right = [("login", "ada"), ("password", "a few short words"), ("to", "/courses?a=b")];
    let mut second = university.browser();
    assert_eq!(second.post("/sign-in", &right).to(), "/courses?a=b");
    let wrong =
        second.post("/account/password", &[("old", "no"), ("new", "other words here"), ("again", "other words here")]);
    assert!(wrong.text(422).contains("The old password is not right"));
    let change = [("old", "a few short words"), ("new", "other words here"), ("again", "other words here")];
    assert_eq!(second.post("/account/password", &change).status, 303);
    assert_eq!(first.get("/courses").to(), "/sign-in?to=/courses", "the other session has ended");
    second.get("/courses").text(200);
    let mut third = university.browser();
    assert!(third.post("/sign-in", &right).text(422).contains("value=\"ada\""), "what was typed stays");
    assert_eq!(second.post("/sign-out", &[]).to(), "/");
    assert_eq!(second.get("/courses").status, 303);
}

#[test]
fn nobody_learns_which_names_there_are() {
    let university = University::new();
    let mut browser = university.browser();
    let page = |login: &str, browser: &mut super::university::Browser<'_>| {
        browser.post("/sign-in", &[("login", login), ("password", "x")]).text(422).replace(login, "NAME")
    };
    assert_eq!(page("ada", &mut browser), page("zoe", &mut browser));
}

#[test]
fn passwords_are_tried_few_times_a_minute_from_one_address() {
    let university =
        University::with(Settings { trusted_proxies: vec!["127.0.0.1/32".parse().unwrap()], ..Settings::default() });
    let words = "a few short words";
    university.browser_of("ada").post("/account/password", &[("new", words), ("again", words)]).to();
    let tried = |from: &str, password: &str, browser: &mut super::university::Browser<'_>| {
        browser.from = Some(from.to_owned());
        browser.post("/sign-in", &[("login", "ADA"), ("password", password)])
    };
    let statuses = university.at_once(12, |browser| tried("192.0.2.7", "x", browser).status);
    assert_eq!(statuses.iter().filter(|status| **status == 422).count(), 10, "{statuses:?}");
    let mut browser = university.browser();
    let refused = tried("192.0.2.7", words, &mut browser).text(429);
    assert!(refused.contains("name=\"login\" value=\"ADA\"") && !refused.contains(words), "{refused}");
    assert_eq!(tried("203.0.113.1, 192.0.2.7", words, &mut browser).status, 429, "what stands before is invented");
    browser.from = Some("192.0.2.8".to_owned());
    let right = browser.post("/sign-in", &[("login", "ada"), ("password", words)]);
    assert_eq!(right.to(), "/courses", "others keep nobody out");
}

#[test]
fn a_name_that_nobody_has_is_not_even_looked_up_where_it_is_too_long() {
    let university = University::new();
    let mut browser = university.browser();
    let long = "a".repeat(201);
    for _ in 0..11 {
        let before = university.store.reads();
        let page = browser.post("/sign-in", &[("login", &long), ("password", "x")]).text(422);
        assert!(!page.contains(&long), "{page}");
        assert_eq!(university.store.reads(), before, "no table and no database has heard of it");
    }
    let longer = "a".repeat(1 << 20);
    browser.post("/sign-in", &[("login", &longer), ("password", "x")]).text(413);
}

#[test]
fn nobody_is_sent_to_another_site() {
    let university = University::new();
    let mut ada = university.browser_of("ada");
    for to in ["https://evil.example", "//evil.example", "/\\evil.example", "javascript:alert(1)"] {
        assert_eq!(
            ada.get(&format!("/sign-in?{}", super::university::encoded(&[("to", to)]))).to(),
            "/courses",
            "{to}"
        );
    }
}

#[test]
fn a_session_ends() {
    let university = University::new();
    let mut ada = university.browser_of("ada");
    university.set_clock(1000 * 365 * DAY);
    assert_eq!(ada.get("/courses").status, 303);
}
