//! Notes of a sheet beside its questions: constants, and how many figures are wanted.

use momentous_explain::Inline;
use momentous_grade::Writing;

use super::Exercise;
use super::rules::Rules;

/// Numbers of figures in words.
const COUNTS: [&str; 7] = ["no", "one", "two", "three", "four", "five", "six"];

impl Exercise {
    /// The note of the sheet: the constants that it uses, and how many figures are wanted.
    pub(super) fn note(&self) -> Vec<Inline> {
        let said = [self.constants(), self.figures()].into_iter().flatten().collect::<Vec<_>>().join(" ");
        if said.is_empty() { Vec::new() } else { vec![Inline::Text(said)] }
    }

    /// How many figures numbers are to be written with; a part that wants more of them says so itself.
    fn figures(&self) -> Option<String> {
        let worked = self.worked();
        let is_ignored = Rules { problem: worked.problem, form: worked.form }.writing() == Writing::Ignore;
        let asked =
            worked.form.parts.iter().filter_map(|part| part.kind.numbers().first()).filter(|number| !number.whole);
        let fewest = asked.map(|number| number.figures).min().filter(|_| !is_ignored)?;
        let count = COUNTS.get(fewest).map_or_else(|| fewest.to_string(), |word| (*word).to_owned());
        Some(format!("Write numbers to {count} significant figure{}.", if fewest == 1 { "" } else { "s" }))
    }

    /// g, where a step uses it and the file leaves it to its default.
    fn constants(&self) -> Option<String> {
        let symbols = &self.problem.model().symbols;
        let gravity = symbols.find("g")?;
        let used = self.worked().leaf().answer_steps().iter().any(|step| {
            step.roots.iter().flat_map(|root| &root.values).any(|(_, closed)| closed.symbols().contains(&gravity))
        });
        let printed = self.problem.loaded().given.get("g").is_some();
        let (value, unit) = self.variant.given(gravity).filter(|_| used && !printed)?;
        Some(format!("Take g = {}.", momentous_problem::say_quantity(&value, &unit)))
    }
}
