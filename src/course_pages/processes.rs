//! The program once more, in a process whose time and memory are bounded: whatever a teacher's file asks for, the server goes on.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::timeout;

use momentous_course::{Key, Person};
use momentous_fault::Input;

/// Processes that run at the same time, for everybody together.
const MOST: usize = 2;
/// The time for which somebody waits for a turn.
const PATIENCE: Duration = Duration::from_secs(10);
/// The memory of a process in kilobytes; addresses are counted, of which it takes more than it fills.
const MEMORY: &str = "4000000";
/// The blocks of 512 bytes that a process may write.
const WRITTEN: &str = "4096";
/// How often it is looked whether a process has ended.
const PAUSE: Duration = Duration::from_millis(5);
/// The bytes of what it prints that are read.
const SHOWN: u64 = 1 << 22;
/// The file in its folder to which it prints.
const PRINTED: &str = "printed.txt";

/// The turns with processes.
pub(super) struct Processes {
    free: Arc<Semaphore>,
    working: Mutex<BTreeSet<Key<Person>>>,
}

/// A turn with a process. It ends with the process, also where whoever asked has gone.
pub(super) struct Turn {
    _working: Working,
    _free: OwnedSemaphorePermit,
}

/// Somebody who has a turn, or waits for one.
struct Working {
    of: Arc<Processes>,
    person: Key<Person>,
}

/// The end of a process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ended {
    /// By itself, with a code.
    Exit(i32),
    /// It took too much memory or processor time.
    TooMuch,
    /// It took too long.
    TooLong,
}

impl Processes {
    pub(super) fn new() -> Arc<Self> {
        Arc::new(Self { free: Arc::new(Semaphore::new(MOST)), working: Mutex::default() })
    }

    /// A turn for a person, where there is one: each has one at a time.
    pub(super) async fn turn(self: &Arc<Self>, person: Key<Person>) -> Option<Turn> {
        if !self.working().insert(person) {
            return None;
        }
        let working = Working { of: Arc::clone(self), person };
        let free = timeout(PATIENCE, Arc::clone(&self.free).acquire_owned()).await.ok()?.ok()?;
        Some(Turn { _working: working, _free: free })
    }

    fn working(&self) -> MutexGuard<'_, BTreeSet<Key<Person>>> {
        self.working.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Working {
    fn drop(&mut self) {
        self.of.working().remove(&self.person);
    }
}

impl Turn {
    /// Runs the program in a folder, for so long at most, which bounds its processor time, too; how it ended, and what it printed.
    pub(super) fn run(
        self,
        program: Option<&Path>,
        folder: &Path,
        arguments: &[&str],
        longest: Duration,
    ) -> io::Result<(Ended, String)> {
        let program = program.map_or_else(std::env::current_exe, |program| Ok(program.to_owned()))?;
        let printed = folder.join(PRINTED);
        let output = fs::File::create(&printed)?;
        let mut child = limited(&program, longest)
            .args(arguments)
            .current_dir(folder)
            .env_clear()
            .env("RAYON_NUM_THREADS", "1")
            .env("NO_COLOR", "1")
            .stdin(Stdio::null())
            .stdout(output.try_clone()?)
            .stderr(output)
            .spawn()?;
        let start = Instant::now();
        let ended = loop {
            match child.try_wait()? {
                Some(status) => break status.code().map_or(Ended::TooMuch, Ended::Exit),
                None if start.elapsed() > longest => {
                    child.kill()?;
                    child.wait()?;
                    break Ended::TooLong;
                }
                None => thread::sleep(PAUSE),
            }
        };
        let printed = Input::open(&printed)?.text(SHOWN)?;
        drop(self);
        Ok((ended, printed))
    }
}

/// The program with less memory and time than it would have. The system ends it even if the server has gone.
#[cfg(unix)]
fn limited(program: &Path, longest: Duration) -> Command {
    const LIMITS: &str = "ulimit -v \"$1\" && ulimit -t \"$2\" && ulimit -f \"$3\" && shift 3 && exec \"$@\"";
    let mut command = Command::new("/bin/sh");
    command.args(["-c", LIMITS, "sh", MEMORY, &longest.as_secs().to_string(), WRITTEN]).arg(program);
    command
}

/// Elsewhere only its time is bounded.
#[cfg(not(unix))]
fn limited(program: &Path, _longest: Duration) -> Command {
    Command::new(program)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test says bluntly what it expects")]
mod tests {
    use super::*;

    #[test]
    fn each_has_one_turn_at_a_time_and_all_together_a_few() {
        tokio::runtime::Builder::new_current_thread().enable_time().build().unwrap().block_on(async {
            let processes = Processes::new();
            let [one, other, third] = [1, 2, 3].map(|number| Key::new([number; 16]));
            let held = processes.turn(one).await.unwrap();
            assert!(processes.turn(one).await.is_none());
            let beside = processes.turn(other).await.unwrap();
            let soon = timeout(Duration::from_millis(1), processes.turn(third)).await;
            assert!(soon.is_err(), "whoever comes later waits");
            drop(held);
            assert!(processes.turn(third).await.is_some());
            drop(beside);
            assert!(processes.turn(one).await.is_some() && processes.turn(other).await.is_some());
        });
    }
}
