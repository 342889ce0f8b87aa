//! A new assignment from the file of a homework: filled in, looked over, kept, and marked as `grade` marks the file.

use std::collections::BTreeMap;

use momentous::bank::{Bank, Homework};
use momentous::fault::Source;
use momentous::grade::Points;
use momentous::store::AssignmentWithItems;

use super::student::{form, right, total};
use super::university::{Browser, DAY, University};

const FILE: &str = "\
title: \"Week 3: impact\"
date: due 14 October
problems:
  - problem: impact/two-carts
    form: forward
    points: 10
    weights: { v_A2: 3, v_B2: 1, T_lost: 1 }
  - problem: impact/two-carts
    form: forward
  - problem: impulse/softball-hit
";

/// The values of the fields of a page, by their names.
fn fields(page: &str) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for tag in page.split("<input ").skip(1).map(|rest| rest.split('>').next().unwrap()) {
        let value = |name: &str| tag.split(&format!("{name}=\"")).nth(1).and_then(|rest| rest.split('"').next());
        if let (Some(name), Some(value)) = (value("name"), value("value")) {
            found.insert(name.to_owned(), value.to_owned());
        }
    }
    for select in page.split("<select name=\"item.").skip(1).map(|rest| rest.split("</select>").next().unwrap()) {
        let name = format!("item.{}", select.split('"').next().unwrap());
        let chosen = select.split("<option ").find(|option| option.contains(" selected"));
        let value = chosen.and_then(|option| option.split("value=\"").nth(1)?.split('"').next());
        found.insert(name, value.unwrap_or_default().to_owned());
    }
    found
}

/// The page that a file fills in.
fn filled_in(university: &University, ida: &mut Browser<'_>, file: &str, status: u16) -> String {
    ida.post(&university.address("/assignments/new"), &[("homework", file), ("do", "homework")]).text(status)
}

fn kept(university: &University, ida: &mut Browser<'_>, page: &str) -> AssignmentWithItems {
    let mut fields = fields(page);
    for (name, value) in
        [("opens", "2025-12-01T08:00"), ("due", "2025-12-03T18:00"), ("closes", "2025-12-04T18:00"), ("do", "save")]
    {
        fields.insert(name.to_owned(), value.to_owned());
    }
    let sent: Vec<(&str, &str)> = fields.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
    let made = ida.post(&university.address("/assignments/new"), &sent);
    assert!(made.to().ends_with("/edit?saved=yes"), "{}", made.text);
    university.wait(async |store| {
        let all = store.assignments(university.course.key).await.unwrap();
        store.assignment(all[0].key).await.unwrap().unwrap()
    })
}

#[test]
fn a_homework_becomes_an_assignment_with_the_marks_of_the_file() {
    let university = University::new();
    university.set_clock(-DAY);
    let mut ida = university.browser_of("ida");
    let page = filled_in(&university, &mut ida, FILE, 200);
    assert!(page.contains("The homework says of its date: due 14 October."), "{page}");
    let whole = kept(&university, &mut ida, &page);
    assert_eq!(whole.assignment.title, "Week 3: impact");
    let bank = Bank::built_in();
    let homework = Homework::of(&Source::new("week-3.yaml", FILE), &bank, None).unwrap();
    assert_eq!(whole.items.len(), homework.slots.len());
    for (item, slot) in whole.items.iter().zip(&homework.slots) {
        assert_eq!(
            (item.problem.as_str(), item.form.as_deref().unwrap_or_default()),
            (slot.problem.id(), slot.form_name())
        );
        assert_eq!((item.points.into(), usize::try_from(item.repeat).unwrap()), (slot.points(), slot.repeat));
    }

    university.set_clock(0);
    let mut ada = university.browser_of("ada");
    let [first, second] = [0, 1].map(|place: usize| university.address(&format!("/items/{}", whole.items[place].key)));
    ada.get(&first).text(200);
    let (_, answers) = right(&university, "ada");
    for (number, part) in ["v_A2", "v_B2"].into_iter().enumerate() {
        let named: Vec<(String, &str)> = answers
            .iter()
            .filter(|(id, _)| *id == part)
            .map(|(id, text)| (format!("answer.{id}"), text.as_str()))
            .collect();
        let fields: Vec<(&str, &str)> = named.iter().map(|(id, text)| (id.as_str(), *text)).collect();
        ada.post(&first, &form(["r1", "r2"][number], &fields)).to();
        let worth: momentous::quantity::Rational =
            ["v_A2", "v_B2"].iter().take(number + 1).fold(0.into(), |sum, part| sum + &homework.slots[0].worth[*part]);
        assert_eq!(total(&ada.get(&first).text(200)), Some(format!("{} of 10", Points(worth)).as_str()));
    }
    ada.get(&second).text(200);
    let sheets = university.wait(async |store| store.sheets_of(University::member("ada")).await).unwrap();
    let seeds: Vec<u64> = sheets.iter().map(|sheet| sheet.issued.seed).collect();
    assert!(seeds.len() == 2 && seeds[0] != seeds[1], "the second of the same problem has other numbers: {seeds:?}");
}

#[test]
fn what_is_wrong_with_a_homework_is_said_where_it_stands() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let page = filled_in(&university, &mut ida, &FILE.replace("points:", "point:"), 422);
    assert!(page.contains("did you mean `points`?") && page.contains("homework.yaml:6"), "{page}");
    assert!(page.contains("date: due 14 October"), "the file stays in its field");
    for (from, to, said) in [
        ("impulse/softball-hit", "impulse/softball", "There is no problem <code>impulse/softball</code>."),
        ("form: forward\n    points", "form: forwards\n    points", "It has no form <code>forwards</code>."),
        ("v_B2: 1", "v_C2: 1", "It does not ask for <code>v_C2</code>."),
        ("v_A2: 3, v_B2: 1, T_lost: 1", "v_A2: 0, v_B2: 0, T_lost: 0", "All its parts weigh nothing."),
    ] {
        let page = filled_in(&university, &mut ida, &FILE.replace(from, to), 422);
        assert!(page.contains(said), "{said}: {page}");
    }
    let all = university.wait(async |store| store.assignments(university.course.key).await.unwrap());
    assert!(all.is_empty(), "nothing is kept before it is kept there");
}
