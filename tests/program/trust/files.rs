//! Files: none is written over another, none is left half, and what is the teacher's stays the teacher's.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::room::Room;

/// How long a test waits for the program at most.
const PATIENCE: Duration = Duration::from_mins(1);

#[cfg(unix)]
#[test]
fn what_is_the_teachers_lies_apart_and_only_its_owner_reads_it() {
    use std::os::unix::fs::PermissionsExt;
    let room = Room::with(&[("class.csv", "id\ns1\n")]);
    let mode = |name: &str| fs::metadata(room.path(name)).unwrap().permissions().mode() & 0o777;
    // What was there before does not open it to others.
    fs::create_dir(room.path("sheets-teacher")).unwrap();
    fs::write(room.path("sheets-teacher/key.html"), "old").unwrap();
    fs::set_permissions(room.path("sheets-teacher/key.html"), fs::Permissions::from_mode(0o644)).unwrap();
    for folder in ["sheets/", "new/"] {
        room.fine(&[
            "generate",
            "impact/two-carts",
            "--roster",
            "class.csv",
            "--key",
            "--format",
            "html",
            "-o",
            folder,
        ]);
        let teacher = format!("{}-teacher", folder.trim_end_matches('/'));
        assert_eq!(room.names(folder), ["s1-impact-two-carts-forward.html"]);
        assert_eq!(room.names(&teacher), ["key.html", "seeds.csv"]);
        for name in ["key.html", "seeds.csv"] {
            assert_eq!(mode(&format!("{teacher}/{name}")), 0o600, "{teacher}/{name}");
        }
    }
    assert_eq!(mode("new-teacher"), 0o700);
}

#[cfg(unix)]
#[test]
fn solutions_and_json_of_a_class_lie_in_the_teachers_folder() {
    use std::os::unix::fs::PermissionsExt;
    let room = Room::with(&[("class.csv", "id\ns1\n"), ("secret.txt", "b289213b44e2929520550277c6eb28ad\n")]);
    let rest = [&["--roster", "class.csv"][..], &["--seed", "1", "--secret", "secret.txt"]];
    for (options, folder) in rest.iter().zip(["class/", "one/"]) {
        let generate = |more: &[&str]| {
            room.fine(&[&["generate", "impact/two-carts", "-o", folder], *options, more].concat());
        };
        generate(&["--solution"]);
        generate(&["--format", "json"]);
        let teacher = format!("{}-teacher", folder.trim_end_matches('/'));
        for name in room.names(folder) {
            assert!(!name.contains("solution") && !name.contains("json"), "{folder}{name}");
        }
        let apart = room.names(&teacher);
        for ending in ["-solution.md", "-solution-1.svg", ".json"] {
            let found = apart.iter().find(|name| name.ends_with(ending)).expect(ending);
            let mode = fs::metadata(room.path(&format!("{teacher}/{found}"))).unwrap().permissions().mode();
            assert_eq!(mode & 0o777, 0o600, "{found}");
        }
    }
    // What everybody can draw has its solution beside it.
    room.fine(&["generate", "impact/two-carts", "--solution", "-o", "open/"]);
    assert!(room.names("open").iter().any(|name| name.ends_with("-solution.md")));
}

