//! What a link opens: a course's the course, the operator's all that is somebody's.

use momentous::course::{Key, Member, Role};
use momentous::store::Entry;

use super::university::{Answer, Browser, University};

/// The fields of a new password.
const NEW: [(&str, &str); 2] = [("new", "a few short words"), ("again", "a few short words")];

/// Ada in the second course, too, and Cleo its instructor.
fn in_both() -> University {
    let university = University::new();
    let member = |login: &str, role| Member {
        key: Key::new([if role == Role::Student { 70 } else { 71 }; 16]),
        course: university.other.key,
        person: University::key(login),
        role,
        section: String::new(),
        left: None,
    };
    let also = [member("ada", Role::Student), member("bob", Role::Instructor)];
    university.wait(async |store| store.save_members(&[], &also, &University::entry(60)).await.unwrap());
    university
}

/// The path of a link that a page shows.
fn shown(page: &Answer) -> String {
    let link = page.text.split("class=\"link\">").nth(1).unwrap_or_else(|| panic!("{}", page.text));
    let link = link.split('<').next().unwrap();
    link[link.find("/sign-in/").unwrap()..].to_owned()
}

/// The link that the instructor of the second course makes for Ada.
fn link_of_other(university: &University) -> String {
    let address = format!("/courses/{}/roster/link", university.other.key);
    let page = university.browser_of("bob").post(&address, &[("member", &Key::<Member>::new([70; 16]).to_string())]);
    assert!(page.text.contains("It opens Mechanics 2 and no other course"), "{}", page.text);
    shown(&page)
}

fn signed_in<'u>(university: &'u University, link: &str) -> Browser<'u> {
    let mut browser = university.browser();
    assert_eq!(browser.post(link, &[]).to(), "/courses");
    browser
}

fn trail(university: &University, course: Key<momentous::course::Course>) -> Vec<String> {
    let all = university.wait(async |store| store.trail(course, 100).await.unwrap());
    all.into_iter().map(|Entry { what, .. }| what).collect()
}

#[test]
fn the_link_of_a_course_opens_that_course_and_nothing_else() {
    let university = in_both();
    let whole = university.assignment(&[("impact/two-carts", "forward", 10)], |_| {});
    let item = university.address(&format!("/items/{}", whole.items[0].key));
    let mut ada = university.browser_of("ada");
    let mine = "the words that I chose";
    ada.post("/account/password", &[("new", mine), ("again", mine)]).to();
    let mut taken = signed_in(&university, &link_of_other(&university));
    taken.get(&format!("/courses/{}", university.other.key)).text(200);
    let courses = taken.get("/courses").text(200);
    assert!(courses.contains("Mechanics 2") && !courses.contains("Mechanics &lt;1&gt;"), "{courses}");
    assert!(courses.contains("You signed in by the link of one course") && !courses.contains("name=\"new\""));
    for address in [&item, &university.address("")] {
        assert_eq!(taken.get(address).status, 404, "{address}");
    }
    assert_eq!(taken.post(&item, &[("answer.v_A2", "9.00 m/s")]).status, 404);
    assert_eq!(taken.post("/account/password", &NEW).status, 403);
    ada.get(&item).text(200);
    let of_first = trail(&university, university.course.key);
    for what in ["link created in another course", "signed in by a link", "password changed"] {
        assert!(of_first.iter().any(|deed| deed == what), "{what}: {of_first:?}");
    }
}

#[test]
fn who_runs_the_server_does_not_by_the_link_of_a_course() {
    let university = University::new();
    let member = Member {
        key: Key::new([72; 16]),
        course: university.course.key,
        person: University::key("olga"),
        role: Role::Student,
        section: String::new(),
        left: None,
    };
    let other = Member { key: Key::new([73; 16]), course: university.other.key, ..member.clone() };
    university.wait(async |store| store.save_members(&[], &[member, other], &University::entry(61)).await.unwrap());
    let reach = momentous::store::Reach::Course(university.course.key);
    let mut olga = university.browser_reaching("olga", reach);
    olga.get(&university.address("")).text(200);
    for address in ["/people", "/courses/new"] {
        assert_eq!(olga.get(address).status, 403, "{address}");
    }
    assert_eq!(olga.post("/account/password", &NEW).status, 403);
}

#[test]
fn whoever_is_in_one_course_chooses_a_password_by_its_link() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let link = university.address("/roster/link");
    let member = University::member("ada").to_string();
    let page = ida.post(&link, &[("member", &member)]);
    let mut ada = signed_in(&university, &shown(&page));
    ada.post("/account/password", &NEW).to();
    ada.get(&university.address("")).text(200);
    let again = ida.post(&link, &[("member", &member)]);
    let mut forgotten = signed_in(&university, &shown(&again));
    let other = [("new", "other words here"), ("again", "other words here")];
    assert!(forgotten.post("/account/password", &other).text(422).contains("The old password is not right"));
}

#[test]
fn a_forgotten_password_is_replaced_by_a_link_of_the_operator() {
    let university = in_both();
    let mut ada = university.browser_of("ada");
    ada.post("/account/password", &NEW).to();
    let person = University::key("ada").to_string();
    let page = university.browser_of("olga").post("/people/link", &[("person", &person)]);
    let mut forgotten = signed_in(&university, &shown(&page));
    assert!(!forgotten.get("/courses").text(200).contains("name=\"old\""), "it is not asked for the old one");
    let other = [("new", "other words here"), ("again", "other words here")];
    forgotten.post("/account/password", &other).to();
    forgotten.get(&university.address("")).text(200);
    assert!(forgotten.post("/account/password", &NEW).text(422).contains("The old password is not right"));
    assert_eq!(ada.get("/courses").status, 303, "every other session has ended");
    for course in [university.course.key, university.other.key] {
        let trail = trail(&university, course);
        for what in ["link created by the operator", "signed in by a link", "password changed"] {
            assert!(trail.iter().any(|deed| deed == what), "{what}: {trail:?}");
        }
    }
}

#[test]
fn links_lead_where_the_server_was_told_that_it_is_and_else_say_that_they_do_not() {
    let university = University::new();
    let member = University::member("ada").to_string();
    let link = university.address("/roster/link");
    let page = university.browser_of("ida").post(&link, &[("member", &member)]).text(200);
    assert!(page.contains("http://127.0.0.1:8080/sign-in/") && page.contains("works on this machine only"), "{page}");
}
