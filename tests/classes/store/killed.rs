//! An acknowledged attempt is never lost: the server is killed in the midst of a class that hands in, again and again.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

use momentous::course::StoredReport;
use momentous::store::Store;

use super::class::{Class, Student};
use super::client::Client;
use super::database::{Database, on_both};
use super::server::Server;

/// Students who hand in at the same time.
const STUDENTS: u32 = 8;

/// What a student has sent.
pub struct Work {
    item: String,
    cookie: String,
    /// What the server has said is kept, in its order.
    pub acknowledged: Vec<String>,
    /// What it has not answered: it may be kept or not.
    pending: Option<String>,
    sent: usize,
}

impl Work {
    /// The work of a student who has signed in and has sent nothing.
    pub fn begin(item: &str, cookie: String) -> Self {
        Self { item: item.to_owned(), cookie, acknowledged: Vec::new(), pending: None, sent: 0 }
    }

    /// Hands in until the server is gone, or the class has ended. What was not answered before is sent again first, as a browser's
    /// reload does.
    pub fn hand_in(&mut self, address: &str, told: &Sender<()>, has_ended: &AtomicBool) {
        let Ok(mut client) = Client::of(address) else { return };
        while !has_ended.load(Ordering::Relaxed) {
            let again = self.pending.take();
            let text = again.unwrap_or_else(|| {
                self.sent += 1;
                format!("{} m/s", 100 + self.sent)
            });
            let fields = [("request", text.as_str()), ("answer.v_A2", text.as_str())];
            match client.post(&self.item, &self.cookie, &fields) {
                Ok(response) => {
                    assert_eq!(response.status, 303, "{}", response.text);
                    self.acknowledged.push(text);
                    // Nobody listens once there are enough.
                    let _ = told.send(());
                }
                Err(_) => {
                    self.pending = Some(text);
                    return;
                }
            }
        }
    }
}

/// Every attempt that was acknowledged is there, once, in its order, under its key; besides these there is at most the one that was
/// not answered.
pub async fn all_are_there(store: &Store, class: &Class, works: &[Work]) {
    for (student, work) in class.students.iter().zip(works) {
        let kept = store.attempts_of(class.assignment.key, student.member).await.unwrap();
        let kept: Vec<_> = kept.into_values().flatten().collect();
        let keys: Vec<&str> = kept.iter().map(|attempt| attempt.request.as_str()).collect();
        let expected =
            work.acknowledged.iter().chain(work.pending.as_ref().filter(|_| kept.len() > work.acknowledged.len()));
        assert_eq!(keys, expected.collect::<Vec<_>>());
        assert!(
            kept.iter().all(|attempt| attempt.answers["v_A2"] == attempt.request),
            "each key has the answer that came with it"
        );
        if let Some(last) = kept.last() {
            let report = StoredReport::of(last).unwrap();
            assert_eq!(report.history.handed_in() as usize, kept.len(), "each was marked after those before it");
        }
    }
}

pub fn enough(told: &Receiver<()>, count: usize) {
    assert_eq!(told.iter().take(count).count(), count, "the students have stopped before the server was killed");
}

async fn kill(database: &Database, times: usize) {
    let room = tempfile::tempdir().unwrap();
    let store = database.serve().await;
    let class = Class::kept(&store, STUDENTS, &[("impact/two-carts", "forward")]).await;
    store.close().await;
    drop(store);
    let mut server = Server::start(room.path(), &database.address());
    let mut client = Client::of(&server.address).unwrap();
    let mut work = |student: &Student| Work::begin(&class.items[0], student.sign_in(&mut client));
    let mut works: Vec<Work> = class.students.iter().map(&mut work).collect();
    for time in 0..times {
        thread::scope(|scope| {
            let (tell, told) = channel();
            for work in &mut works {
                let (tell, address) = (tell.clone(), server.address.clone());
                scope.spawn(move || work.hand_in(&address, &tell, &AtomicBool::new(false)));
            }
            drop(tell);
            // Each time after another count, so that it is killed in all that it does.
            enough(&told, 4 + time * 7 % 29);
            server.kill();
        });
        server = Server::start(room.path(), &database.address());
        let beside = Store::beside(&database.address()).await.unwrap();
        all_are_there(&beside, &class, &works).await;
        beside.close().await;
    }
    let count: usize = works.iter().map(|work| work.acknowledged.len()).sum();
    eprintln!("{}: killed {times} times, {count} attempts acknowledged, none lost", database.address());
}

#[test]
fn an_acknowledged_attempt_outlives_the_server() {
    on_both(async |database| kill(database, 10).await);
}

#[test]
#[ignore = "takes minutes: .ci/soak killed"]
fn attempts_outlive_two_hundred_deaths_of_the_server() {
    on_both(async |database| kill(database, 200).await);
}
