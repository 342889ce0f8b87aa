//! Rosters, and what is handed to a student about the student.

use momentous::course::{
    Course, Member, Override, OverrideRule, Person, Role, RosterChange, RosterRow, StudentData, roster_changes,
    roster_records,
};
use momentous::grade::DecimalMark;

use super::class::{Desk, ZONE, at, form, key, policy, text};

fn member(byte: u8, login: &str, name: &str, section: &str, role: Role) -> (Member, Person) {
    let person = Person { key: key(byte), login: login.into(), name: name.into(), operator: false, erased: None };
    let section = section.to_owned();
    (Member { key: key(byte), course: key(1), person: person.key, role, section, left: None }, person)
}

fn course() -> Vec<(Member, Person)> {
    let mut left = member(4, "s4", "Dan", "A", Role::Student);
    left.0.left = Some(at("2026-11-01T10:00"));
    vec![
        member(1, "s1", "Ada", "A", Role::Student),
        member(2, "s2", "Bob", "A", Role::Student),
        member(3, "s3", "Cy", "B", Role::Student),
        left,
        member(5, "prof", "Prof", "", Role::Instructor),
    ]
}

/// What a table would change, in words.
fn changes(table: &str) -> Vec<String> {
    let said = |change: RosterChange| match change {
        RosterChange::New { row } => format!("new {}", row.login),
        RosterChange::Back { row, .. } => format!("back {}", row.login),
        RosterChange::Renamed { from, to, .. } => format!("renamed {from} {to}"),
        RosterChange::Moved { from, to, .. } => format!("moved {from} {to}"),
        RosterChange::Gone { name, .. } => format!("gone {name}"),
    };
    let rows = RosterRow::all(table).unwrap();
    roster_changes(&rows, &course()).unwrap().into_iter().map(said).collect()
}

#[test]
fn a_roster_says_what_it_would_change() {
    assert_eq!(changes("login,name,section\ns1,Ada,A\ns2,Bob,A\ns3,Cy,B\n"), Vec::<String>::new());
    assert_eq!(
        changes("id;name;section\ns6;Eve;C\ns4;Dan;B\ns1;Ada L.;A\ns2;;B\n"),
        ["new s6", "back s4", "renamed Ada Ada L.", "moved A B", "gone Cy"]
    );
    let rows = RosterRow::all("login\ns1\nprof\n").unwrap();
    assert_eq!(roster_changes(&rows, &course()).unwrap_err(), ["prof"]);
}

#[test]
fn every_row_that_is_wrong_is_told_with_its_line() {
    for (table, fault) in [
        ("name\nAda\n", "there is neither a column `login` nor a column `id`"),
        ("login\n", "there are no students"),
        ("", "it is empty, without even headings"),
        ("login,name\n,Ada\n", "line 2: this student has no login"),
        ("login,name\na,A\nb\n", "line 3: the row has 1 cell, and there are 2 headings"),
        ("login,name\na,\"A\u{7}\"\n", "line 2: `A\\u{7}` has a character that cannot be printed"),
    ] {
        assert_eq!(RosterRow::all(table).unwrap_err(), [fault], "{table}");
    }
    let long = format!("login\n{}\n", "x".repeat(201));
    assert!(RosterRow::all(&long).unwrap_err()[0].ends_with("is longer than 200 bytes"));
}

#[test]
fn a_roster_that_was_applied_changes_nothing_more() {
    let rows = RosterRow::all("login,name,section\ns6,Eve,C\ns7,Flo,C\ns4,Dan D.,B\ns1,Ada L.,B\ns2,Bob,A\n").unwrap();
    let course = course();
    let all = roster_changes(&rows, &course).unwrap();
    let elsewhere = Person { key: key(77), login: "s7".into(), name: "Florence".into(), operator: false, erased: None };
    let mut next = 200_u8;
    let mut random = || {
        next += 1;
        [next; 16]
    };
    let now = at("2026-11-20T10:00");
    let records = roster_records(&all, (key(1), &course), std::slice::from_ref(&elsewhere), now, &mut random);
    assert_eq!(records.members.iter().filter(|membership| membership.person == elsewhere.key).count(), 1);
    assert!(records.people.iter().all(|person| person.key != elsewhere.key), "another course does not rename people");
    // By hand, as storage would: what has a known key is replaced.
    let mut after = course.clone();
    for changed in &records.members {
        match after.iter_mut().find(|(member, _)| member.key == changed.key) {
            Some((member, _)) => *member = changed.clone(),
            None => {
                let person =
                    records.people.iter().chain([&elsewhere]).find(|person| person.key == changed.person).unwrap();
                after.push((changed.clone(), person.clone()));
            }
        }
    }
    for renamed in &records.people {
        after
            .iter_mut()
            .filter(|(_, person)| person.key == renamed.key)
            .for_each(|(_, person)| *person = renamed.clone());
    }
    let again = roster_changes(&rows, &after).unwrap();
    let is_florence =
        |change: &RosterChange| matches!(change, RosterChange::Renamed { from, .. } if from == "Florence");
    assert!(again.len() == 1 && is_florence(&again[0]), "{again:?}");
    let of = |byte: u8| after.iter().find(|(member, _)| member.key == key(byte)).unwrap();
    assert_eq!((of(3).0.left, of(4).0.left, of(4).1.name.as_str()), (Some(now), None, "Dan D."));
    assert_eq!((of(1).0.section.as_str(), of(1).1.name.as_str()), ("B", "Ada L."));
}

#[test]
fn what_a_student_is_handed_has_no_seed_and_nothing_that_is_not_released() {
    let (ada, person) = member(1, "s1", "Ada", "A", Role::Student);
    let course = Course {
        key: key(1),
        title: "Mechanics".into(),
        zone: ZONE.into(),
        decimal: DecimalMark::Point,
        secret: "very secret".into(),
        retention_days: None,
        grading: momentous::course::Grading::default(),
        created: at("2026-11-01T10:00"),
    };
    let hidden = momentous::course::PolicyForm { verdicts: "at_close".into(), ..form() };
    let mut desk = Desk::new(&text(), policy(&hidden), 1);
    desk.hand_in(["-0.5 m/s", "9 m/s", ""], "2026-11-25T10:00").unwrap();
    let other = Desk::new(&text(), policy(&hidden), 2);
    let set = Override {
        sheet: desk.sheet.key,
        points: Some("3".into()),
        rule: OverrideRule::Exactly,
        reason: "viva".into(),
        comment: "well said".into(),
        by: key(9),
        at: desk.policy.opens,
    };
    let sheets = [(desk.worked(), vec![set]), (other.worked(), Vec::new())];
    let json = |local: &str| {
        let data = StudentData::of((&course, &ada, &person), &sheets, &[], &[], at(local));
        serde_json::to_string(&data).unwrap()
    };
    let before = json("2026-11-25T11:00");
    assert!(before.contains("-0.5 m/s") && before.contains("Cart A"), "{before}");
    for word in ["seed", "secret", "verdict", "viva", "well said", &desk.sheet.issued.digest] {
        assert!(!before.contains(word), "{word}: {before}");
    }
    let after = json("2026-12-04T18:00");
    assert!(
        after.contains("\"verdict\":\"right\"")
            && after.contains("viva")
            && after.contains("well said")
            && !after.contains("very secret"),
        "{after}"
    );
    assert_eq!(serde_json::from_str::<serde_json::Value>(&after).unwrap()["sheets"].as_array().map(Vec::len), Some(1));
}
