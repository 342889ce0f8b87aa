//! The problems that submissions may name: those of the bank, and those that the teacher names. A cell is never a path.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::bank::Bank;
use crate::cli::failure::Failure;
use crate::cli::open;
use crate::exercise::Marker;
use crate::exercise::excerpt;
use crate::fault::did_you_mean;
use crate::grade::DecimalMark;
use crate::problem::Problem;

/// Names for which the nearest known one is looked for. Whoever has more of them does not read them one by one.
const MOST_SUGGESTIONS: u32 = 100;

/// The problems that were met so far.
#[derive(Clone)]
pub(super) struct Problems {
    bank: Bank,
    secret: Option<Vec<u8>>,
    mark: DecimalMark,
    /// The problems that are open, in the order in which they were met.
    open: Vec<Arc<OpenProblem>>,
    /// The same by identity, or why there is none.
    by_id: BTreeMap<String, Result<Arc<OpenProblem>, String>>,
    suggestions: u32,
}

/// A problem with a marker for each of its forms.
pub(super) struct OpenProblem {
    /// Its position among those that are open.
    pub(super) place: usize,
    pub(super) problem: Arc<Problem>,
    pub(super) markers: Vec<Marker>,
}

impl Problems {
    /// The problems of the bank where the program runs and those that are named, which come first, with answers written with
    /// this decimal mark.
    pub(super) fn here(named: &[String], secret: Option<Vec<u8>>, mark: DecimalMark) -> Result<Self, Failure> {
        let mut problems = Self {
            bank: Bank::here()?,
            secret,
            mark,
            open: Vec::new(),
            by_id: BTreeMap::new(),
            suggestions: MOST_SUGGESTIONS,
        };
        let named = if named.is_empty() { Vec::new() } else { open::problems(named, problems.secret.as_deref())? };
        for problem in named {
            let id = problem.id().to_owned();
            let before = problem.drawn_as().to_owned();
            let opened = problems.add(problem);
            if before != id {
                problems.by_id.entry(before).or_insert_with(|| Ok(Arc::clone(&opened)));
            }
            if problems.by_id.insert(id.clone(), Ok(opened)).is_some() {
                let message = format!("two of the problems named have the identity `{id}`");
                return Err(Failure::unusable(format!("{message}\nhelp: give one of them another `id`")));
            }
        }
        Ok(problems)
    }

    /// The problems that are open, by their positions.
    pub(super) fn open(&self) -> &[Arc<OpenProblem>] {
        &self.open
    }

    /// Forgets what was told of names and files.
    pub(super) fn begin_again(&mut self) {
        self.suggestions = MOST_SUGGESTIONS;
        self.by_id.retain(|_, opened| opened.is_ok());
    }

    /// The problem with that identity.
    pub(super) fn find(&mut self, id: &str) -> Result<Arc<OpenProblem>, String> {
        match self.by_id.get(id) {
            Some(opened) => return opened.clone(),
            None if self.bank.ids().any(|listed| listed == id) => {}
            None => {
                let renamed = self.bank.renamed(id).map(str::to_owned).ok_or_else(|| self.unknown(id))?;
                let opened = self.find(&renamed)?;
                self.by_id.insert(id.to_owned(), Ok(Arc::clone(&opened)));
                return Ok(opened);
            }
        }
        let source = self.bank.find(id).cloned().map_err(|faults| faults.to_string())?;
        let (kept, result) = match open::compiled(source, self.secret.as_deref()) {
            Ok(problem) => {
                let opened = self.add(problem);
                (Ok(opened.clone()), Ok(opened))
            }
            // The faults of a file are told once, not with each row.
            Err(failure) => (Err(format!("{id} does not load; see the message above")), Err(failure.to_string())),
        };
        self.by_id.insert(id.to_owned(), kept);
        result
    }

    fn add(&mut self, problem: Arc<Problem>) -> Arc<OpenProblem> {
        let forms = 0..problem.forms().len();
        let markers = forms.filter_map(|form| Marker::new(&problem, form, self.mark).ok()).collect();
        let opened = Arc::new(OpenProblem { place: self.open.len(), problem, markers });
        self.open.push(opened.clone());
        opened
    }

    /// There is no such problem; for the first of these names the nearest known one is looked for.
    fn unknown(&mut self, id: &str) -> String {
        if id.is_empty() {
            return "the row names no problem".to_owned();
        }
        let message = format!("there is no problem `{}`", excerpt(id));
        if self.suggestions == 0 {
            return message;
        }
        self.suggestions -= 1;
        let known = self.bank.ids().chain(self.by_id.keys().map(String::as_str));
        match did_you_mean(id, known) {
            Some(near) => format!("{message}\nhelp: did you mean `{near}`?"),
            None => format!(
                "{message}\nhelp: write the identity, such as impact/two-carts; name files of your own with --problem"
            ),
        }
    }
}
