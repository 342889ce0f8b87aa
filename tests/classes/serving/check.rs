//! `momentous serve check` finds what is wrong, and says the way out.

use std::fs;
use std::path::Path;

use momentous::store::sqlx;
use momentous::store::sqlx::{AnyConnection, Connection, Executor};

use super::server::{Server, folder, run};

/// A check on an address that is free.
fn check(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let all = [&["serve", "check", "--bind", "127.0.0.1:0", "--data", "data"], arguments].concat();
    run(folder, &all)
}

/// Carries out a statement in the database of the folder.
fn execute(folder: &Path, statement: &'static str) {
    let url = format!("sqlite://{}", folder.join("data/momentous.sqlite").display());
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    sqlx::any::install_default_drivers();
    runtime.block_on(async { AnyConnection::connect(&url).await.unwrap().execute(statement).await.unwrap() });
}

/// A connection that holds the database locked.
fn locked(folder: &Path) -> (tokio::runtime::Runtime, AnyConnection) {
    let url = format!("sqlite://{}", folder.join("data/momentous.sqlite").display());
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    sqlx::any::install_default_drivers();
    let mut connection = runtime.block_on(AnyConnection::connect(&url)).unwrap();
    runtime.block_on(connection.execute("BEGIN IMMEDIATE")).unwrap();
    (runtime, connection)
}

#[test]
fn a_new_folder_is_fine_and_is_not_made() {
    let room = folder();
    let (code, said) = check(room.path(), &[]);
    assert_eq!(code, 0, "{said}");
    assert!(said.contains("note   data is empty") && !said.contains("wrong"), "{said}");
    assert!(!room.path().join("data").exists(), "a check makes nothing");
}

#[test]
fn what_is_wrong_is_said_with_the_way_out() {
    let room = folder();
    fs::create_dir_all(room.path().join("templates/web")).unwrap();
    fs::write(room.path().join("problem_bank/impact/broken.yaml"), "title: no scene\n").unwrap();
    fs::write(room.path().join("file"), "").unwrap();
    for (arguments, what, help) in [
        (
            &["--no-courses"][..],
            "problem_bank/impact/broken.yaml",
            "help: `momentous check problem_bank/impact/broken.yaml`",
        ),
        (&["--bind", "0.0.0.0:0"], "passwords and answers go through the network", "--base-url https://"),
        (&["--base-url", "https://a.b"], "every reader seems to come from the proxy", "--trusted-proxy 127.0.0.1"),
        (&["--base-url", "http://a.b"], "passwords and answers go through the network", "--base-url https://"),
        (&["--bind", "127.0.0.1:9", "--metrics", "127.0.0.1:9"], "both to be served on 127.0.0.1:9", "--metrics"),
        (&["--data", "file"], "file is a file, and no folder", "--data"),
        (
            &["--smtp", "smtp://127.0.0.1:1", "--mail-from", "a@b.c"],
            "nothing says where readers reach it",
            "--base-url",
        ),
        (
            &["--base-url", "https://a.b", "--smtp", "smtp://127.0.0.1:1", "--mail-from", "a@b.c"],
            "the server of mail cannot be used",
            "compare --smtp",
        ),
        (&["--base-url", "https://a.b", "--smtp", "a.b", "--mail-from", "a@b.c"], "smtp://127.0.0.1:25", "examples"),
        (
            &["--data", "postgres://u:hidden@127.0.0.1:1/d"],
            "PostgreSQL at 127.0.0.1:1/d: the database",
            "see whether the database runs",
        ),
    ] {
        let all = [&["serve", "check"], arguments].concat();
        let (code, said) = run(room.path(), &all);
        assert_eq!(code, 1, "{arguments:?}: {said}");
        assert!(said.contains(what) && said.contains(help) && !said.contains("hidden"), "{arguments:?}: {said}");
    }
    let (_, said) = run(room.path(), &["serve", "check", "--bind", "0.0.0.0:0", "--base-url", "https://a.b"]);
    assert!(!said.contains("passwords"), "{said}");
}

#[test]
fn a_template_that_is_not_filled_is_told() {
    let room = folder();
    fs::create_dir_all(room.path().join("own/web")).unwrap();
    let (code, said) = check(room.path(), &["--templates", "own"]);
    assert_eq!(code, 0, "{said}");
    // The first cannot be read, the second is read and has nothing to be filled with.
    for text in ["{% block main", "{{ page.nothing.at_all }}"] {
        fs::write(room.path().join("own/web/practice.tera"), text).unwrap();
        let (code, said) = check(room.path(), &["--templates", "own"]);
        assert!(code == 1 && said.contains("practice.tera") && said.contains("help: mend the template"), "{said}");
    }
}

#[test]
#[cfg(unix)]
fn a_folder_that_others_read_is_told() {
    use std::os::unix::fs::PermissionsExt;
    let room = folder();
    Server::start(room.path()).stop();
    assert_eq!(check(room.path(), &[]).0, 0, "the server makes it private");
    fs::set_permissions(room.path().join("data"), fs::Permissions::from_mode(0o755)).unwrap();
    let (code, said) = check(room.path(), &[]);
    assert!(code == 1 && said.contains("mode 755") && said.contains("help: chmod 700 data"), "{said}");
}

#[test]
fn a_folder_that_is_served_is_locked() {
    let room = folder();
    let server = Server::start(room.path());
    let (code, said) = check(room.path(), &[]);
    assert!(code == 1 && said.contains("another server works on data"), "{said}");
    let running = ["serve", "check", "--bind", &server.address, "--data", "data", "--running"];
    let (code, said) = run(room.path(), &running);
    assert!(code == 0 && said.contains("answers, and keeps what it is given"), "{said}");
    // What nobody can write to is told, although it answers: here another program holds it locked.
    let held = locked(room.path());
    // What was kept a moment ago counts for a second.
    let mut said = run(room.path(), &running);
    for _ in 0..100 {
        if said.0 == 0 {
            said = run(room.path(), &running);
        }
    }
    assert!(said.0 == 1 && said.1.contains("says: 503 the database"), "{}", said.1);
    drop(held);
    let taken = run(room.path(), &["serve", "check", "--bind", &server.address, "--data", "other"]);
    assert!(taken.0 == 1 && taken.1.contains("cannot be used"), "{}", taken.1);
    server.stop();
    let (code, said) = check(room.path(), &["--running"]);
    assert!(code == 1 && said.contains("no server works on data"), "{said}");
}

#[test]
fn later_data_and_a_clock_that_is_behind_are_told() {
    let room = folder();
    Server::start(room.path()).stop();
    execute(room.path(), "UPDATE trail SET at = 4102444800000");
    let (code, said) = check(room.path(), &[]);
    assert!(code == 1 && said.contains("something was noted at 2100-01-01T00:00:00Z already"), "{said}");
    execute(room.path(), "INSERT INTO version (number) VALUES (99)");
    let (code, said) = check(room.path(), &[]);
    assert!(
        code == 1 && said.contains("the data are of version 99") && said.contains("help: start the program"),
        "{said}"
    );
    fs::write(room.path().join("data/momentous.sqlite"), "no database, but a text that is long enough to be read")
        .unwrap();
    let (code, said) = check(room.path(), &[]);
    assert!(
        code == 1 && said.contains("data: the database") && said.contains("help: let the user of the server"),
        "{said}"
    );
}
