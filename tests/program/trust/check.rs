//! What `momentous check` says holds for `momentous generate`.

use std::fs;

use crate::room::Room;

/// A sound problem.
const SOUND: &str = include_str!("../../../problem_bank/impact/two-carts.yaml");

/// A text of it in a part of the file, with another in its place, and what is wrong with that.
const SPOILT: [(&str, &str, &str, &str); 7] = [
    ("They collide.", r"They collide. $\foo$", r"\foo", "this mathematics cannot be set"),
    ("They collide.", "They collide. ![plan](plan.png)", "![plan](plan.png)", "cannot fetch one"),
    ("They collide.", "They $v = {{ v_A1 }} %$.", "%$", "a bare % starts a comment"),
    ("They collide.", "They collide. [here](javascript:alert)", "[here]", "a link cannot lead to"),
    ("while they touch?", r"while they $\touch$?", r"\touch", "this mathematics cannot be set"),
    ("Find the velocity of each", r"Find $\velocity$ of each", r"\velocity", "this mathematics cannot be set"),
    ("Which velocity do you", r"Which {{ e | symbol }} $\do$ you", r"\do", "this mathematics cannot be set"),
];

#[test]
fn what_generate_refuses_is_told_by_check_at_the_same_place_of_the_file() {
    let room = Room::empty();
    for (old, new, wrong, message) in SPOILT {
        assert!(SOUND.contains(old), "the problem does not say `{old}`");
        let spoilt = SOUND.replacen(old, new, 1);
        fs::write(room.path("my-carts.yaml"), &spoilt).unwrap();
        let (line, column) =
            spoilt.lines().zip(1..).find_map(|(text, line)| Some((line, text.find(wrong)? + 1))).unwrap();
        let place = format!("my-carts.yaml:{line}:{column}");
        let check = room.run(&["check", "my-carts.yaml", "--seeds", "20"]);
        assert_eq!(check.code, 1, "{new}\n{}", check.out);
        let form = if old.starts_with("Which velocity") { "find-e" } else { "forward" };
        let generate = room.run(&["generate", "my-carts.yaml", "--form", form]);
        assert_eq!(generate.code, 2, "{new}");
        for said in [&check.out, &generate.err] {
            assert!(said.contains(message) && said.contains(&place), "{new}: no `{place}`, or no `{message}`\n{said}");
        }
    }
}

#[test]
fn mathematics_of_any_depth_ends_with_a_message() {
    let room = Room::empty();
    let deep = format!("${}x{}$", r"\sqrt{".repeat(3000), "}".repeat(3000));
    fs::write(room.path("my-carts.yaml"), SOUND.replacen("They collide.", &deep, 1)).unwrap();
    for command in [&["check", "my-carts.yaml", "--seeds", "2"][..], &["generate", "my-carts.yaml"]] {
        let ran = room.run(command);
        let said = format!("{}{}", ran.out, ran.err);
        assert!(ran.code == 1 || ran.code == 2, "{command:?}: {}", ran.code);
        assert!(said.contains("nests deeper than 32 levels"), "{}", said.get(..2000).unwrap_or(&said));
    }
}
