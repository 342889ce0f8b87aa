//! The records of courses: one suite over both databases.

use std::collections::BTreeMap;

use momentous::course::{
    Attempt, Course, Draft, HintShown, Key, Member, Moment, Override, OverrideRule, Person, Role, Sheet,
};
use momentous::exercise::Exercise;
use momentous::store::{Address, AssignmentWithItems, HandIn, HandedIn, Reach, Store, StoreFault, Ticket, TicketKind};

use database::{Database, on_both, postgres_with};
use sample::Sample;

mod class;
mod client;
mod database;
mod decided;
mod flooded;
mod full;
mod in_time;
mod killed;
mod letters;
mod replicas;
pub mod sample;
mod server;
mod servers;
mod sweep;

const NOW: Moment = Moment::from_millis(1_764_576_000_000);

#[test]
fn more_may_read_at_once_than_there_are_connections() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let read = (0..50).map(|_| {
            let (store, key) = (store.clone(), sample.course.key);
            tokio::spawn(async move { store.course(key).await.unwrap().unwrap() })
        });
        for found in read.collect::<Vec<_>>() {
            assert_eq!(found.await.unwrap(), sample.course);
        }
        store.close().await;
        assert!(matches!(store.ping().await, Err(StoreFault::Stopped)), "whoever comes later is told");
    });
}

#[test]
fn what_is_kept_is_read_back() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        assert_eq!(store.course(sample.course.key).await.unwrap().unwrap(), sample.course);
        let membership = store.membership(sample.course.key, sample.student.key).await.unwrap().unwrap();
        assert_eq!((membership.member, membership.person), (sample.member.clone(), sample.student.clone()));
        assert_eq!(membership.course.secret, "a secret of the course");
        let found = store.assignment(sample.whole.assignment.key).await.unwrap().unwrap();
        assert_eq!((found.assignment, found.items), (sample.whole.assignment.clone(), sample.whole.items.clone()));
        assert_eq!(store.sheet(sample.sheet.item, sample.member.key, 0).await.unwrap().unwrap(), sample.sheet);
        assert_eq!(store.trail(sample.course.key, 10).await.unwrap().len(), 2);
        assert_eq!(store.courses_of(sample.student.key).await.unwrap().len(), 1);
    });
}

#[test]
fn an_attempt_takes_its_number_once() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let revision = sample.revision(&store).await;
        let [first, second, other] =
            [(1, "a"), (2, "b"), (2, "c")].map(|(number, request)| sample.attempt(number, request));
        let hand_in = |attempt| HandIn { attempt, assignment: sample.whole.assignment.key, revision };
        assert!(matches!(store.hand_in(hand_in(&second)).await.unwrap(), HandedIn::Stale), "a number is left out");
        assert!(matches!(store.hand_in(hand_in(&first)).await.unwrap(), HandedIn::Kept));
        let again = store.hand_in(hand_in(&first)).await.unwrap();
        assert!(
            matches!(again, HandedIn::Before(before) if before.number == 1),
            "a repeated request is the same attempt"
        );
        let both = tokio::join!(store.hand_in(hand_in(&second)), store.hand_in(hand_in(&other)));
        let kept = [both.0.unwrap(), both.1.unwrap()];
        let new = kept.iter().filter(|outcome| matches!(outcome, HandedIn::Kept)).count();
        assert_eq!(new, 1, "two tabs at the same time");
        assert_eq!(store.attempts(sample.sheet.key).await.unwrap().len(), 2);
        assert_eq!(store.last_attempts(sample.whole.assignment.key).await.unwrap()[0].number, 2);
    });
}

#[test]
fn nothing_is_handed_in_by_rules_that_no_longer_hold() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let revision = sample.revision(&store).await;
        store.save_items(&sample.whole.items, &sample.entry(50)).await.unwrap();
        let attempt = sample.attempt(1, "a");
        let hand_in = HandIn { attempt: &attempt, assignment: sample.whole.assignment.key, revision };
        assert!(matches!(store.hand_in(hand_in).await.unwrap(), HandedIn::Stale));
        let hand_in = HandIn { revision: sample.revision(&store).await, ..hand_in };
        assert!(matches!(store.hand_in(hand_in).await.unwrap(), HandedIn::Kept));
    });
}

