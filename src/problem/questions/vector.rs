//! A vector that is asked: all its components at once.

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::component_name;

use super::super::language::ask::Find;
use super::super::reading::load::Loaded;
use super::number::number_part;
use super::part::AskedUnit;
use super::part::PartKind;
use super::part::VectorPart;

/// The components of a name that is no quantity itself.
pub(crate) fn components(vector: &str, builder: &mut Builder<'_>) -> Option<Vec<Symbol>> {
    let axes = builder.axis_letters();
    let mut symbols = || axes.iter().map(|axis| builder.mention(&component_name(vector, axis))).collect();
    if axes.len() > 1 { symbols() } else { None }
}

/// Asks for these components at once: the id, the label and the kind of the part.
pub(crate) fn read(
    loaded: &Loaded,
    find: &Find,
    symbols: &[Symbol],
    builder: &mut Builder<'_>,
    path: &Path,
) -> Option<(String, String, PartKind)> {
    let axes = builder.axis_letters();
    let components = symbols.iter().map(|symbol| number_part(loaded, find, *symbol, builder, path));
    let components = components.collect::<Option<Vec<_>>>()?;
    if components.iter().any(|number| matches!(&number.unit, AskedUnit::InTermsOf(_, unit) if !unit.is_none())) {
        let fault = Fault::new(Code::Value, format!("`{}` is a vector of another dimension than its unit", find.find));
        let help = format!("ask for its components in terms of that quantity: `{}.x`", find.find);
        builder.fault(fault.help(help).at_path(path.key("unit")));
        return None;
    }
    let meaning = symbols.first().and_then(|first| builder.vector_of(*first));
    let meaning = meaning.unwrap_or_else(|| format!("the vector {}", find.find));
    Some((find.find.clone(), meaning, PartKind::Vector(VectorPart { components, axes })))
}
