//! Labels of the forms of a problem on a page: by what each asks.

use momentous_explain::Inline;
use momentous_explain::capitalised;
use momentous_problem::PlannedForm;
use momentous_problem::Problem;

/// The number of quantities that are named; of more, the first.
const MOST: usize = 3;

/// A form of a problem that has several.
#[derive(Clone, Debug, PartialEq)]
pub struct FormLabel {
    /// Its name in the file.
    pub name: String,
    /// The label: `Find v_A2, v_B2`; its name where that is what other forms ask, too, or it asks for no quantity.
    pub label: Vec<Inline>,
}

impl FormLabel {
    /// The forms of a problem that have names.
    #[must_use]
    pub fn all(problem: &Problem) -> Vec<Self> {
        let forms = problem.forms();
        let asked: Vec<Vec<Inline>> = forms.iter().map(|form| sought(problem, form)).collect();
        let label = |(place, form): (usize, &PlannedForm)| {
            let name = form.question.name.clone()?;
            let is_alone = asked.iter().filter(|other| **other == asked[place]).count() == 1;
            let label = if is_alone && !asked[place].is_empty() {
                asked[place].clone()
            } else {
                vec![Inline::Text(titled(&name))]
            };
            Some(Self { name, label })
        };
        forms.iter().enumerate().filter_map(label).collect()
    }
}

/// The quantities that a form asks for; nothing where it asks for none.
fn sought(problem: &Problem, form: &PlannedForm) -> Vec<Inline> {
    let mut said = Vec::new();
    for (place, symbol) in form.wanted().enumerate() {
        if place == MOST {
            said.push(Inline::Text(", …".to_owned()));
            break;
        }
        said.push(Inline::Text(if place == 0 { "Find " } else { ", " }.to_owned()));
        said.push(Inline::Math(problem.math_of(symbol)));
    }
    said
}

/// A name in hyphens as people write it: `week-one` as `Week one`.
#[must_use]
pub fn titled(name: &str) -> String {
    capitalised(&name.replace('-', " "))
}
