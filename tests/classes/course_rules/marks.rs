//! Marks of a class, their table, their statistics, and the problems that an assignment reserves.

use momentous::bank::Bank;
use std::collections::BTreeMap;

use momentous::course::{
    Accounts, Assignment, Correction, CorrectionChoice, Extension, GradeMark, Gradebook, Item, Kind, Ledger, Member,
    Override, OverrideRule, Person, Regraded, Regrading, Reserved, Role, Sheet, StoredReport, effects, statistics,
};
use momentous::quantity::Rational;
use proptest::prelude::*;

use super::class::{Desk, at, form, item, key, policy, problem, text};

const DAY: &str = "2026-11-25T10:00";

fn student(byte: u8, name: &str) -> (Member, Person) {
    let person = Person { key: key(byte), login: format!("s{byte}"), name: name.into(), operator: false, erased: None };
    let section = "A".to_owned();
    let member =
        Member { key: key(byte), course: key(1), person: person.key, role: Role::Student, section, left: None };
    (member, person)
}

fn by_hand(desk: &Desk, points: Option<&str>) -> Override {
    let points = points.map(str::to_owned);
    let (reason, comment) = ("viva".into(), "well said".into());
    let rule = OverrideRule::Exactly;
    Override { sheet: desk.sheet.key, points, rule, reason, comment, by: key(9), at: desk.policy.closes }
}

fn correction(item: &Item, choice: CorrectionChoice, never_lower: bool) -> Correction {
    let (reason, comment) = ("a wrong sign".into(), String::new());
    Correction { item: item.key, from: "a".into(), to: "b".into(), choice, never_lower, reason, comment, at: at(DAY) }
}

/// The records of some desks.
struct Records {
    sheets: Vec<Sheet>,
    last: BTreeMap<momentous::course::Key<Sheet>, StoredReport>,
}

impl Records {
    fn of(desks: &[&Desk]) -> Self {
        let sheets = desks.iter().map(|desk| desk.sheet.clone()).collect();
        let last = desks.iter().filter_map(|desk| Some((desk.sheet.key, desk.reports.last()?.clone())));
        Self { sheets, last: last.collect() }
    }

    fn accounts<'a>(
        &'a self,
        items: &'a [Item],
        corrections: &'a [Correction],
        by_hand: &'a [Override],
    ) -> Accounts<'a> {
        Accounts::of(Ledger { items, corrections, sheets: &self.sheets, last: &self.last, by_hand })
    }
}

fn row(book: &Gradebook, place: usize) -> Vec<String> {
    let points = |mark: &GradeMark| mark.points().map_or("missing".to_owned(), ToString::to_string);
    book.rows[place].marks.iter().map(points).collect()
}

#[test]
fn marks_are_exact_and_by_hand_before_all() {
    let students = [student(1, "Ada"), student(2, "=cmd()"), student(3, "Cy")];
    let students: Vec<(&Member, &Person)> = students.iter().map(|(member, person)| (member, person)).collect();
    let [mut ada, mut bob] = [1, 2].map(|member| Desk::new(&text(), policy(&form()), member));
    ada.hand_in(["-0.5 m/s", "9 m/s", ""], DAY).unwrap();
    bob.hand_in(["9 m/s", "8 m/s", ""], DAY).unwrap();
    let items = [item(1, 7), item(0, 10), Item { dropped: true, ..item(2, 5) }];
    let records = Records::of(&[&ada, &bob]);
    let nothing = Gradebook::of(&records.accounts(&items, &[], &[]), &students);
    assert_eq!(
        nothing.columns.iter().map(|column| column.heading.as_str()).collect::<Vec<_>>(),
        ["1 impact/two-carts", "2 impact/two-carts"]
    );
    assert_eq!(
        (row(&nothing, 0), row(&nothing, 1), row(&nothing, 2), nothing.out_of),
        (
            vec!["4".to_owned(), "missing".to_owned()],
            vec!["0".to_owned(), "missing".to_owned()],
            vec!["missing".to_owned(), "missing".to_owned()],
            17
        )
    );
    let set = [by_hand(&bob, Some("10/3")), by_hand(&ada, Some("9")), by_hand(&ada, None)];
    let full = [correction(&items[0], CorrectionChoice::FullMarks, false)];
    let book = Gradebook::of(&records.accounts(&items, &full, &set), &students);
    assert_eq!(
        (row(&book, 0), row(&book, 1)),
        (vec!["4".to_owned(), "7".to_owned()], vec!["10/3".to_owned(), "7".to_owned()])
    );
    assert_eq!(book.rows[1].total.to_string(), "31/3");
    let accounts = records.accounts(&items, &full, &set);
    let [adas, bobs] = [&students[0], &students[1]].map(|(member, _)| accounts.account(member.key));
    let said = |said: &Option<momentous::course::Said>| said.as_ref().map(|said| said.reason.clone());
    assert_eq!(
        (adas.total.to_string().as_str(), bobs.total.to_string().as_str()),
        ("11", "31/3"),
        "as in the gradebook"
    );
    assert_eq!(
        (said(&bobs.standings[0].by_hand), said(&bobs.standings[1].corrected)),
        (Some("viva".into()), Some("a wrong sign".into()))
    );
    assert_eq!(adas.standings[2].mark, GradeMark::Dropped);
    let old = [Item { issue: 2, ..item(0, 10) }];
    let anew = Gradebook::of(&records.accounts(&old, &[], &[]), &students);
    assert_eq!(row(&anew, 0), ["missing"], "sheets of an issue before do not count");
    let csv = book.to_csv();
    assert_eq!(
        csv,
        "\
login,name,section,1 impact/two-carts,2 impact/two-carts,total,out_of
s1,Ada,A,4,7,11,17
s2,'=cmd(),A,3.333333,7,10.333333,17
s3,Cy,A,,7,7,17
"
    );
    let read = book.read_csv(&csv).unwrap();
    assert!(book.differing(&read).is_empty());
    assert_eq!(read[2].marks[0], None);
    let changed = book.read_csv(&csv.replace("s1,Ada,A,4", "s1,Ada,A,4.5")).unwrap();
    assert_eq!(book.differing(&changed), ["s1"]);
    let faults = book.read_csv(&csv.replace("A,4,7,11,", "A,four,7,11,").replace("7,7,17", "7,,17")).unwrap_err();
    assert_eq!(faults, ["line 2: `four` is no number of points", "line 4: there is no total"]);
    assert_eq!(book.read_csv("login,total\ns1,4\n").unwrap_err(), ["there is no column `1 impact/two-carts`"]);
}

