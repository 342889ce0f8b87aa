//! A busy evening: a class hands in over HTTP, to the server as a process of its own.
//!
//!     cargo bench --bench evening                   # 60 in each second, whether or not the server keeps up
//!     cargo bench --bench evening -- 100000 0       # so many attempts, as fast as they are answered
//!     cargo bench --bench evening -- 100000 200     # so many in each second
//!
//! It prints how long the disk takes to write a page safely, how many attempts a second were marked and kept, how long each waited for
//! its answer, and the server's memory as attempts grow. The aim is [`AIM`] a second with 99 of 100 answered within 250 ms. The data are in a new folder; `MOMENTOUS_DATA` names another, or a database of PostgreSQL, which has to be empty.

#![allow(clippy::unwrap_used, reason = "a measurement that fails has nothing to say")]

use std::env;
use std::fs;
use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use momentous::store::{Address, Store};
use tokio::runtime::Runtime;

use class::Class;
use client::Client;
use server::Server;

#[path = "../tests/classes/store/class.rs"]
mod class;
#[path = "../tests/classes/store/client.rs"]
mod client;
#[path = "../tests/classes/store/server.rs"]
mod server;

/// The items of the assignment, and what is handed in of each: a part and its unit.
const ITEMS: [(&str, &str, &str, &str); 4] = [
    ("impact/two-carts", "forward", "v_A2", "m/s"),
    ("impact/two-carts", "find-e", "e", ""),
    ("impact/hockey-pucks", "", "speed_A2", "m/s"),
    ("impulse/crate-ramp-force", "forward", "t_start", "s"),
];
/// Attempts of each student at each item, each with another answer.
const EACH: usize = 10;
/// Browsers that ask at the same time.
const BROWSERS: usize = 32;
/// Attempts where none are named.
const USUAL: usize = 3600;
/// Attempts in each second where nothing is said: a class of 1000 that hands in within one minute is 17.
const AIM: usize = 60;
/// How often a line is printed.
const LINES: usize = 10;

fn main() {
    let numbers: Vec<usize> = env::args().filter_map(|own| own.parse().ok()).collect();
    let (count, rate) = (numbers.first().copied().unwrap_or(USUAL), numbers.get(1).copied().unwrap_or(AIM));
    let rate = (rate > 0).then_some(rate);
    let room = tempfile::tempdir().unwrap();
    let data = env::var("MOMENTOUS_DATA").unwrap_or_else(|_| room.path().join("data").display().to_string());
    let data: Address = data.parse().unwrap();
    let runtime = Runtime::new().unwrap();
    let students = count.div_ceil(ITEMS.len() * EACH).max(BROWSERS);
    let class = runtime.block_on(async {
        let store = Store::serve(&data).await.unwrap();
        let problems = ITEMS.map(|(problem, form, ..)| (problem, form));
        Class::kept(&store, u32::try_from(students).unwrap(), &problems).await
    });
    let server = Server::start(room.path(), &data);
    let mut client = Client::of(&server.address).unwrap();
    let cookies = class.students.iter().map(|student| student.sign_in(&mut client)).collect();
    let evening = Evening { items: &class.items, cookies, address: &server.address, next: AtomicUsize::new(0), rate };
    let [half, most] = fsync(room.path());
    println!("a page on the disk (fsync): 50 of 100 within {half:.1} ms, 99 of 100 within {most:.1} ms");
    println!(
        "{:>9}  {:>8}  {:>8}  {:>8}  {:>8}  {:>8}",
        "attempts", "a second", "p50 ms", "p99 ms", "max ms", "RSS MB"
    );
    for line in 1..=LINES {
        evening.go_on(count * line / LINES, &server);
    }
    let kept = runtime.block_on(async {
        let store = Store::beside(&data).await.unwrap();
        let mut kept = 0;
        for student in &class.students {
            let own = store.attempts_of(class.assignment.key, student.member).await.unwrap();
            kept += own.values().map(Vec::len).sum::<usize>();
        }
        kept
    });
    assert_eq!(kept, count, "every attempt is kept once");
}

/// What every browser knows.
struct Evening<'a> {
    items: &'a [String],
    /// The cookie of each student.
    cookies: Vec<String>,
    address: &'a str,
    /// The number of the next attempt.
    next: AtomicUsize,
    rate: Option<usize>,
}

