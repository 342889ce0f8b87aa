//! What operators and those who teach do.

use super::university::University;

/// The link that a page shows.
fn link(page: &str) -> String {
    let (_, rest) = page.split_once("<code class=\"link\">http://127.0.0.1:8080").expect("a link");
    rest.split('<').next().unwrap().to_owned()
}

#[test]
fn an_operator_adds_a_person_who_signs_in_by_the_link() {
    let university = University::new();
    let mut olga = university.browser_of("olga");
    let page = olga.post("/people", &[("login", " zoe "), ("name", "<b>Zoe</b>")]).text(200);
    assert!(page.contains("&lt;b&gt;Zoe&lt;/b&gt;") && !page.contains("<b>Zoe"));
    let mut zoe = university.browser();
    assert_eq!(zoe.post(&link(&page), &[]).to(), "/courses");
    assert_eq!(zoe.get("/people").status, 403);
    let listed = olga.get("/people").text(200);
    assert!(listed.contains("zoe") && !listed.contains(&link(&page)), "a link is shown once");
    let page = olga.post("/people", &[("login", "otto"), ("name", ""), ("operator", "yes")]).text(200);
    let mut otto = university.browser();
    otto.post(&link(&page), &[]);
    otto.get("/people").text(200);
}

#[test]
fn a_person_who_cannot_be_added_is_told_with_the_field() {
    let university = University::new();
    let mut olga = university.browser_of("olga");
    let long = "x".repeat(201);
    for (login, said) in [
        ("", "There is no login. Write what the person signs in with"),
        ("ada", "Somebody signs in by this name already."),
        (long.as_str(), "This is longer than 200 bytes."),
        ("a\u{7}", "This has a character that cannot be printed."),
    ] {
        let page = olga.post("/people", &[("login", login), ("name", "Mr \"O\" <i>"), ("operator", "yes")]).text(422);
        assert!(page.contains(said), "{login}: {page}");
        assert!(page.contains("value=\"Mr &quot;O&quot; &lt;i&gt;\""), "what was typed stays: {page}");
        assert!(page.contains("value=\"yes\" checked"), "{page}");
    }
    assert!(olga.post("/people/link", &[("person", "nobody")]).text(422).contains("Nobody was chosen"));
    let ada = University::key("ada").to_string();
    let page = olga.post("/people/link", &[("person", &ada)]).text(200);
    assert_eq!(university.browser().post(&link(&page), &[]).status, 303);
}

#[test]
fn a_course_is_made_with_a_secret_of_its_own_and_an_instructor() {
    let university = University::new();
    let mut olga = university.browser_of("olga");
    let fields = [("title", "Mechanics & <3>"), ("zone", "Europe/Vienna"), ("decimal", "comma"), ("retention", "400")];
    let all: Vec<(&str, &str)> = fields.into_iter().chain([("login", "zoe"), ("name", "Zoe")]).collect();
    let page = olga.post("/courses/new", &all).text(200);
    let mut zoe = university.browser();
    zoe.post(&link(&page), &[]);
    assert!(zoe.get("/courses").text(200).contains("Mechanics &amp; &lt;3&gt;"));
    let courses = university.wait(async |store| store.courses().await.unwrap());
    let course = courses.iter().find(|course| course.title == "Mechanics & <3>").unwrap();
    assert!(course.secret.len() == 64 && course.secret.bytes().all(|digit| digit.is_ascii_hexdigit()));
    assert_eq!((course.zone.as_str(), course.retention_days), ("Europe/Vienna", Some(400)));
    let settings = zoe.get(&format!("/courses/{}/settings", course.key)).text(200);
    assert!(settings.contains("value=\"Europe/Vienna\"") && settings.contains("value=\"comma\" selected"));
    assert!(!settings.contains(&course.secret));
}

