//! What is decided about answers: corrections taken in, and the end of what is kept.

use momentous::course::{Attempt, Correction, CorrectionChoice, Item, Key, OverrideRule};
use momentous::store::{HandIn, Inspection, Records, Regrade, Store};

use super::NOW;
use super::database::on_both;
use super::sample::Sample;

/// Hands in an attempt of that number.
async fn hand_in(store: &Store, own: &Sample, number: u32) -> Attempt {
    let attempt = own.attempt(number, &format!("request {number}"));
    let revision = own.revision(store).await;
    store.hand_in(HandIn { attempt: &attempt, assignment: own.whole.assignment.key, revision }).await.unwrap();
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
        let own = Sample::kept(&store).await;
        let attempt = hand_in(&store, &own, 1).await;
        let item = Item { digest: Some("b".into()), ..own.whole.items[0].clone() };
        let report = serde_json::value::to_raw_value("marked anew").unwrap();
        let attempts = [Attempt { report, ..attempt }];
        let (revision, correction) = (own.revision(&store).await, correction(&item));
        let handed_in = store.attempts_at(item.key).await.unwrap();
        let least = [(Key::new([79; 16]), own.set(Some("3"), OverrideRule::AtLeast))];
        let step =
            Regrade { item: &item, correction: &correction, attempts: &attempts, kept: &least, revision, handed_in };
        let [one, other] = [own.entry(80), own.entry(81)];
        let (one, other) = tokio::join!(
            store.regrade(Key::new([80; 16]), &step, &one),
            store.regrade(Key::new([81; 16]), &step, &other),
        );
        assert_eq!(u8::from(one.unwrap()) + u8::from(other.unwrap()), 1);
        let kept = store.attempts(own.sheet.key).await.unwrap();
        assert_eq!((kept.len(), kept[0].report.get()), (1, "\"marked anew\""));
        assert_eq!(store.corrections(own.whole.assignment.key).await.unwrap(), [correction]);
        assert_eq!(store.trail(own.course.key, 10).await.unwrap().len(), 3, "who was refused left nothing");
        let set = store.set_by_hand_of(own.whole.assignment.key, own.member.key).await.unwrap();
        assert_eq!(set, [least[0].1.clone()]);
        assert!(store.set_by_hand_of(own.whole.assignment.key, Key::new([99; 16])).await.unwrap().is_empty());
        assert!(own.revision(&store).await > revision);
    });
}

#[test]
fn a_correction_that_overlooks_an_attempt_is_not_taken_in() {
    on_both(async |database| {
        let store = database.serve().await;
        let own = Sample::kept(&store).await;
        let item = own.whole.items[0].clone();
        let (revision, correction) = (own.revision(&store).await, correction(&item));
        let handed_in = store.attempts_at(item.key).await.unwrap();
        hand_in(&store, &own, 1).await;
        let step = Regrade { item: &item, correction: &correction, attempts: &[], kept: &[], revision, handed_in };
        assert!(!store.regrade(Key::new([82; 16]), &step, &own.entry(82)).await.unwrap());
        let step = Regrade { handed_in: handed_in + 1, ..step };
        assert!(store.regrade(Key::new([82; 16]), &step, &own.entry(82)).await.unwrap());
        assert_eq!(store.all_attempts(own.whole.assignment.key).await.unwrap().len(), 1);
    });
}

#[test]
fn the_answers_of_a_course_end_and_its_people_stay() {
    on_both(async |database| {
        let store = database.serve().await;
        let own = Sample::kept(&store).await;
        hand_in(&store, &own, 1).await;
        let points = own.set(None, OverrideRule::Exactly);
        store.set_points(Key::new([83; 16]), &points, &own.entry(83)).await.unwrap();
        assert_eq!(store.last_close(own.course.key).await.unwrap(), Some(own.whole.assignment.policy.closes));
        let records = Records { sheets: 1, attempts: 1, by_hand: 1 };
        assert_eq!(store.records_of(own.course.key).await.unwrap(), records);
        store.forget_answers(Key::new([99; 16]), &own.entry(84)).await.unwrap();
        assert_eq!(store.records_of(own.course.key).await.unwrap(), records, "another course's stay");
        store.forget_answers(own.course.key, &own.entry(85)).await.unwrap();
        assert_eq!(store.records_of(own.course.key).await.unwrap(), Records::default());
        assert_eq!(store.members(own.course.key).await.unwrap().len(), 1);
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
        assert_eq!((found.version, found.latest, found.is_earlier()), (Some(3), Some(NOW), false));
        let is_folder = matches!(address, momentous::store::Address::Folder(_));
        assert_eq!((found.is_served, found.now.is_none()), (is_folder, is_folder));
    });
}
