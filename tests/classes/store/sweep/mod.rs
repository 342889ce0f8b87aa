//! What is acknowledged is kept, and kept once, whatever happens to the database: every write of the store, with every fault at every
//! place of it.

use std::future::poll_fn;
use std::pin::pin;
use std::task::Poll;

use momentous::course::{Key, Sheet};
use momentous::store::{Address, Store, StoreFault};

use super::database::{Database, on_both};
use base::{Base, Whole, whole};
use fault::{Fault, Lasting};
use proxy::{Moment, Proxy};
use writes::{WRITES, Write, draft};

mod base;
mod fault;
mod proxy;
mod writes;

/// The faults of a database, each at the beginning of a write.
fn faults(database: &Database) -> Vec<Fault> {
    let both = [Fault::Refused(0), Fault::AtCommit, Fault::Left(0)];
    let faults = match database {
        Database::Folder(_) => vec![Fault::Full(0), Fault::Locked, Fault::Exhausted],
        Database::Postgres(_) => {
            [Moment::Before, Moment::Within, Moment::After].map(|moment| Fault::Cut(0, moment)).to_vec()
        }
    };
    faults.into_iter().chain(both).collect()
}

/// Sheets of nobody, whose drafts are written beside what is tried, and by the request that comes next.
fn of_nobody() -> [Key<Sheet>; 3] {
    [201, 202, 203].map(|number| Key::new([number; 16]))
}

/// Carries out a write; it is given up after looking so many times whether it is done.
async fn until_left(
    looks: usize,
    write: impl Future<Output = Result<bool, StoreFault>>,
) -> Option<Result<bool, StoreFault>> {
    let mut left = looks;
    let mut write = pin!(write);
    poll_fn(|context| {
        if left == 0 {
            return Poll::Ready(None);
        }
        left -= 1;
        write.as_mut().poll(context).map(Some)
    })
    .await
}

/// The draft of a sheet of nobody, where it is kept.
fn kept_draft(whole: &Whole, sheet: Key<Sheet>) -> bool {
    whole["draft"].iter().any(|row| row[0].contains(&sheet.to_string()))
}

/// All but the drafts of nobody.
fn without_drafts(mut whole: Whole) -> Whole {
    let sheets = of_nobody().map(|sheet| sheet.to_string());
    whole.get_mut("draft").unwrap().retain(|row| !sheets.iter().any(|sheet| row[0].contains(sheet)));
    whole
}

/// Tries a write with a fault. Says whether it came to the place of the fault.
async fn meets(base: &Base, number: usize, write: &Write, fault: Fault) -> bool {
    let said = format!("{} with {fault:?}", write.name);
    let database = base.copy().await;
    let proxy = match &database {
        Database::Postgres(url) => Some(Proxy::before(url).await),
        Database::Folder(_) => None,
    };
    let through = proxy.as_ref().map_or_else(|| database.address(), |proxy| Address::Postgres(proxy.url.clone()));
    let store = Store::serve(&through).await.unwrap();
    let lasting = Lasting::of(fault, &database, &store, proxy.as_ref()).await;
    let looks = if let Fault::Left(looks) = fault { looks } else { usize::MAX };
    let [one_beside, other_beside, of_next] = of_nobody();
    let beside = [one_beside, other_beside].map(|sheet| draft(sheet, "1"));
    let tried = until_left(looks, (write.run)(&store, &base.tried));
    let (one, told, other) = if fault == Fault::Locked {
        // Others would wait for the lock as long as it is held.
        (None, tried.await, None)
    } else {
        let (one, told, other) = tokio::join!(store.save_draft(&beside[0]), tried, store.save_draft(&beside[1]));
        (Some(one), told, Some(other))
    };
    if fault == Fault::Locked {
        // Nobody has to wait here.
        store.set("PRAGMA busy_timeout = 0").await.unwrap();
    }
    let is_ill = store.health().await.is_err();
    let is_met = lasting.ended(&store).await;
    let acknowledged = matches!(told, Some(Ok(true)));

    let kept = whole(&database).await;
    for (told, sheet) in [(&one, one_beside), (&other, other_beside)] {
        assert!(
            !matches!(told, Some(Ok(()))) || kept_draft(&kept, sheet),
            "{said}: what was acknowledged beside it is lost"
        );
    }
    let kept = without_drafts(kept);
    if acknowledged {
        assert_eq!(kept, base.after[number], "{said}: what was acknowledged is lost");
    } else {
        assert!(kept == base.before || kept == base.after[number], "{said}: half of it is kept: {kept:#?}");
    }
    let refuses = matches!(fault, Fault::Refused(0) | Fault::AtCommit | Fault::Exhausted | Fault::Locked);
    assert!(!refuses || is_ill, "{said}: a server that keeps nothing is not well");

    let next = store.save_draft(&draft(of_next, "1")).await;
    assert!(next.is_ok(), "{said}: the next request is refused: {next:?}");
    assert_eq!(store.health().await, Ok(()), "{said}: all is well again");
    // The same form is sent again.
    let again = (write.run)(&store, &base.tried).await;
    let is_taken = again.as_ref().is_err_and(StoreFault::is_taken);
    assert!(again.is_ok() || is_taken, "{said}: {again:?}");
    store.close().await;
    let kept = whole(&database).await;
    assert!(kept_draft(&kept, of_next), "{said}: what was acknowledged next is lost");
    assert_eq!(without_drafts(kept), base.after[number], "{said}: once, after it was sent again");
    base.forget(database).await;
    let all = [one.is_none_or(|told| told.is_ok()), acknowledged, other.is_none_or(|told| told.is_ok())];
    is_met && all.contains(&false)
}

/// Tries every write with every fault, at each of its places, or at one in so many.
async fn sweep(database: &Database, step: usize) {
    let base = Base::made(database.another().await).await;
    let mut count = 0;
    for (number, write) in WRITES.iter().enumerate() {
        for fault in faults(database) {
            let mut next = Some(fault);
            for place in number.. {
                let Some(fault) = next else { break };
                next = fault.later();
                if place % step == 0 || next.is_none() {
                    count += 1;
                    if !meets(&base, number, write, fault).await {
                        break;
                    }
                }
            }
        }
    }
    eprintln!("{}: {count} faults, nothing acknowledged is lost and nothing is there twice", database.address());
}

#[test]
fn whatever_goes_wrong_nothing_acknowledged_is_lost() {
    on_both(async |database| sweep(database, 11).await);
}

#[test]
#[ignore = "takes minutes: .ci/soak faults"]
fn whatever_goes_wrong_anywhere_nothing_acknowledged_is_lost() {
    on_both(async |database| sweep(database, 1).await);
}
