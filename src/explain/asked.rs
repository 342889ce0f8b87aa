//! Questions of other rooms about a variant besides its solution: its figures, its answers as they are printed, and whether its
//! lines come out.

use momentous_expr::Math;
use momentous_expr::Symbol;
use momentous_figure::Drawing;
use momentous_problem::FormulaPart;
use momentous_problem::NumberPart;
use momentous_problem::Pictured;
use momentous_problem::Sampler;
use momentous_problem::Variant;
use momentous_problem::Worked;

use super::Detail;
use super::cache::SolutionCache;
use super::computed;
use super::pictures;
use super::pictures::Quantities;
use super::pictures::Scope;
use super::reach::last_instant;
use super::terms::display::Display;
use super::terms::display::PrintedTerms;
use super::terms::entry::Item;
use super::terms::printed;

/// The answers to a part as they are printed, with their unit: one, or every root.
#[must_use]
pub fn printed_answers(worked: Worked<'_>, number: &NumberPart) -> Vec<Math> {
    let cache = SolutionCache::of(worked);
    let display = Display { worked, manners: &cache.way(worked).manners, shown: &PrintedTerms::default() };
    worked.answers(number).into_iter().map(|answer| printed::answer(display, number, answer)).collect()
}

/// A formula as it is printed.
#[must_use]
pub fn printed_formula(worked: Worked<'_>, part: &FormulaPart) -> Option<Math> {
    let cache = SolutionCache::of(worked);
    printed::formula(Display { worked, manners: &cache.way(worked).manners, shown: &PrintedTerms::default() }, part)
}

/// The results of a variant's worked solution that do not come out of the numbers printed before them, in words.
#[must_use]
pub fn lines_out(worked: Worked<'_>, detail: Detail) -> Vec<String> {
    let cache = SolutionCache::of(worked);
    let shown = PrintedTerms::default();
    let way = cache.way(worked);
    let figures = computed::figures(Display { worked, manners: &way.manners, shown: &shown }, way, detail);
    let name = |symbol: Symbol| &worked.problem.model().symbols.entry(symbol).name;
    let said = |item: &Item| match *item {
        Item::Quantity(symbol) | Item::Answer(symbol) => format!("`{}`", name(symbol)),
        Item::Coefficient(symbol, _) => format!("a coefficient of the equation for `{}`", name(symbol)),
        Item::OtherRoot(symbol) => format!("the other root for `{}`", name(symbol)),
        Item::Balance(_) => "a balance in the check".to_owned(),
        Item::Side(..) => "a side of a condition in the check".to_owned(),
        Item::Trial(symbol, number, _) => format!("the trial of `{}` = {number}", name(symbol)),
        Item::Extreme(symbol, _) => format!("the extreme case of `{}` in the check", name(symbol)),
    };
    figures.stubborn.iter().map(said).collect()
}

/// The figures of the worked solution: the diagrams of the stages that it looks at, or of the single instant.
pub(super) fn solution_figures(worked: Worked<'_>) -> Vec<Drawing> {
    let stages = last_instant(worked) - 1;
    let sibling = solved_sibling(worked);
    let worked = sibling.as_ref().and_then(|variant| Worked::new(worked.problem, variant)).unwrap_or(worked);
    let cache = SolutionCache::of(worked);
    let way = cache.way(worked);
    pictures::solution(&Quantities::new(worked, Scope::Solved, &way.manners, &way.pictures), stages)
}

/// The same numbers in a form that solves something, for a form that only asks for concepts and has nothing to draw.
fn solved_sibling(worked: Worked<'_>) -> Option<Variant> {
    if worked.form.wanted().next().is_some() {
        return None;
    }
    let forms = worked.problem.forms();
    let solving = forms.iter().position(|form| form.reveal.is_empty() && form.wanted().next().is_some())?;
    let mut sampler = Sampler::new(worked.problem, solving).ok()?;
    sampler.with_values(worked.variant.seed().unwrap_or(0), worked.variant.all_given()).ok()
}

/// The figure of the problem sheet, which shows only what is given; none where that is no more than outlines of bodies.
#[must_use]
pub fn situation(worked: Worked<'_>) -> Option<Drawing> {
    let cache = SolutionCache::of(worked);
    let way = cache.way(worked);
    let mut drawing = pictures::situation(&Quantities::new(worked, Scope::Given, &way.manners, &way.pictures))?;
    let scene = &worked.problem.loaded().draft.scene;
    drawing.reword(&|words| scene.in_agreement(words));
    Some(drawing)
}

/// The pictures that are offered in a choice, each with its name; in the order in which they are offered.
#[must_use]
pub fn offered_pictures(worked: Worked<'_>, pictured: &Pictured) -> Vec<Drawing> {
    let cache = SolutionCache::of(worked);
    let way = cache.way(worked);
    pictures::offered(&Quantities::new(worked, Scope::Solved, &way.manners, &way.pictures), pictured)
}
