//! A bounded pool for what takes a processor's time.

use tokio::sync::Semaphore;

/// Requests that may wait for each worker; whoever comes later is told to come again.
const WAITING_FOR_EACH: usize = 64;

/// A pool with as many workers as the machine has cores, and a queue of bounded length.
pub(super) struct Workers {
    admitted: Semaphore,
    working: Semaphore,
    /// How many of each there are.
    most: [usize; 2],
}

/// Why work was not done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NotDone {
    /// The queue is full.
    Busy,
    /// The work broke off; the log has the reason.
    Broken,
}

impl Workers {
    pub(super) fn new() -> Self {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        Self::with(cores, cores * (1 + WAITING_FOR_EACH))
    }

    fn with(working: usize, admitted: usize) -> Self {
        let most = [working, admitted];
        Self { admitted: Semaphore::new(admitted), working: Semaphore::new(working), most }
    }

    /// Requests that wait for a worker.
    pub(super) fn waiting(&self) -> usize {
        let [working, admitted] = self.most;
        let inside = admitted.saturating_sub(self.admitted.available_permits());
        inside.saturating_sub(working.saturating_sub(self.working.available_permits()))
    }

    /// Does the work on a thread of its own as soon as a worker is free.
    pub(super) async fn work<T: Send + 'static>(
        &self,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<T, NotDone> {
        let _admitted = self.admitted.try_acquire().map_err(|_| NotDone::Busy)?;
        let _working = self.working.acquire().await.map_err(|_| NotDone::Broken)?;
        tokio::task::spawn_blocking(work).await.map_err(|_| NotDone::Broken)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    fn block_on<T>(future: impl Future<Output = T>) -> T {
        tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap().block_on(future)
    }

    #[test]
    fn whoever_finds_the_queue_full_is_turned_away() {
        block_on(async {
            let workers = Workers::with(1, 1);
            let held = workers.admitted.try_acquire().unwrap();
            assert_eq!(workers.waiting(), 1);
            assert_eq!(workers.work(|| 1).await, Err(NotDone::Busy));
            drop(held);
            assert_eq!(workers.waiting(), 0);
            assert_eq!(workers.work(|| 1).await, Ok(1));
        });
    }

    #[test]
    fn work_that_panics_takes_nobody_with_it() {
        block_on(async {
            let workers = Workers::with(1, 1);
            let broken: Result<(), NotDone> = workers.work(|| std::panic::resume_unwind(Box::new(()))).await;
            assert_eq!(broken, Err(NotDone::Broken));
            assert_eq!(workers.work(|| 1).await, Ok(1));
        });
    }
}
