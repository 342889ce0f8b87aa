//! The motion that a sheet tells, from which `back` and `in the same direction` are counted.

use momentous_expr::Symbol;
use momentous_model::Name;
use momentous_model::QuantityKind;

use super::super::compiling::planned::Form;
use super::super::compiling::planned::Problem;
use super::super::language::known::Known;

impl Problem {
    /// Whether the motion that the sheet tells goes in the positive direction of a component: that of the body itself, or else that of
    /// every body of which a velocity is told. None where nothing moves, or the directions differ from sheet to sheet.
    #[must_use]
    pub fn told_motion(&self, form: &Form, symbol: Symbol) -> Option<bool> {
        self.senses(symbol)?;
        let asked = self.model().name(symbol);
        let is_along = |name: &Name| name.kind == QuantityKind::Velocity && name.component == asked.component;
        // The ways of bodies: to the positive side, to the negative one, or to either.
        let way = |known: &Known| {
            let name = Some(self.model().name(known.symbol)).filter(|name| is_along(name))?;
            let [low, high] = known.origin.limits();
            let moves = form.told.contains(&known.symbol) && (low < 0.0 || high > 0.0);
            moves.then(|| (name.subject.as_str(), if low > 0.0 { Some(true) } else { (high < 0.0).then_some(false) }))
        };
        let ways: Vec<(&str, Option<bool>)> = form.known.iter().filter_map(way).collect();
        let alike = |mut ways: Vec<Option<bool>>| {
            ways.dedup();
            if let [only] = ways[..] { only } else { None }
        };
        let known_ways: Vec<Option<bool>> =
            ways.iter().filter(|(body, _)| *body == asked.subject).map(|(_, way)| *way).collect();
        let is_revealed = form.reveal.iter().any(|reveal| is_along(self.model().name(reveal.symbol)));
        match (known_ways.is_empty(), is_revealed) {
            (false, _) => alike(known_ways),
            (true, true) => None,
            (true, false) => alike(ways.into_iter().map(|(_, way)| way).collect()),
        }
    }
}
