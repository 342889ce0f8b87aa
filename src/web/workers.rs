//! Bounded pools for what takes a processor's time: one for each kind of people who ask, so that none is kept waiting by another.

use tokio::sync::{Semaphore, SemaphorePermit};

/// Requests that may wait for each worker; whoever comes later is told to come again.
const WAITING_FOR_EACH: usize = 64;
/// People who may wait at the door together: a year's classes that sign in at the beginning of an exam.
const WAITING_AT_THE_DOOR: usize = 512;

/// For whom work is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lane {
    /// Those who have signed in.
    SignedIn,
    /// Those who are about to: pages with which people sign in, and their passwords.
    Door,
    /// Everybody else.
    Anyone,
}

/// Workers of every lane. Those who have signed in have as many as the machine has cores, and share none of them: the system divides its
/// time evenly, whatever others ask for. These have half as many each.
pub struct Workers([Pool; 3]);

/// Workers, and a queue of bounded length before them.
struct Pool {
    admitted: Semaphore,
    working: Semaphore,
    /// How many of each there are.
    most: [usize; 2],
}

/// Why work was not done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotDone {
    /// The queue is full.
    #[error("many people are asking at this moment")]
    Busy,
    /// The work broke off; the log has the reason.
    #[error("something went wrong here")]
    Broken,
}

/// A place in the queue of a lane: what a request reads before its work is bounded, too.
pub(super) struct Admitted<'w> {
    pool: &'w Pool,
    _place: SemaphorePermit<'w>,
}

impl Workers {
    pub fn new() -> Self {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let half = cores.div_ceil(2);
        let waiting = [cores * WAITING_FOR_EACH, WAITING_AT_THE_DOOR, half * WAITING_FOR_EACH];
        let [signed_in, door, anyone] = waiting;
        Self([Pool::new(cores, signed_in), Pool::new(half, door), Pool::new(half, anyone)])
    }

    /// Requests that wait for a worker.
    pub fn waiting(&self) -> usize {
        self.0.iter().map(Pool::waiting).sum()
    }

    /// A place in the queue of a lane, unless it is full.
    pub(super) fn admit(&self, lane: Lane) -> Result<Admitted<'_>, NotDone> {
        let pool = &self.0[lane as usize];
        Ok(Admitted { pool, _place: pool.admitted.try_acquire().map_err(|_| NotDone::Busy)? })
    }

    /// Does the work on a thread of its own as soon as a worker of the lane is free.
    pub async fn work<T: Send + 'static>(
        &self,
        lane: Lane,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<T, NotDone> {
        self.admit(lane)?.work(work).await
    }
}

impl Admitted<'_> {
    /// Does the work on a thread of its own as soon as a worker is free.
    pub async fn work<T: Send + 'static>(&self, work: impl FnOnce() -> T + Send + 'static) -> Result<T, NotDone> {
        let _working = self.pool.working.acquire().await.map_err(|_| NotDone::Broken)?;
        tokio::task::spawn_blocking(work).await.map_err(|_| NotDone::Broken)
    }
}

impl Pool {
    fn new(working: usize, waiting: usize) -> Self {
        let most = [working, working + waiting];
        Self { admitted: Semaphore::new(most[1]), working: Semaphore::new(working), most }
    }

    fn waiting(&self) -> usize {
        let [working, admitted] = self.most;
        let inside = admitted.saturating_sub(self.admitted.available_permits());
        inside.saturating_sub(working.saturating_sub(self.working.available_permits()))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    fn block_on<T>(future: impl Future<Output = T>) -> T {
        tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap().block_on(future)
    }

    fn workers() -> Workers {
        Workers([Pool::new(1, 0), Pool::new(1, 0), Pool::new(1, 0)])
    }

    #[test]
    fn whoever_finds_the_queue_full_is_turned_away_and_nobody_else() {
        block_on(async {
            let workers = workers();
            let held = workers.admit(Lane::Anyone).unwrap_or_else(|_| panic!("there is a place"));
            assert_eq!(workers.waiting(), 1);
            assert_eq!(workers.work(Lane::Anyone, || 1).await, Err(NotDone::Busy));
            assert_eq!(workers.work(Lane::SignedIn, || 1).await, Ok(1));
            assert_eq!(workers.work(Lane::Door, || 1).await, Ok(1));
            assert_eq!(held.work(|| 2).await, Ok(2), "a place is good for several works");
            assert_eq!(held.work(|| 3).await, Ok(3));
            drop(held);
            assert_eq!(workers.waiting(), 0);
            assert_eq!(workers.work(Lane::Anyone, || 1).await, Ok(1));
        });
    }

    #[test]
    fn work_that_panics_takes_nobody_with_it() {
        block_on(async {
            let workers = workers();
            let broken: Result<(), NotDone> =
                workers.work(Lane::SignedIn, || std::panic::resume_unwind(Box::new(()))).await;
            assert_eq!(broken, Err(NotDone::Broken));
            assert_eq!(workers.work(Lane::SignedIn, || 1).await, Ok(1));
        });
    }
}
