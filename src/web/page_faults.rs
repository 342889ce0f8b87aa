//! The pages, filled once before anybody asks for them.

use momentous_exercise::calls::{Refused, RefusedKind};
use momentous_pages::{Nothing, PROBLEM_PAGES, Parameters, SIMULATORS, Shown};

use super::answer;
use super::app::App;

/// Faults of the templates of the pages: each is filled once, with a problem of the bank.
#[must_use]
pub fn page_faults(app: &App) -> Vec<String> {
    let problem = match app.pages.library.exhibits() {
        Ok(exhibits) => exhibits.first().map(|exhibit| exhibit.card.id.clone()).unwrap_or_default(),
        Err(refused) => return vec![refused.message],
    };
    let none = Parameters::default();
    let view = app.view(&Nothing);
    let of_problems = PROBLEM_PAGES.iter().flat_map(|(_, shown, make)| {
        let names = match shown {
            Shown::Always => SIMULATORS.map(|(name, _)| name).to_vec(),
            Shown::UnlessReserved => vec![problem.as_str()],
        };
        names.into_iter().map(|name| make(&view, name.to_owned(), &none)).collect::<Vec<_>>()
    });
    let pages = [view.start(&none), answer::tried(app)].into_iter().chain(of_problems);
    let is_fault = |refused: &Refused| refused.kind == RefusedKind::Fault;
    let mut faults: Vec<String> =
        pages.filter_map(Result::err).filter(is_fault).map(|refused| refused.message).collect();
    // A fault of a template that several pages share is said once.
    faults.sort();
    faults.dedup();
    faults
}
