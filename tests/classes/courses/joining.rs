//! A code by which students ask for a place, and what comes of it.

use momentous::course::{Course, Role};

use super::university::{DAY, University};

/// What somebody writes who asks for a place.
fn asks(login: &str) -> [(&str, &str); 4] {
    [("login", login), ("name", "Dan D."), ("new", "a few short words"), ("again", "a few short words")]
}

/// A new code of the first course, as its address.
fn code(university: &University, days: &str) -> String {
    let mut ida = university.browser_of("ida");
    ida.post(&university.address("/roster/code"), &[("days", days)]).to();
    let page = ida.get(&university.address("/roster")).text(200);
    let code = page.split("Code <strong><code class=\"link\">").nth(1).unwrap_or_else(|| panic!("{page}"));
    let code = code.split('<').next().unwrap();
    let to = university.browser().get(&format!("/join?code={}", code.to_lowercase())).to().to_owned();
    assert_eq!(to, format!("/join/{}", code.replace('-', "")));
    to
}

/// The keys of those who wait, each with whether it is ticked.
fn waiting(page: &str) -> Vec<(String, bool)> {
    let rows = page.split("name=\"request\" value=\"").skip(1);
    rows.map(|row| (row[..32].to_owned(), row[..50].contains("checked"))).collect()
}

fn members(university: &University, course: &Course) -> Vec<(String, Role)> {
    let all = university.wait(async |store| store.members(course.key).await.unwrap());
    all.into_iter()
        .filter(|membership| membership.member.left.is_none())
        .map(|membership| (membership.person.login, membership.member.role))
        .collect()
}

#[test]
fn a_student_asks_for_a_place_is_confirmed_and_signs_in() {
    let university = University::new();
    let join = code(&university, "14");
    let mut dan = university.browser();
    let form = dan.get(&join).text(200);
    assert!(form.contains("Mechanics &lt;1&gt;") && form.contains("name=\"login\""), "{form}");
    let asked = dan.post(&join, &asks("s40")).to().to_owned();
    assert!(dan.get(&asked).text(200).contains("Your request was sent"));
    let password = [("login", "s40"), ("password", "a few short words")];
    assert_eq!(dan.post("/sign-in", &password).status, 422, "nothing is open before it is confirmed");
    assert_eq!(members(&university, &university.course).len(), 4);

    let roster = university.address("/roster");
    let mut ida = university.browser_of("ida");
    let page = ida.get(&roster).text(200);
    let [(key, true)] = &waiting(&page)[..] else { panic!("{page}") };
    assert!(page.contains("Dan D.") && page.contains("s40") && !page.contains("argon2"), "{page}");
    ida.post(&format!("{roster}/confirm"), &[("request", key)]).to();
    assert!(members(&university, &university.course).contains(&("s40".to_owned(), Role::Student)));
    assert_eq!(ida.post(&format!("{roster}/confirm"), &[("request", key)]).status, 409, "once");
    dan.post("/sign-in", &password).to();
    dan.get(&university.address("")).text(200);
    let member = dan.get(&join).text(200);
    assert!(member.contains("You are in this course") && !member.contains("<button class=\"main\">"), "{member}");
}

#[test]
fn somebody_with_an_account_asks_by_a_button_and_nobody_takes_it_over() {
    let university = University::new();
    let join = code(&university, "7");
    // Cleo is a student of the other course.
    let mut cleo = university.browser_of("cleo");
    assert!(cleo.get(&join).text(200).contains("Ask for a place as cleo"));
    cleo.post(&join, &[]).to();
    assert!(cleo.get(&join).text(200).contains("Your request was sent"));
    assert!(cleo.post(&join, &[]).text(200).contains("Your request was sent"), "once is enough");
    // Somebody else says to be Cleo, and is told no more than others.
    university.set_clock(1);
    let mut eve = university.browser();
    eve.post(&join, &asks("cleo")).to();
    let roster = university.address("/roster");
    let mut ida = university.browser_of("ida");
    let page = ida.get(&roster).text(200);
    let [(cleos, true), (eves, false)] = &waiting(&page)[..] else { panic!("{page}") };
    assert!(page.contains("Somebody signs in by this login already"), "{page}");
    let refused = ida.post(&format!("{roster}/confirm"), &[("request", cleos), ("request", eves)]);
    assert!(refused.text(409).contains("has to sign in first"));
    assert_eq!(members(&university, &university.course).len(), 4, "all or none");
    ida.post(&format!("{roster}/confirm"), &[("request", cleos)]).to();
    ida.post(&format!("{roster}/decline"), &[("request", eves)]).to();
    assert!(waiting(&ida.get(&roster).text(200)).is_empty());
    cleo.get(&university.address("")).text(200);
    assert_eq!(eve.post("/sign-in", &[("login", "cleo"), ("password", "a few short words")]).status, 422);
}

