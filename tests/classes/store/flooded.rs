//! What a server does under load and beside those who never end a request. These take a minute each and depend on the machine:
//! `.ci/soak flooded` runs them, with the program as it is built for use.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use momentous::store::{Address, Store};
use tempfile::TempDir;

use super::class::Class;
use super::client::Client;
use super::server::Server;

/// Students who hand in at the same time, once a second each.
const STUDENTS: u32 = 5;
/// Connections of those who are not known.
const CONNECTIONS: u32 = 200;

/// A class whose data are in a folder, and its server.
struct Evening {
    folder: TempDir,
    class: Class,
    server: Server,
}

impl Evening {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let data = Address::Folder(folder.path().join("data"));
        let runtime = tokio::runtime::Runtime::new().unwrap();
        let class = runtime.block_on(async {
            let store = Store::serve(&data).await.unwrap();
            Class::kept(&store, STUDENTS, &[("impact/two-carts", "forward")]).await
        });
        drop(runtime);
        let server = Server::start(folder.path(), &data);
        Self { folder, class, server }
    }

    /// Every student signs in: a client each, with the cookie.
    fn signed_in(&self) -> Vec<(Client, String)> {
        let sign_in = |student: &super::class::Student| {
            let mut client = Client::of(&self.server.address).unwrap();
            let cookie = student.sign_in(&mut client);
            (client, cookie)
        };
        self.class.students.iter().map(sign_in).collect()
    }

    /// Every student hands in for so long: how many were acknowledged of how many, and how long the slowest of a hundred took.
    fn handed_in(&self, students: &mut [(Client, String)], run: u32, lasts: Duration) -> (usize, usize, Duration) {
        let item = self.class.items[0].as_str();
        let all: Vec<(u16, Duration)> = thread::scope(|scope| {
            let started: Vec<_> = students
                .iter_mut()
                .map(|(client, cookie)| {
                    scope.spawn(move || {
                        let (start, mut seen) = (Instant::now(), Vec::new());
                        while start.elapsed() < lasts {
                            let text = format!("{run}.{} m/s", 100 + seen.len());
                            let asked = Instant::now();
                            let response = client.post(item, cookie, &[("request", &text), ("answer.v_A2", &text)]);
                            seen.push((response.map_or(0, |response| response.status), asked.elapsed()));
                            thread::sleep(Duration::from_millis(1050));
                        }
                        seen
                    })
                })
                .collect();
            started.into_iter().flat_map(|thread| thread.join().unwrap()).collect()
        });
        let mut took: Vec<Duration> = all.iter().map(|(_, took)| *took).collect();
        took.sort();
        let acknowledged = all.iter().filter(|(status, _)| *status == 303).count();
        (acknowledged, all.len(), took[took.len() * 99 / 100])
    }
}

/// Asks again and again on connections of their own, until it is told to stop: how many answers there were.
fn flood<T>(address: &str, request: impl Fn(u32) -> String + Sync, meanwhile: impl FnOnce() -> T) -> (u32, T) {
    let (is_over, answers) = (AtomicBool::new(false), AtomicU32::new(0));
    thread::scope(|scope| {
        for connection in 0..CONNECTIONS {
            let (is_over, answers, request) = (&is_over, &answers, &request);
            scope.spawn(move || {
                let mut number = connection;
                while !is_over.load(Ordering::Relaxed) {
                    let Ok(mut stream) = TcpStream::connect(address) else { continue };
                    let _ = stream.set_read_timeout(Some(Duration::from_secs(5)));
                    number += CONNECTIONS;
                    if stream.write_all(request(number).as_bytes()).is_ok() && stream.read(&mut [0; 64]).is_ok() {
                        answers.fetch_add(1, Ordering::Relaxed);
                    }
                }
            });
        }
        thread::sleep(Duration::from_secs(2));
        let seen = meanwhile();
        is_over.store(true, Ordering::Relaxed);
        (answers.load(Ordering::Relaxed), seen)
    })
}

fn posted(address: &str, path: &str, kind: &str, body: &str) -> String {
    let length = body.len();
    format!(
        "POST {path} HTTP/1.1\r\nHost: {address}\r\nOrigin: http://{address}\r\nConnection: close\r\n\
         Content-Type: {kind}\r\nContent-Length: {length}\r\n\r\n{body}"
    )
}

#[test]
#[ignore = "takes a minute, and a machine for itself"]
fn students_hand_in_while_others_flood_the_server() {
    let evening = Evening::new();
    let address = evening.server.address.as_str();
    let mut students = evening.signed_in();
    let solve = |number: u32| {
        let body = format!("{{\"problem\":\"impact/three-gliders\",\"seed\":{number}}}");
        posted(address, "/api/solve", "application/json", &body)
    };
    let sign_in = |number: u32| {
        posted(address, "/sign-in", "application/x-www-form-urlencoded", &format!("login=u{number}&password=x"))
    };
    let mut hand_in = |run| evening.handed_in(&mut students, run, Duration::from_secs(20));
    for (what, run, request) in [("solve", 1, &solve as &(dyn Fn(u32) -> String + Sync)), ("sign in", 2, &sign_in)] {
        let (answers, (acknowledged, all, slowest)) = flood(address, request, || hand_in(run));
        println!("{what}: {answers} answers; {acknowledged} of {all} acknowledged, 99 % within {slowest:?}");
        assert!(acknowledged * 100 >= all * 99 && slowest < Duration::from_secs(2), "{what}");
    }
}

