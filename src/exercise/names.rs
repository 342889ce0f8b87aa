//! Under which names answers may be given: that in the file, the course's, and the one that the sheet prints.

use momentous_expr::Notation;
use momentous_problem::Part;
use momentous_problem::PartKind;
use momentous_problem::PlannedForm;
use momentous_problem::Problem;

/// The names of a form's parts.
#[derive(Clone, Debug)]
pub(super) struct Names {
    notation: Notation,
    /// The names that the sheet prints for each part, without brackets and marks.
    printed: Vec<Vec<String>>,
}

impl Names {
    pub(super) fn of(problem: &Problem, form: &PlannedForm) -> Self {
        let printed = form.parts.iter().map(|part| printed(problem, part)).collect();
        Self { notation: problem.notation().clone(), printed }
    }

    /// Of the parts' names in the file, in their order, the one that is meant by what was typed; what was typed where it is none of
    /// them, or could be several.
    pub(super) fn meant<'a>(&self, ids: &[&'a str], typed: &'a str) -> &'a str {
        let usual = self.notation.usual(ids.iter().copied(), typed);
        if ids.contains(&usual) {
            return usual;
        }
        let wanted = bare(typed);
        let mut matching = ids.iter().zip(&self.printed).filter(|(_, names)| names.contains(&wanted));
        match (matching.next(), matching.next()) {
            (Some((id, _)), None) => id,
            _ => typed,
        }
    }
}

fn printed(problem: &Problem, part: &Part) -> Vec<String> {
    let math = match &part.kind {
        PartKind::Number(number) => problem.math_of(number.symbol),
        PartKind::Formula(formula) => problem.math_of(formula.symbol),
        PartKind::Range(range) => problem.math_of(range.number.symbol),
        PartKind::Vector(_) => problem.notation().math(&part.id),
        PartKind::Choice(_) => return Vec::new(),
    };
    vec![bare(&math.plain()), bare(&math.latex())]
}

/// A name by its letters and digits alone: `(r_A2)_y` and `\text{r}_{A2,y}` are one.
fn bare(name: &str) -> String {
    let plain =
        ["\\text", "\\mathrm", "\\lvert", "\\rvert"].iter().fold(name.to_owned(), |name, word| name.replace(word, ""));
    plain.chars().filter(|next| next.is_alphanumeric()).collect()
}
