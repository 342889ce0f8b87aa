//! An expression of several quantities that is asked under a name: `v_B2 - v_A2` as `gap`.

use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::Name;

use super::ask::Find;

/// The quantity for which the name stands; its equation becomes part of the model.
pub(crate) fn asked(find: &Find, id: &str, builder: &mut Builder<'_>, path: &Path) -> Option<Symbol> {
    if let Some((key, _)) =
        [("from", find.from.is_some()), ("sense", find.sense.is_some())].into_iter().find(|key| key.1)
    {
        let fault = Fault::new(Code::Value, format!("an expression has no `{key}`"));
        builder.fault(fault.help("remove it, or ask for a direction by its own name").at_path(path.key(key)));
        return None;
    }
    builder.expression(id, &find.find, find.label.as_deref(), path)
}

/// The question with a name for its answer, where it asks for an expression and gives it none: `difference`, `ratio`.
pub(crate) fn named(find: &Find, builder: &mut Builder<'_>) -> Option<Find> {
    // A name alone that the scene does not have is unknown, and no term.
    let is_nameless = find.id.is_none()
        && builder.mention(&find.find).is_none()
        && Name::parse(find.find.trim()).is_none()
        && builder.is_term(&find.find);
    is_nameless.then(|| Find { id: Some(builder.name_for(&find.find)), ..find.clone() })
}
