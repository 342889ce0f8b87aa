//! Texts of others: no sign in them is obeyed.

use std::fs;

use crate::room::Room;

/// Sets the title of a terminal's window.
const TITLE: &str = "\u{1b}]0;pwned\u{7}";

#[test]
fn no_message_holds_a_control_character() {
    let room = Room::with(&[
        ("cells.csv", &format!("problem,seed,v\n\"{TITLE}\",1,1\nimpact/two-carts,{TITLE},1\n")),
        ("class.csv", &format!("id\n{TITLE}\n{TITLE}\n")),
        ("bad.yaml", &format!("id: a/b\n\"{TITLE}\": 3\ntitle: \"{TITLE}\"\n")),
    ]);
    let named = format!("{TITLE}.yaml");
    fs::write(room.path(&named), "id: [").unwrap();
    let runs: [&[&str]; 6] = [
        &["grade", "cells.csv"],
        &["generate", "impact/two-carts", "--roster", "class.csv", "-o", "a/"],
        &["generate", "bad.yaml"],
        &["generate", &named],
        &["generate", TITLE],
        &["generate", "impact/two-carts", "--seed", TITLE],
    ];
    for arguments in runs {
        let ran = room.run(arguments);
        let obeyed: Vec<char> = ran.err.chars().filter(|sign| sign.is_control() && *sign != '\n').collect();
        assert!(!ran.err.is_empty() && obeyed.is_empty(), "{arguments:?}: {obeyed:?}\n{}", ran.err);
    }
}