#[test]
fn faults_of_a_course_stand_beside_their_fields() {
    let university = University::new();
    let mut olga = university.browser_of("olga");
    let right =
        [("title", "T"), ("zone", "UTC"), ("decimal", "point"), ("retention", ""), ("login", "zoe"), ("name", "Z")];
    for (field, value, said) in [
        ("title", "", "A course has a title."),
        ("zone", "Berlin", "<code>Berlin</code> is no time zone. Write its IANA name"),
        ("zone", "<b>", "<code>&lt;b&gt;</code> is no time zone."),
        ("decimal", "dot", "Choose one of the list."),
        ("retention", "0", "Write days, from 1 to 36525"),
        ("retention", "1e9", "Write days, from 1 to 36525"),
        ("login", "", "There is no login."),
    ] {
        let typed: Vec<(&str, &str)> =
            right.iter().map(|(name, usual)| (*name, if *name == field { value } else { usual })).collect();
        let page = olga.post("/courses/new", &typed).text(422);
        assert!(page.contains(said), "{field} {value}: {page}");
        assert_eq!(page.matches("class=\"fault\"").count(), 1, "{page}");
    }
    assert!(university.wait(async |store| store.person_named("zoe").await.unwrap()).is_none(), "nothing was kept");
    let mut ida = university.browser_of("ida");
    let bad = ida.post(&university.address("/settings"), &[("title", "New"), ("zone", "x")]).text(422);
    assert!(bad.contains("value=\"New\""));
    let to = ida.post(&university.address("/settings"), &right).to().to_owned();
    assert!(ida.get(&to).text(200).contains("Saved."));
    let course = university.wait(async |store| store.course(university.course.key).await.unwrap().unwrap());
    assert_eq!((course.title.as_str(), course.secret.as_str()), ("T", university.course.secret.as_str()));
}

/// What stands in a hidden field of a page.
fn hidden(page: &str, name: &str) -> String {
    let (_, rest) = page.split_once(&format!("name=\"{name}\" value=\"")).expect("a hidden field");
    rest.split('"').next().unwrap().to_owned()
}

const TABLE: &str = "id,name,section\nada,Ada <King>,A\nzoe,\"=cmd|' /C calc'!A0\",B\n";

#[test]
fn a_roster_changes_what_was_shown_and_nothing_else() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let [preview, apply] = ["/roster/preview", "/roster/apply"].map(|path| university.address(path));
    let page = ida.post(&preview, &[("table", TABLE)]).text(200);
    for change in [
        "<th scope=\"row\">new</th><td>zoe</td>",
        "<th scope=\"row\">renamed</th><td>ada</td><td>Ada &lt;King&gt;</td><td>ada &lt;script&gt;</td>",
        "<th scope=\"row\">gone</th><td>bob</td>",
    ] {
        assert!(page.contains(change), "{change}: {page}");
    }
    assert!(
        university.wait(async |store| store.person_named("zoe").await.unwrap()).is_none(),
        "nothing is changed yet"
    );
    assert!(page.contains("id,name,section\nada,Ada &lt;King&gt;,A\n"), "{page}");
    let shown = hidden(&page, "shown");
    let other = TABLE.replace("zoe", "eve");
    assert_eq!(ida.post(&apply, &[("table", &other), ("shown", &shown)]).status, 409, "another table");
    assert_eq!(ida.post(&apply, &[("table", TABLE)]).status, 409, "nothing was shown");
    // A browser sends the ends of lines as CR LF.
    let typed = TABLE.replace('\n', "\r\n");
    assert!(ida.post(&apply, &[("table", &typed), ("shown", &shown)]).to().ends_with("/roster?done=yes"));
    assert_eq!(ida.post(&apply, &[("table", TABLE), ("shown", &shown)]).status, 409, "the changes are made already");
    let mut bob = university.browser_of("bob");
    assert_eq!(bob.get(&university.address("")).status, 404, "bob is out");
    let page = ida.get(&university.address("/roster")).text(200);
    assert!(page.contains("Ada &lt;King&gt;") && page.contains("student, left"), "{page}");
    let table = ida.post(&university.address("/roster/links"), &[]);
    assert_eq!(table.header("content-disposition"), Some("attachment; filename=\"sign-in-links.csv\""));
    let table = table.text(200);
    assert!(table.starts_with("\u{feff}id,"), "{table}");
    assert!(table.contains("zoe,'=cmd|' /C calc'!A0,B,student,http://127.0.0.1:8080/sign-in/"), "{table}");
    let link =
        table.lines().find(|line| line.starts_with("zoe")).unwrap().rsplit_once("http://127.0.0.1:8080").unwrap().1;
    let mut zoe = university.browser();
    zoe.post(link, &[]);
    zoe.get(&university.address("")).text(200);
}

