//! Links that are sent by mail: who gets one, and where it opens.

use momentous::course::MailAddress;
use momentous::course_pages::Post;

use super::letter_box::LetterBox;
use super::university::{Browser, University};

const WORDS: &str = "a few short words";
const QUARTER: i64 = 15 * 60_000;

/// Gives somebody an address, as whoever runs the server does.
fn set(university: &University, login: &str, address: &str) {
    let mut olga = university.browser_of("olga");
    assert_eq!(olga.post("/people/mail", &[("whose", login), ("address", address)]).to(), "/people");
}

/// A server that sends letters, on which Ada has an address.
fn with_address_of_ada() -> (LetterBox, University) {
    let letters = LetterBox::new();
    let university = University::with_post(letters.post());
    set(&university, "ada", "ada@example.edu");
    (letters, university)
}

fn ask(browser: &mut Browser<'_>, address: &str) {
    assert_eq!(browser.post("/mail", &[("address", address)]).to(), "/mail");
}

#[test]
fn a_mailed_link_signs_in_once_in_the_browser_that_asked() {
    let (letters, university) = with_address_of_ada();
    let mut ada = university.browser();
    assert!(ada.get("/sign-in?to=/courses?x=1").text(200).contains("Or by e-mail"));
    let asked = ada.post("/mail", &[("address", " Ada@Example.EDU"), ("to", "/courses?x=1")]);
    let cookie = asked.header("set-cookie").unwrap();
    assert!(
        cookie.contains("Max-Age=900") && cookie.contains("HttpOnly") && cookie.contains("SameSite=Lax"),
        "{cookie}"
    );
    assert!(ada.get("/mail").text(200).contains("Look into your mail"));
    let link = letters.link();
    assert_eq!(link.split_once('?').unwrap().1, "to=%2Fcourses%3Fx%3D1");
    let mut eve = university.browser();
    assert!(eve.get(&link).text(200).contains("asked for in another browser"));
    ask(&mut eve, "eve@example.edu");
    eve.post(&link, &[]).text(200);
    assert_eq!(eve.get("/courses").status, 303, "another browser stays outside, whatever it has asked for");
    for _ in 0..2 {
        assert!(ada.get(&link).text(200).contains("Sign in as ada &lt;script&gt;"), "a look does not use it up");
    }
    assert_eq!(ada.post(&link, &[("to", "/courses?x=1")]).to(), "/courses?x=1");
    assert!(ada.get("/courses").text(200).contains("Mechanics &lt;1&gt;"));
    assert!(ada.post(&link, &[]).text(200).contains("used already"));
    // Whoever reads the letters gets a new password without the old one.
    let new = [("new", WORDS), ("again", WORDS)];
    assert_eq!(ada.post("/account/password", &new).to(), "/courses?password=changed");
}

#[test]
fn a_mailed_link_ends() {
    let (letters, university) = with_address_of_ada();
    let mut ada = university.browser();
    ask(&mut ada, "ada@example.edu");
    let first = letters.link();
    university.set_clock(QUARTER - 1);
    ask(&mut ada, "ada@example.edu");
    let second = letters.link();
    assert!(ada.get(&first).text(200).contains("Sign in as"), "another letter ends none");
    university.set_clock(QUARTER);
    assert!(ada.post(&first, &[]).text(200).contains("its time is over"));
    assert_eq!(ada.post(&second, &[]).status, 303);
}

#[test]
fn nobody_learns_which_addresses_there_are() {
    let (letters, university) = with_address_of_ada();
    let mut replies = ["ada@example.edu", "zoe@example.edu"].map(|address| {
        let mut browser = university.browser();
        let asked = browser.post("/mail", &[("address", address)]);
        let page = browser.get("/mail").text(200);
        (asked.status, asked.to().to_owned(), asked.text, page)
    });
    replies.sort();
    assert_eq!(replies[0], replies[1]);
    letters.letter();
    assert!(letters.is_empty(), "nobody has the other address");
    let mut browser = university.browser();
    let wrong = browser.post("/mail", &[("address", "zoe")]).text(422);
    assert!(wrong.contains("value=\"zoe\"") && wrong.contains("This is no e-mail address"), "{wrong}");
    let tried: Vec<u16> = (0..4).map(|_| browser.post("/mail", &[("address", "yan@example.edu")]).status).collect();
    assert_eq!(tried, [303, 303, 303, 429], "of an address that nobody has, too");
}

