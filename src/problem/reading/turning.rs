//! Units of givens that turn: an angle without a unit, and an angular velocity in hertz.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Model;
use momentous_model::QuantityKind;
use momentous_model::angle_without_unit;
use momentous_quantity::Unit;

use super::super::language::known::Known;
use super::super::language::known::Origin;

/// The fault of a given whose kind is told by its name.
pub(crate) fn unclear(kind: &QuantityKind, name: &str, origin: &Origin, unit: &Unit) -> Option<Fault> {
    if *kind == QuantityKind::AngularVelocity && unit.counts_events() {
        let message = format!("`{name}` is an angular velocity, and {unit} may mean revolutions or radians a second");
        return Some(Fault::new(Code::Dimension, message).help("write the unit as `rev/s`, `rpm` or `rad/s`"));
    }
    kind.is_angle().then(|| without_unit(origin, unit)).flatten()
}

/// The faults of what equations take as an angle, whatever its name.
pub(crate) fn angles_by_use(model: &Model, known: &[Known]) -> Vec<Fault> {
    let angles = model.angles();
    let used = known.iter().filter(|known| angles.contains(&known.symbol));
    let fault = |known: &Known| {
        let fault = without_unit(&known.origin, &known.unit)?;
        Some(fault.at_path(Path::root().key("given").name(known.name.as_str())))
    };
    used.filter_map(fault).collect()
}

/// The fault of an angle that is a number other than zero without a unit of angles.
fn without_unit(origin: &Origin, unit: &Unit) -> Option<Fault> {
    let help = match origin {
        Origin::Any => return None,
        Origin::Fixed(value) if value.is_zero() => return None,
        Origin::Fixed(value) => format!("write `{value} deg`, or `{value} rad` if radians are meant"),
        Origin::Drawn(_) => "add `unit: deg`, or `unit: rad` if radians are meant".to_owned(),
    };
    (!unit.measures_angles()).then(|| angle_without_unit(help))
}
