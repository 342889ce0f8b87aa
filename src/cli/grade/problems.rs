//! The problems of a file of submissions, each compiled when it is first met.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::bank::Bank;
use crate::cli::failure::Failure;
use crate::cli::open;
use crate::problem::Problem;

/// The problems that were met so far.
pub(super) struct Problems {
    bank: Bank,
    secret: Option<Vec<u8>>,
    met: BTreeMap<String, Result<Arc<Problem>, String>>,
}

impl Problems {
    /// The problems of the bank where the program runs.
    pub(super) fn here(secret: Option<Vec<u8>>) -> Result<Self, Failure> {
        Ok(Self { bank: Bank::here()?, secret, met: BTreeMap::new() })
    }

    /// The problem of that identity or file, or why there is none.
    pub(super) fn open(&mut self, name: &str) -> Result<Arc<Problem>, String> {
        if let Some(met) = self.met.get(name) {
            return met.clone();
        }
        let source = self.bank.open(name).map_err(Failure::from);
        let problem = source.and_then(|source| open::compiled(source, self.secret.as_deref()));
        let problem = problem.map_err(|failure| failure.to_string());
        self.met.insert(name.to_owned(), problem.clone());
        problem
    }
}