proptest! {
    #[test]
    fn a_table_of_any_names_and_points_is_read_back(
        names in prop::collection::vec("[=+@a-z\"',;\n -]{0,8}", 1..5),
        above in 0..1000_u32,
        below in 1..1000_u32,
    ) {
        let students: Vec<(Member, Person)> = (1..).zip(&names).map(|(byte, name)| student(byte, name)).collect();
        let pairs: Vec<(&Member, &Person)> = students.iter().map(|(member, person)| (member, person)).collect();
        let desk = Desk::new(&text(), policy(&form()), 1);
        let points = (Rational::from(above) / Rational::from(below)).to_string();
        let set = by_hand(&desk, Some(&points));
        let (items, set) = ([item(0, 1000)], [set]);
        let book = Gradebook::of(&Records::of(&[&desk]).accounts(&items, &[], &set), &pairs);
        let read = book.read_csv(&book.to_csv()).unwrap();
        prop_assert_eq!(read.len(), names.len());
        prop_assert!(book.differing(&read).is_empty());
    }
}

/// A correction that never lowers: by the corrected problem the answer is worth less, and new sheets are worth nothing yet.
#[test]
fn a_regrade_can_be_told_to_lower_nobodys_points() {
    let mut desk = Desk::new(&text(), policy(&form()), 1);
    desk.hand_in(["-0.5 m/s", "9 m/s", ""], DAY).unwrap();
    let less = text().replace("v_A2, unit: m/s, points: 2", "v_A2, unit: m/s, points: 1");
    let effect = &effects(&[desk.worked()], &desk.policy, Some(&problem(&less)))[0];
    let (records, items) = (Records::of(&[&desk]), [item(0, 10)]);
    let accounts = records.accounts(&items, &[], &[]);
    let after = |choice, never_lower| {
        let Regraded { mark, keeps } = accounts.regraded(effect, &items[0], Regrading { choice, never_lower });
        (mark.points().map(ToString::to_string), keeps.map(|points| points.to_string()))
    };
    let some = |points: &str| Some(points.to_owned());
    // By hand: 2 of 5 parts' points are 4 of 10, and 1 of 4 are 5/2.
    assert_eq!(after(CorrectionChoice::Remark, false), (some("5/2"), None));
    assert_eq!(after(CorrectionChoice::Remark, true), (some("4"), some("4")));
    assert_eq!(after(CorrectionChoice::FullMarks, true), (some("10"), None));
    assert_eq!(after(CorrectionChoice::Drop, true), (None, None));
    assert_eq!(after(CorrectionChoice::IssueAnew, false), (None, None));
    assert_eq!(after(CorrectionChoice::IssueAnew, true), (some("4"), some("4")));
    // Full marks stay where the next correction lowers nothing.
    let full = correction(&items[0], CorrectionChoice::FullMarks, false);
    for (never_lower, points) in [(true, "10"), (false, "4")] {
        let both = [full.clone(), correction(&items[0], CorrectionChoice::Remark, never_lower)];
        let standing = records.accounts(&items, &both, &[]).standing(key(1), &items[0]);
        assert_eq!(standing.mark.points().unwrap().to_string(), points);
    }
}

