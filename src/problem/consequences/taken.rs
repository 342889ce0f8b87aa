//! The right value of another quantity, written down as the answer.

use momentous_expr::Symbol;
use momentous_laws::wrong::Misconception;
use momentous_laws::wrong::data;
use momentous_laws::wrong::geometry;
use momentous_model::Model;
use momentous_model::QuantityKind;
use momentous_quantity::Dimension;

use super::mistake::Made;
use super::mistake::Mistake;

/// For each way in which one quantity may be taken for another, what may be taken for which of those that are asked.
pub(super) fn taken(model: &Model, wanted: &[Symbol]) -> Vec<Mistake> {
    let confused = |of: &'static Misconception| {
        let others = |asked: Symbol| model.symbols.iter().map(move |(other, _)| (asked, other));
        let pairs = wanted.iter().flat_map(|asked| others(*asked));
        pairs.filter(|(asked, other)| confusion(model, *asked, *other) == Some(of)).collect::<Vec<_>>()
    };
    let each = data::TAKEN.iter().map(|of| (*of, confused(of))).filter(|(_, pairs)| !pairs.is_empty());
    each.map(|(of, pairs)| Mistake { of, instance: None, places: 1, made: Made::Taken(pairs) }).collect()
}

/// The confusion of a student who writes down another quantity than is asked; `None` where nobody would.
fn confusion(model: &Model, asked: Symbol, other: Symbol) -> Option<&'static Misconception> {
    let dimension = model.symbols.entry(asked).dimension;
    if asked == other || model.symbols.entry(other).dimension != dimension || dimension == Dimension::NONE {
        return None;
    }
    let (name, taken) = (model.name(asked), model.name(other));
    let is_velocity = |kind: &QuantityKind| matches!(kind, QuantityKind::Velocity | QuantityKind::Speed);
    let alike = name.kind == taken.kind || (is_velocity(&name.kind) && is_velocity(&taken.kind));
    let same_body = name.subject == taken.subject;
    let same_time = name.instant == taken.instant && name.stage == taken.stage;
    let same_part = name.kind == taken.kind && name.component == taken.component;
    match (alike, same_body, same_time) {
        (false, ..) => Some(&data::ANOTHER_QUANTITY),
        (true, true, true) => Some(&geometry::COMPONENT_FOR_MAGNITUDE),
        (true, true, false) if same_part => Some(&data::ANOTHER_INSTANT),
        (true, false, true) if same_part => Some(&data::ANOTHER_BODY),
        (true, false, false) if same_part => Some(&data::ANOTHER_QUANTITY),
        (true, ..) => None,
    }
}
