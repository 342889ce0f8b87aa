//! Every page by its address.

use momentous_exercise::calls::Refused;

use super::parameters::Parameters;
use super::refusal::{Refusal, heading, no_page};
use super::view::View;
use super::{figure, play, practice, simulator, solve, start};

/// The function that makes the page of a problem, or of a simulator by its name.
pub type OfProblem = fn(&View<'_>, String, &Parameters) -> Result<String, Refused>;

/// When a page is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// Always.
    Always,
    /// Unless an assignment with its problem is open.
    UnlessReserved,
}

/// The pages of problems, `/practice/impact/two-carts`, and of simulators, by the beginnings of their addresses.
pub const PROBLEM_PAGES: [(&str, Shown, OfProblem); 5] = [
    ("/play/", Shown::UnlessReserved, play::play),
    ("/practice/", Shown::UnlessReserved, practice::practice),
    ("/simulators/", Shown::Always, simulator::simulator),
    ("/solution/", Shown::UnlessReserved, solve::solution),
    ("/solve/", Shown::UnlessReserved, solve::solve),
];

impl View<'_> {
    /// The start page: a gallery of the problems, which the fields narrow.
    ///
    /// # Errors
    /// The bank or a template is at fault.
    pub fn start(&self, fields: &Parameters) -> Result<String, Refused> {
        start::start(self, fields)
    }

    /// The small figure of a problem in the gallery, as SVG.
    ///
    /// # Errors
    /// There is no such problem, or it is withheld.
    pub fn figure(&self, problem: &str) -> Result<String, Refused> {
        figure::figure(self, problem)
    }

    /// The page at a path, with the fields of its address or of a form. It always has one: a refusal is a page as well.
    ///
    /// # Errors
    /// A template is at fault, that of refusals included.
    pub fn answer(&self, path: &str, fields: Vec<(String, String)>) -> Result<String, Refused> {
        let page = Parameters::new(fields, &self.pages.limits).and_then(|fields| self.at(path, &fields));
        page.or_else(|refused| self.refusal(&refused))
    }

    fn at(&self, path: &str, fields: &Parameters) -> Result<String, Refused> {
        if path == "/" {
            return self.start(fields);
        }
        let page = PROBLEM_PAGES.iter().find_map(|(begin, _, make)| Some((path.strip_prefix(begin)?, make)));
        let Some((problem, make)) = page else {
            return Err(no_page());
        };
        make(self, problem.to_owned(), fields)
    }

    fn refusal(&self, refused: &Refused) -> Result<String, Refused> {
        self.page("refused", &Refusal::new(heading(refused.kind), refused, None))
    }
}
