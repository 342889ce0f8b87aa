//! Three servers over one database: they count together, and when one of them is killed, those who worked on it go on with another.

use std::fs;
use std::net::TcpListener;
use std::path::Path;
use std::process::{Child, Command};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::thread;
use std::time::{Duration, Instant};

use momentous::store::{Rate, Store};

use super::NOW;
use super::class::Class;
use super::client::Client;
use super::database::{Database, on_both};
use super::killed::{Work, all_are_there, enough};
use super::server::Server;

#[test]
fn what_one_server_counts_counts_for_all() {
    on_both(async |database| {
        let store = database.serve().await;
        let other = match database {
            Database::Postgres(_) => database.serve().await,
            Database::Folder(_) => store.clone(),
        };
        let rate = Rate { at_once: 10, interval: 6000 };
        let mut allowed = 0;
        for server in [&store, &other].into_iter().cycle().take(20) {
            allowed += u32::from(server.allow("ada", rate, NOW).await.unwrap());
        }
        assert_eq!(allowed, 10);
        assert!(other.allow("bob", rate, NOW).await.unwrap(), "each key for itself");
        let one_more = [NOW.after(5999), NOW.after(6000), NOW.after(6000)];
        for (now, is_allowed) in one_more.into_iter().zip([false, true, false]) {
            assert_eq!(other.allow("ada", rate, now).await.unwrap(), is_allowed, "{now}");
        }
        // What nothing counts for any more is forgotten.
        assert!(store.allow("eve", rate, NOW.after(3_600_000)).await.unwrap());
        assert!(store.allow("ada", rate, NOW.after(3_600_000)).await.unwrap());
    });
}

/// Servers over a database, in a folder.
fn servers(folder: &Path, database: &Database) -> Vec<Server> {
    (0..3).map(|_| Server::start(folder, &database.address())).collect()
}

/// A class of so many students who hand in at the same time.
async fn class(database: &Database, students: u32) -> Class {
    let store = database.serve().await;
    let class = Class::kept(&store, students, &[("impact/two-carts", "forward")]).await;
    store.close().await;
    class
}

fn works(class: &Class, address: &str) -> Vec<Work> {
    let mut client = Client::of(address).unwrap();
    class.students.iter().map(|student| Work::begin(&class.items[0], student.sign_in(&mut client))).collect()
}

async fn compared(database: &Database, class: &Class, works: &[Work]) {
    let store = Store::beside(&database.address()).await.unwrap();
    all_are_there(&store, class, works).await;
    store.close().await;
}

#[test]
fn an_acknowledged_attempt_outlives_one_of_three_servers() {
    on_both(async |database| {
        let Database::Postgres(_) = database else { return };
        let room = tempfile::tempdir().unwrap();
        let class = class(database, 9).await;
        let mut servers = servers(room.path(), database);
        let addresses: Vec<String> = servers.iter().map(|server| server.address.clone()).collect();
        let mut works = works(&class, &addresses[2]);
        let has_ended = AtomicBool::new(false);
        thread::scope(|scope| {
            let (tell, told) = channel();
            for (place, work) in works.iter_mut().enumerate() {
                let (tell, addresses, has_ended) = (tell.clone(), &addresses, &has_ended);
                // A third of the class on each; those of the first go on with the next.
                let ways = addresses[place % 3..].iter();
                scope.spawn(move || ways.for_each(|address| work.hand_in(address, &tell, has_ended)));
            }
            drop(tell);
            enough(&told, 30);
            servers[0].kill();
            enough(&told, 30);
            has_ended.store(true, Ordering::Relaxed);
        });
        compared(database, &class, &works).await;
    });
}

/// nginx before servers, until it is dropped.
struct Proxy {
    process: Child,
    address: String,
}

impl Proxy {
    fn before(servers: &[Server], folder: &Path) -> Self {
        let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
        let listed: Vec<String> =
            servers.iter().map(|server| format!("server {} fail_timeout=5s;", server.address)).collect();
        let upstream = listed.join("\n");
        let settings = format!(
            "daemon off; worker_processes 1; pid nginx.pid; error_log error.log;\n\
             events {{ worker_connections 1024; }}\n\
             http {{\n\
             access_log off; client_body_temp_path body; proxy_temp_path proxy; fastcgi_temp_path f; uwsgi_temp_path u; scgi_temp_path s;\n\
             upstream momentous {{\n{upstream}\n}}\n\
             server {{\n\
             listen 127.0.0.1:{port};\n\
             location / {{\n\
             proxy_pass http://momentous;\n\
             proxy_set_header Host $http_host;\n\
             proxy_set_header X-Forwarded-For $proxy_add_x_forwarded_for;\n\
             proxy_next_upstream error timeout non_idempotent;\n\
             }}\n}}\n}}\n"
        );
        fs::write(folder.join("nginx.conf"), settings).unwrap();
        let mut command = Command::new("nginx");
        command.arg("-p").arg(folder).args(["-c", "nginx.conf", "-e", "error.log"]);
        let process = command.spawn().expect("nginx is installed, as `.ci/soak servers` does");
        let address = format!("127.0.0.1:{port}");
        let begun = Instant::now();
        while Client::of(&address).is_err() {
            assert!(begun.elapsed() < Duration::from_secs(10), "nginx did not start");
        }
        Self { process, address }
    }
}

impl Drop for Proxy {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Behind a proxy nobody sees that a server was killed, again and again, and started anew under its address.
#[test]
#[ignore = "needs nginx: .ci/soak servers"]
fn behind_a_proxy_nobody_sees_that_a_server_died() {
    on_both(async |database| {
        let Database::Postgres(_) = database else { return };
        let room = tempfile::tempdir().unwrap();
        let class = class(database, 30).await;
        let mut servers = servers(room.path(), database);
        let proxy = Proxy::before(&servers, room.path());
        let mut works = works(&class, &proxy.address);
        let has_ended = AtomicBool::new(false);
        let begun = Instant::now();
        thread::scope(|scope| {
            let (tell, told) = channel();
            for work in &mut works {
                let (tell, address, has_ended) = (tell.clone(), &proxy.address, &has_ended);
                scope.spawn(move || {
                    work.hand_in(address, &tell, has_ended);
                    assert!(has_ended.load(Ordering::Relaxed), "the proxy gave no answer");
                });
            }
            drop(tell);
            for round in 0..20 {
                enough(&told, 100 + round);
                let server = &mut servers[round % 3];
                server.kill();
                enough(&told, 50);
                *server = Server::at(room.path(), &database.address(), &server.address);
            }
            has_ended.store(true, Ordering::Relaxed);
        });
        compared(database, &class, &works).await;
        let count: usize = works.iter().map(|work| work.acknowledged.len()).sum();
        let seconds = begun.elapsed().as_secs_f64();
        eprintln!(
            "20 servers of three killed behind a proxy, {count} attempts in {seconds:.0} s acknowledged, none lost, none refused"
        );
    });
}
