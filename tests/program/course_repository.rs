//! A course repository: how it begins, what its CI sees, and that nothing is green by mistake.

use std::fs;
use std::process::Command;

use crate::room::{Ran, Room};

const CARTS: &str = include_str!("../../problem_bank/impact/two-carts.yaml");
const STONES: &str = include_str!("../../problem_bank/impact/curling-stones.yaml");

fn repository(files: &[(&str, &str)]) -> Room {
    let bank = [("problem_bank/impact/two-carts.yaml", CARTS), ("problem_bank/impact/curling-stones.yaml", STONES)];
    let room = Room::with(&[&bank[..], files].concat());
    git(&room, &["init", "-q"]);
    commit(&room);
    room
}

fn git(room: &Room, arguments: &[&str]) {
    let identity = ["-c", "user.name=a", "-c", "user.email=a@b.example"];
    let ran = Command::new("git").current_dir(room.path(".")).args(identity).args(arguments).output().unwrap();
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
}

fn commit(room: &Room) {
    git(room, &["add", "-A"]);
    git(room, &["commit", "-q", "-m", "a state"]);
}

fn change(room: &Room, path: &str, old: &str, new: &str) {
    let text = room.read(path);
    assert!(text.contains(old), "{old}");
    fs::write(room.path(path), text.replacen(old, new, 1)).unwrap();
}

fn check(room: &Room, more: &[&str]) -> Ran {
    room.run(&[&["check", "--seeds", "20"], more].concat())
}

#[test]
fn the_last_lines_name_what_fails_and_reports_say_the_same() {
    let room = repository(&[]);
    change(&room, "problem_bank/impact/two-carts.yaml", "unit: kg }", "unit: kgg }");
    let ran = check(&room, &["--annotations", "--junit", "check.xml"]);
    assert_eq!(ran.code, 2);
    let last = ran.out.lines().last().unwrap();
    assert!(
        last.starts_with("failed: problem_bank/impact/two-carts.yaml:14:43: the unit `kgg` is not known; did you"),
        "{last}"
    );
    assert!(
        ran.out.contains("\n::error file=problem_bank/impact/two-carts.yaml,line=14,col=43::the unit `kgg`"),
        "{}",
        ran.out
    );
    let junit = room.read("check.xml");
    assert!(junit.contains("tests=\"2\" failures=\"1\"") && junit.contains("the unit `kgg` is not known"), "{junit}");
}

#[test]
fn a_promise_that_is_broken_is_named_at_the_end() {
    let room = repository(&[("problem_bank/impact/pass.yaml", include_str!("../fixtures/found/passes_through.yaml"))]);
    let ran = check(&room, &["--quiet"]);
    assert_eq!(ran.code, 1);
    let last = ran.out.lines().last().unwrap();
    assert!(last.starts_with("failed: problem_bank/impact/pass.yaml: ") && last.contains("broken: "), "{}", ran.out);
    assert!(last.contains("`allow: [passes-through]`") && !ran.out.contains("curling-stones"), "{}", ran.out);
}

#[test]
fn quiet_says_nothing_of_what_is_well() {
    let ran = check(&repository(&[]), &["--quiet"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, "2 problems, 4 forms: every promise that was checked holds\n"));
}

#[test]
fn one_broken_file_stops_no_other() {
    let room = repository(&[("problem_bank/impact/zwin.yaml", CARTS), ("problem_bank/impact/no.yaml", "id: [")]);
    fs::write(room.path("problem_bank/impact/bytes.yaml"), [0xff, 0xfe]).unwrap();
    let ran = check(&room, &["--quiet"]);
    assert_eq!(ran.code, 2);
    for said in [
        "zwin.yaml: `impact/two-carts` is also the identity of",
        "no.yaml:1:",
        "bytes.yaml: this cannot be read: it is not UTF-8",
    ] {
        assert!(ran.out.contains(&format!("failed: problem_bank/impact/{said}")), "{said}\n{}", ran.out);
    }
    assert!(ran.out.contains("5 problems, 4 forms: 3 problems broken"), "{}", ran.out);
}