#[test]
fn an_extension_keeps_a_problem_reserved_until_the_last_has_closed() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let closes = sample.whole.assignment.policy.closes;
        let open = async |moment| store.open_assignments(moment).await.unwrap().len();
        // A minute after the close nothing is on its way any more.
        assert_eq!([open(closes.after(60_000)).await, open(closes.after(60_001)).await], [1, 0]);
        assert_eq!(store.open_assignments(closes).await.unwrap()[0].0.items, sample.whole.items);
        store.extend(&[(sample.extension(closes.after(1000)), sample.entry(60))]).await.unwrap();
        assert_eq!([open(closes.after(61_000)).await, open(closes.after(61_001)).await], [1, 0]);
        assert_eq!(store.open_assignments(closes).await.unwrap()[0].1.len(), 1);
        let found = store.extension(sample.whole.assignment.key, sample.member.key).await.unwrap().unwrap();
        assert_eq!(found.reason, "was ill");
        assert_eq!(store.extensions_of(sample.member.key).await.unwrap(), [found]);
        let shorter = AssignmentWithItems { revision: sample.revision(&store).await, ..sample.whole.clone() };
        assert!(store.save_assignment(&shorter, &sample.entry(61)).await.unwrap());
        assert_eq!(open(closes.after(60_999)).await, 1, "a change of the assignment forgets no extension");
    });
}

#[test]
fn a_course_knows_who_has_a_password_and_who_is_elsewhere() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let course = sample.course.key;
        assert!(store.with_password(course).await.unwrap().is_empty());
        store.set_password(sample.student.key, "a hash".into(), None, &[sample.entry(90)]).await.unwrap();
        assert_eq!(store.with_password(course).await.unwrap().into_iter().collect::<Vec<_>>(), [sample.student.key]);
        assert!(store.elsewhere(course).await.unwrap().is_empty());
        let other = Course { key: Key::new([91; 16]), ..sample.course.clone() };
        let there =
            Member { key: Key::new([92; 16]), course: other.key, role: Role::Assistant, ..sample.member.clone() };
        store.add_course(&other, &there, &sample.entry(93)).await.unwrap();
        assert_eq!(store.elsewhere(course).await.unwrap()[0].member, there);
        let left = Member { left: Some(NOW), ..there };
        let renamed = Person { name: "Ada King".into(), ..sample.student.clone() };
        store.save_members(std::slice::from_ref(&renamed), &[left], &sample.entry(94)).await.unwrap();
        assert!(store.elsewhere(course).await.unwrap().is_empty());
        assert_eq!(store.person(renamed.key).await.unwrap(), Some(renamed));
    });
}

#[test]
fn a_ticket_is_taken_once_and_ends() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let ticket = |hash: &str, kind, reach| Ticket {
            hash: hash.into(),
            person: sample.student.key,
            kind,
            reach,
            expires: NOW.after(10),
        };
        store.add_tickets(vec![ticket("h", TicketKind::Link, Reach::Anew)], NOW, &[]).await.unwrap();
        let holder = async |hash, kind, at| store.holder(hash, kind, at).await.unwrap();
        assert_eq!(holder("h", TicketKind::Link, NOW).await, Some((sample.student.clone(), Reach::Anew)));
        assert_eq!(holder("h", TicketKind::Session, NOW).await, None, "a link is no session");
        assert_eq!(holder("h", TicketKind::Link, NOW.after(10)).await, None);
        let session = |hash| Some(ticket(hash, TicketKind::Session, Reach::All));
        let entries = [sample.entry(73)];
        let both = tokio::join!(
            store.take_ticket("h", session("one"), &entries),
            store.take_ticket("h", session("two"), &entries)
        );
        assert_eq!(u8::from(both.0.unwrap()) + u8::from(both.1.unwrap()), 1);
        let [one, two] = [holder("one", TicketKind::Session, NOW).await, holder("two", TicketKind::Session, NOW).await];
        assert_eq!([one, two].into_iter().flatten().collect::<Vec<_>>(), [(sample.student.clone(), Reach::All)]);
    });
}

