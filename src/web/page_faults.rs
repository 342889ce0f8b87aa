//! The pages, filled once before anybody asks for them.

use momentous_exercise::calls::{Refused, RefusedKind};

use super::answer;
use super::app::App;
use super::companion::Nothing;
use super::pages;
use super::parameters::Parameters;
use super::view::View;

/// What is wrong with the templates of the pages: each is filled once, with a problem of the bank.
#[must_use]
pub fn page_faults(app: &App) -> Vec<String> {
    let problem = match app.library.exhibits() {
        Ok(exhibits) => exhibits.first().map(|exhibit| exhibit.card.id.clone()).unwrap_or_default(),
        Err(refused) => return vec![refused.message],
    };
    let none = Parameters::default();
    let view = View::new(app, &Nothing);
    let own = |make: fn(&View<'_>, String, &Parameters) -> Result<String, Refused>| make(&view, problem.clone(), &none);
    let simulator = |name: &str| pages::simulator(&view, name.to_owned(), &none);
    let pages = [
        pages::start(&view, &none),
        own(pages::practice),
        own(pages::solution),
        own(pages::solve),
        own(pages::play),
        simulator("collision"),
        simulator("restitution"),
        answer::tried(app),
    ];
    let is_fault = |refused: &Refused| refused.kind == RefusedKind::Fault;
    let mut faults: Vec<String> =
        pages.into_iter().filter_map(Result::err).filter(is_fault).map(|own| own.message).collect();
    // A fault of a template that several pages share is said once.
    faults.sort();
    faults.dedup();
    faults
}
