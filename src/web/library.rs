//! The problems that a server shows, compiled when they are first wanted.

use std::collections::BTreeMap;
use std::path::Path;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::Mutex;
use std::sync::MutexGuard;
use std::sync::PoisonError;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::SystemTime;

use momentous_bank::Bank;
use momentous_bank::Exhibit;
use momentous_bank::files_under;
use momentous_bank::load_in_course;
use momentous_exercise::calls::{Problems, Refused, RefusedKind};
use momentous_exercise::titled;
use momentous_fault::Faults;
use momentous_fault::Source;
use momentous_problem::Problem;
use momentous_problem::compile;

/// The problems of a bank, and behind them those that are built in. It holds no more compiled problems than these have files.
pub struct Library {
    watched: Option<PathBuf>,
    built_in: Bank,
    shelf: Mutex<Shelf>,
    looked_up: AtomicU64,
}

/// A bank as it was read.
struct Shelf {
    bank: Arc<Bank>,
    /// What the watched files looked like.
    stamp: u64,
    compiled: BTreeMap<String, Arc<Problem>>,
    exhibits: Option<Arc<Vec<Exhibit>>>,
}

impl Library {
    /// The bank of the current folder, or of the folder that is watched.
    pub(super) fn open(watched: Option<&Path>) -> Result<Self, Faults> {
        let stamp = watched.map_or(0, stamp);
        let shelf = Shelf { bank: Arc::new(read(watched)?), stamp, compiled: BTreeMap::new(), exhibits: None };
        Ok(Self {
            watched: watched.map(Path::to_owned),
            built_in: Bank::built_in(),
            shelf: Mutex::new(shelf),
            looked_up: AtomicU64::new(0),
        })
    }

    /// How often a problem was looked up.
    pub fn looked_up(&self) -> u64 {
        self.looked_up.load(Ordering::Relaxed)
    }

    /// What the watched files look like: it changes whenever one of them is saved.
    pub fn stamp(&self) -> u64 {
        self.watched.as_deref().map_or(0, stamp)
    }

    /// All problems that load as a gallery shows them, in the order of their identities.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn exhibits(&self) -> Result<Arc<Vec<Exhibit>>, Refused> {
        let bank = {
            let shelf = self.shelf()?;
            if let Some(exhibits) = &shelf.exhibits {
                return Ok(Arc::clone(exhibits));
            }
            Arc::clone(&shelf.bank)
        };
        let loaded = bank.sources().filter_map(|source| load_in_course(source.clone()).ok());
        let exhibits = Arc::new(loaded.map(|loaded| Exhibit::of(&loaded)).collect::<Vec<_>>());
        self.shelf()?.exhibits = Some(Arc::clone(&exhibits));
        Ok(exhibits)
    }

    /// What a person calls a problem: its title, or for those of a course what its identity says.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn title(&self, id: &str) -> Result<String, Refused> {
        let exhibits = self.exhibits()?;
        let found = exhibits.iter().find(|exhibit| exhibit.card.id == id).map(|exhibit| exhibit.card.title.clone());
        Ok(found.unwrap_or_else(|| titled(id.rsplit('/').next().unwrap_or(id))))
    }

    /// The file of a problem of the bank.
    ///
    /// # Errors
    /// There is no such problem, or the folder cannot be read.
    pub fn source(&self, id: &str) -> Result<Source, Refused> {
        let shelf = self.shelf()?;
        // The scenes of the simulators are there whatever bank is shown.
        let found = shelf.bank.find(id).or_else(|faults| self.built_in.find(id).map_err(|_| faults));
        found.cloned().map_err(|faults| unknown(&faults))
    }

    /// The shelf; under watch it is read anew where a file was saved.
    fn shelf(&self) -> Result<MutexGuard<'_, Shelf>, Refused> {
        // Whoever panicked while holding it left it whole: every change is one assignment.
        let mut shelf = self.shelf.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(folder) = &self.watched {
            let seen = stamp(folder);
            if seen != shelf.stamp {
                let bank = read(Some(folder)).map_err(|faults| Refused::fault(&faults))?;
                *shelf = Shelf { bank: Arc::new(bank), stamp: seen, compiled: BTreeMap::new(), exhibits: None };
            }
        }
        Ok(shelf)
    }
}

impl Problems for Library {
    fn problem(&self, id: &str) -> Result<Arc<Problem>, Refused> {
        self.looked_up.fetch_add(1, Ordering::Relaxed);
        let source = {
            let shelf = self.shelf()?;
            if let Some(problem) = shelf.compiled.get(id) {
                return Ok(Arc::clone(problem));
            }
            drop(shelf);
            self.source(id)?
        };
        // Others are served while it compiles; where two compile it at once, both have the same.
        let problem = load_in_course(source).and_then(|loaded| compile(loaded, None));
        let problem = Arc::new(problem.map_err(|faults| Refused::fault(&faults))?);
        self.shelf()?.compiled.insert(id.to_owned(), Arc::clone(&problem));
        Ok(problem)
    }
}

fn unknown(faults: &Faults) -> Refused {
    let Some(fault) = faults.list.first() else { return Refused::fault(faults) };
    let refused = Refused::new(RefusedKind::Unknown, fault.message.clone());
    match fault.help.as_deref().filter(|help| help.starts_with("did you mean")) {
        Some(help) => refused.help(help),
        None => refused.help("the start page lists every problem"),
    }
}

fn read(watched: Option<&Path>) -> Result<Bank, Faults> {
    watched.map_or_else(Bank::here, Bank::in_folder)
}

/// A number that changes with the names, lengths and times of the files of a folder.
fn stamp(folder: &Path) -> u64 {
    use std::hash::{DefaultHasher, Hash, Hasher};
    let mut hasher = DefaultHasher::new();
    for path in files_under(folder).unwrap_or_default() {
        let found = path.metadata();
        let changed = found.as_ref().ok().and_then(|found| found.modified().ok()).unwrap_or(SystemTime::UNIX_EPOCH);
        (path, found.map_or(0, |found| found.len()), changed).hash(&mut hasher);
    }
    hasher.finish()
}
