//! The secret of the course: good ones are made, bad ones are told, and each sheet says which it was.

use crate::room::{Room, lines};

/// As nobody should choose it.
const WEAK: (&str, &str) = ("weak.txt", "course 2026\n");

#[test]
fn a_secret_is_random_private_and_never_written_over() {
    let room = Room::empty();
    room.fine(&["secret", "a.txt"]);
    room.fine(&["secret", "b.txt"]);
    let [a, b] = ["a.txt", "b.txt"].map(|name| room.read(name));
    assert!(a != b && a.trim().len() == 64 && a.trim().bytes().all(|digit| digit.is_ascii_hexdigit()), "{a}");
    let again = room.run(&["secret", "a.txt"]);
    assert!(again.code == 2 && again.err.contains("already exists") && room.read("a.txt") == a, "{}", again.err);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        assert_eq!(std::fs::metadata(room.path("a.txt")).unwrap().permissions().mode() & 0o777, 0o600);
    }
}

#[test]
fn a_secret_that_can_be_guessed_is_warned_about() {
    let room = Room::with(&[WEAK]);
    room.fine(&["secret", "good.txt"]);
    let warned =
        |secret: &str| room.run(&["generate", "impact/two-carts", "--secret", secret]).err.contains("can be guessed");
    assert_eq!((warned("weak.txt"), warned("good.txt")), (true, false));
}

#[test]
fn the_mark_of_the_secret_stands_on_the_sheet() {
    let room = Room::with(&[WEAK, ("class.csv", "id\ns1\n")]);
    let with = |more: &[&str]| room.fine(&[&["generate", "impact/two-carts", "--seed", "7"], more].concat());
    // By Python, see the test of the mark itself.
    let seed = "seed 7-jdrgqf";
    for format in ["markdown", "latex", "html"] {
        let secret = ["--format", format, "--secret", "weak.txt"];
        assert!(with(&[&secret[..], &["--key"]].concat()).contains(seed), "{format}");
        assert!(!with(&["--format", format]).contains("7-"), "{format}");
    }
    let record = &lines(&with(&["--format", "json", "--secret", "weak.txt"]))[0];
    assert_eq!((&record["seed"], &record["secret"]), (&7.into(), &"jdrgqf".into()));
    assert!(lines(&with(&["--format", "json"]))[0].get("secret").is_none());
    room.fine(&["generate", "impact/two-carts", "--roster", "class.csv", "--secret", "weak.txt", "-o", "sheets/"]);
    assert!(room.read("sheets-teacher/seeds.csv").contains(",jdrgqf,"));
}

/// Answers of three students at one sheet each; some write the mark of `weak.txt` behind the seed.
fn answers(seeds: [&str; 3]) -> String {
    let row = |seed: &str| format!("s{seed},impact/two-carts,{seed},forward,1 m/s\n");
    format!("student,problem,seed,form,v_A2\n{}", seeds.map(row).concat())
}

#[test]
fn a_table_is_not_marked_with_another_secret_or_none() {
    let all = answers(["1-jdrgqf", "2-jdrgqf", "3-jdrgqf"]);
    let one = answers(["1-jdrgqf", "2", "3"]);
    let room = Room::with(&[WEAK, ("all.csv", &all), ("one.csv", &one), ("class.csv", "id\ns1\n")]);
    room.fine(&["secret", "other.txt"]);
    let grade = |more: &[&str]| room.run(&[&["grade"], more].concat());
    assert_eq!(grade(&["all.csv", "--secret", "weak.txt", "-o", "marks.csv"]).code, 1);
    for (more, message) in [(&[][..], "give it with --secret"), (&["--secret", "other.txt"], "another secret")] {
        let ran = grade(&[&["all.csv", "-o", "none.csv"], more].concat());
        assert!(ran.code == 2 && ran.err.contains(message) && ran.err.contains("nothing was marked"), "{}", ran.err);
        assert!(!room.path("none.csv").exists());
    }
    // One row among many is refused by itself.
    let ran = grade(&["one.csv"]);
    assert!(
        ran.code == 2 && ran.err.contains("one.csv:2: ") && ran.err.contains("give it with --secret"),
        "{}",
        ran.err
    );
    assert_eq!(ran.out.lines().filter(|row| row.contains(",v_A2,")).count(), 2, "{}", ran.out);
    // The table of seeds says it before any row is looked at.
    room.fine(&["generate", "impact/two-carts", "--roster", "class.csv", "--secret", "weak.txt", "-o", "s/"]);
    let sheets = ["one.csv", "--sheets", "s-teacher/seeds.csv"];
    assert!(grade(&sheets).err.contains("drawn with a secret, whose mark is `jdrgqf`"));
    let other = grade(&[&sheets[..], &["--secret", "other.txt"]].concat());
    assert!(
        other.code == 2
            && other.out.is_empty()
            && other.err.contains("seeds.csv: its sheets were drawn with the secret")
    );
    room.fine(&["generate", "impact/two-carts", "--roster", "class.csv", "-o", "open/"]);
    let open = ["one.csv", "--sheets", "open-teacher/seeds.csv", "--secret", "weak.txt"];
    assert!(grade(&open).err.contains("drawn without a secret"));
}