#[test]
fn only_what_a_change_may_touch_is_checked() {
    let room = repository(&[("templates/html/sheet.tera", include_str!("../../templates/html/sheet.tera"))]);
    let counted =
        |room: &Room| check(room, &["--quiet", "--changed-since", "HEAD"]).out.lines().last().unwrap().to_owned();
    assert!(counted(&room).starts_with("0 problems"), "{}", counted(&room));
    assert!(check(&room, &["--changed-since", "HEAD"]).err.contains("note: no problem has changed since HEAD"));
    change(&room, "problem_bank/impact/two-carts.yaml", "They collide.", "They meet.");
    assert!(counted(&room).starts_with("1 problem, "), "{}", counted(&room));
    commit(&room);
    // A new problem, a setting and a template are changes, too.
    fs::write(room.path("problem_bank/impact/new.yaml"), CARTS.replacen("impact/two-carts", "impact/new", 1)).unwrap();
    assert!(counted(&room).starts_with("1 problem, "), "{}", counted(&room));
    fs::write(room.path("problem_bank/course.yaml"), "symbols: { momentum: L }\n").unwrap();
    assert!(counted(&room).starts_with("3 problems, "), "{}", counted(&room));
    commit(&room);
    change(&room, "templates/html/sheet.tera", "<", " <");
    assert!(counted(&room).starts_with("3 problems, "), "{}", counted(&room));
    let unknown = check(&room, &["--changed-since", "no-such-branch"]);
    assert!(unknown.code == 2 && unknown.err.contains("help: name a revision"), "{}", unknown.err);
}

#[test]
fn the_course_is_found_from_its_folders_and_the_built_in_bank_is_told() {
    let room = repository(&[
        ("templates/markdown/document.tera", "OUR LOOKS"),
        ("problem_bank/course.yaml", "symbols: { momentum: L }\n"),
    ]);
    let within = |arguments: &[&str]| {
        let program = assert_cmd::cargo::cargo_bin!("momentous");
        let ran = Command::new(program).current_dir(room.path("problem_bank/impact")).args(arguments).output().unwrap();
        [ran.stdout, ran.stderr].map(|text| String::from_utf8(text).unwrap()).concat()
    };
    assert!(within(&["check", "--seeds", "5", "-q"]).contains("2 problems, 4 forms"));
    assert!(within(&["generate", "two-carts.yaml"]).contains("OUR LOOKS"));
    let elsewhere = Room::with(&[]).run(&["check", "--load"]);
    assert!(elsewhere.err.contains("note: there is no folder problem_bank with problems here"), "{}", elsewhere.err);
}

#[test]
fn a_template_that_nobody_would_use_is_told() {
    for (path, near) in [
        ("templates/html/shet.tera", "html/sheet.tera"),
        ("templates/html/stile.css", "html/style.css"),
        ("templates/htm/sheet.tera", "html"),
    ] {
        let room = repository(&[(path, "text")]);
        let ran = room.run(&["generate", "impact/two-carts", "--format", "html"]);
        assert!(ran.code == 2 && ran.err.contains(&format!("did you mean `{near}`?")), "{path}: {}", ran.err);
    }
    let body = "{% include \"html/logo.tera\" %}";
    let repository_here = repository(&[("templates/html/logo.tera", "LOGO"), ("templates/html/body.tera", body)]);
    assert!(repository_here.fine(&["generate", "impact/two-carts", "--format", "html"]).contains("LOGO"));
}

#[test]
fn what_editors_and_systems_leave_is_passed_over() {
    let room = repository(&[("problem_bank/impact/._two-carts.yaml", "\0\0"), ("problem_bank/.hidden.yaml", CARTS)]);
    assert_eq!(check(&room, &["--quiet"]).code, 0);
}

#[test]
fn a_new_repository_is_sound_as_it_stands() {
    let room = Room::with(&[("course/README.md", "ours")]);
    let said = room.fine(&["init", "course"]);
    assert!(said.contains("README.md exists; it was not changed") && room.read("course/README.md") == "ours", "{said}");
    let again = room.fine(&["init", "course"]);
    assert_eq!(again.matches("exists; it was not changed").count(), 10, "{again}");
    let ran = Command::new(assert_cmd::cargo::cargo_bin!("momentous"))
        .current_dir(room.path("course"))
        .args(["check", "--seeds", "20", "-q"])
        .output()
        .unwrap();
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stdout));
    for job in [".github/workflows/problems.yml", ".gitlab-ci.yml"] {
        let text = room.read(&format!("course/{job}"));
        assert!(serde_yaml::from_str::<serde_yaml::Value>(&text).is_ok() && text.contains("momentous check --quiet"));
    }
}

