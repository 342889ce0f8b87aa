//! What is acknowledged is kept while the file of the database can grow no further, and afterwards: the server as a process, whose
//! files the system bounds, or on a small disk that is full.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use momentous::store::{Address, Store};

use super::class::Class;
use super::client::Client;
use super::database::block_on;
use super::server::Server;

/// Students who hand in one after the other.
const STUDENTS: u32 = 8;

/// Hands in for each student, and keeps what was acknowledged. Says how many were refused.
fn hand_in(server: &Server, class: &Class, cookies: &[String], round: usize, kept: &mut BTreeSet<String>) -> usize {
    let mut refused = 0;
    for (number, cookie) in cookies.iter().enumerate() {
        let text = format!("{}.{number} m/s", 100 + round);
        let fields = [("request", text.as_str()), ("answer.v_A2", text.as_str())];
        let answer = Client::of(&server.address).unwrap().post(&class.items[0], cookie, &fields).unwrap();
        match answer.status {
            303 => assert!(kept.insert(text)),
            503 => refused += 1,
            other => panic!("{other}: {}", answer.text),
        }
    }
    refused
}

/// A class hands in while there is room, while there is none, and when there is room again.
fn full(folder: &Path, fill: impl Fn(&Server), make_room: impl Fn(&Server)) {
    let address = Address::Folder(folder.join("data"));
    let class = block_on(async {
        let store = Store::serve(&address).await.unwrap();
        let class = Class::kept(&store, STUDENTS, &[("impact/two-carts", "forward")]).await;
        store.close().await;
        class
    });
    let mut server = Server::bounded(folder, &address);
    let mut client = Client::of(&server.address).unwrap();
    let cookies: Vec<String> = class.students.iter().map(|student| student.sign_in(&mut client)).collect();
    let mut kept = BTreeSet::new();
    assert_eq!(hand_in(&server, &class, &cookies, 0, &mut kept), 0);
    fill(&server);
    let refused: usize = (1..40).map(|round| hand_in(&server, &class, &cookies, round, &mut kept)).sum();
    assert!(refused > 2 * STUDENTS as usize, "there is no room: {refused} were refused");
    let health = Client::of(&server.address).unwrap().get("/health", "").unwrap();
    assert_eq!((health.status, health.text.as_str()), (503, "the database takes nothing new\n"));
    make_room(&server);
    assert_eq!(hand_in(&server, &class, &cookies, 40, &mut kept), 0, "the server goes on without a restart");
    assert_eq!(Client::of(&server.address).unwrap().get("/health", "").unwrap().status, 200);
    server.kill();
    let found = block_on(async {
        let store = Store::beside(&address).await.unwrap();
        let all = store.all_attempts(class.assignment.key).await.unwrap();
        all.into_iter().map(|attempt| attempt.request).collect::<Vec<_>>()
    });
    let once: BTreeSet<_> = found.iter().cloned().collect();
    assert_eq!(once.len(), found.len(), "nothing is there twice");
    let lost: Vec<_> = kept.difference(&once).collect();
    assert!(lost.is_empty(), "{} of {} acknowledged attempts are lost: {lost:?}", lost.len(), kept.len());
    eprintln!("{} acknowledged, {refused} refused, none lost", kept.len());
}

/// Bounds the files that a process writes, from now on.
#[cfg(target_os = "linux")]
fn bound(server: &Server, bytes: &str) {
    let process = server.process.id().to_string();
    let limit = format!("--fsize={bytes}:unlimited");
    assert!(Command::new("prlimit").args(["--pid", &process, &limit]).status().unwrap().success());
}

#[test]
#[cfg(target_os = "linux")]
fn an_acknowledged_attempt_outlives_a_file_that_cannot_grow() {
    let room = tempfile::tempdir().unwrap();
    let longest = |folder: &Path| {
        let sizes = fs::read_dir(folder).unwrap().map(|file| file.unwrap().metadata().unwrap().len());
        sizes.max().unwrap()
    };
    let data = room.path().join("data");
    full(
        room.path(),
        |server| bound(server, &(longest(&data) + 20_000).to_string()),
        |server| bound(server, "unlimited"),
    );
}

#[test]
#[ignore = "needs root: .ci/soak faults"]
#[cfg(target_os = "linux")]
fn whatever_goes_wrong_on_a_full_disk_nothing_acknowledged_is_lost() {
    let room = tempfile::tempdir().unwrap();
    let disk = room.path().to_owned();
    let mount = |arguments: &[&str]| {
        assert!(Command::new("mount").args(arguments).arg(&disk).status().unwrap().success(), "{arguments:?}");
    };
    mount(&["-t", "tmpfs", "-o", "size=3m", "tmpfs"]);
    let filler = disk.join("filler");
    let fill = |_: &Server| {
        // As much as there is room for; the last write is refused.
        let mut file = fs::File::create(&filler).unwrap();
        while std::io::Write::write_all(&mut file, &[1; 1024]).is_ok() {}
    };
    full(&disk, fill, |_| fs::remove_file(&filler).unwrap());
    assert!(Command::new("umount").arg(&disk).status().unwrap().success());
}