#[test]
fn with_a_secret_a_seed_is_known_by_its_mark_or_by_who_was_given_it() {
    let some = answers(["1-jdrgqf", "2-jdrgqf", "3"]);
    let none = answers(["1", "2", "3"]);
    let room = Room::with(&[WEAK, ("some.csv", &some), ("none.csv", &none), ("class.csv", "id\ns1\n")]);
    let grade = |more: &[&str]| room.run(&[&["grade", "--secret", "weak.txt"], more].concat());
    let ran = grade(&["some.csv"]);
    assert!(ran.code == 2 && ran.err.contains("some.csv:4: the seed 3 has no mark"), "{}", ran.err);
    assert!(ran.err.contains("on sheets drawn with the secret given it is 3-jdrgqf"), "{}", ran.err);
    assert_eq!(ran.out.lines().filter(|row| row.contains(",v_A2,")).count(), 2, "{}", ran.out);
    let ran = grade(&["none.csv", "-o", "marks.csv"]);
    assert!(ran.code == 2 && ran.err.contains("nothing was marked"), "{}", ran.err);
    assert!(!room.path("marks.csv").exists());
    // Who was given which sheet says as much as the mark.
    let generate = ["generate", "impact/two-carts", "--roster", "class.csv", "--secret", "weak.txt", "-o", "sheets/"];
    room.fine(&generate);
    let table = room.read("sheets-teacher/seeds.csv");
    let seed = table.lines().nth(1).unwrap().split(',').nth(5).unwrap().to_owned();
    std::fs::write(room.path("own.csv"), format!("student,problem,seed,v_A2\ns1,impact/two-carts,{seed},1 m/s\n"))
        .unwrap();
    for known in [["--sheets", "sheets-teacher/seeds.csv"], ["--roster", "class.csv"]] {
        let ran = grade(&[&["own.csv"][..], &known].concat());
        assert!(ran.code == 1 && ran.err.contains("1 row read: 1 marked"), "{}", ran.err);
    }
    let single = grade(&["--problem", "impact/two-carts", "--seed", "7", "--answer", "v_A2=1.00 m/s"]);
    assert!(single.code == 2 && single.out.is_empty() && single.err.contains("it is 7-jdrgqf"), "{}", single.err);
    // To make a sheet or its solution, the secret and a number are enough.
    room.fine(&["solve", "impact/two-carts", "--seed", "7", "--secret", "weak.txt"]);
}

#[test]
fn a_sheet_is_not_marked_with_another_secret() {
    let room = Room::with(&[WEAK, ("other.txt", "8f14e45fceea167a5a36dedd4bea2543\n")]);
    let commands: [&[&str]; 4] = [
        &["grade", "--problem", "impact/two-carts", "--answer", "v_A2=1.00 m/s"],
        &["solve", "impact/two-carts"],
        &["generate", "impact/two-carts"],
        &["simulate", "impact/two-carts"],
    ];
    for command in commands {
        let with = |more: &[&str]| room.run(&[command, &["--seed", "7-jdrgqf"], more].concat());
        assert!(with(&["--secret", "weak.txt"]).code < 2, "{command:?}");
        let none = with(&[]);
        assert!(none.code == 2 && none.out.is_empty() && none.err.contains("give it with --secret"), "{}", none.err);
        let other = with(&["--secret", "other.txt"]);
        assert!(other.code == 2 && other.out.is_empty() && other.err.contains("another secret"), "{}", other.err);
    }
}
