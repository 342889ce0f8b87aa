//! What is decided about answers: corrections taken in, and the end of what is kept.

use momentous::course::{Attempt, Correction, CorrectionChoice, Item, Key, OverrideRule};
use momentous::store::{HandIn, Inspection, Records, Regrade, Store};

use super::NOW;
use super::database::on_both;
use super::sample::Sample;

/// Hands in an attempt of that number.
async fn hand_in(store: &Store, sample: &Sample, number: u32) -> Attempt {
    let attempt = sample.attempt(number, &format!("request {number}"));
    let revision = sample.revision(store).await;
    store.hand_in(HandIn { attempt: &attempt, assignment: sample.whole.assignment.key, revision }).await.unwrap();
    attempt
}

fn correction(item: &Item) -> Correction {
    let (choice, comment) = (CorrectionChoice::Remark, String::new());
    let (from, to, reason) = ("a".into(), "b".into(), "r".into());
    Correction { item: item.key, from, to, choice, never_lower: true, reason, comment, at: NOW }
}

#[test]
fn of_two_who_take_a_correction_in_one_is_told_that_something_changed() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let attempt = hand_in(&store, &sample, 1).await;
        let item = Item { digest: Some("b".into()), ..sample.whole.items[0].clone() };
        let report = serde_json::value::to_raw_value("marked anew").unwrap();
        let attempts = [Attempt { report, ..attempt }];
        let (revision, correction) = (sample.revision(&store).await, correction(&item));
        let handed_in = store.attempts_at(item.key).await.unwrap();
        let least = [(Key::new([79; 16]), sample.set(Some("3"), OverrideRule::AtLeast))];
        let step =
            Regrade { item: &item, correction: &correction, attempts: &attempts, kept: &least, revision, handed_in };
        let [one, other] = [sample.entry(80), sample.entry(81)];
        let (one, other) = tokio::join!(
            store.regrade(Key::new([80; 16]), &step, &one),
            store.regrade(Key::new([81; 16]), &step, &other),
        );
        assert_eq!(u8::from(one.unwrap()) + u8::from(other.unwrap()), 1);
        let kept = store.attempts(sample.sheet.key).await.unwrap();
        assert_eq!((kept.len(), kept[0].report.get()), (1, "\"marked anew\""));
        assert_eq!(store.corrections(sample.whole.assignment.key).await.unwrap(), [correction]);
        assert_eq!(store.trail(sample.course.key, 10).await.unwrap().len(), 3, "who was refused left nothing");
        let set = store.set_by_hand_of(sample.whole.assignment.key, sample.member.key).await.unwrap();
        assert_eq!(set, [least[0].1.clone()]);
        assert!(store.set_by_hand_of(sample.whole.assignment.key, Key::new([99; 16])).await.unwrap().is_empty());
        assert!(sample.revision(&store).await > revision);
    });
}

#[test]
fn a_correction_that_overlooks_an_attempt_is_not_taken_in() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        let item = sample.whole.items[0].clone();
        let (revision, correction) = (sample.revision(&store).await, correction(&item));
        let handed_in = store.attempts_at(item.key).await.unwrap();
        hand_in(&store, &sample, 1).await;
        let step = Regrade { item: &item, correction: &correction, attempts: &[], kept: &[], revision, handed_in };
        assert!(!store.regrade(Key::new([82; 16]), &step, &sample.entry(82)).await.unwrap());
        let step = Regrade { handed_in: handed_in + 1, ..step };
        assert!(store.regrade(Key::new([82; 16]), &step, &sample.entry(82)).await.unwrap());
        assert_eq!(store.all_attempts(sample.whole.assignment.key).await.unwrap().len(), 1);
    });
}

#[test]
fn the_answers_of_a_course_end_and_its_people_stay() {
    on_both(async |database| {
        let store = database.serve().await;
        let sample = Sample::kept(&store).await;
        hand_in(&store, &sample, 1).await;
        let points = sample.set(None, OverrideRule::Exactly);
        store.set_points(Key::new([83; 16]), &points, &sample.entry(83)).await.unwrap();
        assert_eq!(store.last_close(sample.course.key).await.unwrap(), Some(sample.whole.assignment.policy.closes));
        let records = Records { sheets: 1, attempts: 1, by_hand: 1 };
        assert_eq!(store.records_of(sample.course.key).await.unwrap(), records);
        store.forget_answers(Key::new([99; 16]), &sample.entry(84)).await.unwrap();
        assert_eq!(store.records_of(sample.course.key).await.unwrap(), records, "another course's stay");
        store.forget_answers(sample.course.key, &sample.entry(85)).await.unwrap();
        assert_eq!(store.records_of(sample.course.key).await.unwrap(), Records::default());
        assert_eq!(store.members(sample.course.key).await.unwrap().len(), 1);
    });
}

#[test]
fn an_inspection_changes_nothing() {
    on_both(async |database| {
        let address = database.address();
        let before = Inspection::of(&address).await.unwrap();
        assert_eq!((before.version, before.latest, before.lacks_rights), (None, None, false));
        assert_eq!(Inspection::of(&address).await.unwrap().version, None, "it made nothing");
        let store = database.serve().await;
        Sample::kept(&store).await;
        let found = Inspection::of(&address).await.unwrap();
        assert_eq!((found.version, found.latest, found.is_earlier()), (Some(4), Some(NOW), false));
        let is_folder = matches!(address, momentous::store::Address::Folder(_));
        assert_eq!((found.is_served, found.now.is_none()), (is_folder, is_folder));
    });
}