#[test]
fn a_newer_link_ends_older_ones() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let [here, there] = [sample.course.key, Key::new([91; 16])];
        let add = async |hash: &str, kind, reach| {
            let ticket = Ticket { hash: hash.into(), person: sample.student.key, kind, reach, expires: NOW.after(10) };
            store.add_tickets(vec![ticket], NOW, &[]).await.unwrap();
        };
        let left = async |hashes: &[&'static str]| {
            let mut left = Vec::new();
            for hash in hashes {
                let kind = if hash.starts_with('s') { TicketKind::Session } else { TicketKind::Link };
                left.extend(store.holder(hash, kind, NOW).await.unwrap().map(|_| *hash));
            }
            left
        };
        add("session", TicketKind::Session, Reach::Course(here)).await;
        add("here", TicketKind::Link, Reach::Course(here)).await;
        add("there", TicketKind::Link, Reach::Course(there)).await;
        add("here 2", TicketKind::Link, Reach::Course(here)).await;
        let all = ["session", "here", "there", "here 2", "operator's"];
        assert_eq!(left(&all).await, ["session", "there", "here 2"], "a course ends its own");
        add("operator's", TicketKind::Link, Reach::Anew).await;
        assert_eq!(left(&all).await, ["session", "operator's"], "the operator ends all");
    });
}

#[test]
fn an_erased_person_leaves_its_answers_without_a_name() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        store.set_password(sample.student.key, "hash".into(), None, &[sample.entry(70)]).await.unwrap();
        assert_eq!(store.password(sample.student.key).await.unwrap().as_deref(), Some("hash"));
        let erased = Person { login: String::new(), name: String::new(), erased: Some(NOW), ..sample.student.clone() };
        store.erase_person(&erased, &[sample.entry(71)]).await.unwrap();
        assert_eq!(store.password(sample.student.key).await.unwrap(), None);
        assert_eq!(store.person_named("s17").await.unwrap(), None);
        assert_eq!(store.person(sample.student.key).await.unwrap().unwrap().shown(), "(erased)");
        assert_eq!(store.sheets_of(sample.member.key).await.unwrap().len(), 1);
        let again = Person { key: Key::new([80; 16]), ..sample.student.clone() };
        store.add_people(&[again], &sample.entry(72)).await.expect("the name is free again");
    });
}

#[test]
fn of_people_with_a_name_that_is_taken_none_is_added() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let [new, same] = [("s18", 81), ("s17", 82)].map(|(login, key)| {
            let login = login.to_owned();
            Person { key: Key::new([key; 16]), login, ..sample.student.clone() }
        });
        let member = Member { key: Key::new([83; 16]), person: new.key, role: Role::Student, ..sample.member.clone() };
        let fault = store.save_members(&[new, same], &[member], &sample.entry(73)).await.unwrap_err();
        assert!(fault.is_taken(), "{fault}");
        assert_eq!(store.person_named("s18").await.unwrap(), None);
        assert_eq!(store.members(sample.course.key).await.unwrap().len(), 1);
    });
}

#[test]
fn hints_drafts_and_points_by_hand_are_kept() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let hint = HintShown { sheet: sample.sheet.key, part: None, number: 1, at: NOW };
        for _ in 0..2 {
            store.show_hint(&hint).await.unwrap();
        }
        assert_eq!(store.hints(sample.sheet.key).await.unwrap(), [hint]);
        for text in ["1", "2"] {
            let answers = BTreeMap::from([("v_A2".to_owned(), text.to_owned())]);
            store.save_draft(&Draft { sheet: sample.sheet.key, answers, saved: NOW, settled: None }).await.unwrap();
        }
        assert_eq!(store.draft(sample.sheet.key).await.unwrap().unwrap().answers["v_A2"], "2");
        for (key, points) in [(90, Some("1/3")), (91, None)] {
            let set = Override { at: NOW.after(i64::from(key)), ..sample.set(points, OverrideRule::Exactly) };
            store.set_points(Key::new([key; 16]), &set, &sample.entry(key)).await.unwrap();
        }
        let set = store.set_by_hand(sample.whole.assignment.key).await.unwrap();
        assert_eq!(set.iter().map(|sample| sample.points.as_deref()).collect::<Vec<_>>(), [Some("1/3"), None]);
    });
}

#[test]
fn a_copy_leads_back_and_from_one_database_to_the_other() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("copy.sqlite");
        store.backup(&file).await.unwrap();
        assert!(store.backup(&file).await.is_err(), "no copy is written over another");
        assert!(matches!(store.restore(&file).await, Err(StoreFault::NotEmpty)));
        let other = Address::Folder(folder.path().join("other"));
        for target in [Database::Folder(other), database.another().await] {
            let restored = target.serve().await;
            restored.restore(&file).await.unwrap();
            assert_eq!(restored.course(sample.course.key).await.unwrap().unwrap(), sample.course);
            assert_eq!(restored.sheet_by_key(sample.sheet.key).await.unwrap().unwrap(), sample.sheet);
            assert_eq!(
                restored.trail(sample.course.key, 10).await.unwrap(),
                store.trail(sample.course.key, 10).await.unwrap()
            );
        }
    });
}