#[test]
fn problems_and_templates_are_printed_and_written() {
    let room = Room::with(&[]);
    assert_eq!(room.fine(&["show", "impact/two-carts"]), CARTS);
    let course = repository(&[("problem_bank/impact/curling-stones.yaml", "id: impact/curling-stones\n")]);
    assert_eq!(
        course.fine(&["show", "impact/curling-stones"]),
        "id: impact/curling-stones\n",
        "the course's own first"
    );
    let built_in = course.fine(&["show", "impulse/lift-cable"]);
    assert_eq!(built_in, include_str!("../../problem_bank/impulse/lift-cable.yaml"));
    assert!(course.run(&["show", "impact/curling-stone"]).err.contains("did you mean `impact/curling-stones`?"));
    assert!(room.fine(&["templates"]).contains("html/sheet.tera\n"));
    room.fine(&["templates", "html/sheet.tera", "--write"]);
    assert_eq!(room.read("templates/html/sheet.tera"), include_str!("../../templates/html/sheet.tera"));
    let near = room.run(&["templates", "html/shet.tera"]);
    assert!(near.code == 2 && near.err.contains("did you mean `html/sheet.tera`?"), "{}", near.err);
}

#[test]
fn a_name_in_other_capitals_is_taken_for_the_one_that_is_there() {
    let room = repository(&[]);
    for (old, new, said) in [
        ("m_B: { min", "m_b: { min", "did you mean `m_B`?"),
        ("mass: m_A", "mass: m_a", "did you mean `m_A` by `m_a`? Capitals count"),
    ] {
        change(&room, "problem_bank/impact/two-carts.yaml", old, new);
        let checked = check(&room, &["-q"]);
        assert!(checked.code == 2 && checked.out.contains(said), "{}", checked.out);
        fs::write(room.path("problem_bank/impact/two-carts.yaml"), CARTS).unwrap();
    }
}

#[test]
fn marking_says_of_an_authors_own_answers_what_is_expected() {
    let room = repository(&[]);
    let expect = "{ find: v_A2, expect: { \"-0.5 m/s\": right, \"0.5 m/s\": sense, \"0.77 m/s\": wrong },";
    change(&room, "problem_bank/impact/two-carts.yaml", "{ find: v_A2,", expect);
    let seeds = ["generate", "impact/two-carts", "--seed", "1", "--format", "json"];
    assert!(room.fine(&seeds).contains("\"printed\":\"-0.500 m/s\""));
    assert_eq!(check(&room, &["-q"]).code, 0);
    room.fine(&["snapshot", "--accept"]);
    assert!(room.read("snapshots/impact/two-carts.marks.csv").contains(",expected: sense,0.5 m/s,sense,1/2"));
    change(&room, "problem_bank/impact/two-carts.yaml", "\"0.77 m/s\": wrong", "\"0.77 m/s\": sense");
    let other = check(&room, &["-q"]);
    assert_eq!(other.code, 1);
    assert!(other.out.contains("`v_A2` = 0.77 m/s is marked wrong (0/2), not sense: with seed 1 the"), "{}", other.out);
    change(&room, "problem_bank/impact/two-carts.yaml", "\"0.77 m/s\": sense", "\"0.77 m/s\": wring");
    let unknown = check(&room, &["-q"]);
    assert!(unknown.out.contains("a verdict `wring`, which there is not, did you mean `wrong`?"), "{}", unknown.out);
}

#[test]
fn a_note_is_acknowledged_in_the_file_with_a_reason() {
    let room = repository(&[]);
    let noted = |room: &Room, outcome: &str| {
        let said =
            room.run(&["check", "impact/two-carts", "--seeds", "64", "--simulated", "1", "--format", "json"]).out;
        said.matches(&format!("\"promise\":\"sharp\",\"outcome\":\"{outcome}\"")).count()
    };
    assert_eq!((noted(&room, "noted"), noted(&room, "acknowledged")), (1, 0));
    let reason = "title:";
    change(
        &room,
        "problem_bank/impact/two-carts.yaml",
        reason,
        "acknowledge: { sharp: rounding is what it is about }\ntitle:",
    );
    assert_eq!((noted(&room, "noted"), noted(&room, "acknowledged")), (0, 1));
    let told = room.run(&["check", "impact/two-carts", "--seeds", "64", "--simulated", "1"]).out;
    assert!(told.contains("acknowledged in the file: sharp") && !told.contains("noted:"), "{told}");
    change(
        &room,
        "problem_bank/impact/two-carts.yaml",
        "{ sharp: rounding is what it is about }",
        "{ sharpp: so, told: \"\" }",
    );
    let faults = check(&room, &["-q"]).out;
    assert!(faults.contains("nothing is noted of a promise `sharpp`; did you mean `sharp`?"), "{faults}");
    assert!(faults.contains("the note on `told` is acknowledged without a reason"), "{faults}");
}