#[test]
#[ignore = "takes a minute, and a machine for itself"]
fn a_right_password_is_taken_while_others_try_wrong_ones() {
    let evening = Evening::new();
    let address = evening.server.address.as_str();
    let words = "a few short words";
    let (client, cookie) = &mut evening.signed_in()[0];
    let new = [("new", words), ("again", words)];
    assert_eq!(client.post("/account/password", cookie, &new).unwrap().status, 303);
    let sign_in = |number: u32| {
        posted(address, "/sign-in", "application/x-www-form-urlencoded", &format!("login=u{number}&password=x"))
    };
    let (answers, took) = flood(address, sign_in, || {
        let asked = Instant::now();
        let mut client = Client::of(address).unwrap();
        let answer = client.post("/sign-in", "", &[("login", "s1"), ("password", words)]).unwrap();
        assert_eq!(answer.status, 303, "{}", answer.text);
        asked.elapsed()
    });
    println!("{answers} answers; the right password was taken after {took:?}");
    assert!(took < Duration::from_secs(5));
}

#[test]
#[ignore = "takes a minute, and a machine for itself"]
fn those_who_never_end_a_request_stop_nobody() {
    let evening = Evening::new();
    let address = evening.server.address.as_str();
    let mut students = evening.signed_in();
    let half = "POST /sign-in HTTP/1.1\r\nHost: x\r\n";
    let whole = format!(
        "{half}Origin: http://x\r\nContent-Type: application/x-www-form-urlencoded\r\nContent-Length: 100\r\n\r\nlogin="
    );
    let mut held: Vec<TcpStream> = Vec::new();
    for place in 0..3000 {
        let Ok(mut stream) = TcpStream::connect(address) else { break };
        if stream.write_all(if place % 2 == 0 { half.as_bytes() } else { whole.as_bytes() }).is_ok() {
            held.push(stream);
        }
    }
    // The last of them has as long as the first.
    let sent = Instant::now();
    let (acknowledged, all, slowest) = evening.handed_in(&mut students, 1, Duration::from_secs(10));
    println!("{} held; {acknowledged} of {all} acknowledged, 99 % within {slowest:?}", held.len());
    assert!(acknowledged == all && slowest < Duration::from_secs(2));
    thread::sleep(Duration::from_secs(40).saturating_sub(sent.elapsed()));
    let is_closed = |stream: &mut TcpStream| {
        let _ = stream.set_nonblocking(true);
        let mut answer = [0; 1024];
        loop {
            match stream.read(&mut answer) {
                Ok(0) => return true,
                Ok(_) => {}
                Err(error) => return error.kind() != std::io::ErrorKind::WouldBlock,
            }
        }
    };
    let open = held.iter_mut().filter_map(|stream| (!is_closed(stream)).then_some(())).count();
    assert_eq!(open, 0, "headers have ten seconds, and the rest thirty");
}

/// Whether a process has ended within some time.
fn has_ended(server: &mut Server, within: Duration) -> bool {
    let start = Instant::now();
    while start.elapsed() < within {
        if server.process.try_wait().unwrap().is_some() {
            return true;
        }
        thread::sleep(Duration::from_millis(20));
    }
    false
}

#[test]
#[ignore = "takes a minute, and a machine for itself"]
fn a_server_that_is_told_to_stop_under_load_ends_and_loses_nothing() {
    let mut evening = Evening::new();
    let address = evening.server.address.clone();
    let students = evening.signed_in();
    let item = evening.class.items[0].clone();
    let solve = |number: u32| {
        let body = format!("{{\"problem\":\"impact/three-gliders\",\"seed\":{number}}}");
        posted(&address, "/api/solve", "application/json", &body)
    };
    let process = evening.server.process.id().to_string();
    let server = &mut evening.server;
    let (_, acknowledged) = flood(&address, solve, || {
        let hand_in = |(mut client, cookie): (Client, String)| {
            let mut acknowledged = Vec::new();
            for number in 0..40 {
                let text = format!("{} m/s", 100 + number);
                match client.post(&item, &cookie, &[("request", &text), ("answer.v_A2", &text)]) {
                    Ok(response) if response.status == 303 => acknowledged.push(text),
                    _ => break,
                }
            }
            acknowledged
        };
        thread::scope(|scope| {
            let item: Vec<_> = students.into_iter().map(|student| scope.spawn(|| hand_in(student))).collect();
            thread::sleep(Duration::from_millis(500));
            assert!(Command::new("kill").arg(&process).status().unwrap().success());
            assert!(has_ended(server, Duration::from_secs(20)), "it goes on");
            item.into_iter().map(|thread| thread.join().unwrap()).collect::<Vec<_>>()
        })
    });
    let kept = kept(evening.folder.path(), &evening.class);
    println!("{:?} acknowledged, {:?} kept", lengths(&acknowledged), lengths(&kept));
    assert!(acknowledged.iter().any(|request| !request.is_empty()));
    for (acknowledged, kept) in acknowledged.iter().zip(&kept) {
        assert!(acknowledged.iter().all(|request| kept.contains(request)), "{acknowledged:?} {kept:?}");
    }
}

fn lengths(all: &[Vec<String>]) -> Vec<usize> {
    all.iter().map(Vec::len).collect()
}

/// The keys of what each student's attempts are known by.
fn kept(folder: &Path, class: &Class) -> Vec<Vec<String>> {
    tokio::runtime::Runtime::new().unwrap().block_on(async {
        let store = Store::serve(&Address::Folder(folder.join("data"))).await.unwrap();
        let mut all = Vec::new();
        for student in &class.students {
            let attempts = store.attempts_of(class.assignment.key, student.member).await.unwrap();
            all.push(attempts.into_values().flatten().map(|attempt| attempt.request).collect());
        }
        all
    })
}