#[test]
fn a_roster_renames_nobody_who_is_known_elsewhere() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let [preview, apply] = ["/roster/preview", "/roster/apply"].map(|path| university.address(path));
    let mut roster = |table: &str| {
        let page = ida.post(&preview, &[("table", table)]).text(200);
        if page.contains("name=\"shown\"") {
            ida.post(&apply, &[("table", table), ("shown", &hidden(&page, "shown"))]).to();
        }
        page
    };
    roster("id,name\nada,Ada\ncleo,Cleo\nolga,Olga\n");
    let page = roster("id,name\nada,Ada King\ncleo,Somebody\nolga,Nobody\n");
    assert!(page.contains("<td>Ada King") && !page.contains("<td>Somebody") && !page.contains("<td>Nobody"), "{page}");
    let name = |login| university.wait(async |store| store.person(University::key(login)).await.unwrap().unwrap().name);
    let expected = ["Ada King", "cleo <script>", "olga <script>"];
    assert_eq!(["ada", "cleo", "olga"].map(name), expected, "cleo is in another course, and olga runs the server");
}

#[test]
fn a_table_that_cannot_be_used_stays_with_what_is_wrong() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    for (table, said) in [
        ("", "It is empty, without even headings."),
        ("mail\na@b <i>", "There is neither a column <code>login</code> nor a column <code>id</code>."),
        ("id\nx\nx", "Line 3: <code>x</code> is already in line 2."),
        ("id,name\nada", "Line 2: the row has 1 cell"),
        ("id\nida", "<code>ida</code> teaches this course."),
    ] {
        let page = ida.post(&university.address("/roster/preview"), &[("table", table)]).text(422);
        assert!(page.contains(said), "{table}: {page}");
        assert!(page.contains(&table.replace('<', "&lt;").replace('>', "&gt;")), "{page}");
    }
}

#[test]
fn nobody_gets_a_link_for_somebody_who_may_do_more() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let table = "id\nada\nbob\nolga\ncleo\n";
    let page = ida.post(&university.address("/roster/preview"), &[("table", table)]).text(200);
    let shown = hidden(&page, "shown");
    ida.post(&university.address("/roster/apply"), &[("table", table), ("shown", &shown)]).to();
    let members = university.wait(async |store| store.members(university.course.key).await.unwrap());
    let member = |login: &str| {
        members.iter().find(|membership| membership.person.login == login).unwrap().member.key.to_string()
    };
    let link = university.address("/roster/link");
    assert_eq!(ida.post(&link, &[("member", &member("olga"))]).status, 409, "olga runs the server");
    ida.post(&link, &[("member", &member("cleo"))]).text(200);
    let table = ida.post(&university.address("/roster/links"), &[]).text(200);
    assert!(!table.contains("olga") && table.contains("cleo") && table.contains("ada"), "{table}");
    assert_eq!(ida.post(&link, &[("member", "0")]).status, 404);
}

#[test]
fn staff_are_added_and_a_course_keeps_an_instructor() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let add = university.address("/roster/staff");
    let page = ida.post(&add, &[("login", "zoe"), ("name", "Zoe"), ("role", "assistant")]).text(200);
    let mut zoe = university.browser();
    zoe.post(&link(&page), &[]);
    assert_eq!(zoe.get(&university.address("/roster")).status, 403);
    assert!(
        ida.post(&add, &[("login", "eve"), ("role", "queen")]).text(422).contains("Choose assistant or instructor.")
    );
    let demoted = ida.post(&add, &[("login", "ida"), ("role", "assistant")]).text(422);
    assert!(demoted.contains("This person is the only instructor of the course. Add another first."), "{demoted}");
    let key = University::member("ida").to_string();
    assert_eq!(ida.post(&university.address("/roster/remove"), &[("member", &key)]).status, 409);
    ida.post(&add, &[("login", "zoe"), ("role", "instructor")]).text(200);
    zoe.get(&university.address("/roster")).text(200);
    assert_eq!(ida.post(&university.address("/roster/remove"), &[("member", &key)]).status, 303);
    assert_eq!(ida.get(&university.address("")).status, 404);
}
