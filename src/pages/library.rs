//! The problems that pages show, compiled when they are first wanted.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use momentous_bank::{Bank, Exhibit, load_in_course};
use momentous_exercise::calls::{Problems, Refused, RefusedKind};
use momentous_exercise::titled;
use momentous_fault::{Faults, Source};
use momentous_problem::{Course, Loaded, Problem, compile, load};

use super::watched;

/// The problems of a bank, and behind them those that are built in. It holds no more compiled problems than these have files.
pub struct Library {
    watched: Option<PathBuf>,
    settings: CourseSettings,
    built_in: Bank,
    shelf: Mutex<Shelf>,
    looked_up: AtomicU64,
}

/// The place of the settings of the course to which a file belongs.
enum CourseSettings {
    /// In the folder of the file, or above it.
    InFolders,
    /// At hand, by the names of files.
    AtHand(BTreeMap<String, Course>),
}

/// A bank as it was read.
struct Shelf {
    bank: Arc<Bank>,
    /// A number for the state of the watched files.
    stamp: u64,
    compiled: BTreeMap<String, Arc<Problem>>,
    exhibits: Option<Arc<Vec<Exhibit>>>,
}

impl Shelf {
    fn new(bank: Bank, stamp: u64) -> Self {
        Self { bank: Arc::new(bank), stamp, compiled: BTreeMap::new(), exhibits: None }
    }
}

impl Library {
    /// The problems of a bank.
    #[must_use]
    pub fn of(bank: Bank) -> Self {
        Self {
            watched: None,
            settings: CourseSettings::InFolders,
            built_in: Bank::built_in(),
            shelf: Mutex::new(Shelf::new(bank, 0)),
            looked_up: AtomicU64::new(0),
        }
    }

    /// The same without a look at folders: the settings of the courses to which problems belong are these, by the names of files.
    #[must_use]
    pub fn in_courses(self, courses: BTreeMap<String, Course>) -> Self {
        Self { settings: CourseSettings::AtHand(courses), ..self }
    }

    /// The bank of the current folder, or of the folder that is watched.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn open(folder: Option<&Path>) -> Result<Self, Faults> {
        let stamp = folder.map_or(0, watched::stamp);
        let shelf = Mutex::new(Shelf::new(watched::bank(folder)?, stamp));
        Ok(Self { watched: folder.map(Path::to_owned), shelf, ..Self::of(Bank::built_in()) })
    }

    /// The number of times that a problem was looked up.
    pub fn looked_up(&self) -> u64 {
        self.looked_up.load(Ordering::Relaxed)
    }

    /// A number that changes with the watched files; nothing where none are watched.
    pub fn stamp(&self) -> Option<u64> {
        self.watched.as_deref().map(watched::stamp)
    }

    fn load(&self, source: &Source) -> Result<Loaded, Faults> {
        match &self.settings {
            CourseSettings::InFolders => load_in_course(source.clone()),
            CourseSettings::AtHand(courses) => {
                let loaded = load(source.clone())?;
                Ok(match courses.get(&*source.name) {
                    Some(course) => loaded.in_course(course),
                    None => loaded,
                })
            }
        }
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
        let loaded = bank.sources().filter_map(|source| self.load(source).ok());
        let exhibits = Arc::new(loaded.map(|loaded| Exhibit::of(&loaded)).collect::<Vec<_>>());
        self.shelf()?.exhibits = Some(Arc::clone(&exhibits));
        Ok(exhibits)
    }

    /// The name that people give to a problem: its title, or for those of a course what its identity says.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn title(&self, id: &str) -> Result<String, Refused> {
        Ok(self.known_title(id)?.unwrap_or_else(|| titled(id.rsplit('/').next().unwrap_or(id))))
    }

    /// The title of a problem of the bank; nothing where the bank has none of this identity.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn known_title(&self, id: &str) -> Result<Option<String>, Refused> {
        let exhibits = self.exhibits()?;
        Ok(exhibits.iter().find(|exhibit| exhibit.card.id == id).map(|exhibit| exhibit.card.title.clone()))
    }

    /// The file of a problem of the bank.
    ///
    /// # Errors
    /// There is no such problem, or the folder cannot be read.
    pub fn source(&self, id: &str) -> Result<Source, Refused> {
        let shelf = self.shelf()?;
        // The scenes of the simulators are there whatever bank is shown.
        let source = shelf.bank.find(id).or_else(|faults| self.built_in.find(id).map_err(|_| faults));
        source.cloned().map_err(|faults| unknown(&faults))
    }

    /// The shelf; under watch it is read anew where a file was saved.
    fn shelf(&self) -> Result<MutexGuard<'_, Shelf>, Refused> {
        // Whoever panicked while holding it left it whole: every change is one assignment.
        let mut shelf = self.shelf.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((folder, stamp)) = self.watched.as_deref().zip(self.stamp())
            && stamp != shelf.stamp
        {
            let bank = watched::bank(Some(folder)).map_err(|faults| Refused::fault(&faults))?;
            *shelf = Shelf::new(bank, stamp);
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
        let problem = self.load(&source).and_then(|loaded| compile(loaded, None));
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
