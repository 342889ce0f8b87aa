//! `momentous serve retention` says what courses keep, and deletes nothing before its time.

use momentous::course::Course;
use momentous::store::{Address, Store};

use super::server::{folder, run};
use crate::store::sample::Sample;

/// A hundred years: longer than this test is run.
const LONG: u32 = 36_525;

#[test]
fn answers_end_when_they_were_kept_long_enough_and_an_operator_says_so() {
    let room = folder();
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap();
    let address = Address::Folder(room.path().join("data"));
    let sample = runtime.block_on(async {
        let store = Store::serve(&address).await.unwrap();
        let sample = Sample::kept(&store).await;
        store.close().await;
        sample
    });
    let keep = |retention_days: Option<u32>, number: u8| {
        runtime.block_on(async {
            let store = Store::beside(&address).await.unwrap();
            let course = Course { retention_days, ..sample.course.clone() };
            store.save_course(&course, &sample.entry(number)).await.unwrap();
            store.close().await;
        });
    };
    let said = |more: &[&str]| {
        let (code, said) = run(room.path(), &[&["serve", "retention", "--data", "data"], more].concat());
        assert_eq!(code, 0, "{said}");
        said
    };
    let title = "Mechanics <1>: 1 sheet with 0 attempts";
    for (days, number, expected) in [(None, 60, ", kept without end"), (Some(LONG), 61, ", kept until ")] {
        keep(days, number);
        assert!(said(&[]).starts_with(&format!("{title}{expected}")), "{}", said(&[]));
        assert!(said(&["--delete"]).starts_with(&format!("{title}{expected}")), "nothing is deleted before its time");
    }
    keep(Some(1), 62);
    assert!(said(&[]).contains(", kept long enough since "), "{}", said(&[]));
    assert_eq!(said(&["--delete"]), format!("{title}, deleted\n"));
    let left = runtime.block_on(async {
        let store = Store::beside(&address).await.unwrap();
        let trail = store.trail(sample.course.key, 1).await.unwrap();
        (store.records_of(sample.course.key).await.unwrap().sheets, trail[0].what.clone())
    });
    assert_eq!(left, (0, "answers deleted".to_owned()));
}
