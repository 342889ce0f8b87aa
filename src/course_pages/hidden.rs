//! The kinds of problems that nothing on the site solves for others than those who teach, because an open assignment says so.

use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use lru::LruCache;

use momentous_bank::load_in_course;
use momentous_course::{Course, Item, Key, Kind, Moment, Solvers};
use momentous_fault::Source;
use momentous_store::{Store, StoreFault};

use super::library::source;
use momentous_pages::Library;

/// For so long it is not asked again what is hidden, in ms: pages ask often, and a hurdle may stand a moment late.
const FRESH: i64 = 5_000;

/// The kinds of problem files that are kept, by their texts.
const MOST: NonZeroUsize = NonZeroUsize::new(512).expect("not zero");

/// A kind that is hidden, and the course whose teachers see it all the same.
#[derive(Clone, Debug)]
pub(super) struct HiddenKind {
    pub(super) course: Key<Course>,
    pub(super) kind: Kind,
}

/// The kinds that are hidden now, as they were read last.
pub(super) struct Hidden {
    read: Mutex<Option<(Moment, Arc<Vec<HiddenKind>>)>>,
    known: Mutex<LruCache<String, Kind>>,
}

impl Default for Hidden {
    fn default() -> Self {
        Self { read: Mutex::default(), known: Mutex::new(LruCache::new(MOST)) }
    }
}

impl Hidden {
    /// The problems hidden at a moment. Where the records cannot be reached they are those that were hidden last: simulators go
    /// on without them.
    pub(super) async fn at(&self, bank: &Library, store: &Store, now: Moment) -> Arc<Vec<HiddenKind>> {
        let last = self.read().clone();
        if let Some((read, kinds)) = &last
            && (0..FRESH).contains(&now.millis().saturating_sub(read.millis()))
        {
            return Arc::clone(kinds);
        }
        match self.read_at(bank, store, now).await {
            Ok(kinds) => {
                let kinds = Arc::new(kinds);
                *self.read() = Some((now, Arc::clone(&kinds)));
                kinds
            }
            Err(fault) => {
                eprintln!("momentous serve: {fault}");
                last.map(|(_, kinds)| kinds).unwrap_or_default()
            }
        }
    }

    async fn read_at(&self, bank: &Library, store: &Store, now: Moment) -> Result<Vec<HiddenKind>, StoreFault> {
        let mut kinds = Vec::new();
        for (whole, _) in store.open_assignments(now).await? {
            if whole.assignment.policy.solvers == Solvers::Shown {
                continue;
            }
            let course = whole.assignment.course;
            for item in whole.items.iter().filter(|item| !item.dropped) {
                let Some(source) = file(bank, store, course, item).await? else { continue };
                kinds.extend(self.kind(source).map(|kind| HiddenKind { course, kind }));
            }
        }
        Ok(kinds)
    }

    /// The simulators that solve nothing, as far as was read last: the pages' header does not offer them.
    pub(super) fn simulators(&self) -> Vec<&'static str> {
        self.read()
            .iter()
            .flat_map(|(_, kinds)| kinds.iter())
            .flat_map(|hidden| hidden.kind.simulators())
            .copied()
            .collect()
    }

    /// After a change of an assignment it is read anew.
    pub(super) fn forget(&self) {
        *self.read() = None;
    }

    /// The kind of a problem file; nothing where the file does not load.
    fn kind(&self, source: Source) -> Option<Kind> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let text = source.text.to_string();
        if let Some(kind) = known.get(&text) {
            return Some(kind.clone());
        }
        let kind = Kind::of(&load_in_course(source).ok()?);
        known.put(text, kind.clone());
        Some(kind)
    }

    fn read(&self) -> MutexGuard<'_, Option<(Moment, Arc<Vec<HiddenKind>>)>> {
        self.read.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The file from which the sheets of an item are drawn; before they are pinned it is the one that would be now.
async fn file(bank: &Library, store: &Store, course: Key<Course>, item: &Item) -> Result<Option<Source>, StoreFault> {
    if let Some(digest) = &item.digest {
        return Ok(store.problem_file(course, digest).await?.as_ref().map(source));
    }
    let files = store.problem_files(course).await?.into_iter().filter(|file| file.problem == item.problem);
    let published = files.filter(|file| file.published.is_some()).max_by_key(|file| file.published);
    Ok(published.as_ref().map(source).or_else(|| bank.source(&item.problem).ok()))
}
