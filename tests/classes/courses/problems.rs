//! Problems of a course, written and checked in the browser.

use std::path::PathBuf;

use momentous::bank::Bank;
use momentous::web::Settings;

use super::university::{Browser, University};

/// A problem file that loads.
fn file() -> String {
    let text = Bank::built_in().find("impact/two-carts").unwrap().text.to_string();
    text.replacen("id: impact/two-carts", "id: own/carts", 1)
}

/// Keeps the file as a draft, and says where it is.
fn draft(university: &University, ida: &mut Browser<'_>) -> String {
    ida.post(&university.address("/problems/new"), &[("text", &file())]).to().to_owned()
}

#[test]
fn a_file_with_faults_stays_in_its_field_and_each_fault_has_its_excerpt() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let new = university.address("/problems/new");
    let text = file().replacen("find: v_A2", "find: v_A9", 1);
    let page = ida.post(&new, &[("text", &text)]).text(422);
    let line = 1 + text.lines().position(|line| line.contains("v_A9")).unwrap();
    assert!(page.contains(&format!("problem.yaml:{line}:")) && page.contains("`v_A9`"), "{page}");
    assert!(page.contains("id: own/carts"), "what was typed stays");
    for text in ["", "</textarea><script>alert(1)</script>", "id: ../../etc/passwd\ntitle: x", "&a [*a, *a]"] {
        let page = ida.post(&new, &[("text", text)]).text(422);
        assert!(!page.contains("<script>alert"), "{page}");
    }
    ida.post(&new, &[("text", "\u{0}")]).text(400);
    assert!(university.wait(async |store| store.problem_files(university.course.key).await.unwrap()).is_empty());
    let from = ida.get(&format!("{new}?from=impact/two-carts")).text(200);
    assert!(from.contains("id: impact/two-carts"));
    assert_eq!(ida.get(&format!("{new}?from=no/such")).status, 404);
}

#[test]
fn a_file_is_previewed_as_it_stands_and_nothing_of_it_is_kept() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let preview = university.address("/problems/preview");
    let page = ida.post(&preview, &[("text", &file())]).text(200);
    assert_eq!(page.matches("<h2>Seed ").count(), 3);
    assert!(page.contains("id: own/carts"), "what was typed stays: {page}");
    let wrong = ida.post(&preview, &[("text", &file().replacen("find: v_A2", "find: v_A9", 1))]).text(422);
    assert!(wrong.contains("`v_A9`") && !wrong.contains("<h2>Seed "), "{wrong}");
    assert!(university.wait(async |store| store.problem_files(university.course.key).await.unwrap()).is_empty());
}

#[test]
fn a_problem_is_seen_by_instructors_of_its_course_and_offered_once_published() {
    let university = University::new();
    let mut ida = university.browser_of("ida");
    let page = draft(&university, &mut ida);
    let shown = ida.get(&page).text(200);
    assert_eq!(shown.matches("<h2>Seed ").count(), 3);
    assert!(shown.contains("A draft"));
    let escaped = file()
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace('\'', "&#39;");
    assert!(shown.contains(&format!("\n{escaped}</textarea>")), "its file is shown line by line: {shown}");
    let new = university.address("/assignments/new");
    let search = [("search", "own/carts"), ("do", "search")];
    assert!(!ida.post(&new, &search).text(200).contains("value=\"own/carts\" "), "a draft is not offered");
    assert_eq!(ida.post(&format!("{page}/publish"), &[]).to(), page);
    assert!(ida.post(&new, &search).text(200).contains("name=\"add\" value=\"own/carts\""));
    assert!(ida.get(&university.address("/problems")).text(200).contains("own/carts"));
    let mut nobody = university.browser();
    assert_eq!(nobody.get("/practice/own/carts").status, 404);
    for login in ["ada", "ann", "cleo"] {
        assert!(matches!(university.browser_of(login).get(&page).status, 403 | 404), "{login}");
    }
    let digest = page.rsplit('/').next().unwrap();
    let elsewhere = format!("/courses/{}/problems/{digest}", university.other.key);
    assert_eq!(ida.get(&elsewhere).status, 404);
    // The same text again is the same version, which stays published.
    assert_eq!(draft(&university, &mut ida), page);
    assert!(ida.get(&page).text(200).contains("Published"));
}

#[test]
fn a_check_runs_as_the_command_line_does() {
    let program = Some(PathBuf::from(env!("CARGO_BIN_EXE_momentous")));
    let university = University::with(Settings { program, ..Settings::default() });
    let mut ida = university.browser_of("ida");
    let page = draft(&university, &mut ida);
    let checked = ida.post(&format!("{page}/check"), &[]).text(200);
    assert!(checked.contains("Every promise that was checked holds."), "{checked}");
    assert!(checked.contains("forward: 100 seeds"), "{checked}");
}

#[cfg(unix)]
#[test]
fn a_file_is_read_and_checked_with_little_memory_and_time_and_without_secrets() {
    use std::os::unix::fs::PermissionsExt;

    let folder = tempfile::tempdir().unwrap();
    let script = folder.path().join("program");
    let made = |text: &str| {
        std::fs::write(&script, format!("#!/bin/sh\n{text}\n")).unwrap();
        std::fs::set_permissions(&script, std::fs::Permissions::from_mode(0o755)).unwrap();
    };
    let university = University::with(Settings { program: Some(script.clone()), ..Settings::default() });
    let mut ida = university.browser_of("ida");
    made("exit 0");
    let check = format!("{}/check", draft(&university, &mut ida));
    made(
        "echo \"memory $(ulimit -v) time $(ulimit -t) file $(ulimit -f)\"; echo \"$@\"; echo \"${HOME-no home}\"; echo '<b>'; exit 1",
    );
    let page = ida.post(&check, &[]).text(200);
    for said in [
        "A promise is broken.",
        "memory 4000000 time 60 file 4096",
        "check problem_bank/problem.yaml --seeds 100",
        "no home",
        "&lt;b&gt;",
    ] {
        assert!(page.contains(said), "{said}: {page}");
    }
    made("kill -9 $$");
    assert!(ida.post(&check, &[]).text(200).contains("took too much memory or processor time and was ended"));
    made("while :; do echo much; done");
    assert!(ida.post(&check, &[]).text(200).contains("was ended"), "a report has a bound");
    let new = university.address("/problems/new");
    made("echo \"$@ within $(ulimit -t) s, ${HOME-no home}\"; exit 2");
    let page = ida.post(&new, &[("text", "id: a")]).text(422);
    assert!(page.contains("check --load problem.yaml within 10 s, no home") && page.contains("id: a"), "{page}");
    made("kill -9 $$");
    let page = ida.post(&new, &[("text", "id: a")]).text(422);
    assert!(page.contains("takes more than 10 seconds or too much memory") && page.contains("id: a"), "{page}");
}