#[test]
fn of_two_who_ask_for_one_login_one_is_confirmed() {
    let university = University::new();
    let join = code(&university, "1");
    for _ in 0..2 {
        university.browser().post(&join, &asks("s41")).to();
    }
    let roster = university.address("/roster");
    let mut ida = university.browser_of("ida");
    let page = ida.get(&roster).text(200);
    let [(first, false), (second, false)] = &waiting(&page)[..] else { panic!("{page}") };
    let both = ida.post(&format!("{roster}/confirm"), &[("request", first), ("request", second)]);
    assert!(both.text(409).contains("ask for the login s41"));
    ida.post(&format!("{roster}/confirm"), &[("request", second)]).to();
    let refused = ida.post(&format!("{roster}/confirm"), &[("request", first)]).text(409);
    assert!(refused.contains("has to sign in first"), "{refused}");
}

#[test]
fn a_member_who_left_comes_back_as_a_student() {
    let university = University::new();
    let (join, roster) = (code(&university, "7"), university.address("/roster"));
    let mut ida = university.browser_of("ida");
    ida.post(&format!("{roster}/remove"), &[("member", &University::member("ann").to_string())]).to();
    let mut ann = university.browser_of("ann");
    ann.post(&join, &[]).to();
    let page = ida.get(&roster).text(200);
    let [(key, true)] = &waiting(&page)[..] else { panic!("{page}") };
    ida.post(&format!("{roster}/confirm"), &[("request", key)]).to();
    assert!(members(&university, &university.course).contains(&("ann".to_owned(), Role::Student)));
}

#[test]
fn a_code_ends_by_its_time_by_a_button_and_by_the_next_one() {
    let university = University::new();
    let first = code(&university, "1");
    let second = code(&university, "7");
    assert!(university.browser().get(&first).text(422).contains("not known, or its time is over"));
    university.set_clock(7 * DAY - 1);
    university.browser().get(&second).text(200);
    university.set_clock(7 * DAY);
    assert_eq!(university.browser().post(&second, &asks("s42")).status, 422);
    let third = code(&university, "14");
    university.browser_of("ida").post(&university.address("/roster/code/end"), &[]).to();
    assert_eq!(university.browser().get(&third).status, 422);
    assert_eq!(university.browser_of("ida").post(&university.address("/roster/code"), &[("days", "999")]).status, 400);
}

#[test]
fn what_is_missing_is_said_beside_its_field_and_no_password_comes_back() {
    let university = University::new();
    let join = code(&university, "7");
    for (wrong, said) in [
        (
            [("login", ""), ("name", "Dan"), ("new", "a few short words"), ("again", "a few short words")],
            "There is no login",
        ),
        (
            [("login", "s43"), ("name", " "), ("new", "a few short words"), ("again", "a few short words")],
            "There is no name",
        ),
        ([("login", "s43"), ("name", "Dan"), ("new", "a few short words"), ("again", "others")], "are not the same"),
        ([("login", "s43"), ("name", "Dan"), ("new", "short"), ("again", "short")], "at least 10 characters"),
    ] {
        let page = university.browser().post(&join, &wrong).text(422);
        assert!(page.contains(said) && !page.contains("a few short words"), "{page}");
    }
    assert!(waiting(&university.browser_of("ida").get(&university.address("/roster")).text(200)).is_empty());
    for typed in ["", "ABC", "ABCD-2345", "ABCD-000O"] {
        let page = university.browser().get(&format!("/join?code={typed}"));
        let page = if page.status == 303 { university.browser().get(page.to()) } else { page };
        assert_eq!(page.status, if typed.is_empty() { 200 } else { 422 }, "{typed}: {}", page.text);
    }
}
