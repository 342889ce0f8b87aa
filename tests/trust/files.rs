//! Files: none is written over another, none is left half, and what is the teacher's stays the teacher's.

use std::fs;
use std::time::{Duration, Instant};

use super::room::Room;

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