#[test]
fn statistics_count_what_was_typed_and_score_what_counts() {
    let mut desks: Vec<Desk> = (1..=4).map(|member| Desk::new(&text(), policy(&form()), member)).collect();
    for desk in &mut desks[..2] {
        desk.hand_in(["-0.5 m/s", "4.0 m/s", "67.5 J"], DAY).unwrap();
    }
    desks[0].hand_in(["", "", "33.75 J"], DAY).unwrap();
    for desk in &mut desks[2..] {
        desk.hand_in(["9 m/s", "8..1 m/s", "67.5 J"], DAY).unwrap();
    }
    let students: Vec<(Member, Person)> = (1..=4).map(|byte| student(byte, "S")).collect();
    let students: Vec<(&Member, &Person)> = students.iter().map(|(member, person)| (member, person)).collect();
    let (items, set) = ([item(0, 10)], [by_hand(&desks[3], Some("10"))]);
    let records = Records::of(&desks.iter().collect::<Vec<_>>());
    let accounts = records.accounts(&items, &[], &set);
    let book = Gradebook::of(&accounts, &students);
    let found = statistics(&accounts, &book, desks.iter().map(|desk| (&desk.sheet, desk.reports.as_slice())));
    // By hand: (2 + 2 + 9/10) 2, (2 + 2) 2, 0, and 10 by hand, of 10 each.
    assert_eq!((found.students, found.items[0].mean.to_string().as_str()), (4, "139/20"));
    assert_eq!(found.mean.unwrap().to_string(), "139/200");
    let all = found.parts;
    let part = |id: &str| all.items.iter().find(|item| item.item.part == id).unwrap();
    // Four first attempts; the second of one student has one answer that was typed. It is worth 9/10 of its point.
    assert_eq!((all.students, all.rows.read, part("v_A2").answers, part("T_lost").answers), (4, 5, 4, 5));
    assert!((part("v_A2").facility - 0.5).abs() < 1e-12 && (part("T_lost").facility - 0.9 / 4.0).abs() < 1e-12);
    assert_eq!((part("T_lost").mistakes[0].mistake, part("T_lost").mistakes[0].count), ("half-forgotten", 4));
    assert_eq!((part("T_lost").wrong[0].answer.as_str(), part("T_lost").wrong[0].count), ("67.5 joules", 4));
    assert!(part("v_A2").discrimination.is_some_and(|value| value > 0.9));
    assert_eq!(
        part("v_B2").verdicts.iter().find(|count| count.verdict == "unreadable").map(|count| count.count),
        Some(2)
    );
}

#[test]
fn problems_of_open_assignments_are_reserved_for_all_but_staff() {
    let assignment =
        Assignment { key: key(1), course: key(1), title: "One".into(), policy: policy(&form()), pinned: None };
    let items = [item(0, 10), Item { problem: "impact/dropped".into(), dropped: true, ..item(1, 10) }];
    let late = Extension {
        assignment: assignment.key,
        member: key(2),
        due: at("2026-12-05T18:00"),
        late_until: None,
        closes: at("2026-12-06T18:00"),
        reason: "ill".into(),
    };
    let elsewhere = Extension { assignment: key(7), closes: at("2026-12-20T18:00"), ..late.clone() };
    for (local, reserved) in [
        ("2026-11-23T07:59", false),
        ("2026-11-23T08:00", true),
        ("2026-12-03T18:00", true),
        ("2026-12-06T18:01", true),
        ("2026-12-06T18:02", false),
    ] {
        let mut refused = Reserved::default();
        refused.add(&assignment, &items, &[late.clone(), elsewhere.clone()], at(local));
        assert_eq!(refused.refuses("impact/two-carts", false), reserved, "{local}");
        assert!(!refused.refuses("impact/two-carts", true) && !refused.refuses("impact/dropped", false));
    }
}

#[test]
fn scenes_of_the_simulators_are_known() {
    let bank = Bank::built_in();
    let simulator = |id: &str| Kind::of(problem(&bank.find(id).unwrap().text).loaded()).simulator();
    assert_eq!(simulator("impact/two-carts"), Some("collision"));
    assert_eq!(simulator("bouncing/rubber-ball"), Some("restitution"));
    assert_eq!(simulator("streams/moon-lander"), None);
}