impl Evening<'_> {
    /// Hands in until there are so many attempts, and says how it went.
    fn go_on(&self, until: usize, server: &Server) {
        let (before, start) = (self.next.load(Ordering::Relaxed), Instant::now());
        let mut waits: Vec<Duration> = thread::scope(|scope| {
            let browsers: Vec<_> = (0..BROWSERS).map(|_| scope.spawn(|| self.browse(before, until, start))).collect();
            browsers.into_iter().flat_map(|browser| browser.join().unwrap()).collect()
        });
        let took = start.elapsed().as_millis();
        // Each browser has asked for the number of one more.
        self.next.store(until, Ordering::Relaxed);
        waits.sort_unstable();
        let wait = |percent: usize| waits[(waits.len() - 1) * percent / 100].as_secs_f64() * 1e3;
        let a_second = 1000 * waits.len() as u128 / took;
        let [half, most, all] = [50, 99, 100].map(wait);
        println!("{until:>9}  {a_second:>8}  {half:>8.1}  {most:>8.1}  {all:>8.1}  {:>8.1}", memory(server));
    }

    /// One browser: it hands in whatever is next, and says how long each took. Where a rate is kept, an attempt that is late waits from
    /// the moment when it should have been sent.
    fn browse(&self, from: usize, until: usize, start: Instant) -> Vec<Duration> {
        let mut client = Client::of(self.address).unwrap();
        let mut waits = Vec::new();
        loop {
            let number = self.next.fetch_add(1, Ordering::Relaxed);
            if number >= until {
                return waits;
            }
            self.look(&mut client, number);
            let due = self.rate.map(|rate| start + Duration::from_millis(1000 * (number - from) as u64 / rate as u64));
            if let Some(due) = due {
                thread::sleep(due.saturating_duration_since(Instant::now()));
            }
            let asked = due.unwrap_or_else(Instant::now);
            self.hand_in(&mut client, number);
            waits.push(asked.elapsed());
        }
    }

    /// Student after student; after a round the next answer, and after all of these the next item.
    fn turn(&self, number: usize) -> (usize, usize, usize) {
        let (student, round) = (number % self.cookies.len(), number / self.cookies.len());
        (student, round, round / EACH % ITEMS.len())
    }

    /// Before the first answer to an item its sheet is looked at.
    fn look(&self, client: &mut Client, number: usize) {
        let (student, round, place) = self.turn(number);
        if round.is_multiple_of(EACH) {
            let response = client.get(&self.items[place], &self.cookies[student]).unwrap();
            assert_eq!(response.status, 200, "{}", response.text);
        }
    }

    fn hand_in(&self, client: &mut Client, number: usize) {
        let (student, round, place) = self.turn(number);
        let (.., part, unit) = ITEMS[place];
        let (request, field) = (number.to_string(), format!("answer.{part}"));
        // None is right: a part that is right takes no more answers.
        let answer = format!("{}.{:02} {unit}", 1000 + round % EACH, number % 89);
        let fields = [("request", request.as_str()), (field.as_str(), answer.as_str())];
        let response = client.post(&self.items[place], &self.cookies[student], &fields).unwrap();
        assert_eq!(response.status, 303, "{answer}: {}", response.text);
    }
}

/// How many milliseconds it takes until a page that is added to a file is on the disk: half of the time, and nearly always.
fn fsync(folder: &Path) -> [f64; 2] {
    let mut file = File::create(folder.join("fsync")).unwrap();
    let mut write = || {
        let start = Instant::now();
        file.write_all(&[1; 4096]).unwrap();
        file.sync_data().unwrap();
        start.elapsed().as_secs_f64() * 1e3
    };
    let mut times: Vec<f64> = (0..200).map(|_| write()).collect();
    times.sort_unstable_by(f64::total_cmp);
    [times[100], times[198]]
}

/// The memory that the server holds, in megabytes.
fn memory(server: &Server) -> f64 {
    let status = fs::read_to_string(format!("/proc/{}/status", server.process.id())).unwrap_or_default();
    let resident = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kilobytes = resident.and_then(|own| own.trim().trim_end_matches(" kB").parse::<f64>().ok());
    kilobytes.map_or(f64::NAN, |kilobytes| kilobytes / 1000.0)
}