#[test]
fn a_folder_is_served_by_one_and_read_beside_it() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let beside = Store::beside(store.address()).await.unwrap();
        assert_eq!(beside.course(sample.course.key).await.unwrap().unwrap(), sample.course);
        let second = Store::serve(store.address()).await;
        match store.address() {
            Address::Folder(_) => assert!(matches!(second, Err(StoreFault::Locked(_)))),
            Address::Postgres(_) => {
                // Two servers over one database see at once what the other keeps.
                let second = second.unwrap();
                let draft = Draft { sheet: sample.sheet.key, answers: BTreeMap::new(), saved: NOW, settled: None };
                second.save_draft(&draft).await.unwrap();
                assert_eq!(store.draft(sample.sheet.key).await.unwrap(), Some(draft));
            }
        }
    });
}

#[test]
fn data_of_a_later_program_are_refused_by_name() {
    on_both(async |database| {
        drop(database.serve().await);
        database.execute("INSERT INTO version (number) VALUES (99)").await;
        let refused = Store::beside(&database.address()).await.err().unwrap();
        assert_eq!(
            refused.to_string(),
            "the data are of version 99, and this program knows versions up to 4; use a later program"
        );
    });
}

#[test]
fn a_commit_waits_until_it_is_on_the_disk() {
    on_both(async |database| {
        let careless = match database.address() {
            folder @ Address::Folder(_) => folder,
            Address::Postgres(url) => postgres_with(&url, "synchronous_commit=off"),
        };
        let store = Store::serve(&careless).await.unwrap();
        let durability = store.durability().await.unwrap();
        match careless {
            Address::Folder(_) => assert_eq!(durability, ["wal", "2"]),
            Address::Postgres(_) => assert_eq!(durability[1], "on", "whatever the address says"),
        }
    });
}

/// The sheet of a variant of the bank.
fn exercise() -> Exercise {
    use std::sync::Arc;
    let source = momentous::bank::Bank::built_in().find("impact/two-carts").unwrap().clone();
    let problem = momentous::problem::compile(momentous::problem::load(source).unwrap(), None).unwrap();
    Exercise::draw(&Arc::new(problem), 0, 7).unwrap()
}

/// What a sheet and an attempt look like.
impl Sample {
    fn attempt(&self, number: u32, request: &str) -> Attempt {
        Attempt {
            sheet: self.sheet.key,
            number,
            received: NOW,
            answers: BTreeMap::from([("v_A2".to_owned(), "1 m/s".to_owned())]),
            report: serde_json::value::to_raw_value(&serde_json::json!({ "points": "1/3" })).unwrap(),
            request: request.to_owned(),
        }
    }

    fn sheet(item: Key<momentous::course::Item>, member: Key<Member>) -> Sheet {
        let issued = exercise().issue(None, momentous::grade::DecimalMark::Point);
        Sheet { key: Key::new([5; 16]), item, member, issue: 0, issued, seen: NOW }
    }
}

#[test]
#[cfg(unix)]
fn nobody_else_reads_the_files_wherever_their_folder_came_from() {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;

    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data");
    fs::create_dir(&data).unwrap();
    fs::set_permissions(&data, fs::Permissions::from_mode(0o755)).unwrap();
    let open = || {
        database::block_on(async {
            let store = Store::serve(&Address::Folder(data.clone())).await.unwrap();
            Sample::kept(&store).await;
            let files = fs::read_dir(&data).unwrap().map(|file| file.unwrap());
            let mut modes: Vec<(String, u32)> = files
                .map(|file| {
                    (file.file_name().into_string().unwrap(), file.metadata().unwrap().permissions().mode() & 0o777)
                })
                .filter(|(name, _)| name.starts_with("momentous.sqlite"))
                .collect();
            modes.sort();
            modes
        })
    };
    let modes = open();
    assert!(modes.len() > 1 && modes.iter().all(|(_, mode)| *mode == 0o600), "{modes:?}");
    fs::set_permissions(data.join("momentous.sqlite"), fs::Permissions::from_mode(0o644)).unwrap();
    let store = database::block_on(async { Store::beside(&Address::Folder(data.clone())).await.unwrap() });
    drop(store);
    let mode = fs::metadata(data.join("momentous.sqlite")).unwrap().permissions().mode() & 0o777;
    assert_eq!(mode, 0o600, "an earlier program left it open");
}