#[cfg(unix)]
#[test]
fn a_link_that_waits_for_the_temporary_file_is_not_followed() {
    let room = Room::with(&[("class.csv", "problem,seed,v_A2\nimpact/two-carts,1,1 m/s\n"), ("victim", "precious")]);
    fs::create_dir(room.path("shared")).unwrap();
    // The number of the next process, as far as it can be guessed.
    for process in std::process::id()..std::process::id() + 3000 {
        let link = room.path(&format!("shared/.marks.csv.{process}.tmp"));
        std::os::unix::fs::symlink("../victim", link).unwrap();
    }
    room.run(&["grade", "class.csv", "-o", "shared/marks.csv"]);
    assert_eq!(room.read("victim"), "precious");
    assert!(room.read("shared/marks.csv").starts_with("line,"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_signal_leaves_no_temporary_file() {
    let program = assert_cmd::cargo::cargo_bin("momentous");
    for signal in ["INT", "TERM", "HUP"] {
        let room = Room::empty();
        let arguments = ["impact/two-carts", "--count", "100000000", "--format", "json", "-o", "all/a.jsonl"];
        let mut child = std::process::Command::new("env")
            .args(["--default-signal=INT,TERM,HUP", program.to_str().unwrap(), "generate"])
            .args(arguments)
            .current_dir(room.0.path())
            .spawn()
            .unwrap();
        let start = Instant::now();
        while fs::read_dir(room.path("all")).map_or(0, Iterator::count) == 0 {
            assert!(start.elapsed() < PATIENCE, "nothing is written");
            std::thread::sleep(Duration::from_millis(5));
        }
        let kill = std::process::Command::new("kill").args(["-s", signal, &child.id().to_string()]).status();
        assert!(kill.unwrap().success());
        assert!(!child.wait().unwrap().success());
        assert_eq!(room.names("all"), [] as [&str; 0], "after {signal}");
    }
}

#[test]
fn every_student_has_a_file_of_his_own() {
    let room = Room::with(&[("class.csv", "id,name\na b,Alice\na/b,Bob\na-b-2,Carol\nA-B-2,Dora\n")]);
    for format in ["html", "json"] {
        room.fine(&[
            "generate",
            "impact/two-carts",
            "--roster",
            "class.csv",
            "--format",
            format,
            "-o",
            &format!("{format}/"),
        ]);
        let folder = if format == "json" { "json-teacher" } else { format };
        let mut names = room.names(folder);
        names.retain(|name| name != "seeds.csv");
        let capitals: std::collections::BTreeSet<String> = names.iter().map(|name| name.to_lowercase()).collect();
        assert_eq!((names.len(), capitals.len()), (4, 4), "{names:?}");
        for student in ["Alice", "Bob", "Carol", "Dora"] {
            let names_student = |name: &&String| room.read(&format!("{folder}/{name}")).contains(student);
            assert_eq!(names.iter().filter(names_student).count(), 1, "{student}");
        }
        // The table says which is whose.
        let seeds = room.read(&format!("{format}-teacher/seeds.csv"));
        for name in &names {
            let stem = name.trim_end_matches(&format!(".{format}")).to_owned();
            assert!(seeds.lines().any(|row| row.ends_with(&format!(",{stem}"))), "{stem}\n{seeds}");
        }
    }
}

/// A problem with another identity, in a file of that name.
fn problem(room: &Room, file: &str, id: &str) {
    let text = include_str!("../../../problem_bank/impact/two-carts.yaml");
    fs::write(room.path(file), text.replacen("id: impact/two-carts", &format!("id: {id}"), 1)).unwrap();
}

#[test]
fn two_problems_have_files_of_their_own() {
    let room = Room::empty();
    problem(&room, "a.yaml", "impact/my-carts");
    problem(&room, "b.yaml", "impact-my/carts");
    room.fine(&["generate", "a.yaml", "b.yaml", "--count", "2", "-o", "sheets/"]);
    let sheets = room
        .names("sheets")
        .into_iter()
        .filter(|name| Path::new(name).extension() == Some(OsStr::new("md")))
        .collect::<Vec<_>>();
    assert_eq!(sheets.len(), 4, "{sheets:?}");
    let of = |id: &str| sheets.iter().filter(|name| room.read(&format!("sheets/{name}")).contains(id)).count();
    assert_eq!((of("impact/my-carts"), of("impact-my/carts")), (2, 2));
}

#[test]
fn a_run_with_two_documents_of_one_name_writes_nothing() {
    let room = Room::with(&[("class.csv", "id\ns\ns-p\n")]);
    problem(&room, "a.yaml", "x/y");
    problem(&room, "b.yaml", "p/x/y");
    problem(&room, "twin.yaml", "x/y");
    // `s` with p/x/y and `s-p` with x/y; and two files with one identity.
    let runs: [&[&str]; 2] = [
        &["generate", "a.yaml", "b.yaml", "--roster", "class.csv", "-o", "s/"],
        &["generate", "a.yaml", "twin.yaml", "-o", "s/"],
    ];
    for arguments in runs {
        fs::write(room.path("twin.yaml"), room.read("a.yaml").replace("They collide.", "They meet.")).unwrap();
        let ran = room.run(arguments);
        assert!(ran.code == 2 && ran.err.contains("two documents would be written to"), "{arguments:?}\n{}", ran.err);
        assert!(!room.path("s").exists() && !room.path("s-teacher").exists(), "{arguments:?}");
    }
}

#[test]
fn a_table_of_seeds_is_not_lost_and_old_sheets_are_named() {
    let room = Room::with(&[("class.csv", "id\ns1\ns2\n")]);
    let generate = |problems: &[&str]| {
        let rest = ["--roster", "class.csv", "--solution", "-o", "sheets/"];
        room.run(&[&["generate"], problems, &rest].concat())
    };
    assert_eq!(generate(&["impact/two-carts"]).code, 0);
    let table = room.read("sheets-teacher/seeds.csv");
    let other = generate(&["bouncing/rubber-ball"]);
    assert!(
        other.code == 2 && other.err.contains("seed of impact/two-carts forward, which would be lost"),
        "{}",
        other.err
    );
    assert_eq!(room.read("sheets-teacher/seeds.csv"), table);
    fs::write(room.path("class.csv"), "id\ns2\ns3\n").unwrap();
    let later = generate(&["impact/two-carts", "bouncing/rubber-ball"]);
    assert_eq!(later.code, 0, "{}", later.err);
    for left in ["sheets/s1-impact-two-carts-forward.md", "sheets-teacher/s1-impact-two-carts-forward-solution.md"] {
        assert!(later.err.contains(left), "{left}\n{}", later.err);
    }
    assert!(!later.err.contains("s2-") && !later.err.contains("s3-"), "{}", later.err);
}

#[test]
fn seeds_of_another_secret_are_not_lost() {
    let room =
        Room::with(&[("class.csv", "id,name\ns1,\n=x,\n"), ("a.txt", "course 2026\n"), ("b.txt", "course 2027\n")]);
    let generate = |more: &[&str]| {
        room.run(&[&["generate", "impact/two-carts", "--roster", "class.csv", "-o", "sheets/"], more].concat())
    };
    let first = generate(&["--secret", "a.txt"]);
    assert_eq!(first.code, 0, "{}", first.err);
    let files = || (room.read("sheets-teacher/seeds.csv"), room.read("sheets/s1-impact-two-carts-forward.md"));
    let before = files();
    for other in [&["--secret", "b.txt"][..], &[], &["--secret", "a.txt", "--derivation", "1"]] {
        let ran = generate(other);
        assert!(ran.code == 2 && ran.err.contains("another secret, derivation or scheme"), "{other:?}: {}", ran.err);
        assert_eq!(files(), before);
    }
    let again = generate(&["--secret", "a.txt"]);
    assert_eq!((again.code, files()), (0, before), "{}", again.err);
}

#[cfg(unix)]
#[test]
fn a_link_does_not_lead_the_key_elsewhere() {
    let room = Room::with(&[("class.csv", "id\ns1\n"), ("precious", "precious"), ("class-teacher/old.csv", "")]);
    std::os::unix::fs::symlink("../precious", room.path("class-teacher/key.md")).unwrap();
    room.fine(&["generate", "impact/two-carts", "--roster", "class.csv", "--key", "-o", "class/"]);
    assert_eq!(room.read("precious"), "precious");
    assert!(
        room.read("class-teacher/key.md").starts_with("# Answers") && !room.path("class-teacher/key.md").is_symlink()
    );
}

#[test]
fn no_sheet_is_made_where_nobody_will_know_whose_it_is() {
    let room = Room::with(&[("class.csv", "id\ns1\n"), ("class-teacher", "a file\n")]);
    let ran = room.run(&["generate", "impact/two-carts", "--roster", "class.csv", "-o", "class/"]);
    assert!(ran.code == 2 && ran.err.contains("class-teacher cannot be made"), "{}", ran.err);
    assert!(!room.path("class").exists());
}

#[test]
fn nothing_is_written_over_what_is_read() {
    let table = "student,problem,seed,v_A2\ns,impact/two-carts,1,1 m/s\n";
    let room = Room::with(&[("class.csv", "id\ns1\n"), ("a.csv", table), ("b/secret.txt", "course 2026\n")]);
    problem(&room, "own.yaml", "own/carts");
    let roster = ["generate", "impact/two-carts", "--roster", "class.csv"];
    room.fine(&[&roster[..], &["-o", "sheets/"]].concat());
    let grade = ["grade", "a.csv"];
    let runs: [(&[&str], &[&str]); 11] = [
        (&grade, &["-o", "a.csv"]),
        (&grade, &["-o", "b/../a.csv"]),
        (&grade, &["-o", "x.xml", "--junit", "./x.xml"]),
        (&grade, &["-o", "x.json", "--summary", "x"]),
        (&grade, &["-o", "sheets-teacher/seeds.csv", "--sheets", "sheets-teacher/seeds.csv"]),
        (&grade, &["-o", "own.yaml", "--problem", "own.yaml"]),
        (&roster, &["-o", "class.csv"]),
        (&["generate", "own.yaml"], &["--secret", "b/secret.txt", "-o", "b/secret.txt"]),
        (&["simulate", "own.yaml"], &["-o", "own.yaml"]),
        (&["chart"], &["--from", "a.csv", "-o", "a.csv"]),
        (&["generate", "impact/two-carts", "--roster", "sheets-teacher/seeds.csv"], &["-o", "sheets/"]),
    ];
    let files = ["class.csv", "a.csv", "b/secret.txt", "own.yaml", "sheets-teacher/seeds.csv"];
    let before = files.map(|name| room.read(name));
    for (command, more) in runs {
        let ran = room.run(&[command, more].concat());
        assert!(ran.code == 2 && ran.err.contains("it would be lost"), "{command:?} {more:?}\n{}", ran.err);
        assert_eq!(files.map(|name| room.read(name)), before, "{command:?} {more:?}");
    }
    assert!(!room.names(".").iter().any(|name| name.starts_with('x')), "{:?}", room.names("."));
    // What is no file may be named as often as one likes.
    #[cfg(unix)]
    assert_eq!(room.run(&["grade", "a.csv", "-o", "/dev/null", "--junit", "/dev/null"]).code, 1);
}

#[cfg(unix)]
#[test]
fn a_link_among_submissions_is_not_followed() {
    let submission = "student: s\nproblem: impact/two-carts\nseed: 1\nanswers: { v_A2: 1 m/s }\n";
    let room = Room::with(&[("all/a.yaml", submission), ("private.yaml", "password: swordfish\n")]);
    std::os::unix::fs::symlink("../private.yaml", room.path("all/b.yaml")).unwrap();
    let ran = room.run(&["grade", "all", "--junit", "junit.xml"]);
    assert!(
        ran.err.contains("all/b.yaml: this is a link") && ran.err.contains("1 marked (3 answers), 1 refused"),
        "{}",
        ran.err
    );
    assert!(![ran.err, room.read("junit.xml")].concat().contains("password"));
}
