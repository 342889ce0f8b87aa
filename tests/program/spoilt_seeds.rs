//! Seeds of which a spreadsheet has left the first digits: found, and told whole where it is known whose they are.

use std::fs;

use crate::room::{Ran, Room};

/// Marks a table of right answers to seed 1.
fn grade(room: &Room, rows: &[String], more: &[&str]) -> Ran {
    fs::write(room.path("class.csv"), format!("student,problem,seed,form,v_A2\n{}\n", rows.join("\n"))).unwrap();
    room.run(&[&["grade", "class.csv", "-o", "marks.csv"], more].concat())
}

fn row(student: &str, seed: &str, form: &str) -> String {
    format!("{student},impact/two-carts,{seed},{form},-0.500 m/s")
}

#[test]
fn a_seed_that_a_spreadsheet_spoilt_is_told_whole() {
    let room = Room::with(&[("roster.csv", "id,name\nann,Ann\nbob,Bob\n")]);
    room.fine(&["generate", "impact/two-carts", "--roster", "roster.csv", "--format", "html", "-o", "sheets/"]);
    let seeds = room.read("sheets-teacher/seeds.csv");
    let words: Vec<&str> = seeds.lines().skip(1).filter_map(|line| line.split(',').nth(5)).collect();
    let [ann, bob] = words[..] else { panic!("{seeds}") };
    let digits = |word: &str| word.strip_prefix('s').expect("a large seed is a word").to_owned();
    // As a spreadsheet shows a number, and as it saves what it shows.
    let power = |word: &str| format!("{:.5e}", digits(word).parse::<f64>().unwrap()).replace('e', "E+");
    let saved = |word: &str| format!("{}", power(word).parse::<f64>().unwrap());
    assert!(room.read("sheets/ann-impact-two-carts-forward.html").contains(&format!("seed {ann}")), "{seeds}");
    let rows = [row("ann", ann, "forward"), row("bob", &digits(bob), ""), row("bob", &power(bob), "")];
    for known in [["--sheets", "sheets-teacher/seeds.csv"], ["--roster", "roster.csv"]] {
        let ran = grade(&room, &[rows.to_vec(), vec![row("ann", &saved(ann), "forward")]].concat(), &known);
        assert!(ran.err.contains("4 rows read: 2 marked (6 answers), 2 refused"), "{}", ran.err);
        for (line, word, student) in [(4, bob, "bob"), (5, ann, "ann")] {
            let told = format!("that of the sheet of `{student}` is {word}");
            let said =
                ran.err.lines().find(|line_said| line_said.contains(&format!("class.csv:{line}:"))).unwrap_or_default();
            assert!(said.contains("is what a spreadsheet leaves of a seed") && said.contains(&told), "{}", ran.err);
        }
    }
    let alone = grade(&room, &[row("ann", &power(ann), ""), row("ann", &saved(ann), ""), row("ann", "7", "")], &[]);
    assert!(alone.err.contains("3 rows read: 1 marked (3 answers), 2 refused"), "{}", alone.err);
    assert!(alone.err.contains("copy the seed from the sheet"), "{}", alone.err);
    // A table of seeds that was spoilt can be made again in its place.
    fs::write(room.path("sheets-teacher/seeds.csv"), seeds.replace(ann, &power(ann))).unwrap();
    let spoilt = grade(&room, &rows[..1], &["--sheets", "sheets-teacher/seeds.csv"]);
    assert!(spoilt.code == 2 && spoilt.err.contains("make the table again with the roster"), "{}", spoilt.err);
    room.fine(&["generate", "impact/two-carts", "--roster", "roster.csv", "--format", "html", "-o", "sheets/"]);
    assert_eq!(room.read("sheets-teacher/seeds.csv"), seeds);
}
