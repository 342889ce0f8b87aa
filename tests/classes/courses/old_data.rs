//! Data that were written by an earlier program open, with the same sheets and the same marks. `tests/fixtures/data/` has a folder for
//! each version of the tables: the data as they were, and the gradebook as it was.

use std::fs;
use std::path::{Path, PathBuf};

use momentous::course::{Extension, Key, MailAddress, Moment, Override, OverrideRule};
use momentous::store::sqlx::{AnyConnection, Connection, Executor};
use momentous::store::{Address, Inspection, Store};
use momentous::web::Settings;

use super::student::{form, right};
use super::university::{BEGIN, DAY, University};

const FOLDER: &str = "tests/fixtures/data";
const DATA: &str = "momentous.sqlite";
const GRADEBOOK: &str = "gradebook.csv";

/// A place of the course's only assignment.
fn assignment(university: &University, path: &str) -> String {
    university.address(&format!("/assignments/{}{path}", Key::<()>::new([9; 16])))
}

/// The gradebook after the close.
fn gradebook(university: &University) -> String {
    university.set_clock(4 * DAY);
    university.browser_of("ida").get(&assignment(university, "/gradebook.csv")).text(200)
}

/// The folders of all versions, the oldest first.
fn versions() -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = fs::read_dir(FOLDER).unwrap().map(|entry| entry.unwrap().path()).collect();
    all.sort();
    all
}

#[test]
fn data_of_every_version_open_with_the_same_sheets_and_marks() {
    assert!(!versions().is_empty());
    for version in versions() {
        let room = tempfile::tempdir().unwrap();
        fs::create_dir(room.path().join("data")).unwrap();
        fs::copy(version.join(DATA), room.path().join("data").join(DATA)).unwrap();
        let university = University::over(room, Settings::default());
        assert_eq!(
            gradebook(&university),
            fs::read_to_string(version.join(GRADEBOOK)).unwrap(),
            "{}",
            version.display()
        );
        for login in ["ada", "bob"] {
            let sheets = university.wait(async |store| store.sheets_of(University::member(login)).await.unwrap());
            let (exercise, _) = right(&university, login);
            assert_eq!(exercise.issue(None, sheets[0].issued.decimal).statement, sheets[0].issued.statement);
            let address = university.address(&format!("/items/{}", sheets[0].item));
            let page = university.browser_of(login).get(&address).text(200);
            assert!(page.contains("Mon, 1 Dec 2025"), "what was handed in is listed: {page}");
        }
    }
}

#[test]
fn a_copy_of_every_version_can_be_taken_in() {
    let room = tempfile::tempdir().unwrap();
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap();
    for (version, number) in versions().iter().zip(1..) {
        let address = Address::Folder(room.path().join(number.to_string()));
        runtime.block_on(async {
            let store = Store::serve(&address).await.unwrap();
            store.restore(&version.join(DATA)).await.unwrap();
            assert_eq!(store.courses().await.unwrap().len(), 2, "{}", version.display());
        });
    }
}

#[test]
fn this_version_is_among_them() {
    let room = tempfile::tempdir().unwrap();
    let address = Address::Folder(room.path().join("data"));
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap();
    let version = runtime.block_on(async {
        drop(Store::serve(&address).await.unwrap());
        Inspection::of(&address).await.unwrap().version.unwrap()
    });
    let folder = Path::new(FOLDER).join(version.to_string());
    assert!(folder.is_dir(), "write {}: `cargo test --test classes -- --ignored write_the_data`", folder.display());
}

#[test]
#[ignore = "writes tests/fixtures/data/4: a new version of the tables gets a new folder"]
fn write_the_data_of_this_version() {
    let university = University::new();
    let whole = university.assignment(&[("impact/two-carts", "forward", 10)], |_| {});
    let address = university.address(&format!("/items/{}", whole.items[0].key));
    for login in ["ada", "bob"] {
        let mut browser = university.browser_of(login);
        browser.get(&address).text(200);
        browser.post(&address, &form("1", &[("answer.v_A2", "97.0 m/s"), ("answer.v_B2", "3..2")])).to();
        browser.post(&format!("{address}/hint"), &[("answer.T_lost", "half of it")]).to();
        university.set_clock(DAY + 1);
        let (_, answers) = right(&university, login);
        browser
            .post(&address, &form("2", &[("answer.v_A2", &answers["v_A2"]), ("answer.v_B2", &answers["v_B2"])]))
            .to();
        university.set_clock(0);
    }
    let at = Moment::from_millis(BEGIN + DAY);
    let (assignment, member, closes) = (whole.assignment.key, University::member("bob"), at.after(5 * DAY));
    let extension =
        Extension { assignment, member, due: at.after(DAY), late_until: None, closes, reason: "was ill".into() };
    let folder = Path::new(FOLDER).join("4");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join(DATA);
    let copy = format!("sqlite://{}", file.display());
    university.wait(async |store| {
        store.extend(&[(extension, University::entry(90))]).await.unwrap();
        let sheets = store.sheets_of(University::member("ada")).await.unwrap();
        let (sheet, by) = (sheets[0].key, University::key("ida"));
        let (reason, comment, rule) = ("a clear drawing".into(), String::new(), OverrideRule::Exactly);
        let points = Override { sheet, points: Some("19/2".into()), rule, reason, comment, by, at };
        let address = MailAddress::read("ada@example.edu").unwrap();
        store.set_mail_address(University::key("ada"), Some(&address), &[]).await.unwrap();
        store.set_points(Key::new([91; 16]), &points, &University::entry(91)).await.unwrap();
        store.backup(&file).await.unwrap();
        let mut connection = AnyConnection::connect(&copy).await.unwrap();
        connection.execute("PRAGMA page_size = 1024; VACUUM").await.unwrap();
    });
    fs::write(folder.join(GRADEBOOK), gradebook(&university)).unwrap();
}
