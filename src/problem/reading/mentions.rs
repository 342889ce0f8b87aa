//! References of the texts of a problem: every placeholder names a quantity of which its filter has something to say.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_quantity::Dimension;
use momentous_quantity::dimension_name;

use super::super::language::text::Filter;
use super::super::language::text::Placeholder;
use super::load::Loaded;

/// The dimensions that may have a direction along an axis.
const DIRECTED: &[Dimension] =
    &[Dimension::LENGTH, Dimension::VELOCITY, Dimension::ACCELERATION, Dimension::FORCE, Dimension::MOMENTUM];

/// Every placeholder names a quantity.
pub(crate) fn mention_in_texts(loaded: &Loaded, builder: &mut Builder<'_>) {
    let forms = loaded.questions.iter().map(|question| (question.path.key("text"), &question.text));
    let hints = loaded.questions.iter().flat_map(|question| &question.hints).map(|(path, hint)| (path.clone(), hint));
    for (path, text) in std::iter::once((Path::root().key("text"), &loaded.draft.text)).chain(forms).chain(hints) {
        for placeholder in text.placeholders() {
            if let Some(fault) = unsayable(placeholder, builder) {
                builder.fault(fault.at_path(path.clone()).within(placeholder.span));
            }
        }
    }
}

/// The fault of a placeholder that names nothing, or of whose quantity its filter has nothing to say.
pub(crate) fn unsayable(placeholder: &Placeholder, builder: &mut Builder<'_>) -> Option<Fault> {
    if builder.mention(&placeholder.name).is_some() {
        return without_direction(placeholder, builder);
    }
    let fault = builder.unknown(&placeholder.name);
    let parts = ["x", "y"].map(|letter| format!("{}.{letter}", placeholder.name));
    if let [Some(_), Some(_)] = parts.each_ref().map(|part| builder.mention(part)) {
        let [x, y] = parts;
        return Some(
            fault.help(format!("a text prints a vector by its components: `{{{{ {x} }}}}` and `{{{{ {y} }}}}`")),
        );
    }
    Some(fault)
}

/// The fault of a filter that refers to motion or direction where the quantity has none.
fn without_direction(placeholder: &Placeholder, builder: &mut Builder<'_>) -> Option<Fault> {
    let symbol = builder.mention(&placeholder.name)?;
    let dimension = builder.symbols().entry(symbol).dimension;
    let is_component = || builder.axis_letters().len() == 1 || builder.name(symbol).component.is_some();
    let (serves, kinds) = match placeholder.filter {
        Filter::Motion => (dimension == Dimension::VELOCITY, "a velocity"),
        Filter::Direction => (DIRECTED.contains(&dimension) && is_component(), "a component along an axis"),
        _ => return None,
    };
    let found = dimension_name(dimension);
    let message = format!("`{}` is {found}, but this filter is for {kinds}", placeholder.name);
    (!serves).then(|| Fault::new(Code::Text, message).help(format!("write `{{{{ {} }}}}` alone", placeholder.name)))
}
