//! The problems of a file of submissions, each compiled when it is first met.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::bank::Bank;
use crate::cli::failure::Failure;
use crate::cli::open;
use crate::exercise::Marker;
use crate::grade::DecimalMark;
use crate::problem::Problem;

/// The problems that were met so far.
pub(super) struct Problems {
    bank: Bank,
    secret: Option<Vec<u8>>,
    mark: DecimalMark,
    met: BTreeMap<String, Result<Met, String>>,
}

/// A problem with a marker for each of its forms.
pub(super) struct Met {
    pub(super) problem: Arc<Problem>,
    pub(super) markers: Vec<Marker>,
}

impl Problems {
    /// The problems of the bank where the program runs, with answers written with this decimal mark.
    pub(super) fn here(secret: Option<Vec<u8>>, mark: DecimalMark) -> Result<Self, Failure> {
        Ok(Self { bank: Bank::here()?, secret, mark, met: BTreeMap::new() })
    }

    /// Opens the problem of that identity or file, where that was not tried before.
    pub(super) fn meet(&mut self, name: &str) {
        if !self.met.contains_key(name) {
            let met = self.opened(name).map_err(|failure| failure.to_string());
            self.met.insert(name.to_owned(), met);
        }
    }

    fn opened(&self, name: &str) -> Result<Met, Failure> {
        let problem = open::compiled(self.bank.open(name)?, self.secret.as_deref())?;
        let forms = 0..problem.forms().len();
        let markers = forms.filter_map(|form| Marker::new(&problem, form, self.mark).ok()).collect();
        Ok(Met { problem, markers })
    }

    /// A problem that was met, or why there is none.
    pub(super) fn find(&self, name: &str) -> Result<&Met, &str> {
        match self.met.get(name) {
            Some(met) => met.as_ref().map_err(String::as_str),
            None => Err("the problem was not opened"),
        }
    }
}