#[test]
fn an_address_is_saved_once_its_letter_was_read() {
    let letters = LetterBox::new();
    let university = University::with_post(letters.post());
    let kept = |login: &str| {
        let kept = university.wait(async |store| store.mail_address(University::key(login)).await.unwrap());
        kept.map(|address: MailAddress| address.to_string())
    };
    let mut ada = university.browser_of("ada");
    ada.post("/account/password", &[("new", WORDS), ("again", WORDS)]).to();
    let wrong = ada.post("/account/mail", &[("address", "ada@example.edu"), ("old", "no")]).text(422);
    assert!(wrong.contains("The password is not right") && wrong.contains("value=\"ada@example.edu\""), "{wrong}");
    let mail = [("address", "ada@example.edu"), ("old", WORDS)];
    assert_eq!(ada.post("/account/mail", &mail).to(), "/courses?mail=sent");
    assert!(ada.get("/courses?mail=sent").text(200).contains("A letter is on its way"));
    assert_eq!(kept("ada"), None, "whoever mistypes gives it to nobody");
    ada.post(&letters.link(), &[]).to();
    assert_eq!(kept("ada").as_deref(), Some("ada@example.edu"));
    assert!(ada.get("/courses").text(200).contains("ada@example.edu is saved"));
    let mut other = university.browser();
    ask(&mut other, "ada@example.edu");
    let link = letters.link();
    // A letter that was sent before an address is removed opens nothing afterwards.
    assert_eq!(ada.post("/account/mail", &[("address", ""), ("old", WORDS)]).to(), "/courses?mail=removed");
    assert_eq!(kept("ada"), None);
    assert!(other.post(&link, &[]).text(200).contains("used already"));
    assert_eq!(other.get("/courses").status, 303);
}

#[test]
fn no_course_sets_or_sees_an_address() {
    let (_letters, university) = with_address_of_ada();
    let mut ida = university.browser_of("ida");
    let pages = ["/roster".to_owned(), format!("/members/{}", University::member("ada")), "/trail".to_owned()];
    for page in pages {
        let text = ida.get(&university.address(&page)).text(200);
        assert!(!text.contains("ada@example.edu"), "{page}: {text}");
    }
    assert_eq!(ida.post("/people/mail", &[("whose", "ada"), ("address", "ida@example.edu")]).status, 403);
    let mut olga = university.browser_of("olga");
    assert!(olga.get("/people").text(200).contains("<td>ada@example.edu</td>"));
    let wrong = olga.post("/people/mail", &[("whose", "zoe"), ("address", "zoe@example.edu")]).text(422);
    assert!(wrong.contains("Nobody signs in by this name"), "{wrong}");
    let wrong = olga.post("/people/mail", &[("whose", "ada"), ("address", "a b")]).text(422);
    assert!(wrong.contains("This is no e-mail address"), "{wrong}");
}

#[test]
fn a_server_without_mail_offers_none() {
    let university = University::new();
    let mut ada = university.browser_of("ada");
    assert!(!university.browser().get("/sign-in").text(200).contains("e-mail"));
    assert!(!ada.get("/courses").text(200).contains("mail"));
    for (address, fields) in [("/mail", [("address", "ada@example.edu")]), ("/account/mail", [("address", "")])] {
        assert_eq!(ada.post(address, &fields).status, 404, "{address}");
    }
}

#[test]
fn a_server_of_mail_that_does_not_answer_is_told_to_whoever_has_signed_in() {
    // Nothing listens there.
    let university = University::with_post(Post::new("smtp://127.0.0.1:1", "momentous@example.edu").unwrap());
    let mut ada = university.browser_of("ada");
    let told = ada.post("/account/mail", &[("address", "ada@example.edu")]).text(422);
    assert!(told.contains("The letter could not be sent"), "{told}");
    ask(&mut university.browser(), "ada@example.edu");
}
