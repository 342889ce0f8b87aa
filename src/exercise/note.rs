//! Notes of a sheet beside its questions: constants, and how many figures are wanted.

use momentous_explain::Inline;
use momentous_grade::Writing;
use momentous_problem::AskedUnit;

use super::Exercise;
use super::rules::Rules;

/// Numbers of figures in words.
const COUNTS: [&str; 7] = ["no", "one", "two", "three", "four", "five", "six"];

/// Units that a sheet asks for and that no other unit is a plain multiple of, as books tell them.
const CONVERSIONS: [(&str, &str); 2] = [("hp", "1 hp = 550 ft·lb/s."), ("Btu", "1 Btu = 778 ft·lb.")];

impl Exercise {
    /// The note of the sheet: the constants and the units that it uses, and how many figures are wanted.
    pub(super) fn note(&self) -> Vec<Inline> {
        let said =
            [self.constants(), self.conversions(), self.figures()].into_iter().flatten().collect::<Vec<_>>().join(" ");
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

    /// The sizes of units that are asked for and not known to everybody.
    fn conversions(&self) -> Option<String> {
        let parts = &self.worked().form.parts;
        let units: Vec<String> = parts
            .iter()
            .flat_map(|part| part.kind.numbers())
            .filter_map(|number| match &number.unit {
                AskedUnit::Unit(unit) => Some(unit.unicode()),
                AskedUnit::InTermsOf(..) => None,
            })
            .collect();
        let told: Vec<&str> = CONVERSIONS
            .iter()
            .filter(|(unit, _)| units.iter().any(|asked| asked == unit))
            .map(|(_, told)| *told)
            .collect();
        (!told.is_empty()).then(|| told.join(" "))
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
